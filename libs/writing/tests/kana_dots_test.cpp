// SPDX-License-Identifier: Apache-2.0
// The dots of kana, which careful hands write without the turn to the next stroke.
#include "kana_dots.h"

#include <gtest/gtest.h>

#include <array>

#include "drawing.h"
#include "judgement.h"
#include "model_inside.h"

namespace nazori::writing::test {
namespace {

Shape shape_of(std::vector<double> xs, std::vector<double> ys) { return make_shape(xs, ys); }

/// う of KanjiVG 20220427 (Ulrich Apel, CC BY-SA 3.0), its first stroke as a dot with a turn.
kanji::Character u() {
  return character(U'う',
                   {"|M41,14C45,17 55,19 59,19C63,19 62,21 54,25",
                    "|M34.5,45.5C40,45 52,36.75 59.25,36.75C70,36.75 73.5,45 73.5,54C73.5,72 61,88 46,97"});
}

TEST(KanaDots, WithATurnMayBeWrittenWithoutIt) {
  auto dot = shape_of({40, 60, 52}, {15, 20, 26});
  ASSERT_TRUE(dot.body);
  dot.touch = 21;
  dot.freedom = 1.3F;
  const auto ways = other_ways(U'う', 0, dot);
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_EQ(ways[0].whole.length, dot.body->length);
  EXPECT_NEAR(ways[0].whole.x.back(), 60, 1.5);
  EXPECT_FALSE(ways[0].body);
  EXPECT_EQ(ways[0].touch, 21);
  EXPECT_EQ(ways[0].freedom, 1.3F);
}

TEST(KanaDots, WithoutATurnAndLongStrokesHaveNoOtherWay) {
  EXPECT_TRUE(other_ways(U'う', 0, shape_of({40, 60}, {15, 20})).empty());
  const auto bend = shape_of({20, 70, 62}, {15, 20, 30});
  ASSERT_TRUE(bend.body);
  EXPECT_TRUE(other_ways(U'う', 1, bend).empty());
}

TEST(KanaDots, TheLeftOneOfFuIsWrittenInThreeWays) {
  const auto plain = shape_of({16, 24, 35}, {73, 82, 74});
  for (const char32_t fu : {U'ふ', U'ぶ', U'ぷ'}) {
    const auto ways = other_ways(fu, 2, plain);
    ASSERT_EQ(ways.size(), 2U);
    for (const auto& way : ways) {
      EXPECT_LT(way.whole.x[12], way.whole.x.front()) << "it falls to the left";
      EXPECT_GT(way.whole.y[12], way.whole.y.front());
    }
    EXPECT_GT(ways[0].whole.x.back(), ways[0].whole.x[16]) << "a flick to the right";
    EXPECT_LT(ways[1].whole.x.back(), ways[1].whole.x[16]) << "none";
    EXPECT_TRUE(other_ways(fu, 1, plain).empty());
  }
  EXPECT_TRUE(other_ways(U'は', 2, plain).empty());
}

TEST(KanaDots, OnlyKanaHaveOtherWays) {
  const auto untyped = model_of(u());
  EXPECT_EQ(untyped.inside().main.other_ways.at(0).size(), 1U);
  EXPECT_TRUE(untyped.inside().main.other_ways.at(1).empty());
  auto typed = u();
  for (auto& stroke : typed.strokes) stroke.type = "㇔";
  const auto of_types = model_of(typed);
  for (const auto& ways : of_types.inside().main.other_ways) EXPECT_TRUE(ways.empty());
}

TEST(KanaDots, OfUIsAcceptedWithAndWithoutItsTurnButNotUpright) {
  const auto model = model_of(u());
  const auto with_dot = [&model](const geometry::Polyline<WritingFrame>& line) {
    auto ink = trace(u());
    ink.strokes[0] = along(line);
    return graded(ink, model);
  };
  EXPECT_TRUE(graded(trace(u()), model).accepted);
  const auto plain = with_dot({{42, 13}, {54, 17}, {66, 21}});
  EXPECT_TRUE(plain.accepted);
  EXPECT_GT(plain.probability, 0.8);
  EXPECT_FALSE(with_dot({{52, 8}, {51, 20}, {50, 32}}).accepted);
  EXPECT_FALSE(with_dot({{64, 14}, {53, 19}, {42, 24}}).accepted) << "the other way";
}

TEST(JudgedStroke, TakesTheBestOfItsWays) {
  const auto hooked = shape_of({40, 60, 52}, {15, 20, 26});
  const auto plain = shape_of({40, 60}, {15, 20});
  const auto upright = shape_of({50, 50}, {10, 30});
  constexpr float kFar = 1e9F;
  const auto d = compare(plain, hooked, kFar);
  const Placement here{d.offset_x, d.offset_y, d.length_log};
  const double alone = judge_stroke(plain, hooked, {}, d, here).judgement.deviation;
  EXPECT_GT(alone, 0.1);
  EXPECT_NEAR(judge_stroke(plain, hooked, std::array{plain}, d, here).judgement.deviation, 0, 1e-4);
  EXPECT_NEAR(judge_stroke(plain, hooked, std::array{upright, plain}, d, here).judgement.deviation, 0, 1e-4);
  EXPECT_NEAR(judge_stroke(plain, hooked, std::array{plain, upright}, d, here).judgement.deviation, 0, 1e-4);
  EXPECT_EQ(judge_stroke(plain, hooked, std::array{upright}, d, here).judgement.deviation, alone);
}

TEST(JudgedStroke, IsComparedWithAnotherWayAsIfThatWereTheModel) {
  auto hooked = shape_of({40, 60, 52}, {15, 20, 26});
  hooked.body.reset();  // as of a stroke that the source does not call a hook
  const auto plain = shape_of({40, 60}, {15, 20});
  const auto short_one = shape_of({45, 56}, {17, 20});
  constexpr float kFar = 1e9F;
  const auto of_model = compare(short_one, hooked, kFar);
  const auto of_way = compare(short_one, plain, kFar);
  ASSERT_LT(of_model.length_log, of_way.length_log - 0.3F);
  const auto beside = [](const StrokeDifference& d) {
    return Placement{d.offset_x, d.offset_y, d.length_log};
  };
  EXPECT_NEAR(
      judge_stroke(short_one, hooked, std::array{plain}, of_model, beside(of_model)).judgement.deviation,
      judge_stroke(short_one, plain, {}, of_way, beside(of_way)).judgement.deviation, 1e-5);
}

TEST(JudgedStroke, AWayInTheOtherDirectionIsNotTaken) {
  const auto hooked = shape_of({40, 60, 52}, {15, 20, 26});
  const auto plain = shape_of({40, 60}, {15, 20});
  constexpr float kFar = 1e9F;
  auto d = compare(plain, hooked, kFar);
  d.reversed = true;
  const double alone = judge_stroke(plain, hooked, {}, d, {}).judgement.deviation;
  EXPECT_GT(alone, 1);
  EXPECT_EQ(judge_stroke(plain, hooked, std::array{plain}, d, {}).judgement.deviation, alone);
}

TEST(JudgedStroke, TheUseOfAFreeSlantCostsAThirdOfTheLimit) {
  auto dot = shape_of({40, 54}, {10, 24});
  const auto upright = shape_of({47, 47}, {8, 26});
  constexpr float kFar = 1e9F;
  const auto d = compare(upright, dot, kFar);
  const auto strange = judge_stroke(upright, dot, {}, d, {});
  EXPECT_EQ(strange.used_freedom, 0);
  dot.free_slant = true;
  const auto free = judge_stroke(upright, dot, {}, d, {});
  EXPECT_EQ(free.used_freedom, 0.35);
  EXPECT_LT(free.judgement.deviation, 0.25);
  EXPECT_GT(strange.judgement.deviation, 0.5 + free.judgement.deviation);
  const auto own = judge_stroke(dot, dot, {}, compare(dot, dot, kFar), {});
  EXPECT_EQ(own.used_freedom, 0) << "a freedom that is not used costs nothing";
  EXPECT_NEAR(own.judgement.deviation, 0, 1e-4);
}

}  // namespace
}  // namespace nazori::writing::test
