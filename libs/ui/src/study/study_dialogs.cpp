// SPDX-License-Identifier: Apache-2.0
#include "study/study_dialogs.h"

#include <QInputDialog>
#include <QRegularExpression>

#include "nazori/practice/character_choice.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "study/settings_progress.h"
#include "study/study_settings_dialog.h"

namespace nazori::ui {

void ask_study_settings(WindowParts& parts) {
  auto& learner = parts.learner();
  StudySettingsDialog dialog(learner, parts.preferences(), &parts.window());
  if (dialog.exec() != QDialog::Accepted) return;
  dialog.fill(parts.preferences());
  parts.save_later();
  parts.study_settings_changed();
  const auto wanted = dialog.settings();
  if (learner.can_write() && wanted != learner.store().settings()) {
    if (practice::SettingsChange::takes_long(learner.store(), wanted)) {
      auto* change = new SettingsProgress(parts.settings_change(), wanted, &parts.window());
      QObject::connect(change, &SettingsProgress::announced, &parts, &WindowParts::announce);
      return;
    }
    if (!learner.report(learner.store().change_settings(wanted))) return;
  }
  parts.announce(Feedback::good, StudySettingsDialog::tr("Settings saved."));
}

void ask_tags(WindowParts& parts, char32_t character) {
  auto& learner = parts.learner();
  const auto own = learner.store().tags_of(character);
  // An empty field would look as if there were no tags, and OK would replace the stored ones.
  if (!own) return learner.announce_unread(own.error());
  bool fine = false;
  const QString text = QInputDialog::getText(
      &parts.window(), StudySettingsDialog::tr("Tags"),
      StudySettingsDialog::tr("Tags for %1, separated by commas:").arg(to_text(character)), QLineEdit::Normal,
      joined(*own, QStringLiteral(", ")), &fine);
  if (!fine) return;
  std::vector<std::string> tags;
  static const QRegularExpression commas(QStringLiteral("[,、，]"));
  for (const auto& part : text.split(commas, Qt::SkipEmptyParts))
    if (const QString tag = part.trimmed(); !tag.isEmpty()) tags.push_back(tag.toStdString());
  if (learner.report(learner.store().set_tags(character, tags))) learner.renew_order();
}

void ask_list(WindowParts& parts, char32_t character) {
  auto& learner = parts.learner();
  const auto lists = practice::list_memberships(learner, character);
  if (!lists) return;
  const auto words = [](const char* text) {
    return QCoreApplication::translate("nazori::ui::StudySettingsDialog", text);
  };
  QStringList names;
  for (const auto& list : *lists)
    names.append(list.contains ? to_text(list.name) + QStringLiteral(" ✓") : to_text(list.name));
  bool fine = false;
  const QString chosen = QInputDialog::getItem(
      &parts.window(), words(QT_TRANSLATE_NOOP("nazori::ui::StudySettingsDialog", "Add to list")),
      words(QT_TRANSLATE_NOOP("nazori::ui::StudySettingsDialog",
                              "List for %1. Choose one, or type a new name; ✓: it is in the list already."))
          .arg(to_text(character)),
      names, 0, true, &fine);
  if (!fine || chosen.trimmed().isEmpty()) return;
  const auto row = names.indexOf(chosen);
  const bool contains = row >= 0 && (*lists)[static_cast<std::size_t>(row)].contains;
  const std::string name =
      row >= 0 ? (*lists)[static_cast<std::size_t>(row)].name : chosen.trimmed().toStdString();
  if (!practice::set_in_list(learner, name, character, !contains)) return;
  const char* const said =
      contains ? QT_TRANSLATE_NOOP("nazori::ui::StudySettingsDialog", "Took %1 out of the list “%2”.")
               : QT_TRANSLATE_NOOP("nazori::ui::StudySettingsDialog", "Added %1 to the list “%2”.");
  parts.announce(Feedback::good, words(said).arg(to_text(character), to_text(name)));
}

}  // namespace nazori::ui
