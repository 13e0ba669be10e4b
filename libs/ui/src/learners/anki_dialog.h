// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/learner_exchange.h"

class QLineEdit;
class QSpinBox;

namespace nazori::ui {

class ListChoice;

/// Asks for the content of an Anki package: which characters, the name of the deck, how many words.
class AnkiDialog final : public QDialog {
  Q_OBJECT
 public:
  AnkiDialog(const study::LearnerStore& store, QWidget* parent);
  [[nodiscard]] practice::AnkiChoice choice() const;

 private:
  ListChoice* list_;
  QLineEdit* deck_;
  QSpinBox* words_;
};

}  // namespace nazori::ui
