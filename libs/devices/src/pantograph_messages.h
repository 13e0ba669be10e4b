// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// The protocol on the serial port of a Haply board: bytes without checksum or end mark. The program sends
/// requests and the board answers; it sends nothing by itself.
/// @source the board's firmware, HaplyHaptics/Haply-Arduino-Firmware-Versions, Haply_M0_Firmware_V0_3 and
/// Haply_M3_Firmware_V1_5; which parameters a 2diy needs: README of the package HaplyHAPI 1.0.1 on PyPI.
namespace nazori::devices::pantograph {

/// The id that the program and its ports of the board share. Not 0, which the firmware uses for free ports.
constexpr std::uint8_t kBoardId = 5;

/// Where the firmware cuts off torques.
constexpr double kMostTorque_n_m = 0.123;

/// Directions with the firmware's names.
enum class Turn : std::uint8_t { clockwise = 0, anticlockwise = 1 };

/// A motor with its encoder.
struct Joint {
  std::uint8_t port = 1;  ///< of the board, 1..4; each joint has its own
  Turn motor = Turn::anticlockwise;
  Turn encoder = Turn::anticlockwise;
  float rest_deg = 0;        ///< its angle when the board is set up
  float steps_per_turn = 1;  ///< of the encoder, > 0
};

/// The parameters that a board needs before it can drive a pantograph.
struct BoardSetup {
  std::array<Joint, 2> joints;
  bool has_button = false;  ///< analogue input A2 is read too
};

/// Bytes to be written in one go: the firmware does not wait for the rest of a command.
class Packet {
 public:
  static constexpr std::size_t kMost = 32;
  void add(std::uint8_t byte) noexcept;
  void add(float number) noexcept;  ///< four bytes, the lowest first
  [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept { return {bytes_.data(), size_}; }

 private:
  std::array<std::uint8_t, kMost> bytes_{};
  std::size_t size_ = 0;
};

/// One number for each joint, in the order of BoardSetup::joints.
using PerJoint = std::array<double, 2>;

/// Gives the board its parameters; the joints are at rest_deg from then on. The board does not answer it.
[[nodiscard]] Packet setup_packet(const BoardSetup& setup) noexcept;

/// Sets the torques, and asks for a reply. The board keeps them until it receives others.
/// @param torque_n_m  limited to kMostTorque_n_m; a number that is not finite counts as 0.
[[nodiscard]] Packet torque_packet(const BoardSetup& setup, const PerJoint& torque_n_m) noexcept;

/// Zero bytes. Whatever the firmware is waiting for, it reads them as torques of zero or as commands that
/// free its ports; afterwards it waits for a command.
[[nodiscard]] Packet settling_packet() noexcept;

/// What the board answers.
struct Reading {
  PerJoint angle_deg{0, 0};
  bool pressed = false;  ///< the button, where there is one
};

/// The result of decoding a reply.
enum class Reply : std::uint8_t {
  complete,
  incomplete,   ///< right so far
  wrong_id,     ///< of another device, or not the beginning of a reply
  implausible,  ///< angles that are not numbers, or many turns away
};

/// Number of bytes of the board's answer.
[[nodiscard]] std::size_t reply_size(const BoardSetup& setup) noexcept;

/// Reads a reply that begins with the first of `bytes`; bytes after its end are ignored.
/// @param reading  written only where it is complete.
[[nodiscard]] Reply read_reply(std::span<const std::uint8_t> bytes, const BoardSetup& setup,
                               Reading& reading) noexcept;

}  // namespace nazori::devices::pantograph
