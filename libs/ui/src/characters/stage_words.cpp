// SPDX-License-Identifier: Apache-2.0
#include "characters/stage_words.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include "characters/stroke_words.h"
#include "nazori/kanji/meanings.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/writing_language.h"

namespace nazori::ui {

using practice::Leading;
using practice::StageEvent;
using practice::StageFeedback;

QString StageWords::sentence(const StageFeedback& feedback, const practice::MemoryStage* memory) {
  for (auto* const words : {&StageWords::watching, &StageWords::invitation, &StageWords::tracing,
                            &StageWords::switches, &StageWords::guiding})
    if (QString found = words(feedback); !found.isEmpty()) return found;
  return memory != nullptr ? writing(feedback, *memory) : QString();
}

QString StageWords::watching(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::watch_paused:
      return tr("Space: play. Left and Right: step stroke by stroke.");
    case StageEvent::stroke_watched: {
      const QString which = tr("Stroke %1 of %2").arg(f.stroke).arg(f.count);
      const QString name = StrokeWords::name(f.type);
      const QString ending = StrokeWords::ending(f.ending);
      return name.isEmpty() ? tr("%1. %2").arg(which, ending) : tr("%1: %2. %3").arg(which, name, ending);
    }
    case StageEvent::all_watched:
      return tr("All %n strokes shown. Space: play again. F6: trace.", nullptr, f.count);
    case StageEvent::speed_changed:
      return tr("Speed: %1×.").arg(QLocale().toString(f.value, 'f', 2));
    default:
      return {};
  }
}

QString StageWords::watched_in_session(int strokes) {
  return tr("All %n strokes shown. Space: play again. Enter: trace.", nullptr, strokes);
}

QString StageWords::invitation(const StageFeedback& f) {
  QString sentence;
  const bool by_button = InputWatch::of_program().writes_with_button();
  switch (f.event) {
    case StageEvent::touch_tablet:
      return by_button ? tr("Press the left button to touch the tablet; the right button turns it.")
                       : tr("Touch the tablet with the tip.");
    case StageEvent::follow_groove:
      return by_button ? tr("Hold the left button in a groove and follow it. S: show the strokes.")
                       : tr("Follow a groove. S: show the strokes.");
    case StageEvent::draw_from_one:
      return by_button ? tr("Hold the left button at number 1 and draw along the groove.")
                       : tr("Start at number 1 and draw along the groove.");
    case StageEvent::follow_hidden:
      sentence = tr("Follow the groove.");
      break;
    case StageEvent::write_from_starts:
      sentence = tr("Start each stroke at its number.");
      break;
    default:
      return {};
  }
  if (f.leading == Leading::leading)
    sentence = tr("Let the stylus lead your hand. If you hold back, it gives way.");
  else if (f.leading == Leading::missing)
    sentence = tr("%1 Only a force-feedback device can lead your hand; here strokes attract the stylus.")
                   .arg(sentence);
  return f.count > 0 ? tr("%1 Written without mistakes so far: %2.").arg(sentence).arg(f.count) : sentence;
}

QString StageWords::tracing(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::stroke_began:
      return tr("Stroke %1: follow the groove to its end.").arg(f.stroke);
    case StageEvent::stroke_written_alone:
      return tr("Stroke %1 written. Full stop (.): show the next one.").arg(f.stroke);
    case StageEvent::stroke_written:
      return tr("Stroke %1 written. Next: stroke %2.").arg(f.stroke).arg(f.other);
    case StageEvent::stroke_written_but_open:
      return tr("Stroke %1 is written, but stroke %2 is not finished: the blue bit is missing.")
          .arg(f.stroke)
          .arg(f.other);
    case StageEvent::stroke_written_early:
      return tr("Stroke %1 is written, but stroke %2 comes first. Write it now.").arg(f.stroke).arg(f.other);
    case StageEvent::all_written:
      return tr("All %n strokes written. Delete: clear the tablet.", nullptr, f.count);
    case StageEvent::left_open:
      return tr("Stroke %1 is not finished: the blue bit is missing. Draw on from there.").arg(f.stroke);
    case StageEvent::open_stroke_first:
      return tr("Stroke %1 is not finished: draw the blue bit first.").arg(f.stroke);
    case StageEvent::too_early:
      return tr("Stroke %1 comes before stroke %2.").arg(f.stroke).arg(f.other);
    case StageEvent::from_the_end:
      return tr("Start stroke %1 at its other end, at the number.").arg(f.stroke);
    case StageEvent::stroke_shown_alone:
      return tr("Stroke %1 is shown. Start at its number.").arg(f.stroke);
    case StageEvent::gives_way:
      return tr("The stylus has let go. Move on a little by yourself and it leads again.");
    default:
      return {};
  }
}

QString StageWords::switches(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::stroke_chosen:
      return tr("Stroke %1 of %2. Start at its number.").arg(f.stroke).arg(f.count);
    case StageEvent::stroke_chosen_hidden:
      return tr("Stroke %1 is selected, but the strokes are hidden. S: show them.").arg(f.stroke);
    case StageEvent::snapping_off:
      return tr("Snapping off: the stylus moves freely.");
    case StageEvent::snapping_on:
      return tr("Snapping on: strokes attract the stylus. Pull firmly to leave a stroke.");
    case StageEvent::snapping_needs_strokes:
      return tr("Snapping works only while strokes are visible. S: show them.");
    default:
      return {};
  }
}

