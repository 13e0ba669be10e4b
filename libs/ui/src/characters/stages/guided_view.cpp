// SPDX-License-Identifier: Apache-2.0
#include "characters/stages/guided_view.h"

namespace nazori::ui {

using Guide = practice::GuidedStage::Guide;

GuidedView::GuidedView(practice::GuidedStage& stage, WindowParts& parts, CharacterActions& actions)
    : StageView(stage, parts, actions), guided_(stage) {
  actions.by_groove->setChecked(true);
  always_on(actions.by_groove, [&stage] { stage.set_guide(Guide::groove); });
  always_on(actions.by_starts, [&stage] { stage.set_guide(Guide::starting_points); });
  always_on(actions.lead_hand, [&stage](bool on) { stage.set_leading(on); });
  on(actions.clear_ink, [&stage] { stage.start_over(); });
}

QList<QAction*> GuidedView::own_actions() const {
  return {actions().by_groove, actions().by_starts, actions().lead_hand, actions().clear_ink};
}

QList<Tool> GuidedView::tools() const {
  return {{actions().by_groove, true}, {actions().by_starts, true}, {}, {actions().lead_hand, true}, {},
          {actions().clear_ink}};
}

void GuidedView::load(const base::Settings& settings) {
  const bool is_led = base::flag_setting(settings, "lead_hand", false);
  actions().lead_hand->setChecked(is_led);
  guided_.set_leading(is_led);
}

void GuidedView::save(base::Settings& settings) const {
  base::set_flag(settings, "lead_hand", guided_.leading());
}

}  // namespace nazori::ui
