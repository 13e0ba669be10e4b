// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/traced_ink.h"

#include <gtest/gtest.h>

#include <cmath>

#include "database_under_test.h"
#include "nazori/geometry/polyline.h"

namespace {

using nazori::haptics::StrokePath;
using nazori::haptics::Vec3;
using nazori::practice::TracedInk;
using nazori::practice::TraceEvent;

/// A cross: a level stroke from left to right, then an upright one from top to bottom, each 60 mm long.
TracedInk cross() {
  const StrokePath level{{Vec3(-0.03, 0, -0.01), Vec3(0.03, 0, -0.01)}};
  const StrokePath upright{{Vec3(0, 0.03, -0.01), Vec3(0, -0.03, -0.01)}};
  TracedInk ink;
  ink.set_strokes(std::vector{level, upright});
  return ink;
}

/// Draws a straight line as a hand would, a sample each 0.1 mm; returns the last event that was not none.
TracedInk::Step draw(TracedInk& ink, Vec3 from, Vec3 to, int only = 0) {
  TracedInk::Step last;
  constexpr int kSamples = 600;
  for (int i = 0; i <= kSamples; ++i) {
    const auto step = ink.follow(from + (to - from) * (static_cast<double>(i) / kSamples), true, only);
    if (step.event != TraceEvent::none && step.event != TraceEvent::began) last = step;
  }
  ink.follow(to, false, only);
  return last;
}

TEST(TracedInk, InkFlowsAsFarAsTheStylusHasCome) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(ink.progress()[0], 0.5, 0.01);
  EXPECT_EQ(ink.progress()[1], 0.0);
}

TEST(TracedInk, AStrokeDrawnToItsEndIsFinishedAndTheNextIsDue) {
  auto ink = cross();
  const auto step = draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  EXPECT_EQ(step.event, TraceEvent::finished);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_TRUE(ink.is_finished(1));
  EXPECT_EQ(ink.next_stroke(), 2);
}

TEST(TracedInk, CrossingAGrooveLeavesNoInkOnIt) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  EXPECT_EQ(ink.progress()[1], 0.0);
}

TEST(TracedInk, AStrokeDrawnBackwardsTakesNoInkAndIsAdvisedAgainst) {
  auto ink = cross();
  const auto step = draw(ink, {0.03, 0, 0}, {-0.02, 0, 0});
  EXPECT_EQ(step.event, TraceEvent::from_the_end);
  EXPECT_EQ(step.stroke, 1);
  EXPECT_EQ(ink.progress()[0], 0.0);
}

TEST(TracedInk, ALaterStrokeDrawnFirstIsWrittenWithAdvice) {
  auto ink = cross();
  const auto early = ink.follow({0, 0.03, 0}, true, 0);
  EXPECT_EQ(early.event, TraceEvent::too_early);
  EXPECT_EQ(early.stroke, 2);
  draw(ink, {0, 0.03, 0}, {0, -0.03, 0});
  EXPECT_TRUE(ink.is_finished(2));
  EXPECT_EQ(ink.next_stroke(), 1);
}

TEST(TracedInk, WithOneStrokeShownTheOthersTakeNoInk) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0}, 2);
  EXPECT_EQ(ink.progress()[0], 0.0);
  draw(ink, {0, 0.03, 0}, {0, -0.03, 0}, 2);
  EXPECT_TRUE(ink.is_finished(2));
}

TEST(TracedInk, AfterALiftTheStrokeGoesOnWhereItsInkEnds) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {-0.01, 0, 0});
  EXPECT_EQ(ink.follow({0.02, 0, 0}, true, 0).event, TraceEvent::none) << "far ahead of the ink";
  ink.follow({0.02, 0, 0}, false, 0);
  draw(ink, {-0.01, 0, 0}, {0.03, 0, 0});
  EXPECT_TRUE(ink.is_finished(1));
}

