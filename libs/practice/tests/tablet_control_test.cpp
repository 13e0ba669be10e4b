// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_control.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <limits>

#include "running_tablet.h"
#include "scripted_device.h"

namespace {

using nazori::geometry::TabletPoint;
using nazori::practice::TabletControl;
using nazori::practice::TraceEvent;
using RunningTablet = nazori::practice::test::RunningTablet;

/// Three level strokes, the middle one through the centre of the tablet.
std::shared_ptr<const nazori::tablet::CarvedTablet> three() {
  std::vector<nazori::kanji::StrokeLine> lines(3);
  for (int i = 0; i < 3; ++i)
    lines[static_cast<std::size_t>(i)].points = {{20, 24.5 + 30 * i}, {89, 24.5 + 30 * i}};
  return *nazori::tablet::CarvedTablet::from_lines(nazori::tablet::tablet_lines(lines), 128);
}

TEST(TabletControl, SteppingForwardsGoesThroughEveryStrokeAndWrapsThroughAll) {
  RunningTablet controller;
  controller.set_tablet(three());
  std::vector<int> seen;
  for (int i = 0; i < 5; ++i) {
    controller.next_stroke();
    seen.push_back(controller.current_stroke());
  }
  EXPECT_EQ(seen, (std::vector{1, 2, 3, 0, 1}));
}

TEST(TabletControl, SteppingBackwardsWrapsThroughAllToTheLast) {
  RunningTablet controller;
  controller.set_tablet(three());
  std::vector<int> seen;
  for (int i = 0; i < 5; ++i) {
    controller.previous_stroke();
    seen.push_back(controller.current_stroke());
  }
  EXPECT_EQ(seen, (std::vector{3, 2, 1, 0, 3}));
}

TEST(TabletControl, AButtonDoesWhatItIsSetToDo) {
  using nazori::devices::ButtonDoes;
  RunningTablet controller;
  controller.set_tablet(three());
  controller.press_button(ButtonDoes::next_stroke);
  controller.press_button(ButtonDoes::next_stroke);
  EXPECT_EQ(controller.current_stroke(), 2);
  controller.press_button(ButtonDoes::previous_stroke);
  EXPECT_EQ(controller.current_stroke(), 1);
  controller.press_button(ButtonDoes::nothing);
  controller.press_button(ButtonDoes::clear_ink);
  EXPECT_EQ(controller.current_stroke(), 1);
  controller.press_button(ButtonDoes::all_strokes);
  EXPECT_EQ(controller.current_stroke(), 0);
}

TEST(TabletControl, ItsSwitchesAreSetTogetherAndComeBack) {
  RunningTablet controller;
  controller.set_switches({false, true, false, true});
  EXPECT_FALSE(controller.strokes_visible());
  EXPECT_TRUE(controller.numbers_visible());
  EXPECT_FALSE(controller.arrows_visible());
  EXPECT_TRUE(controller.snapping());
  const auto before = controller.switches();
  controller.set_switches({true, false, true, false});
  EXPECT_TRUE(controller.strokes_visible());
  EXPECT_FALSE(controller.numbers_visible());
  controller.set_switches(before);
  EXPECT_FALSE(controller.strokes_visible());
  EXPECT_TRUE(controller.snapping());
}

TEST(TabletControl, WithoutStrokesSteppingStaysAtAll) {
  RunningTablet controller;
  controller.next_stroke();
  controller.previous_stroke();
  EXPECT_EQ(controller.current_stroke(), 0);
}

TEST(TabletControl, ABrushThatWritesByItselfIsSeenThoughAStylusIsNear) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  controller.move_stylus(TabletPoint{0, 0}, false);
  ASSERT_TRUE(controller.stylus_in_range());
  nazori::practice::Demonstration demonstration;
  demonstration.brush.proxy_m = {0.01, 0.02, 0};
  demonstration.moving = true;
  controller.set_demonstration(demonstration);
  EXPECT_FALSE(controller.draws_stylus());
  ASSERT_TRUE(controller.overlay().cursor);
  EXPECT_EQ(controller.overlay().cursor->proxy_m, demonstration.brush.proxy_m);
  // At rest the learner may feel the groove and sees the position.
  demonstration.moving = false;
  controller.set_demonstration(demonstration);
  EXPECT_TRUE(controller.draws_stylus());
  EXPECT_NE(controller.overlay().cursor->proxy_m, demonstration.brush.proxy_m);
}

