// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::ui {

/// Which colours the window has: those of the desktop, light ones or dark ones.
enum class ThemeChoice : std::uint8_t { desktop, light, dark };

/// The range of the size of text, in points.
inline constexpr int kMinText_pt = 12;
inline constexpr int kMaxText_pt = 28;

}  // namespace nazori::ui
