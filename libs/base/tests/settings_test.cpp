// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/settings.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace nazori::base {
namespace {

enum class Colour : std::uint8_t { red, green };
constexpr std::array<std::string_view, 2> kColours{"red", "green"};

TEST(Settings, NumbersComeBackAsTheyWere) {
  Settings settings;
  for (const double value : {0.0, 0.1, -1.25, 1e-300, 1.0 / 3, 5e6}) {
    set_number(settings, "n", value);
    EXPECT_EQ(number_setting(settings, "n", 7, -1e9, 1e9), value);
  }
}

TEST(Settings, WhatIsNoNumberIsTheFallbackAndTheRestIsHeldInItsRange) {
  for (const char* text : {"", "x", "1x", "nan", "inf", "1 2"}) {
    const Settings settings{{"n", text}};
    EXPECT_EQ(number_setting(settings, "n", 7, 0, 10), 7) << text;
  }
  EXPECT_EQ(number_setting({}, "n", 7, 0, 10), 7);
  EXPECT_EQ(number_setting({{"n", "12"}}, "n", 7, 0, 10), 10);
  EXPECT_EQ(number_setting({{"n", "-1"}}, "n", 7, 0, 10), 0);
}

TEST(Settings, ASwitchComesBackAndAnythingElseIsTheFallback) {
  Settings settings;
  for (const bool value : {true, false}) {
    set_flag(settings, "on", value);
    EXPECT_EQ(flag_setting(settings, "on", !value), value);
    EXPECT_EQ(flag_setting({{"on", "perhaps"}}, "on", value), value);
    EXPECT_EQ(flag_setting({}, "on", value), value);
  }
}

TEST(Settings, AnEnumerationIsStoredByItsNames) {
  EXPECT_EQ(named_setting({{"c", "green"}}, "c", kColours, Colour::red), Colour::green);
  EXPECT_EQ(named_setting({{"c", "Green"}}, "c", kColours, Colour::red), Colour::red);
  EXPECT_EQ(named_setting({}, "c", kColours, Colour::green), Colour::green);
  EXPECT_EQ(text_setting({{"c", "green"}}, "c"), "green");
  EXPECT_EQ(text_setting({}, "c"), "");
}

}  // namespace
}  // namespace nazori::base
