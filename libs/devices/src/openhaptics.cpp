// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/openhaptics.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "openhaptics_errors.h"
#include "openhaptics_port.h"
#include "servo_link.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kCalibrationTicks = 64;  // between checks of the calibration
constexpr int kZeroTicks = 4;          // of zero force before the scheduler stops
constexpr int kMostBadTicks = 50;      // in a row, before errors of an unknown kind count as fatal
constexpr auto kFirstRest = milliseconds(500);
constexpr auto kLongestRest = milliseconds(8000);
constexpr auto kFirstTick = milliseconds(250);
constexpr auto kForgiven = std::chrono::seconds(10);  // without an error, before pauses are short again

class OpenHapticsDevice final : public haptics::HapticDevice {
 public:
  OpenHapticsDevice(std::shared_ptr<hd::Port> port, const WorkspaceMapping& mapping, unsigned long rate_hz)
      : port_(std::move(port)), rate_hz_(rate_hz), link_(port_->name, mapping, port_->limits) {}
  ~OpenHapticsDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {port_->name, static_cast<double>(rate_hz_), true, link_.mapping().to_tablet(port_->limits)};
  }
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override;
  void stop() noexcept override;
  [[nodiscard]] haptics::DeviceStatus status() const override { return link_.status(); }

 private:
  struct Reading {
    Vec3 at_m{0, 0, 0};
    std::uint32_t buttons = 0;
    bool docked = false, released = false;
  };
  static unsigned int scheduled(void* self) noexcept { return static_cast<OpenHapticsDevice*>(self)->tick(); }
  /// The servo crashed inside a frame begun by this program.
  static void switch_off(void* self) noexcept { static_cast<OpenHapticsDevice*>(self)->write_zero(true); }
  unsigned int tick() noexcept;
  /// The last ticks: zero force each, then the output goes off and no tick follows.
  unsigned int leave() noexcept;
  /// Sends zero force in a new frame, or in the open one. @param for_good  also switches the output off.
  void write_zero(bool for_good) noexcept;
  /// Whether a tick comes within kFirstTick.
  [[nodiscard]] bool ticks_come() const noexcept;
  Reading read() noexcept;
  /// The fault of the device's calibration, if any; calibrates where possible.
  DeviceTrouble calibrate(const Reading& now) noexcept;
  /// Handles an error of the library. @return false where the callback must end.
  bool book(const hd::ErrorInfo& error) noexcept;

  std::shared_ptr<hd::Port> port_;
  unsigned long rate_hz_;
  ServoLink link_;
  hd::SchedulerHandle scheduled_ = 0;
  bool started_ = false;  // interface
  std::atomic<bool> stopping_{false}, ended_{false}, ticked_{false};
  // Servo thread.
  int ticks_ = 0, zero_ticks_ = 0, bad_ticks_ = 0;
  bool leaving_ = false, in_frame_ = false, is_bad_tick_ = false;
  std::uint32_t buttons_before_ = 0;
  unsigned int error_ = 0;  // why the force rests
  Clock::time_point rest_until_, last_error_;
  Clock::duration rest_ = kFirstRest;
  bool inkwell_seen_ = false, switch_seen_ = false;
  DeviceTrouble calibration_ = DeviceTrouble::none;
};

