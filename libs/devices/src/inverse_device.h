// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "inverse_link.h"
#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_device.h"

namespace nazori::devices::inverse {

/// An arm of the service as a device. @param limits  at the stylus; their delay is the planned one.
[[nodiscard]] std::unique_ptr<haptics::HapticDevice> arm_device(const InverseServiceSettings& settings,
                                                                const ArmAddress& arm,
                                                                const std::string& name,
                                                                const haptics::DeviceLimits& limits,
                                                                const WorkspaceMapping& mapping);

}  // namespace nazori::devices::inverse
