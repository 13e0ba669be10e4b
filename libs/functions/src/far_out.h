// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// What a function does as its variable grows without bound.
enum class FarOut : std::uint8_t {
  unknown,    ///< waves for ever, or nothing certain
  undefined,  ///< not defined far out
  rises,      ///< beyond all bounds
  falls,      ///< below all bounds
  level,      ///< approaches a value
  slanted,    ///< approaches a slanted line
};

struct FarBehaviour {
  FarOut kind = FarOut::unknown;
  double slope = 0;        ///< of `slanted`
  double intercept = 0;    ///< of `slanted`, and the value of `level`
  bool coincides = false;  ///< not approached but reached: |x| is a line itself
  friend bool operator==(const FarBehaviour&, const FarBehaviour&) = default;
};

/// @param direction  1: the variable goes to infinity; -1: to minus infinity.
[[nodiscard]] FarBehaviour far_behaviour(const Expression& f, Variable v, int direction);

/// The limit as the variable comes to `at`, from above for side 1, from below for -1.
[[nodiscard]] std::optional<double> limit_at(const Expression& f, Variable v, double at, int side);

}  // namespace nazori::functions
