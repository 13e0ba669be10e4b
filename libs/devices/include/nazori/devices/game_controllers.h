// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// Joysticks, wheels and gamepads through SDL 2. Ids: "sdl:" and SDL's GUID of the model, with ".2", ".3" for
/// more of the same.
///
/// A stick is a stylus that moves in the plane of the tablet; a trigger presses it down. Where the device has
/// force, groove walls push with it; a gamepad rumbles at groove walls and when a stroke captures the stylus,
/// is finished, or is written wrongly. Only a joystick with force along two axes is chosen automatically.
///
/// SDL is started at the first find() or open() and ended with the last device and the back end. It installs
/// no signal handlers and needs no window. Every SDL call is made under one lock, by the caller of the back
/// end or its devices or by a running device's own thread, never by the servo thread. The next find() sees
/// devices that were plugged in or out.
[[nodiscard]] std::unique_ptr<BackEnd> game_controllers_back_end();

}  // namespace nazori::devices
