// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/grade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing.h"
#include "nazori/geometry/polyline.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Grade, TheModelItselfIsAcceptedWithFullScore) {
  const auto g = graded(trace(rest()), model_of(rest()));
  EXPECT_TRUE(g.accepted);
  EXPECT_EQ(g.score, 100);
  ASSERT_EQ(g.strokes.size(), 6U);
  for (int k = 0; k < 6; ++k) {
    EXPECT_TRUE(g.strokes[static_cast<std::size_t>(k)].ok);
    EXPECT_EQ(g.strokes[static_cast<std::size_t>(k)].matched, k);
    EXPECT_NEAR(g.strokes[static_cast<std::size_t>(k)].size, 1, 0.02);
    EXPECT_NEAR(g.strokes[static_cast<std::size_t>(k)].offset_x, 0, 0.005);
  }
}

TEST(Grade, TwoStrokesExchangedAreAnOrderMistakeOfThoseTwoOnly) {
  auto ink = trace(rest());
  std::swap(ink.strokes[2], ink.strokes[3]);
  const auto g = graded(ink, model_of(rest()));
  EXPECT_FALSE(g.accepted);
  EXPECT_THAT(mistake_names(g), ElementsAre("order@2"));
  EXPECT_EQ(g.mistakes[0].second, 3);
  EXPECT_THAT(g.mistakes[0].model, ElementsAre(3, 2));
  for (const std::size_t k : {0U, 1U, 4U, 5U}) EXPECT_TRUE(g.strokes[k].ok) << k;
  EXPECT_EQ(g.strokes[2].matched, 3);
  EXPECT_EQ(g.strokes[3].matched, 2);
}

TEST(Grade, AStrokeMovedToTheEndIsOneMistakeNotMany) {
  auto ink = trace(rest());
  std::rotate(ink.strokes.begin() + 1, ink.strokes.begin() + 2, ink.strokes.end());
  const auto g = graded(ink, model_of(rest()));
  EXPECT_EQ(g.mistakes.size(), 1U);
  EXPECT_EQ(g.mistakes[0].kind, kanji::MistakeKind::order);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(g.strokes[k].ok) << k;
  EXPECT_FALSE(g.strokes[5].ok);
}

TEST(Grade, ParallelBarsInTheWrongOrderAreSeen) {
  auto ink = trace(three());
  std::swap(ink.strokes[0], ink.strokes[1]);
  EXPECT_THAT(mistake_names(graded(ink, model_of(three()))), ElementsAre("order@0"));
  auto eyes = trace(eye());
  std::swap(eyes.strokes[2], eyes.strokes[3]);
  EXPECT_THAT(mistake_names(graded(eyes, model_of(eye()))), ElementsAre("order@2"));
}

TEST(Grade, AStrokeDrawnBackwardsSaysWhereItStarts) {
  auto ink = trace(rest());
  ink.strokes[3] = reversed(ink.strokes[3]);
  const auto g = graded(ink, model_of(rest()));
  EXPECT_THAT(mistake_names(g), ElementsAre("reversed@3"));
  EXPECT_TRUE(g.strokes[3].reversed);
  EXPECT_FALSE(g.strokes[3].ok);
  EXPECT_EQ(g.mistakes[0].start, Side::top);
}

TEST(Grade, AMissingStrokeDoesNotBlameThoseAfterIt) {
  for (std::size_t gone = 0; gone < 6; ++gone) {
    auto ink = trace(rest());
    ink.strokes.erase(ink.strokes.begin() + static_cast<std::ptrdiff_t>(gone));
    const auto g = graded(ink, model_of(rest()));
    EXPECT_THAT(mistake_names(g), ElementsAre("missing@" + std::to_string(gone)));
    for (const auto& s : g.strokes) EXPECT_TRUE(s.ok);
  }
}

TEST(Grade, AnExtraStrokeIsNamed) {
  auto ink = trace(rest());
  ink.strokes.insert(ink.strokes.begin() + 2, along({{70, 90}, {100, 95}}));
  const auto g = graded(ink, model_of(rest()));
  EXPECT_THAT(mistake_names(g), ElementsAre("extra@2"));
  EXPECT_EQ(g.strokes[2].matched, std::nullopt);
  EXPECT_TRUE(g.strokes[3].ok);
}

TEST(Grade, TwoStrokesWithoutLiftingThePenAreJoined) {
  auto ink = trace(rest());
  ink.strokes[4] = joined(ink.strokes[4], ink.strokes[5]);
  ink.strokes.pop_back();
  const auto g = graded(ink, model_of(rest()));
  EXPECT_THAT(mistake_names(g), ElementsAre("joined@4"));
  EXPECT_THAT(g.mistakes[0].model, ElementsAre(4, 5));
}

