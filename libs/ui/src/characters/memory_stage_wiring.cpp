// SPDX-License-Identifier: Apache-2.0
// What the stage is connected to: its actions, the panel beside the tablet, the judge, the settings.
#include <QSettings>
#include <cmath>

#include "characters/compare_view.h"
#include "characters/memory_stage.h"
#include "characters/strictness_slider.h"
#include "characters/writing_panel.h"
#include "error_text.h"
#include "signals.h"

namespace nazori::ui {

MemoryStage::MemoryStage(Desk& desk, CharacterActions& actions, WritingPanel* panel)
    : CharacterStage(desk, actions),
      panel_(panel),
      compare_(&panel->compare()),
      groove_(desk.inbox(), [this](const practice::Tablet& tablet) { controller().set_tablet(tablet); }) {
  actions.judge_each->setChecked(true);
  actions.groove_hidden->setChecked(true);
  connect_judging();
  connect_comparing();
  set_strictness(writing::kNormal);
  connect(&controller(), &TabletController::pressed, this,
          [this](geometry::TabletPoint at) { recorder_.press_at(at); });
  connect(&controller(), &TabletController::sampled, this,
          [this](std::span<const haptics::ServoSample> samples) {
            if (is_entered()) take_samples(samples);
          });
  connect(&controller(), &TabletController::eraser_used, this, [this] {
    if (is_entered()) undo();
  });
  connect(actions.undo_stroke, &QAction::triggered, this, &MemoryStage::undo);
  connect(actions.clear_ink, &QAction::triggered, this, [this] {
    if (!is_entered()) return;
    start_over();
    invite();
  });
  connect(actions.done, &QAction::triggered, this, [this] {
    if (strokes_.empty())
      this->desk().say(Feedback::advice, tr("Nothing is written yet. H shows the first stroke."));
    else
      ask(true);
  });
  connect(actions.hint, &QAction::triggered, this, &MemoryStage::give_hint);
  connect(actions.give_up, &QAction::triggered, this, &MemoryStage::give_up);
  for (auto* choice : {actions.groove_hidden, actions.groove_shown, actions.groove_appears})
    connect(choice, &QAction::triggered, this, [this] {
      put_groove();
      emit hiding_changed();
      this->desk().save_later();
    });
  connect(actions.judge_each, &QAction::triggered, this, [this](bool each) {
    seen_.assign(strokes_.size(), each || state_ == State::judged);
    show_writing();
    this->desk().say(Feedback::hint, each ? tr("Every stroke is judged as it ends.")
                                          : tr("The writing is judged at the end: press Enter."));
    this->desk().save_later();
  });
}

MemoryStage::~MemoryStage() = default;

void MemoryStage::connect_judging() {
  subscribe(desk().judge().judged, this,
            [this](std::uint64_t ticket, const writing::Grade& grade) { take_grade(ticket, grade); });
  subscribe(desk().judge().judging_failed, this, [this](std::uint64_t ticket, const base::Error& error) {
    if (ticket == live_ticket_ || ticket == whole_ticket_)
      desk().say(Feedback::wrong, tr("The writing could not be judged: %1. It is kept.").arg(reason(error)));
  });
  subscribe(desk().judge().pen_reported, this, [this](std::uint64_t ticket, const practice::PenReport& pen) {
    if (ticket == whole_ticket_) pen_ = pen;
  });
  auto& slider = panel_->strictness();
  connect(&slider, &StrictnessSlider::moved, this, [this](double to) {
    set_strictness(to);
    desk().say(Feedback::hint, tr("Your writing is judged %1.").arg(panel_->strictness().words()));
    if (!strokes_.empty()) ask(state_ == State::judged);
    desk().save_later();
  });
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions().more_lenient, [&slider] { slider.step(-1); });
  on(actions().more_strict, [&slider] { slider.step(+1); });
  for (const auto& [action, to] :
       {std::pair{actions().lenient, writing::kLenient}, std::pair{actions().normal, writing::kNormal},
        std::pair{actions().strict, writing::kStrict}})
    on(action, [&slider, to = to] {
      slider.step(static_cast<int>(std::lround((to - slider.strictness()) * StrictnessSlider::kSteps)));
    });
}

void MemoryStage::connect_comparing() {
  connect(actions().compare_over, &QAction::triggered, this, [this] { show_writing(); });
  connect(actions().compare_beside, &QAction::triggered, this, [this](bool on) {
    panel_->set_compare_shown(on);
    show_writing();
    refresh_actions();
    if (on) desk().say(Feedback::hint, tr("Your writing beside the model. Space replays both."));
  });
  connect(actions().play, &QAction::triggered, this, [this](bool on) {
    if (is_entered()) set_playing(on);
  });
  connect(compare_, &CompareView::moment_shown, this, [this](double time_s) {
    if (!is_entered()) return;
    replayed_s_ = time_s;
    show_writing();
  });
  connect(compare_, &CompareView::finished, this, [this] {
    if (is_entered()) actions().play->setChecked(false);
  });
}

QList<QAction*> MemoryStage::own_actions() const {
  const auto& a = actions();
  return {a.undo_stroke,   a.clear_ink,    a.done,           a.hint,           a.give_up,     a.judge_each,
          a.groove_hidden, a.groove_shown, a.groove_appears, a.more_lenient,   a.more_strict, a.lenient,
          a.normal,        a.strict,       a.compare_over,   a.compare_beside, a.play};
}

QList<Tool> MemoryStage::tools() const {
  return {{actions().undo_stroke},    {actions().clear_ink},  {}, {actions().hint, true},
          {actions().give_up},        {actions().done, true}, {}, {actions().compare_over},
          {actions().compare_beside}, {actions().play}};
}

void MemoryStage::load(const QSettings& settings) {
  const QString groove = settings.value(QStringLiteral("groove")).toString();
  (groove == QLatin1String("shown")     ? actions().groove_shown
   : groove == QLatin1String("appears") ? actions().groove_appears
                                        : actions().groove_hidden)
      ->setChecked(true);
  bool is_number = false;
  const double strictness = settings.value(QStringLiteral("strictness")).toDouble(&is_number);
  if (is_number && strictness >= 0 && strictness <= 1) set_strictness(strictness);
  actions().judge_each->setChecked(settings.value(QStringLiteral("judge_each"), true).toBool());
}

void MemoryStage::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("groove"), actions().groove_shown->isChecked() ? QStringLiteral("shown")
                                              : actions().groove_appears->isChecked()
                                                  ? QStringLiteral("appears")
                                                  : QStringLiteral("hidden"));
  settings.setValue(QStringLiteral("strictness"), panel_->strictness().strictness());
  settings.setValue(QStringLiteral("judge_each"), actions().judge_each->isChecked());
}

void MemoryStage::set_strictness(double strictness) {
  panel_->strictness().set_strictness(strictness);
  const double now = panel_->strictness().strictness();
  actions().lenient->setChecked(now == writing::kLenient);
  actions().normal->setChecked(now == writing::kNormal);
  actions().strict->setChecked(now == writing::kStrict);
}

void MemoryStage::refresh_actions() {
  const bool any = !strokes_.empty();
  actions().undo_stroke->setEnabled(is_entered() && any);
  actions().done->setEnabled(is_entered() && state_ == State::writing);
  actions().compare_over->setEnabled(is_entered() && any);
  actions().compare_beside->setEnabled(is_entered() && any);
  actions().play->setEnabled(is_entered() && any);
  emit writing_changed();
}

}  // namespace nazori::ui
