// SPDX-License-Identifier: Apache-2.0
#include "learners/learner_actions.h"

namespace nazori::ui {

LearnerActions::LearnerActions(QWidget* window) : ActionSet(window) {
  const auto key = [](const char* text) { return QStringList{QString::fromLatin1(text)}; };
  learners = make("learners", tr("&Who studies…"), tr("Choose, add, rename or remove a learner"),
                  key("Ctrl+Shift+W"));
  back_up = make("back_up", tr("&Back up now"), tr("Keep a copy of everything besides the daily ones"),
                 key("Ctrl+Shift+B"));
  restore = make("restore", tr("&Restore from a backup…"), tr("See the backups and put one in place"),
                 key("Ctrl+Shift+O"));
  export_json =
      make("export_json", tr("&Export everything…"),
           tr("Write the whole log with its ink, lists and tags to a file (JSON)"), key("Ctrl+Shift+X"));
  export_csv = make("export_csv", tr("Export a &table of reviews…"),
                    tr("Write every writing to a table (CSV)"), key("Ctrl+Shift+V"));
  export_anki =
      make("export_anki", tr("Export for &Anki…"),
           tr("Write cards with stroke order, readings, meanings and words (.apkg)"), key("Ctrl+Shift+K"));
  import_json = make("import_json", tr("&Import…"), tr("Read what was exported (JSON), also elsewhere"),
                     key("Ctrl+Shift+I"));
  add_group(tr("&Learner"), {learners, nullptr, back_up, restore, nullptr, export_json, export_csv,
                             export_anki, import_json});
}

}  // namespace nazori::ui
