// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/devices/back_end.h"
#include "sdl_port.h"

namespace nazori::devices::sdl {

/// The back end over the given port. Thread rules: as BackEnd.
[[nodiscard]] std::unique_ptr<BackEnd> back_end(std::shared_ptr<Port> port);

}  // namespace nazori::devices::sdl
