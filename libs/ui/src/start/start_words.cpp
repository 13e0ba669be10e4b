// SPDX-License-Identifier: Apache-2.0
#include "start/start_words.h"

#include <QLocale>

#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {

using practice::LearningGoal;

QString StartWords::found(const practice::PlacementResult& result, std::optional<LearningGoal> goal) {
  if (result.known.empty()) return tr("You are at the beginning. Nothing is marked as known.");
  const QLocale locale;
  const QString known = locale.toString(static_cast<int>(result.known.size()));
  const QString all = locale.toString(result.characters);
  const QString last = to_text(result.known.back());
  switch (goal.value_or(LearningGoal::kanji_by_grade)) {
    case LearningGoal::hiragana:
      return tr("You can write about %1 of the %2 hiragana, up to %3.").arg(known, all, last);
    case LearningGoal::katakana:
      return tr("You can write about %1 of the %2 katakana, up to %3.").arg(known, all, last);
    case LearningGoal::own_list:
      return tr("You can write about %1 of the %2 characters of your list.").arg(known, all);
    case LearningGoal::kanji_by_jlpt:
      return tr("You can write about %1 of the %2 kanji of the old JLPT, up to level %3.")
          .arg(known, all)
          .arg(result.old_jlpt_level.value_or(1));
    case LearningGoal::kanji_by_frequency:
      return tr("You can write about %1 of the %2 school kanji.").arg(known, all);
    case LearningGoal::kanji_by_grade:
      break;
  }
  constexpr int kLastPrimary = 6;
  const int grade = result.grade.value_or(1);
  return grade <= kLastPrimary
             ? tr("You can write about %1 of the %2 school kanji, up to grade %3.").arg(known, all).arg(grade)
             : tr("You can write about %1 of the %2 school kanji, into secondary school.").arg(known, all);
}

QString StartWords::asked(const practice::SessionQuestion& question) {
  if (question.sound) return StudyWords::kana_asked(*question.sound, question.script);
  const QString meanings = joined(question.meanings, QStringLiteral(", "));
  const QString readings = joined(question.readings, QStringLiteral("、"));
  if (meanings.isEmpty()) return readings;
  return readings.isEmpty() ? meanings : QStringLiteral("%1   %2").arg(meanings, readings);
}

}  // namespace nazori::ui
