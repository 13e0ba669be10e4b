// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/inked_stroke.h"

#include <algorithm>
#include <cmath>

namespace nazori::view {
namespace {

constexpr double kThinnestInk_m = 0.0004;
constexpr double kWidestInk_m = 0.0020;
constexpr double kLaidFlat = 0.6;  // of its width more, of a brush on its side

// The brush of inked().
constexpr double kBrush_m = 0.0009;    ///< half of its width, and more of the pressed width
constexpr double kPressed = 0.55;      ///< share of the pressed width that is added
constexpr double kSmoothed_m = 0.006;  ///< on which the brush follows the speed of the hand
constexpr double kEntry_m = 0.0025;    ///< on which the brush opens
constexpr double kEntryWidth = 0.6;    ///< where it comes down
constexpr double kFastest = 0.78;      ///< width where the hand is fast
constexpr double kSlowest = 1.12;      ///< and where it is slow
constexpr double kEndTime_s = 0.06;    ///< in which the end of a stroke is seen to stop or not
constexpr double kSweepSpeed = 0.6;    ///< of the mean speed: faster at the end is a sweep
constexpr double kSweepShare = 0.35;   ///< of the length that a sweep thins out on
constexpr double kLongestSweep_m = 0.012;
constexpr double kPoint = 0.12;  ///< width at the end of a sweep

using Stroke = geometry::WrittenStroke<geometry::TabletFrame>;

double length_m(const Stroke& stroke) {
  double sum_m = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) sum_m += geometry::distance(stroke[i - 1].at, stroke[i].at);
  return sum_m;
}

/// Mean speed [m/s]; 0: not known.
double mean_speed_m_s(const Stroke& stroke, double length) {
  if (stroke.empty() || !stroke.front().time_s || !stroke.back().time_s) return 0;
  const double time_s = *stroke.back().time_s - *stroke.front().time_s;
  return time_s > 0 ? length / time_s : 0;
}

/// Whether the hand was still moving when the pen was lifted.
bool is_swept(const Stroke& stroke, double mean_m_s) {
  if (mean_m_s <= 0) return false;
  const double from_s = *stroke.back().time_s - kEndTime_s;
  double end_m = 0;
  for (std::size_t i = stroke.size(); i-- > 1 && stroke[i - 1].time_s && *stroke[i - 1].time_s >= from_s;)
    end_m += geometry::distance(stroke[i - 1].at, stroke[i].at);
  return end_m / kEndTime_s > kSweepSpeed * mean_m_s;
}

}  // namespace

double InkedStroke::half_width_at(std::size_t i) const {
  if (half_width_m) return *half_width_m;
  return i < half_widths_m.size() ? half_widths_m[i] : ink_half_width_m(points[i]);
}

double ink_half_width_m(const geometry::WrittenPoint<geometry::TabletFrame>& point) {
  const double pressure = std::clamp(point.pressure.value_or(0), 0.0, 1.0);
  const double upright_m = kThinnestInk_m + (kWidestInk_m - kThinnestInk_m) * pressure;
  return upright_m * (1 + kLaidFlat * std::sin(point.lean_rad.value_or(0)));
}

InkedStroke inked(const geometry::WrittenStroke<geometry::TabletFrame>& stroke, Verdict verdict,
                  bool has_ended) {
  InkedStroke drawn;
  drawn.verdict = verdict;
  drawn.points.reserve(stroke.size());
  for (const auto& point : stroke)
    if (drawn.points.empty() || drawn.points.back().at != point.at) drawn.points.push_back(point);
  const double length = length_m(drawn.points);
  const double mean_m_s = mean_speed_m_s(stroke, length);
  const double sweep_m =
      has_ended && is_swept(stroke, mean_m_s) ? std::min(kSweepShare * length, kLongestSweep_m) : 0;
  double along_m = 0;
  double speed = 1;  // relative to the mean, smoothed
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    const auto& point = drawn.points[i];
    if (i > 0) {
      const double step_m = geometry::distance(drawn.points[i - 1].at, point.at);
      along_m += step_m;
      const double step_s = point.time_s.value_or(0) - drawn.points[i - 1].time_s.value_or(0);
      const double now = step_s > 0 && mean_m_s > 0 ? step_m / step_s / mean_m_s : 1;
      speed += (1 - std::exp(-step_m / kSmoothed_m)) * (std::min(now, 3.0) - speed);
    }
    double width = std::clamp(kSlowest - 0.17 * (speed - 0.3), kFastest, kSlowest);
    width *= std::min(1.0, kEntryWidth + (1 - kEntryWidth) * along_m / kEntry_m);
    if (const double left_m = length - along_m; left_m < sweep_m)
      width *= kPoint + (1 - kPoint) * left_m / sweep_m;
    drawn.half_widths_m.push_back(width * (kBrush_m + kPressed * ink_half_width_m(point)));
  }
  return drawn;
}

}  // namespace nazori::view
