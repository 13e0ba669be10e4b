// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_device.h"
#include "sdl_port.h"

namespace nazori::devices::sdl {

/// The workspace of a stick and the position of its plane: it has no depth of its own.
[[nodiscard]] DeviceWorkspace stick_workspace();

/// Limits of a stick with the given abilities, at the stick.
[[nodiscard]] haptics::DeviceLimits stick_limits(const Abilities& abilities);

/// A joystick, wheel or pad as a stylus. A separate thread communicates with it 250 times a second; the servo
/// runs on a clock thread and exchanges values with that thread without waiting.
/// @param calibration  upright and not turned: the stick's plane is the tablet's.
/// @param depth_m  how far a full press goes below the plateau.
[[nodiscard]] std::unique_ptr<haptics::HapticDevice> stick_device(std::shared_ptr<Controller> controller,
                                                                  const Listed& listed,
                                                                  const WorkspaceMapping& mapping,
                                                                  double depth_m);

}  // namespace nazori::devices::sdl
