// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

class QBoxLayout;
class QLabel;

namespace nazori::ui {

/// A name and its field: side by side, or the name above where there is little room. A row may be hidden like
/// any other widget. (QFormLayout loses a field where names stand above and another row is hidden.)
class FieldRow final : public QWidget {
  Q_OBJECT
 public:
  /// @param name  with its mnemonic, which leads to the field. @param field  belongs to the row from now on.
  FieldRow(const QString& name, QWidget* field, QWidget* parent);

  /// Gives rows below each other one shape. @param above  the names stand above their fields; else the names
  /// are equally wide.
  static void arrange(const std::vector<FieldRow*>& rows, bool above);

 private:
  QLabel* name_;
  QBoxLayout* layout_;
};

}  // namespace nazori::ui
