// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "nazori/devices/back_end.h"
#include "nazori/devices/device_trial.h"
#include "nazori/exchange/document.h"

namespace nazori::exchange {

/// The devices that were found, by back end (docs/schemas/devices.json, devices).
[[nodiscard]] Value to_json(std::span<const devices::BackEndFindings> findings);

/// A device that was tried without force, and the machine it was tried on.
struct TriedDevice {
  std::string id;
  haptics::DeviceDescription description;
  devices::TrialResult trial;
  haptics::DeviceStatus status;
  devices::RealTimeReadiness machine;
};
/// docs/schemas/devices.json, trial.
[[nodiscard]] Value to_json(const TriedDevice& tried);

}  // namespace nazori::exchange
