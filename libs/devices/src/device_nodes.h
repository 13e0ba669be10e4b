// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::devices {

/// An entry of /dev that may belong to a haptic device.
struct DeviceNode {
  std::filesystem::path path;
  std::string group;        ///< its group's name, or number
  bool group_open = false;  ///< its group may read and write
  bool open = false;        ///< this user may read and write
};

/// The entries of `folder` whose names begin with one of `prefixes`, sorted.
[[nodiscard]] std::vector<DeviceNode> device_nodes(const std::filesystem::path& folder,
                                                   const std::vector<std::string_view>& prefixes);

/// The vendor number of the USB device behind a node of these classes (hidraw, ttyACM): "2988"; empty where
/// the system does not report it. @param system_folder  /sys.
[[nodiscard]] std::string usb_vendor(const std::filesystem::path& node,
                                     const std::filesystem::path& system_folder);

/// The same with the product: "2341:804d", in the system's spelling (lower case for tty).
[[nodiscard]] std::string usb_product(const std::filesystem::path& node,
                                      const std::filesystem::path& system_folder);

/// The nodes by which libraries open USB devices directly: /dev/bus/usb/001/004.
/// @param ids  of vendors or of devices: "1451", "0403:cb48".
[[nodiscard]] std::vector<DeviceNode> usb_nodes(const std::filesystem::path& device_folder,
                                                const std::filesystem::path& system_folder,
                                                const std::vector<std::string_view>& ids);

/// Instructions for a user without permission to open some of them: the group to join, or the udev rule to
/// set. Nothing where all can be opened.
[[nodiscard]] std::optional<std::string> permission_advice(const std::vector<DeviceNode>& nodes);

}  // namespace nazori::devices
