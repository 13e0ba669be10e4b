// SPDX-License-Identifier: Apache-2.0
#include "pantograph_board.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

namespace nazori::devices::standin {
namespace {

using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

constexpr auto kReadWait = std::chrono::seconds(1);  // of Arduino's Stream::readBytes
constexpr int kNobody = -1;                          // Stream::read, without any data

void add(Bytes& bytes, float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
}

float number_at(const Bytes& bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = (bits << 8U) | bytes.at(at + i);
  return std::bit_cast<float>(bits);
}

}  // namespace

struct PantographBoard::Inside {
  explicit Inside(PantographBoard& board) : stage(board) {
    std::array<char, 128> name{};
    if (openpty(&board_side, &port_side, name.data(), nullptr, nullptr) != 0)
      throw std::runtime_error("no pseudo-terminal");
    path = name.data();
    termios raw{};
    tcgetattr(port_side, &raw);
    cfmakeraw(&raw);
    tcsetattr(port_side, TCSANOW, &raw);
    fcntl(board_side, F_SETFL, fcntl(board_side, F_GETFL) | O_NONBLOCK);
  }
  ~Inside() { hang_up(); }

  void hang_up() {
    ends = true;
    if (thread.joinable()) thread.join();
    for (int* file : {&board_side, &port_side}) {
      if (*file >= 0) close(*file);
      *file = -1;
    }
  }

  /// @return whether data came within a millisecond.
  bool listen() {
    pollfd one{board_side, POLLIN, 0};
    if (poll(&one, 1, 1) <= 0) return false;
    std::array<std::uint8_t, 256> some{};
    const ssize_t got = read(board_side, some.data(), some.size());
    if (got <= 0) return false;
    pipe.insert(pipe.end(), some.begin(), some.begin() + got);
    return true;
  }
  int next() {
    if (pipe.empty()) {
      ++stage.incomplete;
      return kNobody;
    }
    const int byte = pipe.front();
    pipe.pop_front();
    return byte;
  }
  Bytes next(std::size_t count) {
    for (const auto end = Clock::now() + kReadWait; pipe.size() < count && Clock::now() < end && !ends;)
      listen();
    if (pipe.size() < count) ++stage.incomplete;
    const auto last = pipe.begin() + static_cast<std::ptrdiff_t>(std::min(count, pipe.size()));
    Bytes bytes(pipe.begin(), last);
    pipe.erase(pipe.begin(), last);
    bytes.resize(count);
    return bytes;
  }

  void work() {
    while (!ends) {
      if (pipe.empty() && !listen()) {
        ++stage.idle;
        continue;
      }
      if (stage.fault.load() == Fault::forgets) {
        free_ports();
        stage.fault = Fault::none;
      }
      switch (next()) {
        case 0:
          (void)next();
          free_ports();
          ++stage.resets;
          break;
        case 1:
          set_up();
          break;
        case 2:
          write_torques();
          break;
        default:
          ++stage.unknown;
      }
    }
  }

  void free_ports() {
    motor_of = encoder_of = {0, 0};
    sensor_of = 0;
  }

  /// A list of the ports in use, and one byte for each of them.
  std::array<int, 2> directions(std::array<bool, 2>& used) {
    const int mask = next();
    std::array<int, 2> list{0, 0};
    int count = 0;
    for (std::size_t port = 0; port < 2; ++port) {
      used.at(port) = ((mask >> port) & 1) != 0;
      count += used.at(port) ? 1 : 0;
    }
    // As in the firmware: the n-th byte is for port n, whichever ports are in use.
    for (int i = 0; i < count; ++i) list.at(static_cast<std::size_t>(i)) = next();
    return list;
  }

  void set_up() {
    free_ports();
    const int id = next();
    std::array<bool, 2> motors{}, encoders{};
    motor_direction = directions(motors);
    encoder_direction = directions(encoders);
    for (int sensors = next(); sensors > 0; --sensors) {
      if (next() == 56) sensor_of = id;
    }
    for (int pwms = next(); pwms > 0; --pwms) (void)next();
    const auto count = static_cast<std::size_t>(std::count(encoders.begin(), encoders.end(), true));
    const Bytes numbers = next(8 * count);
    std::size_t at = 0;
    for (std::size_t port = 0; port < 2; ++port) {
      if (motors.at(port)) motor_of.at(port) = id;
      if (!encoders.at(port)) continue;
      encoder_of.at(port) = id;
      steps_per_turn.at(port) = number_at(numbers, at + 4);
      steps_at_setup.at(port) = std::trunc(number_at(numbers, at) * steps_per_turn.at(port) / 360);
      arm_at_setup.at(port) = stage.arm_deg.at(port) - stage.knocked_deg;
      at += 8;
    }
    ++stage.setups;
  }

