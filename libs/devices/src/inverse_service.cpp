// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/inverse_service.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "inverse_connection.h"
#include "inverse_messages.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "servo_link.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;
using inverse::Connection;
using inverse::ForceKey;
using inverse::Received;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr const char* kName = "Inverse Service";
constexpr double kPeriod_s = 0.001;
constexpr double kReach_m = 0.10;  // radius of the ball that targets are held in
constexpr auto kConnectWait = milliseconds(500);
constexpr auto kAnswerWait = milliseconds(20);
constexpr auto kSendWait = milliseconds(50);
constexpr auto kSilence = milliseconds(1000);  // after which the connection counts as dead
constexpr auto kFirstRetry = milliseconds(500);
constexpr auto kLongestRetry = milliseconds(10'000);
constexpr double kTooSlow_s = 0.020;
constexpr double kKeyDoubt_s = 0.2;  // of force commanded and none reported
constexpr double kKeyDoubt_n = 0.05;
constexpr int kMostBadMessages = 20;  // in a row
constexpr int kDelayProbes = 15;

/// The service: x right, y forward, z up. Ours: x right, y up, z towards the learner.
Vec3 to_device_frame(const Vec3& v) noexcept { return {v.x, v.z, -v.y}; }
Vec3 to_service_frame(const Vec3& v) noexcept { return {v.x, -v.z, v.y}; }

/// What the delay of a loop leaves of the stiffness that a shorter delay allowed: b > K (T / 2 + delay).
double softened(double planned_delay_s, double delay_s) noexcept {
  return std::min(1.0, (kPeriod_s / 2 + planned_delay_s) / (kPeriod_s / 2 + delay_s));
}

class InverseDevice final : public haptics::HapticDevice {
 public:
  InverseDevice(InverseServiceSettings settings, std::string device_id, ForceKey key,
                const haptics::DeviceLimits& limits, const WorkspaceMapping& mapping)
      : settings_(std::move(settings)),
        device_id_(std::move(device_id)),
        name_("Inverse3 " + device_id_),
        limits_(limits),
        link_(name_, mapping, limits),
        key_(key) {}
  ~InverseDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {name_, 1 / kPeriod_s, true, link_.mapping().to_tablet(limits_)};
  }
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (clock_.status().running)
      return base::fail(base::Errc::device, "the device is running already", name_);
    connection_.reset();
    lost_ = key_changed_ = false;
    retry_ = kFirstRetry;
    next_try_ = last_good_ = Clock::now();
    delay_s_ = limits_.delay_s;
    link_.start(servo);
    auto started = clock_.start(kPeriod_s, [this](double) { tick(); });
    if (!started) link_.stop();
    return started;
  }
  void stop() noexcept override {
    if (!clock_.status().running) return;
    clock_.stop();
    // The force goes with the session; said once more for a service that is slow to notice.
    if (connection_) (void)connection_->send(inverse::tick_message(device_id_, key_, Vec3(0)), kSendWait);
    connection_.reset();
    link_.stop();
  }
  [[nodiscard]] haptics::DeviceStatus status() const override { return link_.status(); }

 private:
  void tick();
  void connect();
  void exchange(const inverse::ServiceState& state);
  void send(const Vec3& service_n);
  void disconnect(DeviceTrouble why);
  void pause(DeviceTrouble why, std::uint32_t buttons = 0);
  /// Whether the arm does as it is told; tries the other spelling once where not.
  bool obeys(const inverse::ArmState& arm);

  const InverseServiceSettings settings_;
  const std::string device_id_, name_;
  const haptics::DeviceLimits limits_;
  ServoLink link_;
  // Servo thread.
  std::unique_ptr<Connection> connection_;
  ForceKey key_;
  bool key_changed_ = false, lost_ = false, session_begun_ = false;
  DeviceTrouble last_trouble_ = DeviceTrouble::service_gone;
  Clock::duration retry_ = kFirstRetry;
  Clock::time_point next_try_, last_good_, sent_at_, heard_at_, doubted_since_;
  Vec3 commanded_n_{0, 0, 0};
  double delay_s_ = 0;
  int bad_messages_ = 0;
  std::string message_;
  RtThread clock_;  // last: it stops before the rest goes
};

void InverseDevice::pause(DeviceTrouble why, std::uint32_t buttons) {
  commanded_n_ = Vec3(0);
  last_trouble_ = why;
  const auto without = std::chrono::duration<double>(Clock::now() - last_good_).count();
  const bool goes_on_alone = why == DeviceTrouble::not_calibrated || why == DeviceTrouble::not_ready;
  lost_ = !goes_on_alone && without > settings_.give_up_s;
  link_.pause(lost_ ? DeviceState::lost : DeviceState::paused, why, 0, buttons);
  if (lost_) connection_.reset();
}

