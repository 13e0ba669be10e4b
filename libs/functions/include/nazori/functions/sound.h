// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "nazori/functions/points.h"
#include "nazori/functions/tracing.h"

namespace nazori::functions {

struct SoundSettings {
  int sample_rate = 44'100;    ///< [Hz], 8000 to 192000
  double seconds = 4.0;        ///< one curve from end to end, 0.2 to 60
  double lowest_hz = 200.0;    ///< at the bottom of the window
  double highest_hz = 1000.0;  ///< at its top
  double volume = 0.5;         ///< 0 to 1; 0 is silence
  bool earcons = true;         ///< short signs at points of interest
};

/// The sound of one point of the plate, both in a sweep and for touching.
struct Cue {
  double hertz = 0;     ///< on a logarithmic scale over the height of the window, limited to its ends
  double pan = 0;       ///< -1 left to 1 right
  double noise = 0;     ///< share of noise, above 0 where y < 0
  double loudness = 0;  ///< 0 silent to 1
};
/// @param nearness  1 on the curve, 0 out of reach; the loudness.
[[nodiscard]] Cue cue_at(PlatePoint at, const Window& window, double nearness,
                         const SoundSettings& settings = {});

/// Stereo samples in -1..1, left and right alternating.
struct Sound {
  int sample_rate = 44'100;
  std::vector<float> samples;
};

/// Each statement in turn, with a short silence between: y = f(x) from left to right in equal time, other
/// curves along each branch, lower ones first. Silent where undefined, with a click at entry and exit; dense
/// bands tremble; points of interest have earcons (shorter than 0.2 s).
/// @return Errc::bad_argument for settings out of range.
[[nodiscard]] base::Result<Sound> sweep(const Plot& plot, const Tracing& tracing,
                                        const std::vector<PointOfInterest>& points,
                                        const SoundSettings& settings = {});

/// 16-bit stereo WAV through libsndfile.
[[nodiscard]] base::Result<void> save_wav(const Sound& sound, const std::filesystem::path& path);

}  // namespace nazori::functions
