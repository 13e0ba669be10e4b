// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::ui {

/// The kind of a sentence. It decides the sign and the colour beside it: never the colour alone.
enum class Feedback : std::uint8_t {
  hint,    ///< what to do
  good,    ///< a tick
  advice,  ///< a warning sign
  wrong,   ///< a cross
};

}  // namespace nazori::ui
