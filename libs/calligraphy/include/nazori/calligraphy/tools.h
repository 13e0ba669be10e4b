// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "nazori/base/result.h"
#include "nazori/brush/tuft_form.h"
#include "nazori/paint/ink_load.h"

namespace nazori::calligraphy {

/// How thick a brush is beside the sheet, which is smaller than a real one.
enum class BrushSize : std::uint8_t {
  large,   ///< bold strokes of a single character
  medium,  ///< one character on the sheet
  small,   ///< two or four characters
  fine,    ///< six characters
};
inline constexpr std::array<std::string_view, 4> kBrushSizes{"large", "medium", "small", "fine"};
inline constexpr std::array<std::string_view, 3> kHairs{"goat", "mixed", "weasel"};

/// A brush that can be chosen.
struct BrushChoice {
  BrushSize size = BrushSize::medium;
  brush::Hair hair = brush::Hair::mixed;
  friend bool operator==(const BrushChoice&, const BrushChoice&) = default;
};

/// The form of a brush. A small brush is a No. 6 in a smaller scale: lengths by the scale, the stiffness by
/// its square, because there are as many fewer hairs, and what it holds by its cube.
[[nodiscard]] brush::TuftForm form_of(const BrushChoice& choice);

/// Inks that can be chosen: names of paint::find_pigment(), and "water" without any pigment.
inline constexpr std::array<std::string_view, 5> kInks{"sumi", "sumi-blue", "sumi-brown", "vermilion",
                                                       "water"};
/// The ink of kInks that has no pigment.
inline constexpr std::string_view kWater = "water";

/// Dips the brush into the ink on the stone. The tip is filled with fresh ink. The root keeps what it has and
/// drinks what is missing, so a brush that was diluted before writes dark first and pale later.
/// @param slot  of the pigment; below 0: clear water.
void dip_in_ink(paint::InkLoad& load, int slot);
/// Dips the brush into the water jar: half of its pigment goes, and it is full again.
void dip_in_water(paint::InkLoad& load);
/// Wipes the brush on a cloth or the edge of the stone: half of what it holds goes.
void wipe(paint::InkLoad& load);
/// The same ink, equally full, in a brush that holds another amount. @param capacity_m3  as for
/// paint::dipped().
[[nodiscard]] paint::InkLoad moved_to_brush(const paint::InkLoad& load, double capacity_m3);
/// Pigment of all kinds in the water of the brush, tip and root together; 1 is undiluted ink.
[[nodiscard]] double strength_of(const paint::InkLoad& load);

/// The tilt of a holder as paint::brush::PenSample takes it.
struct HolderTilt {
  double lean_rad = 0;
  double lean_to_rad = 0;
};
/// From the two angles of a pen tablet. @param right_deg, towards_learner_deg  of the upper end, within -89
/// and 89. @param mirrored  right becomes left.
[[nodiscard]] HolderTilt holder_tilt(double right_deg, double towards_learner_deg, bool mirrored);
/// The tilt that is assumed for a mouse or a finger: a little to the lower right, as the right hand holds a
/// brush.
[[nodiscard]] HolderTilt assumed_tilt(bool mirrored);

}  // namespace nazori::calligraphy
