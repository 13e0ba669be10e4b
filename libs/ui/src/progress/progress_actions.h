// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// The actions of the page for progress.
class ProgressActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit ProgressActions(QWidget* window);

  /// Goes to a card of the page.
  struct CardEntry {
    QString id;  ///< of the card
    QAction* action;
  };
  QList<CardEntry> card_entries;  ///< in the page's order; their keys are 1, 2, 3, ...
  QAction *more, *practise, *numbers, *copy, *longer, *shorter;
};

}  // namespace nazori::ui
