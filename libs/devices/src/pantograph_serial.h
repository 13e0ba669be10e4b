// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "nazori/devices/back_end.h"

namespace nazori::devices::pantograph {

/// A serial port that is locked for this program. Only open() allocates. One thread at a time uses it, except
/// write_at_end().
class SerialPort {
 public:
  /// Raw bytes, no flow control. The speed has no effect over USB; it must not be 1200, which sends boards of
  /// this kind into their boot loader. @source Arduino's SAM and SAMD cores, CDC.cpp.
  [[nodiscard]] static DeviceResult<std::shared_ptr<SerialPort>> open(const std::filesystem::path& path);
  ~SerialPort();
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// Writes all of `bytes`, at once if the port accepts them. @return false if the port is gone or accepts
  /// nothing for kWriteWait.
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes) noexcept;
  static constexpr std::chrono::milliseconds kWriteWait{50};

  /// Reads the available bytes; if there are none, waits. @return number of bytes, 0 after `wait`; -1: the
  /// port is gone.
  [[nodiscard]] int read(std::span<std::uint8_t> into, std::chrono::milliseconds wait) noexcept;

  /// Discards input until there has been none for `quiet`, at most kMostDiscard bytes.
  void discard(std::chrono::milliseconds quiet) noexcept;
  static constexpr int kMostDiscard = 65'536;

  /// Writes as much as possible without waiting. Safe in signal handlers; any thread.
  void write_at_end(std::span<const std::uint8_t> bytes) const noexcept;

 private:
  explicit SerialPort(int file) : file_(file) {}
  const int file_;
};

}  // namespace nazori::devices::pantograph
