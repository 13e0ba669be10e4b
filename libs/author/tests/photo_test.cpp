// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "characters.h"
#include "line_comparison.h"
#include "moved_model.h"
#include "nazori/author/font_picture.h"
#include "nazori/author/trace.h"
#include "photographed.h"

namespace nazori::author::test {
namespace {

/// Low and high corner of all points.
std::pair<GlyphPoint, GlyphPoint> box_of(const std::vector<GlyphLine>& lines) {
  GlyphPoint low{1e9, 1e9};
  GlyphPoint high{-1e9, -1e9};
  for (const GlyphLine& line : lines)
    for (const GlyphPoint p : line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  return {low, high};
}

/// Strokes as ink: brushes of this half width that thin out in sweeps and hooks.
std::vector<OwnStroke> inked(const std::vector<kanji::StrokeLine>& strokes, double half_width) {
  std::vector<OwnStroke> ink;
  for (const kanji::StrokeLine& stroke : strokes) {
    const std::span<const GlyphPoint> all(stroke.points);
    const double length = geometry::arc_length(all);
    const auto count = static_cast<std::size_t>(length / 0.7) + 2;
    const auto line = geometry::resample(all, count);
    OwnStroke own;
    for (std::size_t i = 0; i < count; ++i) {
      const double left = length * (1 - static_cast<double>(i) / static_cast<double>(count - 1));
      const bool thins_out =
          stroke.ending == kanji::StrokeEnding::taper || stroke.ending == kanji::StrokeEnding::hook;
      const double tail = std::max(1.0, std::min(length * 0.4, 14.0));
      own.points.push_back(
          {line[i], thins_out ? half_width * std::min(1.0, 0.08 + left / tail) : half_width, 1});
    }
    ink.push_back(std::move(own));
  }
  return ink;
}

/// The lines of a character as they lie in a picture that was traced: turned as the picture, and with the box
/// of what was found.
std::vector<GlyphLine> as_found(const std::vector<kanji::StrokeLine>& strokes, const Shot& shot,
                                const std::vector<GlyphLine>& found) {
  std::vector<GlyphLine> lines;
  for (const kanji::StrokeLine& stroke : strokes) {
    lines.emplace_back();
    for (const GlyphPoint p : stroke.points) lines.back().push_back(shot.turned(p));
  }
  const auto [low, high] = box_of(lines);
  const auto [to_low, to_high] = box_of(found);
  for (GlyphLine& line : lines)
    for (GlyphPoint& p : line)
      p = {to_low.x + (p.x - low.x) * (to_high.x - to_low.x) / (high.x - low.x),
           to_low.y + (p.y - low.y) * (to_high.y - to_low.y) / (high.y - low.y)};
  return lines;
}

struct Kind {
  const char* name;
  Shot shot;
  double within;  ///< mean distance of each stroke [glyph units]
};

Shot shot_of(double scale, double turn_degrees, double paper_right, double noise, double blur) {
  Shot shot;
  shot.scale = scale;
  shot.width = static_cast<int>(165 * scale);
  shot.height = static_cast<int>(140 * scale);
  shot.left = 37 * scale;
  shot.top = 12 * scale;
  shot.turn_rad = turn_degrees * 3.14159265358979323846 / 180;
  shot.paper_right = paper_right;
  shot.noise = noise;
  shot.blur = blur;
  return shot;
}

const Kind kKinds[] = {{"a scan", shot_of(4, 0, 235, 2, 0.7), 0.85},
                       {"light from the left", shot_of(3, 0, 110, 4, 1.0), 0.85},
                       {"turned, noisy and not sharp", shot_of(5, 2.5, 170, 9, 3.0), 0.85},
                       {"small", shot_of(1.3, -2, 200, 5, 0.8), 1.1},
                       {"large", shot_of(12, 1, 180, 6, 3.0), 0.85}};

TEST(TracedPhotograph, OfAKnownCharacterHasItsStrokesInOrderWhateverTheLight) {
  for (const std::string name : {"永", "休", "口", "の"}) {
    const auto strokes = kanjivg(name);
    ASSERT_FALSE(strokes.empty()) << name;
    for (const Kind& kind : kKinds) {
      const auto found = trace_as(photographed(inked(strokes, 3.2), kind.shot), strokes);
      ASSERT_TRUE(found) << name << ", " << kind.name << ": " << base::to_line(found.error());
      ASSERT_EQ(found->size(), strokes.size());
      std::vector<GlyphLine> lines;
      for (const FittedStroke& s : *found) lines.push_back(line_of(s.stroke));
      const auto truth = as_found(strokes, kind.shot, lines);
      for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_LT(distance_of(truth[k], lines[k]).mean, kind.within)
            << name << ", " << kind.name << ", " << k + 1;
        EXPECT_LT(geometry::distance(truth[k].front(), lines[k].front()), 5) << name << ", " << kind.name;
        EXPECT_EQ((*found)[k].stroke.ending, strokes[k].ending);
        EXPECT_GT((*found)[k].covered, 0.4) << name << ", " << kind.name << ", " << k + 1;
        EXPECT_LT((*found)[k].moved, 3) << name << ", " << kind.name << ", " << k + 1;
      }
    }
  }
}

TEST(TracedPhotograph, OfAnotherHandHasTheLinesOfTheInkNotOfTheCharacter) {
  const auto strokes = kanjivg("永");
  const Shot shot = shot_of(4, 0, 200, 3, 1.0);
  const auto written = moved(strokes, 5);
  const auto found = trace_as(photographed(inked(written, 3.2), shot), strokes);
  ASSERT_TRUE(found);
  std::vector<GlyphLine> lines;
  for (const FittedStroke& s : *found) lines.push_back(line_of(s.stroke));
  const auto truth = as_found(written, shot, lines);
  const auto model = as_found(strokes, shot, lines);
  double to_model = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_LT(distance_of(truth[k], lines[k]).mean, 0.85) << k + 1;
    to_model = std::max(to_model, distance_of(model[k], lines[k]).mean);
  }
  EXPECT_GT(to_model, 1.5);
}

TEST(TracedPhotograph, OfABentCharacterIsFoundWherePartsMovedApart) {
  // Waves that move parts by more than the distance in which ink is looked for beside a line.
  for (const std::string name : {"永", "書", "休"}) {
    auto strokes = kanjivg(name);
    auto bent = strokes;
    for (kanji::StrokeLine& stroke : bent)
      for (GlyphPoint& p : stroke.points)
        p = p + GlyphPoint{6 * std::sin((p.y - 10) / 20), 6 * std::sin((p.x - 20) / 20)};
    const Shot shot = shot_of(4, 0, 235, 2, 0.7);
    const auto found = trace_as(photographed(inked(bent, name == "書" ? 1.6 : 3.0), shot), strokes);
    ASSERT_TRUE(found);
    std::vector<GlyphLine> lines;
    for (const FittedStroke& s : *found) lines.push_back(line_of(s.stroke));
    const auto truth = as_found(bent, shot, lines);
    for (std::size_t k = 0; k < lines.size(); ++k)
      EXPECT_LT(distance_of(truth[k], lines[k]).mean, 1.0) << name << ", " << k + 1;
  }
}

TEST(TracedPhotograph, OfAnUnknownCharacterHasItsStrokes) {
  for (const std::string name : {"永", "休", "口"}) {
    const auto strokes = kanjivg(name);
    const Shot shot = shot_of(4, 0, 190, 3, 1.0);
    const auto found = trace(photographed(inked(strokes, 2.6), shot));
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->size(), strokes.size()) << name;
    std::vector<GlyphLine> lines;
    for (const OwnStroke& s : *found) lines.push_back(line_of(s));
    const auto truth = as_found(strokes, shot, lines);
    const auto match = matched(truth, lines);
    for (std::size_t k = 0; k < truth.size(); ++k) {
      ASSERT_GE(match[k], 0) << name << ", " << k + 1;
      EXPECT_LT(distance_of(truth[k], lines[static_cast<std::size_t>(match[k])]).mean, 1.6)
          << name << ", " << k + 1;
    }
  }
}

