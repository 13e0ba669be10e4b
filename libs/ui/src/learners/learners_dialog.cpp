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
#include <algorithm>

#include "nazori/study/profiles.h"
#include "widgets/named.h"
#include "words/error_text.h"
#include "words/kanji_text.h"

namespace nazori::ui {

LearnersDialog::LearnersDialog(practice::Learner& learner, QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      list_(named(new QListWidget(this), "learners_list", tr("Learners"))),
      name_(named(new QLineEdit(this), "learner_name", tr("Name (to add or rename)"))),
      words_(named(new QLabel(this), "learners_words")) {
  setObjectName(QStringLiteral("learners_dialog"));
  setWindowTitle(tr("Learners"));
  auto* list_caption = new QLabel(tr("&Learners"), this);
  list_caption->setBuddy(list_);
  auto* name_caption = new QLabel(tr("&Name (to add or rename)"), this);
  name_caption->setBuddy(name_);
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
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
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
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
  std::vector<std::string> names = study::profiles(learner_.folder());
  const std::string& current = learner_.profile();
  if (std::find(names.begin(), names.end(), current) == names.end()) names.insert(names.begin(), current);
  for (const std::string& one : names) {
    const QString name = to_text(one);
    const bool studies = one == current;
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
  const auto file = study::learner_file(learner_.folder(), name.toStdString());
  std::error_code ignored;
  if (file && std::filesystem::exists(file->parent_path(), ignored)) {
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
  base::Result<void> done;
  const auto work = [&]() -> std::string {
    done = study::rename_profile(learner_.folder(), from.toStdString(), to.toStdString());
    return done ? to.toStdString() : std::string();
  };
  if (from.toStdString() == learner_.profile())
    learner_.while_closed(work);
  else
    (void)work();
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
  base::Result<std::filesystem::path> kept;
  const auto work = [&]() -> std::string {
    kept = study::remove_profile(learner_.folder(), name.toStdString());
    if (!kept) return {};
    const auto left = study::profiles(learner_.folder());
    return left.empty() ? std::string(study::kDefaultProfile) : left.front();
  };
  if (name.toStdString() == learner_.profile())
    learner_.while_closed(work);
  else
    (void)work();
  refresh();
  show_words(kept ? tr("Removed %1. The folder is now in %2.").arg(name, to_text(kept->string()))
                  : tr("%1 could not be removed: %2.").arg(name, reason(kept.error())));
}

}  // namespace nazori::ui
