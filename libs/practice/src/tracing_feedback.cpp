// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tracing_feedback.h"

#include <algorithm>

namespace nazori::practice {
namespace {

bool is_left_open(int stroke, const TabletControl& tablet) {
  const auto& open = tablet.ink().left_open();
  return std::find(open.begin(), open.end(), stroke) != open.end();
}

StageFeedback finished_stroke(int stroke, int next, const TabletControl& tablet) {
  if (next == 0)
    return {.event = StageEvent::all_written, .tone = Tone::good, .count = tablet.stroke_count()};
  if (tablet.current_stroke() != 0)
    return {.event = StageEvent::stroke_written_alone, .tone = Tone::good, .stroke = stroke};
  // No praise while an earlier stroke is open.
  if (next < stroke)
    return {.event = is_left_open(next, tablet) ? StageEvent::stroke_written_but_open
                                                : StageEvent::stroke_written_early,
            .tone = Tone::advice,
            .stroke = stroke,
            .other = next};
  return {.event = StageEvent::stroke_written, .tone = Tone::good, .stroke = stroke, .other = next};
}

}  // namespace

StageFeedback tracing_invitation(const TabletControl& tablet) {
  if (tablet.stroke_count() == 0) return {.event = StageEvent::touch_tablet};
  if (!tablet.strokes_visible()) return {.event = StageEvent::follow_groove};
  return {.event = StageEvent::draw_from_one};
}

bool is_mistake(TraceEvent event, const TabletControl& tablet) {
  return event == TraceEvent::from_the_end ||
         (event == TraceEvent::too_early && !is_left_open(tablet.ink().next_stroke(), tablet));
}

std::optional<StageFeedback> tracing_feedback(TraceEvent event, int stroke, const TabletControl& tablet) {
  const int next = tablet.ink().next_stroke();
  switch (event) {
    case TraceEvent::none:
      return std::nullopt;
    case TraceEvent::began:
      return StageFeedback{.event = StageEvent::stroke_began, .stroke = stroke};
    case TraceEvent::finished:
      return finished_stroke(stroke, next, tablet);
    case TraceEvent::left_open:
      return StageFeedback{.event = StageEvent::left_open, .tone = Tone::advice, .stroke = stroke};
    case TraceEvent::too_early:
      if (is_left_open(next, tablet))
        return StageFeedback{.event = StageEvent::open_stroke_first, .tone = Tone::advice, .stroke = next};
      return StageFeedback{
          .event = StageEvent::too_early, .tone = Tone::advice, .stroke = next, .other = stroke};
    case TraceEvent::from_the_end:
      return StageFeedback{.event = StageEvent::from_the_end, .tone = Tone::advice, .stroke = stroke};
  }
  return std::nullopt;
}

StageFeedback snapping_feedback(const TabletControl& tablet) {
  if (!tablet.snapping()) return {.event = StageEvent::snapping_off};
  if (!tablet.strokes_visible()) return {.event = StageEvent::snapping_needs_strokes, .tone = Tone::advice};
  return {.event = StageEvent::snapping_on};
}

StageFeedback shown_stroke_feedback(const TabletControl& tablet) {
  const int current = tablet.current_stroke();
  if (current == 0) return tracing_invitation(tablet);
  if (!tablet.strokes_visible())
    return {.event = StageEvent::stroke_chosen_hidden, .tone = Tone::advice, .stroke = current};
  return {.event = StageEvent::stroke_chosen, .stroke = current, .count = tablet.stroke_count()};
}

}  // namespace nazori::practice
