// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/parts/unsaved_box.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::UnsavedBox)
};

}  // namespace

Unsaved ask_unsaved(const char* name, const QString& sentence, QWidget* window) {
  QMessageBox box(QMessageBox::Question, QStringLiteral("Nazori"), sentence, QMessageBox::NoButton, window);
  box.setObjectName(QString::fromLatin1(name));
  auto* keep = box.addButton(Words::tr("Save…"), QMessageBox::AcceptRole);
  auto* discard = box.addButton(Words::tr("Do not save"), QMessageBox::DestructiveRole);
  auto* stay = box.addButton(Words::tr("Go back"), QMessageBox::RejectRole);
  box.setDefaultButton(keep);
  box.setEscapeButton(stay);
  box.exec();
  if (box.clickedButton() == keep) return Unsaved::save;
  return box.clickedButton() == discard ? Unsaved::discard : Unsaved::stay;
}

}  // namespace nazori::ui
