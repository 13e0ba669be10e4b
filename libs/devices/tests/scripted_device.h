// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "nazori/devices/back_end.h"
#include "nazori/devices/rt_thread.h"

namespace nazori::devices::test {

/// The test's control of a device, and a record of the commands to the device. Outlives it.
struct Script {
  std::atomic<double> x_m{0}, y_m{0}, z_m{0.02};
  std::atomic<std::uint32_t> buttons{0};
  std::atomic<haptics::DeviceState> state{haptics::DeviceState::running};
  std::atomic<haptics::DeviceTrouble> trouble{haptics::DeviceTrouble::none};
  std::atomic<bool> plugged_in{true};
  std::atomic<double> force_n{0};       ///< as of the last tick
  std::atomic<double> most_force_n{0};  ///< of all ticks
  std::atomic<double> most_step_n{0};   ///< largest change of force in a millisecond; a tick may come late
  std::atomic<std::uint64_t> ticks{0};
  std::atomic<int> opened{0};
  std::atomic<double> asked_tilt_rad{-1};
  std::atomic<bool> asked_calibrated{false};
};

/// A device with force whose hand, buttons and troubles are the test's.
class ScriptedDevice final : public haptics::HapticDevice {
 public:
  explicit ScriptedDevice(std::shared_ptr<Script> script) : script_(std::move(script)) {}
  ~ScriptedDevice() override { stop(); }
  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {"Scripted arm", 1000, true, {}};
  }
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    return clock_.start(0.001, [this, &servo](double now_s) {
      const bool running = script_->state == haptics::DeviceState::running;
      const haptics::DeviceSample sample{now_s,
                                         {script_->x_m.load(), script_->y_m.load(), script_->z_m.load()},
                                         script_->buttons.load(),
                                         running};
      const haptics::Vec3 force = servo.tick(sample);
      const double size_n = std::sqrt(force.x * force.x + force.y * force.y + force.z * force.z);
      const double late_ms = std::max(1.0, (now_s - last_s_) * 1000);
      last_s_ = now_s;
      script_->most_step_n =
          std::max(script_->most_step_n.load(), std::abs(size_n - script_->force_n) / late_ms);
      script_->most_force_n = std::max(script_->most_force_n.load(), size_n);
      script_->force_n = size_n;
      ++script_->ticks;
    });
  }
  void stop() noexcept override {
    clock_.stop();
    script_->force_n = 0;
  }
  [[nodiscard]] haptics::DeviceStatus status() const override {
    return {script_->state, script_->trouble, "", script_->buttons, 1000, 0};
  }

 private:
  std::shared_ptr<Script> script_;
  double last_s_ = 0;  // of the tick before; the clock thread's
  RtThread clock_;
};

class ScriptedBackEnd final : public BackEnd {
 public:
  explicit ScriptedBackEnd(std::shared_ptr<Script> script) : script_(std::move(script)) {}
  [[nodiscard]] std::string_view id() const override { return "scripted"; }
  [[nodiscard]] BackEndFindings find() override {
    if (!script_->plugged_in)
      return {"Scripts", {}, {{haptics::DeviceTrouble::device_absent, {base::Errc::device, "none", "", ""}}}};
    return {"Scripts", {{"scripted:arm", "Scripted arm", true, true}}, std::nullopt};
  }
  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view, const OpenRequest& request) override {
    if (!script_->plugged_in)
      return no_device(haptics::DeviceTrouble::device_absent, "nothing is plugged in", "Scripts", "");
    ++script_->opened;
    script_->asked_tilt_rad = request.posture.tilt_rad;
    script_->asked_calibrated = request.calibration.has_value();
    return OpenedDevice{"scripted:arm",
                        std::make_unique<ScriptedDevice>(script_),
                        request.calibration.value_or(WorkspaceCalibration{1, {}, request.posture, 0}),
                        {}};
  }

 private:
  std::shared_ptr<Script> script_;
};

/// Back ends with only this device.
inline std::vector<std::unique_ptr<BackEnd>> only(std::shared_ptr<Script> script) {
  std::vector<std::unique_ptr<BackEnd>> all;
  all.push_back(std::make_unique<ScriptedBackEnd>(std::move(script)));
  return all;
}

}  // namespace nazori::devices::test
