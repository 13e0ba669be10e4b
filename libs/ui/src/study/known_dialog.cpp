// SPDX-License-Identifier: Apache-2.0
#include "study/known_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "study/text_file.h"

namespace nazori::ui {

KnownDialog::KnownDialog(practice::Learner& learner, QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      text_(named(new QPlainTextEdit(this), "known_text", tr("Text with the characters you know"))),
      found_(text_label("known_found", this, "muted")) {
  setObjectName(QStringLiteral("known_dialog"));
  setWindowTitle(tr("I know these"));
  text_->setPlaceholderText(
      tr("Paste any text or list, from another program for example. Every kanji and kana in it counts as "
         "known."));
  text_->setTabChangesFocus(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  mark_ = named(buttons->addButton(tr("Mark as known"), QDialogButtonBox::AcceptRole), "known_mark");
  auto* file = named(buttons->addButton(tr("From a file…"), QDialogButtonBox::ActionRole), "known_file");
  connect(file, &QPushButton::clicked, this, &KnownDialog::read_file);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(text_, &QPlainTextEdit::textChanged, this, &KnownDialog::show_found);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 20, 20, 16);
  column->setSpacing(12);
  column->addWidget(text_);
  column->addWidget(found_);
  column->addWidget(buttons);
  show_found();
}

void KnownDialog::read_file() {
  if (const auto file = ask_text_file(this, tr("Open a list"), *found_)) text_->setPlainText(file->text);
}

void KnownDialog::show_found() {
  practice::LearningAnswers answers;
  answers.known.emplace().kind = practice::KnownAlready::Kind::listed;
  answers.known_text = text_->toPlainText().toStdString();
  const auto plan = practice::plan_learning(learner_, answers);
  plan_ = plan.value_or(practice::LearningPlan());
  const int count = static_cast<int>(plan_.choices.known.size());
  mark_->setEnabled(count > 0);
  if (count > 0)
    found_->setText(
        tr("%Ln characters will be marked as known. What you have studied stays as it is.", nullptr, count));
  else if (plan)
    found_->setText(tr("You have studied all of these characters."));
  else if (plan.error().code == base::Errc::bad_argument)
    found_->clear();
  else
    found_->setText(reason(plan.error()));
}

}  // namespace nazori::ui
