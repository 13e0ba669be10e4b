// SPDX-License-Identifier: Apache-2.0
#include "device_nodes.h"

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <system_error>

namespace nazori::devices {
namespace {

std::string group_name(gid_t id) {
  group entry{};
  group* found = nullptr;
  std::array<char, 4096> space{};
  if (getgrgid_r(id, &entry, space.data(), space.size(), &found) == 0 && found != nullptr)
    return entry.gr_name;
  return std::to_string(id);
}

/// Nothing where this user cannot see such an entry.
std::optional<DeviceNode> node_at(const std::filesystem::path& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) return std::nullopt;
  return DeviceNode{path, group_name(info.st_gid), (info.st_mode & 0060) == 0060,
                    access(path.c_str(), R_OK | W_OK) == 0};
}

bool by_path(const DeviceNode& a, const DeviceNode& b) { return a.path < b.path; }

std::string first_line(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// "2988" from "2988", "00002988" or "88".
std::string four_digits(std::string hex) {
  hex.erase(0, std::min(hex.find_first_not_of('0'), hex.size()));
  return std::string(hex.size() < 4 ? 4 - hex.size() : 0, '0') + hex;
}

}  // namespace

std::vector<DeviceNode> device_nodes(const std::filesystem::path& folder,
                                     const std::vector<std::string_view>& prefixes) {
  std::vector<DeviceNode> nodes;
  std::error_code failed;
  for (auto entry = std::filesystem::directory_iterator(folder, failed);
       !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (std::none_of(prefixes.begin(), prefixes.end(),
                     [&](std::string_view p) { return name.starts_with(p); }))
      continue;
    if (auto node = node_at(entry->path())) nodes.push_back(std::move(*node));
  }
  std::sort(nodes.begin(), nodes.end(), by_path);
  return nodes;
}

std::string usb_product(const std::filesystem::path& node, const std::filesystem::path& system_folder) {
  const std::string name = node.filename().string();
  for (const char* group : {"hidraw", "tty"}) {
    std::ifstream in(system_folder / "class" / group / name / "device" / "uevent");
    for (std::string line; std::getline(in, line);) {
      // HID_ID=0003:00002988:00000302 of a HID device, PRODUCT=2988/302/100 of an interface.
      constexpr std::string_view kHid = "HID_ID=", kInterface = "PRODUCT=";
      const bool is_hid = line.starts_with(kHid);
      if (!is_hid && !line.starts_with(kInterface)) continue;
      const char between = is_hid ? ':' : '/';
      std::istringstream words(line.substr(is_hid ? kHid.size() : kInterface.size()));
      std::string vendor, product;
      if (is_hid) std::getline(words, vendor, between);  // the bus
      std::getline(words, vendor, between);
      std::getline(words, product, between);
      if (vendor.empty() || product.empty()) continue;
      return four_digits(vendor) + ":" + four_digits(product);
    }
  }
  return {};
}

std::string usb_vendor(const std::filesystem::path& node, const std::filesystem::path& system_folder) {
  const std::string product = usb_product(node, system_folder);
  return product.substr(0, product.find(':'));
}

std::vector<DeviceNode> usb_nodes(const std::filesystem::path& device_folder,
                                  const std::filesystem::path& system_folder,
                                  const std::vector<std::string_view>& ids) {
  std::vector<DeviceNode> nodes;
  std::error_code failed;
  const std::filesystem::path all = system_folder / "bus" / "usb" / "devices";
  for (auto entry = std::filesystem::directory_iterator(all, failed);
       !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const std::string vendor = first_line(entry->path() / "idVendor");
    const std::string device = vendor + ":" + first_line(entry->path() / "idProduct");
    if (vendor.empty() || std::none_of(ids.begin(), ids.end(),
                                       [&](std::string_view id) { return id == vendor || id == device; }))
      continue;
    const auto three_digits = [&](const char* what) {
      const std::string digits = first_line(entry->path() / what);
      return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
    };
    if (auto node = node_at(device_folder / "bus" / "usb" / three_digits("busnum") / three_digits("devnum")))
      nodes.push_back(std::move(*node));
  }
  std::sort(nodes.begin(), nodes.end(), by_path);
  return nodes;
}

std::optional<std::string> permission_advice(const std::vector<DeviceNode>& nodes) {
  const auto closed = std::find_if(nodes.begin(), nodes.end(), [](const DeviceNode& n) { return !n.open; });
  if (closed == nodes.end()) return std::nullopt;
  if (closed->group_open && closed->group != "root")
    return "no permission to open " + closed->path.string() + ": run sudo usermod -aG " + closed->group +
           " $USER, then log out and in";
  return "no permission to open " + closed->path.string() +
         ": install a udev rule for it (docs/devices.md, permissions), then unplug the device and plug it in "
         "again";
}

}  // namespace nazori::devices
