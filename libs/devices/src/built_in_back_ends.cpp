// SPDX-License-Identifier: Apache-2.0
// What is there without any device: the pointer and the simulations.
#include <array>
#include <utility>

#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/devices/simulated_device.h"

namespace nazori::devices {
namespace {

class PointerBackEnd final : public BackEnd {
 public:
  [[nodiscard]] std::string_view id() const override { return "pointer"; }
  [[nodiscard]] BackEndFindings find() override {
    const std::string name(back_end_names::kPointer);
    return {name, {{"pointer", name, false, true}}, std::nullopt};
  }
  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view, const OpenRequest&) override {
    return OpenedDevice{"pointer", std::make_unique<PointerDevice>(), {}, {}};
  }
};

using Preset = SimulatedHardware (*)();
constexpr std::array<std::pair<const char*, Preset>, 5> kPresets{
    {{"simulated:touch", &SimulatedHardware::touch},
     {"simulated:touch-x", &SimulatedHardware::touch_x},
     {"simulated:falcon", &SimulatedHardware::falcon},
     {"simulated:omega3", &SimulatedHardware::omega_3},
     {"simulated:inverse3", &SimulatedHardware::inverse3}}};

class SimulatedBackEnd final : public BackEnd {
 public:
  [[nodiscard]] std::string_view id() const override { return "simulated"; }
  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{std::string(back_end_names::kSimulated), {}, std::nullopt};
    for (const auto& [id, preset] : kPresets) found.devices.push_back({id, preset().name, true, false});
    return found;
  }
  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device, const OpenRequest&) override {
    for (const auto& [id, preset] : kPresets) {
      if (device == id || device == "simulated")
        return OpenedDevice{id, std::make_unique<SimulatedDevice>(preset()), {}, {}};
    }
    std::string there;
    for (const auto& [id, preset] : kPresets) there += (there.empty() ? "" : ", ") + std::string(id);
    return no_device(haptics::DeviceTrouble::device_absent, "no such simulated device", std::string(device),
                     "available: " + there);
  }
};

}  // namespace

std::unique_ptr<BackEnd> pointer_back_end() { return std::make_unique<PointerBackEnd>(); }
std::unique_ptr<BackEnd> simulated_back_end() { return std::make_unique<SimulatedBackEnd>(); }

}  // namespace nazori::devices
