// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/pen_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nazori/geometry/polyline.h"

namespace nazori::writing {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kSmoothing_s = 0.06;
constexpr double kShortestPause_s = 0.15;
constexpr double kRestShare = 0.05;  // of the greatest speed: below it the pen rests
constexpr std::size_t kMostSteps = 60'000;

/// A stroke by columns: times and pressures of all points, or none.
struct Columns {
  geometry::Polyline<WritingFrame> points;
  std::vector<double> times_s;
  std::vector<double> pressures;
};

std::vector<double> column(const WrittenStroke& stroke, std::optional<double> WrittenPoint::*value) {
  std::vector<double> numbers;
  for (const WrittenPoint& point : stroke)
    if (const std::optional<double>& number = point.*value) numbers.push_back(*number);
  if (numbers.size() != stroke.size()) numbers.clear();
  return numbers;
}

Columns columns_of(const WrittenStroke& stroke) {
  return {geometry::line_of(stroke), column(stroke, &WrittenPoint::time_s),
          column(stroke, &WrittenPoint::pressure)};
}

/// Speed at even steps of time, smoothed.
std::vector<double> speeds(const Columns& s) {
  const double begin = s.times_s.front();
  const double duration = s.times_s.back() - begin;
  // Decreasing times, or times that are not numbers, give no speed.
  if (!(duration >= 3 * kStep_s)) return {};
  const auto steps = static_cast<std::size_t>(std::min(duration / kStep_s, static_cast<double>(kMostSteps)));
  std::vector<WritingPoint> at;
  at.reserve(steps + 1);
  std::size_t i = 0;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double t = begin + kStep_s * static_cast<double>(k);
    while (i + 2 < s.times_s.size() && s.times_s[i + 1] < t) ++i;
    const double span = s.times_s[i + 1] - s.times_s[i];
    const double f = span > 0 ? std::clamp((t - s.times_s[i]) / span, 0.0, 1.0) : 1.0;
    at.push_back(s.points[i] + (s.points[i + 1] - s.points[i]) * f);
  }
  std::vector<double> raw;
  raw.reserve(steps);
  for (std::size_t k = 0; k < steps; ++k) raw.push_back(geometry::distance(at[k], at[k + 1]) / kStep_s);
  const auto half = static_cast<std::ptrdiff_t>(kSmoothing_s / kStep_s / 2);
  std::vector<double> smooth(raw.size());
  for (std::ptrdiff_t k = 0; k < std::ssize(raw); ++k) {
    const auto first = std::max<std::ptrdiff_t>(0, k - half);
    const auto last = std::min<std::ptrdiff_t>(std::ssize(raw) - 1, k + half);
    smooth[static_cast<std::size_t>(k)] = std::accumulate(raw.begin() + first, raw.begin() + last + 1, 0.0) /
                                          static_cast<double>(last - first + 1);
  }
  return smooth;
}

int count_peaks(const std::vector<double>& speed) {
  if (speed.empty()) return 0;
  const double rise = 0.1 * *std::max_element(speed.begin(), speed.end());
  if (rise <= 0) return 0;
  int peaks = 0;
  bool rising = true;
  double extreme = 0;
  for (const double v : speed) {
    if (rising) {
      extreme = std::max(extreme, v);
      if (v < extreme - rise) {
        ++peaks;
        rising = false;
        extreme = v;
      }
    } else {
      extreme = std::min(extreme, v);
      if (v > extreme + rise) {
        rising = true;
        extreme = v;
      }
    }
  }
  // A stroke swept off the paper ends on its peak.
  return rising ? peaks + 1 : peaks;
}

std::vector<Pause> find_pauses(const std::vector<double>& speed) {
  std::vector<Pause> pauses;
  if (speed.empty()) return pauses;
  const double rest = kRestShare * *std::max_element(speed.begin(), speed.end());
  std::size_t start = 0;
  for (std::size_t k = 0; k <= speed.size(); ++k) {
    if (k < speed.size() && speed[k] <= rest) continue;
    const double duration = kStep_s * static_cast<double>(k - start);
    if (duration >= kShortestPause_s) pauses.push_back({kStep_s * static_cast<double>(start), duration});
    start = k + 1;
  }
  return pauses;
}

/// The last speed relative to the mean; 0 without speeds.
double speed_at_end(const std::vector<double>& speed) {
  const double sum = std::accumulate(speed.begin(), speed.end(), 0.0);
  return sum > 0 ? speed.back() * static_cast<double>(speed.size()) / sum : 0;
}

PenLift lift_of(const std::vector<double>& speed, const PenMotion& motion) {
  constexpr double kStillMoving = 0.4;  // of the mean speed
  constexpr double kLighter = 0.5;      // of the mean pressure
  if (!speed.empty()) return motion.speed_at_end > kStillMoving ? PenLift::swept : PenLift::stopped;
  if (motion.pressure && motion.pressure_at_end)
    return *motion.pressure_at_end < kLighter * *motion.pressure ? PenLift::swept : PenLift::stopped;
  return PenLift::unknown;
}

/// Mean over the last tenth of the path.
double pressure_at_end(const Columns& s) {
  const double length = geometry::arc_length<WritingFrame>(s.points);
  double from_end = 0;
  double sum = s.pressures.back();
  int count = 1;
  for (std::size_t i = s.points.size(); i-- > 1;) {
    from_end += geometry::distance(s.points[i - 1], s.points[i]);
    if (from_end > length / 10) break;
    sum += s.pressures[i - 1];
    ++count;
  }
  return sum / count;
}

}  // namespace

std::vector<PenMotion> pen_motion(const WrittenCharacter& ink) {
  std::vector<PenMotion> result;
  std::optional<double> last_end;
  for (const auto& stroke : ink.strokes) {
    const Columns s = columns_of(stroke);
    PenMotion m;
    std::vector<double> speed;
    if (s.times_s.size() >= 2) {
      m.duration_s = s.times_s.back() - s.times_s.front();
      if (last_end) m.pause_before_s = s.times_s.front() - *last_end;
      last_end = s.times_s.back();
      if (m.duration_s > 0) m.mean_speed = geometry::arc_length<WritingFrame>(s.points) / m.duration_s;
      speed = speeds(s);
      m.speed_peaks = count_peaks(speed);
      m.pauses = find_pauses(speed);
      m.speed_at_end = speed_at_end(speed);
    }
    if (!s.pressures.empty()) {
      m.pressure = std::accumulate(s.pressures.begin(), s.pressures.end(), 0.0) /
                   static_cast<double>(s.pressures.size());
      m.pressure_at_end = pressure_at_end(s);
      const auto [least, greatest] = std::minmax_element(s.pressures.begin(), s.pressures.end());
      m.pressure_range = *greatest - *least;
    }
    m.lift = lift_of(speed, m);
    result.push_back(std::move(m));
  }
  return result;
}

}  // namespace nazori::writing
