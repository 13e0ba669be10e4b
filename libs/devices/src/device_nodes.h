// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::devices {

/// An entry of /dev that a haptic device may stand behind.
struct DeviceNode {
  std::filesystem::path path;
  std::string group;        ///< its group's name, or number
  bool group_open = false;  ///< its group may read and write
  bool open = false;        ///< this user may read and write
};

/// The entries of `folder` whose names begin with one of `prefixes`, sorted.
[[nodiscard]] std::vector<DeviceNode> device_nodes(const std::filesystem::path& folder,
                                                   const std::vector<std::string_view>& prefixes);

/// What to do where this user may not open some of them: the group to join, or the udev rule to set. Nothing
/// where all are open.
[[nodiscard]] std::optional<std::string> permission_advice(const std::vector<DeviceNode>& nodes);

}  // namespace nazori::devices