base::Result<void> OpenHapticsDevice::start(haptics::ServoCallback& servo) {
  if (started_) return base::fail(base::Errc::device, "the device is already running", port_->name);
  const hd::Functions& hd = port_->hd;
  const auto refuse = [&](const char* what, unsigned int code) {
    hd.disable(hd::kForceOutput);
    (void)hd::pop_errors(hd);
    const base::Error cause = trouble_error(trouble_of(code), "", static_cast<int>(code));
    return tl::unexpected(
        base::Error{base::Errc::device, what, port_->name, cause.what + "; " + cause.remedy});
  };
  (void)hd::pop_errors(hd);
  // A scheduler that did not start for one of these reasons reports no error the second time.
  const unsigned int before = hd::latched_error();
  hd.make_current(port_->handle);
  hd.enable(hd::kForceOutput);
  if (const auto error = hd::pop_errors(hd); error.code != 0)
    return refuse("it does not output force", error.code);
  if (hd.set_scheduler_rate != nullptr && rate_hz_ != 1000) {
    hd.set_scheduler_rate(rate_hz_);
    if (hd::pop_errors(hd).code != 0)
      rate_hz_ = 1000;  // refused: the default is kept, which is not a failure
  }
  stopping_ = ended_ = ticked_ = false;
  ticks_ = zero_ticks_ = bad_ticks_ = 0;
  leaving_ = in_frame_ = false;
  buttons_before_ = ~0U;  // buttons that are already down do not count as pressed now
  error_ = 0;
  rest_ = kFirstRest;
  rest_until_ = last_error_ = Clock::time_point{};
  calibration_ = DeviceTrouble::none;
  link_.start(servo, &OpenHapticsDevice::switch_off, this);
  scheduled_ = hd.schedule_asynchronous(&OpenHapticsDevice::scheduled, this, hd::kFirst);
  if (const auto error = hd::pop_errors(hd); error.code != 0) {
    link_.stop();
    return refuse("its scheduler does not accept the servo", error.code);
  }
  started_ = true;
  {
    const SignalsBlocked inherited;  // by the scheduler's thread
    hd.start_scheduler();
  }
  // Force errors of the first ticks are handled by the servo.
  auto error = hd::pop_errors(hd);
  if (kind_of(error.code) != ErrorKind::end && before != 0) {
    if (ticks_come())
      hd::forget_latched_error();
    else
      error.code = before;
  }
  if (kind_of(error.code) == ErrorKind::end) {
    stop();
    return refuse("its scheduler cannot be started", error.code);
  }
  return {};
}

bool OpenHapticsDevice::ticks_come() const noexcept {
  const Clock::time_point end = Clock::now() + kFirstTick;
  while (!ticked_.load(std::memory_order_acquire) && Clock::now() < end)
    std::this_thread::sleep_for(milliseconds(1));
  return ticked_.load(std::memory_order_acquire);
}

void OpenHapticsDevice::stop() noexcept {
  if (!started_) return;
  const hd::Functions& hd = port_->hd;
  stopping_.store(true, std::memory_order_release);
  // The last ticks write zeros. A scheduler that has stopped must not block the program.
  for (int i = 0; i < 200 && !ended_.load(std::memory_order_acquire); ++i)
    std::this_thread::sleep_for(milliseconds(1));
  hd.stop_scheduler();
  hd.unschedule(scheduled_);
  (void)hd::pop_errors(hd);
  // With the scheduler stopped this thread may write, whether or not the last ticks came. The frame of the
  // last tick would count as the only one allowed.
  hd.disable(hd::kOneFrameLimit);
  write_zero(true);
  hd.enable(hd::kOneFrameLimit);
  (void)hd::pop_errors(hd);
  started_ = false;
  link_.stop();
}

void OpenHapticsDevice::write_zero(bool for_good) noexcept {
  const hd::Functions& hd = port_->hd;
  constexpr double kNothing[3] = {0, 0, 0};
  if (!in_frame_) {
    hd.make_current(port_->handle);
    hd.begin_frame(port_->handle);
  }
  hd.set_doubles(hd::kForce, kNothing);
  hd.end_frame(port_->handle);
  in_frame_ = false;
  if (for_good) hd.disable(hd::kForceOutput);
}

unsigned int OpenHapticsDevice::leave() noexcept {
  leaving_ = true;
  const bool last = ++zero_ticks_ >= kZeroTicks;
  write_zero(last);
  (void)hd::pop_errors(port_->hd);
  if (!last) return hd::kAgain;
  link_.confirm_off();
  ended_.store(true, std::memory_order_release);
  return hd::kDone;
}

