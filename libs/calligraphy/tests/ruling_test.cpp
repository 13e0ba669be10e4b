// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/ruling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nazori/paint/sheet.h"

namespace nazori::calligraphy {
namespace {

TEST(Ruling, AsManySquaresAsCharactersAllOnTheSheet) {
  constexpr double kEdge = paint::Sheet::kSide_m / 2;
  for (const int count : kRulings) {
    const auto squares = ruled_squares(count);
    ASSERT_EQ(squares.size(), static_cast<std::size_t>(count));
    for (const auto& square : squares) {
      EXPECT_GT(square.side_m, 0.03);
      EXPECT_LT(std::abs(square.middle.x) + square.side_m / 2, kEdge);
      EXPECT_LT(std::abs(square.middle.y) + square.side_m / 2, kEdge);
    }
  }
  EXPECT_TRUE(ruled_squares(3).empty());
  EXPECT_TRUE(ruled_squares(-1).empty());
}

TEST(Ruling, SquaresTouchAndDoNotOverlap) {
  for (const int count : {2, 4, 6}) {
    const auto squares = ruled_squares(count);
    for (std::size_t i = 0; i < squares.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double apart = std::max(std::abs(squares[i].middle.x - squares[j].middle.x),
                                      std::abs(squares[i].middle.y - squares[j].middle.y));
        EXPECT_GE(apart, squares[i].side_m - 1e-12);
      }
  }
}

TEST(Ruling, OrderIsDownTheRightColumnFirst) {
  const auto six = ruled_squares(6);
  EXPECT_GT(six[0].middle.x, 0);
  EXPECT_GT(six[0].middle.y, six[1].middle.y);
  EXPECT_GT(six[1].middle.y, six[2].middle.y);
  EXPECT_EQ(six[2].middle.x, six[0].middle.x);
  EXPECT_LT(six[3].middle.x, 0);
  EXPECT_EQ(six[3].middle.y, six[0].middle.y);
  EXPECT_NEAR(six[1].middle.y, 0, 1e-12);
  EXPECT_NEAR(six[0].middle.x + six[3].middle.x, 0, 1e-12);
  const auto two = ruled_squares(2);
  EXPECT_NEAR(two[0].middle.x, 0, 1e-12);
  EXPECT_NEAR(two[0].middle.y, two[0].side_m / 2, 1e-12);
  EXPECT_NEAR(two[1].middle.y, -two[0].side_m / 2, 1e-12);
}

TEST(Ruling, WithoutRulingAModelIsAsLargeAsOneCharacter) {
  const auto one = ruled_squares(1);
  EXPECT_EQ(only_square().side_m, one[0].side_m);
  EXPECT_NEAR(one[0].middle.x, 0, 1e-12);
  EXPECT_NEAR(one[0].middle.y, 0, 1e-12);
  EXPECT_EQ(only_square().middle.x, 0);
}

TEST(Ruling, SmallerCharactersGetThinnerBrushes) {
  EXPECT_EQ(size_for(0), BrushSize::medium);
  EXPECT_EQ(size_for(1), BrushSize::medium);
  EXPECT_EQ(size_for(2), BrushSize::small);
  EXPECT_EQ(size_for(4), BrushSize::small);
  EXPECT_EQ(size_for(6), BrushSize::fine);
}

kanji::StrokeLine level(kanji::StrokeEnding ending) {
  return {{{9, 54.5}, {54, 54.5}, {54, 54.5}, {99, 54.5}}, ending, {}};
}

/// Half the width at a share of the stroke's points.
double width_at(const ModelStroke& stroke, double share) {
  return stroke
      .half_width_m[static_cast<std::size_t>(share * static_cast<double>(stroke.half_width_m.size() - 1))];
}

TEST(ModelStrokes, StandInTheirSquareUpright) {
  const RuledSquare square{{0.02, -0.01}, 0.05};
  const kanji::StrokeLine corner{{{0, 0}, {109, 109}}, kanji::StrokeEnding::stop, {}};
  const auto strokes = model_strokes(std::vector{corner}, square);
  ASSERT_EQ(strokes.size(), 1U);
  // The glyph's y goes down, that of paper up.
  EXPECT_NEAR(strokes[0].points.front().x, -0.005, 1e-12);
  EXPECT_NEAR(strokes[0].points.front().y, 0.015, 1e-12);
  EXPECT_NEAR(strokes[0].points.back().x, 0.045, 1e-12);
  EXPECT_NEAR(strokes[0].points.back().y, -0.035, 1e-12);
}

TEST(ModelStrokes, HaveAPointAtLeastEveryHalfMillimetreEachWithItsWidth) {
  const auto strokes = model_strokes(std::vector{level(kanji::StrokeEnding::stop)}, only_square());
  ASSERT_EQ(strokes[0].points.size(), strokes[0].half_width_m.size());
  EXPECT_GT(strokes[0].points.size(), 100U);
  for (std::size_t i = 1; i < strokes[0].points.size(); ++i) {
    const double apart = geometry::distance(strokes[0].points[i - 1], strokes[0].points[i]);
    EXPECT_LE(apart, 0.0005 + 1e-12);
    EXPECT_GT(apart, 0);
  }
}

TEST(ModelStrokes, EndAsTheCharacterAsks) {
  const auto of = [](kanji::StrokeEnding ending) {
    return model_strokes(std::vector{level(ending)}, only_square()).front();
  };
  const auto stop = of(kanji::StrokeEnding::stop), sweep = of(kanji::StrokeEnding::taper),
             hook = of(kanji::StrokeEnding::hook), either = of(kanji::StrokeEnding::either);
  const double body = width_at(stop, 0.5);
  EXPECT_NEAR(body, 0.030 * 0.085, 1e-6);
  // Pressed at the start of each.
  for (const auto* stroke : {&stop, &sweep, &hook}) EXPECT_NEAR(width_at(*stroke, 0) / body, 34.0 / 30, 0.01);
  EXPECT_NEAR(width_at(stop, 1) / body, 35.0 / 30, 0.01);
  EXPECT_NEAR(width_at(sweep, 1) / body, 0.1, 0.01);
  EXPECT_NEAR(width_at(hook, 1) / body, 0.1, 0.01);
  // A sweep thins out over more than half of its length, a hook only at its end.
  EXPECT_NEAR(width_at(sweep, 0.7) / body, 0.55, 0.02);
  EXPECT_NEAR(width_at(hook, 0.8) / body, 1, 1e-6);
  EXPECT_NEAR(width_at(hook, 0.93) / body, 0.55, 0.03);
  EXPECT_NEAR(width_at(stop, 0.93) / body, 1.083, 0.015);
  EXPECT_NEAR(width_at(sweep, 0.06) / body, 1.067, 0.015);
  EXPECT_EQ(either.half_width_m, stop.half_width_m);
}

TEST(ModelStrokes, ADotIsPressedAndAnEmptyLineLeftOut) {
  const kanji::StrokeLine dot{{{50, 50}}, kanji::StrokeEnding::stop, {}}, none{};
  const auto strokes = model_strokes(std::vector{none, dot}, only_square());
  ASSERT_EQ(strokes.size(), 1U);
  ASSERT_EQ(strokes[0].points.size(), 1U);
  EXPECT_NEAR(strokes[0].half_width_m[0], 0.034 * 0.085, 1e-9);
}

TEST(ModelStrokes, WithOwnWidthsHaveThoseOfTheirPointsAndBetweenThemEvenOnes) {
  const RuledSquare square{{0.02, -0.01}, 0.05};
  const carving::Groove sweep{{{0, 0}, 4, 1}, {{0, 0}, 9, 1}, {{54.5, 0}, 2, 1}, {{109, 0}, 0, 1}};
  const auto strokes = model_strokes(std::vector{sweep, carving::Groove{}}, square);
  ASSERT_EQ(strokes.size(), 1U);
  const ModelStroke& stroke = strokes[0];
  ASSERT_EQ(stroke.points.size(), stroke.half_width_m.size());
  EXPECT_NEAR(stroke.points.front().x, -0.005, 1e-12);
  EXPECT_NEAR(stroke.points.front().y, 0.015, 1e-12);
  EXPECT_NEAR(stroke.points.back().x, 0.045, 1e-12);
  const double unit_m = 0.05 / 109;
  for (std::size_t i = 1; i < stroke.points.size(); ++i) {
    EXPECT_LE(geometry::distance(stroke.points[i - 1], stroke.points[i]), 0.0005 + 1e-12);
    const double share = (stroke.points[i].x + 0.005) / 0.05;
    const double units = share < 0.5 ? 9 + (2 - 9) * share / 0.5 : 2 - 2 * (share - 0.5) / 0.5;
    EXPECT_NEAR(stroke.half_width_m[i], units * unit_m, 1e-9) << i;
  }
}

std::u32string on_sheet(std::u32string_view text, int squares, int sheet) {
  const auto models = models_on_sheet(text, squares, sheet);
  return {models.begin(), models.end()};
}

TEST(ModelText, AShortTextIsRepeated) {
  EXPECT_EQ(on_sheet(U"永", 4, 0), U"永永永永");
  EXPECT_EQ(on_sheet(U"学校", 4, 0), U"学校学校");
  EXPECT_EQ(on_sheet(U"学校", 1, 0), U"学");
}

TEST(ModelText, ALongTextGoesOnWithTheNextSheetAndBeginsAgain) {
  EXPECT_EQ(sheets_of(U"一期一会心", 2), 3);
  EXPECT_EQ(on_sheet(U"一期一会心", 2, 0), U"一期");
  EXPECT_EQ(on_sheet(U"一期一会心", 2, 1), U"一会");
  EXPECT_EQ(on_sheet(U"一期一会心", 2, 2), U"心心");
  EXPECT_EQ(on_sheet(U"一期一会心", 2, 3), U"一期");
  EXPECT_EQ(on_sheet(U"一期一会心", 2, -1), U"心心");
}

TEST(ModelText, SpacesAreNotWritten) {
  EXPECT_EQ(on_sheet(U" 一 期\u3000一会\t\n", 4, 0), U"一期一会");
  EXPECT_EQ(sheets_of(U" 一 期\u3000一会\t\n", 4), 1);
  EXPECT_EQ(on_sheet(U"   ", 4, 0), U"");
  EXPECT_EQ(on_sheet(U"", 1, 0), U"");
  EXPECT_EQ(on_sheet(U"永", 0, 0), U"");
  EXPECT_EQ(sheets_of(U"", 4), 1);
  EXPECT_EQ(sheets_of(U"永遠", 0), 2);
}

}  // namespace
}  // namespace nazori::calligraphy
