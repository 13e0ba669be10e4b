// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "nazori/kanji/character.h"
#include "nazori/writing/explanation.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/pen_motion.h"
#include "nazori/writing/recogniser.h"

namespace {

using namespace nazori;

kanji::Character cross() {
  kanji::Character c;
  c.code_point = U'十';
  for (const auto& line : {geometry::Polyline<geometry::GlyphFrame>{{12, 48}, {98, 46}},
                           geometry::Polyline<geometry::GlyphFrame>{{53, 14}, {54, 95}, {48, 90}}}) {
    kanji::Stroke s;
    s.type = "㇐";
    s.line.points = line;
    c.strokes.push_back(s);
  }
  return c;
}

/// Any bytes as ink: a byte with the high bit begins a stroke; else 8 bytes are a point, as two floats of any
/// kind or as a small grid.
writing::WrittenCharacter ink_of(const std::uint8_t* data, std::size_t size) {
  writing::WrittenCharacter ink;
  std::size_t i = 0;
  while (i + 3 < size) {
    const std::uint8_t kind = data[i++];
    if ((kind & 0x80U) != 0 || ink.strokes.empty()) ink.strokes.emplace_back();
    auto& stroke = ink.strokes.back();
    if ((kind & 0x40U) != 0 && i + 8 <= size) {
      float xy[2];
      std::memcpy(xy, data + i, sizeof xy);
      i += sizeof xy;
      stroke.push_back({{static_cast<double>(xy[0]), static_cast<double>(xy[1])}});
    } else {
      stroke.push_back({{data[i] / 255.0, data[i + 1] / 255.0}});
      i += 2;
    }
    if ((kind & 0x20U) != 0) stroke.back().time_s = static_cast<double>(kind & 0x1FU) / 10;
    if ((kind & 0x10U) != 0) stroke.back().pressure = static_cast<double>(kind & 0x0FU) / 15;
  }
  if (size % 3 == 0) ink.box = writing::WritingBox{};
  return ink;
}

void demand(bool holds) {
  if (!holds) std::abort();
}

void look_over(const base::Result<writing::Grade>& grade, const writing::WrittenCharacter& ink) {
  if (!grade) return demand(grade.error().code == base::Errc::bad_argument);
  demand(grade->strokes.size() == ink.strokes.size());
  demand(grade->accepted == grade->mistakes.empty());
  demand(grade->score >= 0 && grade->score <= 100);
  for (const auto& s : grade->strokes)
    demand(std::isfinite(s.offset_x) && std::isfinite(s.offset_y) && std::isfinite(s.size) &&
           std::isfinite(s.angle_rad) && std::isfinite(s.shape) && std::isfinite(s.deviation));
  for (const auto language : {writing::Language::english, writing::Language::japanese})
    demand(!writing::explain(*grade, language).empty());
}

}  // namespace

/// Any ink is refused, or graded with finite numbers and words, whole and live and at any strictness.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto kModel = writing::Model::make(cross());
  static const auto kRecogniser = writing::Recogniser::make(std::vector{cross()});
  const auto ink = ink_of(data, size);
  const double strictness = static_cast<double>(size % 5) / 4;
  look_over(writing::grade(ink, *kModel, {strictness, size % 2 == 0}), ink);
  if (ink.strokes.size() <= 12)
    look_over(writing::grade_live(ink, *kModel, {strictness, size % 2 == 0}), ink);
  if (!writing::check(ink)) return 0;
  for (const auto& m : writing::pen_motion(ink)) demand(std::isfinite(m.mean_speed) && m.speed_peaks >= 0);
  const auto found = kRecogniser->recognise(ink, {10, size % 2 == 0});
  demand(found.has_value());
  for (const auto& c : *found) demand(std::isfinite(c.likeness));
  return 0;
}
