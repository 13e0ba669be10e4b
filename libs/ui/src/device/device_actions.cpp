// SPDX-License-Identifier: Apache-2.0
#include "device/device_actions.h"

namespace nazori::ui {

DeviceActions::DeviceActions(QWidget* window) : ActionSet(window) {
  look_again = make("look_again", tr("&Look for devices"), tr("Look again for what is plugged in"),
                    {QStringLiteral("F5")});
  stronger = make("stronger", tr("S&tronger"), tr("The trial pushes harder by a tenth of the device's limit"),
                  {QStringLiteral("Ctrl+PgUp")});
  weaker = make("weaker", tr("&Weaker"), tr("The trial pushes less hard"), {QStringLiteral("Ctrl+PgDown")});
  calibrate = make("calibrate", tr("Fit by &corners…"),
                   tr("Show three corners of the tablet with the stylus"), {QStringLiteral("C")});
  fit = make("fit", tr("&Fit by itself"), tr("The largest tablet that the stylus can reach whole"),
             {QStringLiteral("Shift+C")});
  draw(look_again, Icon::search);
  add_group(tr("&Device"), {look_again, nullptr, stronger, weaker, nullptr, calibrate, fit});
}

}  // namespace nazori::ui
