// SPDX-License-Identifier: Apache-2.0
#include "device/device_actions.h"

namespace nazori::ui {

DeviceActions::DeviceActions(QWidget* window) : ActionSet(window) {
  look_again = make("look_again", tr("&Look for devices"), tr("Search again for connected devices"), "F5",
                    Icon::search);
  choose = make("choose_device", tr("Choose a &device"), tr("Go to the list of devices"), "D");
  stronger = make("stronger", tr("S&tronger"),
                  tr("Make the test force stronger by 10% of the device's limit"), "Ctrl+PgUp");
  weaker = make("weaker", tr("&Weaker"), tr("Make the test force weaker"), "Ctrl+PgDown");
  calibrate = make("calibrate", tr("Calibrate with &corners…"),
                   tr("Point at three corners of the tablet with the stylus"), "C");
  fit = make("fit", tr("&Fit automatically"),
             tr("Use the largest tablet that the stylus can reach completely"), "Shift+C");
  larger_tip = make("larger_tip", tr("Lar&ger ball at the tip"),
                    tr("Make the ball at the tip of the stylus half a millimetre larger"), "]");
  smaller_tip =
      make("smaller_tip", tr("S&maller ball at the tip"),
           tr("Make the ball at the tip of the stylus half a millimetre smaller; 0 is a point"), "[");
  add_group(tr("&Device"), {choose, look_again, nullptr, stronger, weaker, nullptr, larger_tip, smaller_tip,
                            nullptr, calibrate, fit});
}

}  // namespace nazori::ui
