// SPDX-License-Identifier: Apache-2.0
#include "characters/stage_words.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include "characters/stroke_words.h"
#include "error_text.h"
#include "kanji_text.h"
#include "writing_language.h"

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
      return tr("Space plays, Left and Right step from stroke to stroke.");
    case StageEvent::stroke_watched: {
      const QString which = tr("Stroke %1 of %2").arg(f.stroke).arg(f.count);
      const QString name = StrokeWords::name(f.type);
      const QString ending = StrokeWords::ending(f.ending);
      return name.isEmpty() ? tr("%1. %2").arg(which, ending) : tr("%1: %2. %3").arg(which, name, ending);
    }
    case StageEvent::all_watched:
      return tr("All %n strokes. Space plays them again; F6 goes on to tracing.", nullptr, f.count);
    case StageEvent::speed_changed:
      return tr("Speed %1.").arg(QLocale().toString(f.value, 'f', 2));
    default:
      return {};
  }
}

QString StageWords::invitation(const StageFeedback& f) {
  QString sentence;
  switch (f.event) {
    case StageEvent::touch_tablet:
      return tr("Press the left button to touch the tablet; the right button turns it.");
    case StageEvent::follow_groove:
      return tr("Press the left button in a groove and follow it. S shows the strokes.");
    case StageEvent::draw_from_one:
      return tr("Hold the left button at number 1 and draw along the groove.");
    case StageEvent::follow_hidden:
      sentence = tr("Follow the groove.");
      break;
    case StageEvent::write_from_starts:
      sentence = tr("Write each stroke from its number.");
      break;
    default:
      return {};
  }
  if (f.leading == Leading::leading)
    sentence = tr("Let the stylus take the hand along; hold back, and it gives way.");
  else if (f.leading == Leading::missing)
    sentence = tr("%1 Only a device with force leads the hand; here strokes hold it.").arg(sentence);
  return f.count > 0 ? tr("%1 Without a slip so far: %2.").arg(sentence).arg(f.count) : sentence;
}

QString StageWords::tracing(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::stroke_began:
      return tr("Stroke %1: follow the groove to its end.").arg(f.stroke);
    case StageEvent::stroke_written_alone:
      return tr("Stroke %1 is written. The full stop key (.) shows the next.").arg(f.stroke);
    case StageEvent::stroke_written:
      return tr("Stroke %1 is written. Stroke %2 is next.").arg(f.stroke).arg(f.other);
    case StageEvent::stroke_written_but_open:
      return tr("Stroke %1 is written, but stroke %2 is not finished: the blue bit is missing.")
          .arg(f.stroke)
          .arg(f.other);
    case StageEvent::stroke_written_early:
      return tr("Stroke %1 is written, but stroke %2 comes first. Write it now.").arg(f.stroke).arg(f.other);
    case StageEvent::all_written:
      return tr("All %n strokes are written. Delete clears the tablet.", nullptr, f.count);
    case StageEvent::left_open:
      return tr("Stroke %1 is not finished: the blue bit is missing. Draw on from there.").arg(f.stroke);
    case StageEvent::open_stroke_first:
      return tr("Stroke %1 is not finished: draw the blue bit first.").arg(f.stroke);
    case StageEvent::too_early:
      return tr("Stroke %1 comes before stroke %2.").arg(f.stroke).arg(f.other);
    case StageEvent::from_the_end:
      return tr("Stroke %1 begins at its other end, where its number stands.").arg(f.stroke);
    case StageEvent::stroke_shown_alone:
      return tr("Stroke %1 is shown. Draw it from its number.").arg(f.stroke);
    case StageEvent::gives_way:
      return tr("The stylus gives way. Go on a little by yourself, and it leads again.");
    default:
      return {};
  }
}

QString StageWords::switches(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::stroke_chosen:
      return tr("Stroke %1 of %2. Draw it from its number.").arg(f.stroke).arg(f.count);
    case StageEvent::stroke_chosen_hidden:
      return tr("Stroke %1 is chosen, but the strokes are hidden: press S.").arg(f.stroke);
    case StageEvent::snapping_off:
      return tr("The stylus is free.");
    case StageEvent::snapping_on:
      return tr("Strokes now hold the stylus. Pull away firmly to leave one.");
    case StageEvent::snapping_needs_strokes:
      return tr("Strokes hold the stylus only while they are shown: press S.");
    default:
      return {};
  }
}

QString StageWords::guiding(const StageFeedback& f) {
  switch (f.event) {
    case StageEvent::guided_with_mistakes:
      return tr("All strokes are there, not all at their turn. Delete clears the tablet.");
    case StageEvent::lesson_with_mistakes:
      return tr("All strokes are there, not all at their turn.");
    case StageEvent::guided_without_mistake:
      return tr("Without a slip.");
    case StageEvent::guided_less_help:
      return tr("Without a slip. There is less help now: write it again.");
    case StageEvent::guided_without_help:
      return tr("Without a slip, and without help. F8 goes on to writing from memory.");
    default:
      return {};
  }
}

