// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/memory_stage.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/practice/stroke_report.h"

namespace nazori::practice {
namespace {

constexpr std::array<std::string_view, 3> kGrooveNames{"hidden", "shown", "appears"};

}  // namespace

void MemoryStage::Options::load(const base::Settings& settings) {
  judges_each = base::flag_setting(settings, "judge_each", judges_each);
  groove = base::named_setting(settings, "groove", kGrooveNames, groove);
  const double stored = base::number_setting(settings, "strictness", strictness, -1, 2);
  if (stored >= 0 && stored <= 1) strictness = stored;
}

void MemoryStage::Options::save(base::Settings& settings) const {
  base::set_flag(settings, "judge_each", judges_each);
  settings.insert_or_assign("groove", std::string(kGrooveNames[static_cast<std::size_t>(groove)]));
  base::set_number(settings, "strictness", strictness);
}

MemoryStage::MemoryStage(base::Inbox& inbox, TabletControl& control, WritingJudge& judge)
    : PracticeStage(control),
      attempt_(control, judge),
      groove_(inbox, [this](const Tablet& put) { tablet().set_tablet(put); }) {
  attempt_.failed.connect([this](const base::Error& error) {
    report({.event = StageEvent::judging_failed, .tone = Tone::wrong, .error = error});
  });
  attempt_.stroke_ended.connect([this](const HandStroke& stroke) { add_stroke(stroke); });
  attempt_.pen_moved.connect([this] { show_writing(); });
  attempt_.eraser_used.connect([this] { undo(); });
  attempt_.checked.connect([this](bool is_about_new) { use_check(is_about_new); });
  attempt_.judged.connect([this] { finish(); });
  attempt_.other_written.connect(
      [this](char32_t written, char32_t asked, bool) { report_other(written, asked); });
}

std::vector<StageCommand> MemoryStage::commands() {
  return {{"undo", [this] { undo(); }},
          {"clear", [this] { start_over(); }},
          {"hint", [this] { give_hint(); }},
          {"answer", [this] { show_answer(); }},
          {"finish", [this] { finish_writing(); }}};
}

StageDetails MemoryStage::details(const StageFeedback& what) const {
  if (what.event != StageEvent::judged) return {};
  StageDetails details{{"accepted", grade().accepted}, {"score", grade().score}};
  if (grade().form) details.push_back({"form", *grade().form});
  return details;
}

bool MemoryStage::hides_character() const {
  return is_entered() && state_ == State::writing && !shows_groove();
}

bool MemoryStage::shows_groove() const {
  // What a lesson asks for from memory is not shown, whatever the learner chose for free writing.
  return options_.groove == WritingGroove::Mode::shown && !is_lesson();
}

void MemoryStage::set_judges_each(bool on) {
  options_.judges_each = on;
  attempt_.show_verdicts(on || state_ == State::judged);
  show_writing();
  report({.event = on ? StageEvent::judges_each : StageEvent::judges_at_end});
}

void MemoryStage::set_groove(WritingGroove::Mode mode) {
  options_.groove = mode;
  put_groove();
  hiding_changed();
}

void MemoryStage::set_strictness(double strictness) {
  options_.strictness = strictness;
  attempt_.set_strictness(strictness);
  if (!attempt_.is_empty()) attempt_.ask(state_ == State::judged);
}

void MemoryStage::begin() {
  tablet().set_guides(TabletGuides{});
  tablet().set_judged(true);
  // What has been rated meanwhile is done with.
  if (aside_ && aside_->unrated && !is_unrated_) aside_.reset();
  put_aside();
  was_lesson_ = is_lesson();
  character_ = subject().sheet ? subject().sheet->character.code_point : 0;
  if (resumes_ && aside_ && aside_->character == character_) {
    resume();
    return;
  }
  if (aside_ && aside_->character == character_) aside_.reset();
  clear();
  invite();
}

void MemoryStage::put_aside() {
  const bool has_nothing = attempt_.is_empty() && state_ == State::writing;
  if (character_ == 0 || has_nothing || (aside_ && aside_->unrated)) return;
  const bool unrated = was_lesson_ && state_ != State::writing;
  aside_ = {character_, attempt_.take(), state_, unrated};
}

void MemoryStage::forget() {
  aside_.reset();
  if (!is_entered() || (attempt_.is_empty() && state_ == State::writing)) return;
  clear();
  invite();
}

void MemoryStage::resume() {
  Aside back = *std::exchange(aside_, std::nullopt);
  clear();
  attempt_.restore(std::move(back.content));
  set_state(back.state);
  groove_.carve(attempt_.right_strokes());
  show_writing();
  changed();
  switch (state_) {
    case State::judged:
      report({.event = StageEvent::judged, .tone = tone_of_judgement()});
      break;
    case State::answer_shown:
      report({.event = StageEvent::answer_shown});
      break;
    case State::writing:
      // A stroke that was lifted just before has no verdict yet.
      attempt_.ask(false);
      invite();
      break;
  }
}

void MemoryStage::end() {
  replay_stopped();
  groove_.end();
  put_aside();
  character_ = 0;
  attempt_.end();
  state_ = State::writing;
  tablet().set_writing({});
  tablet().set_judged(false);
}

void MemoryStage::start_over() {
  clear();
  invite();
}

void MemoryStage::clear() {
  replay_stopped();
  // What is to be written from memory is not shown beside the empty tablet.
  look_ = {};
  correction_.clear();
  started_over();
  attempt_.begin(character_, subject().tablet);
  put_groove();
  set_state(State::writing);
  show_writing();
  changed();
}

void MemoryStage::put_groove() {
  if (!is_entered() || !subject().tablet) return;
  const auto mode = shows_groove()                                    ? WritingGroove::Mode::shown
                    : options_.groove == WritingGroove::Mode::appears ? WritingGroove::Mode::appears
                                                                      : WritingGroove::Mode::hidden;
  groove_.begin(mode, subject().tablet);
  groove_.carve(attempt_.right_strokes());
}

void MemoryStage::invite() {
  if (subject().sheet) report({.event = StageEvent::write_character, .count = stroke_count()});
}

void MemoryStage::set_state(State state) {
  state_ = state;
  correction_.clear();
  hiding_changed();
}

void MemoryStage::add_stroke(HandStroke stroke) {
  replay_stopped();
  if (attempt_.is_full()) {
    report({.event = StageEvent::tablet_full, .tone = Tone::advice});
    return;
  }
  if (state_ != State::writing) {
    attempt_.show_verdicts(options_.judges_each);
    set_state(State::writing);
    continued();
  }
  attempt_.add(std::move(stroke), options_.judges_each);
  stroke_added();
  show_writing();
  changed();
}

void MemoryStage::finish_writing() {
  if (attempt_.is_empty())
    report({.event = StageEvent::nothing_written, .tone = Tone::advice});
  else
    attempt_.ask(true);
}

void MemoryStage::use_check(bool is_about_new) {
  groove_.carve(attempt_.right_strokes());
  show_writing();
  if (!is_about_new) return;
  if (options_.judges_each && attempt_.is_complete())
    attempt_.ask(true);
  else
    report_last_stroke();
}

void MemoryStage::report_last_stroke() {
  const int written = static_cast<int>(strokes().size());
  if (!options_.judges_each) {
    report({.event = StageEvent::strokes_unjudged, .count = written});
    return;
  }
  auto found = report_on_last_stroke(grade(), written, stroke_count());
  if (!found.is_mistake) {
    report(found.feedback);
    return;
  }
  const int expected = expected_stroke(grade(), written, stroke_count());
  // In a lesson what was refused makes room for the next try.
  attempt_.refuse_last(is_lesson() && found.can_be_tried_again);
  switch (reply_to_mistake(expected)) {
    case study::MissReply::try_again:
      report(found.feedback);
      return;
    case study::MissReply::hint:
      found.feedback.more = MistakeHelp::hint;
      report(found.feedback);
      return;
    case study::MissReply::show:
      attempt_.drop_refused();
      attempt_.show_model_strokes({expected});
      show_writing();
      changed();
      report({.event = StageEvent::stroke_hinted, .tone = Tone::advice, .stroke = expected + 1});
      return;
  }
}

void MemoryStage::report_other(char32_t written, char32_t asked) {
  // Only what is on the tablet now is spoken of; without verdicts nothing is given away before the end.
  if (asked != character_ || (state_ == State::writing && !options_.judges_each)) return;
  report({.event = StageEvent::other_character,
          .tone = Tone::wrong,
          .written = written,
          .asked = hides_character() ? 0 : asked});
}

void MemoryStage::finish() {
  attempt_.show_verdicts(true);
  attempt_.show_model_strokes(attempt_.missing());
  set_state(State::judged);
  show_writing();
  report({.event = StageEvent::judged, .tone = tone_of_judgement()});
  changed();
  judged(grade());
}

Tone MemoryStage::tone_of_judgement() const {
  if (!grade().accepted) return Tone::wrong;
  return grade().advice.empty() && pen_report().remarks.empty() ? Tone::good : Tone::advice;
}

void MemoryStage::undo() {
  replay_stopped();
  if (!attempt_.undo(options_.judges_each)) return;
  set_state(State::writing);
  continued();
  if (attempt_.is_empty()) put_groove();
  show_writing();
  changed();
  report({.event = StageEvent::stroke_undone, .count = static_cast<int>(strokes().size())});
}

void MemoryStage::give_hint() {
  const auto hint = attempt_.give_hint();
  if (hint == WritingAttempt::Hint::none_missing) {
    report({.event = StageEvent::all_strokes_there});
    return;
  }
  hint_given();
  show_writing();
  if (hint == WritingAttempt::Hint::next)
    report({.event = StageEvent::hint_given, .stroke = attempt_.missing().front() + 1});
  else
    report({.event = StageEvent::all_hints_given});
}

void MemoryStage::show_answer() {
  attempt_.show_answer();
  set_state(State::answer_shown);
  show_writing();
  changed();
  answer_was_shown();
  report({.event = StageEvent::answer_shown});
}

void MemoryStage::set_model_over(bool on) {
  look_.model_over = on;
  show_writing();
}

bool MemoryStage::can_show_right() const {
  return is_entered() && state_ == State::judged && subject().tablet &&
         !strokes_to_show(grade(), stroke_count()).empty();
}

void MemoryStage::show_right(bool moves) {
  if (!can_show_right()) return;
  replay_stopped();
  correction_.begin(*subject().tablet, strokes_to_show(grade(), stroke_count()));
  if (!moves) correction_.finish();
  show_writing();
  changed();
}

void MemoryStage::advance_right(double passed_s) {
  if (!is_showing_right()) return;
  correction_.advance(passed_s);
  show_writing();
  if (!is_showing_right()) changed();
}

void MemoryStage::show_moment(std::optional<double> time_s) {
  if (!is_entered()) return;
  look_.moment_s = time_s;
  show_writing();
}

void MemoryStage::show_writing() {
  if (!is_entered()) return;
  if (subject().tablet) writing_shown();
  look_.fits_model = options_.groove == WritingGroove::Mode::hidden;
  look_.correction = correction_.parts();
  attempt_.show(look_);
}

}  // namespace nazori::practice
