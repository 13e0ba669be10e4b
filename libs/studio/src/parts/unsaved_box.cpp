// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/parts/unsaved_box.h"

#include <QCoreApplication>

#include "nazori/studio/parts/question_box.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::UnsavedBox)
};

}  // namespace

Unsaved ask_unsaved(const char* name, const QString& sentence, QWidget* window) {
  const Answer answers[] = {{Words::tr("Save…"), QMessageBox::AcceptRole},
                            {Words::tr("Do not save"), QMessageBox::DestructiveRole},
                            {Words::tr("Go back"), QMessageBox::RejectRole}};
  return static_cast<Unsaved>(ask(name, sentence, answers, 0, window));
}

}  // namespace nazori::ui
