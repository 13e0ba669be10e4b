// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_setup.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "tablet_device_under_test.h"

namespace nazori::devices {
namespace {

using namespace std::chrono_literals;
using haptics::DeviceState;
using haptics::DeviceTrouble;

BackEndFindings found(const std::string& name, std::vector<FoundDevice> devices,
                      DeviceTrouble trouble = DeviceTrouble::none) {
  BackEndFindings made{name, std::move(devices), std::nullopt};
  if (trouble != DeviceTrouble::none) made.problem = {trouble, {base::Errc::device, "what", "", "do this"}};
  return made;
}

DeviceMemory chosen(const std::string& id) {
  DeviceMemory memory;
  memory.chosen = id;
  return memory;
}

/// "id|name", "+" in use, "-" not connected, "*" chosen.
std::vector<std::string> rows(const DeviceChoices& choices) {
  std::vector<std::string> all;
  for (const auto& one : choices.devices)
    all.push_back(one.id + "|" + one.name + (one.state == DeviceChoice::State::in_use ? "+" : "") +
                  (one.state == DeviceChoice::State::not_connected ? "-" : "") + (one.chosen ? "*" : ""));
  return all;
}

TEST(DeviceChoices, TheBestComesFirstThenWhatWasFound) {
  const std::vector arms{found("Arms", {{"a:1", "One", true, true}, {"a:2", "Two", true, true}})};
  EXPECT_EQ(rows(device_choices(arms, {}, "a:2", "Two")),
            (std::vector<std::string>{"|*", "a:1|One", "a:2|Two+"}));
  EXPECT_EQ(rows(device_choices(arms, chosen("a:1"), "pointer", "Mouse")),
            (std::vector<std::string>{"|", "a:1|One*", "a:2|Two", "pointer|Mouse+"}));
}

TEST(DeviceChoices, WhatIsInUseAndWhatWasChosenAreListedThoughTheyWereNotFound) {
  EXPECT_EQ(rows(device_choices({}, chosen("gone:1"), "pointer", "Mouse")),
            (std::vector<std::string>{"|", "pointer|Mouse+", "gone:1|gone:1-*"}));
  EXPECT_EQ(rows(device_choices({}, chosen("pointer"), "pointer", "Mouse")),
            (std::vector<std::string>{"|", "pointer|Mouse+*"}));
}

TEST(DeviceChoices, ADeviceThatIsNotConnectedHasTheNameThatItHadWhenItWas) {
  DeviceMemory memory = chosen("gone:1");
  memory.devices["gone:1"].name = "Touch (serial 12345)";
  EXPECT_EQ(rows(device_choices({}, memory, "pointer", "Mouse")),
            (std::vector<std::string>{"|", "pointer|Mouse+", "gone:1|Touch (serial 12345)-*"}));
}

TEST(DeviceChoices, AProblemThatOurOwnUseOfTheDeviceCausesIsNotShown) {
  const std::vector all{found("Ours", {{"a:1", "One", true, true}}, DeviceTrouble::in_use),
                        found("Others", {{"o:1", "Other", true, true}}, DeviceTrouble::in_use),
                        found("Third", {}, DeviceTrouble::no_permission), found("Fine", {})};
  const auto choices = device_choices(all, {}, "a:1", "One");
  ASSERT_EQ(choices.problems.size(), 2U);
  EXPECT_EQ(choices.problems[0].back_end, "Others");
  EXPECT_EQ(choices.problems[1].back_end, "Third");
  EXPECT_EQ(device_choices({found("Ours", {{"a:1", "One", true, true}}, DeviceTrouble::no_permission)}, {},
                           "a:1", "One")
                .problems.size(),
            1U);
}

/// A tablet with an arm that the test moves, and how a learner sets it up. Deadlines follow the test's clock;
/// the servos run in real time.
class DeviceSetupTest : public test::TabletWithAnArm {
 protected:
  using enum DeviceNewsKind;

  DeviceSetupTest() {
    setup_.news.connect([this](const DeviceNews& news) { news_.push_back(news); });
    setup_.settled.connect([this] { ++settled_; });
  }
  [[nodiscard]] bool settles() {
    const bool came = comes([this] { return !device_.is_searching() && settled_ > 0; });
    settled_ = 0;
    return came;
  }
  void choose_the_arm() {
    ASSERT_TRUE(device_.start());
    setup_.choose("scripted:arm");
    ASSERT_TRUE(settles());
    ASSERT_FALSE(device_.is_pointer());
    news_.clear();
  }
  void point_at(double x_m, double y_m) {
    script_->x_m = x_m;
    script_->y_m = y_m;
    script_->z_m = 0;
    ASSERT_TRUE(comes([&] {
      const auto at = device_.latest().device_m;
      return std::abs(at.x - x_m) < 1e-9 && std::abs(at.y - y_m) < 1e-9;
    }));
  }