void InverseDevice::disconnect(DeviceTrouble why) {
  connection_.reset();
  next_try_ = Clock::now() + retry_;
  retry_ = std::min<Clock::duration>(2 * retry_, kLongestRetry);
  pause(why);
}

void InverseDevice::connect() {
  auto opened = Connection::open(settings_.host, settings_.port, kConnectWait);
  if (!opened) return disconnect(DeviceTrouble::service_gone);
  connection_ = std::move(*opened);
  heard_at_ = sent_at_ = Clock::now();
  bad_messages_ = 0;
  session_begun_ = false;
  doubted_since_ = {};
  // The inventory comes unasked; it is read as the first answer of the loop.
  pause(last_trouble_);
}

void InverseDevice::send(const Vec3& service_n) {
  commanded_n_ = service_n;
  sent_at_ = Clock::now();
  if (!connection_->send(inverse::tick_message(device_id_, key_, service_n), kSendWait))
    disconnect(DeviceTrouble::service_gone);
}

bool InverseDevice::obeys(const inverse::ArmState& arm) {
  const bool pushes = !arm.force_n || glm::length(*arm.force_n) > 0;
  if (pushes || key_changed_ || glm::length(commanded_n_) < kKeyDoubt_n) {
    doubted_since_ = {};
    return true;
  }
  const auto now = Clock::now();
  if (doubted_since_ == Clock::time_point{}) doubted_since_ = now;
  if (std::chrono::duration<double>(now - doubted_since_).count() < kKeyDoubt_s) return true;
  key_changed_ = true;
  key_ = key_ == ForceKey::vector ? ForceKey::values : ForceKey::vector;
  return false;
}

void InverseDevice::exchange(const inverse::ServiceState& state) {
  const auto arm = std::find_if(state.arms.begin(), state.arms.end(),
                                [&](const inverse::ArmState& a) { return a.device_id == device_id_; });
  Vec3 force(0);
  if (arm == state.arms.end()) {
    pause(DeviceTrouble::communication_lost, state.buttons);
    if (lost_) return;
  } else if (arm->calibrated == false) {
    pause(DeviceTrouble::not_calibrated, state.buttons);
  } else if (arm->ready == false) {
    pause(DeviceTrouble::not_ready, state.buttons);
  } else if (!arm->position_m) {
    pause(DeviceTrouble::bad_message, state.buttons);
    if (lost_) return;
  } else if (delay_s_ > kTooSlow_s) {
    pause(DeviceTrouble::too_slow, state.buttons);
    if (lost_) return;
  } else if (!obeys(*arm)) {
    pause(DeviceTrouble::not_ready, state.buttons);  // the servo lets go, and comes back with a ramp
  } else {
    last_good_ = Clock::now();
    retry_ = kFirstRetry;
    link_.set_delay_s(delay_s_);
    force = softened(limits_.delay_s, delay_s_) *
            to_service_frame(link_.feel(to_device_frame(*arm->position_m), state.buttons));
  }
  send(force);
}

void InverseDevice::tick() {
  if (lost_) return;
  if (!connection_) {
    if (Clock::now() < next_try_) return pause(last_trouble_);
    return connect();
  }
  switch (connection_->receive(message_, kAnswerWait)) {
    case Received::closed:
      return disconnect(DeviceTrouble::service_gone);
    case Received::too_large:
      return disconnect(DeviceTrouble::bad_message);
    case Received::nothing_yet:
      if (Clock::now() - heard_at_ > kSilence) return disconnect(DeviceTrouble::too_slow);
      // Commands last one tick: the arm has gone limp by now.
      return pause(DeviceTrouble::too_slow);
    case Received::message:
      break;
  }
  const auto now = Clock::now();
  const double round_trip_s = std::chrono::duration<double>(now - sent_at_).count();
  constexpr double kDelayFilter = 0.05;
  delay_s_ += kDelayFilter * (round_trip_s - delay_s_);
  heard_at_ = now;
  const auto state = inverse::parse_state(message_);
  if (!state) {
    if (++bad_messages_ > kMostBadMessages) return disconnect(DeviceTrouble::bad_message);
    pause(DeviceTrouble::bad_message);
    if (!lost_) send(Vec3(0));  // no message, no next state
    return;
  }
  bad_messages_ = 0;
  if (session_begun_) return exchange(*state);
  // The inventory, which comes unasked.
  session_begun_ = true;
  sent_at_ = Clock::now();
  if (!connection_->send(inverse::first_message(device_id_, key_, settings_.force_gate_gain), kSendWait))
    disconnect(DeviceTrouble::service_gone);
}

