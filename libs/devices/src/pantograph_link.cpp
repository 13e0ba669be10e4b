// SPDX-License-Identifier: Apache-2.0
#include "pantograph_link.h"

#include <poll.h>

#include <algorithm>
#include <utility>

namespace nazori::devices::pantograph {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using std::chrono::milliseconds;

constexpr auto kQuiet = milliseconds(3);  // silence after which an answer is complete
constexpr int kMostZeros = 4;             // that are sent until one is confirmed
constexpr int kStaleWrite_ms = 25;        // time within which a pending torque is written

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

Answer read_answer(SerialPort& port, const BoardSetup& setup, Reading& reading, milliseconds wait) noexcept {
  std::array<std::uint8_t, Packet::kMost> bytes{};
  std::size_t size = 0;
  for (const auto end = Clock::now() + wait;;) {
    const auto left = std::chrono::ceil<milliseconds>(end - Clock::now());
    if (left <= milliseconds(0)) return Answer::nothing;
    const int got = port.read(std::span(bytes).subspan(size), left);
    if (got < 0) return Answer::gone;
    size += static_cast<std::size_t>(got);
    switch (read_reply(std::span(bytes).first(size), setup, reading)) {
      case Reply::complete:
        // More than requested: these bytes may belong to an older answer, and so may the first ones.
        return size == reply_size(setup) ? Answer::reading : Answer::garbage;
      case Reply::wrong_id:
      case Reply::implausible:
        return Answer::garbage;
      case Reply::incomplete:
        break;
    }
  }
}

BoardLink::BoardLink(std::shared_ptr<SerialPort> port, const BoardSetup& setup, double give_up_s,
                     ServoLink& feeling, BoardServo& servo)
    : port_(std::move(port)),
      setup_(setup),
      give_up_s_(give_up_s),
      zero_(torque_packet(setup, {0, 0})),
      feeling_(feeling),
      servo_(servo) {}

BoardLink::~BoardLink() { stop(); }

base::Result<void> BoardLink::start() {
  torques_ = {0, 0};
  why_lost_ = DeviceTrouble::none;
  last_good_ = Clock::now();
  delay_s_ = 0;
  publish(DeviceState::paused, DeviceTrouble::not_ready, {});
  return thread_.start({}, [this](const std::stop_token& stop) { run(stop); });
}

void BoardLink::stop() noexcept { thread_.stop(); }

void BoardLink::write_zero_at_end(void* link) noexcept {
  const BoardLink& self = *static_cast<BoardLink*>(link);
  self.port_->write_at_end(self.zero_.bytes());
  // The link's thread may have been about to write a torque when forces were cut; from then on it writes
  // zero.
  (void)::poll(nullptr, 0, kStaleWrite_ms);
  self.port_->write_at_end(self.zero_.bytes());
}

void BoardLink::run(const std::stop_token& stop) noexcept {
  const ForceGuard::OwnCode own = feeling_.own_code();
  while (!stop.stop_requested() && why_lost_ == DeviceTrouble::none) turn();
  rest_at_zero();
  feeling_.confirm_off();  // nothing follows, and no board is left to receive zero
  if (why_lost_ != DeviceTrouble::none) publish(DeviceState::lost, why_lost_, {});
}

bool BoardLink::ask() noexcept {
  // Data in the pipe belong to an older request. Read as the answer to this one, they would delay every pose
  // from now on.
  std::array<std::uint8_t, Packet::kMost> scrap{};
  if (port_->read(scrap, milliseconds(0)) > 0) port_->discard(kQuiet);
  held_ = ForceGuard::forces() != Forces::allowed;
  asked_at_ = Clock::now();
  return port_->write(held_ ? zero_.bytes() : torque_packet(setup_, torques_).bytes());
}

void BoardLink::publish(DeviceState state, DeviceTrouble trouble, const Reading& reading) noexcept {
  BoardPose& pose = servo_.exchange.poses.back();
  pose.number = ++poses_;
  pose.at = Clock::now();
  pose.state = state;
  pose.trouble = trouble;
  pose.angle_deg = reading.angle_deg;
  pose.pressed = reading.pressed;
  pose.delay_s = delay_s_;
  servo_.exchange.poses.publish();
}

PerJoint BoardLink::await_torques() noexcept { return servo_.exchange.await(poses_).torque_n_m; }

void BoardLink::turn() noexcept {
  Reading reading;
  const Answer answer = ask() ? read_answer(*port_, setup_, reading, kAnswerWait) : Answer::gone;
  const auto asked_at = asked_at_;
  if (answer == Answer::reading && held_) feeling_.confirm_no_force();
  if (answer == Answer::gone) {
    why_lost_ = DeviceTrouble::communication_lost;
    return;
  }
  if (answer == Answer::reading) {
    last_good_ = Clock::now();
    publish(DeviceState::running, DeviceTrouble::none, reading);
    torques_ = await_torques();
    delay_s_ = smoothed_delay_s(delay_s_, seconds(Clock::now() - asked_at));
    return;
  }
  const bool silent = answer == Answer::nothing;
  if (seconds(Clock::now() - last_good_) > give_up_s_) {
    why_lost_ = silent ? DeviceTrouble::communication_lost : DeviceTrouble::bad_message;
    return;
  }
  // The servo must notice even a fault of a single cycle: it releases the handle and restarts with a ramp.
  publish(DeviceState::paused, silent ? DeviceTrouble::too_slow : DeviceTrouble::bad_message, {});
  (void)await_torques();
  torques_ = {0, 0};
  port_->discard(kQuiet);
}

void BoardLink::rest_at_zero() noexcept {
  torques_ = {0, 0};
  for (int i = 0; i < kMostZeros; ++i) {
    Reading reading;
    const Answer answer = ask() ? read_answer(*port_, setup_, reading, kAnswerWait) : Answer::gone;
    if (answer == Answer::reading || answer == Answer::gone) return;
    port_->discard(kQuiet);
  }
}

}  // namespace nazori::devices::pantograph
