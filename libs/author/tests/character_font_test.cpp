// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "characters.h"
#include "font_reader.h"
#include "own_forms.h"

namespace nazori::author {
namespace {

using test::Bytes;
using test::even_stroke;
using test::FlatOutline;
using test::font_of;
using test::GlyphPoint;
using test::GrooveDistance;
using test::ReadFont;
using test::tables_of;
using test::u16_at;

constexpr char32_t kPrivate = 0xF0000;

/// The outline of a font's glyph.
FlatOutline outline_in(const ReadFont& font, char32_t code_point) {
  EXPECT_TRUE(font.load(code_point)) << std::hex << static_cast<unsigned>(code_point);
  return FlatOutline(font.face()->glyph->outline);
}

FlatOutline outline_of(const std::vector<OwnStroke>& strokes) {
  const Bytes bytes = font_of({{kPrivate, strokes}});
  return outline_in(ReadFont(bytes), kPrivate);
}

OwnStroke ring(GlyphPoint middle, double radius, double half_width) {
  OwnStroke stroke;
  for (int i = 0; i <= 24; ++i) {
    const double angle = 2 * std::numbers::pi * i / 24;
    stroke.points.push_back({middle + GlyphPoint{std::cos(angle), std::sin(angle)} * radius, half_width, 1});
  }
  stroke.points.back().at = stroke.points.front().at;
  return stroke;
}

/// Compares a glyph with the grooves at random points near their edges.
void expect_shape(const FlatOutline& outline, const std::vector<OwnStroke>& strokes, std::mt19937& random,
                  int points, double tolerance = kFontTolerance) {
  const GrooveDistance groove(strokes);
  std::uniform_real_distribution<double> unit(0, 1);
  int inside = 0;
  int outside = 0;
  for (int i = 0; i < points; ++i) {
    const auto& line = groove.lines()[random() % groove.lines().size()];
    const carving::SmoothPoint& at = line[random() % line.size()];
    const double angle = 2 * std::numbers::pi * unit(random);
    const double far = std::max(0.0, at.half_width + 4 * (unit(random) - 0.5) * tolerance);
    const GlyphPoint p = at.at + GlyphPoint{std::cos(angle), std::sin(angle)} * far;
    const double off = groove.to(p);
    const int winding = outline.winding(p);
    ASSERT_GE(winding, 0) << "(" << p.x << ", " << p.y << ")";
    if (off < -tolerance) {
      ASSERT_GT(winding, 0) << "(" << p.x << ", " << p.y << ") is " << -off << " inside";
      ++inside;
    } else if (off > tolerance) {
      ASSERT_EQ(winding, 0) << "(" << p.x << ", " << p.y << ") is " << off << " outside";
      ++outside;
    }
  }
  EXPECT_GT(inside + outside, points / 20);
  for (const auto& line : groove.lines())
    for (const carving::SmoothPoint& at : line)
      ASSERT_GT(outline.winding(at.at + GlyphPoint{1e-7, 1e-7}), 0) << at.at.x << ", " << at.at.y;
}

TEST(CharacterFont, WhatIsMissingIsAFrame) {
  const Bytes bytes = font_of({});
  const ReadFont font(bytes);
  ASSERT_EQ(FT_Load_Glyph(font.face(), 0, FT_LOAD_NO_SCALE), 0);
  EXPECT_EQ(font.face()->glyph->metrics.horiAdvance, 1000);
  const FlatOutline frame(font.face()->glyph->outline);
  EXPECT_EQ(frame.winding({54.5, 54.5}), 0);
  EXPECT_EQ(frame.winding({13, 54.5}), 1);
  EXPECT_EQ(frame.winding({54.5, 8}), 1);
  EXPECT_EQ(frame.winding({5, 54.5}), 0);
}

TEST(CharacterFont, AStrokeIsDrawnWhereItsGrooveIs) {
  const Bytes bytes = font_of({{kPrivate, {even_stroke({{20, 30}, {80, 30}}, 6)}}});
  const ReadFont font(bytes);
  ASSERT_EQ(FT_Set_Pixel_Sizes(font.face(), 0, 109), 0);  // a pixel is a glyph unit
  ASSERT_EQ(FT_Load_Char(font.face(), kPrivate, FT_LOAD_RENDER | FT_LOAD_NO_HINTING), 0);
  const FT_GlyphSlot glyph = font.face()->glyph;
  EXPECT_NE(glyph->outline.flags & FT_OUTLINE_OVERLAP, 0);
  EXPECT_EQ(glyph->outline.flags & FT_OUTLINE_EVEN_ODD_FILL, 0);
  double area = 0;
  for (int row = 0; row < static_cast<int>(glyph->bitmap.rows); ++row) {
    for (int column = 0; column < static_cast<int>(glyph->bitmap.width); ++column) {
      const double ink = glyph->bitmap.buffer[row * glyph->bitmap.pitch + column] / 255.0;
      area += ink;
      const double x = glyph->bitmap_left + column + 0.5;
      const double y = 109 * 0.88 - (glyph->bitmap_top - row - 0.5);
      const double off = std::hypot(x - std::clamp(x, 20.0, 80.0), y - 30) - 6;
      if (off < -0.9) {
        EXPECT_GT(ink, 0.99) << x << ", " << y;
      } else if (off > 0.9) {
        EXPECT_LT(ink, 0.01) << x << ", " << y;
      }
    }
  }
  EXPECT_NEAR(area, 60 * 12 + std::numbers::pi * 36, 6);
}

TEST(CharacterFont, AStrokeOfOnePointIsADot) {
  std::mt19937 random(1);
  for (const double half_width : {0.0, 0.5, 3.0, 20.0}) {
    const std::vector<OwnStroke> strokes = {even_stroke({{50, 60}}, half_width)};
    const FlatOutline dot = outline_of(strokes);
    expect_shape(dot, strokes, random, 2000);
    EXPECT_EQ(dot.winding({50, 60}), 1);
  }
  const std::vector<OwnStroke> twice = {even_stroke({{50, 60}, {50, 60}}, 4)};
  expect_shape(outline_of(twice), twice, random, 2000);
}

TEST(CharacterFont, CrossingStrokesStayFilled) {
  const std::vector<OwnStroke> strokes = {even_stroke({{15, 50}, {95, 50}}),
                                          even_stroke({{55, 98}, {55, 12}}),
                                          even_stroke({{95, 90}, {15, 10}})};
  const FlatOutline outline = outline_of(strokes);
  EXPECT_EQ(outline.winding({55, 50}), 3);
  EXPECT_EQ(outline.winding({30, 50}), 1);
  std::mt19937 random(2);
  expect_shape(outline, strokes, random, 3000);
}

TEST(CharacterFont, ALoopKeepsItsHole) {
  const std::vector<OwnStroke> strokes = {ring({54, 54}, 30, 4)};
  const FlatOutline outline = outline_of(strokes);
  EXPECT_EQ(outline.winding({54, 54}), 0);
  EXPECT_EQ(outline.winding({54, 30}), 0);
  EXPECT_GE(outline.winding({54, 24}), 1);
  EXPECT_GE(outline.winding({84, 54}), 1);  // where it closes
  EXPECT_EQ(outline.winding({54, 19}), 0);
  std::mt19937 random(3);
  expect_shape(outline, strokes, random, 3000);
  // Wider than its radius, it has none.
  EXPECT_GE(outline_of({ring({54, 54}, 10, 12)}).winding({54, 54}), 1);
  const std::vector<OwnStroke> narrow = {ring({54, 54}, 10, 9)};
  expect_shape(outline_of(narrow), narrow, random, 3000);
}

TEST(CharacterFont, ASweepThinsOutButItsTipIsSeen) {
  const std::vector<OwnStroke> strokes = {{.points = {{{20, 54}, 6, 1}, {{90, 54}, 0, 0}}}};
  const FlatOutline outline = outline_of(strokes);
  EXPECT_GT(outline.winding({89.9, 54}), 0);
  EXPECT_EQ(outline.winding({90.3, 54}), 0);
  EXPECT_GT(outline.winding({89, 54.1}), 0);
  EXPECT_EQ(outline.winding({89, 54.6}), 0);
  EXPECT_GT(outline.winding({20, 59.7}), 0);
  std::mt19937 random(4);
  expect_shape(outline, strokes, random, 3000);
}

TEST(CharacterFont, AHairlineIsSeen) {
  const FlatOutline outline = outline_of({even_stroke({{20, 54}, {90, 54}}, 0)});
  EXPECT_GT(outline.winding({50, 54.4}), 0);
  EXPECT_GT(outline.winding({23, 53.6}), 0);
  EXPECT_EQ(outline.winding({50, 54.6}), 0);
  EXPECT_EQ(outline.winding({20.2, 54.4}), 0);
}

TEST(CharacterFont, TurningBackAndSharpBendsAreRound) {
  std::mt19937 random(5);
  const std::vector<std::vector<GlyphPoint>> lines = {
      {{20, 50}, {80, 50}, {20, 50}}, {{20, 50}, {80, 50}, {40, 50.5}},
      {{20, 20}, {80, 20}, {80, 80}}, {{20, 20}, {80, 50}, {20, 80}},
      {{20, 80}, {80, 50}, {20, 20}}, {{50, 50}, {51, 50}, {51, 51}, {50, 51}}};
  for (const auto& line : lines) {
    for (const double half_width : {0.5, 4.0, 18.0}) {
      const std::vector<OwnStroke> strokes = {even_stroke(line, half_width)};
      expect_shape(outline_of(strokes), strokes, random, 1000);
    }
  }
}

TEST(CharacterFont, WidthMayChangeFasterThanTheLineGoesOn) {
  std::mt19937 random(6);
  const std::vector<std::vector<GroovePoint>> grooves = {
      {{{50, 50}, 20, 1}, {{53, 50}, 0, 1}, {{56, 50}, 20, 1}},
      {{{20, 50}, 1, 1}, {{50, 50}, 1, 1}, {{52, 50}, 15, 1}, {{54, 50}, 1, 1}, {{90, 40}, 1, 1}},
      {{{50, 50}, 2, 1}, {{50, 50}, 9, 1}, {{50, 50}, 4, 1}},
      {{{50, 50}, 9, 1}, {{51, 50}, 3, 1}, {{51, 53}, 9, 1}, {{80, 53}, 9, 1}}};
  for (const auto& groove : grooves) {
    const std::vector<OwnStroke> strokes = {{.points = groove}};
    expect_shape(outline_of(strokes), strokes, random, 3000);
  }
}

TEST(CharacterFont, KanjiHaveFewPoints) {
  std::mt19937 random(7);
  for (const std::string character : {"永", "鬱", "あ"}) {
    const auto lines = test::kanjivg(character);
    ASSERT_FALSE(lines.empty());
    const auto strokes = own_strokes(lines);
    const Bytes bytes = font_of({{kPrivate, strokes}});
    const ReadFont font(bytes);
    expect_shape(outline_in(font, kPrivate), strokes, random, 2000);
    EXPECT_GE(font.face()->glyph->outline.n_contours, static_cast<short>(strokes.size()));
    EXPECT_LT(font.face()->glyph->outline.n_points, static_cast<short>(200 * strokes.size())) << character;
  }
}

std::vector<OwnStroke> random_strokes(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const bool is_wild = random() % 3 == 0;
  std::vector<OwnStroke> strokes(1 + random() % 5);
  for (OwnStroke& stroke : strokes) {
    GlyphPoint at{10 + 90 * unit(random), 10 + 90 * unit(random)};
    const double even = 8 * unit(random);
    const std::size_t count = 1 + random() % 9;
    for (std::size_t i = 0; i < count; ++i) {
      const double half_width = is_wild ? std::max(0.0, 24 * unit(random) - 4) : even * (0.5 + unit(random));
      stroke.points.push_back({at, half_width, 1});
      const double step = is_wild && random() % 4 == 0 ? 0.3 : 30;
      at = at + GlyphPoint{unit(random) - 0.5, unit(random) - 0.5} * (2 * step);
      at = {std::clamp(at.x, -109.0, 218.0), std::clamp(at.y, -109.0, 218.0)};
    }
  }
  return strokes;
}

TEST(CharacterFont, ThreeHundredRandomCharactersHaveTheShapeOfTheirGrooves) {
  std::mt19937 random(8);
  std::vector<FontGlyph> glyphs;
  for (unsigned i = 0; i < 300; ++i) glyphs.push_back({kPrivate + 2 * i, random_strokes(random)});
  const Bytes bytes = font_of(glyphs);
  const ReadFont font(bytes);
  for (const FontGlyph& glyph : glyphs) {
    SCOPED_TRACE(static_cast<unsigned>(glyph.code_point));
    expect_shape(outline_in(font, glyph.code_point), glyph.strokes, random, 300);
    if (testing::Test::HasFailure()) break;
  }
  // The order of the glyphs does not matter, and neither does when the font is made.
  EXPECT_EQ(bytes, font_of(glyphs));
  std::shuffle(glyphs.begin(), glyphs.end(), random);
  EXPECT_EQ(bytes, font_of(glyphs));
}

TEST(CharacterFont, TheMostComplexCharacterStaysWithinTheLimits) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<OwnStroke> waves;
  for (std::size_t k = 0; k < kMostStrokes; ++k) {
    OwnStroke wave;
    for (std::size_t i = 0; i < kMostPointsInAll / kMostStrokes; ++i) {
      const double x = static_cast<double>(i);
      wave.points.push_back({{5 + x, 5 + static_cast<double>(k) / 2 + 4 * std::sin(x / 4)}, 0.5, 1});
    }
    waves.push_back(wave);
  }
  std::vector<OwnStroke> jumps;
  for (std::size_t k = 0; k < kMostPointsInAll / kMostPoints; ++k) {
    OwnStroke jump;
    for (std::size_t i = 0; i < kMostPoints; ++i)
      jump.points.push_back(
          {{327 * unit(random) - 109, 327 * unit(random) - 109}, 20 * unit(random) * unit(random), 1});
    jumps.push_back(jump);
  }
  const Bytes bytes = font_of({{kPrivate, waves}, {kPrivate + 1, jumps}});
  const ReadFont font(bytes);
  EXPECT_LE(u16_at(tables_of(bytes).at("maxp"), 6), 20'000U);
  for (const char32_t code : {char32_t{0xF0000}, char32_t{0xF0001}}) {
    ASSERT_EQ(FT_Set_Pixel_Sizes(font.face(), 0, 64), 0);
    EXPECT_EQ(FT_Load_Char(font.face(), code, FT_LOAD_RENDER | FT_LOAD_NO_HINTING), 0);
    ASSERT_TRUE(font.load(code));
    const FT_Outline& outline = font.face()->glyph->outline;
    double edge = 0;
    for (int contour = 0, i = 0; contour < outline.n_contours; ++contour)
      for (++i; i <= outline.contours[contour]; ++i)
        edge += std::hypot(outline.points[i].x - outline.points[i - 1].x,
                           outline.points[i].y - outline.points[i - 1].y);
    EXPECT_LE(edge, 2'200'000) << static_cast<unsigned>(code);
    EXPECT_GT(outline.n_points, 100);
  }
  // Bends that a hand can draw keep their shape.
  const FlatOutline outline = outline_in(font, kPrivate);
  for (const OwnStroke& wave : waves)
    for (const GroovePoint& point : wave.points) ASSERT_GT(outline.winding(point.at), 0);
  EXPECT_EQ(outline.winding({54, 0}), 0);
  EXPECT_EQ(outline.winding({54, 110}), 0);
}

TEST(CharacterFont, AGlyphHasNoPointTwiceInARow) {
  // Dots and short strokes whose discs are smaller than a step of the grid.
  const std::vector<OwnStroke> strokes = {even_stroke({{20, 20}, {20.05, 20.03}, {20.1, 20}}, 0.1),
                                          even_stroke({{50, 50}}, 0.05), ring({70, 70}, 0.3, 0.2),
                                          even_stroke({{20, 80}, {60, 90}}, 3)};
  const Bytes bytes = font_of({{kPrivate, strokes}});
  const ReadFont font(bytes);
  ASSERT_TRUE(font.load(kPrivate));
  const FT_Outline& outline = font.face()->glyph->outline;
  ASSERT_GE(outline.n_contours, 4);
  int first = 0;
  for (int c = 0; c < outline.n_contours; ++c) {
    const int last = outline.contours[c];
    for (int i = first; i <= last && last > first; ++i) {
      const FT_Vector a = outline.points[i];
      const FT_Vector b = outline.points[i == last ? first : i + 1];
      EXPECT_FALSE(a.x == b.x && a.y == b.y) << c << ", " << i - first;
    }
    first = last + 1;
  }
}

TEST(CharacterFont, APointInTheMiddleOfItsNeighboursIsLeftOut) {
  // TrueType puts such a point between two control points by itself.
  const Bytes bytes = font_of({{kPrivate, {ring({54, 54}, 30, 5)}}});
  const ReadFont font(bytes);
  ASSERT_TRUE(font.load(kPrivate));
  const FT_Outline& outline = font.face()->glyph->outline;
  int first = 0;
  for (int c = 0; c < outline.n_contours; ++c) {
    const int last = outline.contours[c];
    const auto on = [&](int i) { return (outline.tags[i] & 1) != 0; };
    for (int i = first + 1; i < last; ++i) {
      if (!on(i) || on(i - 1) || on(i + 1)) continue;
      const FT_Vector a = outline.points[i - 1];
      const FT_Vector b = outline.points[i + 1];
      const FT_Vector p = outline.points[i];
      EXPECT_FALSE(std::abs(2 * p.x - a.x - b.x) <= 1 && std::abs(2 * p.y - a.y - b.y) <= 1) << i;
    }
    first = last + 1;
  }
}

}  // namespace
}  // namespace nazori::author
