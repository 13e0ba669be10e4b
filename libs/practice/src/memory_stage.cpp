// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/memory_stage.h"

#include <algorithm>
#include <utility>

#include "nazori/practice/model_fit.h"

namespace nazori::practice {
namespace {

constexpr double kModelOver = 0.9;   ///< opacity of the model over the writing
constexpr double kModelHint = 0.75;  ///< and of a hint

}  // namespace

MemoryStage::MemoryStage(base::Inbox& inbox, TabletControl& control, WritingJudge& judge)
    : PracticeStage(control),
      judge_(judge),
      groove_(inbox, [this](const Tablet& put) { tablet().set_tablet(put); }),
      judged_(judge.judged.connect(
          [this](std::uint64_t number, const writing::Grade& grade) { use_grade(number, grade); })),
      failed_(judge.judging_failed.connect([this](std::uint64_t number, const base::Error& error) {
        if (number == awaited_) awaited_ = 0;
        if (number == live_number_ || number == whole_number_)
          report({.event = StageEvent::judging_failed, .tone = Tone::wrong, .error = error});
      })),
      reported_(judge.pen_reported.connect([this](std::uint64_t number, const PenReport& pen) {
        if (number == whole_number_) pen_ = pen;
      })),
      pressed_(control.pressed.connect([this](geometry::TabletPoint at) { recorder_.press_at(at); })),
      sampled_(control.sampled.connect([this](std::span<const haptics::ServoSample> samples) {
        if (is_entered()) record(samples);
      })),
      erased_(control.eraser_used.connect([this] {
        if (is_entered()) undo();
      })) {}

bool MemoryStage::hides_character() const {
  return is_entered() && state_ == State::writing && !shows_groove();
}

bool MemoryStage::shows_groove() const {
  // What a lesson asks for from memory is not shown, whatever the learner chose for free writing.
  return options_.groove == WritingGroove::Mode::shown && !is_lesson();
}

void MemoryStage::set_judges_each(bool on) {
  options_.judges_each = on;
  seen_.assign(strokes_.size(), on || state_ == State::judged);
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
  if (!strokes_.empty()) ask(state_ == State::judged);
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
  const bool is_empty = strokes_.empty() && state_ == State::writing;
  if (character_ == 0 || is_empty || (aside_ && aside_->unrated)) return;
  const bool unrated = was_lesson_ && state_ != State::writing;
  aside_ = {character_, std::move(strokes_), grade_, pen_, seen_, hinted_, hints_, state_, unrated};
  strokes_.clear();
}

void MemoryStage::forget() {
  aside_.reset();
  if (!is_entered() || (strokes_.empty() && state_ == State::writing)) return;
  clear();
  invite();
}

void MemoryStage::resume() {
  Aside back = *std::exchange(aside_, std::nullopt);
  clear();
  strokes_ = std::move(back.strokes);
  grade_ = std::move(back.grade);
  pen_ = std::move(back.pen);
  seen_ = std::move(back.seen);
  hinted_ = std::move(back.hinted);
  hints_ = back.hints;
  set_state(back.state);
  groove_.carve(right_strokes());
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
      ask(false);
      invite();
      break;
  }
}

void MemoryStage::end() {
  live_number_ = whole_number_ = 0;
  replay_stopped();
  groove_.end();
  put_aside();
  character_ = 0;
  strokes_.clear();
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
  is_model_over_ = false;
  moment_s_.reset();
  started_over();
  strokes_.clear();
  seen_.clear();
  hinted_.clear();
  grade_ = {};
  pen_ = {};
  hints_ = 0;
  is_refused_ = false;
  live_number_ = whole_number_ = 0;
  recorder_.drop();
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
  groove_.carve(right_strokes());
}

std::vector<int> MemoryStage::right_strokes() const {
  std::vector<int> right;
  for (const auto& verdict : grade_.strokes)
    if (verdict.ok && verdict.matched) right.push_back(*verdict.matched);
  return right;
}

void MemoryStage::invite() {
  if (subject().sheet) report({.event = StageEvent::write_character, .count = stroke_count()});
}

void MemoryStage::set_state(State state) {
  state_ = state;
  hiding_changed();
}

void MemoryStage::record(std::span<const haptics::ServoSample> samples) {
  recorder_.lean(tablet().lean_rad());
  bool grew = false;
  for (const auto& sample : samples) {
    const auto event = recorder_.follow(sample);
    grew = grew || event != PenRecorder::Event::none;
    if (event == PenRecorder::Event::ended) add_stroke(recorder_.take());
  }
  if (grew) show_writing();
}

