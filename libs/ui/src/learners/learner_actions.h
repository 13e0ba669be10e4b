// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// The actions for learners and their study data. They are available on every page.
class LearnerActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit LearnerActions(QWidget* window);

  QAction *learners, *back_up, *restore;
  QAction *export_json, *export_csv, *export_anki, *import_json;
};

}  // namespace nazori::ui