TEST(TracedInk, DriftingFarBesideTheGrooveStopsTheInk) {
  auto ink = cross();
  draw(ink, {-0.03, 0.012, 0}, {0.03, 0.012, 0});
  EXPECT_EQ(ink.progress()[0], 0.0);
}

TEST(TracedInk, WhoStraysTwiceTheReachFromTheInkMustComeBackToIt) {
  constexpr double kReach = TracedInk::kReach_m;
  for (const double away : {1.8, 2.2, 2.5, 4.0}) {
    auto ink = cross();
    const Vec3 front(-0.01, 0, 0);
    const auto go = [&ink](Vec3 from, Vec3 to) {
      for (int i = 0; i <= 200; ++i) (void)ink.follow(from + (to - from) * (i / 200.0), true, 0);
    };
    go({-0.03, 0, 0}, front);
    const double before = ink.progress()[0];
    ASSERT_NEAR(before, 1.0 / 3, 1e-6);
    // The way back passes the ink beyond its reach.
    const Vec3 astray = front + Vec3(0, -away * kReach, 0);
    const Vec3 further = front + Vec3(1.5 * kReach, 0, 0);
    go(front, astray);
    go(astray, further);
    if (away < 2)
      EXPECT_GT(ink.progress()[0], before) << "still the same stroke";
    else
      EXPECT_EQ(ink.progress()[0], before) << away;
    go(further, front);
    go(front, {0.03, 0, 0});
    EXPECT_TRUE(ink.is_finished(1)) << away;
  }
}

TEST(TracedInk, ALoopThatReturnsToItsStartIsNotFinishedByStandingThere) {
  StrokePath circle;
  for (int i = 0; i <= 60; ++i)
    circle.points.emplace_back(0.02 * std::cos(i * 0.1047), 0.02 * std::sin(i * 0.1047), -0.01);
  TracedInk ink;
  ink.set_strokes(std::vector{circle});
  for (int i = 0; i < 100; ++i) ink.follow({0.02, 0, 0}, true, 0);
  EXPECT_LT(ink.progress()[0], 0.1);
}

TEST(TracedInk, AHoveringStylusLeavesNoInk) {
  auto ink = cross();
  for (int i = 0; i <= 60; ++i) ink.follow({-0.03 + i * 0.001, 0, 0.005}, false, 0);
  EXPECT_EQ(ink.progress()[0], 0.0);
}

TEST(TracedInk, UndoTakesTheInkOffTheStrokeThatTookItUpLast) {
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

TEST(TracedInk, WhoRestsAtTheEndOfTheLastStrokeWhileItIsClearedHasNotBegunThere) {
  TracedInk ink;
  ink.set_strokes(std::vector{StrokePath{{Vec3(-0.03, 0, -0.01), Vec3(0.03, 0, -0.01)}}});
  for (int i = 0; i <= 600; ++i) (void)ink.follow(Vec3(-0.03 + i * 0.0001, 0, 0), true, 0);
  ASSERT_EQ(ink.next_stroke(), 0);
  ink.clear();
  EXPECT_EQ(ink.follow(Vec3(0.03, 0, 0), true, 0).event, TraceEvent::none);
  (void)ink.follow(Vec3(0.03, 0, 0), false, 0);
  EXPECT_EQ(ink.follow(Vec3(0.03, 0, 0), true, 0).event, TraceEvent::from_the_end) << "now it has";
}

TEST(TracedInk, ClearingTakesAllInkAway) {
  auto ink = cross();
  draw(ink, {-0.03, 0, 0}, {0.03, 0, 0});
  ink.clear();
  EXPECT_EQ(ink.progress(), (std::vector<double>{0, 0}));
  EXPECT_EQ(ink.next_stroke(), 1);
}

/// Draws a bent line with a sample each 0.2 mm and lifts. @return all events but none.
std::vector<TracedInk::Step> draw_along(TracedInk& ink, const std::vector<Vec3>& line) {
  std::vector<TracedInk::Step> steps;
  const auto take = [&steps](const TracedInk::Step& step) {
    if (step.event != TraceEvent::none) steps.push_back(step);
  };
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec3 way = line[k + 1] - line[k];
    const int samples = std::max(1, static_cast<int>(std::hypot(way.x, way.y) / 0.0002));
    for (int i = 0; i <= samples; ++i)
      take(ink.follow(line[k] + way * (static_cast<double>(i) / samples), true, 0));
  }
  take(ink.follow(line.back(), false, 0));
  return steps;
}

