// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMessageBox>
#include <QString>
#include <cstddef>
#include <span>

namespace nazori::ui {

/// A button of a question.
struct Answer {
  QString text;
  QMessageBox::ButtonRole role = QMessageBox::AcceptRole;
};

/// Asks a question and waits for the answer. Thread: interface.
/// @param name  of the box, for tests. @param answers  at least one; Escape gives the last. @param proposed
/// the one that Enter gives.
/// @return index of the answer.
[[nodiscard]] std::size_t ask(const char* name, const QString& sentence, std::span<const Answer> answers,
                              std::size_t proposed, QWidget* window);

}  // namespace nazori::ui
