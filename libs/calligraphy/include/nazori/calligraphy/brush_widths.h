// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nazori/brush/tuft_form.h"

namespace nazori::calligraphy {

/// How broad a brush writes under each pressure of an upright pen, found by drawing it straight.
class BrushWidths {
 public:
  /// @cost about 0.2 s.
  explicit BrushWidths(const brush::TuftForm& form);

  /// The pressure, 0..1, at which the brush writes with half of this width; 1 where it writes no wider.
  [[nodiscard]] double pressure_for(double half_width_m) const;

 private:
  static constexpr int kSteps = 20;
  std::array<double, kSteps + 1> half_width_m_{};  ///< by pressure in equal steps; ascends
};

}  // namespace nazori::calligraphy
