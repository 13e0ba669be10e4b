// SPDX-License-Identifier: Apache-2.0
#include "inverse_messages.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "nazori/base/nesting.h"

namespace nazori::devices::inverse {
namespace {

using Json = nlohmann::json;
using haptics::Vec3;

/// No message has brackets nested deeper. The parser takes time that grows with the square of the depth.
constexpr int kDeepest = 32;

/// The member of that name; null where there is none.
const Json* member(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::optional<Vec3> vector(const Json* value) {
  if (value == nullptr) return std::nullopt;
  Vec3 v(0);
  const char* const names[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const Json* part = member(*value, names[i]);
    if (part == nullptr || !part->is_number()) return std::nullopt;
    v[i] = part->get<double>();
    if (!std::isfinite(v[i])) return std::nullopt;
  }
  return v;
}

std::optional<bool> truth(const Json* value) {
  if (value == nullptr || !value->is_boolean()) return std::nullopt;
  return value->get<bool>();
}

std::string id_of(const Json& device) {
  const Json* id = member(device, "device_id");
  if (id == nullptr) return {};
  return id->is_string() ? id->get<std::string>() : id->is_number_integer() ? id->dump() : std::string();
}

void add_buttons(const Json& grip, std::uint32_t& buttons, std::uint32_t& next) {
  const Json* state = member(grip, "state");
  if (state == nullptr) return;
  const auto add = [&](const Json& pressed) {
    if (!pressed.is_boolean() || next >= 32) return;
    if (pressed.get<bool>()) buttons |= 1U << next;
    ++next;
  };
  if (const Json* one = member(*state, "button"); one != nullptr) add(*one);
  if (const Json* map = member(*state, "buttons"); map != nullptr && map->is_object()) {
    for (const Json& pressed : *map) add(pressed);
  }
}

Json command(ForceKey key, const Vec3& force) {
  return {
      {"set_cursor_force",
       {{key == ForceKey::vector ? "vector" : "values", {{"x", force.x}, {"y", force.y}, {"z", force.z}}}}}};
}

}  // namespace

std::optional<ServiceState> parse_state(std::string_view message) {
  if (base::is_nested_deeper(message, kDeepest)) return std::nullopt;
  const Json json = Json::parse(message, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  ServiceState state;
  if (const Json* arms = member(json, "inverse3"); arms != nullptr) {
    if (!arms->is_array()) return std::nullopt;
    for (const Json& arm : *arms) {
      ArmState one;
      one.device_id = id_of(arm);
      if (one.device_id.empty()) continue;
      if (const Json* now = member(arm, "state"); now != nullptr) {
        one.position_m = vector(member(*now, "cursor_position"));
        one.force_n = vector(member(*now, "current_cursor_force"));
      }
      if (const Json* status = member(arm, "status"); status != nullptr) {
        one.calibrated = truth(member(*status, "calibrated"));
        one.ready = truth(member(*status, "ready"));
      }
      state.arms.push_back(std::move(one));
    }
  }
  std::uint32_t next = 0;
  for (const char* list : {"wireless_verse_grip", "verse_grip", "custom_verse_grip"}) {
    const Json* grips = member(json, list);
    if (grips == nullptr || !grips->is_array()) continue;
    for (const Json& grip : *grips) add_buttons(grip, state.buttons, next);
  }
  return state;
}

std::optional<ForceKey> key_for_version(std::string_view answer) {
  if (base::is_nested_deeper(answer, kDeepest)) return std::nullopt;
  const Json json = Json::parse(answer, nullptr, false);
  const Json* data = member(json, "data");
  for (const Json* place : {&json, data}) {
    if (place == nullptr) continue;
    for (const char* name : {"git_tag", "project_version"}) {
      const Json* text = member(*place, name);
      if (text == nullptr || !text->is_string()) continue;
      const auto& version = text->get_ref<const std::string&>();
      const std::size_t begin = version.find_first_of("0123456789");
      if (begin == std::string::npos) continue;
      int major = 0, minor = 0;
      const char* const end = version.data() + version.size();
      const auto [dot, failed] = std::from_chars(version.data() + begin, end, major);
      if (failed != std::errc()) continue;
      if (dot != end && *dot == '.') std::from_chars(dot + 1, end, minor);
      return major > 3 || (major == 3 && minor >= 5) ? ForceKey::vector : ForceKey::values;
    }
  }
  return std::nullopt;
}

std::string first_message(std::string_view device_id, ForceKey key, std::optional<double> force_gate_gain) {
  Json configure{{"preset", {{"preset", "arm_front_centered"}}}};
  if (force_gate_gain) configure["force_gate"] = {{"gain", *force_gate_gain}};
  const Json session{
      {"configure", {{"profile", {{"name", "org.nazori:tablet"}}}, {"basis", {{"permutation", "XYZ"}}}}}};
  const Json arm{{"device_id", device_id}, {"configure", configure}, {"commands", command(key, Vec3(0))}};
  return Json{{"session", session}, {"inverse3", Json::array({arm})}}.dump();
}

std::string tick_message(std::string_view device_id, ForceKey key, const Vec3& force_n) {
  const Json arm{{"device_id", device_id}, {"commands", command(key, force_n)}};
  return Json{{"inverse3", Json::array({arm})}}.dump();
}

}  // namespace nazori::devices::inverse
