// SPDX-License-Identifier: Apache-2.0
// Where the tracker of the ink draws its lines: how near, how far, how much.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nazori/practice/traced_ink.h"

namespace nazori::practice {
namespace {

using haptics::StrokePath;
using haptics::Vec3;

StrokePath line(Vec3 from, Vec3 to) { return {{from, to}}; }

TracedInk tracker(const std::vector<StrokePath>& strokes) {
  TracedInk ink;
  ink.set_strokes(strokes);
  return ink;
}

/// A level stroke of 60 mm, then an upright one.
TracedInk cross() { return tracker({line({-0.03, 0, 0}, {0.03, 0, 0}), line({0, 0.03, 0}, {0, -0.03, 0})}); }

/// Moves the pressed stylus in steps of at most 0.1 mm. @return the last event but none and began.
TracedInk::Step go(TracedInk& ink, Vec3 from, Vec3 to, int only = 0) {
  TracedInk::Step told;
  const int steps =
      std::max(1, static_cast<int>(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / 0.0001)));
  for (int i = 0; i <= steps; ++i) {
    const auto step = ink.follow(from + (to - from) * (static_cast<double>(i) / steps), true, only);
    if (step.event != TraceEvent::none && step.event != TraceEvent::began) told = step;
  }
  return told;
}

TracedInk::Step lift(TracedInk& ink, Vec3 at = {}) { return ink.follow(at, false, 0); }

TEST(TracedInkBounds, AStrokeIsFinishedWithoutALiftOneAndAHalfMillimetresBeforeItsEnd) {
  auto ink = cross();
  EXPECT_EQ(go(ink, {-0.03, 0, 0}, {0.0284, 0, 0}).event, TraceEvent::none);
  EXPECT_EQ(ink.next_stroke(), 1);
  const auto step = go(ink, {0.0284, 0, 0}, {0.0286, 0, 0});
  EXPECT_EQ(step.event, TraceEvent::finished);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_TRUE(step.inked);
}

TEST(TracedInkBounds, OfAShortStrokeATenthIsNearEnoughToTheEnd) {
  auto ink = tracker({line({0, 0, 0}, {0.01, 0, 0})});
  go(ink, {0, 0, 0}, {0.0088, 0, 0});
  EXPECT_FALSE(ink.is_finished(1));
  go(ink, {0.0088, 0, 0}, {0.0092, 0, 0});
  EXPECT_TRUE(ink.is_finished(1));
}

TEST(TracedInkBounds, ADotIsFinishedByATouch) {
  auto ink = tracker({line({0, 0, 0}, {0, 0, 0})});
  EXPECT_EQ(ink.follow({0, 0, 0}, true, 0).event, TraceEvent::began);
  EXPECT_EQ(ink.follow({0, 0, 0}, true, 0).event, TraceEvent::finished);
  EXPECT_EQ(ink.progress(), std::vector{1.0});
  EXPECT_EQ(ink.undo(), 0) << "nothing flowed along it";
}

TEST(TracedInkBounds, WhileALongerStrokeMayBeMeantTheLiftDecides) {
  // The first lies completely on the second.
  auto ink = tracker({line({0, 0, 0}, {0.02, 0, 0}), line({0, 0, 0}, {0.04, 0, 0})});
  go(ink, {0, 0, 0}, {0.02, 0, 0});
  EXPECT_FALSE(ink.is_finished(1));
  EXPECT_GT(ink.progress()[0], 0.99);
  const auto step = lift(ink, {0.02, 0, 0});
  EXPECT_EQ(step.event, TraceEvent::finished);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_EQ(ink.progress(), (std::vector{1.0, 0.0}));
}

TEST(TracedInkBounds, TwoMillimetresOfInkMakeAStrokeThatWasLeft) {
  for (const double drawn_m : {0.0018, 0.0022}) {
    auto ink = cross();
    go(ink, {-0.03, 0, 0}, {-0.03 + drawn_m, 0, 0});
    EXPECT_EQ(lift(ink).event, drawn_m > 0.002 ? TraceEvent::left_open : TraceEvent::none) << drawn_m;
    EXPECT_EQ(ink.left_open().size(), drawn_m > 0.002 ? 1U : 0U) << drawn_m;
  }
}

TEST(TracedInkBounds, FiveMillimetresMayBeMissingAtALift) {
  for (const double left_m : {0.0048, 0.0052}) {
    auto ink = cross();
    go(ink, {-0.03, 0, 0}, {0.03 - left_m, 0, 0});
    EXPECT_EQ(lift(ink).event, left_m < 0.005 ? TraceEvent::finished : TraceEvent::left_open) << left_m;
  }
}

TEST(TracedInkBounds, WhoPassesOverABeginningWritesThereAfterEightMillimetres) {
  for (const double past_m : {0.0077, 0.0083}) {
    auto ink = tracker({line({-0.04, 0, 0}, {0, 0, 0}), line({0, 0, 0}, {0.04, 0, 0})});
    go(ink, {-0.04, 0, 0}, {past_m, 0, 0});
    const auto step = lift(ink, {past_m, 0, 0});
    EXPECT_EQ(step.stroke, 2);
    if (past_m < 0.008) {
      EXPECT_EQ(step.event, TraceEvent::none);
      EXPECT_TRUE(step.inked) << "its ink went away";
      EXPECT_EQ(ink.progress(), (std::vector{1.0, 0.0}));
      EXPECT_TRUE(ink.left_open().empty());
    } else {
      EXPECT_EQ(step.event, TraceEvent::left_open);
      EXPECT_NEAR(ink.progress()[1], past_m / 0.04, 1e-6);
    }
  }
}

TEST(TracedInkBounds, AStrokeBeginsWithinTheReachOfItsStart) {
  constexpr double kReach = TracedInk::kReach_m;
  for (const auto& [away_m, event] :
       {std::pair(kReach - 1e-4, TraceEvent::began), std::pair(kReach + 1e-4, TraceEvent::none)}) {
    auto ink = cross();
    const auto step = ink.follow({-0.03, away_m, 0}, true, 0);
    EXPECT_EQ(step.event, event) << away_m;
    EXPECT_EQ(step.stroke, event == TraceEvent::began ? 1 : 0) << away_m;
    EXPECT_FALSE(step.inked);
  }
}

TEST(TracedInkBounds, OnlyALongStrokeWithoutInkIsSaidToBeTakenUpFromItsEnd) {
  constexpr double kReach = TracedInk::kReach_m;
  const auto at_the_end_of = [](double length_m, double beside_m) {
    auto ink = tracker({line({0, 0, 0}, {length_m, 0, 0})});
    return ink.follow({length_m, beside_m, 0}, true, 0).event;
  };
  EXPECT_EQ(at_the_end_of(2 * kReach + 2e-4, 0), TraceEvent::from_the_end);
  EXPECT_EQ(at_the_end_of(2 * kReach - 2e-4, 0), TraceEvent::none);
  EXPECT_EQ(at_the_end_of(0.04, kReach - 1e-4), TraceEvent::from_the_end);
  EXPECT_EQ(at_the_end_of(0.04, kReach + 1e-4), TraceEvent::none);
  auto begun = tracker({line({0, 0, 0}, {0.04, 0, 0})});
  go(begun, {0, 0, 0}, {0.01, 0, 0});
  lift(begun);
  EXPECT_EQ(begun.follow({0.04, 0, 0}, true, 0).event, TraceEvent::none) << "it has ink";
}

TEST(TracedInkBounds, TheEndOfAnotherStrokeThanTheNextIsNoBeginning) {
  auto ink = cross();
  EXPECT_EQ(ink.follow({0, -0.03, 0}, true, 0).event, TraceEvent::none);
  lift(ink);
  const auto step = ink.follow({0, -0.03, 0}, true, 2);
  EXPECT_EQ(step.event, TraceEvent::from_the_end) << "it is the one that is shown";
  EXPECT_EQ(step.stroke, 2);
  lift(ink);
  EXPECT_EQ(ink.follow({0, -0.03, 0}, true, 3).event, TraceEvent::none) << "there is no third";
}

TEST(TracedInkBounds, AFinishedStrokeIsNotTakenUpAgain) {
  auto ink = cross();
  go(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  lift(ink);
  EXPECT_EQ(ink.follow({-0.03, 0, 0}, true, 1).event, TraceEvent::none);
  lift(ink);
  EXPECT_EQ(ink.follow({0.03, 0, 0}, true, 1).event, TraceEvent::none);
}

TEST(TracedInkBounds, AloneOnTheTabletNoStrokeIsTooEarly) {
  auto ink = cross();
  EXPECT_EQ(ink.follow({0, 0.03, 0}, true, 2).event, TraceEvent::began);
}

TEST(TracedInkBounds, OfSeveralThatBeginTogetherTheNextComesFirstElseTheNearest) {
  const std::vector<StrokePath> strokes{line({0.03, 0.03, 0}, {0.03, -0.03, 0}),
                                        line({0, 0, 0}, {-0.03, 0.01, 0}),
                                        line({0.003, 0, 0}, {0.003, -0.03, 0})};
  auto ink = tracker(strokes);
  const auto early = ink.follow({0.003, 0, 0}, true, 0);
  EXPECT_EQ(early.event, TraceEvent::too_early);
  EXPECT_EQ(early.stroke, 3) << "the nearest";
  lift(ink);
  go(ink, {0.03, 0.03, 0}, {0.03, -0.03, 0});
  lift(ink);
  const auto next = ink.follow({0.003, 0, 0}, true, 0);
  EXPECT_EQ(next.event, TraceEvent::began);
  EXPECT_EQ(next.stroke, 2) << "it is its turn";
}

TEST(TracedInkBounds, OfThreeThatBeginTogetherTheOneTakesTheInkThatTheHandFollowsFurthest) {
  auto ink = tracker({line({0, 0, 0}, {0.04, 0, 0}), line({0, 0, 0}, {-0.0283, -0.0283, 0}),
                      line({0, 0, 0}, {0, -0.04, 0})});
  const auto step = go(ink, {0, 0, 0}, {0, -0.0115, 0});
  EXPECT_EQ(step.event, TraceEvent::too_early);
  EXPECT_EQ(step.stroke, 3);
  EXPECT_TRUE(step.inked);
  EXPECT_EQ(ink.progress()[0], 0);
  EXPECT_EQ(ink.progress()[1], 0);
  EXPECT_NEAR(ink.progress()[2], 0.0115 / 0.04, 0.003);
}

TEST(TracedInkBounds, WhenOneStrokeIsShownAloneTheOthersAreFollowedNoMore) {
  auto ink = tracker({line({0, 0, 0}, {0.04, 0, 0}), line({0, 0, 0}, {0, -0.04, 0})});
  (void)ink.follow({0, 0, 0}, true, 0);
  go(ink, {0, 0, 0}, {0.005, 0, 0}, 2);
  EXPECT_EQ(ink.progress(), (std::vector{0.0, 0.0}));
}

TEST(TracedInkBounds, EachStepTellsWhetherInkFlowed) {
  auto ink = cross();
  (void)ink.follow({-0.03, 0, 0}, true, 0);
  const auto on = ink.follow({-0.029, 0, 0}, true, 0);
  EXPECT_TRUE(on.inked);
  EXPECT_EQ(on.stroke, 1);
  EXPECT_FALSE(ink.follow({-0.029, 0, 0}, true, 0).inked) << "the stylus rests";
  EXPECT_FALSE(ink.follow({-0.030, 0, 0}, true, 0).inked) << "backwards";
  EXPECT_NEAR(ink.progress()[0], 0.001 / 0.06, 1e-9);
}

TEST(TracedInkBounds, WhatIsUndoneOrClearedInTheMiddleOfATouchIsNotGoneOnWith) {
  for (const bool undone : {true, false}) {
    auto ink = cross();
    go(ink, {-0.03, 0, 0}, {-0.01, 0, 0});
    undone ? void(ink.undo()) : ink.clear();
    go(ink, {-0.01, 0, 0}, {0.01, 0, 0});
    EXPECT_EQ(ink.progress(), (std::vector{0.0, 0.0}));
    EXPECT_EQ(lift(ink).event, TraceEvent::none);
    // The same if the stylus has left the stroke.
    go(ink, {-0.03, 0, 0}, {-0.01, 0, 0});
    go(ink, {-0.01, 0, 0}, {-0.01, -0.02, 0});
    undone ? void(ink.undo()) : ink.clear();
    EXPECT_EQ(lift(ink).event, TraceEvent::none);
    EXPECT_TRUE(ink.left_open().empty());
  }
}

TEST(TracedInkBounds, WhoGoesAstrayAndLiftsHasLeftTheStroke) {
  auto ink = cross();
  go(ink, {-0.03, 0, 0}, {-0.01, 0, 0});
  go(ink, {-0.01, 0, 0}, {-0.01, -0.02, 0});
  const auto step = lift(ink, {-0.01, -0.02, 0});
  EXPECT_EQ(step.event, TraceEvent::left_open);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_EQ(lift(ink).event, TraceEvent::none) << "told once";
}

TEST(TracedInkBounds, WhatIsLeftOpenIsListedOnceInTheOrderOfTheStrokes) {
  auto ink = cross();
  go(ink, {0, 0.03, 0}, {0, 0.01, 0}, 2);
  lift(ink);
  go(ink, {-0.03, 0, 0}, {-0.02, 0, 0});
  lift(ink);
  go(ink, {-0.02, 0, 0}, {-0.01, 0, 0});
  lift(ink);
  EXPECT_EQ(ink.left_open(), (std::vector{1, 2}));
}

TEST(TracedInkBounds, TheMissingBitGoesInStepsOfAMillimetreAtMostFromTheInkToTheEnd) {
  auto ink = tracker({line({0, 0, 0}, {0.0105, 0, 0})});
  const auto whole = ink.missing_bit(1);
  ASSERT_EQ(whole.size(), 12U);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NEAR(whole[i].x, 0.0105 * static_cast<double>(i) / 11, 1e-12);
    EXPECT_EQ(whole[i].y, 0);
  }
  go(ink, {0, 0, 0}, {0.004, 0, 0});
  const auto rest = ink.missing_bit(1);
  ASSERT_EQ(rest.size(), 8U);
  EXPECT_NEAR(rest.front().x, 0.004, 1e-9);
  EXPECT_TRUE(ink.missing_bit(0).empty());
  EXPECT_TRUE(ink.missing_bit(2).empty());
}

TEST(TracedInkBounds, AStrokeThatIsNotThereIsNotFinished) {
  auto ink = tracker({line({0, 0, 0}, {0, 0, 0})});
  (void)ink.follow({0, 0, 0}, true, 0);
  (void)ink.follow({0, 0, 0}, true, 0);
  EXPECT_TRUE(ink.is_finished(1));
  EXPECT_FALSE(ink.is_finished(0));
  EXPECT_FALSE(ink.is_finished(2));
  EXPECT_EQ(TracedInk().next_stroke(), 0);
}

}  // namespace
}  // namespace nazori::practice
