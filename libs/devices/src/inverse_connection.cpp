// SPDX-License-Identifier: Apache-2.0
#include "inverse_connection.h"

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace nazori::devices::inverse {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using std::chrono::milliseconds;

namespace {

using Clock = std::chrono::steady_clock;

/// Runs the started operation until `done`. @return false where `end` or a request to stop came first.
bool run_until(asio::io_context& io, const bool& done, Clock::time_point end,
               const std::stop_token& stop = {}) {
  constexpr auto kLook = milliseconds(20);
  // Handles what is ready even if there is no time to wait.
  if (io.stopped()) io.restart();
  while (!done && io.poll_one() > 0) {
  }
  while (!done) {
    if (io.stopped()) io.restart();
    const auto next = stop.stop_possible() ? std::min(end, Clock::now() + kLook) : end;
    if (io.run_one_until(next) == 0 && (Clock::now() >= end || stop.stop_requested())) return done;
  }
  return true;
}

error_code connect(asio::io_context& io, beast::tcp_stream& stream, const std::string& host,
                   std::uint16_t port, Clock::time_point end, const std::stop_token& stop = {}) {
  error_code result;
  // Addresses only, because looking up a name cannot be interrupted.
  const auto address = asio::ip::make_address(host == "localhost" ? "127.0.0.1" : host, result);
  if (result) return result;
  bool done = false;
  stream.async_connect({address, port}, [&](error_code e) {
    result = e;
    done = true;
  });
  if (!run_until(io, done, end, stop)) {
    stream.close();
    run_until(io, done, Clock::now() + milliseconds(100));
    return asio::error::timed_out;
  }
  if (!result) {
    error_code ignored;
    stream.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
  }
  return result;
}

}  // namespace

struct Connection::Inside {
  asio::io_context io{1};
  websocket::stream<beast::tcp_stream> socket{io};
  beast::flat_buffer buffer;
  bool reading = false, read_done = false, gone = false;
  error_code read_error;
};

Connection::Connection() : inside_(std::make_unique<Inside>()) {}

Connection::~Connection() {
  Inside& in = *inside_;
  beast::get_lowest_layer(in.socket).close();
  if (in.reading && !in.read_done) run_until(in.io, in.read_done, Clock::now() + milliseconds(100));
}

base::Result<std::unique_ptr<Connection>> Connection::open(const std::string& host, std::uint16_t port,
                                                           milliseconds wait, const std::stop_token& stop) {
  const auto end = Clock::now() + wait;
  std::unique_ptr<Connection> made(new Connection());
  Inside& in = *made->inside_;
  const std::string where = host + ":" + std::to_string(port);
  error_code failed = connect(in.io, beast::get_lowest_layer(in.socket), host, port, end, stop);
  if (failed) return base::fail(base::Errc::device, failed.message(), where);
  in.socket.read_message_max(kMostBytes);
  bool done = false;
  in.socket.async_handshake(where, "/", [&](error_code e) {
    failed = e;
    done = true;
  });
  if (!run_until(in.io, done, end, stop)) {
    beast::get_lowest_layer(in.socket).close();
    run_until(in.io, done, Clock::now() + milliseconds(100));
    return base::fail(base::Errc::device, "the handshake timed out", where);
  }
  if (failed) return base::fail(base::Errc::device, failed.message(), where);
  in.socket.text(true);
  return made;
}

bool Connection::send(std::string_view message, milliseconds wait) {
  Inside& in = *inside_;
  if (in.gone) return false;
  bool done = false;
  error_code failed;
  in.socket.async_write(asio::buffer(message.data(), message.size()), [&](error_code e, std::size_t) {
    failed = e;
    done = true;
  });
  if (!run_until(in.io, done, Clock::now() + wait)) {
    in.gone = true;
    beast::get_lowest_layer(in.socket).close();
    while (!done) run_until(in.io, done, Clock::now() + milliseconds(100));  // it refers to local variables
    return false;
  }
  if (failed) in.gone = true;
  return !failed;
}

Received Connection::receive(std::string& message, milliseconds wait) {
  Inside& in = *inside_;
  if (in.gone) return Received::closed;
  if (!in.reading) {
    in.reading = true;
    in.read_done = false;
    in.socket.async_read(in.buffer, [&in](error_code e, std::size_t) {
      in.read_error = e;
      in.read_done = true;
    });
  }
  if (!run_until(in.io, in.read_done, Clock::now() + wait)) return Received::nothing_yet;
  in.reading = false;
  if (in.read_error) {
    in.gone = true;
    return in.read_error == websocket::error::message_too_big ||
                   in.read_error == websocket::error::buffer_overflow
               ? Received::too_large
               : Received::closed;
  }
  const auto bytes = in.buffer.cdata();  // one piece, because it is a flat buffer
  message.assign(static_cast<const char*>(bytes.data()), bytes.size());
  in.buffer.consume(in.buffer.size());
  return Received::message;
}

Received Connection::receive_newest(std::string& message, milliseconds wait) {
  constexpr int kMost = 64;
  Received received = receive(message, wait);
  for (int i = 0; i < kMost && received == Received::message; ++i) {
    received = receive(message, milliseconds(0));
    if (received == Received::nothing_yet) return Received::message;
  }
  return received;
}

std::optional<std::string> http_get(const std::string& host, std::uint16_t port, const std::string& path,
                                    milliseconds wait) {
  const auto end = Clock::now() + wait;
  asio::io_context io{1};
  beast::tcp_stream stream(io);
  if (connect(io, stream, host, port, end)) return std::nullopt;
  http::request<http::empty_body> request{http::verb::get, path, 11};
  request.set(http::field::host, host);
  http::response_parser<http::string_body> parser;
  parser.body_limit(Connection::kMostBytes);
  beast::flat_buffer buffer;
  bool done = false;
  error_code failed;
  http::async_write(stream, request, [&](error_code e, std::size_t) {
    if (e) {
      failed = e;
      done = true;
      return;
    }
    http::async_read(stream, buffer, parser, [&](error_code r, std::size_t) {
      failed = r;
      done = true;
    });
  });
  if (!run_until(io, done, end)) {
    stream.close();
    while (!done) run_until(io, done, Clock::now() + milliseconds(100));
    return std::nullopt;
  }
  if (failed || parser.get().result() != http::status::ok) return std::nullopt;
  return parser.get().body();
}

}  // namespace nazori::devices::inverse
