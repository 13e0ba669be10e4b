// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/every_back_end.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/game_controllers.h"
#include "nazori/devices/inverse_service.h"
#include "nazori/devices/openhaptics.h"
#include "nazori/devices/pantograph.h"

namespace nazori::devices {
namespace {

using base::Settings;
using base::text_setting;

struct EnvironmentVariable {
  const char* name;
  std::string_view setting;
  bool may_be_empty;  ///< an empty value means the default, not the stored value
};

constexpr std::array kEnvironment{
    EnvironmentVariable{"NAZORI_LIBHD", "openhaptics_library", false},
    EnvironmentVariable{"NAZORI_OPENHAPTICS_DEVICE", "openhaptics_device", false},
    EnvironmentVariable{"NAZORI_LIBDHD", "forcedimension_library", false},
    EnvironmentVariable{"NAZORI_INVERSE_PORT", "inverse_port", true},
    EnvironmentVariable{"NAZORI_PANTOGRAPH_PORT", "pantograph_port", false},
    EnvironmentVariable{"NAZORI_PANTOGRAPH_BUTTON", "pantograph_button", true},
};

std::unique_ptr<BackEnd> make_openhaptics(const Settings& settings) {
  OpenHapticsSettings s;
  s.library = text_setting(settings, "openhaptics_library");
  s.device_name = text_setting(settings, "openhaptics_device");
  return openhaptics_back_end(std::move(s));
}

std::unique_ptr<BackEnd> make_force_dimension(const Settings& settings) {
  ForceDimensionSettings s;
  s.library = text_setting(settings, "forcedimension_library");
  return force_dimension_back_end(std::move(s));
}

std::unique_ptr<BackEnd> make_inverse_service(const Settings& settings) {
  InverseServiceSettings s;
  const std::string_view port = text_setting(settings, "inverse_port");
  std::uint16_t number = 0;
  if (const auto [end, failed] = std::from_chars(port.data(), port.data() + port.size(), number);
      failed == std::errc() && end == port.data() + port.size() && number > 0)
    s.port = number;
  return inverse_service_back_end(std::move(s));
}

std::unique_ptr<BackEnd> make_pantograph(const Settings& settings) {
  PantographSettings s;
  s.port = text_setting(settings, "pantograph_port");
  const std::string_view button = text_setting(settings, "pantograph_button");
  s.has_button = !button.empty() && button != "0" && button != "false";
  return pantograph_back_end(std::move(s));
}

using Make = std::unique_ptr<BackEnd> (*)(const Settings& settings);

/// Best first.
constexpr Make kBackEnds[]{
    make_openhaptics,
    make_force_dimension,
    make_inverse_service,
    make_pantograph,
    [](const Settings&) { return game_controllers_back_end(); },
    [](const Settings&) { return pointer_back_end(); },
    [](const Settings&) { return simulated_back_end(); },
};

}  // namespace

Settings back_end_settings(Settings stored) {
  for (const auto& variable : kEnvironment) {
    const char* text =
        std::getenv(variable.name);  // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
    if (text != nullptr && (variable.may_be_empty || *text != '\0'))
      stored.insert_or_assign(std::string(variable.setting), text);
  }
  return stored;
}

std::vector<std::unique_ptr<BackEnd>> every_back_end(const Settings& settings) {
  std::vector<std::unique_ptr<BackEnd>> all;
  all.reserve(std::size(kBackEnds));
  for (const Make make : kBackEnds) all.push_back(make(settings));
  return all;
}

}  // namespace nazori::devices
