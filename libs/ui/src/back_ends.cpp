// SPDX-License-Identifier: Apache-2.0
#include "back_ends.h"

#include <QSettings>

#include "nazori/devices/every_back_end.h"

namespace nazori::ui {

Stylus::BackEnds registered_back_ends(const QString& settings_file) {
  const QSettings settings(settings_file, QSettings::IniFormat);
  auto where = devices::BackEndSettings::from_environment();
  // What the environment says is meant for this one time.
  const auto take = [&](std::string& value, const char* key) {
    if (value.empty()) value = settings.value(QLatin1String(key)).toString().toStdString();
  };
  take(where.openhaptics.library, "device/openhaptics_library");
  take(where.openhaptics.device_name, "device/openhaptics_device");
  take(where.force_dimension.library, "device/forcedimension_library");
  take(where.pantograph.port, "device/pantograph_port");
  if (!qEnvironmentVariableIsSet("NAZORI_PANTOGRAPH_BUTTON"))
    where.pantograph.has_button = settings.value(QLatin1String("device/pantograph_button")).toBool();
  const int port = settings.value(QLatin1String("device/inverse_port")).toInt();
  if (port > 0 && port <= 65'535 && !qEnvironmentVariableIsSet("NAZORI_INVERSE_PORT"))
    where.inverse_service.port = static_cast<std::uint16_t>(port);
  return devices::every_back_end(where);
}

}  // namespace nazori::ui