  std::vector<DeviceNews> news_;
  int settled_ = 0;
  DeviceSetup setup_{device_, test::only(script_)};
};

TEST_F(DeviceSetupTest, TheChosenDeviceIsRememberedAndReported) {
  ASSERT_TRUE(device_.start());
  EXPECT_EQ(setup_.id_in_use(), "pointer");
  setup_.choose("scripted:arm");
  EXPECT_EQ(setup_.memory().chosen, "scripted:arm");
  ASSERT_TRUE(settles());
  EXPECT_EQ(setup_.id_in_use(), "scripted:arm");
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_EQ(news_[0].kind, in_use);
  EXPECT_EQ(news_[0].device, "Scripted arm");
  EXPECT_EQ(setup_.memory().devices.at("scripted:arm").name, "Scripted arm");
}

TEST_F(DeviceSetupTest, ADeviceThatCannotBeOpenedIsReportedOnceWhenTheSearchHasEnded) {
  script_->plugged_in = false;
  ASSERT_TRUE(device_.start());
  setup_.choose("scripted:arm");
  ASSERT_TRUE(settles());
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_EQ(news_[0].kind, missing);
  EXPECT_EQ(news_[0].missing.device, "scripted:arm");
  EXPECT_EQ(news_[0].missing.trouble, DeviceTrouble::device_absent);
  EXPECT_FALSE(news_[0].missing.message.empty());
}

TEST_F(DeviceSetupTest, TheDeviceThatReplacesAnotherIsReportedWithTheTrouble) {
  ASSERT_TRUE(device_.start());
  setup_.choose("gone:1");
  ASSERT_TRUE(settles());
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_EQ(news_[0].kind, replaced);
  EXPECT_EQ(news_[0].device, "Scripted arm");
  EXPECT_EQ(news_[0].missing.device, "gone:1");
}

TEST_F(DeviceSetupTest, APauseAndItsEndAreReported) {
  choose_the_arm();
  script_->trouble = DeviceTrouble::docked;
  script_->state = DeviceState::paused;
  pass(100ms);
  script_->trouble = DeviceTrouble::none;
  script_->state = DeviceState::running;
  pass(100ms);
  ASSERT_EQ(news_.size(), 2U);
  EXPECT_EQ(news_[0].kind, missing);
  EXPECT_EQ(news_[0].missing.device, "Scripted arm");
  EXPECT_EQ(news_[0].missing.trouble, DeviceTrouble::docked);
  EXPECT_TRUE(news_[0].missing.message.empty());
  EXPECT_EQ(news_[1].kind, works_again);
  EXPECT_EQ(news_[1].device, "Scripted arm");
}

TEST_F(DeviceSetupTest, APostureForgetsTheCalibrationAndHoldsWhenItIsApplied) {
  choose_the_arm();
  setup_.fit();
  ASSERT_TRUE(settles());
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_EQ(news_[0].kind, changed);
  EXPECT_EQ(news_[0].change, DeviceChange::automatic_fit);
  news_.clear();
  TabletPosture posture;
  posture.tilt_rad = 0.5;
  setup_.set_posture(posture);
  EXPECT_EQ(setup_.settings().posture.tilt_rad, 0.5);
  EXPECT_FALSE(setup_.settings().calibration);
  EXPECT_NE(script_->asked_tilt_rad, 0.5) << "the device is not opened again yet";
  setup_.apply(DeviceChange::posture);
  ASSERT_TRUE(settles());
  EXPECT_EQ(script_->asked_tilt_rad, 0.5);
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_EQ(news_[0].change, DeviceChange::posture);
  // The next use of it is no change.
  script_->state = DeviceState::paused;
  script_->trouble = DeviceTrouble::docked;
  pass(100ms);
  script_->state = DeviceState::running;
  script_->trouble = DeviceTrouble::none;
  pass(100ms);
  EXPECT_EQ(news_.back().kind, works_again);
}

TEST_F(DeviceSetupTest, AChangeWithoutADeviceIsKeptForTheDevice) {
  ASSERT_TRUE(device_.start());
  setup_.apply(DeviceChange::posture);
  EXPECT_FALSE(device_.is_searching());
  setup_.set_buttons({ButtonDoes::clear_ink, ButtonDoes::nothing});
  EXPECT_EQ(setup_.memory().devices.at("pointer").buttons[0], ButtonDoes::clear_ink);
  EXPECT_EQ(setup_.action_of(0), ButtonDoes::nothing) << "mouse and pen have no buttons of a stylus";
}

TEST_F(DeviceSetupTest, ButtonsDoWhatTheLearnerChose) {
  choose_the_arm();
  setup_.set_buttons({ButtonDoes::clear_ink, ButtonDoes::previous_stroke});
  EXPECT_EQ(setup_.action_of(0), ButtonDoes::clear_ink);
  EXPECT_EQ(setup_.action_of(1), ButtonDoes::previous_stroke);
  EXPECT_EQ(setup_.action_of(2), ButtonDoes::nothing);
  EXPECT_EQ(setup_.action_of(-1), ButtonDoes::nothing);
}

TEST_F(DeviceSetupTest, LimitsAndStrengthHoldAtOnce) {
  choose_the_arm();
  setup_.set_limits(1.5, 300);
  EXPECT_DOUBLE_EQ(device_.describe().limits.max_force_n, 1.5);
  EXPECT_EQ(setup_.memory().devices.at("scripted:arm").max_stiffness_n_m, 300);
  EXPECT_FALSE(setup_.can_be_stronger());
  EXPECT_TRUE(setup_.can_be_weaker());
  setup_.set_strength(0);
  EXPECT_DOUBLE_EQ(device_.strength(), DeviceSetup::kTrialStep);
  EXPECT_TRUE(setup_.can_be_stronger());
  EXPECT_FALSE(setup_.can_be_weaker());
  setup_.change_strength(+1);
  EXPECT_NEAR(device_.strength(), 2 * DeviceSetup::kTrialStep, 1e-9);
  EXPECT_TRUE(setup_.can_be_weaker());
  setup_.change_strength(-2);
  EXPECT_DOUBLE_EQ(device_.strength(), DeviceSetup::kTrialStep);
  setup_.change_strength(+30);
  EXPECT_DOUBLE_EQ(device_.strength(), 1);
}

TEST_F(DeviceSetupTest, WithoutADeviceNothingIsTriedOrCalibrated) {
  ASSERT_TRUE(device_.start());
  EXPECT_FALSE(setup_.can_be_stronger());
  EXPECT_FALSE(setup_.can_be_weaker());
  EXPECT_FALSE(setup_.begin_calibration());
  EXPECT_EQ(setup_.corner(), -1);
  EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::no_device);
}

TEST_F(DeviceSetupTest, ThreeCornersPutTheTabletWhereTheyWere) {
  choose_the_arm();
  ASSERT_TRUE(setup_.begin_calibration());
  EXPECT_EQ(setup_.corner(), 0);
  point_at(-0.04, -0.03);
  EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::next);
  EXPECT_EQ(setup_.corner(), 1);
  point_at(0.02, -0.03);
  EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::next);
  point_at(-0.04, 0.03);
  EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::done);
  EXPECT_EQ(setup_.corner(), -1);
  const auto& saved = setup_.memory().devices.at("scripted:arm");
  ASSERT_TRUE(saved.calibration);
  EXPECT_NEAR(saved.calibration->centre_m.x, -0.01, 1e-9);
  EXPECT_NEAR(saved.calibration->centre_m.y, 0, 1e-9);
  ASSERT_TRUE(settles());
  EXPECT_TRUE(script_->asked_calibrated);
  EXPECT_EQ(news_.back().change, DeviceChange::corners);
}

