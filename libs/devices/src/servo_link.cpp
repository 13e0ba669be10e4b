// SPDX-License-Identifier: Apache-2.0
#include "servo_link.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::devices {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;

namespace {

constexpr auto kStalled = std::chrono::milliseconds(500);
constexpr double kRateFilter = 0.02;

struct Sentence {
  const char* what;
  const char* remedy;
};

/// @param cause  as ForcesOff.
Sentence forces_off(std::int32_t cause) {
  switch (static_cast<ForcesOff>(cause)) {
    case ForcesOff::button:
      return {"its force button switched its forces off", "press that button again"};
    case ForcesOff::speed:
      return {"its forces went off because it moved too fast", "move more slowly; it resumes by itself"};
    case ForcesOff::watchdog:
      return {"its forces went off because the program was late",
              "close other programs; it goes on by itself"};
    case ForcesOff::software:
      return {"a program switched its forces off", "close other programs that use it; it goes on by itself"};
    case ForcesOff::usb:
      return {"its forces went off because its USB connection broke",
              "check the cable, then choose it again"};
    case ForcesOff::grip_switch:
      return {"its forces are off because nobody holds it", "hold the stylus so that its switch is covered"};
    case ForcesOff::unknown:
      break;
  }
  return {"its forces are off", "press its force button, or switch it off and on"};
}

bool finite(const Vec3& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

void ServoLink::start(haptics::ServoCallback& servo, ForceGuard::Off off, void* device) noexcept {
  servo_ = &servo;
  guard_.watch(off, device);
  begin_ = last_ = Clock::now();
  period_s_ = delay_s_ = 0;
  Stand stand;
  stand.state = DeviceState::running;
  stand.at = begin_;
  publish(stand);
}

void ServoLink::stop() noexcept {
  guard_.release();
  servo_ = nullptr;
  const Stand last = stand_.latest();
  Stand stand;
  // A lost device stays lost until it is opened again.
  if (last.state == DeviceState::lost) stand = last;
  publish(stand);
}

void ServoLink::publish(Stand stand) noexcept {
  stand_.back() = stand;
  stand_.publish();
}

haptics::DeviceSample ServoLink::sample(std::uint32_t buttons) noexcept {
  now_ = Clock::now();
  const double period = std::chrono::duration<double>(now_ - last_).count();
  period_s_ += (period - period_s_) * (period_s_ > 0 ? kRateFilter : 1.0);
  last_ = now_;
  haptics::DeviceSample s;
  s.time_s = std::chrono::duration<double>(now_ - begin_).count();
  s.position_m = last_tablet_m_;
  s.buttons = buttons;
  return s;
}

Vec3 ServoLink::ask(const haptics::DeviceSample& sample) noexcept {
  const ForceGuard::OwnCode own(guard_);
  return servo_->tick(sample);
}

Vec3 ServoLink::feel(const Vec3& device_m, std::uint32_t buttons) noexcept {
  if (ForceGuard::forces() != Forces::allowed) {
    pause(DeviceState::paused, DeviceTrouble::none, 0, buttons);
    return Vec3(0);
  }
  if (!finite(device_m)) {
    pause(DeviceState::paused, DeviceTrouble::bad_message, 0, buttons);
    return Vec3(0);
  }
  haptics::DeviceSample s = sample(buttons);
  s.position_m = last_tablet_m_ = mapping_.to_tablet_m(device_m);
  Vec3 force = mapping_.to_device_n(ask(s));
  const double size = glm::length(force);
  if (!(size <= limits_.max_force_n))
    force = std::isfinite(size) ? force * (limits_.max_force_n / size) : Vec3(0);
  Stand stand;
  stand.state = DeviceState::running;
  stand.buttons = buttons;
  stand.rate_hz = period_s_ > 0 ? 1 / period_s_ : 0;
  stand.delay_s = delay_s_;
  stand.at = now_;
  publish(stand);
  return force;
}

void ServoLink::pause(DeviceState state, DeviceTrouble trouble, std::int32_t code,
                      std::uint32_t buttons) noexcept {
  haptics::DeviceSample s = sample(buttons);
  s.present = false;
  (void)ask(s);
  Stand stand;
  stand.state = state;
  stand.trouble = trouble;
  stand.code = code;
  stand.buttons = buttons;
  stand.rate_hz = period_s_ > 0 ? 1 / period_s_ : 0;
  stand.delay_s = delay_s_;
  stand.at = now_;
  publish(stand);
}

haptics::DeviceStatus ServoLink::status() const {
  const Stand stand = stand_.latest();
  haptics::DeviceStatus s;
  s.state = stand.state;
  s.trouble = stand.trouble;
  s.buttons = stand.buttons;
  s.rate_hz = stand.rate_hz;
  s.delay_s = stand.delay_s;
  const bool ticks = stand.state == DeviceState::running || stand.state == DeviceState::paused;
  if (ticks && Clock::now() - stand.at > kStalled) {
    s.state = DeviceState::lost;
    s.trouble = DeviceTrouble::stalled;
    s.rate_hz = 0;
  }
  if (s.trouble != DeviceTrouble::none)
    s.message = base::to_line(trouble_error(s.trouble, name_, stand.code));
  return s;
}

base::Error trouble_error(DeviceTrouble trouble, const std::string& device, std::int32_t code) {
  const Sentence s = [&]() -> Sentence {
    switch (trouble) {
      case DeviceTrouble::none:
        return {"no problem", ""};
      case DeviceTrouble::library_missing:
        return {"its library is missing", "see docs/devices.md"};
      case DeviceTrouble::symbol_missing:
        return {"its library is incomplete", "install the manufacturer's latest version"};
      case DeviceTrouble::service_missing:
        return {"its service does not respond", "start the service"};
      case DeviceTrouble::device_absent:
        return {"it is not connected", "plug it in and switch it on"};
      case DeviceTrouble::no_permission:
        return {"no permission to open it", "see docs/devices.md, permissions"};
      case DeviceTrouble::in_use:
        return {"another program uses it", "close that program"};
      case DeviceTrouble::init_failed:
        return {"it does not start", "switch it off and on again"};
      case DeviceTrouble::bad_calibration:
        return {"its calibration cannot be used", "calibrate the device again"};
      case DeviceTrouble::docked:
        return {"the stylus rests in its inkwell", "take it out to continue"};
      case DeviceTrouble::safety_switch:
        return {"the safety switch is not held", "hold the stylus so that it presses the switch"};
      case DeviceTrouble::not_calibrated:
        return {"it is not calibrated",
                "move the stylus through all of its space, or calibrate it with the maker's program"};
      case DeviceTrouble::wants_inkwell:
        return {"it is not calibrated", "put the stylus into its inkwell for a moment"};
      case DeviceTrouble::wants_reset_position:
        return {
            "it is not calibrated",
            "hold the arm at its reset position, as the maker's manual shows it, and press a button of the "
            "stylus"};
      case DeviceTrouble::not_at_rest:
        return {"it was not at rest when it was opened, so its angles are wrong",
                "put its handle to rest, then choose it again"};
      case DeviceTrouble::not_homed:
        return {
            "it is not homed, so it brakes and tells no position",
            "home it: press the button of an omega or delta, pull all arms of a Falcon out and push them in"};
      case DeviceTrouble::forces_off:
        return forces_off(code);
      case DeviceTrouble::over_force:
        return {"it paused because the force was too large", "hold the stylus lightly; it resumes by itself"};
      case DeviceTrouble::over_speed:
        return {"it paused because it was moved too fast", "move more slowly; it resumes by itself"};
      case DeviceTrouble::warm_motors:
        return {"its motors are too warm", "put the stylus down for a few minutes; it resumes by itself"};
      case DeviceTrouble::not_ready:
        return {"it is not ready", "switch it on and close other programs"};
      case DeviceTrouble::too_slow:
        return {"it responds too slowly for force feedback", "close other programs and connect it by cable"};
      case DeviceTrouble::communication_lost:
        return {"the connection was lost", "check the cable and the power, then select the device again"};
      case DeviceTrouble::device_fault:
        return {"it reports a fault", "switch it off and on, then select it again"};
      case DeviceTrouble::no_timer:
        return {"its library gets no timer from the system",
                "close other programs, then choose the device again"};
      case DeviceTrouble::stalled:
        return {"it no longer responds", "check the cable and the power, then select the device again"};
      case DeviceTrouble::service_gone:
        return {"its service has stopped", "start the service again; Nazori reconnects by itself"};
      case DeviceTrouble::bad_message:
        return {"it sends data that cannot be read", "update the manufacturer's software"};
    }
    return {"unknown problem", ""};
  }();
  std::string what = s.what;
  if (trouble == DeviceTrouble::forces_off) code = 0;  // the message already says it
  // The makers' codes are written in hexadecimal in their manuals.
  if (code > 0) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string hex;
    for (std::int32_t rest = code; rest > 0; rest /= 16) hex.insert(hex.begin(), kDigits[rest % 16]);
    what += " (code 0x" + hex + ")";
  } else if (code < 0) {
    what += " (code " + std::to_string(code) + ")";
  }
  return {base::Errc::device, what, device, s.remedy};
}

}  // namespace nazori::devices
