// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "action_set.h"

namespace nazori::ui {

/// Who studies, and what can be done with everything they have done: in every workplace.
class LearnerActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit LearnerActions(QWidget* window);

  QAction *learners, *back_up, *restore;
  QAction *export_json, *export_csv, *export_anki, *import_json;
};

}  // namespace nazori::ui
