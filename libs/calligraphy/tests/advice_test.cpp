// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/advice.h"

#include <gtest/gtest.h>

#include <numbers>

#include "writing_under_test.h"

namespace nazori::calligraphy::test {
namespace {

using Names = std::vector<std::string>;
constexpr double kDegree = std::numbers::pi / 180;

class Writings : public ::testing::Test {
 protected:
  SheetModel rest_{rest(), only_square()};
  SheetModel three_{three(), only_square()};
  SheetModel hook_{hook(), only_square()};
};

TEST_F(Writings, AModelWrittenExactlyGetsNoAdviceAndIsGood) {
  for (const SheetModel* model : {&rest_, &three_, &hook_}) {
    const auto result = advice_for(exactly(*model), *model);
    EXPECT_EQ(names(result), Names{});
    EXPECT_TRUE(result.is_comparable);
    EXPECT_TRUE(result.is_good);
    EXPECT_EQ(result.good.size(), model->character.strokes.size());
    EXPECT_GT(result.covered, 0.97);
    EXPECT_LT(result.outside, 0.01);
    ASSERT_EQ(result.marks.size(), 1U);
    EXPECT_EQ(result.marks[0].kind, CorrectionMark::Kind::circle);
  }
}

TEST_F(Writings, WhatWasWrittenIsHandedBackInGlyphUnits) {
  auto strokes = exactly(three_);
  for (auto& point : strokes.front()) point.pressure = 0.25;
  const double later_s = 100;
  for (auto& stroke : strokes)
    for (auto& point : stroke) point.time_s += later_s;
  const auto ink = advice_for(strokes, three_).ink;
  ASSERT_EQ(ink.size(), 3U);
  for (std::size_t i = 0; i < ink.size(); ++i) {
    // The square of the sheet is the box of the character.
    const auto& line = three_.character.strokes[i].line.points;
    EXPECT_NEAR(ink[i].front().at.x, line.front().x, 0.01);
    EXPECT_NEAR(ink[i].front().at.y, line.front().y, 0.01);
    EXPECT_NEAR(ink[i].back().at.x, line.back().x, 0.01);
    EXPECT_NEAR(ink[i].back().at.y, line.back().y, 0.01);
    EXPECT_NEAR(*ink[i].back().time_s, strokes[i].back().time_s - later_s - (strokes[0][0].time_s - later_s),
                1e-9);
  }
  EXPECT_EQ(ink[0].front().time_s, 0);
  EXPECT_EQ(ink[0].front().pressure, 0.25);
  EXPECT_FALSE(ink[1].front().pressure);
}

TEST_F(Writings, FiveMillimetresToTheSideAreNoticedBySide) {
  const auto shifted = [this](PaperPoint by) {
    auto strokes = exactly(rest_);
    for (auto& stroke : strokes) move(stroke, by);
    return advice_for(strokes, rest_);
  };
  const auto left = shifted({-0.005, 0});
  EXPECT_TRUE(has(left, "too_far_left"));
  EXPECT_NEAR(left.advice.back().amount, 0.005 / rest_.square.side_m, 0.001);
  EXPECT_TRUE(has(shifted({0.005, 0}), "too_far_right"));
  EXPECT_TRUE(has(shifted({0, 0.005}), "too_high"));
  const auto low = shifted({0, -0.005});
  EXPECT_TRUE(has(low, "too_low"));
  EXPECT_FALSE(has(low, "too_far_left"));
  EXPECT_FALSE(has(shifted({0.002, 0.002}), "too_far_right"));
  // The arrow leads back.
  const auto arrow = std::find_if(left.marks.begin(), left.marks.end(), [](const CorrectionMark& mark) {
    return mark.kind == CorrectionMark::Kind::arrow;
  });
  ASSERT_NE(arrow, left.marks.end());
  EXPECT_NEAR(arrow->to.x - arrow->from.x, 0.005, 0.0002);
}

TEST_F(Writings, ShiftedInkCoversLessUnlessTheModelLiesBeside) {
  auto strokes = exactly(rest_);
  for (auto& stroke : strokes) move(stroke, {0.005, 0.005});
  const auto traced = advice_for(strokes, rest_);
  EXPECT_TRUE(has(traced, "uncovered"));
  EXPECT_TRUE(has(traced, "outside"));
  const auto beside = advice_for(strokes, rest_, {.traced = false});
  EXPECT_FALSE(has(beside, "uncovered"));
  EXPECT_FALSE(has(beside, "outside"));
  EXPECT_GT(beside.covered, 0.9);
  EXPECT_TRUE(has(beside, "too_far_right"));
}

TEST_F(Writings, OnePressureEverywhereIsNoticedWhereTheModelChanges) {
  const auto flat = [](const SheetModel& model) {
    auto strokes = exactly(model);
    for (auto& stroke : strokes)
      for (auto& point : stroke) point.half_width_m = 0.030 * model.square.side_m;
    return advice_for(strokes, model);
  };
  const auto result = flat(rest_);
  EXPECT_TRUE(has(result, "flat_width"));
  EXPECT_TRUE(has(result, "no_sweep@0"));
  EXPECT_TRUE(has(result, "no_sweep@5"));
  EXPECT_FALSE(has(result, "no_sweep@2"));
  // Bars without a sweep are nearly as broad everywhere.
  EXPECT_EQ(names(flat(three_)), Names{});
}

TEST_F(Writings, AStartTurnedByFortyDegreesIsNoticedButForTheEntryOfKaisho) {
  const auto turned = [this](double degrees) {
    auto strokes = exactly(three_);
    turn_start(strokes[1], degrees * kDegree, 0.005);
    return advice_for(strokes, three_);
  };
  const auto upwards = turned(40);
  EXPECT_EQ(names(upwards), Names{"start_turned@1"});
  EXPECT_NEAR(upwards.advice[0].amount, 40 * kDegree, 8 * kDegree);
  EXPECT_EQ(names(turned(-40)), Names{});  // to the lower right, as a brush is set down in kaisho
  EXPECT_TRUE(has(turned(-85), "start_turned@1"));
  EXPECT_EQ(names(turned(12)), Names{});
  const auto arrow = std::find_if(upwards.marks.begin(), upwards.marks.end(),
                                  [](const CorrectionMark& mark) { return mark.stroke == 1; });
  ASSERT_NE(arrow, upwards.marks.end());
  EXPECT_EQ(arrow->kind, CorrectionMark::Kind::arrow);
  EXPECT_NEAR(std::atan2(arrow->to.y - arrow->from.y, arrow->to.x - arrow->from.x), 0, 20 * kDegree);
}

TEST_F(Writings, AHiraganaStartsAsItGoesOn) {
  SheetModel model = three_;
  model.character.code_point = U'こ';
  auto strokes = exactly(model);
  turn_start(strokes[1], -40 * kDegree, 0.005);
  EXPECT_TRUE(has(advice_for(strokes, model), "start_turned@1"));
}

TEST_F(Writings, ATipThatFirstMovesBackIsHidden) {
  auto strokes = exactly(three_);
  BrushPoint back = strokes[0].front();
  back.time_s -= 0.1;
  BrushStroke begins;
  for (int i = 0; i < 5; ++i) {
    BrushPoint point = back;
    point.pen.x += 0.0004 * (4 - i);  // begins 2 mm within the stroke
    point.at = point.pen;
    begins.push_back(point);
  }
  for (int i = 0; i < 4; ++i) begins[static_cast<std::size_t>(i)].time_s -= 0.02 * (5 - i);
  strokes[0].insert(strokes[0].begin(), begins.begin(), begins.end());
  EXPECT_EQ(names(advice_for(strokes, three_)), Names{"hidden_tip@0"});
}

TEST_F(Writings, ABarThatThinsOutHasNoStop) {
  auto strokes = exactly(three_);
  auto& bar = strokes[2];
  for (std::size_t i = 0; i < bar.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(bar.size());
    if (share > 0.7) bar[i].half_width_m *= (1 - share) / 0.3;
  }
  const auto result = advice_for(strokes, three_);
  EXPECT_TRUE(has(result, "no_stop@2"));
  EXPECT_FALSE(has(result, "no_stop@1"));
  EXPECT_TRUE(std::any_of(result.marks.begin(), result.marks.end(), [](const CorrectionMark& mark) {
    return mark.kind == CorrectionMark::Kind::outline && mark.stroke == 2 && !mark.outline.empty();
  }));
  EXPECT_EQ(std::count(result.good.begin(), result.good.end(), 2), 0);
}

TEST_F(Writings, ASweepThatEndsAsBroadAsSevenTenthsOfItsBodyIsBlunt) {
  // The body reaches to seven tenths of the length; what swells behind it does not count.
  const auto ends_with = [&](double end) {
    auto strokes = exactly(rest_);
    auto& sweep = strokes[0];
    for (std::size_t i = 0; i < sweep.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(sweep.size() - 1);
      sweep[i].half_width_m = 0.03 * rest_.square.side_m * (share < 0.75 ? 1 : share < 0.9 ? 1.5 : end);
    }
    return has(advice_for(strokes, rest_), "no_sweep@0");
  };
  EXPECT_FALSE(ends_with(0.64));
  EXPECT_TRUE(ends_with(0.75));
}

TEST_F(Writings, ABarThatIsLiftedWhileItMovesHasNoStop) {
  auto strokes = exactly(three_);
  auto& bar = strokes[2];
  for (std::size_t i = bar.size() * 9 / 10; i < bar.size(); ++i) bar[i].half_width_m *= 0.7;
  EXPECT_EQ(names(advice_for(strokes, three_)), Names{});  // a little thin, but not in haste
  pace(bar, [](double share) { return share > 0.85 ? 0.11 : 0.06; });
  EXPECT_EQ(names(advice_for(strokes, three_)), Names{"no_stop@2"});
}

TEST_F(Writings, AHookThatIsMissingOrBluntIsNoticed) {
  auto strokes = exactly(hook_);
  auto& stroke = strokes[0];
  auto without = stroke;
  while (without.back().pen.x < without.front().pen.x - 1e-6) without.pop_back();
  EXPECT_TRUE(has(advice_for({without}, hook_), "no_hook@0"));
  for (auto& point : stroke) point.half_width_m = 0.03 * hook_.square.side_m;
  EXPECT_TRUE(has(advice_for(strokes, hook_), "no_hook@0"));
}

TEST_F(Writings, ThinAndThickStrokesAreToldApart) {
  auto strokes = exactly(three_);
  for (auto& point : strokes[0]) point.half_width_m *= 0.4;
  for (auto& point : strokes[2]) point.half_width_m *= 1.9;
  const auto result = advice_for(strokes, three_);
  EXPECT_TRUE(has(result, "thin@0"));
  EXPECT_TRUE(has(result, "thick@2"));
  EXPECT_FALSE(has(result, "thin@1") || has(result, "thick@1"));
  EXPECT_NEAR(result.advice[0].amount, 0.4, 0.02);
}

TEST_F(Writings, AHastyMiddleAndARestAreNoticedWithTheirPlace) {
  auto strokes = exactly(three_);
  pace(strokes[2], [](double share) { return share > 0.4 && share < 0.62 ? 0.3 : 0.06; });
  auto result = advice_for(strokes, three_);
  EXPECT_EQ(names(result), Names{"hasty@2"});
  EXPECT_EQ(result.advice[0].part, StrokePart::middle);
  EXPECT_GT(result.advice[0].amount, 3);

  pace(strokes[2], [](double share) { return share > 0.68 && share < 0.8 ? 0.01 : 0.06; });
  result = advice_for(strokes, three_);
  EXPECT_EQ(names(result), Names{"halting@2"});
  EXPECT_EQ(result.advice[0].part, StrokePart::end);

  pace(strokes[2], [](double share) { return share < 0.32 ? 0.3 : 0.06; });
  result = advice_for(strokes, three_);
  EXPECT_EQ(names(result), Names{"hasty@2"});
  EXPECT_EQ(result.advice[0].part, StrokePart::beginning);

  // A hand that speeds up and slows down, as hands do.
  pace(strokes[2], [](double share) { return 0.02 + 0.16 * share * (1 - share); });
  EXPECT_EQ(names(advice_for(strokes, three_)), Names{});
}

TEST_F(Writings, AHandMaySlowDownAtACorner) {
  auto strokes = exactly(hook_);
  pace(strokes[0], [](double share) { return share > 0.75 && share < 0.83 ? 0.01 : 0.06; });
  EXPECT_EQ(names(advice_for(strokes, hook_)), Names{});
}

TEST_F(Writings, GapsBetweenBarsAreComparedWithTheModel) {
  auto strokes = exactly(three_);
  move(strokes[1], {0, 0.012});
  const auto result = advice_for(strokes, three_);
  EXPECT_TRUE(has(result, "narrow_gap@0-1"));
  EXPECT_TRUE(has(result, "wide_gap@1-2"));
  EXPECT_FALSE(has(result, "wide_gap@0-2") || has(result, "narrow_gap@0-2"));
  const auto arrow = std::find_if(result.marks.begin(), result.marks.end(), [](const CorrectionMark& mark) {
    return mark.kind == CorrectionMark::Kind::arrow && mark.stroke == 1;
  });
  ASSERT_NE(arrow, result.marks.end());
  EXPECT_NEAR(arrow->to.y - arrow->from.y, -0.012, 0.002);
}

TEST_F(Writings, ACharacterThatIsLargeAsAWholeHasRightGaps) {
  for (const double scale : {0.7, 1.15 * 1.1}) {
    auto strokes = exactly(three_);
    for (auto& stroke : strokes)
      for (auto& point : stroke) {
        point.pen = point.at = point.pen * scale;
        point.half_width_m *= scale;
      }
    const auto result = advice_for(strokes, three_);
    EXPECT_TRUE(has(result, scale < 1 ? "too_small" : "too_large"));
    for (const auto& name : names(result)) EXPECT_EQ(name.find("gap"), std::string::npos) << name;
  }
}

TEST_F(Writings, AMissingStrokeIsAMistakeAndIsOutlined) {
  auto strokes = exactly(rest_);
  strokes.erase(strokes.begin() + 3);
  const auto result = advice_for(strokes, rest_);
  ASSERT_TRUE(result.grade);
  ASSERT_EQ(result.grade->mistakes.size(), 1U);
  EXPECT_EQ(result.grade->mistakes[0].kind, kanji::MistakeKind::missing);
  EXPECT_FALSE(result.is_good);
  EXPECT_TRUE(std::any_of(result.marks.begin(), result.marks.end(),
                          [](const CorrectionMark& mark) { return mark.stroke == 3; }));
}

TEST_F(Writings, AStrokeThatRunsBackwardsIsAMistakeAndNotJudgedFurther) {
  auto strokes = exactly(three_);
  std::reverse(strokes[1].begin(), strokes[1].end());
  strokes[1].front().time_s = 0;
  pace(strokes[1], [](double) { return 0.06; });
  const auto result = advice_for(strokes, three_);
  ASSERT_EQ(result.grade->mistakes.size(), 1U);
  for (const Advice& one : result.advice) EXPECT_NE(one.stroke, 1);
}

TEST_F(Writings, StrokesInAnyOrderAreComparedWithTheirOwnModel) {
  auto strokes = exactly(three_);
  for (auto& point : strokes[2]) point.half_width_m *= 0.4;
  std::swap(strokes[0], strokes[2]);
  EXPECT_TRUE(has(advice_for(strokes, three_), "thin@2"));
}

TEST_F(Writings, ScribblesCannotBeCompared) {
  auto strokes = exactly(three_);
  strokes.resize(1);
  auto result = advice_for(strokes, rest_);
  EXPECT_FALSE(result.is_comparable);
  EXPECT_TRUE(result.advice.empty());
  BrushStroke dot(3);
  result = advice_for({dot}, rest_);
  EXPECT_FALSE(result.is_comparable);
  EXPECT_EQ(result.written, 1);
  EXPECT_FALSE(advice_for({}, rest_).grade);
}

TEST_F(Writings, EachSquareIsComparedWithItsOwnModel) {
  const auto squares = ruled_squares(2);
  const SheetModel first{rest(), squares[0]}, second{three(), squares[1]};
  auto strokes = exactly(second);
  for (auto& point : strokes[0]) point.half_width_m *= 0.4;
  for (auto& stroke : exactly(first)) strokes.push_back(stroke);
  std::vector<ModelStroke> shapes;
  for (const auto& stroke : strokes) shapes.push_back(shape_of(stroke));
  const auto all = advise(strokes, ink_of(shapes, 256), std::vector{first, second});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(names(all[0]), Names{});
  EXPECT_EQ(all[0].written, 6);
  EXPECT_TRUE(has(all[1], "thin@0"));
  EXPECT_FALSE(has(all[1], "thin@1") || has(all[1], "too_small"));
}

TEST(Advice, AMouseIsNotToldAboutWidthsThatItCannotChoose) {
  const SheetModel model{rest(), only_square()};
  const auto with_width = [&](WidthFrom from, const std::function<double(double)>& half_width_m) {
    auto strokes = exactly(model);
    for (auto& stroke : strokes)
      for (auto& point : stroke) {
        point.half_width_m = half_width_m(point.half_width_m);
        point.width_from = from;
      }
    return advice_for(strokes, model);
  };
  const auto thin = [](double half) { return 0.3 * half; };
  const auto thick = [](double half) { return 2 * half; };
  const auto even_width = [](double) { return 0.0008; };
  EXPECT_TRUE(has(with_width(WidthFrom::hand, thin), "thin@1"));
  EXPECT_TRUE(has(with_width(WidthFrom::hand, thin), "uncovered"));
  EXPECT_TRUE(has(with_width(WidthFrom::hand, thick), "thick@1"));
  EXPECT_TRUE(has(with_width(WidthFrom::hand, even_width), "flat_width"));
  EXPECT_TRUE(has(with_width(WidthFrom::hand, even_width), "no_sweep@0"));
  for (const WidthFrom from : {WidthFrom::speed, WidthFrom::nothing}) {
    const auto result = with_width(from, thin);
    EXPECT_EQ(names(result), std::vector<std::string>{});
    EXPECT_EQ(result.good.size(), 6U) << "the lines are those of the model";
    EXPECT_LT(result.covered, 0.7) << "measured as before";
    EXPECT_FALSE(has(with_width(from, thick), "thick@1"));
    EXPECT_FALSE(has(with_width(from, even_width), "flat_width"));
  }
  EXPECT_TRUE(has(with_width(WidthFrom::speed, even_width), "no_sweep@0")) << "it could have been faster";
  EXPECT_FALSE(has(with_width(WidthFrom::nothing, even_width), "no_sweep@0"));
}

TEST(Advice, AHookWithoutPressureIsJudgedByItsDirectionOnly) {
  const SheetModel model{hook(), only_square()};
  auto strokes = exactly(model);
  for (auto& point : strokes[0]) {
    point.half_width_m = 0.0008;
    point.width_from = WidthFrom::nothing;
  }
  EXPECT_FALSE(has(advice_for(strokes, model), "no_hook@0"));
  for (auto& point : strokes[0]) point.width_from = WidthFrom::speed;
  EXPECT_TRUE(has(advice_for(strokes, model), "no_hook@0"));
  auto straight = exactly(model);
  straight[0].resize(straight[0].size() / 2);
  for (auto& point : straight[0]) point.width_from = WidthFrom::nothing;
  EXPECT_TRUE(has(advice_for(straight, model), "no_hook@0")) << "there is none";
}

TEST(Advice, AStrokeWithPressureAmongThoseOfAMouseIsStillJudged) {
  const SheetModel model{three(), only_square()};
  auto strokes = exactly(model);
  for (auto& stroke : strokes)
    for (auto& point : stroke) {
      point.half_width_m *= 0.3;
      point.width_from = &stroke == &strokes[1] ? WidthFrom::hand : WidthFrom::speed;
    }
  const auto result = advice_for(strokes, model);
  EXPECT_TRUE(has(result, "thin@1"));
  EXPECT_FALSE(has(result, "thin@0"));
  EXPECT_FALSE(has(result, "thin@2"));
}

/// 三 as another hand writes it: bars in other places, of other lengths and broader.
SheetModel three_by_hand() {
  SheetModel model{three(), only_square()};
  const auto bar = [](double from, double to, double y, double half) {
    return carving::Groove{{{from, y + 2}, half, 1}, {{to, y}, half, 1}};
  };
  model.strokes = {bar(20, 90, 30, 5), bar(32, 78, 52, 4), bar(6, 103, 80, 6)};
  return model;
}

TEST(AdviceOnAnotherHand, ComparesWithItsLinesAndWidths) {
  const SheetModel hand = three_by_hand(), printed{three(), only_square()};
  const auto written = advice_for(exactly(hand), hand);
  EXPECT_EQ(names(written), Names{});
  EXPECT_TRUE(written.is_good);
  EXPECT_GT(written.covered, 0.97);
  EXPECT_LT(written.outside, 0.01);
  // What is right for one is not for the other.
  EXPECT_TRUE(has(advice_for(exactly(hand), printed), "outside"));
  EXPECT_TRUE(has(advice_for(exactly(printed), hand), "uncovered"));
  auto thin = exactly(hand);
  for (auto& point : thin[2]) point.half_width_m *= 0.45;
  EXPECT_TRUE(has(advice_for(thin, hand), "thin@2"));
  EXPECT_FALSE(has(advice_for(thin, printed), "thin@2"));
}

TEST(AdviceOnAnotherHand, GradesTheFormOfItsLines) {
  // A bar that the other hand writes steeply is wrong in print, and the other way round.
  SheetModel hand{three(), only_square()};
  const auto line = [](geometry::GlyphPoint from, geometry::GlyphPoint to) {
    return carving::Groove{{from, 3.2, 1}, {to, 3.2, 1}};
  };
  hand.strokes = {line({27, 24}, {84, 24}), line({40, 75}, {68, 40}), line({13, 88}, {96, 84})};
  const auto own = advice_for(exactly(hand), hand);
  ASSERT_TRUE(own.grade);
  EXPECT_TRUE(own.grade->mistakes.empty());
  const auto other = advice_for(exactly(hand), {three(), only_square()});
  ASSERT_TRUE(other.grade);
  EXPECT_FALSE(other.grade->mistakes.empty());
}

TEST(AdviceOnAnotherHand, OutlinesItsStrokes) {
  const SheetModel hand = three_by_hand();
  auto strokes = exactly(hand);
  strokes.erase(strokes.begin() + 1);
  const auto result = advice_for(strokes, hand);
  const auto outline = std::find_if(result.marks.begin(), result.marks.end(),
                                    [](const CorrectionMark& mark) { return mark.stroke == 1; });
  ASSERT_NE(outline, result.marks.end());
  ASSERT_FALSE(outline->outline.empty());
  double left = 1, right = -1;
  for (const auto at : outline->outline.front()) {
    left = std::min(left, at.x);
    right = std::max(right, at.x);
  }
  const double side_m = hand.square.side_m;
  EXPECT_NEAR(left, ((32 - 4) / 109.0 - 0.5) * side_m, 0.0003);
  EXPECT_NEAR(right, ((78 + 4) / 109.0 - 0.5) * side_m, 0.0003);
}

}  // namespace
}  // namespace nazori::calligraphy::test
