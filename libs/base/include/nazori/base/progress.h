// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace nazori::base {

/// Receives the progress of long work: `done` from 0 to 1, never decreasing, and the name of the present step
/// (English). Called on the thread that does the work. Returning false asks the work to stop; it then fails
/// with Errc::cancelled and leaves everything as it was.
using Progress = std::function<bool(double done, std::string_view step)>;

/// Reports the progress of one part of a task as `from` to `to` of the whole. Empty where `whole` is.
[[nodiscard]] inline Progress part_of(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double done, std::string_view step) {
    return whole(from + (to - from) * done, step);
  };
}

}  // namespace nazori::base
