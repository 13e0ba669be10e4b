// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/writing/written_character.h"

namespace nazori::writing {

/// How the pen left the paper, according to speed and pressure.
enum class PenLift : std::uint8_t {
  unknown,  ///< neither times nor pressures, or too short
  stopped,  ///< it came to rest
  swept,    ///< the pen was lifted while it moved
};

/// A rest of the pen within a stroke.
struct Pause {
  double start_s = 0;  ///< from the beginning of the stroke
  double duration_s = 0;
};

/// The motion of the pen in one stroke. Lengths are in units of the ink.
struct PenMotion {
  double duration_s = 0;
  double pause_before_s = 0;       ///< since the end of the previous stroke; 0 for the first
  double mean_speed = 0;           ///< path by duration
  int speed_peaks = 0;             ///< 1 or 2 for a fluent stroke, more for a hesitant one; 0 without times
  double speed_at_end = 0;         ///< when the pen was lifted, relative to the mean speed; 0 without times
  std::vector<Pause> pauses;       ///< rests of 0.15 s or more
  std::optional<double> pressure;  ///< mean, 0..1
  std::optional<double> pressure_at_end;  ///< over the last tenth of the path
  double pressure_range = 0;              ///< largest minus smallest, 0 without pressures
  PenLift lift = PenLift::unknown;
};

/// The motion of each stroke of ink that passes check(). Strokes without times have only pressures. Peaks are
/// counted in the speed smoothed over 60 ms, and only those that rise at least a tenth of the greatest speed
/// above the adjacent minima.
/// @source number of velocity peaks as a measure of fluency: H. L. Teulings et al., "Parkinsonism reduces
/// coordination of fingers, wrist, and arm in fine motor control", Experimental Neurology 146 (1997).
[[nodiscard]] std::vector<PenMotion> pen_motion(const WrittenCharacter& ink);

}  // namespace nazori::writing
