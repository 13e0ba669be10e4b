// SPDX-License-Identifier: Apache-2.0
#include "learners/learner_actions.h"

namespace nazori::ui {

LearnerActions::LearnerActions(QWidget* window) : ActionSet(window) {
  learners =
      make("learners", tr("S&witch learner…"), tr("Choose, add, rename or remove a learner"), "Ctrl+Shift+W");
  back_up = make("back_up", tr("&Back up now"), tr("Make a backup now, in addition to the daily ones"),
                 "Ctrl+Shift+B");
  restore =
      make("restore", tr("&Restore from a backup…"), tr("See your backups and restore one"), "Ctrl+Shift+O");
  export_json = make("export_json", tr("&Export everything…"),
                     tr("Save the complete study history with handwriting, lists and tags to a file (JSON)"),
                     "Ctrl+Shift+X");
  export_csv = make("export_csv", tr("Export a &table of reviews…"),
                    tr("Save every entry as a row of a table (CSV)"), "Ctrl+Shift+V");
  export_anki =
      make("export_anki", tr("Export for &Anki…"),
           tr("Save cards with stroke order, readings, meanings and words (.apkg)"), "Ctrl+Shift+K");
  import_json = make("import_json", tr("&Import…"),
                     tr("Load exported data (JSON), also from another computer"), "Ctrl+Shift+I");
  add_group(tr("&Learner"), {learners, nullptr, back_up, restore, nullptr, export_json, export_csv,
                             export_anki, import_json});
}

}  // namespace nazori::ui