TEST(Grade, ALongStrokeDoesNotHideTheShortOneThatIsMissing) {
  // KanjiVG 20220427 (Ulrich Apel, CC BY-SA 3.0).
  const auto ne = character(
      U'ね', {"|M33.29,14.5c1.62,1.62,2.1,3.21,1.88,5.88c-1.03,11.93-2.06,31.66-2.53,53.12c-0.1,4.62-0.18,"
              "9.31-0.22,14",
              "|M17.16,37.88c1.62,0.88,3.25,1.38,5.62,0.75c2.14-0.56,7.8-2.31,12.37-4.03c6.26-2.35,6.88-1.47,"
              "3.12,3.63c-5.56,7.53-13.02,17.38-18.48,26.77c-5.6,9.62-3.45,8.3,2,3c19.12-18.62,38.5-39.12,"
              "54.12-39.12c11.38,0,12.88,11.25,12.88,32.5c0,28.62-30.18,24.88-30.18,16.26c0-9.63,18.73-7.82,"
              "28.06-1.88c2.75,1.75,5.88,4.88,7.5,6.75"});
  auto ink = trace(ne);
  ink.strokes.erase(ink.strokes.begin());
  EXPECT_THAT(mistake_names(graded(ink, model_of(ne))), ElementsAre("missing@0"));
  auto together = trace(ne);
  together.strokes = {joined(together.strokes[0], together.strokes[1])};
  EXPECT_THAT(mistake_names(graded(together, model_of(ne))), ElementsAre("joined@0"));
}

TEST(Grade, AStrokeThatCoversOneOfTwoIsNotBothOfThem) {
  // However uneven the hand: a missing stroke is missing, not joined to its neighbour.
  for (const auto& c : {rest(), soil(), eye()}) {
    const auto model = model_of(c);
    for (std::size_t gone = 0; gone < c.strokes.size(); ++gone)
      for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        auto ink = trace(c);
        ink.strokes.erase(ink.strokes.begin() + static_cast<std::ptrdiff_t>(gone));
        for (auto& s : ink.strokes) s = resampled(s, 4);
        for (const auto& mistake : graded(shaken(ink, 5, seed), model).mistakes)
          EXPECT_NE(mistake.kind, kanji::MistakeKind::joined) << "without " << gone << ", seed " << seed;
      }
  }
}

TEST(Grade, ALineWithItsCornersCutIsTwoStrokesWhileItIsAboutAsLongAsBoth) {
  // The upper two bars of three in one zigzag, which is drawn out to a straight line step by step.
  const auto model = model_of(three());
  const auto bars = trace(three());
  const auto zigzag = resampled(joined(bars.strokes[0], bars.strokes[1]), 40);
  const auto length = [](const WrittenStroke& s) {
    return geometry::arc_length<WritingFrame>(geometry::line_of(s));
  };
  int both = 0, one = 0;
  for (int step = 0; step <= 200; ++step) {
    const double cut = step / 200.0;
    WrittenStroke drawn = zigzag;
    const WritingPoint from = drawn.front().at, to = drawn.back().at;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      auto& p = drawn[i].at;
      const double way = static_cast<double>(i) / 39;
      p = {p.x + cut * (from.x + way * (to.x - from.x) - p.x),
           p.y + cut * (from.y + way * (to.y - from.y) - p.y)};
    }
    // The grader allows for 0.2. It lays the writing on its model first, which makes the line a little
    // longer.
    constexpr double kAllowed = 0.27, kTooNearToTell = 0.03;
    // How many times shorter than both, and how many times longer than the longer bar, as logarithms.
    const double shorter = std::log(length(zigzag) / length(drawn));
    const double longer =
        std::abs(std::log(length(drawn) / std::max(length(bars.strokes[0]), length(bars.strokes[1]))));
    if (std::abs(shorter - longer - kAllowed) < kTooNearToTell) continue;
    auto ink = bars;
    ink.strokes = {drawn, bars.strokes[2]};
    const auto mistakes = graded(ink, model).mistakes;
    const bool is_joined = std::any_of(mistakes.begin(), mistakes.end(),
                                       [](const Mistake& f) { return f.kind == kanji::MistakeKind::joined; });
    EXPECT_EQ(is_joined, shorter < longer + kAllowed) << cut << ": " << shorter << ", " << longer;
    ++(is_joined ? both : one);
  }
  EXPECT_GT(both, 80);
  EXPECT_GT(one, 40);
}

