// SPDX-License-Identifier: Apache-2.0
#include "study/session_words.h"

#include "kanji_text.h"
#include "study/learner_words.h"
#include "study/study_words.h"

namespace nazori::ui {

using practice::SessionFeedback;
using Kind = SessionFeedback::Kind;

Feedback SessionWords::kind(const SessionFeedback& feedback) {
  switch (feedback.kind) {
    case Kind::not_writable:
    case Kind::no_plan:
    case Kind::plan_lost:
      return Feedback::wrong;
    case Kind::all_done:
    case Kind::rated:
      return Feedback::good;
    case Kind::set_apart:
      return Feedback::advice;
    case Kind::nothing_due:
    case Kind::nothing_to_undo:
    case Kind::ended:
    case Kind::undone:
    case Kind::postponed:
    case Kind::paused:
    case Kind::reset:
      return Feedback::hint;
  }
  return Feedback::hint;
}

QString SessionWords::undone(const SessionFeedback& feedback) {
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
        return tr("Taken back: the last writing of %1.");
      case study::EntryKind::postpone:
        return tr("Taken back: %1 is not postponed.");
      case study::EntryKind::pause:
        return tr("Taken back: %1 is not paused.");
      case study::EntryKind::resume:
        return tr("Taken back: %1 is paused again.");
      case study::EntryKind::reset:
        return tr("Taken back: what was learnt of %1 is there again.");
      default:
        return tr("Taken back: %1.");
    }
  };
  return sentence().arg(about);
}

QString SessionWords::sentence(const SessionFeedback& feedback) {
  const QString character = feedback.characters.empty() ? QString() : to_text(feedback.characters.front());
  const auto put_aside = [](const QString& what) { return tr("%1 Ctrl+Shift+Z takes it back.").arg(what); };
  switch (feedback.kind) {
    case Kind::not_writable:
      return LearnerWords::sentence(feedback.trouble);
    case Kind::no_plan:
      return tr("What is due cannot be told: %1.").arg(to_text(base::to_line(feedback.error)));
    case Kind::plan_lost:
      return to_text(base::to_line(feedback.error));
    case Kind::nothing_due:
      return tr("Nothing is due now.");
    case Kind::nothing_to_undo:
      return tr("There is nothing to take back.");
    case Kind::all_done:
      return tr("That was all for now. Everything is kept.");
    case Kind::ended:
      return tr("The session has ended. Everything that was rated is kept.");
    case Kind::rated:
      return tr("Kept: %1 is “%2” and comes %3.")
          .arg(character, StudyWords::rating(feedback.rating),
               StudyWords::comes_again(feedback.card, feedback.now, feedback.today));
    case Kind::set_apart:
      return tr("%1 is forgotten often. It is set apart: Home offers another lesson for it.").arg(character);
    case Kind::undone:
      return undone(feedback);
    case Kind::postponed:
      return put_aside(tr("%1 comes tomorrow.").arg(character));
    case Kind::paused:
      return put_aside(tr("%1 is paused until it is asked for.").arg(character));
    case Kind::reset:
      return put_aside(tr("%1 is new again.").arg(character));
  }
  return {};
}

QString SessionWords::sentence(const std::optional<SessionFeedback>& feedback) {
  return feedback ? sentence(*feedback) : QString();
}

}  // namespace nazori::ui