OpenHapticsDevice::Reading OpenHapticsDevice::read() noexcept {
  const hd::Functions& hd = port_->hd;
  Reading r;
  double mm[3] = {NAN, NAN, NAN};
  hd.get_doubles(hd::kPosition, mm);
  r.at_m = Vec3(mm[0], mm[1], mm[2]) * 1e-3;
  int buttons = 0;
  hd.get_integers(hd::kButtons, &buttons);
  r.buttons = static_cast<std::uint32_t>(buttons);
  // Each switch counts only once it has been seen on, or if the device reports that it has one: devices
  // without it always read 0.
  if (port_->reads_inkwell) {
    hd::Boolean out = 0;
    hd.get_booleans(hd::kInkwellSwitch, &out);
    if (out != 0) inkwell_seen_ = true;
    r.docked = out == 0 && (inkwell_seen_ || (port_->calibration_styles & hd::kInkwellStyle) != 0);
  }
  if (port_->reads_safety_switch) {
    hd::Boolean held = 0;
    hd.get_booleans(hd::kSafetySwitch, &held);
    if (held != 0) switch_seen_ = true;
    r.released = held == 0 && switch_seen_;
  }
  return r;
}

DeviceTrouble OpenHapticsDevice::calibrate(const Reading& now) noexcept {
  const hd::Functions& hd = port_->hd;
  const std::uint32_t pressed = now.buttons & ~buttons_before_;
  buttons_before_ = now.buttons;
  const int style = hd::preferred_style(port_->calibration_styles);
  const bool confirmed = calibration_ == DeviceTrouble::wants_reset_position && pressed != 0;
  if (ticks_++ % kCalibrationTicks != 0 && !confirmed) return calibration_;
  const unsigned int need = hd.check_calibration();
  if (need != hd::kNeedsUpdate && need != hd::kNeedsManualInput) return calibration_ = DeviceTrouble::none;
  switch (style) {
    case hd::kInkwellStyle:
      calibration_ = DeviceTrouble::wants_inkwell;
      break;
    case hd::kResetStyle:
      calibration_ = DeviceTrouble::wants_reset_position;
      break;
    default:
      calibration_ = DeviceTrouble::not_calibrated;
  }
  // Encoders reset anywhere but at the reset position would be wrong from then on, and only the learner knows
  // when the arm is there.
  const bool in_place = style == hd::kResetStyle ? confirmed
                                                 : need == hd::kNeedsUpdate && (style == hd::kAutoStyle ||
                                                                                (style != 0 && now.docked));
  if (in_place) hd.update_calibration(static_cast<unsigned int>(style));
  return calibration_;
}

bool OpenHapticsDevice::book(const hd::ErrorInfo& error) noexcept {
  const ErrorKind kind = kind_of(error.code);
  if (kind == ErrorKind::none) return true;
  if (kind == ErrorKind::other) {
    is_bad_tick_ = true;
    if (bad_ticks_ + 1 < kMostBadTicks) return true;
    error_ = error.code;
    return false;
  }
  error_ = error.code;
  if (kind == ErrorKind::end) return false;
  const Clock::time_point now = Clock::now();
  if (now > rest_until_) {  // a new press, not a repetition of the last one
    rest_ = now - last_error_ < kForgiven ? std::min<Clock::duration>(2 * rest_, kLongestRest) : kFirstRest;
  }
  last_error_ = now;
  rest_until_ = now + rest_;
  return true;
}

