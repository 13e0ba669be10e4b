// SPDX-License-Identifier: Apache-2.0
#include "sdl_device.h"

#include <SDL2/SDL_thread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <system_error>
#include <thread>

#include "force_guard.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/haptics/latest_value.h"
#include "sdl_feedback.h"
#include "servo_link.h"

namespace nazori::devices::sdl {
namespace {

using Clock = std::chrono::steady_clock;
using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;

constexpr double kPeriod_s = 0.001;
constexpr auto kTalk = std::chrono::milliseconds(4);
constexpr auto kSilent = std::chrono::milliseconds(200);
constexpr double kReach_m = 0.06;   // travel of a stick to each side: a hand's breadth in total
constexpr double kHover_m = 0.005;  // of the tip above the plateau
constexpr double kHand_s =
    0.008;  // two low-pass filters: because an axis changes in steps, 250 times a second
constexpr double kDeepest = 1.15;  // below the deepest groove: a full press touches the bottom
constexpr double kRim = 0.95;      // worn sticks do not reach their ends
constexpr double kRumbleFull_n = 1.0;
constexpr int kMostRefusals = 20;  // in a row

double seconds(Clock::time_point t) { return std::chrono::duration<double>(t.time_since_epoch()).count(); }

/// A pad's stick moves in a circle, the tablet is a square: the rim of the circle is mapped to the edge of
/// the square.
void square(double& x, double& y) {
  const double most = std::max(std::abs(x), std::abs(y));
  if (most > 0) {
    const double stretch = std::hypot(x, y) / most / kRim;
    x = std::clamp(x * stretch, -1.0, 1.0);
    y = std::clamp(y * stretch, -1.0, 1.0);
  }
}

class StickDevice final : public haptics::HapticDevice {
 public:
  StickDevice(std::shared_ptr<Controller> controller, Listed listed, const WorkspaceMapping& mapping,
              double depth_m)
      : controller_(std::move(controller)),
        listed_(std::move(listed)),
        limits_(stick_limits(listed_.abilities)),
        depth_m_(depth_m),
        link_(listed_.name, mapping, limits_) {}
  ~StickDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {listed_.name, 1 / kPeriod_s, listed_.abilities.force(), link_.mapping().to_tablet(limits_)};
  }

  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (talk_.joinable())
      return base::fail(base::Errc::device, "the device is already running", listed_.name);
    Pose pose{controller_->read(), Clock::now(), false};
    if (!pose.reading.attached)
      return base::fail(base::Errc::device, "it is no longer connected", listed_.name,
                        "plug it in and select it again");
    if (listed_.abilities.force()) {
      auto effects = ForceEffects::create(*controller_, listed_.abilities);
      if (!effects) return tl::unexpected(effects.error());
      effects_.emplace(std::move(*effects));
    }
    poses_.back() = pose;
    poses_.publish();
    commands_.back() = {};
    commands_.publish();
    events_ = 0;
    delay_s_ = 0;
    halfway_ = at_ = target(pose.reading);
    over_ = false;
    servo_ = &servo;
    link_.start(servo);
    auto started = clock_.start(kPeriod_s, [this](double) { tick(); });
    if (!started) {
      effects_.reset();
      link_.stop();
      return started;
    }
    try {
      talk_ = std::jthread([this](const std::stop_token& stop) {
        talk(stop);
        SDL_TLSCleanup();  // SDL's data of this thread, which SDL did not start itself
      });
    } catch (const std::system_error& e) {
      clock_.stop();
      effects_.reset();
      link_.stop();
      return base::fail(base::Errc::device, std::string("the device thread cannot be started: ") + e.what(),
                        listed_.name);
    }
    return {};
  }

  void stop() noexcept override {
    if (!talk_.joinable()) return;
    clock_.stop();
    talk_.request_stop();
    talk_.join();
    effects_.reset();
    link_.stop();
  }

  [[nodiscard]] haptics::DeviceStatus status() const override { return link_.status(); }

 private:
  struct Pose {
    Reading reading;
    Clock::time_point at;
    bool refuses = false;  ///< it does not accept effects any more
  };
  struct Command {
    Wish wish;
    Clock::time_point at;
    Clock::time_point pose_at;  ///< of the reading that the force belongs to
  };

  /// Device frame. Thread: servo, and the interface's while nothing ticks.
  [[nodiscard]] Vec3 target(const Reading& r) const noexcept {
    double x = r.x, y = r.y;
    if (listed_.abilities.pad && !listed_.abilities.force()) square(x, y);
    const double press = std::clamp(r.press, 0.0, 1.0);
    const double tip_m = press > 0 ? -press * kDeepest * depth_m_ : kHover_m;
    const WorkspaceCalibration& fit = link_.mapping().calibration();
    return {x * kReach_m, y * kReach_m, fit.centre_m.z + tip_m / fit.scale};
  }

