// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/stroke.h"
#include "nazori/writing/explanation.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// What kind of feedback something is, and so its sign and colour.
enum class Tone : std::uint8_t {
  hint,    ///< what to do
  good,    ///< a tick
  advice,  ///< a warning sign
  wrong,   ///< a cross
};

/// What a stage has to report. Strokes are numbered from 1. The comments name the fields of StageFeedback
/// that are set.
enum class StageEvent : std::uint8_t {
  // Watch
  watch_paused,    ///< nothing moves by itself: how to play
  stroke_watched,  ///< the brush begins a stroke: stroke, count, type, ending
  all_watched,     ///< count
  speed_changed,   ///< value: the new speed, 1 as written

  // Trace and Guided: how to begin
  touch_tablet,       ///< the tablet has no strokes
  follow_groove,      ///< strokes are hidden
  draw_from_one,      ///< draw from number 1
  follow_hidden,      ///< Guided, only the groove: how follows in `leading`, `count` successes
  write_from_starts,  ///< Guided, only the starting points: likewise

  // Trace and Guided: on the way
  stroke_began,             ///< stroke
  stroke_written_alone,     ///< stroke; it alone is shown
  stroke_written,           ///< stroke; other: the next one
  stroke_written_but_open,  ///< stroke; other: an earlier one that was left before its end
  stroke_written_early,     ///< stroke; other: an earlier one that is not written
  all_written,              ///< count
  left_open,                ///< stroke was left before its end
  open_stroke_first,        ///< stroke was left before its end, and another was begun
  too_early,                ///< other was begun; stroke comes before it
  from_the_end,             ///< stroke was begun at its end
  stroke_shown_alone,       ///< Guided, after too many mistakes: stroke
  gives_way,                ///< the learner resists, and the device no longer leads

  // Trace: switches
  stroke_chosen,         ///< stroke of count is shown
  stroke_chosen_hidden,  ///< stroke, but strokes are hidden
  snapping_off,
  snapping_on,
  snapping_needs_strokes,  ///< on, but strokes are hidden

  // Guided: at the end
  guided_with_mistakes,    ///< all written, not in order
  lesson_with_mistakes,    ///< the same in a lesson, which goes on
  guided_without_mistake,  ///< in a lesson
  guided_less_help,        ///< without mistakes: less help from now on
  guided_without_help,     ///< without mistakes and without help

  // Memory
  write_character,  ///< count strokes; a lesson asks already
  nothing_written,
  tablet_full,
  strokes_unjudged,            ///< count strokes are written, judged at the end
  mistake,                     ///< mistake; more: what the learner can do about it
  not_of_character,            ///< the last stroke is none of the character; more
  stroke_hinted,               ///< after too many mistakes stroke is shown
  stroke_advice,               ///< the last stroke is accepted, with advice: mistake
  stroke_right,                ///< stroke; count strokes are left
  stroke_right_other_missing,  ///< stroke; other is missing
  judged,                      ///< the writing as a whole: see MemoryStage::grade()
  judging_failed,              ///< error
  stroke_undone,               ///< count strokes are left
  all_strokes_there,           ///< a hint was asked for, and none is missing
  hint_given,                  ///< stroke is shown
  all_hints_given,
  answer_shown,
  other_character,  ///< what is written is another character: written; asked
  judges_each,      ///< every stroke is judged as it ends
  judges_at_end,

  own,  ///< what only one stage reports: its name is in `own`
};

/// How the hand is guided along a stroke.
enum class Leading : std::uint8_t {
  none,     ///< not asked for
  leading,  ///< the device leads the hand
  missing,  ///< asked for, but the device has no force
};

/// What the learner can do about a mistake.
enum class MistakeHelp : std::uint8_t {
  none,
  hint,  ///< a hint shows where the stroke goes
};

/// One thing that a stage reports. The window makes a sentence of it, the command line a line of JSON.
struct StageFeedback {
  StageEvent event = StageEvent::touch_tablet;
  /// With StageEvent::own: the name of the event for data formats, a constant of the stage's class.
  std::string_view own = {};
  Tone tone = Tone::hint;
  int stroke = 0;
  int other = 0;
  int count = 0;
  double value = 0;
  Leading leading = Leading::none;
  MistakeHelp more = MistakeHelp::none;
  char32_t written = 0;   ///< the character that was written
  char32_t asked = 0;     ///< the one that was to be written; 0 while the learner must know it
  std::string type = {};  ///< of a stroke, as KanjiVG names it; empty where it has none
  kanji::StrokeEnding ending = kanji::StrokeEnding::stop;
  std::optional<writing::Mistake> mistake = {};
  std::optional<base::Error> error = {};
};

struct StageDetail;
/// Named values in an order, as in a JSON object.
using StageDetails = std::vector<StageDetail>;
/// One of them.
struct StageDetail {
  std::string_view name;
  std::variant<bool, int, std::string, std::vector<std::string>, std::vector<StageDetails>> value;
};

}  // namespace nazori::practice
