// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/simulated_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "nazori/tablet/carved_tablet.h"

namespace nazori::devices {
namespace {

using kanji::StrokeEnding;

/// A stroke across of 60 glyph units, and a dot.
std::shared_ptr<const tablet::CarvedTablet> across_and_dot() {
  return *tablet::CarvedTablet::from_lines(
      tablet::tablet_lines(std::vector<kanji::StrokeLine>{{{{20, 40}, {80, 40}}, StrokeEnding::stop, {}},
                                                          {{{60, 75}, {66, 81}}, StrokeEnding::stop, {}}}),
      256);
}

std::vector<std::shared_ptr<const haptics::HapticScene>> scenes_of(const tablet::CarvedTablet& tablet,
                                                                   bool snapping) {
  std::vector<std::shared_ptr<const haptics::HapticScene>> scenes;
  for (int stroke = 0; stroke <= static_cast<int>(tablet.paths().size()); ++stroke) {
    haptics::Snapping snap;
    snap.enabled = snapping && stroke > 0;
    snap.stroke = stroke;
    scenes.push_back(tablet.scene({}, snap));
  }
  return scenes;
}

const SimulatedHardware kTouch = SimulatedHardware::touch();

TEST(SimulatedHand, FollowsEveryStrokeInItsGroove) {
  const auto tablet = across_and_dot();
  SimulatedHand hand(tablet->paths(), scenes_of(*tablet, false), kTouch);
  double last = -1;
  const auto ended = hand.run(HandClock::none, [&](double done, std::string_view) {
    EXPECT_GE(done, last);
    last = done;
    return true;
  });
  ASSERT_TRUE(ended);
  const HandReport report = hand.report();
  ASSERT_EQ(report.strokes.size(), 2U);
  const FollowedStroke& across = report.strokes[0];
  EXPECT_EQ(across.stroke, 1);
  EXPECT_NEAR(across.length_m, 0.1 * 60 / 109, 0.002);
  // One movement from rest to rest, 1.5 times as long as at constant speed, and a halt.
  EXPECT_NEAR(across.duration_s, 1.5 * across.length_m / HandHabits{}.speed_m_s + 0.15, 1e-9);
  EXPECT_GT(across.followed_share, 0.9);
  EXPECT_LT(across.tip_rms_m, 0.003);
  EXPECT_GT(across.aim_rms_m, 0.0002);
  EXPECT_GT(across.contact_share, 0.9);
  EXPECT_EQ(across.snapped_share, 0);
  EXPECT_EQ(across.slips, 0);
  EXPECT_GT(across.mean_depth_m, 0.002);
  EXPECT_LE(report.strokes[1].peak_force_n, kTouch.limits.max_force_n + 1e-9);
  EXPECT_LT(report.work_on_hand_j, 1e-4) << "a tablet gives no energy";
  EXPECT_FALSE(report.clock.real_time);
}

TEST(SimulatedHand, IsHeldByTheStrokeThatItIsAtWhereItsSceneSnaps) {
  const auto tablet = across_and_dot();
  SimulatedHand hand(tablet->paths(), scenes_of(*tablet, true), kTouch);
  ASSERT_TRUE(hand.run(HandClock::none, {}));
  for (const FollowedStroke& stroke : hand.report().strokes) EXPECT_GT(stroke.snapped_share, 0.9);
}

TEST(SimulatedHand, PullsHarderWhereFrictionHoldsTheTipBack) {
  struct Reached final : HandObserver {
    void see(const haptics::ServoSample& sample) noexcept override {
      if (sample.touching) right_m = std::max(right_m, sample.proxy_m.x);
    }
    double right_m = -1;
  };
  const auto tablet = across_and_dot();
  haptics::Material rough;
  rough.static_friction = rough.dynamic_friction = 0.8;
  const auto scene = tablet->scene(rough, {});
  const std::vector across{tablet->paths()[0]};
  Reached reached;
  SimulatedHand hand(across, {scene, scene}, kTouch, &reached);
  ASSERT_TRUE(hand.run(HandClock::none, {}));
  // The hand presses with 0.7 N and draws with 120 N/m: held back by eight tenths of the first, the tip would
  // stop almost 5 mm before the end.
  EXPECT_NEAR(reached.right_m, across[0].points.back().x, 0.0015);
}

TEST(SimulatedHand, ShowsEveryTickToItsObserverAndDoesTheSameAgain) {
  struct Sums final : HandObserver {
    void see(const haptics::ServoSample& sample) noexcept override {
      ++ticks;
      x_m += sample.proxy_m.x;
    }
    std::uint64_t ticks = 0;
    double x_m = 0;
  };
  const auto tablet = across_and_dot();
  const auto follow = [&] {
    Sums sums;
    SimulatedHand hand(tablet->paths(), scenes_of(*tablet, false), kTouch, &sums);
    EXPECT_TRUE(hand.run(HandClock::none, {}));
    EXPECT_EQ(sums.ticks, hand.report().timing.ticks);
    return sums;
  };
  const Sums once = follow();
  const Sums again = follow();
  EXPECT_GT(once.ticks, 1000U);
  EXPECT_EQ(once.ticks, again.ticks);
  EXPECT_EQ(once.x_m, again.x_m);
}

TEST(SimulatedHand, StopsWhenItIsToldTo) {
  const auto tablet = across_and_dot();
  SimulatedHand hand(tablet->paths(), scenes_of(*tablet, false), kTouch);
  const auto ended = hand.run(HandClock::none, [](double done, std::string_view) { return done < 0.3; });
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, base::Errc::cancelled);
  EXPECT_EQ(hand.report().strokes[1].contact_share, 0) << "it did not come to the second stroke";
}

TEST(SimulatedHand, IsAskedWhetherToGoOnAtTheFirstTickAndEach256thAfterIt) {
  const auto tablet = across_and_dot();
  for (const int questions : {1, 2, 3}) {
    SimulatedHand hand(tablet->paths(), scenes_of(*tablet, false), kTouch);
    int asked = 0;
    EXPECT_FALSE(hand.run(HandClock::none, [&](double, std::string_view) { return ++asked < questions; }));
    EXPECT_EQ(asked, questions);
    EXPECT_EQ(hand.report().timing.ticks, 1U + 256U * static_cast<unsigned>(questions - 1));
  }
}

TEST(SimulatedHand, WithoutStrokesOrPointsNothingFails) {
  const auto tablet = across_and_dot();
  const auto scene = tablet->scene({}, {});
  SimulatedHand none({}, {scene}, kTouch);
  EXPECT_TRUE(none.report().strokes.empty());
  const std::vector<haptics::StrokePath> empty(1);
  SimulatedHand dot(empty, {scene, scene}, kTouch);
  ASSERT_TRUE(dot.run(HandClock::none, {}));
  EXPECT_EQ(dot.report().strokes[0].length_m, 0);
}

TEST(SimulatedHand, OnTheClockThreadItCanBeStopped) {
  const auto tablet = across_and_dot();
  SimulatedHand hand(tablet->paths(), scenes_of(*tablet, false), kTouch);
  const auto ended =
      hand.run(HandClock::real_time, [](double done, std::string_view) { return done < 0.01; });
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, base::Errc::cancelled);
  EXPECT_GT(hand.report().timing.ticks, 0U);
}

}  // namespace
}  // namespace nazori::devices
