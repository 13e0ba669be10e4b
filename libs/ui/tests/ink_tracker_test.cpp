// SPDX-License-Identifier: Apache-2.0
#include "ink_tracker.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using nazori::haptics::StrokePath;
using nazori::haptics::Vec3;
using nazori::ui::InkEvent;
using nazori::ui::InkTracker;

/// A cross: a level stroke from left to right, then an upright one from top to bottom, each 60 mm long.
InkTracker cross() {
  const StrokePath level{{Vec3(-0.03, 0, -0.01), Vec3(0.03, 0, -0.01)}};
  const StrokePath upright{{Vec3(0, 0.03, -0.01), Vec3(0, -0.03, -0.01)}};
  InkTracker ink;
  ink.set_strokes(std::vector{level, upright});
  return ink;
}

/// Draws a straight line as a hand would, a sample each 0.1 mm; returns the last event that was not none.
InkTracker::Step draw(InkTracker& ink, Vec3 from, Vec3 to, int only = 0) {
  InkTracker::Step last;
  constexpr int kSamples = 600;
  for (int i = 0; i <= kSamples; ++i) {
    const auto step = ink.follow(from + (to - from) * (static_cast<double>(i) / kSamples), true, only);
    if (step.event != InkEvent::none && step.event != InkEvent::began) last = step;
  }
  ink.follow(to, false, only);
  return last;
}

TEST(InkTracker, InkFlowsAsFarAsTheStylusHasCome) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(ink.progress()[0], 0.5, 0.01);
  EXPECT_EQ(ink.progress()[1], 0.0);
}

TEST(InkTracker, AStrokeDrawnToItsEndIsFinishedAndTheNextIsDue) {
  auto ink = cross();
  const auto step = draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  EXPECT_EQ(step.event, InkEvent::finished);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_TRUE(ink.is_finished(1));
  EXPECT_EQ(ink.next_stroke(), 2);
}

TEST(InkTracker, CrossingAGrooveLeavesNoInkOnIt) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  EXPECT_EQ(ink.progress()[1], 0.0);
}

TEST(InkTracker, AStrokeDrawnBackwardsTakesNoInkAndIsAdvisedAgainst) {
  auto ink = cross();
  const auto step = draw(ink, {0.03, 0, 0}, {-0.02, 0, 0});
  EXPECT_EQ(step.event, InkEvent::from_the_end);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_EQ(ink.progress()[0], 0.0);
}

TEST(InkTracker, ALaterStrokeDrawnFirstIsWrittenWithAdvice) {
  auto ink = cross();
  const auto early = ink.follow({0, 0.03, 0}, true, 0);
  EXPECT_EQ(early.event, InkEvent::too_early);
  EXPECT_EQ(early.stroke, 2);
  draw(ink, {0, 0.03, 0}, {0, -0.03, 0});
  EXPECT_TRUE(ink.is_finished(2));
  EXPECT_EQ(ink.next_stroke(), 1);
}

TEST(InkTracker, WithOneStrokeShownTheOthersTakeNoInk) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0}, 2);
  EXPECT_EQ(ink.progress()[0], 0.0);
  draw(ink, {0, 0.03, 0}, {0, -0.03, 0}, 2);
  EXPECT_TRUE(ink.is_finished(2));
}

TEST(InkTracker, AfterALiftTheStrokeGoesOnWhereItsInkEnds) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {-0.01, 0, 0});
  EXPECT_EQ(ink.follow({0.02, 0, 0}, true, 0).event, InkEvent::none) << "far ahead of the ink";
  ink.follow({0.02, 0, 0}, false, 0);
  draw(ink, {-0.01, 0, 0}, {0.03, 0, 0});
  EXPECT_TRUE(ink.is_finished(1));
}

TEST(InkTracker, DriftingFarBesideTheGrooveStopsTheInk) {
  auto ink = cross();
  draw(ink, {-0.03, 0.012, 0}, {0.03, 0.012, 0});
  EXPECT_EQ(ink.progress()[0], 0.0);
}

TEST(InkTracker, ALoopThatReturnsToItsStartIsNotFinishedByStandingThere) {
  StrokePath circle;
  for (int i = 0; i <= 60; ++i)
    circle.points.emplace_back(0.02 * std::cos(i * 0.1047), 0.02 * std::sin(i * 0.1047), -0.01);
  InkTracker ink;
  ink.set_strokes(std::vector{circle});
  for (int i = 0; i < 100; ++i) ink.follow({0.02, 0, 0}, true, 0);
  EXPECT_LT(ink.progress()[0], 0.1);
}

TEST(InkTracker, AHoveringStylusLeavesNoInk) {
  auto ink = cross();
  for (int i = 0; i <= 60; ++i) ink.follow({-0.03 + i * 0.001, 0, 0.005}, false, 0);
  EXPECT_EQ(ink.progress()[0], 0.0);
}

TEST(InkTracker, UndoTakesTheInkOffTheStrokeThatTookItUpLast) {
  auto ink = cross();
  draw(ink, {0, 0.03, 0}, {0, -0.03, 0}, 2);
  draw(ink, {-0.03, 0, 0}, {0, 0, 0});
  EXPECT_EQ(ink.undo(), 1);
  EXPECT_EQ(ink.progress(), (std::vector<double>{0, 1}));
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  EXPECT_EQ(ink.undo(), 1) << "written anew, it is the last again";
  EXPECT_EQ(ink.undo(), 2);
  EXPECT_EQ(ink.undo(), 0);
  EXPECT_EQ(ink.progress(), (std::vector<double>{0, 0}));
}

TEST(InkTracker, WhoRestsAtTheEndOfTheLastStrokeWhileItIsClearedHasNotBegunThere) {
  InkTracker ink;
  ink.set_strokes(std::vector{StrokePath{{Vec3(-0.03, 0, -0.01), Vec3(0.03, 0, -0.01)}}});
  for (int i = 0; i <= 600; ++i) (void)ink.follow(Vec3(-0.03 + i * 0.0001, 0, 0), true, 0);
  ASSERT_EQ(ink.next_stroke(), 0);
  ink.clear();
  EXPECT_EQ(ink.follow(Vec3(0.03, 0, 0), true, 0).event, InkEvent::none);
  (void)ink.follow(Vec3(0.03, 0, 0), false, 0);
  EXPECT_EQ(ink.follow(Vec3(0.03, 0, 0), true, 0).event, InkEvent::from_the_end) << "now it has";
}

TEST(InkTracker, ClearingTakesAllInkAway) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  ink.clear();
  EXPECT_EQ(ink.progress(), (std::vector<double>{0, 0}));
  EXPECT_EQ(ink.next_stroke(), 1);
}

}  // namespace
