// SPDX-License-Identifier: Apache-2.0
#include "inverse_standin.h"

#include <poll.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

namespace nazori::devices::standin {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using Json = nlohmann::json;

struct InverseService::Inside {
  explicit Inside(InverseService& service, std::uint16_t port)
      : stage(service), acceptor(io, {asio::ip::make_address("127.0.0.1"), port}) {
    address = acceptor.local_endpoint().port();
    thread = std::thread([this] { serve(); });
  }
  ~Inside() {
    ends = true;
    thread.join();
  }

  /// Whether something can be read before the service ends.
  bool readable(int file) {
    while (!ends && !stage.hang_up) {
      pollfd one{file, POLLIN, 0};
      if (poll(&one, 1, 5) > 0) return true;
    }
    return false;
  }

  void serve() {
    std::vector<std::thread> answering;
    while (!ends) {
      pollfd one{acceptor.native_handle(), POLLIN, 0};
      if (poll(&one, 1, 5) <= 0) continue;
      tcp::socket socket(io);
      error_code failed;
      acceptor.accept(socket, failed);
      if (failed) continue;
      socket.set_option(tcp::no_delay(true), failed);
      answering.emplace_back([this, s = std::move(socket)]() mutable { answer(std::move(s)); });
    }
    for (std::thread& session : answering) session.join();
  }

  void answer(tcp::socket socket) {
    if (!readable(socket.native_handle())) return;
    beast::flat_buffer buffer;
    http::request<http::string_body> request;
    error_code failed;
    http::read(socket, buffer, request, failed);
    if (failed) return;
    if (!websocket::is_upgrade(request)) {
      http::response<http::string_body> response{http::status::ok, 11};
      if (const char* tag = stage.version; tag != nullptr && request.target() == "/version")
        response.body() = Json{{"ok", true}, {"data", {{"git_tag", tag}}}}.dump();
      else
        response.result(http::status::not_found);
      response.prepare_payload();
      http::write(socket, response, failed);
      return;
    }
    websocket::stream<tcp::socket> stream(std::move(socket));
    stream.accept(request, failed);
    if (failed) return;
    const int number = ++stage.sessions;
    stream.text(true);
    bool centred = false;
    const bool is_garbled = stage.garbles_inventory;
    int heard = 0;
    say(stream, is_garbled ? "{\"inverse3\": [}}\x01" : state(number, true, centred));
    for (bool first = true; readable(stream.next_layer().native_handle()); first = false) {
      beast::flat_buffer message;
      stream.read(message, failed);
      if (failed) break;
      take(beast::buffers_to_string(message.data()), first, centred);
      ++stage.messages;
      if (is_garbled) stage.most_after_garbled = std::max(stage.most_after_garbled.load(), ++heard);
      if (stage.delay_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(stage.delay_ms));
      switch (stage.answer) {
        case Answer::state:
          for (int i = stage.states_for_a_message; i > 0; --i) say(stream, state(number, false, centred));
          break;
        case Answer::garbage:
          say(stream, "{\"inverse3\": [}}\x01");
          break;
        case Answer::wrong_types:
          say(stream, R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":"up"}}]})");
          break;
        case Answer::huge:
          say(stream, "\"" + std::string(3 << 20, 'x') + "\"");
          break;
        case Answer::nothing:
          break;
      }
    }
    stage.hang_up = false;
    // Commands end with the session.
    push(0, 0, 0);
  }

  void say(websocket::stream<tcp::socket>& stream, const std::string& text) {
    error_code ignored;
    stream.write(asio::buffer(text), ignored);
  }
  void push(double x, double y, double z) {
    stage.force_x_n = x;
    stage.force_y_n = y;
    stage.force_z_n = z;
  }

  std::string state(int session, bool inventory, bool centred) {
    const auto vector = [](double x, double y, double z) { return Json{{"x", x}, {"y", y}, {"z", z}}; };
    Json json{{"session_id", session}, {"inverse3", Json::array()}};
    if (stage.plugged) {
      const double side = stage.left_handed ? -1 : 1;
      const double from_base = centred ? 0 : 1;
      Json now{{"cursor_position",
                vector(stage.x_m + from_base * side * kCentre_m[0], stage.y_m + from_base * kCentre_m[1],
                       stage.z_m + from_base * kCentre_m[2])},
               {"cursor_velocity", vector(0, 0, 0)},
               {"control_mode", "force"}};
      if (stage.reports_force)
        now["current_cursor_force"] = stage.reports_no_other_than_zero
                                          ? vector(0, 0, 0)
                                          : vector(stage.force_x_n, stage.force_y_n, stage.force_z_n);
      Json arm{{"device_id", "049D"},
               {"state", now},
               {"status", {{"calibrated", stage.calibrated.load()}, {"ready", stage.ready.load()}}}};
      if (inventory) {
        arm["config"] = {{"handedness", stage.left_handed ? "left" : "right"}, {"type", stage.type.load()}};
        if (stage.knows_presets) arm["config"]["preset"] = "defaults";
      }
      json["inverse3"].push_back(arm);
    }
    json["wireless_verse_grip"] = Json::array(
        {{{"device_id", "G1"},
          {"state", {{"buttons", {{"a", stage.button_a.load()}, {"b", stage.button_b.load()}}}}}}});
    return json.dump();
  }

  /// Obeys a message, or counts it where the documentation does not allow it.
  void take(const std::string& text, bool first, bool& centred) {
    const Json json = Json::parse(text, nullptr, false);
    const bool good = json.is_object() && json.contains("inverse3") && json["inverse3"].is_array() &&
                      json["inverse3"].size() == 1 && json["inverse3"][0].value("device_id", "") == "049D" &&
                      json["inverse3"][0].contains("commands") && json.contains("session") == first &&
                      json["inverse3"][0].contains("configure") == first;
    const Json command = good ? json["inverse3"][0]["commands"].value("set_cursor_force", Json()) : Json();
    const char* const key = stage.takes_vector ? "vector" : "values";
    const char* const other = stage.takes_vector ? "values" : "vector";
    const bool has_preset = good && first && json["inverse3"][0]["configure"].contains("preset");
    if (has_preset && stage.knows_presets) centred = true;
    if (has_preset && !stage.knows_presets) ++stage.malformed;
    if (!good || !command.is_object() || !(command.contains(key) || command.contains(other))) {
      ++stage.malformed;
      return;
    }
    const int spelling = command.contains("vector") ? 1 : 2;
    const int before = last_spelling.exchange(spelling);
    if (before != 0 && before != spelling) ++stage.spelling_changes;
    if (!command.contains(key)) return push(0, 0, 0);  // silently ignored
    push(command[key].value("x", 0.0), command[key].value("y", 0.0), command[key].value("z", 0.0));
    stage.last_command_n = std::hypot(stage.force_x_n, stage.force_y_n, stage.force_z_n);
  }

  InverseService& stage;
  asio::io_context io;
  tcp::acceptor acceptor;
  std::uint16_t address = 0;
  std::atomic<bool> ends{false};
  std::atomic<int> last_spelling{0};
  std::thread thread;
};

InverseService::InverseService(std::uint16_t port) : inside_(std::make_unique<Inside>(*this, port)) {}
InverseService::~InverseService() = default;
std::uint16_t InverseService::port() const { return inside_->address; }

}  // namespace nazori::devices::standin
