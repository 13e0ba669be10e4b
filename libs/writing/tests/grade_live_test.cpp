// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawing.h"
#include "nazori/writing/grade.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(GradeLive, VerdictsAreThoseOfTheMoment) {
  auto ink = trace(rest());
  ink.strokes[1] = reversed(ink.strokes[1]);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  EXPECT_THAT(mistake_names(*live), ElementsAre("reversed@1"));
  for (const std::size_t k : {0U, 2U, 3U, 4U, 5U}) EXPECT_TRUE(live->strokes[k].ok) << k;
}

TEST(GradeLive, AStrokeLeftOutIsNamedAndTheNextOnesStayRight) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin() + 1);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  EXPECT_THAT(mistake_names(*live), ElementsAre("missing@1"));
  EXPECT_FALSE(live->accepted);
}

TEST(GradeLive, AtTheEndTwoStrokesInOneAreCalledThat) {
  auto ink = trace(rest());
  ink.strokes[3] = joined(ink.strokes[3], ink.strokes[4]);
  ink.strokes.erase(ink.strokes.begin() + 4);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  EXPECT_THAT(mistake_names(*live), ElementsAre("joined@3"));
  for (const std::size_t k : {0U, 1U, 2U, 4U}) EXPECT_TRUE(live->strokes[k].ok) << k;
}

TEST(GradeLive, AFirstStrokeOfOnePointNextToZeroIsJudgedInFiniteNumbers) {
  auto ink = trace(soil());
  ink.strokes.resize(2);
  ink.strokes[0] = along({{1.3108082146925777e-39, 1.7345692780951883e-40}});
  ink.box.reset();
  const auto live = grade_live(ink, model_of(soil()));
  ASSERT_TRUE(live);
  for (const auto& s : live->strokes) {
    for (const double number : {s.offset_x, s.offset_y, s.size, s.angle_rad, s.shape, s.deviation})
      EXPECT_TRUE(std::isfinite(number));
  }
  EXPECT_FALSE(live->strokes[0].ok);
}

TEST(GradeLive, AStrokeDrawnTooEarlyIsToldOnce) {
  auto ink = trace(rest());
  std::rotate(ink.strokes.begin(), ink.strokes.begin() + 4, ink.strokes.begin() + 5);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  EXPECT_THAT(mistake_names(*live), ElementsAre("order@0"));
  auto unfinished = ink;
  unfinished.strokes.pop_back();
  const auto before = grade_live(unfinished, model_of(rest()), {kNormal, true});
  ASSERT_TRUE(before);
  EXPECT_THAT(mistake_names(*before), ElementsAre("order@0"));
}

/// The verdict on the last stroke, as the window requests it after each.
Grade told(const WrittenCharacter& ink, const kanji::Character& c, double strictness = kNormal) {
  const auto live = grade_live(ink, model_of(c), {strictness, true});
  EXPECT_TRUE(live);
  return live.value_or(Grade{});
}

TEST(GradeLive, AStrokeThatPassesOverAnotherIsToldSoAtOnceAndNotAgain) {
  auto ink = trace(rest());
  std::swap(ink.strokes[4], ink.strokes[5]);
  ink.strokes.pop_back();
  const auto early = told(ink, rest());
  EXPECT_THAT(mistake_names(early), ElementsAre("order@4"));
  EXPECT_FALSE(early.mistakes[0].second);
  EXPECT_THAT(early.mistakes[0].model, ElementsAre(5, 4)) << "the stroke drawn, the one that comes first";
  EXPECT_FALSE(early.strokes[4].ok);
  EXPECT_EQ(early.strokes[4].matched, 5);
  EXPECT_FALSE(early.accepted);
  ink.strokes.push_back(trace(rest()).strokes[4]);
  const auto late = told(ink, rest());
  EXPECT_THAT(mistake_names(late), ElementsAre("order@4")) << "once";
  EXPECT_FALSE(late.strokes[4].ok);
  EXPECT_TRUE(late.strokes[5].ok) << "it is what was asked for";
  EXPECT_EQ(late.strokes[5].matched, 4);
}

