// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/event_names.h"

namespace nazori::practice {

std::string_view name_of(StageEvent event) {
  switch (event) {
    case StageEvent::watch_paused:
      return "watch_paused";
    case StageEvent::stroke_watched:
      return "stroke_watched";
    case StageEvent::all_watched:
      return "all_watched";
    case StageEvent::speed_changed:
      return "speed_changed";
    case StageEvent::touch_tablet:
      return "touch_tablet";
    case StageEvent::follow_groove:
      return "follow_groove";
    case StageEvent::draw_from_one:
      return "draw_from_one";
    case StageEvent::follow_hidden:
      return "follow_hidden";
    case StageEvent::write_from_starts:
      return "write_from_starts";
    case StageEvent::stroke_began:
      return "stroke_began";
    case StageEvent::stroke_written_alone:
      return "stroke_written_alone";
    case StageEvent::stroke_written:
      return "stroke_written";
    case StageEvent::stroke_written_but_open:
      return "stroke_written_but_open";
    case StageEvent::stroke_written_early:
      return "stroke_written_early";
    case StageEvent::all_written:
      return "all_written";
    case StageEvent::left_open:
      return "left_open";
    case StageEvent::open_stroke_first:
      return "open_stroke_first";
    case StageEvent::too_early:
      return "too_early";
    case StageEvent::from_the_end:
      return "from_the_end";
    case StageEvent::stroke_shown_alone:
      return "stroke_shown_alone";
    case StageEvent::gives_way:
      return "gives_way";
    case StageEvent::stroke_chosen:
      return "stroke_chosen";
    case StageEvent::stroke_chosen_hidden:
      return "stroke_chosen_hidden";
    case StageEvent::snapping_off:
      return "snapping_off";
    case StageEvent::snapping_on:
      return "snapping_on";
    case StageEvent::snapping_needs_strokes:
      return "snapping_needs_strokes";
    case StageEvent::guided_with_mistakes:
      return "guided_with_mistakes";
    case StageEvent::lesson_with_mistakes:
      return "lesson_with_mistakes";
    case StageEvent::guided_without_mistake:
      return "guided_without_mistake";
    case StageEvent::guided_less_help:
      return "guided_less_help";
    case StageEvent::guided_without_help:
      return "guided_without_help";
    case StageEvent::write_character:
      return "write_character";
    case StageEvent::nothing_written:
      return "nothing_written";
    case StageEvent::tablet_full:
      return "tablet_full";
    case StageEvent::strokes_unjudged:
      return "strokes_unjudged";
    case StageEvent::mistake:
      return "mistake";
    case StageEvent::not_of_character:
      return "not_of_character";
    case StageEvent::stroke_hinted:
      return "stroke_hinted";
    case StageEvent::stroke_advice:
      return "stroke_advice";
    case StageEvent::stroke_right:
      return "stroke_right";
    case StageEvent::stroke_right_other_missing:
      return "stroke_right_other_missing";
    case StageEvent::judged:
      return "judged";
    case StageEvent::judging_failed:
      return "judging_failed";
    case StageEvent::stroke_undone:
      return "stroke_undone";
    case StageEvent::all_strokes_there:
      return "all_strokes_there";
    case StageEvent::hint_given:
      return "hint_given";
    case StageEvent::all_hints_given:
      return "all_hints_given";
    case StageEvent::answer_shown:
      return "answer_shown";
    case StageEvent::other_character:
      return "other_character";
    case StageEvent::judges_each:
      return "judges_each";
    case StageEvent::judges_at_end:
      return "judges_at_end";
    case StageEvent::own:
      return "own";
  }
  return {};
}

std::string_view name_of(const StageFeedback& what) {
  return what.event == StageEvent::own ? what.own : name_of(what.event);
}

std::string_view name_of(Tone tone) {
  switch (tone) {
    case Tone::hint:
      return "hint";
    case Tone::good:
      return "good";
    case Tone::advice:
      return "advice";
    case Tone::wrong:
      return "wrong";
  }
  return {};
}

std::string_view name_of(SessionFeedback::Kind kind) {
  using Kind = SessionFeedback::Kind;
  switch (kind) {
    case Kind::not_writable:
      return "not_writable";
    case Kind::no_plan:
      return "no_plan";
    case Kind::plan_lost:
      return "plan_lost";
    case Kind::nothing_due:
      return "nothing_due";
    case Kind::nothing_to_undo:
      return "nothing_to_undo";
    case Kind::all_done:
      return "all_done";
    case Kind::ended:
      return "ended";
    case Kind::rated:
      return "rated";
    case Kind::set_apart:
      return "set_apart";
    case Kind::undone:
      return "undone";
    case Kind::postponed:
      return "postponed";
    case Kind::paused:
      return "paused";
    case Kind::reset:
      return "reset";
  }
  return {};
}

std::string_view name_of(SessionState state) {
  using State = SessionState;
  switch (state) {
    case State::idle:
      return "idle";
    case State::doing:
      return "doing";
    case State::offered:
      return "offered";
    case State::judged:
      return "judged";
  }
  return {};
}

}  // namespace nazori::practice
