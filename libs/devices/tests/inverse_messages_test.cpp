// SPDX-License-Identifier: Apache-2.0
#include "inverse_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string_view>

#include "alloc_guard.h"
#include "json_reader.h"

namespace nazori::devices::inverse {
namespace {

using Json = nlohmann::json;
using haptics::Vec3;

// The shape of a state as the maker documents it.
constexpr const char* kState = R"({"session_id":7,"inverse3":[{"device_id":"049D",
  "state":{"cursor_position":{"x":0.01,"y":-0.02,"z":0.03},"current_cursor_force":{"x":0,"y":0,"z":1.5},
           "control_domain":"cartesian","control_mode":"force"},
  "status":{"calibrated":true,"in_use":false,"power_supply":true,"ready":true,"started":true}}],
  "wireless_verse_grip":[{"device_id":"G","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},
                                                   "buttons":{"a":false,"b":true,"c":false}}}],
  "verse_grip":[{"device_id":"61548","state":{"button":true,"hall":3}}]})";

// The start of a connection as documentation 3.5 shows it.
constexpr const char* kInventory = R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{
  "type":"minverse","port":"COM12","device_info":{"major_version":7,"minor_version":4,"id":"049D"},
  "gravity_compensation":{"enabled":true,"scaling_factor":1.0},"handedness":"left","streaming_mode":"USB",
  "preset":"defaults","basis":{"permutation":"XYZ"},"filters":{"force_gate":{"gain":0.3}}},
  "state":{"cursor_position":{"x":0.0,"y":-0.12,"z":0.15}}}]})";

std::optional<ServiceState> parsed(std::string_view message) {
  ServiceState state;
  return read_state(message, state) ? std::optional(state) : std::nullopt;
}

TEST(InverseMessages, AStateIsReadAsDocumented) {
  const auto state = parsed(kState);
  ASSERT_TRUE(state);
  ASSERT_EQ(state->arm_count, 1U);
  const ArmState& arm = state->arms.front();
  EXPECT_EQ(arm.device_id.view(), "049D");
  EXPECT_EQ(*arm.position_m, Vec3(0.01, -0.02, 0.03));
  EXPECT_EQ(*arm.force_n, Vec3(0, 0, 1.5));
  EXPECT_EQ(arm.calibrated, true);
  EXPECT_EQ(arm.ready, true);
  EXPECT_FALSE(arm.type);
  EXPECT_FALSE(arm.has_preset);
  EXPECT_EQ(state->buttons, 0b1010U);  // b of the first grip, the one of the second
}

TEST(InverseMessages, TheInventoryTellsTypeHandAndWhetherPresetsAreKnown) {
  const auto state = parsed(kInventory);
  ASSERT_TRUE(state);
  const ArmState& arm = state->arms.front();
  EXPECT_EQ(arm.type, ArmType::minverse);
  EXPECT_TRUE(arm.left_handed);
  EXPECT_TRUE(arm.has_preset);
  EXPECT_EQ(*arm.position_m, Vec3(0, -0.12, 0.15));
  EXPECT_EQ(parsed(R"({"inverse3":[{"device_id":"A","config":{"type":"inverse3x"}}]})")->arms[0].type,
            ArmType::inverse3x);
  EXPECT_EQ(parsed(R"({"inverse3":[{"device_id":"A","config":{"type":"toaster"}}]})")->arms[0].type,
            std::nullopt);
}

TEST(InverseMessages, EveryFieldMayBeMissingOrOfAnotherType) {
  EXPECT_TRUE(parsed("{}"));
  EXPECT_EQ(parsed(R"({"inverse3":[]})")->arm_count, 0U);
  EXPECT_EQ(parsed(R"({"inverse3":[1,null,{"device_id":[]},{},{"device_id":1.5}]})")->arm_count, 0U);
  EXPECT_EQ(parsed(R"({"inverse3":[{"device_id":61548}]})")->arms[0].device_id.view(), "61548");
  const auto odd =
      parsed(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1,"y":"2"}},"status":3}],
                                   "verse_grip":{"a":1},"custom_verse_grip":[{"state":{"buttons":[true]}}]})");
  ASSERT_TRUE(odd);
  EXPECT_FALSE(odd->arms.front().position_m);
  EXPECT_FALSE(odd->arms.front().calibrated);
  EXPECT_FALSE(
      parsed(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1e999,"y":2,"z":3}}}]})"));
}

