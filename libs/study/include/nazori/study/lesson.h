// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "nazori/study/writing_result.h"

namespace nazori::study {

/// What a learner does with a character.
enum class Stage : std::uint8_t {
  watch = 0,   ///< a brush shows the strokes
  trace = 1,   ///< the learner follows the grooves, with arrows and numbers
  guided = 2,  ///< with help that fades
  memory = 3,  ///< blank tablet
  brush = 4,   ///< with a brush on paper; reviewed apart from the others, once the character is well known
};
/// The stages of a lesson, in its order.
inline constexpr std::array kStages{Stage::watch, Stage::trace, Stage::guided, Stage::memory};

/// "watch", "trace", "guided", "memory", "brush"; empty for an invalid number, as with every name_of() here.
[[nodiscard]] std::string_view name_of(Stage stage);
[[nodiscard]] std::optional<Stage> stage_named(std::string_view name);

/// What a lesson does when strokes go wrong, and how fast its help fades.
struct LessonRules {
  int hint_after_misses = 2;   ///< misses of one stroke until a hint is offered automatically; it has no cost
  int show_after_misses = 3;   ///< misses until the stroke is shown and the lesson goes on; >= the above
  double help_retained = 0.7;  ///< f: share of the help that is left after each try, 0..1
  double help_per_error = 0.6;  ///< g: help that a completely failed try adds, 0..1
  double help_is_over = 0.15;   ///< below it guided writing counts as writing without help

  friend bool operator==(const LessonRules&, const LessonRules&) = default;
};

/// The help of the next try: f * help + g * error, within 0..1.
/// @param error  0 no mistake .. 1 completely failed.
/// @source J. L. Emken, R. Benitez, A. Sideris, J. E. Bobrow, D. J. Reinkensmeyer, "Motor adaptation as a
/// greedy optimization of error and effort", J. Neurophysiol. 97 (2007): the rule by which assistance as
/// needed fades.
[[nodiscard]] double faded_help(double help, double error, const LessonRules& rules = {});

/// The error of a try: 0..1. It is 1 for a try that was not accepted or where strokes were shown for half of
/// the strokes; a miss or a hint counts as half of a shown stroke, a mistake as a quarter.
[[nodiscard]] double error_of(const WritingResult& result, int strokes);

/// What to do after a miss of one stroke.
enum class MissReply : std::uint8_t {
  try_again,  ///< nothing is given away
  hint,       ///< show faintly where the stroke goes
  show,       ///< show the stroke and go on with the next
};
/// @param misses  of this stroke so far, >= 1.
[[nodiscard]] MissReply reply_to_miss(int misses, const LessonRules& rules = {});

/// The progress of a learner with one character: a pure state machine whose input is the results of stages.
/// The learner may do any stage at any time; this only proposes the next one.
class Lesson {
 public:
  /// @param stage  the stage to begin with: the last value of next_stage().
  /// @param help   the help level to begin with, 0..1.
  explicit Lesson(Stage stage = Stage::watch, double help = 1, LessonRules rules = {});

  /// Adds the result of a stage. `strokes`: of the character, >= 1.
  ///
  /// watch -> trace. trace -> guided when it was accepted without a shown stroke, else trace again, and back
  /// to watch after two failures in a row. guided -> memory when the help has faded to `help_is_over` or a
  /// try had no mistake and no miss at all; back to trace after two failures in a row. memory: done when
  /// accepted without a shown stroke; else back to guided with the help that follows from the error. brush is
  /// no part of a lesson and changes nothing.
  void finish(Stage stage, const WritingResult& result, int strokes);

  [[nodiscard]] Stage next_stage() const { return stage_; }  ///< what to do next
  [[nodiscard]] bool done() const { return done_; }          ///< written from memory: the lesson is over
  [[nodiscard]] double help() const { return help_; }        ///< for the next guided try, 0..1
  [[nodiscard]] int failures() const { return failures_; }   ///< in a row, in the present stage

 private:
  void go_to(Stage stage);
  Stage stage_;
  double help_;
  LessonRules rules_;
  int failures_ = 0;
  bool done_ = false;
};

}  // namespace nazori::study