QString StageWords::writing(const StageFeedback& f, const practice::MemoryStage& memory) {
  switch (f.event) {
    case StageEvent::write_character:
      return invitation_to_write(f.count, memory);
    case StageEvent::nothing_written:
      return tr("Nothing is written yet. H shows the first stroke.");
    case StageEvent::tablet_full:
      return tr("The tablet is full. Delete clears it.");
    case StageEvent::strokes_unjudged:
      return tr("%n strokes are written. Enter judges them.", nullptr, f.count);
    case StageEvent::mistake:
    case StageEvent::not_of_character:
    case StageEvent::stroke_advice:
      return mistake(f, memory);
    case StageEvent::stroke_hinted:
      return tr("Stroke %1 is shown in blue. Write it there and go on.").arg(f.stroke);
    case StageEvent::stroke_right:
      return f.count == 0 ? tr("Stroke %1 is right. Enter is done.").arg(f.stroke)
                          : tr("Stroke %1 is right. %n to go.", nullptr, f.count).arg(f.stroke);
    case StageEvent::stroke_right_other_missing:
      return tr("Stroke %1 is right. Stroke %2 is still missing.").arg(f.stroke).arg(f.other);
    case StageEvent::judged:
      return judgement(memory);
    case StageEvent::judging_failed:
      return f.error ? tr("The writing could not be judged: %1. It is kept.").arg(reason(*f.error))
                     : QString();
    case StageEvent::stroke_undone:
      return tr("Taken back. %n strokes are written.", nullptr, f.count);
    case StageEvent::all_strokes_there:
      return tr("Every stroke is there. Enter is done.");
    case StageEvent::hint_given:
      return tr("Stroke %1 is shown in blue. H again shows all that are left.").arg(f.stroke);
    case StageEvent::all_hints_given:
      return tr("All strokes that are left are shown in blue.");
    case StageEvent::answer_shown:
      return tr("This is how it is written. Delete clears the tablet to try again.");
    case StageEvent::judges_each:
      return tr("Every stroke is judged as it ends.");
    case StageEvent::judges_at_end:
      return tr("The writing is judged at the end: press Enter.");
    default:
      return {};
  }
}

QString StageWords::invitation_to_write(int strokes, const practice::MemoryStage& memory) {
  if (!memory.subject().sheet) return {};
  const auto& entry = memory.subject().sheet->character.entry;
  QString meaning;
  for (const auto& m : entry.meanings)
    if (m.language == "en") {
      meaning = to_text(m.text);
      break;
    }
  QString reading;
  if (!entry.kun_readings.empty())
    reading = kun_plain(kanji::split_kun(entry.kun_readings.front()));
  else if (!entry.on_readings.empty())
    reading = to_text(entry.on_readings.front());
  const QString asked = QStringList{reading, meaning}
                            .filter(QRegularExpression(QStringLiteral(".")))
                            .join(QStringLiteral(", "));
  const QString what = tr("Write the character of %n strokes.", nullptr, strokes);
  // In a lesson the question stands under the tablet already.
  if (memory.is_lesson()) return tr("%1 H gives a hint, Enter is done.").arg(what);
  return asked.isEmpty() ? what : tr("%1: %2 H gives a hint, Enter is done.").arg(asked, what);
}

QString StageWords::mistake(const StageFeedback& f, const practice::MemoryStage& memory) {
  const QString why = f.mistake ? to_text(writing::explain(*f.mistake, memory.grade(), writing_language()))
                                : tr("That is no stroke of this character. Ctrl+Z takes it back.");
  return f.more == practice::MistakeHelp::hint ? tr("%1 H shows where the stroke goes.").arg(why) : why;
}

QString StageWords::judgement(const practice::MemoryStage& memory) {
  constexpr int kMostSentences = 3;
  const auto& grade = memory.grade();
  QStringList sentences;
  for (const auto& sentence : writing::explain(grade, writing_language())) {
    if (sentences.size() == kMostSentences) break;
    sentences.append(to_text(sentence));
  }
  const QString between = writing_language() == writing::Language::japanese ? QString() : QStringLiteral(" ");
  const QString found = sentences.join(between);
  if (!grade.accepted) return tr("%1 Ctrl+Z takes back a stroke, O shows the model.").arg(found);
  QString words = tr("%1 %2 of 100 points.").arg(found).arg(grade.score);
  // Of how the pen moved one thing is mentioned, and only where nothing else could be better.
  if (grade.advice.empty() && !memory.pen_report().remarks.empty())
    words += between + to_text(writing::explain(memory.pen_report().remarks, writing_language()).front());
  return words;
}

}  // namespace nazori::ui
