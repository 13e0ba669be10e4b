// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>

class QLabel;
class QWidget;

namespace nazori::ui {

struct TextFile {
  QString path;
  QString text;
};

/// Asks for a text file of at most 1 MB and reads it. @param trouble  shows why it cannot be read.
[[nodiscard]] std::optional<TextFile> ask_text_file(QWidget* parent, const QString& title, QLabel& trouble);

}  // namespace nazori::ui
