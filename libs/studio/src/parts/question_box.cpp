// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/parts/question_box.h"

#include <QPushButton>
#include <vector>

namespace nazori::ui {

std::size_t ask(const char* name, const QString& sentence, std::span<const Answer> answers,
                std::size_t proposed, QWidget* window) {
  QMessageBox box(QMessageBox::Question, QStringLiteral("Nazori"), sentence, QMessageBox::NoButton, window);
  box.setObjectName(QString::fromLatin1(name));
  std::vector<QPushButton*> buttons;
  for (const Answer& answer : answers) buttons.push_back(box.addButton(answer.text, answer.role));
  box.setDefaultButton(buttons[proposed]);
  box.setEscapeButton(buttons.back());
  box.exec();
  for (std::size_t i = 0; i + 1 < buttons.size(); ++i)
    if (box.clickedButton() == buttons[i]) return i;
  return buttons.size() - 1;
}

}  // namespace nazori::ui