void MemoryStage::add_stroke(HandStroke stroke) {
  replay_stopped();
  if (strokes_.size() >= writing::kMaxInkStrokes) {
    report({.event = StageEvent::tablet_full, .tone = Tone::advice});
    return;
  }
  if (state_ != State::writing) {
    seen_.assign(strokes_.size(), options_.judges_each);
    set_state(State::writing);
    continued();
  }
  // In a lesson what was refused makes room for the next try.
  drop_mistake();
  strokes_.push_back(std::move(stroke));
  seen_.push_back(options_.judges_each);
  hinted_.clear();
  hints_ = 0;
  awaits_report_ = true;
  stroke_added();
  ask(false);
  show_writing();
  changed();
}

void MemoryStage::ask(bool as_a_whole) {
  if (!subject().sheet) return;
  JudgeRequest request;
  request.character = subject().sheet->character.code_point;
  request.ink = to_ink(strokes_, geometry::TabletShape{});
  request.strictness = options_.strictness;
  request.finished = as_a_whole;
  awaited_ = judge_.judge(request);
  (as_a_whole ? whole_number_ : live_number_) = awaited_;
}

void MemoryStage::finish_writing() {
  if (strokes_.empty())
    report({.event = StageEvent::nothing_written, .tone = Tone::advice});
  else
    ask(true);
}

void MemoryStage::use_grade(std::uint64_t number, const writing::Grade& grade) {
  if (number == awaited_) awaited_ = 0;
  if (!is_entered() || strokes_.empty()) return;
  if (number == whole_number_) {
    grade_ = grade;
    finish();
    return;
  }
  if (number != live_number_) return;
  grade_ = grade;
  groove_.carve(right_strokes());
  show_writing();
  if (!std::exchange(awaits_report_, false)) return;
  const bool is_complete = options_.judges_each && static_cast<int>(strokes_.size()) == stroke_count() &&
                           grade.mistakes.empty() && missing_strokes(grade, stroke_count()).empty();
  if (is_complete)
    ask(true);
  else
    report_last_stroke();
}

void MemoryStage::report_last_stroke() {
  const int last = static_cast<int>(strokes_.size()) - 1;
  if (!options_.judges_each) {
    report({.event = StageEvent::strokes_unjudged, .count = last + 1});
    return;
  }
  const auto* const verdict = static_cast<std::size_t>(last) < grade_.strokes.size()
                                  ? &grade_.strokes[static_cast<std::size_t>(last)]
                                  : nullptr;
  const bool is_wrong = verdict != nullptr && !verdict->ok;
  for (const auto& mistake : grade_.mistakes) {
    // An exchange may show only with its second stroke, where both are alike.
    const bool is_about_it = mistake.stroke == last || (is_wrong && mistake.second == last);
    if (!is_about_it || mistake.kind == kanji::MistakeKind::missing) continue;
    report_mistake({.event = StageEvent::mistake, .mistake = mistake},
                   mistake.kind != kanji::MistakeKind::order);
    return;
  }
  if (is_wrong) {
    report_mistake({.event = StageEvent::not_of_character}, !verdict->matched);
    return;
  }
  for (const auto& advice : grade_.advice)
    if (advice.stroke == last) {
      report({.event = StageEvent::stroke_advice, .tone = Tone::advice, .mistake = advice});
      return;
    }
  const int number = (verdict != nullptr ? verdict->matched.value_or(last) : last) + 1;
  // What was passed over is named as long as it is missing.
  const auto missing = missing_strokes(grade_, stroke_count());
  if (!missing.empty() && missing.front() + 1 < number)
    report({.event = StageEvent::stroke_right_other_missing,
            .tone = Tone::advice,
            .stroke = number,
            .other = missing.front() + 1});
  else
    report({.event = StageEvent::stroke_right,
            .tone = Tone::good,
            .stroke = number,
            .count = static_cast<int>(missing.size())});
}

void MemoryStage::report_mistake(StageFeedback what, bool can_be_tried_again) {
  // The stroke that should have come: the first that was missing before this one.
  writing::Grade before = grade_;
  if (before.strokes.size() == strokes_.size()) before.strokes.pop_back();
  const auto missing = missing_strokes(before, stroke_count());
  const int expected = missing.empty() ? 0 : missing.front();
  is_refused_ = is_lesson() && can_be_tried_again;
  what.tone = Tone::wrong;
  switch (reply_to_mistake(expected)) {
    case study::MissReply::try_again:
      report(what);
      return;
    case study::MissReply::hint:
      what.more = MistakeHelp::hint;
      report(what);
      return;
    case study::MissReply::show:
      drop_mistake();
      hinted_ = {expected};
      show_writing();
      changed();
      report({.event = StageEvent::stroke_hinted, .tone = Tone::advice, .stroke = expected + 1});
      return;
  }
}

