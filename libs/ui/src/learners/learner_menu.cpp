// SPDX-License-Identifier: Apache-2.0
#include "learners/learner_menu.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

#include "desk.h"
#include "kanji_text.h"
#include "learners/anki_dialog.h"
#include "learners/backups_dialog.h"
#include "learners/exchange_progress.h"
#include "learners/learner_actions.h"
#include "learners/learners_dialog.h"
#include "study/learner_words.h"

namespace nazori::ui {

using Format = practice::LearnerExchange::Format;

LearnerMenu::LearnerMenu(Desk& desk)
    : QObject(&desk.window()),
      desk_(desk),
      actions_(new LearnerActions(&desk.window())),
      progress_(new ExchangeProgress(desk.exchange(), &desk.window())) {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions_->learners, [this] { show_learners(); });
  on(actions_->back_up, [this] { desk_.exchange().back_up(); });
  on(actions_->restore, [this] { show_backups(); });
  on(actions_->export_json, [this] { ask_and_write(Format::json); });
  on(actions_->export_csv, [this] { ask_and_write(Format::csv); });
  on(actions_->export_anki, [this] { ask_and_write(Format::anki); });
  on(actions_->import_json, [this] { ask_and_read(); });
  connect(progress_, &ExchangeProgress::said, &desk_, &Desk::say);
}

void LearnerMenu::show_learners() {
  LearnersDialog dialog(desk_.learner(), &desk_.window());
  connect(&dialog, &LearnersDialog::said, &desk_, &Desk::say);
  dialog.exec();
  desk_.focus_tablet();
}

void LearnerMenu::show_backups() {
  BackupsDialog dialog(desk_.inbox(), desk_.learner(), desk_.exchange(), *progress_, &desk_.window());
  dialog.exec();
  desk_.focus_tablet();
}

QString LearnerMenu::folder() const {
  const QString& last = desk_.preferences().folder;
  return last.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::HomeLocation) : last;
}

void LearnerMenu::remember_folder_of(const QString& path) {
  desk_.preferences().folder = QFileInfo(path).absolutePath();
  desk_.save_later();
}

void LearnerMenu::ask_and_write(Format format) {
  const auto& store = desk_.learner().store();
  practice::AnkiChoice choice;
  QString suffix = QStringLiteral("json");
  QString filter = tr("Everything of a learner (*.json)");
  if (format == Format::csv) {
    suffix = QStringLiteral("csv");
    filter = tr("Tables (*.csv)");
  } else if (format == Format::anki) {
    suffix = QStringLiteral("apkg");
    filter = tr("Anki packages (*.apkg)");
    AnkiDialog dialog(store, &desk_.window());
    if (dialog.exec() != QDialog::Accepted) return desk_.focus_tablet();
    choice = dialog.choice();
  }
  if (store.last_entry() == 0 && format != Format::anki) {
    const QString trouble = LearnerWords::sentence(desk_.learner().trouble());
    desk_.say(trouble.isEmpty() ? Feedback::advice : Feedback::wrong,
              trouble.isEmpty() ? tr("Nothing is studied yet: there is nothing to export.") : trouble);
    return;
  }
  QString path = QFileDialog::getSaveFileName(
      &desk_.window(), tr("Export"),
      QStringLiteral("%1/%2.%3").arg(folder(), to_text(desk_.learner().profile()), suffix), filter);
  if (!path.isEmpty()) {
    if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
    remember_folder_of(path);
    desk_.exchange().write(format, path.toStdString(), choice);
  }
  desk_.focus_tablet();
}

void LearnerMenu::ask_and_read() {
  const QString path = QFileDialog::getOpenFileName(&desk_.window(), tr("Import"), folder(),
                                                    tr("Everything of a learner (*.json);;All files (*)"));
  if (!path.isEmpty()) {
    remember_folder_of(path);
    desk_.exchange().read(path.toStdString());
  }
  desk_.focus_tablet();
}

}  // namespace nazori::ui