TEST(GradeLive, OnlyTheStrokeThatPassesOverAnotherIsBlamed) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin() + 1);
  ink.strokes.resize(3);
  const auto live = told(ink, rest());
  EXPECT_THAT(mistake_names(live), ElementsAre("order@1"));
  EXPECT_THAT(live.mistakes[0].model, ElementsAre(2, 1));
  EXPECT_TRUE(live.strokes[2].ok) << "the one after it follows rightly";
}

TEST(GradeLive, OfSeveralPassedOverTheFirstIsNamed) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin() + 1, ink.strokes.begin() + 3);
  ink.strokes.resize(2);
  const auto live = told(ink, rest());
  ASSERT_THAT(mistake_names(live), ElementsAre("order@1"));
  EXPECT_THAT(live.mistakes[0].model, ElementsAre(3, 1));
}

TEST(GradeLive, PassingOverAStrokeIsAdviceWhenLenient) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin());
  ink.strokes.resize(1);
  const auto live = told(ink, rest(), kLenient);
  EXPECT_THAT(live.mistakes, IsEmpty());
  ASSERT_EQ(live.advice.size(), 1U);
  EXPECT_EQ(live.advice[0].kind, kanji::MistakeKind::order);
  EXPECT_TRUE(live.strokes[0].ok);
}

TEST(GradeLive, AListedOrderIsNotTakenForPassingOver) {
  auto c = soil();
  c.alternative_orders = {{{1, 3, 2}, "a list"}};
  auto ink = trace(c);
  ink.strokes.erase(ink.strokes.begin() + 1);
  const auto live = told(ink, c);
  EXPECT_THAT(live.mistakes, IsEmpty());
  EXPECT_TRUE(live.strokes[1].ok);
  EXPECT_THAT(mistake_names(told(ink, soil())), ElementsAre("order@1"));
}

TEST(GradeLive, AStrangeStrokeDoesNotPassOverAnything) {
  auto ink = trace(rest());
  ink.strokes.resize(3);
  ink.strokes[2] = along({{60, 20}, {90, 25}, {62, 50}, {90, 90}, {58, 70}});
  for (const auto& mistake : told(ink, rest()).mistakes) EXPECT_NE(mistake.kind, kanji::MistakeKind::order);
}

TEST(GradeLive, AStrangeStrokeIsNotRightWhateverItWasTakenForAtFirst) {
  // Alone it looks like the fourth stroke, drawn too early. Together with the others it only counts as the
  // first.
  auto ink = trace(rest());
  ink.strokes[0] = along({{60, 20}, {62, 50}, {58, 70}});
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  EXPECT_THAT(mistake_names(*live), ElementsAre("wrong@0"));
  EXPECT_FALSE(live->strokes[0].ok);
  EXPECT_FALSE(told(ink, rest()).strokes[0].ok);
}

TEST(GradeLive, AStrokeDrawnOverOneThatWasRightIsTheOneTooMany) {
  // Person: the second stroke is a little off, the third lies just where the model has the second.
  const auto person =
      character(U'人', {"㇒|M54.5,20c0.37,2.12,0.23,4.03-0.22,6.27C51.68,39.48,38.25,72.25,16.5,87.25",
                        "㇏|M46,54.25c6.12,6,25.51,22.24,35.52,29.72c3.66,2.73,6.94,4.64,11.48,5.53"});
  auto ink = trace(person);
  ink.strokes.push_back(ink.strokes[1]);
  for (auto& p : ink.strokes[1]) p.at = {p.at.x + 4, p.at.y - 3};
  const auto live = told(ink, person);
  EXPECT_THAT(mistake_names(live), ElementsAre("extra@2"));
  EXPECT_TRUE(live.strokes[1].ok);
  EXPECT_EQ(live.strokes[1].matched, 1);
  EXPECT_FALSE(live.strokes[2].ok);
  EXPECT_EQ(live.strokes[2].matched, std::nullopt);
}

