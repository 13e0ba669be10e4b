// SPDX-License-Identifier: Apache-2.0
#include "inverse_device.h"

#include "nazori/devices/rt_thread.h"

namespace nazori::devices::inverse {
namespace {

class ArmDevice final : public haptics::HapticDevice {
 public:
  ArmDevice(const InverseServiceSettings& settings, const ArmAddress& arm, const std::string& name,
            const haptics::DeviceLimits& limits, const WorkspaceMapping& mapping)
      : name_(name),
        limits_(limits),
        feeling_(name, mapping, limits),
        servo_(feeling_, limits.delay_s),
        link_(settings, arm, servo_) {}
  ~ArmDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {name_, 1 / kPeriod_s, true, feeling_.mapping().to_tablet(limits_)};
  }

  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (link_.is_running()) return base::fail(base::Errc::device, "the device is already running", name_);
    feeling_.start(servo);
    servo_.start();
    auto started = link_.start();
    if (started) started = clock_.start(kPeriod_s, [this](double) { servo_.tick(); });
    if (!started) {
      link_.stop();
      feeling_.stop();
    }
    return started;
  }

  void stop() noexcept override {
    if (!link_.is_running()) return;
    clock_.stop();
    link_.stop();
    feeling_.stop();
  }

  [[nodiscard]] haptics::DeviceStatus status() const override { return feeling_.status(); }

 private:
  const std::string name_;
  const haptics::DeviceLimits limits_;
  ServoLink feeling_;
  ArmServo servo_;
  ArmLink link_;
  RtThread clock_;  // declared last, so that it stops before the other members are destroyed
};

}  // namespace

void ArmServo::start() noexcept {
  lost_ = false;
  poses.back() = {};
  poses.publish();
  forces.back() = {};
  forces.publish();
}

std::unique_ptr<haptics::HapticDevice> arm_device(const InverseServiceSettings& settings,
                                                  const ArmAddress& arm, const std::string& name,
                                                  const haptics::DeviceLimits& limits,
                                                  const WorkspaceMapping& mapping) {
  return std::make_unique<ArmDevice>(settings, arm, name, limits, mapping);
}

}  // namespace nazori::devices::inverse
