// SPDX-License-Identifier: Apache-2.0
#include "window/back_ends.h"

#include "nazori/devices/every_back_end.h"
#include "nazori/widgets/settings/stored_settings.h"

namespace nazori::ui {

std::vector<std::unique_ptr<devices::BackEnd>> registered_back_ends(const QString& settings_file) {
  QSettings settings(settings_file, QSettings::IniFormat);
  settings.beginGroup(QStringLiteral("device"));
  return devices::every_back_end(devices::back_end_settings(read_settings(settings)));
}

}  // namespace nazori::ui
