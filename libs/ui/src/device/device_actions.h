// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// The actions of the page for devices.
class DeviceActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit DeviceActions(QWidget* window);
  QAction *look_again, *choose, *stronger, *weaker, *calibrate, *fit, *larger_tip, *smaller_tip;
};

}  // namespace nazori::ui
