// SPDX-License-Identifier: Apache-2.0
#include "characters/memory_stage.h"

#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "characters/compare_view.h"
#include "characters/strictness_slider.h"
#include "characters/writing_panel.h"
#include "characters/writing_report.h"
#include "kanji_text.h"
#include "writing_language.h"

namespace nazori::ui {
namespace {

constexpr double kModelOver = 0.9;   ///< opacity of the model over the writing
constexpr double kModelHint = 0.75;  ///< and of a hint
constexpr int kMostSentences = 3;

}  // namespace

void MemoryStage::set_playing(bool playing) {
  actions().play->setChecked(playing);
  compare_->set_playing(playing);
}

bool MemoryStage::hides_character() const {
  return is_entered() && state_ == State::writing && !shows_groove();
}

bool MemoryStage::shows_groove() const {
  // What a lesson asks for from memory is not shown, whatever the learner chose for free writing.
  return actions().groove_shown->isChecked() && !is_taught();
}

void MemoryStage::begin() {
  controller().set_guides(TabletGuides{});
  controller().set_judged(true);
  panel_->show();
  // What has been rated meanwhile is done with.
  if (aside_ && aside_->unrated && !unrated_) aside_.reset();
  put_aside();
  taught_ = is_taught();
  character_ = lesson().sheet ? lesson().sheet->character.code_point : 0;
  if (resumes_ && aside_ && aside_->character == character_) {
    resume();
    return;
  }
  if (aside_ && aside_->character == character_) aside_.reset();
  start_over();
  invite();
}

void MemoryStage::put_aside() {
  const bool is_empty = strokes_.empty() && state_ == State::writing;
  if (character_ == 0 || is_empty || (aside_ && aside_->unrated)) return;
  const bool unrated = taught_ && state_ != State::writing;
  aside_ = {character_, std::move(strokes_), grade_, pen_, seen_, hinted_, hints_, state_, unrated};
  strokes_.clear();
}

void MemoryStage::forget() {
  aside_.reset();
  if (!is_entered() || (strokes_.empty() && state_ == State::writing)) return;
  start_over();
  invite();
}

void MemoryStage::resume() {
  Aside back = *std::exchange(aside_, std::nullopt);
  start_over();
  strokes_ = std::move(back.strokes);
  grade_ = std::move(back.grade);
  pen_ = std::move(back.pen);
  seen_ = std::move(back.seen);
  hinted_ = std::move(back.hinted);
  hints_ = back.hints;
  set_state(back.state);
  groove_.carve(right_strokes());
  show_writing();
  refresh_actions();
  switch (state_) {
    case State::judged:
      tell_grade();
      break;
    case State::given_up:
      desk().say(Feedback::hint, tr("This is how it is written. Delete clears the tablet to try again."));
      break;
    case State::writing:
      // A stroke that was lifted just before has no verdict yet.
      ask(false);
      invite();
      break;
  }
}

void MemoryStage::end() {
  live_ticket_ = whole_ticket_ = 0;
  set_playing(false);
  panel_->hide();
  groove_.end();
  put_aside();
  character_ = 0;
  strokes_.clear();
  state_ = State::writing;
  controller().set_writing({});
  controller().set_judged(false);
  emit writing_changed();
}

void MemoryStage::start_over() {
  set_playing(false);
  // What is to be written from memory is not shown beside the empty tablet.
  actions().compare_over->setChecked(false);
  actions().compare_beside->setChecked(false);
  panel_->set_compare_shown(false);
  strokes_.clear();
  seen_.clear();
  hinted_.clear();
  grade_ = {};
  pen_ = {};
  hints_ = 0;
  missed_ = false;
  live_ticket_ = whole_ticket_ = 0;
  recorder_.drop();
  put_groove();
  set_state(State::writing);
  show_writing();
  refresh_actions();
}

void MemoryStage::put_groove() {
  if (!is_entered() || !lesson().tablet) return;
  groove_.begin(shows_groove()                          ? practice::WritingGroove::Mode::shown
                : actions().groove_appears->isChecked() ? practice::WritingGroove::Mode::appears
                                                        : practice::WritingGroove::Mode::hidden,
                lesson().tablet);
  groove_.carve(right_strokes());
}

std::vector<int> MemoryStage::right_strokes() const {
  std::vector<int> right;
  for (const auto& verdict : grade_.strokes)
    if (verdict.ok && verdict.matched) right.push_back(*verdict.matched);
  return right;
}

void MemoryStage::invite() {
  if (!lesson().sheet) return;
  const auto& entry = lesson().sheet->character.entry;
  QString meaning;
  for (const auto& m : entry.meanings)
    if (m.language == "en") {
      meaning = to_text(m.text);
      break;
    }
  QString reading;
  if (!entry.kun_readings.empty())
    reading = kun_plain(kanji::split_kun(entry.kun_readings.front()));
  else if (!entry.on_readings.empty())
    reading = to_text(entry.on_readings.front());
  const QString asked = QStringList{reading, meaning}
                            .filter(QRegularExpression(QStringLiteral(".")))
                            .join(QStringLiteral(", "));
  const QString what = tr("Write the character of %n strokes.", nullptr, stroke_count());
  // In a lesson the question stands under the tablet already.
  desk().say(Feedback::hint, is_taught() ? tr("%1 H gives a hint, Enter is done.").arg(what)
                             : asked.isEmpty()
                                 ? what
                                 : tr("%1: %2 H gives a hint, Enter is done.").arg(asked, what));
}

void MemoryStage::set_state(State state) {
  state_ = state;
  panel_->set_report_shown(state == State::judged);
  emit hiding_changed();
}

void MemoryStage::take_samples(std::span<const haptics::ServoSample> samples) {
  recorder_.lean(controller().lean_rad());
  bool grew = false;
  for (const auto& sample : samples) {
    const auto event = recorder_.follow(sample);
    grew = grew || event != practice::PenRecorder::Event::none;
    if (event == practice::PenRecorder::Event::ended) add_stroke(recorder_.take());
  }
  if (grew) show_writing();
}

void MemoryStage::add_stroke(practice::HandStroke stroke) {
  set_playing(false);
  if (strokes_.size() >= writing::kMaxInkStrokes) {
    desk().say(Feedback::advice, tr("The tablet is full. Delete clears it."));
    return;
  }
  if (state_ != State::writing) {
    seen_.assign(strokes_.size(), actions().judge_each->isChecked());
    set_state(State::writing);
    emit taken_back();
  }
  // In a lesson what was refused makes room for the next try.
  clear_miss();
  strokes_.push_back(std::move(stroke));
  seen_.push_back(actions().judge_each->isChecked());
  hinted_.clear();
  hints_ = 0;
  tell_ = true;
  emit stroke_added();
  ask(false);
  show_writing();
  refresh_actions();
}

void MemoryStage::ask(bool finished) {
  if (!lesson().sheet) return;
  practice::JudgeRequest request;
  request.character = lesson().sheet->character.code_point;
  request.ink = practice::to_ink(strokes_, geometry::TabletShape{});
  request.strictness = panel_->strictness().strictness();
  request.finished = finished;
  (finished ? whole_ticket_ : live_ticket_) = desk().judge().judge(request);
}

void MemoryStage::take_grade(std::uint64_t ticket, const writing::Grade& grade) {
  if (!is_entered() || strokes_.empty()) return;
  if (ticket == whole_ticket_) {
    grade_ = grade;
    finish();
    return;
  }
  if (ticket != live_ticket_) return;
  grade_ = grade;
  groove_.carve(right_strokes());
  show_writing();
  if (!tell_) return;
  tell_ = false;
  const bool complete = actions().judge_each->isChecked() &&
                        static_cast<int>(strokes_.size()) == stroke_count() && grade.faults.empty() &&
                        practice::missing_strokes(grade, stroke_count()).empty();
  if (complete)
    ask(true);
  else
    tell_last_stroke();
}

void MemoryStage::tell_last_stroke() {
  const int last = static_cast<int>(strokes_.size()) - 1;
  if (!actions().judge_each->isChecked()) {
    desk().say(Feedback::hint, tr("%n strokes are written. Enter judges them.", nullptr, last + 1));
    return;
  }
  const bool is_wrong = static_cast<std::size_t>(last) < grade_.strokes.size() &&
                        !grade_.strokes[static_cast<std::size_t>(last)].ok;
  for (const auto& fault : grade_.faults) {
    // An exchange may show only with its second stroke, where both are alike.
    const bool is_about_it = fault.stroke == last || (is_wrong && fault.second == last);
    if (!is_about_it || fault.kind == writing::FaultKind::missing) continue;
    tell_miss(to_text(writing::explain(fault, grade_, writing_language())),
              fault.kind != writing::FaultKind::order);
    return;
  }
  if (is_wrong) {
    tell_miss(tr("That is no stroke of this character. Ctrl+Z takes it back."),
              !grade_.strokes[static_cast<std::size_t>(last)].matched);
    return;
  }
  for (const auto& advice : grade_.advice)
    if (advice.stroke == last) {
      desk().say(Feedback::advice, to_text(writing::explain(advice, grade_, writing_language())));
      return;
    }
  const bool is_known = static_cast<std::size_t>(last) < grade_.strokes.size();
  const int number =
      (is_known ? grade_.strokes[static_cast<std::size_t>(last)].matched.value_or(last) : last) + 1;
  // What was passed over is named as long as it is missing.
  const auto missing = practice::missing_strokes(grade_, stroke_count());
  if (!missing.empty() && missing.front() + 1 < number) {
    desk().say(Feedback::advice,
               tr("Stroke %1 is right. Stroke %2 is still missing.").arg(number).arg(missing.front() + 1));
    return;
  }
  const int left = static_cast<int>(missing.size());
  desk().say(Feedback::good, left == 0 ? tr("Stroke %1 is right. Enter is done.").arg(number)
                                       : tr("Stroke %1 is right. %n to go.", nullptr, left).arg(number));
}

void MemoryStage::tell_miss(const QString& why, bool can_be_tried_again) {
  // The stroke that should have come: the first that was missing before this one.
  writing::Grade before = grade_;
  if (before.strokes.size() == strokes_.size()) before.strokes.pop_back();
  const auto missing = practice::missing_strokes(before, stroke_count());
  const int expected = missing.empty() ? 0 : missing.front();
  missed_ = is_taught() && can_be_tried_again;
  switch (reply_to_miss(expected)) {
    case study::MissReply::try_again:
      desk().say(Feedback::wrong, why);
      return;
    case study::MissReply::hint:
      desk().say(Feedback::wrong, tr("%1 H shows where the stroke goes.").arg(why));
      return;
    case study::MissReply::show:
      clear_miss();
      hinted_ = {expected};
      show_writing();
      refresh_actions();
      desk().say(Feedback::advice,
                 tr("Stroke %1 is shown in blue. Write it there and go on.").arg(expected + 1));
      return;
  }
}

void MemoryStage::clear_miss() {
  if (!std::exchange(missed_, false) || strokes_.empty()) return;
  strokes_.pop_back();
  seen_.pop_back();
  if (grade_.strokes.size() > strokes_.size()) grade_.strokes.resize(strokes_.size());
}

void MemoryStage::finish() {
  seen_.assign(strokes_.size(), true);
  hinted_ = practice::missing_strokes(grade_, stroke_count());
  set_state(State::judged);
  show_writing();
  tell_grade();
  refresh_actions();
  emit judged(grade_);
}

void MemoryStage::tell_grade() {
  QStringList sentences;
  for (const auto& sentence : writing::explain(grade_, writing_language())) {
    if (sentences.size() == kMostSentences) break;
    sentences.append(to_text(sentence));
  }
  const QString between = writing_language() == writing::Language::japanese ? QString() : QStringLiteral(" ");
  const QString said = sentences.join(between);
  panel_->report().show_grade(grade_, pen_);
  if (grade_.accepted) {
    QString words = tr("%1 %2 of 100 points.").arg(said).arg(grade_.score);
    // Of how the pen moved one thing is said, and only where nothing else could be better.
    const bool spare = grade_.advice.empty() && !pen_.remarks.empty();
    if (spare) words += between + to_text(writing::explain(pen_.remarks, writing_language()).front());
    desk().say(grade_.advice.empty() && !spare ? Feedback::good : Feedback::advice, words);
  } else {
    desk().say(Feedback::wrong, tr("%1 Ctrl+Z takes back a stroke, O shows the model.").arg(said));
  }
}

void MemoryStage::undo() {
  set_playing(false);
  if (!recorder_.current().empty()) {
    recorder_.drop();
  } else if (!strokes_.empty()) {
    strokes_.pop_back();
    seen_.assign(strokes_.size(), actions().judge_each->isChecked());
  } else {
    return;
  }
  missed_ = false;
  hinted_.clear();
  hints_ = 0;
  set_state(State::writing);
  emit taken_back();
  tell_ = false;
  if (strokes_.empty()) {
    grade_ = {};
    live_ticket_ = 0;
    put_groove();
  } else {
    if (grade_.strokes.size() > strokes_.size()) grade_.strokes.resize(strokes_.size());
    ask(false);
  }
  show_writing();
  refresh_actions();
  desk().say(Feedback::hint,
             tr("Taken back. %n strokes are written.", nullptr, static_cast<int>(strokes_.size())));
}

void MemoryStage::give_hint() {
  const auto missing = practice::missing_strokes(grade_, stroke_count());
  if (missing.empty()) {
    desk().say(Feedback::hint, tr("Every stroke is there. Enter is done."));
    return;
  }
  ++hints_;
  emit hint_given();
  hinted_ = hints_ == 1 ? std::vector<int>{missing.front()} : missing;
  show_writing();
  desk().say(Feedback::hint,
             hints_ == 1
                 ? tr("Stroke %1 is shown in blue. H again shows all that are left.").arg(missing.front() + 1)
                 : tr("All strokes that are left are shown in blue."));
}

void MemoryStage::give_up() {
  // A verdict that is still on its way would be told over the solution.
  tell_ = false;
  live_ticket_ = whole_ticket_ = 0;
  hinted_.clear();
  for (int n = 0; n < stroke_count(); ++n) hinted_.push_back(n);
  set_state(State::given_up);
  show_writing();
  refresh_actions();
  emit given_up();
  desk().say(Feedback::hint, tr("This is how it is written. Delete clears the tablet to try again."));
}

void MemoryStage::show_writing() {
  if (!is_entered()) return;
  std::vector<view::WrittenStroke> all;
  const auto said = practice::verdicts(grade_, strokes_.size());
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const practice::HandStroke shown =
        replayed_s_ < 0 ? strokes_[i]
                        : practice::until(strokes_[i], strokes_.front().front().time_s + replayed_s_);
    if (!shown.empty()) all.push_back(practice::to_written(shown, seen_[i] ? said[i] : view::Verdict::none));
  }
  if (!recorder_.current().empty())
    all.push_back(practice::to_written(recorder_.current(), view::Verdict::none));
  if (lesson().tablet) {
    const auto& paths = lesson().tablet->paths();
    const practice::ModelFit fit = actions().groove_hidden->isChecked()
                                       ? practice::fit_model(strokes_, grade_, paths)
                                       : practice::ModelFit{};
    const bool over = actions().compare_over->isChecked();
    for (int n = 0; n < stroke_count(); ++n) {
      const bool hinted = std::find(hinted_.begin(), hinted_.end(), n) != hinted_.end();
      if (over || hinted)
        all.push_back(
            practice::model_line(paths[static_cast<std::size_t>(n)], fit, over ? kModelOver : kModelHint));
    }
    compare_->show_writing(strokes_, said, lesson().tablet);
  }
  controller().set_writing(std::move(all));
}

}  // namespace nazori::ui