TEST(TracedInk, LiftedALittleBeforeTheEndAStrokeIsFinished) {
  auto ink = cross();
  const auto steps = draw_along(ink, {{-0.03, 0, 0}, {0.0255, 0, 0}});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].event, TraceEvent::finished);
  EXPECT_EQ(steps[1].stroke, 1);
  EXPECT_EQ(ink.progress()[0], 1.0);
}

TEST(TracedInk, LiftedEarlierAStrokeIsLeftOpenAndShowsWhatIsMissing) {
  auto ink = cross();
  const auto steps = draw_along(ink, {{-0.03, 0, 0}, {0.0235, 0, 0}});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].event, TraceEvent::left_open);
  EXPECT_EQ(steps[1].stroke, 1);
  EXPECT_FALSE(ink.is_finished(1));
  EXPECT_EQ(ink.left_open(), std::vector{1});
  const auto bit = ink.missing_bit(1);
  ASSERT_GE(bit.size(), 2U);
  EXPECT_NEAR(bit.front().x, 0.0235, 1e-3);
  EXPECT_NEAR(bit.back().x, 0.03, 1e-9);
  draw_along(ink, {{0.0235, 0, 0}, {0.03, 0, 0}});
  EXPECT_TRUE(ink.is_finished(1));
  EXPECT_TRUE(ink.left_open().empty());
  EXPECT_TRUE(ink.missing_bit(1).empty());
}

TEST(TracedInk, OfAShortStrokeNoMoreThanAQuarterMayBeLeft) {
  TracedInk ink;
  ink.set_strokes(std::vector{StrokePath{{Vec3(0, 0, -0.01), Vec3(0.012, 0, -0.01)}}});
  draw_along(ink, {{0, 0, 0}, {0.0085, 0, 0}});
  EXPECT_FALSE(ink.is_finished(1));
  EXPECT_EQ(ink.left_open(), std::vector{1});
  draw_along(ink, {{0.0085, 0, 0}, {0.0095, 0, 0}});
  EXPECT_TRUE(ink.is_finished(1));
}

TEST(TracedInk, AStrokeThatWasOnlyTouchedIsNotCalledLeft) {
  auto ink = cross();
  const auto steps = draw_along(ink, {{-0.03, 0, 0}, {-0.0285, 0, 0}});
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].event, TraceEvent::began);
  EXPECT_TRUE(ink.left_open().empty());
}

