// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace nazori::functions {

/// The value of a number with an exact name (see exact_name) that is at most `tolerance` from `value`. It is
/// a guess, to be verified.
[[nodiscard]] std::optional<double> exact_value_near(double value, double tolerance);

}  // namespace nazori::functions
