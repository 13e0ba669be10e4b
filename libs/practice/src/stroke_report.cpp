// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stroke_report.h"

#include "nazori/practice/model_fit.h"

namespace nazori::practice {

StrokeReport report_on_last_stroke(const writing::Grade& grade, int written, int of_model) {
  const int last = written - 1;
  const auto* const verdict = static_cast<std::size_t>(last) < grade.strokes.size()
                                  ? &grade.strokes[static_cast<std::size_t>(last)]
                                  : nullptr;
  const bool is_wrong = verdict != nullptr && !verdict->ok;
  for (const auto& mistake : grade.mistakes) {
    // An exchange may show only with its second stroke, where both are alike.
    const bool is_about_it = mistake.stroke == last || (is_wrong && mistake.second == last);
    if (!is_about_it || mistake.kind == kanji::MistakeKind::missing) continue;
    return {{.event = StageEvent::mistake, .tone = Tone::wrong, .mistake = mistake},
            true,
            mistake.kind != kanji::MistakeKind::order};
  }
  if (is_wrong)
    return {{.event = StageEvent::not_of_character, .tone = Tone::wrong}, true, !verdict->matched};
  for (const auto& advice : grade.advice)
    if (advice.stroke == last)
      return {{.event = StageEvent::stroke_advice, .tone = Tone::advice, .mistake = advice}};
  const int number = (verdict != nullptr ? verdict->matched.value_or(last) : last) + 1;
  // What was passed over is named as long as it is missing.
  const auto missing = missing_strokes(grade, of_model);
  if (!missing.empty() && missing.front() + 1 < number)
    return {{.event = StageEvent::stroke_right_other_missing,
             .tone = Tone::advice,
             .stroke = number,
             .other = missing.front() + 1}};
  return {{.event = StageEvent::stroke_right,
           .tone = Tone::good,
           .stroke = number,
           .count = static_cast<int>(missing.size())}};
}

int expected_stroke(const writing::Grade& grade, int written, int of_model) {
  // The first that was missing before this one.
  writing::Grade before = grade;
  if (before.strokes.size() == static_cast<std::size_t>(written)) before.strokes.pop_back();
  const auto missing = missing_strokes(before, of_model);
  return missing.empty() ? 0 : missing.front();
}

}  // namespace nazori::practice
