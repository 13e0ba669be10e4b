// SPDX-License-Identifier: Apache-2.0
#include "inverse_messages.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "json_reader.h"
#include "nazori/json/json.h"

namespace nazori::devices::inverse {
namespace {

using Json = json::Value;
using haptics::Vec3;
using Kind = JsonReader::Kind;

/// x, y and z, all three numbers; nothing where it is anything else.
std::optional<Vec3> vector(JsonReader& json) noexcept {
  Vec3 v(0);
  std::array<bool, 3> there{};
  if (json.next() != Kind::object) {
    json.skip();
    return std::nullopt;
  }
  json.object([&](std::string_view name) {
    const std::size_t axis = name.size() == 1 ? static_cast<std::size_t>(name[0] - 'x') : 3;
    const bool is_number = json.next() == Kind::number;
    if (axis > 2) return json.skip();
    there[axis] = is_number;
    if (is_number)
      v[static_cast<int>(axis)] = json.number();
    else
      json.skip();
  });
  if (!json.good() || !there[0] || !there[1] || !there[2]) return std::nullopt;
  return v;
}

std::optional<bool> truth(JsonReader& json) noexcept {
  if (json.next() == Kind::truth) return json.truth();
  json.skip();
  return std::nullopt;
}

std::string_view text(JsonReader& json) noexcept {
  if (json.next() == Kind::string) return json.string();
  json.skip();
  return {};
}

std::string_view id(JsonReader& json) noexcept {
  if (json.next() != Kind::number) return text(json);
  const std::string_view number = json.number_text();
  return number.find_first_of(".eE") == std::string_view::npos ? number : std::string_view{};
}

/// The members of an object; anything else is passed over.
template <class F>
void members(JsonReader& json, F member) noexcept {
  if (json.next() == Kind::object)
    json.object(member);
  else
    json.skip();
}

void read_config(JsonReader& json, ArmState& arm) noexcept {
  members(json, [&](std::string_view name) {
    if (name == "type") {
      const std::string_view type = text(json);
      if (type == "inverse3x")
        arm.type = ArmType::inverse3x;
      else if (type == "minverse")
        arm.type = ArmType::minverse;
      else if (type == "inverse3")
        arm.type = ArmType::inverse3;
    } else if (name == "handedness") {
      arm.left_handed = text(json) == "left";
    } else if (name == "preset") {
      arm.has_preset = true;
      json.skip();
    } else {
      json.skip();
    }
  });
}

ArmState read_arm(JsonReader& json) noexcept {
  ArmState arm;
  members(json, [&](std::string_view name) {
    if (name == "device_id") {
      arm.device_id.set(id(json));
    } else if (name == "state") {
      members(json, [&](std::string_view part) {
        if (part == "cursor_position")
          arm.position_m = vector(json);
        else if (part == "current_cursor_force")
          arm.force_n = vector(json);
        else
          json.skip();
      });
    } else if (name == "status") {
      members(json, [&](std::string_view part) {
        if (part == "calibrated")
          arm.calibrated = truth(json);
        else if (part == "ready")
          arm.ready = truth(json);
        else
          json.skip();
      });
    } else if (name == "config") {
      read_config(json, arm);
    } else {
      json.skip();
    }
  });
  return arm;
}

/// The buttons of one list of grips, from bit 0 on.
struct Buttons {
  void add(bool is_down) noexcept {
    if (count >= 32) return;
    if (is_down) bits |= 1U << count;
    ++count;
  }
  /// The same as a list behind this one.
  void add(const Buttons& more) noexcept {
    if (count < 32) bits |= more.bits << count;
    count = std::min(32U, count + more.count);
  }
  std::uint32_t bits = 0, count = 0;
};

/// Buttons of one grip, which come in any order, by name.
class NamedButtons {
 public:
  void set(std::string_view name, std::optional<bool> is_down) noexcept {
    std::size_t place = 0;
    while (place < count_ && all_[place].name < name) ++place;
    if (place == count_ || all_[place].name != name) {
      if (count_ == all_.size()) return;
      std::copy_backward(&all_[place], all_.data() + count_, all_.data() + count_ + 1);
      ++count_;
    }
    all_[place] = {name, is_down};
  }
  void add_to(Buttons& buttons) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (all_[i].is_down) buttons.add(*all_[i].is_down);
    }
  }

 private:
  struct One {
    std::string_view name;
    std::optional<bool> is_down;
  };
  std::array<One, 32> all_{};
  std::size_t count_ = 0;
};

Buttons read_grips(JsonReader& json) noexcept {
  Buttons all;
  if (json.next() != Kind::array) {
    json.skip();
    return all;
  }
  json.array([&] {
    std::optional<bool> one;
    NamedButtons named;
    members(json, [&](std::string_view name) {
      if (name != "state") return json.skip();
      members(json, [&](std::string_view part) {
        if (part == "button") {
          one = truth(json);
        } else if (part == "buttons") {
          named = {};
          members(json, [&](std::string_view button) { named.set(button, truth(json)); });
        } else {
          json.skip();
        }
      });
    });
    if (one) all.add(*one);
    named.add_to(all);
  });
  return all;
}

