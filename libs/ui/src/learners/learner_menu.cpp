// SPDX-License-Identifier: Apache-2.0
#include "learners/learner_menu.h"

#include <QFileDialog>
#include <QFileInfo>

#include "learners/anki_dialog.h"
#include "learners/backups_dialog.h"
#include "learners/exchange_progress.h"
#include "learners/learner_actions.h"
#include "learners/learners_dialog.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"

namespace nazori::ui {

using Format = practice::LearnerExchange::Format;

LearnerMenu::LearnerMenu(WindowParts& parts)
    : QObject(&parts.window()),
      parts_(parts),
      actions_(new LearnerActions(&parts.window())),
      progress_(new ExchangeProgress(parts.exchange(), &parts.window())) {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions_->learners, [this] { show_learners(); });
  on(actions_->back_up, [this] { parts_.exchange().back_up(); });
  on(actions_->restore, [this] { show_backups(); });
  on(actions_->export_json, [this] { ask_and_write(Format::json); });
  on(actions_->export_csv, [this] { ask_and_write(Format::csv); });
  on(actions_->export_anki, [this] { ask_and_write(Format::anki); });
  on(actions_->import_json, [this] { ask_and_read(); });
  connect(progress_, &ExchangeProgress::announced, &parts_, &WindowParts::announce);
}

void LearnerMenu::show_learners() {
  LearnersDialog dialog(parts_.learner(), &parts_.window());
  connect(&dialog, &LearnersDialog::announced, &parts_, &WindowParts::announce);
  dialog.exec();
  parts_.focus_tablet();
}

void LearnerMenu::show_backups() {
  BackupsDialog dialog(parts_.inbox(), parts_.learner(), parts_.exchange(), *progress_, &parts_.window());
  dialog.exec();
  parts_.focus_tablet();
}

void LearnerMenu::remember_folder_of(const QString& path) {
  parts_.preferences().folder = QFileInfo(path).absolutePath();
  parts_.save_later();
}

void LearnerMenu::ask_and_write(Format format) {
  const auto& store = parts_.learner().store();
  practice::AnkiChoice choice;
  QString suffix = QStringLiteral("json");
  QString filter = tr("All study data (*.json)");
  if (format == Format::csv) {
    suffix = QStringLiteral("csv");
    filter = tr("Tables (*.csv)");
  } else if (format == Format::anki) {
    suffix = QStringLiteral("apkg");
    filter = tr("Anki packages (*.apkg)");
    AnkiDialog dialog(store, &parts_.window());
    if (dialog.exec() != QDialog::Accepted) return parts_.focus_tablet();
    choice = dialog.choice();
  }
  if (store.last_entry() == 0 && format != Format::anki) {
    const QString trouble = LearnerWords::sentence(parts_.learner().trouble());
    parts_.announce(trouble.isEmpty() ? Feedback::advice : Feedback::wrong,
                    trouble.isEmpty() ? tr("Nothing studied yet, so there is nothing to export.") : trouble);
    return;
  }
  QString path = QFileDialog::getSaveFileName(
      &parts_.window(), tr("Export"),
      QStringLiteral("%1/%2.%3")
          .arg(parts_.preferences().start_folder(), to_text(parts_.learner().profile()), suffix),
      filter);
  if (!path.isEmpty()) {
    if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
    remember_folder_of(path);
    parts_.exchange().write(format, path.toStdString(), choice);
  }
  parts_.focus_tablet();
}

void LearnerMenu::ask_and_read() {
  const QString path =
      QFileDialog::getOpenFileName(&parts_.window(), tr("Import"), parts_.preferences().start_folder(),
                                   tr("All study data (*.json);;All files (*)"));
  if (!path.isEmpty()) {
    remember_folder_of(path);
    parts_.exchange().read(path.toStdString());
  }
  parts_.focus_tablet();
}

}  // namespace nazori::ui
