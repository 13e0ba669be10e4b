// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/device_text.h"

#include <gtest/gtest.h>
#include "print_qt.h"

namespace nazori::ui {
namespace {

TEST(DeviceText, NamesThatAreWordsAreSaidInTheLanguageOfTheWindow) {
  EXPECT_EQ(device_name("Mouse, pen or finger"), QStringLiteral("Mouse, pen or finger"));
  EXPECT_EQ(device_name("Falcon (simulated)"), QStringLiteral("Falcon (simulated)"));
  EXPECT_EQ(device_name("Joysticks, wheels and gamepads"), QStringLiteral("Joysticks, wheels and gamepads"));
  EXPECT_EQ(device_name("Simulated devices"), QStringLiteral("Simulated devices"));
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
            QStringLiteral("Arm is in use. Close the program that uses it. (by cat)"));
  EXPECT_EQ(trouble_text(haptics::DeviceTrouble::docked, QStringLiteral("Arm"), QStringLiteral("by cat")),
            QStringLiteral("Arm rests in its inkwell. Take the stylus out to go on."));
}

}  // namespace
}  // namespace nazori::ui