unsigned int OpenHapticsDevice::tick() noexcept {
  const hd::Functions& hd = port_->hd;
  ticked_.store(true, std::memory_order_release);
  if (leaving_ || stopping_.load(std::memory_order_acquire) || ForceGuard::forces() == Forces::cut)
    return leave();

  const Clock::time_point begin = Clock::now();
  is_bad_tick_ = false;
  hd.make_current(port_->handle);
  hd.begin_frame(port_->handle);
  in_frame_ = true;
  const Reading now = read();
  const DeviceTrouble calibration = calibrate(now);
  bool goes_on = book(hd::pop_errors(hd));
  const bool resting = Clock::now() < rest_until_;
  double force_n[3] = {0, 0, 0};
  if (!goes_on) {
    link_.pause(DeviceState::lost, trouble_of(error_), static_cast<std::int32_t>(error_), now.buttons);
  } else if (resting) {
    link_.pause(DeviceState::paused, trouble_of(error_), static_cast<std::int32_t>(error_), now.buttons);
  } else if (calibration != DeviceTrouble::none) {
    link_.pause(DeviceState::paused, calibration, 0, now.buttons);
  } else if (now.docked) {
    link_.pause(DeviceState::paused, DeviceTrouble::docked, 0, now.buttons);
  } else if (now.released) {
    link_.pause(DeviceState::paused, DeviceTrouble::safety_switch, 0, now.buttons);
  } else {
    // Hard errors switch the output off; it must be switched on again to continue.
    if (error_ != 0 && hd.is_enabled(hd::kForceOutput) == 0) hd.enable(hd::kForceOutput);
    error_ = 0;
    const Vec3 force = link_.feel(now.at_m, now.buttons);
    force_n[0] = force.x;
    force_n[1] = force.y;
    force_n[2] = force.z;
  }
  hd.set_doubles(hd::kForce, force_n);
  hd.end_frame(port_->handle);
  in_frame_ = false;
  link_.note_delay_s(std::chrono::duration<double>(Clock::now() - begin).count());
  if (goes_on && !book(hd::pop_errors(hd))) {
    goes_on = false;
    link_.pause(DeviceState::lost, trouble_of(error_), static_cast<std::int32_t>(error_), now.buttons);
  }
  bad_ticks_ = is_bad_tick_ ? bad_ticks_ + 1 : 0;
  // The failed frame may have left an earlier force on the device: the next ones write zeros.
  leaving_ = !goes_on;
  if (force_n[0] == 0 && force_n[1] == 0 && force_n[2] == 0) link_.confirm_zero();
  return hd::kAgain;
}

class OpenHapticsBackEnd final : public BackEnd {
 public:
  explicit OpenHapticsBackEnd(OpenHapticsSettings settings) : settings_(std::move(settings)) {}
  [[nodiscard]] std::string_view id() const override { return "openhaptics"; }

  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{"OpenHaptics (PHANTOM, Touch)", {}, std::nullopt};
    if (const auto open = open_.lock()) {
      found.devices.push_back({"openhaptics", open->name, true, true});
      found.problem = in_use(open->name).value();
      return found;
    }
    const auto port = port_of("");
    if (port)
      found.devices.push_back({"openhaptics", (*port)->name, true, true});
    else
      found.problem = port.error();
    return found;
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    if (const auto already = open_.lock()) return in_use(already->name);
    const std::size_t colon = device.find(':');
    const auto port = port_of(colon == std::string_view::npos ? "" : std::string(device.substr(colon + 1)));
    if (!port) return tl::unexpected(port.error());
    const WorkspaceCalibration fit =
        request.calibration.value_or(fit_workspace((*port)->workspace, request.shape, request.posture));
    const auto mapping = WorkspaceMapping::create(fit);
    if (!mapping) return tl::unexpected(DeviceProblem{DeviceTrouble::bad_calibration, mapping.error()});
    open_ = *port;
    return OpenedDevice{std::string(device),
                        std::make_unique<OpenHapticsDevice>(*port, *mapping, settings_.rate_hz), fit,
                        (*port)->workspace};
  }

 private:
  static tl::unexpected<DeviceProblem> in_use(const std::string& name) {
    return no_device(DeviceTrouble::in_use, "it is already open in this program", name, "use the open one");
  }
  [[nodiscard]] DeviceResult<std::shared_ptr<hd::Port>> port_of(const std::string& name) const {
    const auto functions = hd::load(settings_.library);
    if (!functions) return tl::unexpected(functions.error());
    return hd::Port::open(*functions, settings_, name);
  }

  OpenHapticsSettings settings_;
  std::weak_ptr<hd::Port> open_;
};

}  // namespace

std::unique_ptr<BackEnd> openhaptics_back_end(OpenHapticsSettings settings) {
  return std::make_unique<OpenHapticsBackEnd>(std::move(settings));
}

}  // namespace nazori::devices
