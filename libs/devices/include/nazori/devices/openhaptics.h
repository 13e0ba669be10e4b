// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// Where to look for a PHANTOM Omni, PHANTOM Desktop, Touch or Touch X.
struct OpenHapticsSettings {
  std::string library;      ///< path of libHD.so; empty: the usual names
  std::string device_name;  ///< as in the maker's setup program; empty: the first, then the usual names
  unsigned long rate_hz = 1000;
  std::filesystem::path device_folder = "/dev";  ///< used to detect a missing permission
  std::filesystem::path system_folder = "/sys";  ///< used to identify the device of an entry of /dev
};

/// OpenHaptics' HDAPI through libHD.so, loaded at run time and never unloaded. One device at a time; the
/// servo runs in the library's scheduler thread. Ids: "openhaptics", "openhaptics:NAME".
[[nodiscard]] std::unique_ptr<BackEnd> openhaptics_back_end(OpenHapticsSettings settings);

}  // namespace nazori::devices
