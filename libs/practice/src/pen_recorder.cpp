// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/pen_recorder.h"

#include <algorithm>
#include <cmath>

namespace nazori::practice {
namespace {

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
  // A fast hand has moved on before the stylus arrived: the stroke begins at the nearest point it reached.
  const bool arrived = away_m < kArrived_m || away_m > nearest_m_ + kTurnedAway_m;
  nearest_m_ = std::min(nearest_m_, away_m);
  if (!arrived) return true;
  pressed_at_.reset();
  nearest_m_ = kFar_m;
  return false;
}

PenRecorder::Event PenRecorder::follow(const haptics::ServoSample& sample) {
  // A late tick interrupts the contact although the hand did not lift.
  if (haptics::has(sample.events, haptics::ServoEvent::fault)) return Event::none;
  if (!sample.touching) {
    const bool ended = touching_ && !dropped_;
    touching_ = false;
    dropped_ = false;
    if (ended) pressed_at_.reset();
    nearest_m_ = kFar_m;
    if (!ended) return Event::none;
    // The pause of the pen before it was lifted distinguishes a stop from a sweep.
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
    // The pen rests: the width there follows the strongest pressure.
    current_.back().pressure = std::max(current_.back().pressure.value_or(0), pressure);
    return Event::none;
  }
  current_.push_back(last_);
  return Event::grew;
}

void PenRecorder::drop() {
  current_.clear();
  dropped_ = touching_;
}

writing::WrittenCharacter to_ink(const std::vector<HandStroke>& strokes, const geometry::TabletShape& shape) {
  writing::WrittenCharacter ink;
  for (const auto& stroke : strokes)
    ink.strokes.push_back(geometry::in_frame<writing::WritingFrame>(stroke, [&shape](auto at) {
      const auto glyph = geometry::tablet_to_glyph(at, shape);
      return writing::WritingPoint{glyph.x, glyph.y};
    }));
  ink.box = writing::WritingBox{{0, 0}, geometry::kGlyphSide};
  return ink;
}

HandStroke until(const HandStroke& stroke, double time_s) {
  HandStroke part;
  const auto between = [](const std::optional<double>& from, const std::optional<double>& to, double share) {
    return from.value_or(0) + (to.value_or(0) - from.value_or(0)) * share;
  };
  for (const auto& point : stroke) {
    if (point.time_s.value_or(0) <= time_s) {
      part.push_back(point);
      continue;
    }
    if (part.empty()) break;
    const auto& last = part.back();
    const double last_s = last.time_s.value_or(0);
    const double share = (time_s - last_s) / (point.time_s.value_or(0) - last_s);
    part.push_back({last.at + (point.at - last.at) * share, time_s,
                    between(last.pressure, point.pressure, share),
                    between(last.lean_rad, point.lean_rad, share)});
    break;
  }
  return part;
}

}  // namespace nazori::practice