  void write_torques() {
    const int id = next();
    std::size_t count = 0;
    for (const int owner : motor_of) count += owner == id ? 1U : 0U;
    const Bytes numbers = next(4 * count);
    std::size_t at = 0;
    bool zero = count > 0;
    for (std::size_t port = 0; port < 2; ++port) {
      if (motor_of.at(port) != id) continue;
      const double torque = number_at(numbers, at);
      at += 4;
      // Version 3 is wired so that a motor set up as anticlockwise turns its arm from x towards y.
      const double turn = motor_direction.at(port) == 1 ? torque : -torque;
      stage.torque_n_m.at(port) = std::clamp(turn, -kMostTorque_n_m, kMostTorque_n_m);
      zero = zero && torque == 0;
    }
    if (zero) ++stage.zeros;
    if (stage.swings) ++(zero == tells_other ? stage.in_time : stage.late);
    tells_other = stage.swings && !tells_other;
    ++stage.questions;
    if (stage.delay_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(stage.delay_ms));
    answer(id);
  }

  Bytes states(int id) {
    Bytes bytes{static_cast<std::uint8_t>(id)};
    if (sensor_of == id) add(bytes, static_cast<float>(stage.a2));
    for (std::size_t port = 0; port < 2; ++port) {
      if (encoder_of.at(port) != id) continue;
      const double arm = tells_other ? stage.other_deg.at(port) : stage.arm_deg.at(port);
      const double way = arm - arm_at_setup.at(port);
      const double turned = encoder_direction.at(port) == 1 ? way : -way;
      const double steps = steps_at_setup.at(port) + std::trunc(turned * steps_per_turn.at(port) / 360);
      add(bytes, static_cast<float>(360 * steps / steps_per_turn.at(port)));
    }
    return bytes;
  }

  void answer(int id) {
    Bytes bytes = states(id);
    switch (stage.fault.load()) {
      case Fault::silent:
        return;
      case Fault::half:
        bytes.resize(bytes.size() / 2);
        break;
      case Fault::wrong_id:
        ++bytes.front();
        break;
      case Fault::no_number:
        bytes.resize(bytes.size() - 4);
        add(bytes, std::numeric_limits<float>::quiet_NaN());
        break;
      case Fault::answers_twice:
        bytes.insert(bytes.begin(), before.begin(), before.end());
        break;
      case Fault::none:
      case Fault::answers_later:
      case Fault::forgets:
        break;
    }
    before = states(id);
    const auto length = static_cast<std::size_t>(std::max(stage.piece.load(), 1));
    for (std::size_t at = 0; at < bytes.size() && !ends; at += length) {
      (void)!write(board_side, bytes.data() + at, std::min(length, bytes.size() - at));
      std::this_thread::yield();
    }
    Fault later = Fault::answers_later;
    if (!stage.fault.compare_exchange_strong(later, Fault::none)) return;
    std::this_thread::sleep_for(std::chrono::microseconds(300));
    (void)!write(board_side, bytes.data(), bytes.size());
  }

  PantographBoard& stage;
  std::string path;
  int board_side = -1, port_side = -1;
  std::deque<std::uint8_t> pipe;
  std::array<int, 2> motor_of{0, 0}, encoder_of{0, 0};  // id of the owner; 0 nobody
  std::array<int, 2> motor_direction{0, 0}, encoder_direction{0, 0};
  std::array<double, 2> steps_per_turn{1, 1}, steps_at_setup{0, 0}, arm_at_setup{0, 0};
  int sensor_of = 0;
  bool tells_other = false;
  Bytes before;
  std::atomic<bool> ends{false};
  std::thread thread;
};

PantographBoard::PantographBoard(bool runs) : inside_(std::make_unique<Inside>(*this)) {
  if (runs) run();
}
PantographBoard::~PantographBoard() = default;
void PantographBoard::run() {
  inside_->thread = std::thread([this] { inside_->work(); });
}
const std::string& PantographBoard::path() const { return inside_->path; }
void PantographBoard::unplug() { inside_->hang_up(); }

}  // namespace nazori::devices::standin
