// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

namespace nazori::ui {

/// How much taller than usual the lines of the window's language are in a font: some fonts with Japanese
/// letters keep half a line empty between lines. 1 for lines of up to 1.2 em. Thread: interface.
[[nodiscard]] double line_stretch(const QFont& font);

}  // namespace nazori::ui
