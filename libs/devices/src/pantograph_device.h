// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_device.h"
#include "pantograph_model.h"
#include "pantograph_serial.h"

namespace nazori::devices::pantograph {

/// A pantograph whose board has been set up.
struct OpenBoard {
  std::shared_ptr<SerialPort> port;
  Model model;
  haptics::DeviceLimits limits;  ///< at the handle; their delay is the planned one
  double give_up_s = 3;          ///< time without an answer until the device counts as lost
};

/// A HapticDevice for a pantograph.
/// @param mapping  upright: the plane is the tablet's.
/// @param shape  of the tablet: beyond its edges a tip without a button is lifted.
[[nodiscard]] std::unique_ptr<haptics::HapticDevice> pantograph_device(OpenBoard board,
                                                                       const WorkspaceMapping& mapping,
                                                                       const geometry::TabletShape& shape);

}  // namespace nazori::devices::pantograph
