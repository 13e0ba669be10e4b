// SPDX-License-Identifier: Apache-2.0
#include "characters/stages/memory_view.h"

#include <array>
#include <cmath>
#include <utility>

#include "characters/compare_view.h"
#include "characters/strictness_slider.h"
#include "characters/writing_panel.h"
#include "characters/writing_report.h"
#include "nazori/practice/model_fit.h"

namespace nazori::ui {

using Groove = practice::WritingGroove::Mode;
using State = practice::MemoryStage::State;

namespace {

constexpr int kFrame_ms = 16;
constexpr std::array kGrooves{Groove::hidden, Groove::shown, Groove::appears};

QAction* action_of(const CharacterActions& actions, Groove groove) {
  switch (groove) {
    case Groove::shown:
      return actions.groove_shown;
    case Groove::appears:
      return actions.groove_appears;
    case Groove::hidden:
      break;
  }
  return actions.groove_hidden;
}

}  // namespace

MemoryView::MemoryView(practice::MemoryStage& stage, WindowParts& parts, CharacterActions& actions,
                       WritingPanel* panel)
    : StageView(stage, parts, actions), memory_(stage), panel_(panel), compare_(&panel->compare()) {
  actions.judge_each->setChecked(true);
  actions.groove_hidden->setChecked(true);
  connect_writing();
  connect_judging();
  connect_comparing();
  set_strictness(writing::kNormal);
}

void MemoryView::connect_writing() {
  on(actions().undo_stroke, [this] { memory_.undo(); });
  on(actions().clear_ink, [this] { memory_.start_over(); });
  on(actions().done, [this] { memory_.finish_writing(); });
  on(actions().hint, [this] { memory_.give_hint(); });
  on(actions().give_up, [this] { memory_.show_answer(); });
  for (const Groove groove : kGrooves)
    always_on(action_of(actions(), groove), [this, groove] {
      memory_.set_groove(groove);
      parts().save_later();
    });
  always_on(actions().judge_each, [this](bool each) {
    memory_.set_judges_each(each);
    parts().save_later();
  });
  subscribe(memory_.hiding_changed, this,
            [this] { panel_->set_report_shown(memory_.state() == State::judged); });
  subscribe(memory_.feedback, this, [this](const practice::StageFeedback& feedback) {
    if (feedback.event == practice::StageEvent::judged)
      panel_->report().show_grade(memory_.grade(), memory_.pen_report());
  });
}

void MemoryView::connect_judging() {
  auto& slider = panel_->strictness();
  connect(&slider, &StrictnessSlider::moved, this, [this](double to) {
    set_strictness(to);
    parts().announce(Feedback::hint, tr("Strictness: %1.").arg(panel_->strictness().words()));
    memory_.set_strictness(panel_->strictness().strictness());
    parts().save_later();
  });
  always_on(actions().more_lenient, [&slider] { slider.step(-1); });
  always_on(actions().more_strict, [&slider] { slider.step(+1); });
  for (const auto& [action, to] :
       {std::pair{actions().lenient, writing::kLenient}, std::pair{actions().normal, writing::kNormal},
        std::pair{actions().strict, writing::kStrict}})
    always_on(action, [&slider, to = to] {
      slider.step(static_cast<int>(std::lround((to - slider.strictness()) * StrictnessSlider::kSteps)));
    });
}

void MemoryView::connect_comparing() {
  always_on(actions().compare_over, [this](bool on) { memory_.set_model_over(on); });
  always_on(actions().compare_beside, [this](bool on) {
    panel_->set_compare_shown(on);
    refresh();
    if (on) parts().announce(Feedback::hint, tr("Your writing beside the model. Space: replay both."));
  });
  on(actions().show_right, [this] { show_right(); });
  drawing_.setTimerType(Qt::PreciseTimer);
  connect(&drawing_, &QTimer::timeout, this, [this] {
    memory_.advance_right(static_cast<double>(since_.restart()) / 1000);
    if (!memory_.is_showing_right()) drawing_.stop();
  });
  on(actions().play, [this] { set_playing(actions().play->isChecked()); });
  connect(compare_, &CompareView::moment_shown, this,
          [this](double time_s) { memory_.show_moment(time_s < 0 ? std::nullopt : std::optional(time_s)); });
  connect(compare_, &CompareView::finished, this, [this] {
    if (is_entered()) actions().play->setChecked(false);
  });
  subscribe(memory_.replay_stopped, this, [this] { set_playing(false); });
  subscribe(memory_.started_over, this, [this] {
    actions().compare_over->setChecked(false);
    actions().compare_beside->setChecked(false);
    panel_->set_compare_shown(false);
  });
  subscribe(memory_.writing_shown, this, [this] {
    const auto& strokes = memory_.strokes();
    compare_->show_writing(strokes, practice::verdicts(memory_.grade(), strokes.size()),
                           memory_.subject().tablet);
  });
}

void MemoryView::show_right() {
  memory_.show_right(!parts().preferences().reduced_motion);
  since_.start();
  if (memory_.is_showing_right()) drawing_.start(kFrame_ms);
}

void MemoryView::set_playing(bool playing) {
  actions().play->setChecked(playing);
  compare_->set_playing(playing);
}

QList<QAction*> MemoryView::own_actions() const {
  const auto& a = actions();
  return {a.undo_stroke,   a.clear_ink,    a.done,           a.hint,           a.give_up,     a.judge_each,
          a.groove_hidden, a.groove_shown, a.groove_appears, a.more_lenient,   a.more_strict, a.lenient,
          a.normal,        a.strict,       a.compare_over,   a.compare_beside, a.show_right,  a.play};
}

QList<Tool> MemoryView::tools() const {
  return {{actions().undo_stroke},
          {actions().clear_ink},
          {},
          {actions().hint, true},
          {actions().give_up},
          {actions().done, true},
          {},
          {actions().show_right},
          {actions().compare_over},
          {actions().compare_beside},
          {actions().play}};
}

void MemoryView::load(const base::Settings& settings) {
  practice::MemoryStage::Options options;
  options.load(settings);
  set_strictness(options.strictness);
  options.strictness = panel_->strictness().strictness();
  action_of(actions(), options.groove)->setChecked(true);
  actions().judge_each->setChecked(options.judges_each);
  memory_.set_options(options);
}

void MemoryView::save(base::Settings& settings) const { memory_.options().save(settings); }

void MemoryView::set_strictness(double strictness) {
  panel_->strictness().set_strictness(strictness);
  const double now = panel_->strictness().strictness();
  actions().lenient->setChecked(now == writing::kLenient);
  actions().normal->setChecked(now == writing::kNormal);
  actions().strict->setChecked(now == writing::kStrict);
}

void MemoryView::refresh() {
  const bool any = !memory_.strokes().empty();
  actions().undo_stroke->setEnabled(is_entered() && any);
  actions().done->setEnabled(is_entered() && memory_.state() == State::writing);
  actions().compare_over->setEnabled(is_entered() && any);
  actions().compare_beside->setEnabled(is_entered() && any);
  actions().play->setEnabled(is_entered() && any);
  actions().show_right->setEnabled(memory_.can_show_right());
  panel_->setVisible(is_entered());
}

}  // namespace nazori::ui
