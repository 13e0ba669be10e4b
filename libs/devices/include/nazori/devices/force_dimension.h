// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// Where to look for Force Dimension's devices and the Novint Falcon.
struct ForceDimensionSettings {
  std::string library;                           ///< path of libdhd.so or libdrd.so; empty: the usual names
  double rate_hz = 1000;                         ///< of the servo, on a thread of this program
  std::filesystem::path device_folder = "/dev";  ///< used to detect a missing permission
  std::filesystem::path system_folder = "/sys";  ///< used to identify the device of an entry of /dev
};

/// Force Dimension's SDK (omega, delta, sigma, and the Novint Falcon) through libdhd.so or libdrd.so, loaded
/// at run time and never unloaded. Ids: "forcedimension:0", numbered as in the library.
[[nodiscard]] std::unique_ptr<BackEnd> force_dimension_back_end(ForceDimensionSettings settings);

}  // namespace nazori::devices
