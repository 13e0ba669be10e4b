// SPDX-License-Identifier: Apache-2.0
#include "learners/learners_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/study/profiles.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

LearnersDialog::LearnersDialog(practice::Learner& learner, QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      list_(named(new QListWidget(this), "learners_list", tr("Learners"))),
      name_(named(new QLineEdit(this), "learner_name", tr("Name (to add or rename)"))),
      words_(text_label("learners_words", this)) {
  setObjectName(QStringLiteral("learners_dialog"));
  setWindowTitle(tr("Learners"));
  auto* list_caption = new QLabel(tr("&Learners"), this);
  list_caption->setBuddy(list_);
  auto* name_caption = new QLabel(tr("&Name (to add or rename)"), this);
  name_caption->setBuddy(name_);
  const auto button = [this](const char* name, const QString& text) {
    auto* made = named(new QPushButton(text, this), name);
    made->setAutoDefault(false);
    return made;
  };
  choose_ = button("learner_choose", tr("&Study as this learner"));
  choose_->setDefault(true);
  auto* add_button = button("learner_add", tr("&Add"));
  rename_ = button("learner_rename", tr("&Rename"));
  remove_ = button("learner_remove", tr("Re&move…"));
  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  connect(choose_, &QPushButton::clicked, this, &LearnersDialog::choose);
  connect(add_button, &QPushButton::clicked, this, &LearnersDialog::add);
  connect(rename_, &QPushButton::clicked, this, &LearnersDialog::rename);
  connect(remove_, &QPushButton::clicked, this, &LearnersDialog::remove);
  connect(list_, &QListWidget::itemActivated, this, &LearnersDialog::choose);

  auto* edit = new QHBoxLayout;
  edit->addWidget(add_button);
  edit->addWidget(rename_);
  edit->addWidget(remove_);
  edit->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 20, 20, 16);
  column->setSpacing(10);
  column->addWidget(list_caption);
  column->addWidget(list_, 1);
  column->addWidget(choose_);
  column->addWidget(name_caption);
  column->addWidget(name_);
  column->addLayout(edit);
  column->addWidget(words_);
  column->addWidget(buttons);
  const int em = fontMetrics().height();
  resize(em * 20, em * 22);
  refresh();
  show_words(tr("Each learner has their own study history, settings and backups."));
}

void LearnersDialog::show_words(const QString& sentence) {
  words_->setText(sentence);
  words_->setAccessibleName(sentence);
}

QString LearnersDialog::chosen() const {
  return list_->currentItem() == nullptr ? QString() : list_->currentItem()->data(Qt::UserRole).toString();
}

void LearnersDialog::refresh() {
  list_->clear();
  for (const std::string& one : learner_.profiles()) {
    const QString name = to_text(one);
    const bool studies = one == learner_.profile();
    auto* item = new QListWidgetItem(studies ? tr("✓ %1 (current)").arg(name) : name, list_);
    item->setData(Qt::UserRole, name);
    if (studies) list_->setCurrentItem(item);
  }
}

QString LearnersDialog::typed_name() {
  const QString name = name_->text().trimmed();
  if (!study::can_be_profile(name.toStdString())) {
    show_words(
        tr("Type a name first: at most 60 letters (20 in Japanese), no “/”, and no dot at the start."));
    name_->setFocus();
    return {};
  }
  if (learner_.has_profile(name.toStdString())) {
    show_words(tr("%1 already exists. Type another name.").arg(name));
    name_->setFocus();
    return {};
  }
  return name;
}

void LearnersDialog::choose() {
  const QString name = chosen();
  if (name.isEmpty()) return;
  if (name.toStdString() != learner_.profile() && learner_.switch_profile(name.toStdString()))
    emit announced(Feedback::good, tr("Now studying as %1.").arg(name));
  accept();
}

void LearnersDialog::add() {
  const QString name = typed_name();
  if (name.isEmpty() || !learner_.switch_profile(name.toStdString())) return;
  name_->clear();
  refresh();
  show_words(tr("Now studying as %1.").arg(name));
  emit announced(Feedback::good, tr("Now studying as %1.").arg(name));
}

void LearnersDialog::rename() {
  const QString from = chosen();
  if (from.isEmpty()) return;
  const QString to = typed_name();
  if (to.isEmpty()) return;
  const auto done = learner_.rename_profile(from.toStdString(), to.toStdString());
  refresh();
  if (!done) {
    show_words(tr("%1 could not be renamed: %2.").arg(from, reason(done.error())));
    return;
  }
  name_->clear();
  show_words(tr("Renamed %1 to %2.").arg(from, to));
}

void LearnersDialog::remove() {
  const QString name = chosen();
  if (name.isEmpty()) return;
  QMessageBox question(
      QMessageBox::Question, tr("Remove a learner"),
      tr("Remove %1, with all reviews, handwriting and backups, from the list of learners?").arg(name),
      QMessageBox::Cancel, this);
  question.setObjectName(QStringLiteral("learner_remove_question"));
  question.setInformativeText(
      tr("Nothing is deleted. The folder is moved to “.removed”, next to the other learners. Move it back to "
         "use it again."));
  auto* yes = question.addButton(tr("Re&move"), QMessageBox::AcceptRole);
  yes->setObjectName(QStringLiteral("learner_remove_yes"));
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() != yes) return;
  const auto kept = learner_.remove_profile(name.toStdString());
  refresh();
  show_words(kept ? tr("Removed %1. The folder is now in %2.").arg(name, to_text(kept->string()))
                  : tr("%1 could not be removed: %2.").arg(name, reason(kept.error())));
}

}  // namespace nazori::ui
