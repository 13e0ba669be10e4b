// SPDX-License-Identifier: Apache-2.0
#include "device_settings.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>

#include "device_text.h"

namespace nazori::ui {
namespace {

class RememberedDevices : public testing::Test {
 protected:
  [[nodiscard]] QString file() const { return folder_.filePath(QStringLiteral("nazori.ini")); }
  void save(const DeviceMemory& memory) const {
    QSettings settings(file(), QSettings::IniFormat);
    settings.beginGroup(QStringLiteral("device"));
    memory.save(settings);
  }
  [[nodiscard]] DeviceMemory load() const {
    QSettings settings(file(), QSettings::IniFormat);
    settings.beginGroup(QStringLiteral("device"));
    DeviceMemory memory;
    memory.load(settings);
    EXPECT_EQ(settings.group(), QStringLiteral("device")) << "it stands where it stood";
    return memory;
  }
  /// As a hand might write it into the file.
  void write(const QString& key, const QVariant& value) const {
    QSettings settings(file(), QSettings::IniFormat);
    settings.setValue(QStringLiteral("device/") + key, value);
  }
  static QString known(const char* key) {
    return QStringLiteral("known/%1/%2")
        .arg(QString::fromLatin1(QByteArray("arm:1").toHex()), QString::fromLatin1(key));
  }
  QTemporaryDir folder_;
};

TEST_F(RememberedDevices, HoldsEachDeviceTheMaterialAndTheChoice) {
  DeviceMemory memory;
  memory.chosen = QStringLiteral("inverse3:049D");
  memory.material = {0.1, 0.2, 0.4, 0.3, 0.6, haptics::Texture::stone, 0.7};
  DeviceSettings& arm = memory.devices[QStringLiteral("arm/1: Ä")];
  arm.posture = {0.5, -1.25, devices::WritingHand::left};
  arm.calibration = devices::WorkspaceCalibration{1.5, {0.1, -0.2, 0.3}, arm.posture, 0.75};
  arm.max_force_n = 1.5;
  arm.max_stiffness_n_m = 250;
  arm.buttons = {ButtonDoes::clear_ink, ButtonDoes::nothing};
  memory.devices[QStringLiteral("pointer")].buttons = {ButtonDoes::previous_stroke, ButtonDoes::next_stroke};
  save(memory);
  const DeviceMemory read = load();
  EXPECT_EQ(read.chosen, memory.chosen);
  EXPECT_EQ(read.material.stiffness, 0.1);
  EXPECT_EQ(read.material.damping, 0.2);
  EXPECT_EQ(read.material.static_friction, 0.4);
  EXPECT_EQ(read.material.dynamic_friction, 0.3);
  EXPECT_EQ(read.material.popthrough, 0.6);
  EXPECT_EQ(read.material.texture, haptics::Texture::stone);
  EXPECT_EQ(read.material.roughness, 0.7);
  ASSERT_EQ(read.devices.size(), 2);
  const DeviceSettings again = read.devices.value(QStringLiteral("arm/1: Ä"));
  EXPECT_EQ(again.posture.tilt_rad, 0.5);
  EXPECT_EQ(again.posture.yaw_rad, -1.25);
  EXPECT_EQ(again.posture.hand, devices::WritingHand::left);
  ASSERT_TRUE(again.calibration);
  EXPECT_EQ(again.calibration->scale, 1.5);
  EXPECT_EQ(again.calibration->centre_m, (haptics::Vec3{0.1, -0.2, 0.3}));
  EXPECT_EQ(again.calibration->roll_rad, 0.75);
  EXPECT_EQ(again.calibration->posture.yaw_rad, -1.25);
  EXPECT_EQ(again.max_force_n, 1.5);
  EXPECT_EQ(again.max_stiffness_n_m, 250);
  EXPECT_EQ(again.buttons, arm.buttons);
  const DeviceSettings other = read.devices.value(QStringLiteral("pointer"));
  EXPECT_EQ(other.buttons, (std::array{ButtonDoes::previous_stroke, ButtonDoes::next_stroke}));
  EXPECT_EQ(other.posture.hand, devices::WritingHand::right);
  EXPECT_FALSE(other.calibration);
}

TEST_F(RememberedDevices, ForgetsACalibrationThatIsGone) {
  DeviceMemory memory;
  memory.devices[QStringLiteral("arm:1")].calibration = devices::WorkspaceCalibration{};
  save(memory);
  ASSERT_TRUE(load().devices.value(QStringLiteral("arm:1")).calibration);
  memory.devices[QStringLiteral("arm:1")].calibration.reset();
  save(memory);
  EXPECT_FALSE(load().devices.value(QStringLiteral("arm:1")).calibration);
}

TEST_F(RememberedDevices, OfAnEmptyFileIsWhatADeviceHasAtFirst) {
  const DeviceMemory read = load();
  EXPECT_TRUE(read.chosen.isEmpty());
  EXPECT_TRUE(read.devices.isEmpty());
  EXPECT_EQ(read.material.stiffness, haptics::Material{}.stiffness);
  EXPECT_EQ(read.material.roughness, haptics::Material{}.roughness);
  const DeviceSettings first;
  EXPECT_EQ(first.buttons, (std::array{ButtonDoes::next_stroke, ButtonDoes::all_strokes}));
  EXPECT_EQ(first.max_force_n, 0);
  EXPECT_EQ(first.max_stiffness_n_m, 0);
}

TEST_F(RememberedDevices, KeepsWhatMakesSenseOfAFileThatDoesNot) {
  write(known("tilt"), 7);
  write(known("yaw"), -7);
  write(known("hand"), QStringLiteral("both"));
  write(known("button_1"), QStringLiteral("explode"));
  write(known("button_2"), QStringLiteral("clear_ink"));
  write(known("max_force_n"), -3);
  write(known("max_stiffness_n_m"), QStringLiteral("nan"));
  write(known("scale"), 0);  // no tablet can be so small
  write(QStringLiteral("material_stiffness"), 1.5);
  write(QStringLiteral("material_damping"), -0.5);
  write(QStringLiteral("material_static_friction"), 0.25);
  write(QStringLiteral("material_dynamic_friction"), 0.75);
  write(QStringLiteral("material_roughness"), QStringLiteral("rough"));
  write(QStringLiteral("material_texture"), QStringLiteral("velvet"));
  const DeviceMemory read = load();
  const DeviceSettings arm = read.devices.value(QStringLiteral("arm:1"));
  EXPECT_EQ(arm.posture.tilt_rad, 2);
  EXPECT_EQ(arm.posture.yaw_rad, -2);
  EXPECT_EQ(arm.posture.hand, devices::WritingHand::right);
  EXPECT_EQ(arm.buttons, (std::array{ButtonDoes::next_stroke, ButtonDoes::clear_ink}));
  EXPECT_EQ(arm.max_force_n, 0);
  EXPECT_EQ(arm.max_stiffness_n_m, 0);
  EXPECT_FALSE(arm.calibration);
  EXPECT_EQ(read.material.stiffness, 1);
  EXPECT_EQ(read.material.damping, 0);
  EXPECT_EQ(read.material.dynamic_friction, 0.25) << "what slides is never held more than what rests";
  EXPECT_EQ(read.material.roughness, haptics::Material{}.roughness);
  EXPECT_EQ(read.material.texture, haptics::Texture::none);
}

TEST_F(RememberedDevices, HoldsPosturesBackOnTheOtherSideToo) {
  write(known("tilt"), -1);
  write(known("yaw"), 7);
  write(known("max_force_n"), 5000);
  write(known("max_stiffness_n_m"), 5e6);
  const DeviceSettings arm = load().devices.value(QStringLiteral("arm:1"));
  EXPECT_EQ(arm.posture.tilt_rad, 0);
  EXPECT_EQ(arm.posture.yaw_rad, 2);
  EXPECT_EQ(arm.max_force_n, 1000);
  EXPECT_EQ(arm.max_stiffness_n_m, 1e6);
}

TEST_F(RememberedDevices, NamesEachMeaningOfAButtonAndEachTexture) {
  using enum ButtonDoes;
  for (const ButtonDoes does : {nothing, next_stroke, previous_stroke, all_strokes, clear_ink}) {
    DeviceMemory memory;
    memory.devices[QStringLiteral("a")].buttons = {does, does};
    save(memory);
    EXPECT_EQ(load().devices.value(QStringLiteral("a")).buttons, (std::array{does, does}));
  }
  using enum haptics::Texture;
  for (const haptics::Texture texture : {none, paper, wood, stone}) {
    DeviceMemory memory;
    memory.material.texture = texture;
    save(memory);
    EXPECT_EQ(load().material.texture, texture);
  }
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

TEST(DeviceText, NamesThatAreWordsAreSaidInTheLanguageOfTheWindow) {
  EXPECT_EQ(device_name("Mouse or pen"), QStringLiteral("Mouse, pen or finger"));
  EXPECT_EQ(device_name("Mouse, pen or finger"), QStringLiteral("Mouse, pen or finger"));
  EXPECT_EQ(device_name("Joysticks, wheels and gamepads"), QStringLiteral("Joysticks, wheels and gamepads"));
  EXPECT_EQ(device_name("Simulations"), QStringLiteral("Simulations"));
  EXPECT_EQ(device_name("Touch (serial 12345)"), QStringLiteral("Touch (serial 12345)"));
}

TEST(DeviceText, EachTroubleNamesItsDeviceAndNoTwoSayTheSame) {
  QStringList all;
  for (int i = 1; i <= static_cast<int>(haptics::DeviceTrouble::bad_message); ++i) {
    const QString said = trouble_text(static_cast<haptics::DeviceTrouble>(i), QStringLiteral("Arm"));
    EXPECT_TRUE(said.contains(QStringLiteral("Arm"))) << i << said.toStdString();
    EXPECT_TRUE(said.endsWith(u'.')) << said.toStdString();
    all.append(said);
  }
  EXPECT_GE(all.size(), 25);
  EXPECT_EQ(all.removeDuplicates(), 0);
  EXPECT_TRUE(trouble_text(haptics::DeviceTrouble::none, QStringLiteral("Arm")).isEmpty());
}

TEST(DeviceText, WhatTheDriverSaysStandsBehindTheSentence) {
  EXPECT_EQ(trouble_text(haptics::DeviceTrouble::in_use, QStringLiteral("Arm"), QStringLiteral("by cat")),
            QStringLiteral("Arm is in use. Close the other program. (by cat)"));
  EXPECT_EQ(trouble_text(haptics::DeviceTrouble::docked, QStringLiteral("Arm"), QStringLiteral("by cat")),
            QStringLiteral("Arm rests in its inkwell. Take the stylus out to go on."));
}

}  // namespace
}  // namespace nazori::ui
