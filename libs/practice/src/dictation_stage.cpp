// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/dictation_stage.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/practice/blank_tablet.h"
#include "nazori/practice/stroke_report.h"
#include "nazori/practice/writing_results.h"

namespace nazori::practice {
namespace {

Tone tone_of(const DictationStage::Box& box) {
  if (!box.is_accepted()) return Tone::wrong;
  return box.writing.grade.advice.empty() ? Tone::good : Tone::advice;
}

StageDetails details_of(const DictationStage::Box& box) {
  const auto& grade = box.writing.grade;
  std::vector<std::string> mistakes;
  for (const auto& mistake : grade.mistakes) mistakes.emplace_back(kanji::name_of(mistake.kind));
  return {{"char", base::encode_utf8(box.character)},
          {"accepted", box.is_accepted()},
          {"score", grade.score},
          {"mistakes", std::move(mistakes)},
          {"hints", box.hints},
          {"shown", box.was_shown}};
}

}  // namespace

DictationStage::DictationStage(const StageParts& parts)
    : PracticeStage(parts.tablet),
      library_(parts.library),
      knows_(parts.knows),
      attempt_(parts.tablet, parts.judge),
      characters_ready_(library_.characters_ready.connect(
          [this](const std::vector<kanji::Character>& found) { use_characters(found); })) {
  attempt_.failed.connect([this](const base::Error& error) {
    report({.event = StageEvent::judging_failed, .tone = Tone::wrong, .error = error});
  });
  attempt_.stroke_ended.connect([this](const HandStroke& stroke) { add_stroke(stroke); });
  attempt_.pen_moved.connect([this] { show_writing(); });
  attempt_.eraser_used.connect([this] { undo(); });
  attempt_.checked.connect([this](bool is_about_new) { use_check(is_about_new); });
  attempt_.judged.connect([this] { finish_character(); });
  attempt_.other_written.connect([this](char32_t written, char32_t asked, bool was_finished) {
    use_other(written, asked, was_finished);
  });
}

std::vector<StageCommand> DictationStage::commands() {
  return {{"undo", [this] { undo(); }},
          {"clear", [this] { start_over(); }},
          {"hint", [this] { give_hint(); }},
          {"answer", [this] { show_answer(); }},
          {"finish", [this] { finish_writing(); }},
          {"next_word", [this] { next_word(); }},
          {"speak", [this] { speak(); }}};
}

StageDetails DictationStage::details(const StageFeedback& what) const {
  if (word() == nullptr) return {};
  if (what.own == kWordAsked || what.own == kSpeechWanted)
    return {{"reading", word()->prompt()},
            {"meaning", word()->word.glosses.empty() ? std::string() : word()->word.glosses.front()}};
  if (what.own == kCharacterWritten) return details_of(boxes_[static_cast<std::size_t>(what.stroke - 1)]);
  if (what.own != kWordJudged) return {};
  std::vector<StageDetails> characters;
  for (const auto& box : boxes_) characters.push_back(details_of(box));
  return {{"word", word()->word.text},
          {"accepted", is_accepted()},
          {"score", score()},
          {"characters", std::move(characters)}};
}

bool DictationStage::hides_character() const {
  return is_entered() && (state_ == State::coming || state_ == State::writing);
}

bool DictationStage::is_accepted() const {
  return !boxes_.empty() &&
         std::all_of(boxes_.begin(), boxes_.end(), [](const Box& b) { return b.is_accepted(); });
}

int DictationStage::score() const {
  if (boxes_.empty()) return 0;
  const int sum = std::accumulate(boxes_.begin(), boxes_.end(), 0, [](int so_far, const Box& box) {
    return so_far + (box.was_shown ? 0 : box.writing.grade.score);
  });
  return sum / static_cast<int>(boxes_.size());
}

void DictationStage::begin() {
  put_aside();
  tablet().set_guides(TabletGuides{});
  tablet().set_judged(true);
  tablet().set_tablet(blank_tablet());
  const char32_t character = subject().sheet ? subject().sheet->character.code_point : 0;
  if (character != character_ || words_.empty()) {
    character_ = character;
    words_.clear();
    boxes_.clear();
    if (subject().sheet) words_ = best_known_first(subject().sheet->dictation, character, knows_);
    if (words_.empty()) {
      attempt_.end();
      tablet().set_writing({});
      set_state(State::unavailable);
      if (subject().sheet) report_own(kNoWord, Tone::advice);
    } else {
      ask_for(0);
    }
    return;
  }
  if (boxes_.empty()) {
    ask_for(chosen_);
    return;
  }
  // The word goes on where it was left.
  const bool is_over = state_ == State::judged;
  auto& box = boxes_[position_];
  auto kept = is_over ? box.writing : std::exchange(box.writing, {});
  open(position_);
  attempt_.restore(std::move(kept));
  show_writing();
  if (is_over) {
    set_state(State::judged);
    report_own(kWordJudged, is_accepted() ? Tone::good : Tone::wrong, static_cast<int>(boxes_.size()));
  } else {
    report_own(kWordAsked, Tone::hint, static_cast<int>(boxes_.size()));
    // A stroke that was lifted just before has no verdict yet.
    if (!attempt_.is_empty()) attempt_.ask(false);
  }
}

void DictationStage::end() {
  put_aside();
  attempt_.end();
  tablet().set_writing({});
  tablet().set_judged(false);
}

void DictationStage::put_aside() {
  if (!boxes_.empty() && state_ == State::writing && !attempt_.is_empty())
    boxes_[position_].writing = attempt_.take();
}

void DictationStage::forget() {
  character_ = 0;
  words_.clear();
  boxes_.clear();
  attempt_.clear();
  if (is_entered()) enter(StageSubject(subject()));
}

void DictationStage::ask_for(std::size_t word) {
  chosen_ = word;
  boxes_.clear();
  position_ = 0;
  attempt_.end();
  tablet().set_writing({});
  set_state(State::coming);
  library_.request_characters(words_[word].characters);
}

void DictationStage::use_characters(const std::vector<kanji::Character>& characters) {
  if (!is_entered() || state_ != State::coming) return;
  std::vector<Box> boxes;
  for (const auto& one : characters) {
    Box box;
    box.character = one.code_point;
    box.model = blank_tablet(tablet::tablet_lines(one.lines()));
    boxes.push_back(std::move(box));
  }
  const auto& wanted = words_[chosen_].characters;
  // The answer to an earlier question.
  if (!std::equal(boxes.begin(), boxes.end(), wanted.begin(), wanted.end(),
                  [](const Box& box, char32_t character) { return box.character == character; }))
    return;
  boxes_ = std::move(boxes);
  open(0);
  report_own(kWordAsked, Tone::hint, static_cast<int>(boxes_.size()));
}

void DictationStage::open(std::size_t position) {
  position_ = position;
  attempt_.begin(boxes_[position].character, boxes_[position].model);
  set_state(State::writing);
  show_writing();
}

void DictationStage::reopen(std::size_t position) {
  auto kept = std::move(boxes_[position].writing);
  boxes_[position].writing = {};
  boxes_[position].is_finished = false;
  boxes_[position].other = 0;
  open(position);
  attempt_.restore(std::move(kept));
  attempt_.show_model_strokes({});
}

void DictationStage::add_stroke(HandStroke stroke) {
  if (state_ == State::judged) {
    report_own(kWordOver, Tone::advice);
    return;
  }
  if (state_ != State::writing) return;
  if (attempt_.is_full()) {
    report({.event = StageEvent::tablet_full, .tone = Tone::advice});
    return;
  }
  attempt_.add(std::move(stroke), true);
  show_writing();
  changed();
}

void DictationStage::use_check(bool is_about_new) {
  show_writing();
  if (!is_about_new) return;
  if (attempt_.is_complete())
    attempt_.ask(true);
  else
    report(report_on_last_stroke(attempt_.grade(), static_cast<int>(attempt_.strokes().size()),
                                 attempt_.stroke_count())
               .feedback);
}

void DictationStage::finish_writing() {
  if (state_ == State::judged) {
    next_word();
    return;
  }
  if (state_ != State::writing) return;
  if (!attempt_.is_empty())
    attempt_.ask(true);
  else if (boxes_[position_].was_shown)
    finish_character();
  else
    report({.event = StageEvent::nothing_written, .tone = Tone::advice});
}

void DictationStage::finish_character() {
  if (state_ != State::writing) return;
  auto& box = boxes_[position_];
  attempt_.show_model_strokes(attempt_.missing());
  box.writing = attempt_.content();
  box.is_finished = true;
  const auto next = position_ + 1;
  if (next == boxes_.size()) {
    finish_word();
    return;
  }
  open(next);
  report({.event = StageEvent::own,
          .own = kCharacterWritten,
          .tone = tone_of(boxes_[next - 1]),
          .stroke = static_cast<int>(next),
          .other = static_cast<int>(next) + 1});
}

void DictationStage::use_other(char32_t written, char32_t asked, bool was_finished) {
  if (!is_entered() || boxes_.empty()) return;
  if (was_finished) {
    // The answer may come when the next character, or none, is being written.
    for (auto& box : boxes_)
      if (box.character == asked && (box.is_finished || box.character == boxes_[position_].character) &&
          !box.writing.grade.accepted)
        box.other = written;
    changed();
  }
  report({.event = StageEvent::other_character,
          .tone = Tone::wrong,
          .written = written,
          .asked = was_finished ? asked : 0});
}

void DictationStage::finish_word() {
  set_state(State::judged);
  show_writing();
  const bool is_right =
      std::all_of(boxes_.begin(), boxes_.end(), [](const Box& box) { return tone_of(box) == Tone::good; });
  report_own(kWordJudged,
             is_right        ? Tone::good
             : is_accepted() ? Tone::advice
                             : Tone::wrong,
             static_cast<int>(boxes_.size()));
  study::WritingResult result;
  for (const auto& box : boxes_) {
    // Mistakes are numbered by the strokes of the character that is practised.
    if (box.character == character_) result = to_result(box.writing.grade);
  }
  result.hints = 0;
  for (const auto& box : boxes_) {
    result.hints += box.hints;
    if (box.was_shown) result.shown_strokes += static_cast<int>(box.model->lines().size());
  }
  result.accepted = is_accepted();
  result.score = score();
  finished(result);
}

void DictationStage::undo() {
  if (state_ == State::judged) {
    reopen(position_);
    (void)attempt_.undo(true);
  } else if (state_ != State::writing) {
    return;
  } else if (!attempt_.undo(true)) {
    if (position_ == 0) return;
    reopen(position_ - 1);
    (void)attempt_.undo(true);
  }
  show_writing();
  changed();
  report({.event = StageEvent::stroke_undone, .count = static_cast<int>(attempt_.strokes().size())});
}

void DictationStage::start_over() {
  if (state_ == State::judged) {
    ask_for(chosen_);
  } else if (state_ == State::writing) {
    open(position_);
    report_own(kWordAsked, Tone::hint, static_cast<int>(boxes_.size()));
  }
}

void DictationStage::give_hint() {
  if (state_ != State::writing) return;
  const auto hint = attempt_.give_hint();
  if (hint == WritingAttempt::Hint::none_missing) {
    report({.event = StageEvent::all_strokes_there});
    return;
  }
  ++boxes_[position_].hints;
  show_writing();
  if (hint == WritingAttempt::Hint::next)
    report({.event = StageEvent::hint_given, .stroke = attempt_.missing().front() + 1});
  else
    report({.event = StageEvent::all_hints_given});
}

void DictationStage::show_answer() {
  if (state_ != State::writing) return;
  boxes_[position_].was_shown = true;
  attempt_.show_answer();
  show_writing();
  changed();
  report({.event = StageEvent::answer_shown});
}

void DictationStage::next_word() {
  if (!words_.empty()) ask_for((chosen_ + 1) % words_.size());
}

void DictationStage::speak() {
  if (word() == nullptr) return;
  speech_wanted(word()->spoken());
  report_own(kSpeechWanted, Tone::hint);
}

void DictationStage::set_state(State state) {
  state_ = state;
  hiding_changed();
  changed();
}

void DictationStage::report_own(std::string_view what, Tone tone, int count) {
  report({.event = StageEvent::own, .own = what, .tone = tone, .count = count});
}

void DictationStage::show_writing() {
  if (is_entered()) attempt_.show({});
}

}  // namespace nazori::practice
