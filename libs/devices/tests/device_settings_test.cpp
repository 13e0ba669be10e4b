// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace nazori::devices {
namespace {

/// What is stored, as the window stores it in a file.
class StoredDevices : public testing::Test {
 protected:
  void save(const DeviceMemory& memory) { memory.save(stored_); }
  [[nodiscard]] DeviceMemory load() const {
    DeviceMemory memory;
    memory.load(stored_);
    return memory;
  }
  /// As a person might write it into the file.
  void write(const std::string& key, const std::string& value) { stored_.insert_or_assign(key, value); }
  static std::string known(const char* key) { return std::string("known/61726d3a31/") + key; }  // arm:1
  base::Settings stored_;
};

TEST_F(StoredDevices, HoldsEachDeviceTheMaterialAndTheChoice) {
  DeviceMemory memory;
  memory.chosen = "inverse3:049D";
  memory.material = {0.1, 0.2, 0.4, 0.3, 0.6, haptics::Texture::stone, 0.7};
  memory.tip_radius_m = 0.0017;
  DeviceSettings& arm = memory.devices["arm/1: Ä"];
  arm.posture = {0.5, -1.25, WritingHand::left};
  arm.calibration = WorkspaceCalibration{1.5, {0.1, -0.2, 0.3}, arm.posture, 0.75};
  arm.max_force_n = 1.5;
  arm.max_stiffness_n_m = 250;
  arm.buttons = {ButtonDoes::clear_ink, ButtonDoes::nothing};
  arm.name = "Touch (serial 12345)";
  memory.devices["pointer"].buttons = {ButtonDoes::previous_stroke, ButtonDoes::next_stroke};
  save(memory);
  const auto buttons = std::count_if(stored_.begin(), stored_.end(), [](const auto& one) {
    return one.first.find("/button_") != std::string::npos;
  });
  EXPECT_EQ(buttons, 4) << "two of each device";
  const DeviceMemory read = load();
  EXPECT_EQ(read.chosen, memory.chosen);
  EXPECT_EQ(read.material.stiffness, 0.1);
  EXPECT_EQ(read.material.damping, 0.2);
  EXPECT_EQ(read.material.static_friction, 0.4);
  EXPECT_EQ(read.material.dynamic_friction, 0.3);
  EXPECT_EQ(read.material.popthrough, 0.6);
  EXPECT_EQ(read.material.texture, haptics::Texture::stone);
  EXPECT_EQ(read.material.roughness, 0.7);
  EXPECT_NEAR(read.tip_radius_m, 0.0017, 1e-15);
  ASSERT_EQ(read.devices.size(), 2U);
  const DeviceSettings again = settings_of(read.devices, "arm/1: Ä");
  EXPECT_EQ(again.posture.tilt_rad, 0.5);
  EXPECT_EQ(again.posture.yaw_rad, -1.25);
  EXPECT_EQ(again.posture.hand, WritingHand::left);
  ASSERT_TRUE(again.calibration);
  EXPECT_EQ(again.calibration->scale, 1.5);
  EXPECT_EQ(again.calibration->centre_m, (haptics::Vec3{0.1, -0.2, 0.3}));
  EXPECT_EQ(again.calibration->roll_rad, 0.75);
  EXPECT_EQ(again.calibration->posture.yaw_rad, -1.25);
  EXPECT_EQ(again.max_force_n, 1.5);
  EXPECT_EQ(again.max_stiffness_n_m, 250);
  EXPECT_EQ(again.buttons, arm.buttons);
  EXPECT_EQ(again.name, "Touch (serial 12345)");
  const DeviceSettings other = settings_of(read.devices, "pointer");
  EXPECT_EQ(other.buttons, (std::array{ButtonDoes::previous_stroke, ButtonDoes::next_stroke}));
  EXPECT_EQ(other.posture.hand, WritingHand::right);
  EXPECT_FALSE(other.calibration);
}

TEST_F(StoredDevices, ForgetsACalibrationThatIsGone) {
  DeviceMemory memory;
  memory.devices["arm:1"].calibration = WorkspaceCalibration{};
  save(memory);
  ASSERT_TRUE(settings_of(load().devices, "arm:1").calibration);
  memory.devices["arm:1"].calibration.reset();
  save(memory);
  EXPECT_FALSE(settings_of(load().devices, "arm:1").calibration);
}

TEST_F(StoredDevices, OfAnEmptyFileIsWhatADeviceHasAtFirst) {
  const DeviceMemory read = load();
  EXPECT_TRUE(read.chosen.empty());
  EXPECT_TRUE(read.devices.empty());
  EXPECT_EQ(read.material.stiffness, haptics::Material{}.stiffness);
  EXPECT_EQ(read.material.roughness, haptics::Material{}.roughness);
  const DeviceSettings first;
  EXPECT_EQ(first.buttons, (std::array{ButtonDoes::next_stroke, ButtonDoes::all_strokes}));
  EXPECT_EQ(first.max_force_n, 0);
  EXPECT_EQ(first.max_stiffness_n_m, 0);
}

TEST_F(StoredDevices, KeepsWhatMakesSenseOfAFileThatDoesNot) {
  write(known("tilt"), "7");
  write(known("yaw"), "-7");
  write(known("hand"), "both");
  write(known("button_1"), "explode");
  write(known("button_2"), "clear_ink");
  write(known("max_force_n"), "-3");
  write(known("max_stiffness_n_m"), "nan");
  write(known("scale"), "0");  // no tablet can be so small
  write("material_stiffness", "1.5");
  write("material_damping", "-0.5");
  write("material_static_friction", "0.25");
  write("material_dynamic_friction", "0.75");
  write("material_roughness", "rough");
  write("material_texture", "velvet");
  write("tip_radius_mm", "3.5");
  const DeviceMemory read = load();
  const DeviceSettings arm = settings_of(read.devices, "arm:1");
  EXPECT_EQ(arm.posture.tilt_rad, 2);
  EXPECT_EQ(arm.posture.yaw_rad, -2);
  EXPECT_EQ(arm.posture.hand, WritingHand::right);
  EXPECT_EQ(arm.buttons, (std::array{ButtonDoes::next_stroke, ButtonDoes::clear_ink}));
  EXPECT_EQ(arm.max_force_n, 0);
  EXPECT_EQ(arm.max_stiffness_n_m, 0);
  EXPECT_FALSE(arm.calibration);
  EXPECT_EQ(read.material.stiffness, 1);
  EXPECT_EQ(read.material.damping, 0);
  EXPECT_EQ(read.material.dynamic_friction, 0.25) << "what slides is never held more than what rests";
  EXPECT_EQ(read.material.roughness, haptics::Material{}.roughness);
  EXPECT_EQ(read.material.texture, haptics::Texture::none);
  EXPECT_EQ(read.tip_radius_m, 0.003);
  write("tip_radius_mm", "-1");
  EXPECT_EQ(load().tip_radius_m, 0);
  write("tip_radius_mm", "wide");
  EXPECT_EQ(load().tip_radius_m, 0);
}

TEST_F(StoredDevices, HoldsPosturesBackOnTheOtherSideToo) {
  write(known("tilt"), "-1");
  write(known("yaw"), "7");
  write(known("max_force_n"), "5000");
  write(known("max_stiffness_n_m"), "5e6");
  const DeviceSettings arm = settings_of(load().devices, "arm:1");
  EXPECT_EQ(arm.posture.tilt_rad, 0);
  EXPECT_EQ(arm.posture.yaw_rad, 2);
  EXPECT_EQ(arm.max_force_n, 1000);
  EXPECT_EQ(arm.max_stiffness_n_m, 1e6);
}

TEST_F(StoredDevices, NamesEachMeaningOfAButtonAndEachTexture) {
  using enum ButtonDoes;
  for (const ButtonDoes does : {nothing, next_stroke, previous_stroke, all_strokes, clear_ink}) {
    DeviceMemory memory;
    memory.devices["a"].buttons = {does, does};
    save(memory);
    EXPECT_EQ(settings_of(load().devices, "a").buttons, (std::array{does, does}));
  }
  using enum haptics::Texture;
  for (const haptics::Texture texture : {none, paper, wood, stone}) {
    DeviceMemory memory;
    memory.material.texture = texture;
    save(memory);
    EXPECT_EQ(load().material.texture, texture);
  }
}

TEST_F(StoredDevices, LeavesOtherKeysAsTheyAre) {
  write("inverse_port", "10002");
  write("known/zz/tilt", "1");
  write("known/6", "1");
  write("known/61", "1");     // no setting of a device, whose keys have a name after its id
  write("known/6g/", "1");    // no hexadecimal digits
  write("known/616/x", "1");  // half a byte too many
  EXPECT_TRUE(load().devices.empty());
  save(load());
  EXPECT_EQ(stored_.at("inverse_port"), "10002");
  EXPECT_EQ(stored_.at("known/zz/tilt"), "1");
}

TEST(LimitsOfADevice, AreTheSmallerOfItsOwnAndTheLearners) {
  haptics::DeviceLimits own;
  own.max_force_n = 3;
  own.continuous_force_n = 1;
  own.max_stiffness_n_m = 400;
  EXPECT_EQ(limited(own, {}).max_force_n, 3);
  EXPECT_EQ(limited(own, {}).continuous_force_n, 1);
  EXPECT_EQ(limited(own, {}).max_stiffness_n_m, 400);
  DeviceSettings less;
  less.max_force_n = 2;
  EXPECT_EQ(limited(own, less).max_force_n, 2);
  EXPECT_EQ(limited(own, less).continuous_force_n, 1) << "it holds that for long";
  EXPECT_EQ(limited(own, less).max_stiffness_n_m, 400);
  less.max_force_n = 0.5;
  less.max_stiffness_n_m = 100;
  EXPECT_EQ(limited(own, less).max_force_n, 0.5);
  EXPECT_EQ(limited(own, less).continuous_force_n, 0.5);
  EXPECT_EQ(limited(own, less).max_stiffness_n_m, 100);
}

}  // namespace
}  // namespace nazori::devices