TEST(GradeLive, AWarningThatTheWholeDoesNotBearOutIsTakenBack) {
  // Whatever the first two of three bars were matched with: in the end they are in order.
  const auto model = model_of(three());
  for (double shift = -30; shift <= 30; shift += 1) {
    auto ink = trace(three());
    for (auto& p : ink.strokes[0]) p.at.y += shift;
    const auto whole = grade(ink, model, {kNormal, true});
    const auto live = grade_live(ink, model, {kNormal, true});
    ASSERT_TRUE(whole && live);
    if (!whole->accepted) continue;
    for (const auto& mistake : live->mistakes) EXPECT_NE(mistake.kind, kanji::MistakeKind::order) << shift;
  }
}

TEST(GradeLive, AtTheEndAStrokeLeftOutIsMissingAndTheStrokeThatPassedOverItIsRight) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin() + 1);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  EXPECT_THAT(mistake_names(*live), ElementsAre("missing@1"));
  for (const auto& s : live->strokes) EXPECT_TRUE(s.ok);
}

TEST(GradeLive, AtTheEndAnExchangeIsToldWithBothStrokes) {
  auto ink = trace(rest());
  std::swap(ink.strokes[4], ink.strokes[5]);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  ASSERT_THAT(mistake_names(*live), ElementsAre("order@4"));
  EXPECT_EQ(live->mistakes[0].second, 5);
  EXPECT_FALSE(live->strokes[4].ok);
  EXPECT_TRUE(live->strokes[5].ok);
}

TEST(GradeLive, AStrokeAloneIsTheSameStrokeInBothWays) {
  for (const auto& c : {rest(), soil(), eye()}) {
    const auto model = model_of(c);
    const auto all = trace(c);
    for (std::size_t k = 0; k < all.strokes.size(); ++k) {
      WrittenCharacter ink;
      ink.box = all.box;
      ink.strokes = {all.strokes[k]};
      const auto live = grade_live(ink, model);
      const auto whole = grade(ink, model);
      ASSERT_TRUE(live && whole);
      EXPECT_EQ(whole->strokes[0].matched, static_cast<int>(k));
      EXPECT_EQ(live->strokes[0].matched, static_cast<int>(k));
      EXPECT_EQ(mistake_names(*live), mistake_names(*whole));
    }
  }
}

TEST(GradeLive, AfterALaterStrokeDrawnFirstTheOthersAreStillKnown) {
  auto ink = trace(rest());
  std::rotate(ink.strokes.begin(), ink.strokes.begin() + 3, ink.strokes.begin() + 4);
  const auto live = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(live);
  std::vector<int> matched;
  for (const auto& s : live->strokes) matched.push_back(s.matched.value_or(-1));
  EXPECT_THAT(matched, ElementsAre(3, 0, 1, 2, 4, 5));
  EXPECT_FALSE(live->accepted);
}

TEST(GradeLive, WhichStrokeAFirstBarIsShowsOnceTheOthersAreThere) {
  auto ink = trace(three());
  ink.box.reset();
  std::swap(ink.strokes[0], ink.strokes[1]);
  for (const bool unfinished : {false, true}) {
    const auto live = grade_live(ink, model_of(three()), {kNormal, unfinished});
    ASSERT_TRUE(live);
    std::vector<int> matched;
    for (const auto& s : live->strokes) matched.push_back(s.matched.value_or(-1));
    EXPECT_THAT(matched, ElementsAre(1, 0, 2));
  }
}

TEST(GradeLive, TheBeginningIsNotBlamedForWhatFollows) {
  auto ink = trace(rest());
  ink.strokes.resize(3);
  const auto g = grade(ink, model_of(rest()), {kNormal, true});
  ASSERT_TRUE(g);
  EXPECT_THAT(mistake_names(*g), IsEmpty());
  for (const auto& s : g->strokes) EXPECT_TRUE(s.ok);
}

}  // namespace
}  // namespace nazori::writing::test