TEST(Grade, OneStrokeInTwoPiecesIsSplit) {
  auto ink = trace(rest());
  const auto whole = resampled(ink.strokes[2], 21);
  ink.strokes[2].assign(whole.begin(), whole.begin() + 11);
  ink.strokes.insert(ink.strokes.begin() + 3, WrittenStroke(whole.begin() + 11, whole.end()));
  EXPECT_THAT(mistake_names(graded(ink, model_of(rest()))), ElementsAre("split@2"));
}

TEST(Grade, AStrangeStrokeInThePlaceOfARightOneIsWrong) {
  auto ink = trace(rest());
  ink.strokes[2] = along({{60, 20}, {62, 50}, {58, 70}});
  EXPECT_THAT(mistake_names(graded(ink, model_of(rest()))), ElementsAre("wrong@2"));
}

TEST(Grade, PlaceAndSizeOfTheWholeDoNotCount) {
  const auto model = model_of(rest());
  for (const double size : {0.002, 0.3, 40.0}) {
    const auto g = graded(mapped(trace(rest()), size, 0, 0, size, -7 * size, 1000 * size), model);
    EXPECT_TRUE(g.accepted) << size;
    EXPECT_EQ(g.score, 100) << size;
  }
}

TEST(Grade, SlantAndAspectWithinReasonDoNotCount) {
  const auto model = model_of(rest());
  EXPECT_TRUE(graded(mapped(trace(rest()), 1, -0.25, 0, 1, 0, 0), model).accepted);
  EXPECT_TRUE(graded(mapped(trace(rest()), 1, 0, -0.15, 1, 0, 0), model).accepted);
  EXPECT_TRUE(graded(mapped(trace(rest()), 1.3, 0, 0, 0.9, 0, 0), model).accepted);
  EXPECT_TRUE(graded(mapped(trace(rest()), 0.75, 0, 0, 1.1, 0, 0), model).accepted);
}

TEST(Grade, ThreePointsOrThousandsAreAsGood) {
  for (const std::size_t count : {3U, 4U, 3000U}) {
    auto ink = trace(rest());
    for (auto& s : ink.strokes) s = resampled(s, count);
    EXPECT_TRUE(graded(ink, model_of(rest())).accepted) << count;
  }
}

TEST(Grade, AVerticalWithoutAnyWidthIsAVertical) {
  auto ink = trace(rest());
  ink.strokes[1] = along({{27, 43}, {27, 60}, {27, 93}});
  EXPECT_TRUE(graded(ink, model_of(rest())).accepted);
}

TEST(Grade, RepeatedPointsAndASinglePointAreNoTrouble) {
  auto ink = trace(rest());
  ink.strokes[0].insert(ink.strokes[0].begin(), 50, ink.strokes[0].front());
  EXPECT_TRUE(graded(ink, model_of(rest())).accepted);
  ink.strokes[2] = along({{50, 40}});
  const auto g = graded(ink, model_of(rest()));
  EXPECT_FALSE(g.accepted);
  EXPECT_FALSE(g.strokes[2].ok);
}

TEST(Grade, AListedOrderIsRecognisedAsAWholeAndNamed) {
  auto c = soil();
  c.alternative_orders = {{{1, 3, 2}, "a list"}};
  auto ink = trace(c);
  std::swap(ink.strokes[1], ink.strokes[2]);
  const auto g = graded(ink, model_of(c));
  EXPECT_TRUE(g.accepted);
  ASSERT_TRUE(g.alternative);
  EXPECT_EQ(g.alternative->source, "a list");
  EXPECT_EQ(g.strokes[1].matched, 2);
  EXPECT_TRUE(g.strokes[1].ok);
  auto other = trace(c);
  std::swap(other.strokes[0], other.strokes[1]);
  EXPECT_FALSE(graded(other, model_of(c)).accepted);
}

TEST(Grade, AnotherOrderIsAdviceWhenLenient) {
  auto ink = trace(rest());
  std::swap(ink.strokes[0], ink.strokes[1]);
  const auto g = graded(ink, model_of(rest()), kLenient);
  EXPECT_TRUE(g.accepted);
  ASSERT_EQ(g.advice.size(), 1U);
  EXPECT_EQ(g.advice[0].kind, kanji::MistakeKind::order);
  EXPECT_FALSE(graded(ink, model_of(rest()), kNormal).accepted);
}

TEST(Grade, TheStricterTheEarlierAMovedBarIsRefused) {
  const auto model = model_of(rest());
  double before = 1e9;
  double first = 0;
  for (const double strictness : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    double limit = 0;
    for (double shift = 0; shift < 40; shift += 0.5) {
      auto ink = trace(rest());
      for (auto& p : ink.strokes[2]) p.at.y += shift;
      if (!graded(ink, model, strictness).accepted) break;
      limit = shift;
    }
    EXPECT_LE(limit, before) << strictness;
    EXPECT_GT(limit, 3) << strictness;
    before = limit;
    if (strictness == 0) first = limit;
  }
  EXPECT_LT(before, 0.8 * first);
}

