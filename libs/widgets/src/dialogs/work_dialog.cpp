// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/dialogs/work_dialog.h"

#include <QProgressDialog>

namespace nazori::ui {
namespace {

constexpr int kPatience_ms = 500;

}  // namespace

QProgressDialog* make_work_dialog(const QString& name, const QString& words, const QString& stop,
                                  QWidget* parent) {
  auto* dialog = new QProgressDialog(words, stop, 0, 100, parent);
  dialog->setObjectName(name);
  dialog->setWindowModality(Qt::WindowModal);
  dialog->setMinimumDuration(kPatience_ms);
  dialog->setAutoClose(false);
  dialog->setAutoReset(false);
  dialog->setValue(0);
  return dialog;
}

}  // namespace nazori::ui
