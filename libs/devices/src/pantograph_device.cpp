// SPDX-License-Identifier: Apache-2.0
#include "pantograph_device.h"

#include <string>
#include <utility>

#include "nazori/devices/rt_thread.h"
#include "pantograph_link.h"

namespace nazori::devices::pantograph {
namespace {

class PantographDevice final : public haptics::HapticDevice {
 public:
  PantographDevice(OpenBoard board, const WorkspaceMapping& mapping, const geometry::TabletShape& shape)
      : board_(std::move(board)),
        name_(board_.model.name),
        feeling_(name_, mapping, board_.limits),
        servo_(feeling_, board_.model, board_.limits.delay_s, shape.width_m / 2, shape.depth_m),
        link_(board_.port, board_.model.setup, board_.give_up_s, feeling_, servo_) {}
  ~PantographDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {name_, 1 / kPeriod_s, true, feeling_.mapping().to_tablet(board_.limits)};
  }

  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (link_.is_running()) return base::fail(base::Errc::device, "the device is already running", name_);
    feeling_.start(servo, &BoardLink::write_zero_at_end, &link_);
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
  const OpenBoard board_;
  const std::string name_;
  ServoLink feeling_;
  BoardServo servo_;
  BoardLink link_;
  RtThread clock_;  // declared last, so that it stops before the other members are destroyed
};

}  // namespace

DeviceWorkspace plane_workspace() {
  return {{-kReach_m, -kReach_m, -kReach_m}, {kReach_m, kReach_m, kReach_m}};
}

haptics::DeviceLimits plane_limits() {
  haptics::DeviceLimits limits;
  limits.max_force_n = kMostForce_n;
  // The maker publishes neither the continuous force nor the stable stiffness: cautious estimates.
  limits.continuous_force_n = kMostForce_n / 2;
  limits.max_stiffness_n_m = 400;
  limits.max_damping_n_s_m = 1;
  return limits;
}

std::unique_ptr<haptics::HapticDevice> pantograph_device(OpenBoard board, const WorkspaceMapping& mapping,
                                                         const geometry::TabletShape& shape) {
  return std::make_unique<PantographDevice>(std::move(board), mapping, shape);
}

}  // namespace nazori::devices::pantograph
