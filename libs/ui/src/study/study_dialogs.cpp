// SPDX-License-Identifier: Apache-2.0
#include "study/study_dialogs.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QRegularExpression>

#include "desk.h"
#include "error_text.h"
#include "kanji_text.h"
#include "study/settings_progress.h"
#include "study/study_settings_dialog.h"

namespace nazori::ui {

void ask_study_settings(Desk& desk) {
  auto& learner = desk.learner();
  StudySettingsDialog dialog(learner, desk.preferences(), &desk.window());
  if (dialog.exec() != QDialog::Accepted) return;
  dialog.fill(desk.preferences());
  desk.save_later();
  desk.note_study_settings();
  const auto wanted = dialog.settings();
  if (learner.can_write() && wanted != learner.store().settings()) {
    if (practice::SettingsChange::takes_long(learner.store(), wanted)) {
      auto* change = new SettingsProgress(desk.settings_change(), wanted, &desk.window());
      QObject::connect(change, &SettingsProgress::said, &desk, &Desk::say);
      return;
    }
    if (!learner.report(learner.store().change_settings(wanted))) return;
  }
  desk.say(Feedback::good, QCoreApplication::translate("nazori::ui::StudySettingsDialog",
                                                       "The study settings hold from now on."));
}

void ask_tags(Desk& desk, char32_t character) {
  auto& learner = desk.learner();
  const auto own = learner.store().tags_of(character);
  // An empty line would look as if there were none, and would replace those there are.
  if (!own) return learner.announce_unread(own.error());
  QStringList before;
  for (const auto& tag : *own) before.append(to_text(tag));
  bool fine = false;
  const QString text = QInputDialog::getText(
      &desk.window(), QCoreApplication::translate("nazori::ui::StudySettingsDialog", "Tags"),
      QCoreApplication::translate("nazori::ui::StudySettingsDialog", "Tags of %1, with commas between them:")
          .arg(to_text(character)),
      QLineEdit::Normal, before.join(QStringLiteral(", ")), &fine);
  if (!fine) return;
  std::vector<std::string> tags;
  static const QRegularExpression commas(QStringLiteral("[,、，]"));
  for (const auto& part : text.split(commas, Qt::SkipEmptyParts))
    if (const QString tag = part.trimmed(); !tag.isEmpty()) tags.push_back(tag.toStdString());
  if (learner.report(learner.store().set_tags(character, tags))) learner.renew_order();
}

}  // namespace nazori::ui
