// SPDX-License-Identifier: Apache-2.0
#include "characters/stages/trace_view.h"

#include <QWidgetAction>
#include <utility>

#include "characters/stroke_counter.h"

namespace nazori::ui {

TraceView::TraceView(practice::TraceStage& stage, WindowParts& parts, CharacterActions& actions)
    : StageView(stage, parts, actions), counter_(new StrokeCounter(parts.tablet())) {
  auto* counter = new QWidgetAction(this);
  counter->setDefaultWidget(counter_);
  counter_action_ = counter;
  auto& control = tablet();
  always_on(actions.next_stroke, [&stage] { stage.show_next_stroke(); });
  always_on(actions.previous_stroke, [&stage] { stage.show_previous_stroke(); });
  always_on(actions.all_strokes, [&stage] { stage.show_all_strokes(); });
  always_on(actions.strokes, [&stage](bool show) { stage.set_strokes_visible(show); });
  always_on(actions.numbers, [&control](bool show) { control.set_numbers_visible(show); });
  always_on(actions.arrows, [&control](bool show) { control.set_arrows_visible(show); });
  always_on(actions.snap, [&stage](bool hold) { stage.set_snapping(hold); });
  on(actions.clear_ink, [&stage] { stage.clear_ink(); });
  subscribe(control.state_changed, this, [this, &control] {
    if (!is_entered()) return;
    Preferences& preferences = this->parts().preferences();
    preferences.strokes_visible = control.strokes_visible();
    preferences.numbers_visible = control.numbers_visible();
    preferences.arrows_visible = control.arrows_visible();
    preferences.snapping = control.snapping();
    refresh();
    this->parts().save_later();
  });
}

QList<QAction*> TraceView::own_actions() const {
  return {actions().previous_stroke, actions().next_stroke, actions().all_strokes, actions().strokes,
          actions().numbers,         actions().arrows,      actions().snap,        actions().clear_ink};
}

QList<Tool> TraceView::tools() const {
  return {{actions().previous_stroke},
          {counter_action_},
          {actions().next_stroke},
          {},
          {actions().strokes, true},
          {actions().numbers, true},
          {actions().arrows, true},
          {actions().snap, true},
          {},
          {actions().clear_ink}};
}

void TraceView::refresh() {
  if (!is_entered()) return;
  const auto& control = tablet();
  const std::pair<QAction*, bool> states[] = {
      {actions().strokes, control.strokes_visible()},
      {actions().numbers, control.numbers_visible()},
      {actions().arrows, control.arrows_visible()},
      {actions().snap, control.snapping()},
  };
  for (const auto& [action, checked] : states) action->setChecked(checked);
  for (auto* action : {actions().next_stroke, actions().previous_stroke, actions().all_strokes})
    action->setEnabled(control.stroke_count() > 0);
  for (auto* action : {actions().numbers, actions().arrows}) action->setEnabled(control.strokes_visible());
  counter_->refresh();
}

}  // namespace nazori::ui