TEST(InverseMessages, NumbersThatNoDoubleHoldsAreRefusedOrNothing) {
  const auto x_of = [](const std::string& number) -> std::optional<double> {
    const auto state = parsed(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":)" + number +
                              R"(,"y":0,"z":0}}}]})");
    if (!state || !state->arms[0].position_m) return std::nullopt;
    return state->arms[0].position_m->x;
  };
  EXPECT_EQ(x_of("1e-400"), 0.0);
  EXPECT_EQ(x_of("-2.5E-400"), 0.0);
  EXPECT_EQ(x_of("5e-324"), 5e-324);
  EXPECT_EQ(x_of("1.7976931348623157e308"), 1.7976931348623157e308);
  for (const char* large : {"1e309", "-1e309", "1e999999999999"})
    EXPECT_EQ(x_of(large), std::nullopt) << large;
  EXPECT_EQ(x_of(std::string(400, '9') + "e-5"), std::nullopt);
  for (const char* odd : {"+1", ".5", "1.", "1e", "--1", "0x1", "inf", "nan", "-"})
    EXPECT_EQ(x_of(odd), std::nullopt) << odd;
  EXPECT_EQ(x_of("-0.5e1"), -5.0);
}

TEST(InverseMessages, WhatIsNoStateIsRefused) {
  for (const char* text : {"", "null", "[]", "{\"inverse3\":{}}", "{\"inverse3\":", "\xff\xfe", "nonsense",
                           "{} {}", "{\"a\":1,}", "{\"a\":01}", "{\"a\":\"\\x\"}", "{\"a\":tru}"})
    EXPECT_FALSE(parsed(text)) << text;
  EXPECT_FALSE(parsed(std::string(200'000, '[')));
  EXPECT_FALSE(parsed("{\"a\":" + std::string(200'000, '[')));
}

TEST(InverseMessages, MoreArmsAndLongerNamesThanThereIsRoomForAreLeftOut) {
  std::string many = R"({"inverse3":[)";
  for (int i = 0; i < 20; ++i) many += R"({"device_id":"A)" + std::to_string(i) + "\"},";
  many.back() = ']';
  many += R"(,"wireless_verse_grip":[{"state":{"buttons":{)";
  for (int i = 10; i < 60; ++i) many += "\"b" + std::to_string(i) + "\":true,";
  many.back() = '}';
  const auto state = parsed(many + "}}]}");
  ASSERT_TRUE(state);
  EXPECT_EQ(state->arm_count, ServiceState::kMostArms);
  EXPECT_EQ(state->buttons, ~0U);
  EXPECT_EQ(parsed(R"({"inverse3":[{"device_id":")" + std::string(48, 'x') + "\"}]}")->arm_count, 0U);
  EXPECT_EQ(parsed(R"({"inverse3":[{"device_id":")" + std::string(47, 'x') + "\"}]}")->arm_count, 1U);
  EXPECT_EQ(parsed("{\"inverse3\":[{\"device_id\":\"\xc3\xa4\"}]}")->arm_count, 0U);
}

TEST(InverseMessages, ReadingAndWritingAtTheRateOfTheServoDoesNotAllocate) {
  TickMessage message("049D", ForceKey::vector);
  ServiceState state;
  const haptics::test::AllocGuard guard;
  bool fine = true;
  std::size_t written = 0;
  for (int i = 0; i < 1000; ++i) {
    fine = fine && read_state(kState, state) && read_state(kInventory, state);
    written += message.write({-1.0 / 3.0 * i, 1e-300 / 3.0, -1.7976931348623157e308}).size();
  }
  EXPECT_EQ(guard.calls(), 0);
  EXPECT_TRUE(fine);
  EXPECT_GT(written, 0U);
}

/// The same reading with a general library, which makes a document of each message.
class Reference {
 public:
  static std::optional<ServiceState> read(const std::string& message) {
    const Json json = Json::parse(message, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    ServiceState state;
    if (json.contains("inverse3") && !json["inverse3"].is_array()) return std::nullopt;
    for (const Json& arm : json.value("inverse3", Json::array())) {
      ArmState one;
      if (const Json id = at(arm, "device_id"); id.is_string())
        one.device_id.set(id.get<std::string>());
      else if (id.is_number_integer())
        one.device_id.set(id.dump());
      if (one.device_id.empty()) continue;
      one.position_m = vector(at(at(arm, "state"), "cursor_position"));
      one.force_n = vector(at(at(arm, "state"), "current_cursor_force"));
      one.calibrated = truth(at(at(arm, "status"), "calibrated"));
      one.ready = truth(at(at(arm, "status"), "ready"));
      state.arms[state.arm_count++] = one;
    }
    unsigned next = 0;
    for (const char* list : {"wireless_verse_grip", "verse_grip", "custom_verse_grip"}) {
      const Json grips = at(json, list);
      if (!grips.is_array()) continue;
      for (const Json& grip : grips) {
        const auto add = [&](const Json& is_down) {
          if (!is_down.is_boolean()) return;
          if (is_down.get<bool>()) state.buttons |= 1U << next;
          ++next;
        };
        add(at(at(grip, "state"), "button"));
        if (const Json map = at(at(grip, "state"), "buttons"); map.is_object()) {
          for (const Json& is_down : map) add(is_down);
        }
      }
    }
    return state;
  }

 private:
  static Json at(const Json& object, const char* name) {
    return object.is_object() && object.contains(name) ? object[name] : Json();
  }
  static std::optional<bool> truth(const Json& value) {
    return value.is_boolean() ? std::optional(value.get<bool>()) : std::nullopt;
  }
  static std::optional<Vec3> vector(const Json& value) {
    Vec3 v(0);
    const char* const names[3] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      const Json part = at(value, names[i]);
      if (!part.is_number()) return std::nullopt;
      v[i] = part.get<double>();
    }
    return v;
  }
};

TEST(InverseMessages, DamagedMessagesAreReadAsAGeneralLibraryReadsThem) {
  std::mt19937 random(1);
  const std::string sound = kState;
  const std::string letters = "{}[]\",:0123456789.-+eEtfnul xyzab_\\/ \n";
  int accepted = 0;
  for (int i = 0; i < 40'000; ++i) {
    std::string message = sound;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t place = random() % message.size();
      const char letter = letters[random() % letters.size()];
      switch (random() % 3) {
        case 0:
          message[place] = letter;
          break;
        case 1:
          message.erase(place, 1 + random() % 3);
          break;
        default:
          message.insert(place, 1, letter);
      }
    }
    // Escapes are left as they are written: that is the one difference, and it only concerns names.
    if (message.find('\\') != std::string::npos) continue;
    const auto expected = Reference::read(message);
    const auto state = parsed(message);
    ASSERT_EQ(state.has_value(), expected.has_value()) << message;
    if (!expected) continue;
    ++accepted;
    ASSERT_EQ(state->arm_count, expected->arm_count) << message;
    ASSERT_EQ(state->buttons, expected->buttons) << message;
    for (std::size_t k = 0; k < state->arm_count; ++k) {
      const ArmState &a = state->arms[k], &b = expected->arms[k];
      ASSERT_EQ(a.device_id.view(), b.device_id.view()) << message;
      ASSERT_EQ(a.position_m, b.position_m) << message;
      ASSERT_EQ(a.force_n, b.force_n) << message;
      ASSERT_EQ(a.calibrated, b.calibrated) << message;
      ASSERT_EQ(a.ready, b.ready) << message;
    }
  }
  EXPECT_GT(accepted, 2000);
}

TEST(InverseMessages, TheVersionTellsTheSpellingOfAForceAndWhetherPresetsAreKnown) {
  for (const char* recent : {R"({"git_tag":"v3.5.0"})", R"({"ok":true,"data":{"project_version":"3.10.2"}})",
                             R"({"git_tag":"v4"})"}) {
    ASSERT_TRUE(dialect_for_version(recent)) << recent;
    EXPECT_EQ(dialect_for_version(recent)->key, ForceKey::vector) << recent;
    EXPECT_TRUE(dialect_for_version(recent)->knows_presets) << recent;
  }
  for (const char* old : {R"({"git_tag":"3.1.0-rc1"})", R"({"git_tag":"v3.4.9"})", R"({"git_tag":"2.9"})"}) {
    ASSERT_TRUE(dialect_for_version(old)) << old;
    EXPECT_EQ(dialect_for_version(old)->key, ForceKey::values) << old;
    EXPECT_FALSE(dialect_for_version(old)->knows_presets) << old;
  }
  for (const char* silent :
       {"", "{}", R"({"git_tag":"main"})", R"({"git_tag":7})", "[1]", R"({"git_tag":"99999999999999"})"})
    EXPECT_FALSE(dialect_for_version(silent)) << silent;
}

TEST(InverseMessages, CommandsAreTheDocumentedOnes) {
  TickMessage message("049D", ForceKey::vector);
  EXPECT_EQ(Json::parse(message.write({0, 0, 1.2})), Json::parse(R"({"inverse3":[{"device_id":"049D",
              "commands":{"set_cursor_force":{"vector":{"x":0.0,"y":0.0,"z":1.2}}}}]})"));
  const Vec3 odd(-1.0 / 3, 1e-12, -2);
  const Json force = Json::parse(message.write(odd))["inverse3"][0]["commands"]["set_cursor_force"]["vector"];
  EXPECT_EQ(force["x"].get<double>(), odd.x);
  EXPECT_EQ(force["y"].get<double>(), odd.y);
  EXPECT_EQ(force["z"].get<double>(), odd.z);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Json::parse(message.write({nan, HUGE_VAL, 1})),
            Json::parse(TickMessage("049D", ForceKey::vector).write({0, 0, 1})));
  const Json first = Json::parse(first_message("049D", {ForceKey::vector, true}, 0.4));
  EXPECT_EQ(first["session"]["configure"]["basis"]["permutation"], "XYZ");
  EXPECT_EQ(first["inverse3"][0]["configure"]["preset"]["preset"], "arm_front_centered");
  EXPECT_EQ(first["inverse3"][0]["configure"]["force_gate"]["gain"], 0.4);
  EXPECT_EQ(first["inverse3"][0]["commands"]["set_cursor_force"]["vector"]["z"], 0.0);
  const Json old = Json::parse(first_message("049D", {ForceKey::values, false}, std::nullopt));
  EXPECT_FALSE(old["inverse3"][0]["configure"].contains("preset")) << "before 3.5 nobody knows it";
  EXPECT_EQ(old["inverse3"][0]["commands"]["set_cursor_force"]["values"]["z"], 0.0);
}

TEST(JsonReader, TakesNoPartOfATextForTheWhole) {
  // What follows the part in memory is the rest of the text: to look beyond the end would find it good.
  constexpr std::string_view kText = R"({"a":[1,-2.5e3,true,false,null,"x\"A"],"b":{},"c":[]})";
  for (std::size_t length = 0; length <= kText.size(); ++length) {
    JsonReader reader(kText.substr(0, length));
    reader.skip();
    EXPECT_EQ(reader.good(), length == kText.size()) << kText.substr(0, length);
    EXPECT_EQ(reader.at_end(), length == kText.size()) << kText.substr(0, length);
  }
}

TEST(InverseMessages, ABrokenMessageHoldsNoButtonDownFromBefore) {
  ServiceState state;
  ASSERT_TRUE(read_state(R"({"inverse3":[],"verse_grip":[{"state":{"buttons":{"a":true}}}]})", state));
  ASSERT_NE(state.buttons, 0U);
  EXPECT_FALSE(read_state("[]", state));
  EXPECT_EQ(state.buttons, 0U);
}

}  // namespace
}  // namespace nazori::devices::inverse
