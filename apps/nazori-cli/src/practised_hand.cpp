// SPDX-License-Identifier: Apache-2.0
#include "practised_hand.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "nazori/geometry/frames.h"

namespace nazori::cli {
namespace {

constexpr double kSample_s = 0.008;
constexpr double kStep_m = 0.0008;      ///< between two samples of a stroke without times
constexpr double kGroove_m = 0.005;     ///< depth of the tip in the tablet
constexpr double kFullPress_m = 0.015;  ///< as practice::PenRecorder has it
constexpr double kUsualPressure = 0.4;
constexpr int kRestSamples = 12;  ///< the pen rests before it is lifted, as at a stop

geometry::TabletPoint on_tablet(const writing::WrittenPoint& point, const writing::WritingBox& box) {
  const geometry::GlyphPoint glyph{(point.at.x - box.corner.x) / box.side * geometry::kGlyphSide,
                                   (point.at.y - box.corner.y) / box.side * geometry::kGlyphSide};
  return geometry::glyph_to_tablet(glyph, geometry::TabletShape{});
}

}  // namespace

void PractisedHand::sample(geometry::TabletPoint at, bool touching, double pressure) {
  haptics::ServoSample sample;
  sample.time_s = time_s_;
  sample.touching = touching;
  sample.proxy_m = {at.x, at.y, touching ? -kGroove_m : kGroove_m};
  sample.device_m = {at.x, at.y, sample.proxy_m.z - (touching ? pressure * kFullPress_m : 0)};
  tablet_.follow(std::span(&sample, 1));
}

void PractisedHand::write(const std::vector<writing::WrittenPoint>& stroke, const writing::WritingBox& box) {
  if (stroke.empty()) return;
  time_s_ += kSample_s;
  sample(on_tablet(stroke.front(), box), false, 0);
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    const auto to = on_tablet(stroke[i], box);
    const double pressure = stroke[i].pressure.value_or(kUsualPressure);
    if (i == 0) {
      time_s_ += kSample_s;
      sample(to, true, pressure);
      continue;
    }
    const auto from = on_tablet(stroke[i - 1], box);
    const int steps = std::max(1, static_cast<int>(std::ceil(geometry::distance(from, to) / kStep_m)));
    const bool is_timed =
        stroke[i].time_s && stroke[i - 1].time_s && *stroke[i].time_s > *stroke[i - 1].time_s;
    const double step_s = is_timed ? (*stroke[i].time_s - *stroke[i - 1].time_s) / steps : kSample_s;
    for (int step = 1; step <= steps; ++step) {
      time_s_ += step_s;
      sample(from + (to - from) * (static_cast<double>(step) / steps), true, pressure);
    }
  }
  const auto end = on_tablet(stroke.back(), box);
  if (!stroke.back().time_s)
    for (int i = 0; i < kRestSamples; ++i) {
      time_s_ += kSample_s;
      sample(end, true, stroke.back().pressure.value_or(kUsualPressure));
    }
  time_s_ += kSample_s;
  sample(end, false, 0);
}

}  // namespace nazori::cli
