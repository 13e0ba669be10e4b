// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/written_character.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "nazori/writing/grade.h"

namespace nazori::writing {
namespace {

constexpr double kLargest = 1e9;

bool usable(double v) { return std::isfinite(v) && std::abs(v) <= kLargest; }

bool all_or_none(const WrittenStroke& stroke, std::optional<double> WrittenPoint::*value) {
  const auto known = std::count_if(stroke.begin(), stroke.end(),
                                   [value](const WrittenPoint& p) { return (p.*value).has_value(); });
  return known == 0 || known == std::ssize(stroke);
}

std::string stroke_name(std::size_t index) { return "stroke " + std::to_string(index + 1); }

}  // namespace

base::Result<void> check(const WrittenCharacter& ink) {
  using base::Errc;
  using base::fail;
  if (ink.strokes.empty()) return fail(Errc::bad_argument, "there are no strokes");
  if (ink.strokes.size() > kMaxInkStrokes)
    return fail(Errc::bad_argument, "there are too many strokes", std::to_string(ink.strokes.size()),
                "give at most " + std::to_string(kMaxInkStrokes));
  if (ink.box &&
      !(usable(ink.box->corner.x) && usable(ink.box->corner.y) && ink.box->side > 0 && usable(ink.box->side)))
    return fail(Errc::bad_argument, "the writing box must be a square larger than zero");
  std::size_t count = 0;
  bool apart = false;
  const WritingPoint* first = nullptr;
  for (std::size_t i = 0; i < ink.strokes.size(); ++i) {
    const auto& s = ink.strokes[i];
    if (s.empty()) return fail(Errc::bad_argument, "has no points", stroke_name(i));
    if (!all_or_none(s, &WrittenPoint::time_s))
      return fail(Errc::bad_argument, "must have as many times as points", stroke_name(i));
    if (!all_or_none(s, &WrittenPoint::pressure))
      return fail(Errc::bad_argument, "must have as many pressures as points", stroke_name(i));
    count += s.size();
    if (count > kMaxInkPoints)
      return fail(Errc::bad_argument, "has too many points", stroke_name(i),
                  "give at most " + std::to_string(kMaxInkPoints));
    for (const WrittenPoint& p : s) {
      const WritingPoint& at = p.at;
      if (!usable(at.x) || !usable(at.y))
        return fail(Errc::bad_argument, "has an invalid coordinate", stroke_name(i));
      if (first == nullptr) first = &at;
      apart = apart || !(at == *first);
    }
  }
  if (!apart) return fail(Errc::bad_argument, "all points are the same");
  return {};
}

}  // namespace nazori::writing
