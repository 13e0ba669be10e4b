// SPDX-License-Identifier: Apache-2.0
#include "inverse_messages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace nazori::devices::inverse {
namespace {

// The shape of a state as the maker documents it.
constexpr const char* kState = R"({"session_id":7,"inverse3":[{"device_id":"049D",
  "state":{"cursor_position":{"x":0.01,"y":-0.02,"z":0.03},"current_cursor_force":{"x":0,"y":0,"z":1.5},
           "control_domain":"cartesian","control_mode":"force"},
  "status":{"calibrated":true,"in_use":false,"power_supply":true,"ready":true,"started":true}}],
  "wireless_verse_grip":[{"device_id":"G","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},
                                                   "buttons":{"a":false,"b":true,"c":false}}}],
  "verse_grip":[{"device_id":"61548","state":{"button":true,"hall":3}}]})";

TEST(InverseMessages, AStateIsReadAsDocumented) {
  const auto state = parse_state(kState);
  ASSERT_TRUE(state);
  ASSERT_EQ(state->arms.size(), 1U);
  const ArmState& arm = state->arms.front();
  EXPECT_EQ(arm.device_id, "049D");
  EXPECT_EQ(*arm.position_m, haptics::Vec3(0.01, -0.02, 0.03));
  EXPECT_EQ(*arm.force_n, haptics::Vec3(0, 0, 1.5));
  EXPECT_EQ(arm.calibrated, true);
  EXPECT_EQ(state->buttons, 0b1010U);  // b of the first grip, the one of the second
}

TEST(InverseMessages, EveryFieldMayBeMissingOrOfAnotherType) {
  EXPECT_TRUE(parse_state("{}"));
  EXPECT_TRUE(parse_state(R"({"inverse3":[]})")->arms.empty());
  EXPECT_TRUE(parse_state(R"({"inverse3":[1,null,{"device_id":[]},{}]})")->arms.empty());
  const auto odd =
      parse_state(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1,"y":"2"}},"status":3}],
                                   "verse_grip":{"a":1},"custom_verse_grip":[{"state":{"buttons":[true]}}]})");
  ASSERT_TRUE(odd);
  EXPECT_FALSE(odd->arms.front().position_m);
  EXPECT_FALSE(odd->arms.front().calibrated);
  EXPECT_FALSE(
      parse_state(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1e999,"y":2,"z":3}}}]})"));
}

TEST(InverseMessages, WhatIsNoStateIsRefused) {
  for (const char* text : {"", "null", "[]", "{\"inverse3\":{}}", "{\"inverse3\":", "\xff\xfe", "nonsense"})
    EXPECT_FALSE(parse_state(text)) << text;
  EXPECT_FALSE(parse_state(std::string(200'000, '[')));
}

TEST(InverseMessages, TheVersionTellsTheSpellingOfAForce) {
  EXPECT_EQ(key_for_version(R"({"git_tag":"v3.5.0"})"), ForceKey::vector);
  EXPECT_EQ(key_for_version(R"({"ok":true,"data":{"project_version":"3.10.2"}})"), ForceKey::vector);
  EXPECT_EQ(key_for_version(R"({"git_tag":"v4"})"), ForceKey::vector);
  EXPECT_EQ(key_for_version(R"({"git_tag":"3.1.0-rc1"})"), ForceKey::values);
  for (const char* silent :
       {"", "{}", R"({"git_tag":"main"})", R"({"git_tag":7})", "[1]", R"({"git_tag":"99999999999999"})"})
    EXPECT_EQ(key_for_version(silent), std::nullopt) << silent;
}

TEST(InverseMessages, CommandsAreTheDocumentedOnes) {
  using Json = nlohmann::json;
  EXPECT_EQ(Json::parse(tick_message("049D", ForceKey::vector, {0, 0, 1.2})),
            Json::parse(R"({"inverse3":[{"device_id":"049D",
              "commands":{"set_cursor_force":{"vector":{"x":0.0,"y":0.0,"z":1.2}}}}]})"));
  const Json first = Json::parse(first_message("049D", ForceKey::values, 0.4));
  EXPECT_EQ(first["session"]["configure"]["basis"]["permutation"], "XYZ");
  EXPECT_EQ(first["inverse3"][0]["configure"]["preset"]["preset"], "arm_front_centered");
  EXPECT_EQ(first["inverse3"][0]["configure"]["force_gate"]["gain"], 0.4);
  EXPECT_EQ(first["inverse3"][0]["commands"]["set_cursor_force"]["values"]["z"], 0.0);
}

}  // namespace
}  // namespace nazori::devices::inverse