TEST(TracedInk, UndoAndClearForgetWhatWasLeftOpen) {
  auto ink = cross();
  draw_along(ink, {{-0.03, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(ink.undo(), 1);
  EXPECT_TRUE(ink.left_open().empty());
  draw_along(ink, {{-0.03, 0, 0}, {0, 0, 0}});
  ink.clear();
  EXPECT_TRUE(ink.left_open().empty());
}

/// From one point: first a stroke to the right, then one downwards, each 40 mm long.
TracedInk corner() {
  const StrokePath level{{Vec3(0, 0, -0.01), Vec3(0.04, 0, -0.01)}};
  const StrokePath upright{{Vec3(0, 0, -0.01), Vec3(0, -0.04, -0.01)}};
  TracedInk ink;
  ink.set_strokes(std::vector{level, upright});
  return ink;
}

TEST(TracedInk, WhereTwoStrokesBeginTogetherTheHandShowsWhichItFollows) {
  auto ink = corner();
  const auto steps = draw_along(ink, {{0, 0, 0}, {0, -0.04, 0}});
  EXPECT_EQ(ink.progress(), (std::vector<double>{0, 1})) << "the first takes back the ink it was given";
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[1].event, TraceEvent::too_early) << "told as soon as it shows";
  EXPECT_EQ(steps[1].stroke, 2);
  EXPECT_EQ(steps[2].event, TraceEvent::finished);
  EXPECT_EQ(steps[2].stroke, 2);
  EXPECT_EQ(ink.undo(), 2) << "the first has no ink to be taken off";
  EXPECT_EQ(ink.undo(), 0);
}

TEST(TracedInk, ABitLeftOpenDoesNotSwallowTheStrokeThatBeginsBesideIt) {
  // The first stroke ends where the second begins.
  const StrokePath level{{Vec3(-0.04, 0, -0.01), Vec3(0, 0, -0.01)}};
  const StrokePath upright{{Vec3(0, 0, -0.01), Vec3(0, -0.04, -0.01)}};
  TracedInk ink;
  ink.set_strokes(std::vector{level, upright});
  draw_along(ink, {{-0.04, 0, 0}, {-0.0055, 0, 0}});
  ASSERT_EQ(ink.left_open(), std::vector{1});
  const double before = ink.progress()[0];
  draw_along(ink, {{-0.0006, -0.001, 0}, {0, -0.04, 0}});
  EXPECT_TRUE(ink.is_finished(2));
  EXPECT_DOUBLE_EQ(ink.progress()[0], before) << "nor is it finished by it";
  EXPECT_EQ(ink.left_open(), std::vector{1});
}

TEST(TracedInk, OfTwoShortStrokesFromOnePointTheOneIsFinishedThatEndsAtTheLift) {
  for (const bool level_is_written : {true, false}) {
    TracedInk ink;
    ink.set_strokes(std::vector{StrokePath{{Vec3(0, 0, -0.01), Vec3(0.01, 0, -0.01)}},
                                StrokePath{{Vec3(0, 0, -0.01), Vec3(0.005, -0.009, -0.01)}}});
    draw_along(ink, {{0, 0, 0}, level_is_written ? Vec3(0.01, 0, 0) : Vec3(0.005, -0.009, 0)});
    EXPECT_EQ(ink.is_finished(1), level_is_written);
    EXPECT_EQ(ink.is_finished(2), !level_is_written);
    EXPECT_EQ(ink.progress()[level_is_written ? 1 : 0], 0.0);
  }
}

TEST(TracedInk, GoingOnALittlePastTheEndLeavesNoInkOnTheNextStroke) {
  const StrokePath level{{Vec3(-0.04, 0, -0.01), Vec3(0, 0, -0.01)}};
  const StrokePath further{{Vec3(0, 0, -0.01), Vec3(0.04, 0.002, -0.01)}};
  TracedInk ink;
  ink.set_strokes(std::vector{level, further});
  const auto steps = draw_along(ink, {{-0.04, 0, 0}, {0.003, 0, 0}});
  EXPECT_EQ(ink.progress(), (std::vector<double>{1, 0}));
  EXPECT_EQ(steps.back().event, TraceEvent::finished) << "nothing is said of the next";
  draw_along(ink, {{0, 0, 0}, {0.04, 0.002, 0}});
  EXPECT_EQ(ink.next_stroke(), 0);
}

TEST(TracedInk, WrittenInOneGoWithoutALiftTheNextStrokeKeepsItsInk) {
  const StrokePath level{{Vec3(-0.04, 0, -0.01), Vec3(0, 0, -0.01)}};
  const StrokePath further{{Vec3(0, 0, -0.01), Vec3(0.04, 0.002, -0.01)}};
  TracedInk ink;
  ink.set_strokes(std::vector{level, further});
  draw_along(ink, {{-0.04, 0, 0}, {0.02, 0, 0}});
  EXPECT_NEAR(ink.progress()[1], 0.5, 0.03);
}

TEST(TracedInk, InTurnTheFirstOfTwoThatBeginTogetherIsWrittenWithoutAdvice) {
  auto ink = corner();
  const auto steps = draw_along(ink, {{0, 0, 0}, {0.04, 0, 0}});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].event, TraceEvent::began);
  EXPECT_EQ(steps[1].event, TraceEvent::finished);
  EXPECT_EQ(ink.progress(), (std::vector<double>{1, 0}));
}

