// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace nazori::ui {

/// Asks which character a picture shows, or which character of which font is wanted.
class TraceDialog final : public QDialog {
  Q_OBJECT
 public:
  /// @param picture  name of the file; empty: of a font. @param character  proposed.
  TraceDialog(const QString& picture, const QString& character, QWidget* parent);

  /// The first character that was typed; 0: not known.
  [[nodiscard]] char32_t character() const;
  /// The chosen font; empty for a picture.
  [[nodiscard]] QString family() const;

 private:
  void show_families();

  QLineEdit* character_;
  QComboBox* family_ = nullptr;
  QLabel* words_;
  QPushButton* find_;
};

}  // namespace nazori::ui
