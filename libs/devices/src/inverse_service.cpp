// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/inverse_service.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "inverse_device.h"
#include "nazori/devices/simulated_device.h"

namespace nazori::devices {
namespace {

using haptics::DeviceTrouble;
using haptics::Vec3;
using inverse::ArmAddress;
using inverse::ArmState;
using inverse::ArmType;
using inverse::Connection;
using inverse::Dialect;
using inverse::Received;
using Clock = inverse::Clock;

constexpr const char* kName = "Inverse Service";
constexpr int kDelayProbes = 15;

/// Middle of the workspace of an Inverse3 with its arm on the right, measured from the middle of its mounting
/// plate: the starting point of the maker's own examples.
constexpr Vec3 kCentre_m{0.0186, -0.153, 0.151};

ArmType type_of(const ArmState& arm) { return arm.type.value_or(ArmType::inverse3); }

/// Radius of the ball to which the maker's tutorials limit targets.
double reach_m(ArmType type) { return type == ArmType::minverse ? 0.04 : 0.10; }

std::string name_of(const ArmState& arm) {
  const auto words = [&] {
    switch (type_of(arm)) {
      case ArmType::inverse3x:
        return "Inverse3x ";
      case ArmType::minverse:
        return "Minverse ";
      case ArmType::inverse3:
        break;
    }
    return "Inverse3 ";
  };
  return words() + std::string(arm.device_id.view());
}

class InverseBackEnd final : public BackEnd {
 public:
  explicit InverseBackEnd(InverseServiceSettings settings) : settings_(std::move(settings)) {}
  [[nodiscard]] std::string_view id() const override { return "inverse3"; }

  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{"Haply Inverse3, Inverse3x and Minverse (Inverse Service)", {}, std::nullopt};
    const auto session = connect();
    if (!session) {
      found.problem = session.error();
      return found;
    }
    for (std::size_t i = 0; i < session->inventory.arm_count; ++i) {
      const ArmState& arm = session->inventory.arms[i];
      found.devices.push_back({id_of(arm), name_of(arm), true, true});
    }
    if (found.devices.empty()) found.problem = absent("").value();
    return found;
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    auto session = connect();
    if (!session) return tl::unexpected(session.error());
    const std::size_t colon = device.find(':');
    const ArmState* const arm =
        session->inventory.find(colon == std::string_view::npos ? "" : device.substr(colon + 1));
    if (arm == nullptr) return absent(device);

    ArmAddress address{std::string(arm->device_id.view()), dialect(*arm), {}};
    if (!address.dialect.knows_presets) {
      if (type_of(*arm) == ArmType::minverse)
        return no_device(DeviceTrouble::bad_calibration, "this service does not tell where its tablet lies",
                         name_of(*arm), "update haply-inverse-service to 3.5 or later");
      address.centre_m = kCentre_m;
      if (arm->left_handed) address.centre_m.x = -address.centre_m.x;
    }
    haptics::DeviceLimits limits = SimulatedHardware::inverse3().limits;
    limits.max_force_n = std::min(std::max(settings_.force_cap_n, 0.1), 10.0);
    limits.continuous_force_n = std::min(limits.continuous_force_n, limits.max_force_n);
    limits.delay_s = settings_.delay_s ? std::clamp(*settings_.delay_s, 0.0, kTooSlow_s)
                                       : measure_delay(*session->connection, address);

    const double half = reach_m(type_of(*arm)) / std::sqrt(3.0);
    const DeviceWorkspace workspace{{-half, -half, -half}, {half, half, half}};
    const WorkspaceCalibration fit =
        request.calibration.value_or(fit_workspace(workspace, request.shape, request.posture));
    const auto mapping = WorkspaceMapping::create(fit);
    if (!mapping) return tl::unexpected(DeviceProblem{DeviceTrouble::bad_calibration, mapping.error()});
    return OpenedDevice{id_of(*arm), inverse::arm_device(settings_, address, name_of(*arm), limits, *mapping),
                        fit, workspace};
  }

 private:
  struct Session {
    std::unique_ptr<Connection> connection;
    inverse::ServiceState inventory;
  };

  static std::string id_of(const ArmState& arm) { return "inverse3:" + std::string(arm.device_id.view()); }
  [[nodiscard]] std::string where() const { return settings_.host + ":" + std::to_string(settings_.port); }
  static tl::unexpected<DeviceProblem> absent(std::string_view device) {
    return no_device(DeviceTrouble::device_absent, "the service does not find this arm",
                     device.empty() ? kName : std::string(device),
                     "plug the arm in, switch its power on and wait for its light");
  }
  [[nodiscard]] DeviceResult<Session> connect() const {
    auto connection = Connection::open(settings_.host, settings_.port, inverse::kConnectWait);
    if (!connection)
      return no_device(DeviceTrouble::service_missing,
                       "no service responds on " + where() + ": " + connection.error().what, kName,
                       "install and start haply-inverse-service, see docs/devices.md, Inverse3");
    std::string message;
    Session session{std::move(*connection), {}};
    if (session.connection->receive(message, inverse::kSilence) != Received::message ||
        !inverse::read_state(message, session.inventory))
      return no_device(DeviceTrouble::bad_message,
                       "the service on " + where() + " does not send a list of devices", kName,
                       "update haply-inverse-service to 3.1 or later, or set the correct port");
    return session;
  }
  /// Decided by the version; where the service does not report it, by the inventory.
  [[nodiscard]] Dialect dialect(const ArmState& arm) const {
    const auto version = inverse::http_get(settings_.host, settings_.port, "/version", inverse::kConnectWait);
    const Dialect recent, old{inverse::ForceKey::values, false};
    return version ? inverse::dialect_for_version(*version).value_or(arm.has_preset ? recent : old)
                   : (arm.has_preset ? recent : old);
  }
  /// From pose to force: the usual round trip, doubled, for a busy machine, and a period until the servo and
  /// the communication thread have exchanged data.
  static double measure_delay(Connection& connection, const ArmAddress& arm) {
    std::vector<double> round_trips;
    inverse::TickMessage tick(arm.device_id, arm.dialect.key);
    std::string answer;
    std::string message = inverse::first_message(arm.device_id, arm.dialect, std::nullopt);
    for (int i = 0; i < kDelayProbes; ++i) {
      (void)connection.receive_newest(
          answer, std::chrono::milliseconds(0));  // old messages, not the answer to this request
      const auto sent = Clock::now();
      if (!connection.send(message, inverse::kSendWait) ||
          connection.receive(answer, inverse::kSilence) != Received::message)
        break;
      round_trips.push_back(std::chrono::duration<double>(Clock::now() - sent).count());
      message = tick.write(Vec3(0));
    }
    if (round_trips.empty()) return kTooSlow_s;
    const auto middle = round_trips.begin() + static_cast<std::ptrdiff_t>(round_trips.size() / 2);
    std::nth_element(round_trips.begin(), middle, round_trips.end());
    return std::min(2 * *middle + kLinkPeriod_s, kTooSlow_s);
  }

  InverseServiceSettings settings_;
};

}  // namespace

std::unique_ptr<BackEnd> inverse_service_back_end(InverseServiceSettings settings) {
  return std::make_unique<InverseBackEnd>(std::move(settings));
}

}  // namespace nazori::devices