  void tick() noexcept {
    if (over_) return;
    const Pose& pose = poses_.latest();
    const auto now = Clock::now();
    Command command;
    command.at = now;
    command.pose_at = pose.at;
    if (!pose.reading.attached || pose.refuses) {
      over_ = true;
      link_.pause(DeviceState::lost,
                  pose.reading.attached ? DeviceTrouble::device_fault : DeviceTrouble::communication_lost, 0,
                  0);
    } else if (now - pose.at > kSilent) {
      link_.pause(DeviceState::paused, DeviceTrouble::too_slow, 0, pose.reading.buttons);
    } else {
      constexpr double kPass = kPeriod_s / (kPeriod_s + kHand_s);
      halfway_ += (target(pose.reading) - halfway_) * kPass;
      at_ += (halfway_ - at_) * kPass;
      link_.set_delay_s(delay_s_.load(std::memory_order_relaxed));
      const Vec3 force = link_.feel(at_, pose.reading.buttons);
      events_.fetch_or(servo_->events(), std::memory_order_relaxed);
      const double full_n = listed_.abilities.force() ? limits_.max_force_n : kRumbleFull_n;
      command.wish = {
          true, pose.reading.x, pose.reading.y, force.x / full_n, force.y / full_n, pose.reading.press > 0,
          0};
    }
    commands_.back() = command;
    commands_.publish();
  }

  /// The device's own thread: all communication with it.
  void talk(const std::stop_token& stop) {
    RumbleCues rumble(*controller_);
    int refusals = 0;
    const auto feel = [&](const Wish& wish, Clock::time_point now) {
      if (effects_) return effects_->apply(wish, seconds(now));
      if (listed_.abilities.rumble) rumble.apply(wish, seconds(now));
      return true;
    };
    while (!stop.stop_requested()) {
      Pose pose{controller_->read(), Clock::now(), refusals >= kMostRefusals};
      poses_.back() = pose;
      poses_.publish();
      Command command = commands_.latest();
      command.wish.events = static_cast<std::uint16_t>(events_.exchange(0, std::memory_order_relaxed));
      const auto now = Clock::now();
      const bool allowed = ForceGuard::forces() == Forces::allowed;
      // A servo that has stopped must not keep pushing.
      const bool live = allowed && pose.reading.attached && !pose.refuses && now - command.at < kSilent;
      if (!live) command.wish = {};
      refusals = feel(command.wish, now) ? 0 : refusals + 1;
      if (!allowed && refusals == 0) link_.confirm_no_force();
      if (live) {
        const double took_s = seconds(Clock::now()) - seconds(command.pose_at);
        delay_s_.store(smoothed_delay_s(delay_s_.load(std::memory_order_relaxed), took_s),
                       std::memory_order_relaxed);
      }
      if (!pose.reading.attached || pose.refuses) break;
      std::this_thread::sleep_for(kTalk);
    }
    (void)feel({}, Clock::now());
  }

  std::shared_ptr<Controller> controller_;
  Listed listed_;
  haptics::DeviceLimits limits_;
  double depth_m_;
  ServoLink link_;
  haptics::LatestValue<Pose> poses_{Pose{}};
  haptics::LatestValue<Command> commands_{Command{}};
  std::atomic<std::uint32_t> events_{0};
  std::atomic<double> delay_s_{0};       ///< from a reading to the effect for it; smoothed
  std::optional<ForceEffects> effects_;  // talk_'s
  // Servo thread.
  haptics::ServoCallback* servo_ = nullptr;
  Vec3 halfway_{0, 0, 0}, at_{0, 0, 0};
  bool over_ = false;
  // Declared last, so that they stop before the other members are destroyed.
  RtThread clock_;
  std::jthread talk_;
};

}  // namespace

DeviceWorkspace stick_workspace() {
  return {{-kReach_m, -kReach_m, -kReach_m}, {kReach_m, kReach_m, kReach_m}};
}

haptics::DeviceLimits stick_limits(const Abilities& abilities) {
  haptics::DeviceLimits limits;
  if (!abilities.force()) return limits;
  // Such devices do not report their force; this is the assumed full force.
  limits.max_force_n = limits.continuous_force_n = 3;
  limits.max_stiffness_n_m = 300;
  limits.max_damping_n_s_m = 1;
  limits.own_damping_n_s_m = 0.2;
  // Up to one cycle of talk_ for the position, and one more plus the pause between effects for the force.
  limits.delay_s = 2 * std::chrono::duration<double>(kTalk).count() + 1 / ForceEffects::kMost_hz;
  return limits;
}

std::unique_ptr<haptics::HapticDevice> stick_device(std::shared_ptr<Controller> controller,
                                                    const Listed& listed, const WorkspaceMapping& mapping,
                                                    double depth_m) {
  return std::make_unique<StickDevice>(std::move(controller), listed, mapping, depth_m);
}

}  // namespace nazori::devices::sdl
