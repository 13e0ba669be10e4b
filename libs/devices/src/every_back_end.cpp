// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/every_back_end.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

#include "nazori/devices/device_catalogue.h"

namespace nazori::devices {

BackEndSettings BackEndSettings::from_environment() {
  const auto value = [](const char* name) -> std::string_view {
    const char* text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
    return text != nullptr ? text : "";
  };
  BackEndSettings s;
  s.openhaptics.library = value("NAZORI_LIBHD");
  s.openhaptics.device_name = value("NAZORI_OPENHAPTICS_DEVICE");
  s.force_dimension.library = value("NAZORI_LIBDHD");
  const std::string_view port = value("NAZORI_INVERSE_PORT");
  std::uint16_t number = 0;
  if (const auto [end, failed] = std::from_chars(port.data(), port.data() + port.size(), number);
      failed == std::errc() && end == port.data() + port.size() && number > 0)
    s.inverse_service.port = number;
  s.pantograph.port = value("NAZORI_PANTOGRAPH_PORT");
  const std::string_view button = value("NAZORI_PANTOGRAPH_BUTTON");
  s.pantograph.has_button = !button.empty() && button != "0";
  return s;
}

std::vector<std::unique_ptr<BackEnd>> every_back_end(const BackEndSettings& settings) {
  std::vector<std::unique_ptr<BackEnd>> all;
  all.push_back(openhaptics_back_end(settings.openhaptics));
  all.push_back(force_dimension_back_end(settings.force_dimension));
  all.push_back(inverse_service_back_end(settings.inverse_service));
  all.push_back(pantograph_back_end(settings.pantograph));
  all.push_back(game_controllers_back_end());
  all.push_back(pointer_back_end());
  all.push_back(simulated_back_end());
  return all;
}

}  // namespace nazori::devices
