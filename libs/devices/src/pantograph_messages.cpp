// SPDX-License-Identifier: Apache-2.0
#include "pantograph_messages.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace nazori::devices::pantograph {
namespace {

enum class Command : std::uint8_t { set_up = 1, write_torques = 2 };

constexpr std::uint8_t kAnalogue2 = 56;    // the firmware counts A0 as 54
constexpr double kPressedBelow = 1000;     // level of A2; a pressed button pulls it to ground
constexpr double kMostAngle_deg = 720;     // no arm of a pantograph turns that far
constexpr std::size_t kNumber = 4;         // bytes
constexpr std::size_t kSettlingSize = 16;  // longer than the rest of any command

/// The joints in the order of the board's ports, which is that of all lists in packets.
std::array<std::size_t, 2> by_port(const BoardSetup& setup) noexcept {
  if (setup.joints[0].port < setup.joints[1].port) return {0, 1};
  return {1, 0};
}

/// Bit n is port n + 1.
std::uint8_t ports(const BoardSetup& setup) noexcept {
  unsigned mask = 0;
  for (const Joint& joint : setup.joints) mask |= 1U << (joint.port - 1U);
  return static_cast<std::uint8_t>(mask);
}

float number_at(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t bits = 0;
  for (std::size_t i = kNumber; i-- > 0;) bits = (bits << 8U) | bytes[i];
  return std::bit_cast<float>(bits);
}

}  // namespace

void Packet::add(std::uint8_t byte) noexcept {
  if (size_ < kMost) bytes_[size_++] = byte;
}

void Packet::add(float number) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (unsigned shift = 0; shift < 32; shift += 8) add(static_cast<std::uint8_t>(bits >> shift));
}

Packet setup_packet(const BoardSetup& setup) noexcept {
  const auto order = by_port(setup);
  Packet packet;
  packet.add(static_cast<std::uint8_t>(Command::set_up));
  packet.add(kBoardId);
  packet.add(ports(setup));
  for (const std::size_t i : order) packet.add(static_cast<std::uint8_t>(setup.joints[i].motor));
  packet.add(ports(setup));
  for (const std::size_t i : order) packet.add(static_cast<std::uint8_t>(setup.joints[i].encoder));
  packet.add(static_cast<std::uint8_t>(setup.has_button ? 1 : 0));  // how many analogue inputs, and which
  if (setup.has_button) packet.add(kAnalogue2);
  packet.add(std::uint8_t{0});  // how many PWM outputs
  for (const std::size_t i : order) {
    packet.add(setup.joints[i].rest_deg);
    packet.add(setup.joints[i].steps_per_turn);
  }
  return packet;
}

Packet torque_packet(const BoardSetup& setup, const PerJoint& torque_n_m) noexcept {
  Packet packet;
  packet.add(static_cast<std::uint8_t>(Command::write_torques));
  packet.add(kBoardId);
  for (const std::size_t i : by_port(setup)) {
    const double torque = std::isfinite(torque_n_m[i]) ? torque_n_m[i] : 0;
    packet.add(static_cast<float>(std::clamp(torque, -kMostTorque_n_m, kMostTorque_n_m)));
  }
  return packet;
}

Packet settling_packet() noexcept {
  Packet packet;
  for (std::size_t i = 0; i < kSettlingSize; ++i) packet.add(std::uint8_t{0});
  return packet;
}

std::size_t reply_size(const BoardSetup& setup) noexcept {
  return 1 + (setup.has_button ? kNumber : 0) + kNumber * setup.joints.size();
}

Reply read_reply(std::span<const std::uint8_t> bytes, const BoardSetup& setup, Reading& reading) noexcept {
  if (bytes.empty()) return Reply::incomplete;
  if (bytes[0] != kBoardId) return Reply::wrong_id;
  if (bytes.size() < reply_size(setup)) return Reply::incomplete;
  bytes = bytes.subspan(1);
  Reading read;
  if (setup.has_button) {
    const double level = number_at(bytes);
    if (!std::isfinite(level)) return Reply::implausible;
    read.pressed = level < kPressedBelow;
    bytes = bytes.subspan(kNumber);
  }
  for (const std::size_t i : by_port(setup)) {
    const double angle = number_at(bytes);
    if (!(std::abs(angle) <= kMostAngle_deg)) return Reply::implausible;
    read.angle_deg[i] = angle;
    bytes = bytes.subspan(kNumber);
  }
  reading = read;
  return Reply::complete;
}

}  // namespace nazori::devices::pantograph
