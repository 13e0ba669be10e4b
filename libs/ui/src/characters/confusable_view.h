// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "nazori/practice/character_library.h"

class QAction;
class QHBoxLayout;

namespace nazori::ui {

/// A character beside those it is confused with. The strokes that differ are thick and coloured.
class ConfusableView final : public QWidget {
  Q_OBJECT
 public:
  /// @param actions  offered below the pictures.
  ConfusableView(const QList<QAction*>& actions, QWidget* parent);

  /// @param sheet  with confusables.
  void show_sheet(const practice::CharacterSheet& sheet);

 signals:
  void character_chosen(char32_t code_point);

 private:
  QWidget* pictures_;
};

}  // namespace nazori::ui
