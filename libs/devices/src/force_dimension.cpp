// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/force_dimension.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "device_nodes.h"
#include "force_dimension_abi.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "servo_link.h"
#include "shared_library.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;
using Clock = std::chrono::steady_clock;

constexpr const char* kName = "Force Dimension";
constexpr int kMostBadTicks = 20;  // in a row; force is zero from the first
constexpr int kLookTicks = 16;     // between checks of the status
constexpr int kForceOffLooks = 2;  // in a row, before forces count as off: switching them on takes a moment
constexpr auto kForceRest = std::chrono::milliseconds(500);  // before they are switched on again

DeviceResult<dhd::Functions> load(const std::string& user_path) {
  std::vector<std::string> names{"libdhd.so.3", "libdrd.so.3", "libdhd.so", "libdrd.so"};
  if (!user_path.empty()) names = {user_path};
  const auto library = SharedLibrary::load(
      kName, names, "install the Force Dimension SDK, see docs/devices.md, Force Dimension and Falcon");
  if (!library) return tl::unexpected(library.error());
  dhd::Functions f;
  DeviceResult<void> all;
  const auto need = [&](auto& function, const char* name) {
    if (all) all = library->need(function, name);
  };
  need(f.device_count, "dhdGetDeviceCount");
  need(f.open, "dhdOpenID");
  need(f.close, "dhdClose");
  need(f.last_error, "dhdErrorGetLast");
  need(f.last_error_text, "dhdErrorGetLastStr");
  need(f.enable_force, "dhdEnableForce");
  need(f.get_position, "dhdGetPosition");
  need(f.set_force, "dhdSetForce");
  if (!all) return tl::unexpected(all.error());
  library->want(f.system_name, "dhdGetSystemName");
  library->want(f.system_type, "dhdGetSystemType");
  library->want(f.button_mask, "dhdGetButtonMask");
  library->want(f.button, "dhdGetButton");
  library->want(f.max_force, "dhdGetMaxForce");
  library->want(f.set_max_force, "dhdSetMaxForce");
  library->want(f.set_gravity_compensation, "dhdSetGravityCompensation");
  library->want(f.status, "dhdGetStatus");
  library->want(f.emulate_button, "dhdEmulateButton");
  return f;
}

/// Properties of a kind of device, which the library does not report.
struct Kind {
  haptics::DeviceLimits limits;
  double radius_m;  // of the ball that it reaches
};

Kind kind_of(const std::string& name, int type) {
  const auto says = [&](const char* word) {
    return std::search(name.begin(), name.end(), word, word + std::char_traits<char>::length(word),
                       [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); }) !=
           name.end();
  };
  if (type == dhd::kFalcon || says("falcon")) return {SimulatedHardware::falcon().limits, 0.04};
  if (says("omega")) return {SimulatedHardware::omega_3().limits, 0.075};
  if (says("delta")) {
    Kind delta{SimulatedHardware::omega_3().limits, 0.15};
    delta.limits.max_force_n = delta.limits.continuous_force_n = 20;
    return delta;
  }
  // sigma, lambda and future devices: assumed no stronger than the omega unless the library says otherwise.
  Kind other{SimulatedHardware::omega_3().limits, 0.06};
  if (says("sigma")) other.limits.max_stiffness_n_m = 4000;
  return other;
}

