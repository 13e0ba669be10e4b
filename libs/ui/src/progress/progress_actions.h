// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "action_set.h"

namespace nazori::ui {

/// What can be done on the page of progress.
class ProgressActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit ProgressActions(QWidget* window);

  QAction *forecast, *activity, *retention, *motion, *characters, *hard_strokes;
  QAction *numbers, *copy, *longer, *shorter;
};

}  // namespace nazori::ui
