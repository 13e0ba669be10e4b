// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "nazori/surface/ball_surface.h"

namespace nazori::devices {
namespace {

using base::named_setting;
using base::number_setting;
using base::set_number;
using base::text_setting;

constexpr std::array<std::string_view, 5> kButtonNames{"nothing", "next_stroke", "previous_stroke",
                                                       "all_strokes", "clear_ink"};
constexpr std::array<std::string_view, 4> kTextureNames{"none", "paper", "wood", "stone"};
constexpr std::array<std::string_view, 2> kHandNames{"right", "left"};
static_assert(static_cast<int>(WritingHand::right) == 0 && static_cast<int>(WritingHand::left) == 1);

constexpr std::array<const char*, 3> kCentre{"centre_x", "centre_y", "centre_z"};
constexpr std::string_view kKnown = "known/";
constexpr const char* kTip = "tip_radius_mm";

template <class Enum, std::size_t N>
void set_name(base::Settings& s, std::string key, const std::array<std::string_view, N>& names, Enum value) {
  s.insert_or_assign(std::move(key), std::string(names[static_cast<std::size_t>(value)]));
}

std::string button_key(std::size_t button) { return fmt::format("button_{}", button + 1); }

/// @param in  the folder of the device, with a slash.
DeviceSettings read_device(const base::Settings& s, const std::string& in) {
  DeviceSettings d;
  auto& posture = d.posture;
  posture.tilt_rad = number_setting(s, in + "tilt", posture.tilt_rad, 0, 2);
  posture.yaw_rad = number_setting(s, in + "yaw", posture.yaw_rad, -2, 2);
  posture.hand = named_setting(s, in + "hand", kHandNames, posture.hand);
  if (s.contains(in + "scale")) {
    WorkspaceCalibration c;
    c.scale = number_setting(s, in + "scale", 0, 0, 1e3);
    for (int i = 0; i < 3; ++i)
      c.centre_m[i] = number_setting(s, in + kCentre[static_cast<std::size_t>(i)], 0, -10, 10);
    c.roll_rad = number_setting(s, in + "roll", 0, -4, 4);
    c.posture = posture;
    // An invalid calibration is ignored: the automatic fit replaces it.
    if (WorkspaceMapping::create(c)) d.calibration = c;
  }
  d.max_force_n = number_setting(s, in + "max_force_n", 0, 0, 1e3);
  d.max_stiffness_n_m = number_setting(s, in + "max_stiffness_n_m", 0, 0, 1e6);
  for (std::size_t i = 0; i < d.buttons.size(); ++i)
    d.buttons[i] = named_setting(s, in + button_key(i), kButtonNames, d.buttons[i]);
  d.name = text_setting(s, in + "name");
  return d;
}

void write_device(base::Settings& s, const std::string& in, const DeviceSettings& d) {
  set_number(s, in + "tilt", d.posture.tilt_rad);
  set_number(s, in + "yaw", d.posture.yaw_rad);
  set_name(s, in + "hand", kHandNames, d.posture.hand);
  if (d.calibration) {
    set_number(s, in + "scale", d.calibration->scale);
    for (int i = 0; i < 3; ++i)
      set_number(s, in + kCentre[static_cast<std::size_t>(i)], d.calibration->centre_m[i]);
    set_number(s, in + "roll", d.calibration->roll_rad);
  } else {
    s.erase(in + "scale");
  }
  set_number(s, in + "max_force_n", d.max_force_n);
  set_number(s, in + "max_stiffness_n_m", d.max_stiffness_n_m);
  for (std::size_t i = 0; i < d.buttons.size(); ++i)
    set_name(s, in + button_key(i), kButtonNames, d.buttons[i]);
  s.insert_or_assign(in + "name", d.name);
}

/// The numbers of a material by name, as they are stored.
template <class M>
auto numbers(M& m) {
  return std::array{
      std::pair{"stiffness", &m.stiffness},
      std::pair{"damping", &m.damping},
      std::pair{"static_friction", &m.static_friction},
      std::pair{"dynamic_friction", &m.dynamic_friction},
      std::pair{"popthrough", &m.popthrough},
      std::pair{"roughness", &m.roughness},
  };
}

std::string folder_of(std::string_view id) {
  std::string folder(kKnown);
  for (const char c : id) folder += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return folder + "/";
}

/// The id with these hexadecimal digits; empty where they are invalid.
std::string id_of(std::string_view digits) {
  std::string id;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const std::string_view two = digits.substr(i, 2);
    unsigned byte = 0;
    const auto [end, failed] = std::from_chars(two.data(), two.data() + two.size(), byte, 16);
    if (two.size() != 2 || failed != std::errc() || end != two.data() + 2) return {};
    id += static_cast<char>(byte);
  }
  return id;
}

}  // namespace

DeviceSettings settings_of(const RememberedDevices& devices, std::string_view id) {
  const auto at = devices.find(id);
  return at != devices.end() ? at->second : DeviceSettings{};
}

void DeviceMemory::load(const base::Settings& s) {
  chosen = text_setting(s, "chosen");
  for (auto [name, number] : numbers(material))
    *number = number_setting(s, std::string("material_") + name, *number, 0, 1);
  material.dynamic_friction = std::min(material.dynamic_friction, material.static_friction);
  material.texture = named_setting(s, "material_texture", kTextureNames, material.texture);
  tip_radius_m = number_setting(s, kTip, 1e3 * tip_radius_m, 0, 1e3 * surface::kLargestBall_m) / 1e3;
  for (auto at = s.lower_bound(kKnown); at != s.end() && at->first.starts_with(kKnown); ++at) {
    const auto end = at->first.find('/', kKnown.size());
    if (end == std::string::npos) continue;
    const std::string id = id_of(std::string_view(at->first).substr(kKnown.size(), end - kKnown.size()));
    if (!id.empty()) devices.try_emplace(id, read_device(s, at->first.substr(0, end + 1)));
  }
}

void DeviceMemory::save(base::Settings& s) const {
  s.insert_or_assign("chosen", chosen);
  for (auto [name, number] : numbers(material)) set_number(s, std::string("material_") + name, *number);
  set_name(s, "material_texture", kTextureNames, material.texture);
  set_number(s, kTip, 1e3 * tip_radius_m);
  for (const auto& [id, device] : devices) write_device(s, folder_of(id), device);
}

haptics::DeviceLimits limited(haptics::DeviceLimits own, const DeviceSettings& settings) {
  if (settings.max_force_n > 0) {
    own.max_force_n = std::min(own.max_force_n, settings.max_force_n);
    own.continuous_force_n = std::min(own.continuous_force_n, own.max_force_n);
  }
  if (settings.max_stiffness_n_m > 0)
    own.max_stiffness_n_m = std::min(own.max_stiffness_n_m, settings.max_stiffness_n_m);
  return own;
}

}  // namespace nazori::devices