Json command(ForceKey key, const Vec3& force) {
  return {
      {"set_cursor_force",
       {{key == ForceKey::vector ? "vector" : "values", {{"x", force.x}, {"y", force.y}, {"z", force.z}}}}}};
}

}  // namespace

void ShortText::set(std::string_view text) noexcept {
  size_ = 0;
  if (text.size() > kMost) return;
  for (const char c : text) {
    if (c < 0x20 || c > 0x7e) return;
  }
  std::copy(text.begin(), text.end(), text_.begin());
  size_ = text.size();
}

const ArmState* ServiceState::find(std::string_view device_id) const noexcept {
  for (std::size_t i = 0; i < arm_count; ++i) {
    if (device_id.empty() || arms[i].device_id.view() == device_id) return &arms[i];
  }
  return nullptr;
}

bool read_state(std::string_view message, ServiceState& state) noexcept {
  JsonReader json(message);
  state.arm_count = 0;
  state.buttons = 0;
  if (json.next() != Kind::object) return false;
  constexpr std::array<std::string_view, 3> kGrips{"wireless_verse_grip", "verse_grip", "custom_verse_grip"};
  std::array<Buttons, 3> grips;
  bool has_lists = true;
  json.object([&](std::string_view name) {
    if (name == "inverse3") {
      state.arm_count = 0;
      has_lists = json.next() == Kind::array;
      if (!has_lists) return json.skip();
      return json.array([&] {
        const ArmState arm = read_arm(json);
        if (!arm.device_id.empty() && state.arm_count < state.arms.size())
          state.arms[state.arm_count++] = arm;
      });
    }
    for (std::size_t i = 0; i < kGrips.size(); ++i) {
      if (name == kGrips[i]) {
        grips[i] = read_grips(json);
        return;
      }
    }
    json.skip();
  });
  if (!json.at_end() || !has_lists) return false;
  Buttons all;
  for (const Buttons& list : grips) all.add(list);
  state.buttons = all.bits;
  return true;
}

std::optional<Dialect> dialect_for_version(std::string_view answer) {
  const auto parsed = json::parse(answer, {.depth = JsonReader::kDeepest});
  if (!parsed) return std::nullopt;
  const auto member = [](const Json* object, const char* name) -> const Json* {
    if (object == nullptr || !object->is_object()) return nullptr;
    const auto found = object->find(name);
    return found == object->end() ? nullptr : &*found;
  };
  for (const Json* place : {&*parsed, member(&*parsed, "data")}) {
    for (const char* name : {"git_tag", "project_version"}) {
      const Json* said = member(place, name);
      if (said == nullptr || !said->is_string()) continue;
      const auto& version = said->get_ref<const std::string&>();
      const std::size_t begin = version.find_first_of("0123456789");
      if (begin == std::string::npos) continue;
      int major = 0, minor = 0;
      const char* const end = version.data() + version.size();
      const auto [dot, failed] = std::from_chars(version.data() + begin, end, major);
      if (failed != std::errc()) continue;
      if (dot != end && *dot == '.') std::from_chars(dot + 1, end, minor);
      const bool new_enough = major > 3 || (major == 3 && minor >= 5);
      return Dialect{new_enough ? ForceKey::vector : ForceKey::values, new_enough};
    }
  }
  return std::nullopt;
}

std::string first_message(std::string_view device_id, const Dialect& dialect,
                          std::optional<double> force_gate_gain) {
  Json configure = Json::object();
  if (dialect.knows_presets) configure["preset"] = {{"preset", "arm_front_centered"}};
  if (force_gate_gain) configure["force_gate"] = {{"gain", *force_gate_gain}};
  const Json session{
      {"configure", {{"profile", {{"name", "org.nazori:tablet"}}}, {"basis", {{"permutation", "XYZ"}}}}}};
  const Json arm{
      {"device_id", device_id}, {"configure", configure}, {"commands", command(dialect.key, Vec3(0))}};
  return json::to_line({{"session", session}, {"inverse3", Json::array({arm})}});
}

TickMessage::TickMessage(std::string_view device_id, ForceKey key)
    : text_(R"({"inverse3":[{"device_id":")" + std::string(device_id) +
            R"(","commands":{"set_cursor_force":{")" + (key == ForceKey::vector ? "vector" : "values") +
            R"(":)"),
      begin_(text_.size()) {
  constexpr std::size_t kNumbers = 128;  // three of up to 24 characters, and what stands around them
  text_.reserve(begin_ + kNumbers);
}

std::string_view TickMessage::write(const Vec3& force_n) noexcept {
  text_.resize(begin_);
  std::array<char, 32> number{};
  const auto add = [&](std::string_view before, double value) {
    const auto [end, failed] =
        std::to_chars(number.data(), number.data() + number.size(), std::isfinite(value) ? value : 0.0);
    text_ += before;
    text_.append(number.data(), end);
    (void)failed;  // 32 characters hold every double
  };
  add(R"({"x":)", force_n.x);
  add(R"(,"y":)", force_n.y);
  add(R"(,"z":)", force_n.z);
  text_ += "}}}}]}";
  return text_;
}

}  // namespace nazori::devices::inverse
