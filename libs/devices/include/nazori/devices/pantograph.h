// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// Where to look for Haply's 2diy and how it is built.
struct PantographSettings {
  std::string port;                              ///< path of its serial port; empty: looked for on USB
  bool has_button = false;                       ///< a button is wired to analogue input A2 of the board
  std::optional<double> delay_s;                 ///< from pose to force, 0..0.02; empty: measured
  double give_up_s = 3;                          ///< without an answer, until the device counts as lost
  std::filesystem::path device_folder = "/dev";  ///< where the ports are
  std::filesystem::path system_folder = "/sys";  ///< tells what USB device stands behind a port
};

/// Haply's 2diy: a pantograph of two motors, moved in a plane, on a board of type M0 or M3 at a USB serial
/// port. Its plane is the tablet's; it has force along two axes and none along the depth. A thread of its own
/// speaks with the board; the servo never waits for it.
///
/// The board shows the USB numbers of an Arduino, so it cannot be told from one. It is therefore never chosen
/// by itself, and no port is opened before somebody has chosen it. Each board is listed once for each
/// version of the mechanism, because the board does not tell which one it moves. Ids: "pantograph:3",
/// "pantograph:2", with ".2", ".3" for more boards.
///
/// The board knows only how far its motors turned since open(): the handle must be at rest then.
[[nodiscard]] std::unique_ptr<BackEnd> pantograph_back_end(PantographSettings settings);

}  // namespace nazori::devices
