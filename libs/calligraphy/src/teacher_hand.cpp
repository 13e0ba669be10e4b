// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/teacher_hand.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nazori/geometry/point.h"

namespace nazori::calligraphy {
namespace {

using geometry::PaperPoint;

constexpr double kSampled_s = 0.016;     ///< while the pen rests or is in the air
constexpr double kBendReach_m = 0.0015;  ///< a turn is looked at over this way to both sides
constexpr double kSharp = 0.5;           ///< cosine of the turn: 60 degrees
constexpr double kTip = 0.75;            ///< of the pressure, where the brush is set down
constexpr double kLaid_m = 0.004;        ///< from there on the hair lies
constexpr double kThin = 0.6;            ///< of the broadest part; what is thinner at the end is a sweep

/// The point of a line that is so far from point `i`, forwards or backwards.
PaperPoint point_beyond(const ModelStroke& stroke, std::size_t i, double way_m, bool forwards) {
  double way = 0;
  while (way < way_m && (forwards ? i + 1 < stroke.points.size() : i > 0)) {
    const std::size_t next = forwards ? i + 1 : i - 1;
    way += geometry::distance(stroke.points[i], stroke.points[next]);
    i = next;
  }
  return stroke.points[i];
}

bool is_bend(const ModelStroke& stroke, std::size_t i) {
  const PaperPoint in = stroke.points[i] - point_beyond(stroke, i, kBendReach_m, false);
  const PaperPoint out = point_beyond(stroke, i, kBendReach_m, true) - stroke.points[i];
  const double lengths = std::hypot(in.x, in.y) * std::hypot(out.x, out.y);
  return lengths > 0 && (in.x * out.x + in.y * out.y) / lengths < kSharp;
}

/// From where on a stroke thins out to its end; its number of points where it does not.
std::size_t sweep_of(const ModelStroke& stroke) {
  const double broadest = *std::max_element(stroke.half_width_m.begin(), stroke.half_width_m.end());
  std::size_t from = stroke.points.size();
  while (from > 0 && stroke.half_width_m[from - 1] < kThin * broadest) --from;
  return from;
}

/// A pen whose samples are collected.
class Hand {
 public:
  explicit Hand(const HandPace& pace) : pace_(pace) {}

  void carry_to(PaperPoint to) {
    if (samples_.empty()) return add(to, 0, false, 0);
    const PaperPoint from = samples_.back().at;
    const double seconds = std::max(pace_.least_air_s, geometry::distance(from, to) / pace_.air_m_s);
    const int parts = std::max(1, static_cast<int>(std::lround(seconds / kSampled_s)));
    for (int k = 1; k <= parts; ++k)
      add(from + (to - from) * (static_cast<double>(k) / parts), seconds / parts, false, 0);
  }
  void rest(double pressure) {
    const PaperPoint at = samples_.back().at;
    const int parts = std::max(1, static_cast<int>(std::lround(pace_.rest_s / kSampled_s)));
    for (int k = 0; k < parts; ++k) add(at, pace_.rest_s / parts, true, pressure);
  }
  void set_down(double pressure) { add(samples_.back().at, kSampled_s, true, pressure); }
  void move_to(PaperPoint to, double speed_m_s, double pressure) {
    const double way = geometry::distance(samples_.back().at, to);
    if (way > 0) add(to, way / speed_m_s, true, pressure);
  }
  void lift() { add(samples_.back().at, kSampled_s, false, 0); }
  [[nodiscard]] std::vector<brush::PenSample> samples() && { return std::move(samples_); }

 private:
  void add(PaperPoint at, double after_s, bool down, double pressure) {
    brush::PenSample sample;
    sample.time_s = samples_.empty() ? 0 : samples_.back().time_s + after_s;
    sample.at = at;
    sample.down = down;
    sample.pressure = pressure;
    samples_.push_back(sample);
  }

  HandPace pace_;
  std::vector<brush::PenSample> samples_;
};

}  // namespace

std::vector<brush::PenSample> teacher_hand(std::span<const ModelStroke> strokes, const BrushWidths& widths,
                                           const HandPace& pace) {
  Hand hand(pace);
  for (const ModelStroke& stroke : strokes) {
    const std::size_t last = stroke.points.size() - 1;
    const std::size_t sweep = sweep_of(stroke);
    double way = 0;
    const auto pressure_at = [&](std::size_t i) {
      const double laid = std::min(1.0, kTip + (1 - kTip) * way / kLaid_m);
      return laid * widths.pressure_for(stroke.half_width_m[i]);
    };
    hand.carry_to(stroke.points.front());
    hand.set_down(pressure_at(0));
    for (std::size_t i = 1; i <= last; ++i) {
      way += geometry::distance(stroke.points[i - 1], stroke.points[i]);
      const bool is_slow = way < kLaid_m || is_bend(stroke, i);
      const double speed = i > sweep ? pace.sweep_m_s : is_slow ? pace.bend_m_s : pace.body_m_s;
      hand.move_to(stroke.points[i], speed, pressure_at(i));
    }
    if (sweep > last) hand.rest(pressure_at(last));
    hand.lift();
  }
  return std::move(hand).samples();
}

}  // namespace nazori::calligraphy
