// SPDX-License-Identifier: Apache-2.0
#include "back_ends.h"

#include <QSettings>

#include "nazori/devices/force_dimension.h"
#include "nazori/devices/openhaptics.h"

namespace nazori::ui {

Stylus::BackEnds registered_back_ends(const QString& settings_file) {
  const QSettings settings(settings_file, QSettings::IniFormat);
  const auto text = [&](const char* key) {
    return settings.value(QLatin1String(key)).toString().toStdString();
  };
  devices::OpenHapticsSettings openhaptics;
  openhaptics.library = text("device/openhaptics_library");
  openhaptics.device_name = text("device/openhaptics_device");
  devices::ForceDimensionSettings force_dimension;
  force_dimension.library = text("device/forcedimension_library");
  Stylus::BackEnds all;
  all.push_back(devices::openhaptics_back_end(std::move(openhaptics)));
  all.push_back(devices::force_dimension_back_end(std::move(force_dimension)));
  all.push_back(devices::pointer_back_end());
  all.push_back(devices::simulated_back_end());
  return all;
}

}  // namespace nazori::ui
