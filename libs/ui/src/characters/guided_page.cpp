// SPDX-License-Identifier: Apache-2.0
#include "characters/guided_page.h"

#include <QSettings>

namespace nazori::ui {

using Guide = practice::GuidedStage::Guide;

GuidedPage::GuidedPage(practice::GuidedStage& stage, Desk& desk, CharacterActions& actions)
    : StagePage(stage, desk, actions), guided_(stage) {
  actions.by_groove->setChecked(true);
  always_on(actions.by_groove, [&stage] { stage.set_guide(Guide::groove); });
  always_on(actions.by_starts, [&stage] { stage.set_guide(Guide::starting_points); });
  always_on(actions.lead_hand, [&stage](bool on) { stage.set_leading(on); });
  on(actions.clear_ink, [&stage] { stage.start_over(); });
}

QList<QAction*> GuidedPage::own_actions() const {
  return {actions().by_groove, actions().by_starts, actions().lead_hand, actions().clear_ink};
}

QList<Tool> GuidedPage::tools() const {
  return {{actions().by_groove, true}, {actions().by_starts, true}, {}, {actions().lead_hand, true}, {},
          {actions().clear_ink}};
}

void GuidedPage::load(const QSettings& settings) {
  const bool is_led = settings.value(QStringLiteral("lead_hand"), false).toBool();
  actions().lead_hand->setChecked(is_led);
  guided_.set_leading(is_led);
}

void GuidedPage::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("lead_hand"), guided_.leading());
}

}  // namespace nazori::ui
