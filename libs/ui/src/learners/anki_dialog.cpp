// SPDX-License-Identifier: Apache-2.0
#include "learners/anki_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kMostWords = 20;

}  // namespace

AnkiDialog::AnkiDialog(const study::LearnerStore& store, QWidget* parent)
    : QDialog(parent),
      list_(named(new ListChoice(this), "anki_list")),
      deck_(named(new QLineEdit(this), "anki_deck")),
      words_(named(new QSpinBox(this), "anki_words")) {
  setObjectName(QStringLiteral("anki_dialog"));
  setWindowTitle(tr("Export for Anki"));
  list_->fill(store);
  if (store.cards().empty()) list_->set_list(QStringLiteral("grade-1"));
  deck_->setText(to_text(practice::AnkiChoice().deck));
  deck_->setMaxLength(40);
  words_->setRange(0, kMostWords);
  words_->setValue(practice::AnkiChoice().words);
  auto* buttons = dialog_buttons(QDialogButtonBox::Cancel, this);
  auto* choose = buttons->addButton(tr("Choose file…"), QDialogButtonBox::AcceptRole);
  choose->setDefault(true);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 20, 20, 16);
  form->setSpacing(12);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->addRow(tr("&Characters"), list_);
  form->addRow(tr("&Deck"), deck_);
  form->addRow(tr("&Words per character"), words_);
  form->addRow(buttons);
}

practice::AnkiChoice AnkiDialog::choice() const {
  return {list_->list().toStdString(), deck_->text().trimmed().toStdString(), words_->value()};
}

}  // namespace nazori::ui
