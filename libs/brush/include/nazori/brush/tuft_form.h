// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "nazori/base/result.h"
#include "nazori/brush/spine.h"

namespace nazori::brush {

/// What a tuft is made of.
enum class Hair : std::uint8_t {
  goat,    ///< soft, holds much ink
  mixed,   ///< a stiff core in soft hair
  weasel,  ///< stiff, springs back
};

/// Length of the hair over the diameter of the shaft. @source makers' classes: short 3.5-4.5, medium 4.5-5.5,
/// long 5.5-8; here the middle of each.
enum class HairLength : std::uint8_t { short_hair, medium_hair, long_hair };

/// Sizes and stiffness of a brush.
struct TuftForm {
  double shaft_m = 0;         ///< diameter of the shaft [m]
  double hair_m = 0;          ///< free length of the hair [m]
  double root_radius_m = 0;   ///< of the tuft at its root [m]
  double stiffness_n_m2 = 0;  ///< EI of the whole tuft at its root [N m^2]
  double holds_m3 = 0;        ///< ink that the full tuft holds [m^3]
  SpineForm spine;
  SpineFriction wet;  ///< with a full load of ink
  SpineFriction dry;  ///< without ink

  /// Force of 1 in units of the spine [N].
  [[nodiscard]] double force_unit_n() const { return stiffness_n_m2 / (hair_m * hair_m); }
  /// Friction at a wetness of 0..1.
  [[nodiscard]] SpineFriction friction(double wetness) const;
};

/// The root of the hair comes no nearer to the paper than this [length of the hair].
inline constexpr double kLowestRoot = 0.15;

/// Smallest and largest number of a brush (fude): 1 is the thickest.
inline constexpr int kThickestBrush = 1, kThinnestBrush = 6;

/// The brush with a number, kind and length of hair.
/// @return Errc::bad_argument for a number outside 1..6.
/// @source shafts of No. 1 to 6 by Japanese makers: 15, 14.5, 13, 11, 10, 8.5 mm. EI: estimated from the
/// number and thickness of hairs, goat 1e-4, weasel 3e-4 N m^2 for a No. 4; no published force curve of a
/// brush was found. The rest is chosen, see docs/brush.md.
[[nodiscard]] base::Result<TuftForm> tuft_form(int number, Hair hair = Hair::mixed,
                                               HairLength length = HairLength::medium_hair);

}  // namespace nazori::brush
