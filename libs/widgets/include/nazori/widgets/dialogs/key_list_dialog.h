// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// F1: every action with its keys, and what the mouse and the pen do.
class KeyListDialog final : public QDialog {
  Q_OBJECT
 public:
  /// @param groups  as in the menu bar.
  KeyListDialog(const QList<ActionSet::Group>& groups, QWidget* parent);
};

}  // namespace nazori::ui
