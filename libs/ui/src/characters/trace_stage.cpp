// SPDX-License-Identifier: Apache-2.0
#include "characters/trace_stage.h"

#include <QWidgetAction>
#include <utility>

#include "characters/stroke_counter.h"

namespace nazori::ui {

TraceStage::TraceStage(Desk& desk, CharacterActions& actions)
    : CharacterStage(desk, actions), counter_(new StrokeCounter(desk.controller())) {
  auto* place = new QWidgetAction(this);
  place->setDefaultWidget(counter_);
  counter_place_ = place;
  auto& tablet = controller();
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions.next_stroke, [this, &tablet] {
    tablet.next_stroke();
    tell(StrokeTeller::stroke_shown(tablet));
  });
  on(actions.previous_stroke, [this, &tablet] {
    tablet.previous_stroke();
    tell(StrokeTeller::stroke_shown(tablet));
  });
  on(actions.all_strokes, [this, &tablet] {
    tablet.set_current_stroke(0);
    tell(StrokeTeller::stroke_shown(tablet));
  });
  on(actions.strokes, [this, &tablet](bool show) {
    tablet.set_strokes_visible(show);
    tell(tablet.snapping() ? StrokeTeller::snapping(tablet) : StrokeTeller::invitation(tablet));
  });
  on(actions.numbers, [&tablet](bool show) { tablet.set_numbers_visible(show); });
  on(actions.arrows, [&tablet](bool show) { tablet.set_arrows_visible(show); });
  on(actions.snap, [this, &tablet](bool hold) {
    tablet.set_snapping(hold);
    tell(StrokeTeller::snapping(tablet));
  });
  on(actions.clear_ink, [this, &tablet] {
    if (!is_entered()) return;
    tablet.clear_ink();
    tell(StrokeTeller::invitation(tablet));
  });
  connect(&tablet, &TabletController::eraser_used, this, [this, &tablet] {
    if (is_entered()) tablet.undo_ink();
  });
  connect(&tablet, &TabletController::state_changed, this, [this, &tablet] {
    if (!is_entered()) return;
    Preferences& preferences = this->desk().preferences();
    preferences.strokes_visible = tablet.strokes_visible();
    preferences.numbers_visible = tablet.numbers_visible();
    preferences.arrows_visible = tablet.arrows_visible();
    preferences.snapping = tablet.snapping();
    show_state();
    this->desk().save_later();
  });
  connect(&tablet, &TabletController::stroke_event, this, [this](practice::TraceEvent event, int stroke) {
    if (is_entered()) take(event, stroke);
  });
}

QList<QAction*> TraceStage::own_actions() const {
  return {actions().previous_stroke, actions().next_stroke, actions().all_strokes, actions().strokes,
          actions().numbers,         actions().arrows,      actions().snap,        actions().clear_ink};
}

QList<Tool> TraceStage::tools() const {
  return {{actions().previous_stroke},
          {counter_place_},
          {actions().next_stroke},
          {},
          {actions().strokes, true},
          {actions().numbers, true},
          {actions().arrows, true},
          {actions().snap, true},
          {},
          {actions().clear_ink}};
}

void TraceStage::begin() {
  controller().set_guides({});
  controller().set_tablet(lesson().tablet);
  shown_alone_ = 0;
  show_state();
  tell(StrokeTeller::invitation(controller()));
}

void TraceStage::take(practice::TraceEvent event, int stroke) {
  auto& tablet = controller();
  const int next = tablet.ink().next_stroke();
  if (StrokeTeller::is_miss(event, controller())) {
    if (reply_to_miss(next - 1) == study::MissReply::show) {
      shown_alone_ = next;
      tablet.set_current_stroke(next);
      tell(StrokeTeller::stroke_shown(tablet));
      return;
    }
  }
  if (event == practice::TraceEvent::finished && std::exchange(shown_alone_, 0) == stroke && next != 0)
    tablet.set_current_stroke(0);
  tell(StrokeTeller::about(event, stroke, tablet));
  if (event == practice::TraceEvent::finished && next == 0) emit finished({});
}

void TraceStage::tell(const StrokeTeller::Sentence& sentence) { desk().say(sentence.kind, sentence.text); }

void TraceStage::show_state() {
  const auto& tablet = controller();
  const std::pair<QAction*, bool> states[] = {
      {actions().strokes, tablet.strokes_visible()},
      {actions().numbers, tablet.numbers_visible()},
      {actions().arrows, tablet.arrows_visible()},
      {actions().snap, tablet.snapping()},
  };
  for (const auto& [action, checked] : states) action->setChecked(checked);
  for (auto* action : {actions().next_stroke, actions().previous_stroke, actions().all_strokes})
    action->setEnabled(tablet.stroke_count() > 0);
  for (auto* action : {actions().numbers, actions().arrows}) action->setEnabled(tablet.strokes_visible());
  counter_->refresh();
}

}  // namespace nazori::ui