TEST(TabletControl, ADrawnStylusIsAsOldAsTheMomentOfFeelingItShows) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  (void)controller.overlay();
  controller.note_drawn();
  EXPECT_EQ(controller.take_drawn_age_s(), 0) << "no stylus in the picture";
  controller.move_stylus(TabletPoint{0, 0}, false);
  ASSERT_TRUE(controller.wait_for([&] { return controller.latest().begun_s > 0; }));
  (void)controller.overlay();
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  controller.note_drawn();
  EXPECT_GE(controller.take_drawn_age_s(), 0.030);
  EXPECT_EQ(controller.take_drawn_age_s(), 0);
}

bool rests(RunningTablet& controller) {
  return controller.wait_for([&] { return controller.device().is_resting(); }, 20'000);
}

TEST(TabletControl, TheServoStandsStillWhileNothingMovesAndGoesOnWithTheNextMove) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  controller.move_stylus(TabletPoint{0, 0}, false);
  ASSERT_TRUE(rests(controller));
  controller.pump();
  const auto before = controller.device().timing();
  const double then_s = controller.latest().time_s;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(controller.device().timing().ticks, before.ticks);
  controller.move_stylus(TabletPoint{0.01, 0}, true);
  EXPECT_FALSE(controller.device().is_resting());
  ASSERT_TRUE(controller.wait_for([&] { return controller.latest().touching; }, 20'000));
  EXPECT_GE(controller.latest().time_s, then_s + 0.05) << "time goes on over the rest";
  EXPECT_LT(controller.device().timing().missed_ticks, before.missed_ticks + 1'000)
      << "a rest misses no tick";
}

TEST(TabletControl, APressedStylusKeepsTheServoAwake) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  controller.move_stylus(TabletPoint{0, 0}, true);
  // Twice the time until a rest begins.
  const auto ticks = controller.device().timing().ticks;
  ASSERT_TRUE(
      controller.wait_for([&] { return controller.device().timing().ticks > ticks + 2'000; }, 60'000));
  EXPECT_FALSE(controller.device().is_resting());
}

TEST(TabletControl, ANewTabletReachesARestingServoSoThatOldOnesAreLetGo) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  ASSERT_TRUE(rests(controller));
  controller.set_tablet(three());
  EXPECT_FALSE(controller.device().is_resting());
  EXPECT_TRUE(rests(controller));
}

TEST(TabletControl, ARecordingKeepsTheServoAwake) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  ASSERT_TRUE(rests(controller));
  controller.device().set_awake(true);
  const auto ticks = controller.device().timing().ticks;
  ASSERT_TRUE(
      controller.wait_for([&] { return controller.device().timing().ticks > ticks + 2'000; }, 60'000));
  controller.device().set_awake(false);
  EXPECT_TRUE(rests(controller));
}

TEST(TabletControl, ANewTabletBeginsWithAllStrokesAndNoInk) {
  RunningTablet controller;
  controller.set_tablet(three());
  controller.next_stroke();
  controller.set_tablet(three());
  EXPECT_EQ(controller.current_stroke(), 0);
  EXPECT_EQ(controller.ink().progress(), (std::vector<double>{0, 0, 0}));
}

TEST(TabletControl, StrokesHoldTheStylusOnlyWhileTheyAreShown) {
  RunningTablet controller;
  controller.set_tablet(three());
  controller.set_snapping(true);
  EXPECT_TRUE(controller.snapping_in_effect());
  controller.set_strokes_visible(false);
  EXPECT_FALSE(controller.snapping_in_effect());
  EXPECT_TRUE(controller.snapping()) << "remembered for when they are shown again";
}

TEST(TabletControl, ChangesAreToldOnceAndOnlyWhenTheyAreChanges) {
  RunningTablet controller;
  controller.set_tablet(three());
  int changes = 0;
  controller.state_changed.connect([&] { ++changes; });
  controller.set_numbers_visible(true);
  EXPECT_EQ(changes, 0);
  controller.set_numbers_visible(false);
  EXPECT_EQ(changes, 1);
}

TEST(TabletControl, PressingInAGrooveTouchesItsBottomAndNotThrough) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  controller.move_stylus({0, 0}, true);
  controller.push_stylus(100);
  EXPECT_TRUE(controller.wait_for(
      [&] { return controller.latest().touching && controller.latest().proxy_m.z < -0.008; }, 3000));
  EXPECT_GE(controller.latest().proxy_m.z, -0.0101);
  EXPECT_LT(controller.latest().device_m.z, controller.latest().proxy_m.z) << "the device itself is deeper";
}

TEST(TabletControl, DrawingAlongAGrooveInksItAndReportsItsEnd) {
  RunningTablet controller;
  controller.set_tablet(three());
  ASSERT_TRUE(controller.start());
  bool finished = false;
  controller.stroke_event.connect(
      [&](TraceEvent event, int) { finished = finished || event == TraceEvent::finished; });
  const auto at = [](double glyph_x) {
    return nazori::geometry::glyph_to_tablet({glyph_x, 24.5}, nazori::geometry::TabletShape{});
  };
  controller.move_stylus(at(20), true);
  ASSERT_TRUE(controller.wait_for([&] { return controller.latest().touching; }, 3000));
  for (double x = 20; x <= 89.5; x += 0.5) {
    controller.move_stylus(at(x), true);
    controller.let_ticks_pass(4);
  }
  EXPECT_TRUE(controller.wait_for(
      [&] {
        controller.pump();
        return controller.ink().is_finished(1);
      },
      3000))
      << controller.ink().progress()[0];
  EXPECT_TRUE(finished);
  EXPECT_EQ(controller.ink().next_stroke(), 2);
}

TEST(TabletControl, WithSnappingTheProxyStaysOnTheStroke) {
  RunningTablet controller;
  controller.set_tablet(three());
  controller.set_snapping(true);
  ASSERT_TRUE(controller.start());
  controller.move_stylus({0, 0.0015}, true);
  ASSERT_TRUE(controller.wait_for([&] { return controller.latest().stroke == 2; }, 3000));
  EXPECT_NEAR(controller.latest().proxy_m.y, 0.0, 1e-4) << "stroke 2 lies on y = 0, the device beside it";
}

TEST(TabletControl, WhatIsPressedOutsideTheTabletDoesNotTouchIt) {
  RunningTablet controller;
  controller.set_tablet(three());
  controller.move_stylus({0.2, 0}, true);
  EXPECT_FALSE(controller.is_pressed());
  EXPECT_FALSE(controller.stylus_in_range());
}

TEST(TabletControl, PenPressureGivesTheDepth) {
  RunningTablet controller;
  controller.set_tablet(three());
  controller.move_stylus({0, 0}, true, 0.2);
  const double light_m = controller.depth_m();
  controller.move_stylus({0, 0}, true, 0.8);
  EXPECT_GT(light_m, 0.0);
  EXPECT_NEAR(controller.depth_m(), 4 * light_m, 1e-9);
}

TEST(TabletControl, TheWheelChangesTheDepthOnlyWhilePressed) {
  RunningTablet controller;
  controller.set_tablet(three());
  controller.push_stylus(1);
  EXPECT_EQ(controller.depth_m(), 0.0);
  controller.move_stylus({0, 0}, true);
  const double before_m = controller.depth_m();
  controller.push_stylus(1);
  EXPECT_GT(controller.depth_m(), before_m);
  controller.push_stylus(-1000);
  EXPECT_GT(controller.depth_m(), 0.0);
}

TEST(TabletControl, WhileWritingIsJudgedOnlyTheHandMovesTheStylus) {
  RunningTablet controller;
  const auto tablet = three();
  controller.set_tablet(tablet);
  controller.set_slope_help(true);
  ASSERT_TRUE(controller.start());
  const nazori::haptics::TabletSurface surface(*tablet->surface(), tablet->shape());
  TabletPoint hand, helped;
  // Out of the middle groove.
  const auto slide = [&] {
    controller.move_stylus({0, 0}, false);
    nazori::devices::SlopeGain help;
    for (int step = 0; step <= 20; ++step) {
      hand = {0, step * 0.00025};
      helped = help.follow(hand, surface);
      controller.move_stylus(hand, true);
    }
  };
  const auto comes_to = [&](const TabletPoint& to) {
    return controller.wait_for(
        [&] {
          const auto& at = controller.latest().device_m;
          return nazori::geometry::distance(TabletPoint{at.x, at.y}, to) < 1e-6;
        },
        10'000);
  };
  slide();
  ASSERT_GT(nazori::geometry::distance(hand, helped), 0.0005);
  EXPECT_TRUE(comes_to(helped));
  controller.set_judged(true);
  slide();
  EXPECT_TRUE(comes_to(hand));
}

TEST(TabletControl, TicksThatCannotBeTrustedDoNotEndAStroke) {
  using nazori::haptics::Vec3;
  const auto script = std::make_shared<nazori::devices::test::Script>();
  RunningTablet controller;
  const auto ticks_pass = [&](std::uint64_t count) {
    const std::uint64_t from = script->ticks;
    return controller.wait_for([&] { return script->ticks > from + count; }, 20'000);
  };
  const auto tablet = three();
  controller.set_tablet(tablet);
  controller.device().set_devices(nazori::devices::test::only(script), tablet->shape(), {});
  ASSERT_TRUE(controller.start());
  controller.device().choose("scripted:arm");
  ASSERT_TRUE(controller.wait_for([&] { return !controller.device().is_pointer(); }, 20'000));
  std::vector<std::pair<TraceEvent, int>> events;
  controller.stroke_event.connect([&](TraceEvent event, int stroke) { events.emplace_back(event, stroke); });
  int distrusted = 0;
  controller.sampled.connect([&](std::span<const nazori::haptics::ServoSample> samples) {
    for (const auto& one : samples)
      distrusted += nazori::haptics::has(one.events, nazori::haptics::ServoEvent::fault);
  });
  const auto hold = [&](const Vec3& at) {
    script->x_m = at.x;
    script->y_m = at.y;
    script->z_m = at.z;
    return ticks_pass(2);
  };
  const auto& path = tablet->paths().front().points;
  const Vec3 below(0, 0, -0.001);
  constexpr int kSteps = 60;
  for (int step = 0; step <= kSteps; ++step) {
    ASSERT_TRUE(hold(glm::mix(path.front(), path.back(), static_cast<double>(step) / kSteps) + below));
    if (step != kSteps / 2) continue;
    controller.pump();
    distrusted = 0;
    script->x_m = std::numeric_limits<double>::quiet_NaN();
    ASSERT_TRUE(ticks_pass(5));
    controller.pump();
    ASSERT_GT(distrusted, 0);
  }
  script->z_m = 0.02;
  ASSERT_TRUE(ticks_pass(2));
  controller.pump();
  EXPECT_EQ(events,
            (std::vector<std::pair<TraceEvent, int>>{{TraceEvent::began, 1}, {TraceEvent::finished, 1}}));
}

}  // namespace