QString StageWords::guiding(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::guided_with_mistakes:
      return tr(
          "All strokes written, but not all in the right order or direction. Delete: clear and try again.");
    case StageEvent::lesson_with_mistakes:
      return tr("All strokes written, but not all in the right order or direction.");
    case StageEvent::guided_without_mistake:
      return tr("No mistakes.");
    case StageEvent::guided_less_help:
      return tr("No mistakes. Write it again, now with less help.");
    case StageEvent::guided_without_help:
      return tr("No mistakes, and no help used. F8: write from memory.");
    default:
      return {};
  }
}

QString StageWords::writing(const StageFeedback& f, const practice::MemoryStage& memory) {
  switch (f.event) {
    case StageEvent::write_character:
      return invitation_to_write(f.count, memory);
    case StageEvent::judged:
      return judgement(memory);
    default:
      return of_strokes(f, memory.grade());
  }
}

QString StageWords::of_strokes(const StageFeedback& f, const writing::Grade& grade) {
  switch (f.event) {
    case StageEvent::nothing_written:
      return tr("Nothing written yet. H: show the first stroke.");
    case StageEvent::tablet_full:
      return tr("The tablet is full. Delete: clear it.");
    case StageEvent::strokes_unjudged:
      return tr("%n strokes written. Enter: finish.", nullptr, f.count);
    case StageEvent::mistake:
    case StageEvent::not_of_character:
    case StageEvent::stroke_advice:
      return mistake(f, grade);
    case StageEvent::stroke_hinted:
      return tr("Stroke %1 is shown in blue. Write over it and go on.").arg(f.stroke);
    case StageEvent::stroke_right:
      return f.count == 0 ? tr("Stroke %1 is correct. Enter: finish.").arg(f.stroke)
                          : tr("Stroke %1 is correct. %n to go.", nullptr, f.count).arg(f.stroke);
    case StageEvent::stroke_right_other_missing:
      return tr("Stroke %1 is right. Stroke %2 is still missing.").arg(f.stroke).arg(f.other);
    case StageEvent::judging_failed:
      return f.error ? tr("Your writing could not be checked: %1. It is still there.").arg(reason(*f.error))
                     : QString();
    case StageEvent::stroke_undone:
      return tr("Undone. %n strokes written.", nullptr, f.count);
    case StageEvent::all_strokes_there:
      return tr("All strokes written. Enter: finish.");
    case StageEvent::hint_given:
      return tr("Stroke %1 is shown in blue. H again: show all remaining strokes.").arg(f.stroke);
    case StageEvent::all_hints_given:
      return tr("All remaining strokes are shown in blue.");
    case StageEvent::answer_shown:
      return tr("This is how it is written. Delete: clear and try again.");
    case StageEvent::other_character:
      return other_character(f.written, f.asked);
    case StageEvent::judges_each:
      return tr("Each stroke is checked as you finish it.");
    case StageEvent::judges_at_end:
      return tr("Your writing is checked at the end: press Enter.");
    default:
      return {};
  }
}

QString StageWords::other_character(char32_t written, char32_t asked) {
  return asked == 0 ? tr("That is %1, another character.").arg(to_text(written))
                    : tr("That is %1; %2 was asked.").arg(to_text(written), to_text(asked));
}

QString StageWords::invitation_to_write(int strokes, const practice::MemoryStage& memory) {
  if (!memory.subject().sheet) return {};
  const auto& entry = memory.subject().sheet->character.entry;
  const QString meaning = joined(kanji::meanings_in("en", entry), {}, 1);
  QString reading;
  if (!entry.kun_readings.empty())
    reading = kun_plain(kanji::split_kun(entry.kun_readings.front()));
  else if (!entry.on_readings.empty())
    reading = to_text(entry.on_readings.front());
  const QString asked = QStringList{reading, meaning}
                            .filter(QRegularExpression(QStringLiteral(".")))
                            .join(QStringLiteral(", "));
  const QString what = tr("Write the character (%n strokes).", nullptr, strokes);
  // In a lesson the question is already shown under the tablet.
  if (memory.is_lesson()) return tr("%1 H: hint. Enter: finish.").arg(what);
  return asked.isEmpty() ? what : tr("%1: %2 H: hint. Enter: finish.").arg(asked, what);
}

QString StageWords::mistake(const StageFeedback& f, const writing::Grade& grade) {
  const QString why = f.mistake ? to_text(writing::explain(*f.mistake, grade, writing_language()))
                                : tr("That stroke isn't part of this character. Ctrl+Z: undo.");
  return f.more == practice::MistakeHelp::hint ? tr("%1 H: show where the stroke goes.").arg(why) : why;
}

QString StageWords::judgement(const practice::MemoryStage& memory) {
  constexpr std::size_t kMostSentences = 3;
  const auto& grade = memory.grade();
  const QString between = between_sentences();
  // What to mend is one thing at a time; the panel beside the tablet has all of it.
  const QString found =
      joined(writing::explain(grade, writing_language()), between, grade.accepted ? kMostSentences : 1);
  if (!grade.accepted) return tr("%1 D: show it.").arg(found);
  QString words =
      grade.form ? tr("%1 Form: %2 of %3 stars.").arg(found).arg(*grade.form).arg(writing::kBestForm) : found;
  // At most one remark is about how the pen moved, and only if there is no other remark.
  if (grade.advice.empty() && !memory.pen_report().remarks.empty())
    words += between + to_text(writing::explain(memory.pen_report().remarks, writing_language()).front());
  return words;
}

}  // namespace nazori::ui
