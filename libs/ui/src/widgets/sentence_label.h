// SPDX-License-Identifier: Apache-2.0
#pragma once

class QLabel;
class QWidget;

namespace nazori::ui {

/// A label for sentences: plain text in as many lines as it needs, which can be copied.
/// @param name  its object name.
[[nodiscard]] QLabel* sentence_label(const char* name, QWidget* parent);

}  // namespace nazori::ui