/// Open while it lives.
struct Port {
  Port(const dhd::Functions& functions, char number) : dhd(functions), id(number) {
    const char* given = dhd.system_name != nullptr ? dhd.system_name(id) : nullptr;
    if (given != nullptr && *given != '\0') name = given;
    Kind kind = kind_of(name, dhd.system_type != nullptr ? dhd.system_type(id) : 0);
    const double most = dhd.max_force != nullptr ? dhd.max_force(id) : -1;
    if (std::isfinite(most) && most > 0) kind.limits.max_force_n = std::min(kind.limits.max_force_n, most);
    kind.limits.continuous_force_n = std::min(kind.limits.continuous_force_n, kind.limits.max_force_n);
    limits = kind.limits;
    const double half = kind.radius_m / std::sqrt(3.0);
    workspace = {{-half, -half, -half}, {half, half, half}};
  }
  ~Port() { (void)dhd.close(id); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  const dhd::Functions dhd;
  const char id;
  std::string name = "Force Dimension device";
  haptics::DeviceLimits limits;
  DeviceWorkspace workspace;
};

std::string last_error(const dhd::Functions& dhd) {
  const char* words = dhd.last_error_text();
  return words != nullptr ? words : "error " + std::to_string(dhd.last_error());
}

class ForceDimensionDevice final : public haptics::HapticDevice {
 public:
  ForceDimensionDevice(std::shared_ptr<Port> port, const WorkspaceMapping& mapping, double rate_hz)
      : port_(std::move(port)), rate_hz_(rate_hz), link_(port_->name, mapping, port_->limits) {}
  ~ForceDimensionDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {port_->name, rate_hz_, true, link_.mapping().to_tablet(port_->limits)};
  }

  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (clock_.status().running)
      return base::fail(base::Errc::device, "the device is already running", port_->name);
    const dhd::Functions& dhd = port_->dhd;
    if (dhd.set_gravity_compensation != nullptr) (void)dhd.set_gravity_compensation(1, port_->id);
    if (dhd.set_max_force != nullptr) (void)dhd.set_max_force(port_->limits.max_force_n, port_->id);
    // An omega.7 or sigma.7 has no button but its gripper; other devices refuse this.
    if (dhd.emulate_button != nullptr) (void)dhd.emulate_button(1, port_->id);
    (void)dhd.set_force(0, 0, 0, port_->id);
    // Succeeds even where the device is not homed; its status shows that.
    if (dhd.enable_force(1, port_->id) < 0)
      return base::fail(base::Errc::device, "it does not output force: " + last_error(dhd), port_->name,
                        "switch it on and calibrate it: on a Falcon, pull all arms out, then push them in");
    bad_ticks_ = ticks_ = looks_without_force_ = 0;
    trouble_ = DeviceTrouble::none;
    over_ = false;
    link_.start(servo, &ForceDimensionDevice::switch_off, this);
    auto started = clock_.start(1 / rate_hz_, [this](double) { tick(); });
    if (!started) {
      write_zero();
      link_.stop();
    }
    return started;
  }

  void stop() noexcept override {
    if (!clock_.status().running) return;
    clock_.stop();
    write_zero();
    link_.stop();
  }

  [[nodiscard]] haptics::DeviceStatus status() const override { return link_.status(); }

 private:
  static void switch_off(void* self) noexcept { static_cast<ForceDimensionDevice*>(self)->write_zero(); }
  /// Sets zero force and switches the output off.
  void write_zero() noexcept {
    (void)port_->dhd.set_force(0, 0, 0, port_->id);
    (void)port_->dhd.enable_force(0, port_->id);
  }

  void tick() noexcept {
    if (over_) return;
    if (ForceGuard::forces() == Forces::cut) {
      over_ = true;
      write_zero();
      return link_.confirm_off();
    }
    const dhd::Functions& dhd = port_->dhd;
    const auto begin = Clock::now();
    look();
    // x towards the operator, y to the right, z up.
    double out = NAN, right = NAN, up = NAN;
    bool fine = dhd.get_position(&out, &right, &up, port_->id) >= 0;
    const std::uint32_t buttons = fine ? pressed() : 0;
    Vec3 force(0);
    if (fine && trouble_ != DeviceTrouble::none)
      link_.pause(DeviceState::paused, trouble_, cause_, buttons);
    else if (fine)
      force = link_.feel({right, up, out}, buttons);
    fine = dhd.set_force(force.z, force.x, force.y, port_->id) >= 0 && fine;
    if (fine) {
      bad_ticks_ = 0;
      link_.note_delay_s(std::chrono::duration<double>(Clock::now() - begin).count());
      if (force == Vec3(0)) link_.confirm_zero();
      return;
    }
    over_ = ++bad_ticks_ >= kMostBadTicks;
    if (over_)
      write_zero();
    else
      (void)dhd.set_force(0, 0, 0, port_->id);
    link_.pause(over_ ? DeviceState::lost : DeviceState::paused, DeviceTrouble::communication_lost, 0,
                buttons);
    if (over_) link_.confirm_off();
  }

  /// Checks regularly whether the device is homed and its forces are on. For the library switching them on
  /// succeeds even where the device brakes, and the device may switch them off by itself.
  void look() noexcept {
    const dhd::Functions& dhd = port_->dhd;
    if (dhd.status == nullptr || ticks_++ % kLookTicks != 0) return;
    std::array<int, dhd::kStatusRoom> status{};
    if (dhd.status(status.data(), port_->id) < 0) return;  // the position fails, too
    const Clock::time_point now = Clock::now();
    if (status[dhd::kReset] != 0) {
      trouble_ = DeviceTrouble::not_homed;
      looks_without_force_ = kForceOffLooks;  // it stays off until it is switched on again
      rest_until_ = now;
      cause_ = 0;
      return;
    }
    if (status[dhd::kForce] != 0) {
      trouble_ = DeviceTrouble::none;
      looks_without_force_ = 0;
      return;
    }
    if (looks_without_force_ == 0) rest_until_ = now + kForceRest;
    looks_without_force_ = std::min(looks_without_force_ + 1, kForceOffLooks);
    if (looks_without_force_ < kForceOffLooks) return;
    trouble_ = DeviceTrouble::forces_off;
    cause_ = status[dhd::kForceOffCause];
    const auto cause = static_cast<ForcesOff>(cause_);
    const bool waits_for_somebody =
        cause == ForcesOff::button || cause == ForcesOff::grip_switch || cause == ForcesOff::usb;
    if (waits_for_somebody || now < rest_until_) return;
    rest_until_ = now + kForceRest;
    (void)dhd.set_force(0, 0, 0, port_->id);
    (void)dhd.enable_force(1, port_->id);
  }

  [[nodiscard]] std::uint32_t pressed() const noexcept {
    const dhd::Functions& dhd = port_->dhd;
    if (dhd.button_mask != nullptr) return dhd.button_mask(port_->id);
    return dhd.button != nullptr && dhd.button(0, port_->id) > 0 ? 1U : 0U;
  }

  std::shared_ptr<Port> port_;
  double rate_hz_;
  ServoLink link_;
  // Servo thread.
  int bad_ticks_ = 0, ticks_ = 0, looks_without_force_ = 0;
  bool over_ = false;
  DeviceTrouble trouble_ = DeviceTrouble::none;  // as the status tells
  std::int32_t cause_ = 0;
  Clock::time_point rest_until_;
  RtThread clock_;  // declared last, so that it stops before the other members are destroyed
};

