// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/haptics/haptic_device.h"

namespace nazori::devices::inverse {

/// Both spellings of a force in a command: documentation from 3.5 on says "vector", older programs send
/// "values".
enum class ForceKey : std::uint8_t { vector, values };

/// What one message says of one arm. Metres and newtons in the service's frame: x right, y forward, z up.
/// What the message does not say is empty; nothing is obligatory.
struct ArmState {
  std::string device_id;
  std::optional<haptics::Vec3> position_m;
  std::optional<haptics::Vec3> force_n;  ///< what the arm says it pushes with
  std::optional<bool> calibrated, ready;
};

/// A message of the service.
struct ServiceState {
  std::vector<ArmState> arms;
  std::uint32_t buttons = 0;  ///< of all grips, in the order of their names
};

/// @return nothing where it is not a JSON object with lists of devices. Numbers that are not finite count as
/// not said.
[[nodiscard]] std::optional<ServiceState> parse_state(std::string_view message);

/// The spelling that the answer to GET /version asks for; nothing where it does not tell.
[[nodiscard]] std::optional<ForceKey> key_for_version(std::string_view answer);

/// The first message of a session: profile, where the origin is, and no force.
[[nodiscard]] std::string first_message(std::string_view device_id, ForceKey key,
                                        std::optional<double> force_gate_gain);
/// One tick: the force, in the service's frame.
[[nodiscard]] std::string tick_message(std::string_view device_id, ForceKey key,
                                       const haptics::Vec3& force_n);

}  // namespace nazori::devices::inverse
