// SPDX-License-Identifier: Apache-2.0
#include "inverse_link.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>
#include <utility>

#include "force_guard.h"

namespace nazori::devices::inverse {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;
using std::chrono::milliseconds;

constexpr auto kAnswerWait = milliseconds(20);
constexpr auto kFirstRetry = milliseconds(500);
constexpr auto kLongestRetry = milliseconds(10'000);
constexpr auto kLook = milliseconds(5);  // between attempts to connect
constexpr double kKeyDoubt_s = 0.2;      // of force commanded and none reported
constexpr double kKeyDoubt_n = 0.05;
constexpr int kMostBadMessages = 20;  // in a row

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

ArmLink::ArmLink(InverseServiceSettings settings, ArmAddress arm, ArmServo& servo)
    : settings_(std::move(settings)),
      arm_(std::move(arm)),
      servo_(servo),
      tick_message_(arm_.device_id, arm_.dialect.key) {}

ArmLink::~ArmLink() { stop(); }

base::Result<void> ArmLink::start() {
  connection_.reset();
  lost_ = key_changed_ = false;
  trouble_ = DeviceTrouble::service_gone;
  retry_ = kFirstRetry;
  next_try_ = last_good_ = Clock::now();
  delay_s_ = 0;
  publish(DeviceTrouble::not_ready, nullptr);
  return thread_.start(arm_.device_id, [this](const std::stop_token& stop) { run(stop); });
}

void ArmLink::stop() noexcept { thread_.stop(); }

void ArmLink::run(const std::stop_token& stop) noexcept {
  try {
    talk(stop);
    if (connection_) (void)connection_->send(tick_message_.write(Vec3(0)), kSendWait);
  } catch (const std::exception&) {
    // Out of memory, or an exception of the network library: the session ends, and with it the force.
    lost_ = true;
    publish(DeviceTrouble::device_fault, nullptr);
  }
  connection_.reset();
}

void ArmLink::talk(const std::stop_token& stop) {
  while (!stop.stop_requested() && !lost_) {
    if (connection_) {
      turn();
    } else if (Clock::now() >= next_try_) {
      connect(stop);
    } else {
      publish(trouble_, nullptr);
      std::this_thread::sleep_for(kLook);
    }
  }
}

void ArmLink::publish(DeviceTrouble trouble, const ArmState* arm) {
  const auto now = Clock::now();
  const bool goes_on_alone = trouble == DeviceTrouble::not_calibrated || trouble == DeviceTrouble::not_ready;
  if (trouble == DeviceTrouble::none) {
    last_good_ = now;
    retry_ = kFirstRetry;
  } else if (!goes_on_alone && seconds(now - last_good_) > settings_.give_up_s) {
    lost_ = true;
  }
  ArmPose& pose = servo_.exchange.poses.back();
  pose = {};
  pose.number = ++poses_;
  pose.at = now;
  pose.trouble = trouble_ = trouble;
  pose.state = lost_                            ? DeviceState::lost
               : trouble == DeviceTrouble::none ? DeviceState::running
                                                : DeviceState::paused;
  pose.delay_s = delay_s_;
  if (connection_) pose.buttons = state_.buttons;
  if (arm != nullptr && arm->position_m) pose.position_m = to_device_frame(*arm->position_m - arm_.centre_m);
  servo_.exchange.poses.publish();
}

void ArmLink::disconnect(DeviceTrouble why) {
  connection_.reset();
  commanded_n_ = Vec3(0);
  next_try_ = Clock::now() + retry_;
  retry_ = std::min<Clock::duration>(2 * retry_, kLongestRetry);
  publish(why, nullptr);
}

void ArmLink::connect(const std::stop_token& stop) {
  auto opened = Connection::open(settings_.host, settings_.port, kConnectWait, stop);
  if (!opened) return disconnect(DeviceTrouble::service_gone);
  connection_ = std::move(*opened);
  heard_at_ = asked_at_ = Clock::now();
  bad_messages_ = 0;
  state_.buttons = 0;
  session_begun_ = false;
  doubted_since_ = {};
  // The service sends the inventory without a request; it is read as the first answer of the loop.
}

void ArmLink::send(const Vec3& service_n) {
  // The service may send more than one state for a command. One of an older command would count as the answer
  // to this one, and the position would be out of date.
  (void)connection_->receive_newest(message_, milliseconds(0));
  commanded_n_ = service_n;
  asked_at_ = Clock::now();
  if (!connection_->send(tick_message_.write(service_n), kSendWait)) disconnect(DeviceTrouble::service_gone);
}

bool ArmLink::obeys(const ArmState& arm) {
  const bool pushes = !arm.force_n || glm::length(*arm.force_n) > 0;
  if (pushes || key_changed_ || glm::length(commanded_n_) < kKeyDoubt_n) {
    doubted_since_ = {};
    return true;
  }
  const auto now = Clock::now();
  if (doubted_since_ == Clock::time_point{}) doubted_since_ = now;
  if (seconds(now - doubted_since_) < kKeyDoubt_s) return true;
  key_changed_ = true;
  arm_.dialect.key = arm_.dialect.key == ForceKey::vector ? ForceKey::values : ForceKey::vector;
  tick_message_ = TickMessage(arm_.device_id, arm_.dialect.key);
  return false;
}

DeviceTrouble ArmLink::read() {
  const ArmState* const arm = state_.find(arm_.device_id);
  DeviceTrouble trouble = DeviceTrouble::none;
  if (arm == nullptr)
    trouble = DeviceTrouble::communication_lost;
  else if (arm->calibrated == false)
    trouble = DeviceTrouble::not_calibrated;
  else if (arm->ready == false)
    trouble = DeviceTrouble::not_ready;  // NOLINT(bugprone-branch-clone): the order of the checks matters
  else if (!arm->position_m)
    trouble = DeviceTrouble::bad_message;
  else if (delay_s_ > kTooSlow_s)
    trouble = DeviceTrouble::too_slow;
  else if (!obeys(*arm))
    trouble = DeviceTrouble::not_ready;  // the servo releases the stylus and restarts with a ramp
  publish(trouble, arm);
  return trouble;
}

Vec3 ArmLink::await_force() { return to_service_frame(servo_.exchange.await(poses_).force_n); }

void ArmLink::turn() {
  switch (connection_->receive_newest(message_, kAnswerWait)) {
    case Received::closed:
      return disconnect(DeviceTrouble::service_gone);
    case Received::too_large:
      return disconnect(DeviceTrouble::bad_message);
    case Received::nothing_yet:
      if (Clock::now() - heard_at_ > kSilence) return disconnect(DeviceTrouble::too_slow);
      // Commands last one tick: the arm has no force by now.
      publish(DeviceTrouble::too_slow, nullptr);
      (void)await_force();
      return;
    case Received::message:
      break;
  }
  const auto asked_at = asked_at_;
  heard_at_ = Clock::now();
  if (!read_state(message_, state_)) {
    state_.buttons = 0;
    if (++bad_messages_ > kMostBadMessages) return disconnect(DeviceTrouble::bad_message);
    publish(DeviceTrouble::bad_message, nullptr);
    (void)await_force();
    return send(Vec3(0));  // no message, no next state
  }
  bad_messages_ = 0;
  if (!session_begun_) {
    session_begun_ = true;
    asked_at_ = Clock::now();
    if (!connection_->send(first_message(arm_.device_id, arm_.dialect, settings_.force_gate_gain), kSendWait))
      disconnect(DeviceTrouble::service_gone);
    return;
  }
  // The servo must notice even a fault of a single cycle: it releases the stylus and restarts with a ramp.
  const DeviceTrouble trouble = read();
  const Vec3 answer_n = await_force();
  const bool allowed = ForceGuard::forces() == Forces::allowed;
  const Vec3 force_n = allowed && trouble == DeviceTrouble::none ? answer_n : Vec3(0);
  delay_s_ = smoothed_delay_s(delay_s_, seconds(Clock::now() - asked_at));
  send(force_n);
  if (!allowed && connection_) servo_.confirm_no_force();
}

}  // namespace nazori::devices::inverse
