// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_attempt.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "nazori/practice/model_fit.h"

namespace nazori::practice {
namespace {

constexpr double kModelOver = 0.9;   ///< opacity of the model over the writing
constexpr double kModelHint = 0.75;  ///< and of a hint

/// The character that the grader has found in place of the one asked for; 0: none.
char32_t other_in(const writing::Grade& grade) {
  for (const auto& mistake : grade.mistakes)
    if (mistake.kind == kanji::MistakeKind::other) return mistake.character;
  return 0;
}

}  // namespace

WritingAttempt::WritingAttempt(TabletControl& tablet, WritingJudge& judge)
    : tablet_(tablet),
      judge_(judge),
      judged_(judge.judged.connect(
          [this](std::uint64_t number, const writing::Grade& grade) { use_grade(number, grade); })),
      failed_(judge.judging_failed.connect(
          [this](std::uint64_t number, const base::Error& error) { use_error(number, error); })),
      named_(judge.named.connect(
          [this](std::uint64_t number, char32_t character) { use_name(number, character); })),
      reported_(judge.pen_reported.connect([this](std::uint64_t number, const PenReport& pen) {
        if (number == whole_number_) content_.pen = pen;
      })),
      pressed_(tablet.pressed.connect([this](geometry::TabletPoint at) { recorder_.press_at(at); })),
      sampled_(tablet.sampled.connect([this](std::span<const haptics::ServoSample> samples) {
        if (is_open_) record(samples);
      })),
      erased_(tablet.eraser_used.connect([this] {
        if (is_open_) eraser_used();
      })) {}

void WritingAttempt::begin(char32_t character, Tablet model) {
  character_ = character;
  model_ = std::move(model);
  is_open_ = true;
  // A word goes on with its next character before the answer about the one before is there.
  const auto naming = names_whole_ && named_for_ != character ? naming_ : 0;
  clear();
  naming_ = naming;
}

void WritingAttempt::end() {
  is_open_ = false;
  awaited_ = 0;
  live_number_ = whole_number_ = 0;
  content_ = {};
  tried_.clear();
  naming_ = 0;
}

void WritingAttempt::clear() {
  content_ = {};
  tried_.clear();
  naming_ = 0;
  is_refused_ = false;
  live_number_ = whole_number_ = 0;
  recorder_.drop();
}

int WritingAttempt::stroke_count() const { return model_ ? static_cast<int>(model_->lines().size()) : 0; }

bool WritingAttempt::is_complete() const {
  return static_cast<int>(content_.strokes.size()) == stroke_count() && content_.grade.mistakes.empty() &&
         missing().empty();
}

std::vector<int> WritingAttempt::missing() const { return missing_strokes(content_.grade, stroke_count()); }

std::vector<int> WritingAttempt::right_strokes() const {
  std::vector<int> right;
  for (const auto& verdict : content_.grade.strokes)
    if (verdict.ok && verdict.matched) right.push_back(*verdict.matched);
  return right;
}

void WritingAttempt::record(std::span<const haptics::ServoSample> samples) {
  recorder_.lean(tablet_.lean_rad());
  bool grew = false;
  for (const auto& sample : samples) {
    const auto event = recorder_.follow(sample);
    grew = grew || event != PenRecorder::Event::none;
    if (event == PenRecorder::Event::ended) stroke_ended(recorder_.take());
  }
  if (grew) pen_moved();
}

void WritingAttempt::add(HandStroke stroke, bool shows_verdict) {
  drop_refused();
  naming_ = 0;
  if (tried_.size() < writing::kMaxInkStrokes) tried_.push_back(stroke);
  content_.strokes.push_back(std::move(stroke));
  content_.seen.push_back(shows_verdict);
  content_.hinted.clear();
  content_.hints = 0;
  awaits_report_ = true;
  ask(false);
}

void WritingAttempt::drop_refused() {
  if (!std::exchange(is_refused_, false) || content_.strokes.empty()) return;
  content_.strokes.pop_back();
  content_.seen.pop_back();
  auto& verdicts_so_far = content_.grade.strokes;
  if (verdicts_so_far.size() > content_.strokes.size()) verdicts_so_far.resize(content_.strokes.size());
}

bool WritingAttempt::undo(bool shows_verdicts) {
  if (!recorder_.current().empty()) {
    recorder_.drop();
  } else if (!content_.strokes.empty()) {
    content_.strokes.pop_back();
    if (!tried_.empty()) tried_.pop_back();
    show_verdicts(shows_verdicts);
  } else {
    return false;
  }
  is_refused_ = false;
  naming_ = 0;
  content_.hinted.clear();
  content_.hints = 0;
  awaits_report_ = false;
  if (content_.strokes.empty()) {
    content_.grade = {};
    live_number_ = 0;
  } else {
    auto& verdicts_so_far = content_.grade.strokes;
    if (verdicts_so_far.size() > content_.strokes.size()) verdicts_so_far.resize(content_.strokes.size());
    ask(false);
  }
  return true;
}

void WritingAttempt::ask(bool as_a_whole) {
  if (character_ == 0) return;
  JudgeRequest request;
  request.character = character_;
  request.ink = to_ink(content_.strokes, geometry::TabletShape{});
  request.strictness = strictness_;
  request.finished = as_a_whole;
  awaited_ = judge_.judge(request);
  (as_a_whole ? whole_number_ : live_number_) = awaited_;
}

void WritingAttempt::ignore_answers() {
  awaits_report_ = false;
  live_number_ = whole_number_ = 0;
}

WritingAttempt::Hint WritingAttempt::give_hint() {
  const auto left = missing();
  if (left.empty()) return Hint::none_missing;
  ++content_.hints;
  content_.hinted = content_.hints == 1 ? std::vector<int>{left.front()} : left;
  return content_.hints == 1 ? Hint::next : Hint::all;
}

void WritingAttempt::show_answer() {
  // A verdict that is still on its way would be reported over the answer.
  ignore_answers();
  content_.hinted.resize(static_cast<std::size_t>(stroke_count()));
  std::iota(content_.hinted.begin(), content_.hinted.end(), 0);
}

void WritingAttempt::use_grade(std::uint64_t number, const writing::Grade& grade) {
  if (number == awaited_) awaited_ = 0;
  if (!is_open_ || content_.strokes.empty()) return;
  if (number == whole_number_) {
    content_.grade = grade;
    const char32_t asked = character_;
    const char32_t other = other_in(grade);
    if (!grade.accepted && other == 0) name_other(true);
    judged();
    if (other != 0) other_written(other, asked, true);
  } else if (number == live_number_) {
    content_.grade = grade;
    const bool is_about_new = std::exchange(awaits_report_, false);
    checked(is_about_new);
    if (is_about_new && !grade.mistakes.empty()) name_other(false);
  }
}

void WritingAttempt::use_error(std::uint64_t number, const base::Error& error) {
  if (number == awaited_) awaited_ = 0;
  if (number == live_number_ || number == whole_number_) failed(error);
}

void WritingAttempt::name_other(bool as_a_whole) {
  if (!as_a_whole) {
    // While it is written, only what is mostly wrong can be another character: 木 is the beginning of 林.
    const auto right = static_cast<std::size_t>(
        std::count_if(content_.grade.strokes.begin(), content_.grade.strokes.end(),
                      [](const writing::StrokeVerdict& verdict) { return verdict.ok; }));
    if (tried_.empty() || 2 * right >= tried_.size() || (tried_.size() == 1 && stroke_count() != 1)) return;
  }
  named_for_ = character_;
  names_whole_ = as_a_whole;
  naming_ = judge_.name_other(to_ink(tried_.empty() ? content_.strokes : tried_, geometry::TabletShape{}),
                              character_);
}

void WritingAttempt::use_name(std::uint64_t number, char32_t character) {
  if (number != naming_) return;
  naming_ = 0;
  if (character != 0) other_written(character, named_for_, names_whole_);
}

void WritingAttempt::show(const Look& look) const {
  const auto& strokes = content_.strokes;
  std::vector<view::InkedStroke> all;
  const auto of_strokes = verdicts(content_.grade, strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const HandStroke shown =
        look.moment_s ? until(strokes[i], strokes.front().front().time_s.value_or(0) + *look.moment_s)
                      : strokes[i];
    if (!shown.empty())
      all.push_back(view::inked(shown, content_.seen[i] ? of_strokes[i] : view::Verdict::none));
  }
  if (!recorder_.current().empty())
    all.push_back(view::inked(recorder_.current(), view::Verdict::none, false));
  if (model_) {
    const auto& paths = model_->paths();
    const ModelFit fit = look.fits_model ? fit_model(strokes, content_.grade, paths) : ModelFit{};
    for (int n = 0; n < stroke_count(); ++n) {
      // What is being drawn is not there before it is drawn.
      const bool is_drawn = std::any_of(look.correction.begin(), look.correction.end(),
                                        [n](const Correction::Part& part) { return part.stroke == n; });
      if (is_drawn) continue;
      const auto& hinted = content_.hinted;
      if (look.model_over || std::find(hinted.begin(), hinted.end(), n) != hinted.end())
        all.push_back(
            model_line(paths[static_cast<std::size_t>(n)], fit, look.model_over ? kModelOver : kModelHint));
    }
    for (const auto& part : look.correction)
      all.push_back(model_line(paths[static_cast<std::size_t>(part.stroke)], fit, 1, part.share));
  }
  tablet_.set_writing(std::move(all));
}

}  // namespace nazori::practice
