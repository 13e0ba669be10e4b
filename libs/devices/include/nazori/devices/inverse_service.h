// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// Where Haply's Inverse Service listens, and the limits of its force.
struct InverseServiceSettings {
  std::string host = "127.0.0.1";
  std::uint16_t port = 10001;
  double force_cap_n = 2;                 ///< the device does not report a limit of its own
  std::optional<double> force_gate_gain;  ///< the service's guard against oscillation; empty: its default
  std::optional<double> delay_s;          ///< from pose to force, 0..0.02; empty: measured when it is opened
  double give_up_s = 15;                  ///< without service or device, time until the device counts as lost
};

/// Haply's Inverse3, Inverse3x and Minverse through the Inverse Service: WebSocket and JSON, one state for
/// each message sent. The delay is measured when the device is opened and is part of its limits; if the
/// service becomes slower, the force is reduced. A separate thread communicates with the service; the servo
/// never waits for it. It reconnects automatically. The origin is the middle of the workspace, whatever
/// version the service has. Ids: "inverse3:049D".
[[nodiscard]] std::unique_ptr<BackEnd> inverse_service_back_end(InverseServiceSettings settings);

}  // namespace nazori::devices