/// The same numbers on every machine, -1..1.
class Shake {
 public:
  explicit Shake(std::uint32_t seed) : state_(seed) {}
  double next() {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      state_ = state_ * 1664525U + 1013904223U;
      sum += static_cast<double>(state_ >> 8U) / (1U << 24U) - 0.5;
    }
    return sum / 2;
  }

 private:
  std::uint32_t state_;
};

/// A hand that follows a line with care: it begins and ends a little off, trembles slowly by about half a
/// millimetre, and the stylus lags behind by half a millimetre because of friction.
std::vector<Vec3> careful(const std::vector<Vec3>& line, Shake& shake) {
  std::vector<nazori::geometry::TabletPoint> points;
  for (const auto& p : line) points.push_back({p.x, p.y});
  using nazori::geometry::TabletFrame;
  const double length = nazori::geometry::arc_length<TabletFrame>(points);
  const double off_x = 0.002 * shake.next();
  const double off_y = 0.002 * shake.next();
  const double stop = length - 0.001 + 0.003 * shake.next();
  std::vector<Vec3> out;
  Vec3 lagging{points.front().x, points.front().y, 0};
  double x = 0, y = 0, to_x = 0, to_y = 0;
  constexpr double kStep_m = 0.0002;
  for (double at = 0; at <= stop; at += kStep_m) {
    if (static_cast<int>(at / kStep_m) % 20 == 0) {
      to_x = 0.0016 * shake.next();
      to_y = 0.0016 * shake.next();
    }
    x += 0.08 * (to_x - x);
    y += 0.08 * (to_y - y);
    const double fades = std::exp(-at / 0.004);
    const auto p = nazori::geometry::point_at<TabletFrame>(points, std::min(at, length));
    const Vec3 hand{p.x + x + fades * off_x, p.y + y + fades * off_y, 0};
    const double away = std::hypot(hand.x - lagging.x, hand.y - lagging.y);
    constexpr double kLag_m = 0.0005;
    if (away > kLag_m) lagging += (hand - lagging) * ((away - kLag_m) / away);
    out.push_back(lagging);
  }
  return out;
}

TEST(TracedInk, NineteenOfTwentyCarefulTracingsAreTaken) {
  int tracings = 0;
  int completed = 0;
  for (const char32_t character : std::u32string(U"休年人木水火花書国四心必川女子食あうおかけこさすたなぬねは"
                                                 U"ふほまむやらるれろをアキケシツネヒホモ")) {
    std::vector<StrokePath> strokes;
    for (const auto& line : nazori::practice::test::model(character)) {
      StrokePath path;
      for (const auto& point : line) {
        const auto p = nazori::geometry::glyph_to_tablet(point, {});
        path.points.emplace_back(p.x, p.y, -0.01);
      }
      strokes.push_back(path);
    }
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
      TracedInk ink;
      ink.set_strokes(strokes);
      Shake shake(seed * 7919U + static_cast<std::uint32_t>(character));
      for (const auto& stroke : strokes) {
        const auto hand = careful(stroke.points, shake);
        for (const auto& at : hand) (void)ink.follow(at, true, 0);
        (void)ink.follow(hand.back(), false, 0);
      }
      ++tracings;
      completed += ink.next_stroke() == 0 ? 1 : 0;
    }
  }
  EXPECT_GE(completed, tracings * 19 / 20) << "of " << tracings;
}

}  // namespace