class InverseBackEnd final : public BackEnd {
 public:
  explicit InverseBackEnd(InverseServiceSettings settings) : settings_(std::move(settings)) {}
  [[nodiscard]] std::string_view id() const override { return "inverse3"; }

  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{"Haply Inverse3 (Inverse Service)", {}, std::nullopt};
    const auto session = connect();
    if (!session) {
      found.problem = session.error();
      return found;
    }
    for (const inverse::ArmState& arm : session->inventory.arms)
      found.devices.push_back({"inverse3:" + arm.device_id, "Inverse3 " + arm.device_id, true, true});
    if (found.devices.empty()) found.problem = absent("").value();
    return found;
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    auto session = connect();
    if (!session) return tl::unexpected(session.error());
    const std::size_t colon = device.find(':');
    const std::string_view wanted = colon == std::string_view::npos ? "" : device.substr(colon + 1);
    const auto& arms = session->inventory.arms;
    const auto arm = std::find_if(arms.begin(), arms.end(), [&](const inverse::ArmState& a) {
      return wanted.empty() || a.device_id == wanted;
    });
    if (arm == arms.end()) return absent(device);

    ForceKey key = ForceKey::vector;
    if (const auto version = inverse::http_get(settings_.host, settings_.port, "/version", kConnectWait))
      key = inverse::key_for_version(*version).value_or(key);
    haptics::DeviceLimits limits = SimulatedHardware::inverse3().limits;
    limits.max_force_n = std::min(std::max(settings_.force_cap_n, 0.1), 10.0);
    limits.continuous_force_n = std::min(limits.continuous_force_n, limits.max_force_n);
    limits.delay_s = settings_.delay_s ? std::clamp(*settings_.delay_s, 0.0, kTooSlow_s)
                                       : measure_delay(*session->connection, arm->device_id, key);

    const double half = kReach_m / std::sqrt(3.0);
    const DeviceWorkspace workspace{{-half, -half, -half}, {half, half, half}};
    const WorkspaceCalibration fit =
        request.calibration.value_or(fit_workspace(workspace, request.shape, request.posture));
    const auto mapping = WorkspaceMapping::create(fit);
    if (!mapping) return tl::unexpected(DeviceProblem{DeviceTrouble::bad_calibration, mapping.error()});
    return OpenedDevice{"inverse3:" + arm->device_id,
                        std::make_unique<InverseDevice>(settings_, arm->device_id, key, limits, *mapping),
                        fit, workspace};
  }

 private:
  struct Session {
    std::unique_ptr<Connection> connection;
    inverse::ServiceState inventory;
  };

  [[nodiscard]] std::string where() const { return settings_.host + ":" + std::to_string(settings_.port); }
  static tl::unexpected<DeviceProblem> absent(std::string_view device) {
    return no_device(DeviceTrouble::device_absent, "the service sees no such arm",
                     device.empty() ? kName : std::string(device),
                     "plug the Inverse3 in, switch its power on and wait for its light");
  }
  [[nodiscard]] DeviceResult<Session> connect() const {
    auto connection = Connection::open(settings_.host, settings_.port, kConnectWait);
    if (!connection)
      return no_device(DeviceTrouble::service_missing,
                       "no service answers on " + where() + ": " + connection.error().what, kName,
                       "install and start haply-inverse-service, see docs/devices.md, Inverse3");
    std::string message;
    const Received received = (*connection)->receive(message, kSilence);
    const auto inventory = received == Received::message ? inverse::parse_state(message) : std::nullopt;
    if (!inventory)
      return no_device(DeviceTrouble::bad_message, "what answers on " + where() + " sends no list of devices",
                       kName, "update haply-inverse-service to 3.1 or later, or set its port");
    return Session{std::move(*connection), *inventory};
  }
  /// From pose to force: the usual round trip, doubled, for a busy machine. At least a period.
  static double measure_delay(Connection& connection, const std::string& device_id, ForceKey key) {
    std::vector<double> round_trips;
    std::string message = inverse::first_message(device_id, key, std::nullopt);
    for (int i = 0; i < kDelayProbes; ++i) {
      const auto sent = Clock::now();
      if (!connection.send(message, kSendWait) || connection.receive(message, kSilence) != Received::message)
        break;
      round_trips.push_back(std::chrono::duration<double>(Clock::now() - sent).count());
      message = inverse::tick_message(device_id, key, Vec3(0));
    }
    if (round_trips.empty()) return kTooSlow_s;
    std::nth_element(round_trips.begin(), round_trips.begin() + round_trips.size() / 2, round_trips.end());
    return std::clamp(2 * round_trips[round_trips.size() / 2], kPeriod_s, kTooSlow_s);
  }

  InverseServiceSettings settings_;
};

}  // namespace

std::unique_ptr<BackEnd> inverse_service_back_end(InverseServiceSettings settings) {
  return std::make_unique<InverseBackEnd>(std::move(settings));
}

}  // namespace nazori::devices
