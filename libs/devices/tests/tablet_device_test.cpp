// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/tablet_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "tablet_device_under_test.h"

namespace nazori::devices {
namespace {

using namespace std::chrono_literals;
using haptics::DeviceState;
using haptics::DeviceTrouble;

/// What a device is given and tells until its end; a base class, so that it outlives the device.
struct GivenAndTold {
  RememberedDevices remembered_;
  std::vector<DeviceEvent> events_;
};

class TabletDeviceTest : protected GivenAndTold, public test::TabletWithAnArm {
 protected:
  using enum DeviceEventKind;

  TabletDeviceTest() {
    device_.happened.connect([this](const DeviceEvent& event) { events_.push_back(event); });
    device_.set_devices(test::only(script_), {}, [this] { return remembered_; });
  }
  [[nodiscard]] int count(DeviceEventKind kind) const {
    return static_cast<int>(
        std::count_if(events_.begin(), events_.end(), [&](const auto& event) { return event.kind == kind; }));
  }
  /// The arm is chosen and active.
  void choose_the_arm() {
    ASSERT_TRUE(device_.start());
    device_.choose("scripted:arm");
    ASSERT_TRUE(comes([&] { return count(searched) == 1; }));
    ASSERT_FALSE(device_.is_pointer());
    events_.clear();
  }
};

TEST_F(TabletDeviceTest, ADeviceThatIsFoundInTheMiddleOfAStrokeWaitsForItsEnd) {
  ASSERT_TRUE(device_.start());
  bool is_pressed = false;
  device_.sampled.connect(
      [&](std::span<const haptics::ServoSample> some) { is_pressed = some.back().buttons != 0; });
  device_.move({0, 0, 0.01, true, true});
  ASSERT_TRUE(comes([&] { return is_pressed; }));
  device_.choose("scripted:arm");
  ASSERT_TRUE(comes([&] { return count(searched) == 1; }));
  ASSERT_EQ(script_->opened, 1);
  EXPECT_TRUE(device_.is_pointer());
  // Long enough for a second check whether the stroke has ended.
  for (int i = 0; i < 5; ++i) pass(100ms);
  EXPECT_TRUE(device_.is_pointer());
  device_.move({0, 0, 0, false, true});
  EXPECT_TRUE(comes([&] { return !device_.is_pointer(); }, 20ms));
  EXPECT_EQ(script_->opened, 1) << "it was open already";
}

TEST_F(TabletDeviceTest, SamplesAreEmittedWhenTheyAreTakenAndNeverNone) {
  ASSERT_TRUE(device_.start());
  std::size_t emitted = 0;
  bool has_emitted_none = false;
  device_.sampled.connect([&](std::span<const haptics::ServoSample> some) {
    emitted += some.size();
    has_emitted_none = has_emitted_none || some.empty();
  });
  device_.move({0, 0, 0, false, true});
  std::size_t all = 0;
  ASSERT_TRUE(comes([&] {
    std::array<haptics::ServoSample, 256> samples;
    const std::size_t before = emitted;
    const std::size_t count = device_.take_samples(samples);
    EXPECT_EQ(emitted - before, count);
    all += count;
    return all > 20;
  }));
  EXPECT_FALSE(has_emitted_none);
}

TEST_F(TabletDeviceTest, APausedDeviceGivesTheTabletToThePointerAndHasItAgainWhenItRuns) {
  choose_the_arm();
  int changes = 0;
  device_.changed.connect([&] { ++changes; });
  script_->trouble = DeviceTrouble::docked;
  script_->state = DeviceState::paused;
  pass(100ms);
  EXPECT_TRUE(device_.is_pointer());
  EXPECT_NE(device_.opened(), nullptr);
  ASSERT_EQ(events_.size(), 1U);
  EXPECT_EQ(events_[0].kind, paused);
  EXPECT_EQ(events_[0].device, "Scripted arm");
  EXPECT_EQ(events_[0].trouble, DeviceTrouble::docked);
  pass(100ms);
  EXPECT_EQ(events_.size(), 1U) << "the same cause is reported once";
  script_->trouble = DeviceTrouble::over_force;
  pass(100ms);
  EXPECT_EQ(count(paused), 2);
  script_->trouble = DeviceTrouble::none;
  script_->state = DeviceState::running;
  pass(99ms);
  EXPECT_TRUE(device_.is_pointer()) << "not before it is due";
  pass(1ms);
  EXPECT_FALSE(device_.is_pointer());
  EXPECT_EQ(count(resumed), 1);
  EXPECT_EQ(changes, 2);
}

TEST_F(TabletDeviceTest, ALostDeviceIsRetriedUntilItIsThereAgain) {
  choose_the_arm();
  script_->plugged_in = false;
  script_->trouble = DeviceTrouble::communication_lost;
  script_->state = DeviceState::lost;
  pass(100ms);
  EXPECT_TRUE(device_.is_pointer());
  EXPECT_EQ(device_.opened(), nullptr);
  EXPECT_EQ(count(lost), 1);
  ASSERT_TRUE(comes([&] { return count(searched) == 1; }));
  script_->state = DeviceState::running;
  script_->trouble = DeviceTrouble::none;
  script_->plugged_in = true;
  pass(2999ms);
  EXPECT_FALSE(device_.is_searching());
  pass(1ms);
  EXPECT_TRUE(device_.is_searching());
  ASSERT_TRUE(comes([&] { return !device_.is_pointer(); }));
  EXPECT_EQ(count(taken), 1);
  EXPECT_EQ(script_->opened, 2);
}

TEST_F(TabletDeviceTest, WhatIsNotThereIsRefusedOnceAndThePointerWrites) {
  script_->plugged_in = false;
  ASSERT_TRUE(device_.start());
  device_.choose("scripted:arm");
  EXPECT_TRUE(device_.is_searching());
  ASSERT_TRUE(comes([&] { return count(searched) == 1; }));
  EXPECT_EQ(count(refused), 1);
  EXPECT_EQ(events_[0].device, "scripted:arm");
  EXPECT_EQ(events_[0].trouble, DeviceTrouble::device_absent);
  pass(3s);
  ASSERT_TRUE(comes([&] { return !device_.is_searching(); }));
  EXPECT_EQ(count(refused), 1) << "retrying is silent";
  device_.choose("pointer");
  EXPECT_EQ(count(searched), 2);
  pass(10s);
  EXPECT_FALSE(device_.is_searching());
}

TEST_F(TabletDeviceTest, AStalledServoIsLostAfterFiveLooks) {
  choose_the_arm();
  script_->plugged_in = false;
  script_->trouble = DeviceTrouble::stalled;
  script_->state = DeviceState::lost;
  for (int i = 0; i < 4; ++i) pass(100ms);
  EXPECT_EQ(count(lost), 0);
  pass(100ms);
  EXPECT_EQ(count(lost), 1);
}

TEST_F(TabletDeviceTest, ThePointerRestsASecondAfterItsLastMoveUnlessItIsPressedOrKeptAwake) {
  ASSERT_TRUE(device_.start());
  device_.move({0, 0, 0, false, true});
  pass(999ms);
  EXPECT_FALSE(device_.is_resting());
  device_.move({0.001, 0, 0, false, true});
  pass(999ms);
  EXPECT_FALSE(device_.is_resting());
  pass(1ms);
  EXPECT_TRUE(device_.is_resting());
  device_.move({0, 0, 0.01, true, true});
  EXPECT_FALSE(device_.is_resting());
  for (int i = 0; i < 5; ++i) pass(1s);
  EXPECT_FALSE(device_.is_resting()) << "it is pressed";
  device_.set_awake(true);
  device_.move({0, 0, 0, false, true});
  for (int i = 0; i < 5; ++i) pass(1s);
  EXPECT_FALSE(device_.is_resting()) << "a recording has no gaps";
  device_.set_awake(false);
  pass(1s);
  EXPECT_TRUE(device_.is_resting());
}

TEST_F(TabletDeviceTest, MovesOfThePointerAskForNoWakingBeforeTheOneThatIsComing) {
  const auto begin = clock_.steady();
  const int before = wakes_;
  ASSERT_TRUE(device_.start());
  ASSERT_EQ(wakes_, before + 1);
  EXPECT_EQ(woken_at_, begin + 1s);
  pass(600ms);
  for (int i = 0; i < 3; ++i) device_.move({0.001 * i, 0, 0, false, true});
  EXPECT_EQ(wakes_, before + 1);
  EXPECT_EQ(woken_at_, begin + 1s);
  pass(400ms);
  EXPECT_FALSE(device_.is_resting());
  EXPECT_EQ(wakes_, before + 2);
  EXPECT_EQ(woken_at_, begin + 1600ms) << "a second after the last move";
  pass(600ms);
  EXPECT_TRUE(device_.is_resting());
  EXPECT_EQ(wakes_, before + 2) << "nothing is due any more";
  EXPECT_FALSE(woken_at_);
}

TEST_F(TabletDeviceTest, EachLookAsksForTheNextOneOnce) {
  choose_the_arm();
  for (int i = 0; i < 5; ++i) {
    const int before = wakes_;
    pass(100ms);
    EXPECT_EQ(wakes_, before + 1) << i;
    EXPECT_EQ(woken_at_, clock_.steady() + 100ms) << i;
  }
}

TEST_F(TabletDeviceTest, ButtonsOfADeviceAreReportedWhenTheyGoDown) {
  script_->buttons = 1;
  choose_the_arm();
  std::vector<int> pressed;
  device_.button_pressed.connect([&](int number) { pressed.push_back(number); });
  const auto ticks_pass = [&](std::uint64_t more) {
    const auto before = script_->ticks.load();
    return comes([&] { return script_->ticks >= before + more; });
  };
  ASSERT_TRUE(ticks_pass(50));
  EXPECT_TRUE(pressed.empty()) << "it was down before the device had the tablet";
  script_->buttons = 0;
  ASSERT_TRUE(ticks_pass(50));
  script_->buttons = 3;
  ASSERT_TRUE(comes([&] { return pressed.size() == 2; }));
  EXPECT_EQ(pressed, (std::vector{0, 1}));
}

TEST_F(TabletDeviceTest, TheLearnersLimitsAndTheStrengthHoldBackTheDevice) {
  choose_the_arm();
  const auto own = device_.own_description().limits;
  EXPECT_EQ(device_.describe().limits.max_force_n, own.max_force_n);
  remembered_["scripted:arm"].max_force_n = own.max_force_n / 2;
  device_.apply_limits();
  EXPECT_EQ(device_.describe().limits.max_force_n, own.max_force_n / 2);
  device_.set_strength(0.1);
  EXPECT_DOUBLE_EQ(device_.describe().limits.max_force_n, own.max_force_n / 20);
  EXPECT_DOUBLE_EQ(device_.describe().limits.max_stiffness_n_m, own.max_stiffness_n_m / 10);
  device_.set_strength(0);
  EXPECT_EQ(device_.strength(), 0.05);
}

TEST_F(TabletDeviceTest, OpenedAgainItStandsAsRemembered) {
  choose_the_arm();
  remembered_["scripted:arm"].posture.tilt_rad = 0.5;
  device_.reopen();
  EXPECT_EQ(device_.reopening(), "scripted:arm");
  EXPECT_TRUE(device_.is_pointer());
  ASSERT_TRUE(comes([&] { return count(searched) == 1; }));
  EXPECT_TRUE(device_.reopening().empty());
  EXPECT_FALSE(device_.is_pointer());
  EXPECT_EQ(script_->asked_tilt_rad, 0.5);
  EXPECT_EQ(script_->opened, 2);
}

TEST_F(TabletDeviceTest, FindingListsTheDeviceAndMayBeEndedBeforeItsAnswer) {
  std::size_t back_ends = 0;
  device_.found.connect([&](const std::vector<BackEndFindings>& findings) { back_ends = findings.size(); });
  device_.find();
  ASSERT_TRUE(comes([&] { return back_ends > 0; }));
  EXPECT_EQ(back_ends, 1U);
  device_.find();
  device_.choose("scripted:arm");
}

}  // namespace
}  // namespace nazori::devices
