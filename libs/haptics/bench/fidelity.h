// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::haptics::fidelity {

/// Experiments on what mesh-based renderers get wrong, run on this renderer. Each function runs one
/// experiment; the benchmark prints the figures, the tests compare them with limits. Everything is
/// deterministic.

/// A servo whose stylus comes down on a plate 1,000 times at 0.01 to 0.3 m/s.
struct FirstTick {
  int dives = 0;
  int pushed = 0;       ///< dives whose first tick inside had the full force for its depth
  double least = 1e30;  ///< smallest share of that force
};
[[nodiscard]] FirstTick first_tick();

/// Largest distance sideways between proxy and device over 200,000 ticks of scribble on a flat plate without
/// friction [m].
[[nodiscard]] double sideways_lag_m();

/// The trajectories of the workload.
struct Behind {
  int ticks = 0;
  int behind = 0;  ///< proxy more than 0.05 units (2.5 mm) from the device, which is at most 0.045 deep
  int below = 0;   ///< proxy under the surface
  int late = 0;    ///< device inside and no contact, or contact without being inside
  double farthest_m = 0;
};
/// @param path  0 trace, 1 sweep, 2 scribble; 200,000 ticks.
[[nodiscard]] Behind behind_a_ridge(int size, int path);

/// 1,000 styluses that rest on a surface which then rises by 0.05 to 9 mm.
struct Lift {
  int styluses = 0;
  int lifted =
      0;  ///< proxy on the new surface one tick later, and an upward force once the force ramp is over
  double worst_step_n = 0;  ///< largest change of force in one tick
};
[[nodiscard]] Lift rising_surface();

/// Largest distance between proxy and centre line while a ring groove of 20 mm is traced at 12 mm/s, pressed
/// 1 mm deep: 1 N at 1,000 N/m [m].
[[nodiscard]] double ripple_m(int size);

}  // namespace nazori::haptics::fidelity