class ForceDimensionBackEnd final : public BackEnd {
 public:
  explicit ForceDimensionBackEnd(ForceDimensionSettings settings) : settings_(std::move(settings)) {}
  [[nodiscard]] std::string_view id() const override { return "forcedimension"; }

  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{"Force Dimension and Novint Falcon", {}, std::nullopt};
    const auto dhd = load(settings_.library);
    if (!dhd) {
      found.problem = dhd.error();
      return found;
    }
    const int count = dhd->device_count();
    for (int i = 0; i < std::min(count, 16); ++i) {
      if (const auto open = open_port(i)) {
        found.devices.push_back({id_of(i), open->name, true, true});
        found.problem = in_use(open->name).value();
        continue;
      }
      const auto port = port_of(*dhd, i);
      if (port)
        found.devices.push_back({id_of(i), (*port)->name, true, true});
      else
        found.problem = port.error();
    }
    if (found.devices.empty() && !found.problem) found.problem = refused(*dhd).value();
    return found;
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    int index = 0;
    if (const std::size_t colon = device.find(':'); colon != std::string_view::npos) {
      const std::string_view number = device.substr(colon + 1);
      const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), index);
      if (failed != std::errc() || end != number.data() + number.size() || index < 0 || index > 15)
        return no_device(DeviceTrouble::device_absent, "this device does not exist", std::string(device),
                         "the first device is forcedimension:0");
    }
    if (const auto open = open_port(index)) return in_use(open->name);
    const auto dhd = load(settings_.library);
    if (!dhd) return tl::unexpected(dhd.error());
    const auto port = port_of(*dhd, index);
    if (!port) return tl::unexpected(port.error());
    const WorkspaceCalibration fit =
        request.calibration.value_or(fit_workspace((*port)->workspace, request.shape, request.posture));
    const auto mapping = WorkspaceMapping::create(fit);
    if (!mapping) return tl::unexpected(DeviceProblem{DeviceTrouble::bad_calibration, mapping.error()});
    open_[index] = *port;
    return OpenedDevice{id_of(index),
                        std::make_unique<ForceDimensionDevice>(*port, *mapping, settings_.rate_hz), fit,
                        (*port)->workspace};
  }

 private:
  static std::string id_of(int index) { return "forcedimension:" + std::to_string(index); }
  static tl::unexpected<DeviceProblem> in_use(const std::string& name) {
    return no_device(DeviceTrouble::in_use, "it is already open in this program", name, "use the open one");
  }
  [[nodiscard]] tl::unexpected<DeviceProblem> refused(const dhd::Functions& dhd) const {
    switch (dhd.last_error()) {
      case dhd::kErrorNoDevice:
      case 0:
        // The library opens USB devices directly.
        if (const auto advice = permission_advice(
                usb_nodes(settings_.device_folder, settings_.system_folder, {dhd::kVendor, dhd::kFalconUsb})))
          return no_device(DeviceTrouble::no_permission, "no device responds", kName, *advice);
        return no_device(DeviceTrouble::device_absent, "no device responds", kName,
                         "plug it in and switch it on");
      case dhd::kErrorBusy:
      case dhd::kErrorInUse:
        return no_device(DeviceTrouble::in_use, "the device is already in use", kName,
                         "close the program that uses it");
      default:
        return no_device(DeviceTrouble::init_failed, "the device cannot be opened: " + last_error(dhd), kName,
                         "switch it off and on; for permissions see docs/devices.md");
    }
  }
  [[nodiscard]] DeviceResult<std::shared_ptr<Port>> port_of(const dhd::Functions& dhd, int index) const {
    const int id = dhd.open(static_cast<char>(index));
    if (id < 0) return refused(dhd);
    return std::make_shared<Port>(dhd, static_cast<char>(id));
  }
  [[nodiscard]] std::shared_ptr<Port> open_port(int index) const {
    const auto found = open_.find(index);
    return found == open_.end() ? nullptr : found->second.lock();
  }

  ForceDimensionSettings settings_;
  std::map<int, std::weak_ptr<Port>> open_;
};

}  // namespace

std::unique_ptr<BackEnd> force_dimension_back_end(ForceDimensionSettings settings) {
  return std::make_unique<ForceDimensionBackEnd>(std::move(settings));
}

}  // namespace nazori::devices
