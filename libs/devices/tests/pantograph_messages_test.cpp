// SPDX-License-Identifier: Apache-2.0
// The bytes are written out by hand, in the order in which the firmware reads and writes them.
#include "pantograph_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "pantograph_model.h"

namespace nazori::devices::pantograph {
namespace {

using Bytes = std::vector<std::uint8_t>;

const BoardSetup& version_3() { return kModels[0].setup; }
const BoardSetup& version_2() { return kModels[1].setup; }
BoardSetup with_button(BoardSetup setup) {
  setup.has_button = true;
  return setup;
}
Bytes bytes_of(const Packet& packet) { return {packet.bytes().begin(), packet.bytes().end()}; }

TEST(PantographMessages, ASetupNamesTheBoardItsPortsAndDirectionsThenTheEncodersByPort) {
  EXPECT_EQ(bytes_of(setup_packet(version_3())), (Bytes{1,    5,                 //
                                                        3,    1,    1,           // motors at ports 1 and 2
                                                        3,    1,    1,           // encoders
                                                        0,    0,                 // no sensors, no PWM
                                                        0x00, 0x00, 0x40, 0x41,  // 12 degrees, at port 1
                                                        0x00, 0x80, 0x98, 0x45,  // 4880 steps
                                                        0x00, 0x00, 0x28, 0x43,  // 168 degrees, at port 2
                                                        0x00, 0x80, 0x98, 0x45}));
  EXPECT_EQ(bytes_of(setup_packet(version_2())),
            (Bytes{1,    5,    3,    0,    1, 3, 0, 1, 0, 0, 0x00, 0x00, 0x74, 0xc2,  // -61
                   0x00, 0x00, 0x28, 0x46,                                            // 10752
                   0x00, 0x00, 0x71, 0x43,                                            // 241
                   0x00, 0x00, 0x28, 0x46}));
}

TEST(PantographMessages, AButtonIsOneAnalogueInputMore) {
  const Bytes packet = bytes_of(setup_packet(with_button(version_3())));
  ASSERT_EQ(packet.size(), 27U);
  EXPECT_EQ((Bytes{packet.begin() + 8, packet.begin() + 11}), (Bytes{1, 56, 0}));  // A0 is 54
}

TEST(PantographMessages, TorquesGoByPortNotByJoint) {
  EXPECT_EQ(bytes_of(torque_packet(version_3(), {0.0625, -0.03125})),
            (Bytes{2, 5, 0x00, 0x00, 0x00, 0xbd, 0x00, 0x00, 0x80, 0x3d}));
}

TEST(PantographMessages, NoTorqueLeavesThatIsNoNumberOrMoreThanTheMotorsTake) {
  const auto written = [](double torque) { return bytes_of(torque_packet(version_3(), {torque, 0})); };
  const Bytes none = bytes_of(torque_packet(version_3(), {0, 0}));
  EXPECT_EQ(none, (Bytes{2, 5, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), none);
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), none);
  EXPECT_EQ(written(1e9), written(kMostTorque_n_m));
  EXPECT_EQ(written(-1), written(-kMostTorque_n_m));
}

TEST(PantographMessages, WhatSettlesABoardIsZerosOnlyAndLongerThanTheRestOfATorque) {
  const Bytes packet = bytes_of(settling_packet());
  EXPECT_GE(packet.size(), 8U);
  for (const std::uint8_t byte : packet) EXPECT_EQ(byte, 0);
}

const Bytes kReply{5, 0x00, 0x00, 0x40, 0x41, 0x00, 0x00, 0x28, 0xc3};  // 12 at port 1, -168 at port 2

TEST(PantographMessages, AReplyGivesTheAnglesToTheirJoints) {
  Reading reading;
  ASSERT_EQ(reply_size(version_3()), kReply.size());
  ASSERT_EQ(read_reply(kReply, version_3(), reading), Reply::complete);
  EXPECT_EQ(reading.angle_deg, (PerJoint{-168, 12}));
  EXPECT_FALSE(reading.pressed);
}

TEST(PantographMessages, TheButtonComesFirstAndIsPressedWhereItsLevelIsLow) {
  Bytes reply = kReply;
  reply.insert(reply.begin() + 1, {0x00, 0x80, 0x79, 0x44});  // 998
  Reading reading;
  ASSERT_EQ(reply_size(with_button(version_3())), reply.size());
  ASSERT_EQ(read_reply(reply, with_button(version_3()), reading), Reply::complete);
  EXPECT_TRUE(reading.pressed);
  EXPECT_EQ(reading.angle_deg, (PerJoint{-168, 12}));
  reply[2] = 0x00;
  reply[3] = 0x7a;  // 1000
  ASSERT_EQ(read_reply(reply, with_button(version_3()), reading), Reply::complete);
  EXPECT_FALSE(reading.pressed);
}

TEST(PantographMessages, EveryPartOfAReplyWaitsForTheRest) {
  Reading reading{{7, 7}, true};
  for (std::size_t size = 0; size < kReply.size(); ++size)
    EXPECT_EQ(read_reply(std::span(kReply).first(size), version_3(), reading), Reply::incomplete);
  EXPECT_EQ(reading.angle_deg, (PerJoint{7, 7})) << "a part of a reply is no reading";
}

TEST(PantographMessages, AReplyOfAnotherDeviceOrWithoutNumbersIsNone) {
  Reading reading{{7, 7}, true};
  Bytes reply = kReply;
  reply[0] = 4;
  EXPECT_EQ(read_reply(reply, version_3(), reading), Reply::wrong_id);
  EXPECT_EQ(read_reply(std::span(reply).first(1), version_3(), reading), Reply::wrong_id);
  reply = {5, 0x00, 0x00, 0xc0, 0x7f, 0, 0, 0, 0};  // not a number
  EXPECT_EQ(read_reply(reply, version_3(), reading), Reply::implausible);
  reply = {5, 0x00, 0x00, 0x80, 0xff, 0, 0, 0, 0};  // minus infinity
  EXPECT_EQ(read_reply(reply, version_3(), reading), Reply::implausible);
  reply = {5, 0, 0, 0, 0, 0x00, 0x40, 0x34, 0x44};  // 721 degrees
  EXPECT_EQ(read_reply(reply, version_3(), reading), Reply::implausible);
  EXPECT_EQ(reading.angle_deg, (PerJoint{7, 7}));
}

}  // namespace
}  // namespace nazori::devices::pantograph
