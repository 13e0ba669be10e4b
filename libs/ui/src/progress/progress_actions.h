// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "action_set.h"

namespace nazori::ui {

/// What can be done on the page of progress.
class ProgressActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit ProgressActions(QWidget* window);

  /// Goes to a card of the page.
  struct Place {
    QString id;  ///< of the card
    QAction* action;
  };
  QList<Place> places;  ///< in the page's order; their keys are 1, 2, 3, ...
  QAction *numbers, *copy, *longer, *shorter;
};

}  // namespace nazori::ui