void MemoryStage::drop_mistake() {
  if (!std::exchange(is_refused_, false) || strokes_.empty()) return;
  strokes_.pop_back();
  seen_.pop_back();
  if (grade_.strokes.size() > strokes_.size()) grade_.strokes.resize(strokes_.size());
}

void MemoryStage::finish() {
  seen_.assign(strokes_.size(), true);
  hinted_ = missing_strokes(grade_, stroke_count());
  set_state(State::judged);
  show_writing();
  report({.event = StageEvent::judged, .tone = tone_of_judgement()});
  changed();
  judged(grade_);
}

Tone MemoryStage::tone_of_judgement() const {
  if (!grade_.accepted) return Tone::wrong;
  return grade_.advice.empty() && pen_.remarks.empty() ? Tone::good : Tone::advice;
}

void MemoryStage::undo() {
  replay_stopped();
  if (!recorder_.current().empty()) {
    recorder_.drop();
  } else if (!strokes_.empty()) {
    strokes_.pop_back();
    seen_.assign(strokes_.size(), options_.judges_each);
  } else {
    return;
  }
  is_refused_ = false;
  hinted_.clear();
  hints_ = 0;
  set_state(State::writing);
  continued();
  awaits_report_ = false;
  if (strokes_.empty()) {
    grade_ = {};
    live_number_ = 0;
    put_groove();
  } else {
    if (grade_.strokes.size() > strokes_.size()) grade_.strokes.resize(strokes_.size());
    ask(false);
  }
  show_writing();
  changed();
  report({.event = StageEvent::stroke_undone, .count = static_cast<int>(strokes_.size())});
}

void MemoryStage::give_hint() {
  const auto missing = missing_strokes(grade_, stroke_count());
  if (missing.empty()) {
    report({.event = StageEvent::all_strokes_there});
    return;
  }
  ++hints_;
  hint_given();
  hinted_ = hints_ == 1 ? std::vector<int>{missing.front()} : missing;
  show_writing();
  if (hints_ == 1)
    report({.event = StageEvent::hint_given, .stroke = missing.front() + 1});
  else
    report({.event = StageEvent::all_hints_given});
}

void MemoryStage::show_answer() {
  // A verdict that is still on its way would be reported over the answer.
  awaits_report_ = false;
  live_number_ = whole_number_ = 0;
  hinted_.clear();
  for (int n = 0; n < stroke_count(); ++n) hinted_.push_back(n);
  set_state(State::answer_shown);
  show_writing();
  changed();
  answer_was_shown();
  report({.event = StageEvent::answer_shown});
}

void MemoryStage::set_model_over(bool on) {
  is_model_over_ = on;
  show_writing();
}

void MemoryStage::show_moment(std::optional<double> time_s) {
  if (!is_entered()) return;
  moment_s_ = time_s;
  show_writing();
}

void MemoryStage::show_writing() {
  if (!is_entered()) return;
  std::vector<view::InkedStroke> all;
  const auto of_strokes = verdicts(grade_, strokes_.size());
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const HandStroke shown =
        moment_s_ ? until(strokes_[i], strokes_.front().front().time_s.value_or(0) + *moment_s_)
                  : strokes_[i];
    if (!shown.empty()) all.push_back(view::inked(shown, seen_[i] ? of_strokes[i] : view::Verdict::none));
  }
  if (!recorder_.current().empty()) all.push_back(view::inked(recorder_.current(), view::Verdict::none));
  if (subject().tablet) {
    const auto& paths = subject().tablet->paths();
    const ModelFit fit =
        options_.groove == WritingGroove::Mode::hidden ? fit_model(strokes_, grade_, paths) : ModelFit{};
    for (int n = 0; n < stroke_count(); ++n) {
      const bool is_hinted = std::find(hinted_.begin(), hinted_.end(), n) != hinted_.end();
      if (is_model_over_ || is_hinted)
        all.push_back(
            model_line(paths[static_cast<std::size_t>(n)], fit, is_model_over_ ? kModelOver : kModelHint));
    }
    writing_shown();
  }
  tablet().set_writing(std::move(all));
}

}  // namespace nazori::practice
