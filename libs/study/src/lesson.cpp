// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/lesson.h"

#include <algorithm>
#include <cassert>

#include "named_values.h"

namespace nazori::study {
namespace {

constexpr int kFailuresToStepBack = 2;

bool succeeded(const WritingResult& result) { return result.accepted && result.shown_strokes == 0; }

}  // namespace

std::string_view name_of(Stage stage) {
  switch (stage) {
    case Stage::watch:
      return "watch";
    case Stage::trace:
      return "trace";
    case Stage::guided:
      return "guided";
    case Stage::memory:
      return "memory";
    case Stage::brush:
      return "brush";
  }
  return {};
}

std::optional<Stage> stage_named(std::string_view name) { return value_named<Stage>(name); }

double faded_help(double help, double error, const LessonRules& rules) {
  return std::clamp(rules.help_retained * help + rules.help_per_error * std::clamp(error, 0.0, 1.0), 0.0,
                    1.0);
}

double error_of(const WritingResult& result, int strokes) {
  assert(strokes >= 1);
  if (!result.accepted) return 1;
  const double shown = result.shown_strokes + 0.5 * (result.misses + result.hints) +
                       0.25 * static_cast<double>(result.mistakes.size());
  return std::clamp(2 * shown / strokes, 0.0, 1.0);
}

MissReply reply_to_miss(int misses, const LessonRules& rules) {
  if (misses >= rules.show_after_misses) return MissReply::show;
  return misses >= rules.hint_after_misses ? MissReply::hint : MissReply::try_again;
}

Lesson::Lesson(Stage stage, double help, LessonRules rules)
    : stage_(stage), help_(std::clamp(help, 0.0, 1.0)), rules_(rules) {}

void Lesson::go_to(Stage stage) {
  if (stage != stage_) failures_ = 0;
  stage_ = stage;
}

void Lesson::finish(Stage stage, const WritingResult& result, int strokes) {
  if (stage == Stage::brush) return;
  // A stage of the learner's own choice counts like the proposed one.
  go_to(stage);
  done_ = false;
  const bool success = succeeded(result);
  failures_ = success ? 0 : failures_ + 1;
  switch (stage) {
    case Stage::watch:
      go_to(Stage::trace);
      return;
    case Stage::trace:
      if (success) {
        go_to(Stage::guided);
      } else if (failures_ >= kFailuresToStepBack) {
        go_to(Stage::watch);
      }
      return;
    case Stage::guided: {
      const double error = error_of(result, strokes);
      help_ = faded_help(help_, error, rules_);
      if (success && (error == 0 || help_ <= rules_.help_is_over)) {
        go_to(Stage::memory);
      } else if (failures_ >= kFailuresToStepBack) {
        go_to(Stage::trace);
      }
      return;
    }
    case Stage::memory:
      if (success) {
        done_ = true;
      } else {
        help_ = faded_help(help_, error_of(result, strokes), rules_);
        go_to(Stage::guided);
      }
      return;
    case Stage::brush:
      return;
  }
}

}  // namespace nazori::study