TEST(TracedFont, HasTheStrokesOfTheCharacterInOrder) {
  struct Case {
    char32_t character;
    const char* name;
  };
  for (const Case& c : {Case{U'永', "永"}, Case{U'休', "休"}, Case{U'書', "書"}, Case{U'口', "口"}}) {
    const auto picture = font_picture(c.character, "Klee One", 512);
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    const auto strokes = kanjivg(c.name);
    const auto found = trace_as(*picture, strokes);
    ASSERT_TRUE(found) << c.name;
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      const FittedStroke& fit = (*found)[k];
      EXPECT_GT(fit.covered, 0.5) << c.name << ", " << k + 1;
      EXPECT_LT(fit.moved, 5) << c.name << ", " << k + 1;
      // The direction is that of the character.
      const GlyphLine line = line_of(fit.stroke);
      const GlyphPoint way = strokes[k].points.back() - strokes[k].points.front();
      EXPECT_GT(geometry::dot(line.back() - line.front(), way), 0) << c.name << ", " << k + 1;
    }
  }
}

TEST(TracedPhotograph, AStrokeWithoutInkIsNotCovered) {
  const auto strokes = kanjivg("休");
  auto ink = inked(strokes, 3.2);
  ink.erase(ink.begin() + 2);
  const auto found = trace_as(photographed(ink, shot_of(4, 0, 235, 2, 0.7)), strokes);
  ASSERT_TRUE(found);
  EXPECT_LT((*found)[2].covered, 0.5);
  for (const std::size_t k : {0UL, 1UL, 4UL}) EXPECT_GT((*found)[k].covered, 0.6) << k + 1;
}

TEST(TracedPhotograph, AThinPenIsALineToo) {
  const OwnStroke line = drawn({{15, 20}, {60, 30}, {92, 85}}, 0.35);
  const auto found = trace(photographed({{line}}, shot_of(4, 0, 235, 0, 0.6)));
  ASSERT_TRUE(found) << base::to_line(found.error());
  ASSERT_EQ(found->size(), 1U);
  const GlyphLine own = line_of(found->front());
  const auto truth = as_found({{{{15, 20}, {60, 30}, {92, 85}}, kanji::StrokeEnding::stop, {}}}, {}, {own});
  EXPECT_LT(distance_of(truth[0], own).mean, 0.5);
}

}  // namespace
}  // namespace nazori::author::test
