// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "nazori/study/writing_result.h"

namespace nazori::study {

/// The stages by which a character is learnt.
enum class Stage : std::uint8_t {
  watch = 0,   ///< strokes are written before the learner's eyes
  trace = 1,   ///< along the groove, with arrows and numbers
  guided = 2,  ///< with help that fades
  memory = 3,  ///< blank tablet
};
inline constexpr std::array kStages{Stage::watch, Stage::trace, Stage::guided, Stage::memory};

/// "watch", "trace", "guided", "memory"; empty for a number that is no stage, as with every name_of() here.
[[nodiscard]] std::string_view name_of(Stage stage);
[[nodiscard]] std::optional<Stage> stage_named(std::string_view name);

/// What a lesson does when strokes go wrong, and how fast its help fades.
struct LessonRules {
  int hint_after_misses = 2;    ///< misses of one stroke until a hint is offered by itself; it costs nothing
  int show_after_misses = 3;    ///< misses until the stroke is shown and the lesson goes on; >= the above
  double help_retained = 0.7;   ///< f: share of the help that is left after each try, 0..1
  double help_per_error = 0.6;  ///< g: help that a wholly failed try brings back, 0..1
  double help_is_over = 0.15;   ///< below it guided writing counts as writing without help

  friend bool operator==(const LessonRules&, const LessonRules&) = default;
};

/// The help of the next try: f * help + g * error, within 0..1.
/// @param error  0 no mistake .. 1 wholly failed.
/// @source J. L. Emken, R. Benitez, A. Sideris, J. E. Bobrow, D. J. Reinkensmeyer, "Motor adaptation as a
/// greedy optimization of error and effort", J. Neurophysiol. 97 (2007): the law by which assistance that is
/// given as needed fades.
[[nodiscard]] double faded_help(double help, double error, const LessonRules& rules = {});

/// How far a try was from a good one: 0..1. One for a try that was not accepted or where strokes were shown
/// for half of the strokes; a miss or a hint counts as half of a shown stroke, a mistake as a quarter.
[[nodiscard]] double error_of(const WritingResult& result, int strokes);

/// What to do after a miss of one stroke.
enum class MissReply : std::uint8_t {
  try_again,  ///< nothing is given away
  hint,       ///< show faintly where it goes
  show,       ///< show the stroke and go on with the next
};
/// @param misses  of this stroke so far, >= 1.
[[nodiscard]] MissReply reply_to_miss(int misses, const LessonRules& rules = {});

/// Where a learner stands with one character: a pure state machine, fed with what was done. The learner may
/// do any stage at any time; this only says what to do next.
class Lesson {
 public:
  /// @param stage  the stage to begin with: what next_stage() said last time.
  /// @param help   the help level to begin with, 0..1.
  explicit Lesson(Stage stage = Stage::watch, double help = 1, LessonRules rules = {});

  /// Tells what was done in a stage. `strokes`: of the character, >= 1.
  ///
  /// watch -> trace. trace -> guided when it was accepted without a shown stroke, else trace again, and back
  /// to watch after two failures in a row. guided -> memory when the help has faded to `help_is_over` or a
  /// try had no mistake and no miss at all; back to trace after two failures in a row. memory: done when
  /// accepted without a shown stroke; else back to guided with the help that the error asks for.
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
