// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/key_pen.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "nazori/geometry/polyline.h"

namespace nazori::practice {
namespace {

// Nearer than this to an end of a stroke the pen is at that end.
constexpr double kAtEnd_m = 1.5e-3;
// Of strokes that are equally near the first is named, whatever rounding says.
constexpr double kSame_m = 1e-9;

}  // namespace

KeyPenEvent KeyPen::begin() {
  in_use_ = true;
  at_ = {0, 0};
  is_down_ = false;
  visited_ = 0;
  send();
  return {KeyPenDid::moved, where()};
}

void KeyPen::end() {
  if (!in_use_) return;
  in_use_ = false;
  if (is_down_) {
    is_down_ = false;
    send();
  }
  ground_.take_pen_away();
}

KeyPenEvent KeyPen::step(int right, int up, bool fine) {
  assert(in_use_ && std::abs(right) <= 1 && std::abs(up) <= 1);
  const double step_m = fine ? kFineStep_m : kStep_m;
  const double edge_m = ground_.side_m() / 2;
  const geometry::TabletPoint to{std::clamp(at_.x + right * step_m, -edge_m, edge_m),
                                 std::clamp(at_.y + up * step_m, -edge_m, edge_m)};
  if (to == at_) return {KeyPenDid::at_border, where()};
  return arrive(to);
}

KeyPenEvent KeyPen::press() {
  assert(in_use_);
  is_down_ = !is_down_;
  send();
  return {is_down_ ? KeyPenDid::put_down : KeyPenDid::lifted, where()};
}

KeyPenEvent KeyPen::go_to_next_start() {
  assert(in_use_);
  const int count = ground_.stroke_count();
  if (count == 0) return {KeyPenDid::no_strokes, where()};
  if (is_down_) {
    is_down_ = false;
    send();
  }
  const int alone = ground_.only_stroke();
  visited_ = alone > 0 ? alone : visited_ % count + 1;
  at_ = ground_.line(visited_).front();
  send();
  KeyPenPlace place = where();
  // Where strokes start at one point, the one that was asked for is meant.
  place.stroke = visited_;
  place.along = 0;
  return {KeyPenDid::at_start, place};
}

KeyPenPlace KeyPen::where() const { return place_at(at_); }

KeyPenPlace KeyPen::place_at(geometry::TabletPoint at) const {
  KeyPenPlace place;
  place.at = at;
  place.is_down = is_down_;
  place.from_left = at.x / ground_.side_m() + 0.5;
  place.from_top = 0.5 - at.y / ground_.side_m();
  place.depth = ground_.depth(at);
  double nearest_m = kReach_m;
  for (int number = 1; number <= ground_.stroke_count(); ++number) {
    if (ground_.only_stroke() != 0 && ground_.only_stroke() != number) continue;
    const KeyPenGround::Line points = ground_.line(number);
    if (points.empty()) continue;
    const std::span<const geometry::TabletPoint> line(points);
    const auto found = geometry::nearest_point(line, at);
    if (found.distance > nearest_m - (place.stroke != 0 ? kSame_m : 0)) continue;
    nearest_m = found.distance;
    place.stroke = number;
    const double length = geometry::arc_length(line);
    const double left = length - found.arc_length;
    place.along = length > 0 ? found.arc_length / length : 0;
    if (found.arc_length < kAtEnd_m && found.arc_length <= left)
      place.along = 0;
    else if (left < kAtEnd_m)
      place.along = 1;
  }
  return place;
}

KeyPenEvent KeyPen::arrive(geometry::TabletPoint at) {
  const KeyPenPlace before = where();
  at_ = at;
  send();
  const KeyPenPlace now = where();
  const bool same = now.stroke == before.stroke;
  if (now.stroke == 0) return {same ? KeyPenDid::moved : KeyPenDid::left_stroke, now, before.stroke};
  const auto newly = [&](double end) { return now.along == end && !(same && before.along == end); };
  if (newly(0)) return {KeyPenDid::at_start, now};
  if (newly(1)) return {KeyPenDid::at_end, now};
  return {same ? KeyPenDid::moved : KeyPenDid::met_stroke, now};
}

void KeyPen::send() { ground_.move_pen(at_, is_down_); }

functions::Cue cue_of(const KeyPenPlace& place) {
  constexpr double kLowest_hz = 200;
  constexpr double kHighest_hz = 1000;
  constexpr double kQuiet = 0.15;  // on the plateau, so that the place is heard there, too
  const double up = std::clamp(1 - place.from_top, 0.0, 1.0);
  return {kLowest_hz * std::pow(kHighest_hz / kLowest_hz, up), std::clamp(2 * place.from_left - 1, -1.0, 1.0),
          4 * place.depth * (1 - place.depth), kQuiet + (1 - kQuiet) * place.depth};
}

}  // namespace nazori::practice
