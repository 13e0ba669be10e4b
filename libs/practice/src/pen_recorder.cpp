// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/pen_recorder.h"

#include <algorithm>
#include <cmath>

namespace nazori::practice {
namespace {

constexpr double kThinnest_m = 0.0004;
constexpr double kWidest_m = 0.0020;
constexpr double kLaidFlat = 0.6;  // of its width more, of a brush on its side
constexpr double kArrived_m = 0.0008;
constexpr double kTurnedAway_m = 0.0002;

double length_m(const HandStroke& stroke) {
  double sum_m = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) sum_m += geometry::distance(stroke[i - 1].at, stroke[i].at);
  return sum_m;
}

}  // namespace

bool PenRecorder::is_on_its_way(geometry::TabletPoint at) {
  if (!pressed_at_) return false;
  const double away_m = geometry::distance(*pressed_at_, at);
  // A quick hand has moved on before the stylus arrived: the stroke begins where it came nearest.
  const bool arrived = away_m < kArrived_m || away_m > nearest_m_ + kTurnedAway_m;
  nearest_m_ = std::min(nearest_m_, away_m);
  if (!arrived) return true;
  pressed_at_.reset();
  nearest_m_ = kFar_m;
  return false;
}

PenRecorder::Event PenRecorder::follow(const haptics::ServoSample& sample) {
  // A tick that came too late drops the touch, which says nothing of the hand.
  if (haptics::has(sample.events, haptics::ServoEvent::fault)) return Event::none;
  if (!sample.touching) {
    const bool ended = touching_ && !dropped_;
    touching_ = false;
    dropped_ = false;
    if (ended) pressed_at_.reset();
    nearest_m_ = kFar_m;
    if (!ended) return Event::none;
    // How long the pen rested before it was lifted tells a stop from a sweep.
    if (!current_.empty() && last_.time_s > current_.back().time_s)
      current_.push_back({current_.back().at, last_.time_s, last_.pressure, last_.lean_rad});
    ended_ = std::move(current_);
    current_.clear();
    if (length_m(ended_) >= kSlip_m) return Event::ended;
    ended_.clear();
    return Event::slip;
  }
  touching_ = true;
  if (dropped_) return Event::none;
  const geometry::TabletPoint at{sample.proxy_m.x, sample.proxy_m.y};
  if (current_.empty() && is_on_its_way(at)) return Event::none;
  const double pressure = std::clamp((sample.proxy_m.z - sample.device_m.z) / full_press_m_, 0.0, 1.0);
  last_ = {at, sample.time_s, pressure, lean_rad_};
  if (!current_.empty() && geometry::distance(current_.back().at, at) < kStep_m) {
    // The pen rests: the width there is that of the firmest press.
    current_.back().pressure = std::max(current_.back().pressure, pressure);
    return Event::none;
  }
  current_.push_back(last_);
  return Event::grew;
}

void PenRecorder::drop() {
  current_.clear();
  dropped_ = touching_;
}

writing::Ink to_ink(const std::vector<HandStroke>& strokes, const geometry::TabletShape& shape) {
  writing::Ink ink;
  for (const auto& stroke : strokes) {
    auto& out = ink.strokes.emplace_back();
    for (const auto& point : stroke) {
      const auto glyph = geometry::tablet_to_glyph(point.at, shape);
      out.points.push_back({glyph.x, glyph.y});
      out.times_s.push_back(point.time_s);
      out.pressures.push_back(point.pressure);
    }
  }
  ink.box = writing::WritingBox{{0, 0}, geometry::kGlyphSide};
  return ink;
}

HandStroke until(const HandStroke& stroke, double time_s) {
  HandStroke part;
  for (const auto& point : stroke) {
    if (point.time_s <= time_s) {
      part.push_back(point);
      continue;
    }
    if (part.empty()) break;
    const auto& last = part.back();
    const double share = (time_s - last.time_s) / (point.time_s - last.time_s);
    part.push_back({last.at + (point.at - last.at) * share, time_s,
                    last.pressure + (point.pressure - last.pressure) * share,
                    last.lean_rad + (point.lean_rad - last.lean_rad) * share});
    break;
  }
  return part;
}

double ink_half_width_m(const HandPoint& point) {
  const double upright_m = kThinnest_m + (kWidest_m - kThinnest_m) * std::clamp(point.pressure, 0.0, 1.0);
  return upright_m * (1 + kLaidFlat * std::sin(point.lean_rad));
}

view::WrittenStroke to_written(const HandStroke& stroke, view::Verdict verdict) {
  view::WrittenStroke written;
  written.verdict = verdict;
  written.points.reserve(stroke.size());
  for (const auto& point : stroke)
    // The pen at rest draws nothing.
    if (written.points.empty() || written.points.back().at != point.at)
      written.points.push_back({point.at, ink_half_width_m(point)});
  return written;
}

}  // namespace nazori::practice
