// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace nazori::ui {

class Actions;

/// F1: every action with its keys, and what the mouse and the pen do.
class KeyListDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit KeyListDialog(const Actions& actions, QWidget* parent);
};

}  // namespace nazori::ui