TEST(Grade, EndingsAreAdviceAndMistakesOnlyWhenStrict) {
  auto c = rest();
  auto ink = trace(c);
  auto& bar = ink.strokes[2];
  bar.push_back({{bar.back().at.x - 3, bar.back().at.y + 7}});
  const auto g = graded(ink, model_of(c));
  EXPECT_TRUE(g.accepted);
  ASSERT_EQ(g.advice.size(), 1U);
  EXPECT_EQ(g.advice[0].kind, kanji::MistakeKind::ending);
  EXPECT_THAT(mistake_names(graded(ink, model_of(c), kStrict)), ElementsAre("ending@2"));
  for (auto& s : c.strokes) s.line.ending = kanji::StrokeEnding::either;
  EXPECT_THAT(graded(ink, model_of(c), kStrict).mistakes, IsEmpty());
}

TEST(Grade, LookalikesAreNotTakenForEachOther) {
  const std::vector<Model> lookalikes{model_of(samurai())};
  const auto right = grade(trace(soil()), model_of(soil()), {}, lookalikes);
  ASSERT_TRUE(right);
  EXPECT_TRUE(right->accepted);
  const auto mistaken = grade(trace(samurai()), model_of(soil()), {}, lookalikes);
  ASSERT_TRUE(mistaken);
  EXPECT_FALSE(mistaken->accepted);
}

TEST(Grade, BadInkIsRefusedWithTheStrokeAtFault) {
  const auto model = model_of(rest());
  const auto refused = [&model](const WrittenCharacter& ink) {
    const auto g = grade(ink, model);
    return !g && g.error().code == base::Errc::bad_argument;
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({{WrittenStroke{}}, {}}));
  EXPECT_TRUE(refused({{along({{1, 1}})}, {}}));
  EXPECT_TRUE(refused({{along({{1, 1}, {1, 1}})}, {}}));
  EXPECT_TRUE(refused({{along({{1, 1}, {std::nan(""), 1}})}, {}}));
  EXPECT_TRUE(refused({{along({{1, 1}, {std::numeric_limits<double>::infinity(), 1}})}, {}}));
  EXPECT_TRUE(refused({{along({{1, 1}, {2, 1}}, {0.5})}, {}}));
  EXPECT_TRUE(refused({{along(geometry::Polyline<WritingFrame>(100'000, {1, 2}))}, {}}));
  auto boxed = trace(rest());
  boxed.box->side = 0;
  EXPECT_TRUE(refused(boxed));
  auto second = trace(rest());
  second.strokes[1][0].at.x = std::nan("");
  EXPECT_EQ(grade(second, model).error().where, "stroke 2");
  EXPECT_FALSE(grade(trace(rest()), model, {1.5, false}));
}

TEST(Grade, AStrangeStrokeThatLooksLikeAnotherOneIsTheOnlyMistake) {
  struct Case {
    kanji::Character character;
    std::size_t stroke;
    geometry::Polyline<WritingFrame> line;
  };
  const Case cases[] = {{rest(), 4, {{68, 30}, {71, 66}}},   // like the stroke before it
                        {three(), 0, {{22, 70}, {60, 73}}},  // below the second bar
                        {eye(), 2, {{92, 76}, {16, 64}}},    // like the next one, backwards
                        {eye(), 3, {{46, 95}, {63, 90}}}};   // at the place of the last one
  for (const auto& c : cases) {
    auto ink = trace(c.character);
    ink.strokes[c.stroke] = along(c.line);
    const std::vector<std::string> only{"wrong@" + std::to_string(c.stroke)};
    for (const double strictness : {kNormal, 0.8}) {
      const auto g = graded(ink, model_of(c.character), strictness);
      EXPECT_EQ(mistake_names(g), only) << strictness;
      for (std::size_t k = 0; k < g.strokes.size(); ++k) EXPECT_EQ(g.strokes[k].ok, k != c.stroke) << k;
    }
  }
}

TEST(Grade, LenientJudgingGivesNoAdviceAboutOrderBecauseOfAStrangeStroke) {
  auto ink = trace(eye());
  ink.strokes[3] = along({{46, 95}, {63, 90}});
  const auto g = graded(ink, model_of(eye()), 0.2);
  EXPECT_EQ(mistake_names(g), std::vector<std::string>{"wrong@3"});
  EXPECT_THAT(g.advice, IsEmpty());
}

}  // namespace
}  // namespace nazori::writing::test