TEST_F(DeviceSetupTest, CornersThatFormNoTabletChangeNothing) {
  choose_the_arm();
  ASSERT_TRUE(setup_.begin_calibration());
  for (int i = 0; i < 2; ++i) EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::next);
  EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::no_tablet) << "all of them at one place";
  EXPECT_EQ(setup_.corner(), -1);
  EXPECT_FALSE(setup_.settings().calibration);
  ASSERT_TRUE(setup_.begin_calibration());
  setup_.stop_calibration();
  EXPECT_EQ(setup_.corner(), -1);
}

TEST_F(DeviceSetupTest, ADeviceThatPausesDuringACalibrationEndsIt) {
  choose_the_arm();
  ASSERT_TRUE(setup_.begin_calibration());
  script_->trouble = DeviceTrouble::docked;
  script_->state = DeviceState::paused;
  pass(100ms);
  EXPECT_EQ(setup_.add_corner(), DeviceSetup::Corner::no_device);
  EXPECT_EQ(setup_.corner(), -1);
}

TEST_F(DeviceSetupTest, TheDeviceGoesOnWithoutIt) {
  ASSERT_TRUE(device_.start());
  int heard = 0;
  {
    DeviceSetup other(device_, test::only(script_));
    other.news.connect([&heard](const DeviceNews&) { ++heard; });
  }
  int events = 0;
  device_.happened.connect([&events](const DeviceEvent&) { ++events; });
  device_.choose("scripted:arm");
  ASSERT_TRUE(comes([&] { return events >= 2; }));
  EXPECT_EQ(heard, 0);
}

TEST_F(DeviceSetupTest, WhatWasSavedIsLoaded) {
  base::Settings saved;
  DeviceMemory memory;
  memory.chosen = "scripted:arm";
  memory.material.texture = haptics::Texture::wood;
  memory.save(saved);
  setup_.load(saved);
  EXPECT_EQ(setup_.memory().material.texture, haptics::Texture::wood);
  haptics::Material stone;
  stone.texture = haptics::Texture::stone;
  setup_.set_material(stone);
  EXPECT_EQ(setup_.memory().material.texture, haptics::Texture::stone);
  ASSERT_TRUE(device_.start());
  setup_.open_chosen();
  ASSERT_TRUE(settles());
  EXPECT_EQ(setup_.id_in_use(), "scripted:arm");
}

}  // namespace
}  // namespace nazori::devices
