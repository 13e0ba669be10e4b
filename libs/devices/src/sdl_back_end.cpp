// SPDX-License-Identifier: Apache-2.0
#include "sdl_back_end.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "device_nodes.h"
#include "nazori/devices/game_controllers.h"
#include "sdl_device.h"

namespace nazori::devices {
namespace sdl {
namespace {

using haptics::DeviceTrouble;

constexpr std::string_view kName = back_end_names::kGamepads;

struct Named {
  std::string id;
  Listed device;
};

/// Ids by model, so that they are the same after unplugging.
std::vector<Named> named(std::vector<Listed> listed) {
  std::map<std::string, int> count;
  std::vector<Named> all;
  for (Listed& device : listed) {
    const int number = ++count[device.guid];
    std::string id = "sdl:" + device.guid;
    if (number > 1) id += "." + std::to_string(number);
    all.push_back({std::move(id), std::move(device)});
  }
  return all;
}

class SdlBackEnd final : public BackEnd {
 public:
  explicit SdlBackEnd(std::shared_ptr<Port> port) : port_(std::move(port)) {}
  [[nodiscard]] std::string_view id() const override { return "sdl"; }

  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{std::string(kName), {}, std::nullopt};
    const auto listed = port_->list();
    if (!listed) {
      found.problem = DeviceProblem{DeviceTrouble::init_failed, listed.error()};
      return found;
    }
    for (const Named& one : named(*listed)) {
      const Abilities& can = one.device.abilities;
      found.devices.push_back({one.id, one.device.name, can.force(), can.force() && can.force_axes() >= 2});
      if (is_open(one.device)) found.problem = in_use(one.device).value();
    }
    if (found.devices.empty()) found.problem = absent(std::string(kName)).value();
    return found;
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    const auto listed = port_->list();
    if (!listed) return tl::unexpected(DeviceProblem{DeviceTrouble::init_failed, listed.error()});
    const std::vector<Named> all = named(*listed);
    const auto wanted = std::find_if(all.begin(), all.end(),
                                     [&](const Named& one) { return device == id() || device == one.id; });
    if (wanted == all.end()) return absent(std::string(device));
    if (is_open(wanted->device)) return in_use(wanted->device);

    // The stick's plane is the tablet's plane, whatever the pose of the tablet on other devices.
    TabletPosture upright;
    upright.hand = request.posture.hand;
    WorkspaceCalibration fit =
        request.calibration.value_or(fit_workspace(stick_workspace(), request.shape, upright));
    fit.posture = upright;
    const auto mapping = WorkspaceMapping::create(fit);
    if (!mapping) return tl::unexpected(DeviceProblem{DeviceTrouble::bad_calibration, mapping.error()});

    auto opened = port_->open(wanted->device, request.posture.hand);
    if (!opened) return tl::unexpected(DeviceProblem{DeviceTrouble::init_failed, opened.error()});
    const std::shared_ptr<Controller> controller = std::move(*opened);
    open_[wanted->device.instance] = controller;
    return OpenedDevice{wanted->id, stick_device(controller, wanted->device, *mapping, request.shape.depth_m),
                        fit, stick_workspace()};
  }

 private:
  [[nodiscard]] bool is_open(const Listed& device) const {
    const auto found = open_.find(device.instance);
    return found != open_.end() && !found->second.expired();
  }
  static tl::unexpected<DeviceProblem> in_use(const Listed& device) {
    return no_device(DeviceTrouble::in_use, "it is already open in this program", device.name,
                     "use the open one");
  }
  static tl::unexpected<DeviceProblem> absent(std::string what) {
    if (const auto advice = permission_advice(device_nodes("/dev/input", {"js"})))
      return no_device(DeviceTrouble::no_permission, "no permission to open it", std::move(what), *advice);
    return no_device(DeviceTrouble::device_absent, "none is connected", std::move(what),
                     "plug it in; if it is wireless, switch it on");
  }

  std::shared_ptr<Port> port_;
  std::map<std::int32_t, std::weak_ptr<Controller>> open_;
};

}  // namespace

std::unique_ptr<BackEnd> back_end(std::shared_ptr<Port> port) {
  return std::make_unique<SdlBackEnd>(std::move(port));
}

}  // namespace sdl

std::unique_ptr<BackEnd> game_controllers_back_end() { return sdl::back_end(sdl::system_port()); }

}  // namespace nazori::devices
