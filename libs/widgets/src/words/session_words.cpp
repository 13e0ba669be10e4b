// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/session_words.h"

#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {

using practice::SessionFeedback;
using SessionKind = SessionFeedback::Kind;

Feedback SessionWords::kind(const SessionFeedback& feedback) {
  switch (feedback.kind) {
    case SessionKind::not_writable:
    case SessionKind::no_plan:
    case SessionKind::plan_lost:
      return Feedback::wrong;
    case SessionKind::all_done:
    case SessionKind::rated:
      return Feedback::good;
    case SessionKind::set_apart:
      return Feedback::advice;
    case SessionKind::nothing_due:
    case SessionKind::nothing_to_undo:
    case SessionKind::ended:
    case SessionKind::undone:
    case SessionKind::postponed:
    case SessionKind::paused:
    case SessionKind::reset:
      return Feedback::hint;
  }
  return Feedback::hint;
}

QString SessionWords::undone(const SessionFeedback& feedback) {
  if (feedback.entry == study::EntryKind::choices)
    return feedback.characters.empty()
               ? tr("Undone: what you chose to learn.")
               : tr("Undone: what you chose to learn, and %n characters marked as known.", nullptr,
                    static_cast<int>(feedback.characters.size()));
  constexpr int kMostNamed = 20;
  QString about;
  for (const char32_t one : feedback.characters) {
    if (about.size() > kMostNamed) {
      about += QStringLiteral("…");
      break;
    }
    about += to_text(one);
  }
  const auto sentence = [&feedback] {
    switch (feedback.entry) {
      case study::EntryKind::writing:
        return tr("Undone: the last entry for %1.");
      case study::EntryKind::postpone:
        return tr("Undone: %1 is no longer postponed.");
      case study::EntryKind::pause:
        return tr("Undone: %1 is no longer suspended.");
      case study::EntryKind::resume:
        return tr("Undone: %1 is suspended again.");
      case study::EntryKind::reset:
        return tr("Undone: your progress with %1 is back.");
      case study::EntryKind::known:
        return tr("Undone: %1 is no longer marked as known.");
      default:
        return tr("Undone: %1.");
    }
  };
  return sentence().arg(about);
}

QString SessionWords::sentence(const SessionFeedback& feedback) {
  const QString character = feedback.characters.empty() ? QString() : to_text(feedback.characters.front());
  const bool with_brush = feedback.stage == study::Stage::brush;
  const auto put_aside = [](const QString& what) { return tr("%1 Ctrl+Shift+Z: undo.").arg(what); };
  switch (feedback.kind) {
    case SessionKind::not_writable:
      return LearnerWords::sentence(feedback.trouble);
    case SessionKind::no_plan:
      return tr("Today's study could not be prepared: %1.").arg(to_text(base::to_line(feedback.error)));
    case SessionKind::plan_lost:
      return to_text(base::to_line(feedback.error));
    case SessionKind::nothing_due:
      return with_brush ? tr("No character is due with the brush now.") : tr("Nothing is due now.");
    case SessionKind::nothing_to_undo:
      return tr("Nothing to undo.");
    case SessionKind::all_done:
      return with_brush ? tr("All done with the brush for now. Every rating is saved.")
                        : tr("All done for now. Everything is saved.");
    case SessionKind::ended:
      return tr("Session ended. Everything you rated is saved.");
    case SessionKind::rated:
      if (with_brush)
        return tr("Saved: %1 with the brush, %2. Next time with the brush %3.")
            .arg(character, StudyWords::rating(feedback.rating),
                 StudyWords::comes_again(study::review_delay(feedback.card.brush, feedback.today)));
      return tr("Saved: %1, %2. Next review %3.")
          .arg(character, StudyWords::rating(feedback.rating),
               StudyWords::comes_again(feedback.card, feedback.now, feedback.today));
    case SessionKind::set_apart:
      return tr("%1 was forgotten too often and taken out of reviews. Relearn it from Home.").arg(character);
    case SessionKind::undone:
      return undone(feedback);
    case SessionKind::postponed:
      return put_aside(tr("Postponed %1 to tomorrow.").arg(character));
    case SessionKind::paused:
      return put_aside(tr("Suspended %1 until you resume it.").arg(character));
    case SessionKind::reset:
      return put_aside(tr("Started %1 over as a new character.").arg(character));
  }
  return {};
}

QString SessionWords::sentence(const std::optional<SessionFeedback>& feedback) {
  return feedback ? sentence(*feedback) : QString();
}

}  // namespace nazori::ui
