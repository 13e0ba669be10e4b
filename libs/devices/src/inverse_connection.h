// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::devices::inverse {

/// The result of waiting for a message.
enum class Received : std::uint8_t { message, nothing_yet, too_large, closed };

/// A WebSocket to the service, used by one thread at a time. No call waits longer than its argument says.
class Connection {
 public:
  /// Longer messages are refused and end the connection.
  static constexpr std::size_t kMostBytes = 1 << 20;

  /// @param stop  gives up within some 20 ms when it is requested.
  [[nodiscard]] static base::Result<std::unique_ptr<Connection>> open(const std::string& host,
                                                                      std::uint16_t port,
                                                                      std::chrono::milliseconds wait,
                                                                      const std::stop_token& stop = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// @return false where the connection is gone.
  [[nodiscard]] bool send(std::string_view message, std::chrono::milliseconds wait);
  /// @param message  its memory is reused from call to call.
  [[nodiscard]] Received receive(std::string& message, std::chrono::milliseconds wait);
  /// Waits for a message, then skips older ones: `message` is the newest.
  [[nodiscard]] Received receive_newest(std::string& message, std::chrono::milliseconds wait);

 private:
  Connection();
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// The body of an HTTP GET; nothing where there is no valid answer in time.
[[nodiscard]] std::optional<std::string> http_get(const std::string& host, std::uint16_t port,
                                                  const std::string& path, std::chrono::milliseconds wait);

}  // namespace nazori::devices::inverse
