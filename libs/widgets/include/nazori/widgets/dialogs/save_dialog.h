// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/tablet_workshop.h"

class QComboBox;

namespace nazori::ui {

/// Asks how to save the tablet: which kind of file and which size.
class SaveDialog final : public QDialog {
  Q_OBJECT
 public:
  /// @param fixed_size  side of a map of one's own, which keeps its size; 0: the size can be chosen.
  SaveDialog(int fixed_size, bool has_strokes, QWidget* parent);

  [[nodiscard]] practice::FileFormat format() const;
  [[nodiscard]] int size() const;
  /// "*.raw" and what it is, for the file dialog.
  [[nodiscard]] static QString filter(practice::FileFormat format);
  [[nodiscard]] static QString suffix(practice::FileFormat format);

 private:
  QComboBox* format_;
  QComboBox* size_;
};

}  // namespace nazori::ui
