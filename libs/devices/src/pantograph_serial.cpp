// SPDX-License-Identifier: Apache-2.0
#include "pantograph_serial.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "device_nodes.h"

namespace nazori::devices::pantograph {
namespace {

using haptics::DeviceTrouble;

/// Whether the port became ready within `wait`, or may have been disconnected.
bool ready(int file, short events, std::chrono::milliseconds wait) noexcept {
  pollfd one{file, events, 0};
  int found = 0;
  do {
    found = ::poll(&one, 1, static_cast<int>(wait.count()));
  } while (found < 0 && errno == EINTR);
  return found != 0;
}

bool make_raw(int file) noexcept {
  termios settings{};
  if (tcgetattr(file, &settings) != 0) return false;
  cfmakeraw(&settings);
  settings.c_cflag |= static_cast<tcflag_t>(CLOCAL | CREAD);
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  return cfsetspeed(&settings, B115200) == 0 && tcsetattr(file, TCSANOW, &settings) == 0;
}

tl::unexpected<DeviceProblem> refused(const std::filesystem::path& path, int error) {
  switch (error) {
    case EACCES:
    case EPERM:
      return no_device(DeviceTrouble::no_permission, "the port cannot be opened", path.string(),
                       permission_advice(device_nodes(path.parent_path(), {path.filename().string()}))
                           .value_or("see docs/devices.md, permissions"));
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return no_device(DeviceTrouble::device_absent, "there is no such port", path.string(),
                       "plug the board in");
    case EBUSY:
    case EWOULDBLOCK:
      return no_device(DeviceTrouble::in_use, "another program uses the port", path.string(),
                       "close that program");
    default:
      return no_device(DeviceTrouble::init_failed,
                       "the port cannot be used: " + std::generic_category().message(error), path.string(),
                       "unplug the board and plug it in again");
  }
}

}  // namespace

DeviceResult<std::shared_ptr<SerialPort>> SerialPort::open(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return refused(path, errno);
  std::shared_ptr<SerialPort> port(new SerialPort(file));
  // The lock also keeps out programs of root, unlike TIOCEXCL.
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 || ::ioctl(file, TIOCEXCL) != 0 || !make_raw(file))
    return refused(path, errno);
  (void)::tcflush(file, TCIOFLUSH);
  return port;
}

SerialPort::~SerialPort() {
  (void)::ioctl(file_, TIOCNXCL);
  (void)::close(file_);
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (written < 0 && errno != EAGAIN && errno != EINTR) {
      return false;
    } else if (!ready(file_, POLLOUT, kWriteWait)) {
      return false;
    }
  }
  return true;
}

int SerialPort::read(std::span<std::uint8_t> into, std::chrono::milliseconds wait) noexcept {
  for (bool waited = false;; waited = true) {
    const ssize_t got = ::read(file_, into.data(), into.size());
    if (got > 0) return static_cast<int>(got);
    if (got == 0) return -1;  // the other side hung up
    if (errno != EAGAIN && errno != EINTR) return -1;
    if (waited || !ready(file_, POLLIN, wait)) return 0;
  }
}

void SerialPort::discard(std::chrono::milliseconds quiet) noexcept {
  std::array<std::uint8_t, 256> scrap{};
  for (int all = 0; all < kMostDiscard;) {
    const int got = read(scrap, quiet);
    if (got <= 0) return;
    all += got;
  }
}

void SerialPort::write_at_end(std::span<const std::uint8_t> bytes) const noexcept {
  (void)!::write(file_, bytes.data(), bytes.size());
}

}  // namespace nazori::devices::pantograph
