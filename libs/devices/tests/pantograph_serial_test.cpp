// SPDX-License-Identifier: Apache-2.0
// The serial port alone, over a pseudo-terminal: the test is what is plugged in.
#include "pantograph_serial.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace nazori::devices::pantograph {
namespace {

using haptics::DeviceTrouble;
using std::chrono::milliseconds;
using Bytes = std::vector<std::uint8_t>;

constexpr milliseconds kLong{60'000};  // for what is there
constexpr milliseconds kShort{1};      // for what is not

class Serial : public testing::Test {
 protected:
  Serial() {
    std::array<char, 128> name{};
    EXPECT_EQ(openpty(&board_, &side_, name.data(), nullptr, nullptr), 0);
    path_ = name.data();
    fcntl(board_, F_SETFL, fcntl(board_, F_GETFL) | O_NONBLOCK);
  }
  ~Serial() override { hang_up(); }
  void hang_up() {
    if (board_ >= 0) close(board_);
    if (side_ >= 0) close(side_);
    board_ = side_ = -1;
  }
  [[nodiscard]] std::shared_ptr<SerialPort> opened() const {
    auto port = SerialPort::open(path_);
    EXPECT_TRUE(port) << base::to_line(port.error().error);
    return *port;
  }
  void board_sends(const Bytes& bytes) const {
    EXPECT_EQ(::write(board_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  /// Waits until something is there to be read: the system passes it on in a thread of its own.
  static void await(int file) {
    pollfd one{file, POLLIN, 0};
    EXPECT_EQ(::poll(&one, 1, static_cast<int>(kLong.count())), 1);
  }
  /// What arrives at the board, so many bytes.
  [[nodiscard]] Bytes at_board(std::size_t count) const {
    Bytes bytes(count);
    for (std::size_t size = 0; size < count;) {
      await(board_);
      const ssize_t got = ::read(board_, bytes.data() + size, count - size);
      if (got <= 0) return {};
      size += static_cast<std::size_t>(got);
    }
    return bytes;
  }

  int board_ = -1, side_ = -1;
  std::string path_;
};

TEST_F(Serial, PassesEveryByteAsItIsBothWays) {
  const auto port = opened();
  Bytes all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  EXPECT_TRUE(port->write(all));
  EXPECT_EQ(at_board(all.size()), all);
  board_sends(all);
  Bytes read(all.size());
  for (std::size_t size = 0; size < read.size();) {
    const int got = port->read(std::span(read).subspan(size), kLong);
    ASSERT_GT(got, 0);
    size += static_cast<std::size_t>(got);
  }
  EXPECT_EQ(read, all);
  EXPECT_TRUE(port->write(Bytes{7}));
  EXPECT_EQ(at_board(1), Bytes{7}) << "no echo of what the board sent";
}

TEST_F(Serial, IsRawWithoutFlowControlAtTheSpeedThatLeavesTheBoardRunning) {
  termios odd{};
  ASSERT_EQ(tcgetattr(side_, &odd), 0);
  odd.c_cflag |= CSTOPB | CRTSCTS;
  odd.c_cflag &= ~static_cast<tcflag_t>(CLOCAL);
  odd.c_cc[VMIN] = 7;
  odd.c_cc[VTIME] = 3;
  cfsetspeed(&odd, B1200);
  ASSERT_EQ(tcsetattr(side_, TCSANOW, &odd), 0);
  const auto port = opened();
  termios now{};
  ASSERT_EQ(tcgetattr(side_, &now), 0);
  EXPECT_EQ(now.c_lflag & (ICANON | ECHO | ISIG), 0U);
  EXPECT_EQ(now.c_cflag & (CSTOPB | CRTSCTS), 0U);
  EXPECT_EQ(now.c_cflag & (CLOCAL | CREAD), CLOCAL | CREAD);
  EXPECT_EQ(now.c_cc[VMIN], 1);
  EXPECT_EQ(now.c_cc[VTIME], 0);
  EXPECT_EQ(cfgetospeed(&now), B115200) << "1200 would send it into its boot loader";
}

TEST_F(Serial, BelongsToOneAtATime) {
  auto port = opened();
  const auto second = SerialPort::open(path_);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().trouble, DeviceTrouble::in_use);
  EXPECT_NE(base::to_line(second.error().error).find("another program uses the port"), std::string::npos);
  port.reset();
  const int other = ::open(path_.c_str(), O_RDWR | O_NOCTTY);
  EXPECT_GE(other, 0) << "it is free again, for others too";
  close(other);
  EXPECT_TRUE(SerialPort::open(path_));
}

TEST_F(Serial, WhatIsNoPortIsSaidInOneLine) {
  const auto missing = SerialPort::open("/nowhere/ttyACM7");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().trouble, DeviceTrouble::device_absent);
  EXPECT_EQ(base::to_line(missing.error().error),
            "/nowhere/ttyACM7: there is no such port (plug the board in)");
  const auto null = SerialPort::open("/dev/null");
  ASSERT_FALSE(null);
  EXPECT_EQ(null.error().trouble, DeviceTrouble::init_failed);
  EXPECT_NE(base::to_line(null.error().error).find("unplug the board"), std::string::npos);
}

TEST_F(Serial, APortThatMayNotBeOpenedSaysHowToBeAllowed) {
  std::filesystem::permissions(path_, std::filesystem::perms::none);
  // Root may open everything, so the check runs as the user nobody.
  const auto ask_as_nobody = [&] {
    if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(99);
    const auto port = SerialPort::open(path_);
    std::_Exit(!port && port.error().trouble == DeviceTrouble::no_permission &&
                       port.error().error.remedy.find("no permission to open " + path_) == 0
                   ? 0
                   : 1);
  };
  EXPECT_EXIT(ask_as_nobody(), testing::ExitedWithCode(0), "");
}

TEST_F(Serial, WhatWasSentBeforeItWasOpenedIsForgotten) {
  termios raw{};
  tcgetattr(side_, &raw);
  cfmakeraw(&raw);
  tcsetattr(side_, TCSANOW, &raw);
  board_sends({1, 2, 3});
  await(side_);
  const auto port = opened();
  Bytes read(8);
  EXPECT_EQ(port->read(read, kShort), 0);
  board_sends({4});
  EXPECT_EQ(port->read(read, kLong), 1);
  EXPECT_EQ(read[0], 4);
}

TEST_F(Serial, ABoardThatTakesNothingMoreEndsTheWriting) {
  const auto port = opened();
  const Bytes many(1 << 20);
  EXPECT_FALSE(port->write(many)) << "nobody reads";
}

TEST_F(Serial, APortThatIsGoneNeitherReadsNorWrites) {
  const auto port = opened();
  hang_up();
  Bytes some(8);
  EXPECT_EQ(port->read(some, kLong), -1);
  EXPECT_FALSE(port->write(some));
  port->discard(kShort);
  port->write_at_end(some);
}

TEST_F(Serial, DiscardsUntilItIsQuiet) {
  const auto port = opened();
  board_sends(Bytes(900, 7));
  await(side_);
  port->discard(milliseconds(20));
  Bytes some(8);
  EXPECT_EQ(port->read(some, kShort), 0);
}

TEST_F(Serial, AtTheEndItWritesWithoutWaiting) {
  const auto port = opened();
  port->write_at_end(Bytes{2, 5, 0});
  EXPECT_EQ(at_board(3), (Bytes{2, 5, 0}));
}

}  // namespace
}  // namespace nazori::devices::pantograph
