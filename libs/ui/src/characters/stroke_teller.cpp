// SPDX-License-Identifier: Apache-2.0
#include "characters/stroke_teller.h"

#include <algorithm>

#include "tablet_controller.h"

namespace nazori::ui {

StrokeTeller::Sentence StrokeTeller::invitation(const TabletController& controller) {
  if (controller.stroke_count() == 0)
    return {Feedback::hint, tr("Press the left button to touch the tablet; the right button turns it.")};
  if (!controller.strokes_visible())
    return {Feedback::hint, tr("Press the left button in a groove and follow it. S shows the strokes.")};
  return {Feedback::hint, tr("Hold the left button at number 1 and draw along the groove.")};
}

bool StrokeTeller::is_left_open(int stroke, const TabletController& controller) {
  const auto& open = controller.ink().left_open();
  return std::find(open.begin(), open.end(), stroke) != open.end();
}

bool StrokeTeller::is_miss(practice::TraceEvent event, const TabletController& controller) {
  return event == practice::TraceEvent::from_the_end ||
         (event == practice::TraceEvent::too_early &&
          !is_left_open(controller.ink().next_stroke(), controller));
}

StrokeTeller::Sentence StrokeTeller::about(practice::TraceEvent event, int stroke,
                                           const TabletController& controller) {
  const int next = controller.ink().next_stroke();
  switch (event) {
    case practice::TraceEvent::none:
      return {};
    case practice::TraceEvent::began:
      return {Feedback::hint, tr("Stroke %1: follow the groove to its end.").arg(stroke)};
    case practice::TraceEvent::finished:
      if (next == 0)
        return {Feedback::good, tr("All %n strokes are written. Delete clears the tablet.", nullptr,
                                   controller.stroke_count())};
      if (controller.current_stroke() != 0)
        return {Feedback::good,
                tr("Stroke %1 is written. The full stop key (.) shows the next.").arg(stroke)};
      // No praise while an earlier stroke is open.
      if (next < stroke)
        return {
            Feedback::advice,
            is_left_open(next, controller)
                ? tr("Stroke %1 is written, but stroke %2 is not finished: the blue bit is missing.")
                      .arg(stroke)
                      .arg(next)
                : tr("Stroke %1 is written, but stroke %2 comes first. Write it now.").arg(stroke).arg(next)};
      return {Feedback::good, tr("Stroke %1 is written. Stroke %2 is next.").arg(stroke).arg(next)};
    case practice::TraceEvent::left_open:
      return {Feedback::advice,
              tr("Stroke %1 is not finished: the blue bit is missing. Draw on from there.").arg(stroke)};
    case practice::TraceEvent::too_early:
      if (is_left_open(next, controller))
        return {Feedback::advice, tr("Stroke %1 is not finished: draw the blue bit first.").arg(next)};
      return {Feedback::advice, tr("Stroke %1 comes before stroke %2.").arg(next).arg(stroke)};
    case practice::TraceEvent::from_the_end:
      return {Feedback::advice,
              tr("Stroke %1 begins at its other end, where its number stands.").arg(stroke)};
  }
  return {};
}

StrokeTeller::Sentence StrokeTeller::snapping(const TabletController& controller) {
  if (!controller.snapping()) return {Feedback::hint, tr("The stylus is free.")};
  if (!controller.strokes_visible())
    return {Feedback::advice, tr("Strokes hold the stylus only while they are shown: press S.")};
  return {Feedback::hint, tr("Strokes now hold the stylus. Pull away firmly to leave one.")};
}

StrokeTeller::Sentence StrokeTeller::stroke_shown(const TabletController& controller) {
  const int current = controller.current_stroke();
  if (current == 0) return invitation(controller);
  if (!controller.strokes_visible())
    return {Feedback::advice, tr("Stroke %1 is chosen, but the strokes are hidden: press S.").arg(current)};
  return {Feedback::hint,
          tr("Stroke %1 of %2. Draw it from its number.").arg(current).arg(controller.stroke_count())};
}

}  // namespace nazori::ui
