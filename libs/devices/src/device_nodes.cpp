// SPDX-License-Identifier: Apache-2.0
#include "device_nodes.h"

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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
    struct stat info {};
    if (stat(entry->path().c_str(), &info) != 0) continue;
    nodes.push_back({entry->path(), group_name(info.st_gid), (info.st_mode & 0060) == 0060,
                     access(entry->path().c_str(), R_OK | W_OK) == 0});
  }
  std::sort(nodes.begin(), nodes.end(),
            [](const DeviceNode& a, const DeviceNode& b) { return a.path < b.path; });
  return nodes;
}

std::optional<std::string> permission_advice(const std::vector<DeviceNode>& nodes) {
  const auto closed = std::find_if(nodes.begin(), nodes.end(), [](const DeviceNode& n) { return !n.open; });
  if (closed == nodes.end()) return std::nullopt;
  if (closed->group_open && closed->group != "root")
    return "you may not open " + closed->path.string() + ": run sudo usermod -aG " + closed->group +
           " $USER, then log out and in";
  return "you may not open " + closed->path.string() +
         ": set a udev rule for it (docs/devices.md, permissions), then unplug and plug in";
}

}  // namespace nazori::devices
