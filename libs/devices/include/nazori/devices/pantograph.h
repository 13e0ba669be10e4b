// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// Where to look for Haply's 2diy, and its variant.
struct PantographSettings {
  std::string port;                              ///< path of its serial port; empty: searched on USB
  bool has_button = false;                       ///< a button is wired to analogue input A2 of the board
  std::optional<double> delay_s;                 ///< from pose to force, 0..0.02; empty: measured
  double give_up_s = 3;                          ///< time without an answer until the device counts as lost
  std::filesystem::path device_folder = "/dev";  ///< where the ports are
  std::filesystem::path system_folder = "/sys";  ///< used to identify the USB device of a port
};

/// Haply's 2diy: a pantograph of two motors, moved in a plane, on a board of type M0 or M3 at a USB serial
/// port. Its plane is the tablet's; it has force along two axes and none along the depth. A separate thread
/// communicates with the board; the servo never waits for it.
///
/// The board has the USB numbers of an Arduino and cannot be distinguished from one. So it is never chosen
/// automatically, and no port is opened before the user has chosen it. Each board is listed once for each
/// version of the mechanism, because the board does not report which one it drives. Ids: "pantograph:3",
/// "pantograph:2", with ".2", ".3" for more boards.
///
/// The board measures only how far its motors have turned since open(), so the handle must be at rest at that
/// moment.
[[nodiscard]] std::unique_ptr<BackEnd> pantograph_back_end(PantographSettings settings);

}  // namespace nazori::devices
