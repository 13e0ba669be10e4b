// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstdint>

class QWidget;

namespace nazori::ui {

/// What becomes of work that is not saved, in the order of the buttons.
enum class Unsaved : std::uint8_t { save, discard, stay };

/// Asks. @param name  of the box, for tests. @param sentence  says what is not saved.
[[nodiscard]] Unsaved ask_unsaved(const char* name, const QString& sentence, QWidget* window);

}  // namespace nazori::ui
