// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "device_nodes.h"
#include "nazori/devices/pantograph.h"
#include "pantograph_device.h"
#include "pantograph_link.h"

namespace nazori::devices {
namespace {

using haptics::DeviceTrouble;
using pantograph::Answer;
using pantograph::Clock;
using pantograph::kModels;
using pantograph::Model;
using pantograph::Reading;
using pantograph::SerialPort;
using std::chrono::milliseconds;

constexpr const char* kName = "Haply 2diy (pantograph)";
constexpr const char* kId = "pantograph";

/// The boards are Arduino models and have their numbers: an M0 those of a Zero, an M3 those of a Due, each at
/// its own USB port. @source boards.txt of Arduino's SAMD and SAM cores; public programs for the 2diy look
/// for a port named "Arduino Zero".
constexpr std::array<std::string_view, 2> kBoards{"2341:804d", "2341:003e"};

constexpr int kTries = 2;
constexpr auto kSettle = milliseconds(5);  // the firmware takes a command each 50 us
constexpr auto kQuiet = milliseconds(20);  // silence of a board without requests
constexpr auto kFirstAnswer = milliseconds(600);
constexpr double kNearRest_deg = 20;  // a hand may have moved the handle
constexpr int kDelayProbes = 15;

/// Sets up the board and makes it confirm a torque of zero. @return its reading at that moment, or nothing.
std::optional<Reading> set_up(SerialPort& port, const pantograph::BoardSetup& setup) {
  for (int i = 0; i < kTries; ++i) {
    if (!port.write(pantograph::settling_packet().bytes())) return std::nullopt;
    std::this_thread::sleep_for(kSettle);
    port.discard(kQuiet);
    Reading reading;
    if (!port.write(pantograph::setup_packet(setup).bytes()) ||
        !port.write(pantograph::torque_packet(setup, {0, 0}).bytes()))
      return std::nullopt;
    if (read_answer(port, setup, reading, kFirstAnswer) == Answer::reading) return reading;
  }
  return std::nullopt;
}

bool is_near_rest(const Reading& reading, const pantograph::BoardSetup& setup) {
  for (std::size_t i = 0; i < setup.joints.size(); ++i) {
    if (!(std::abs(reading.angle_deg[i] - setup.joints[i].rest_deg) < kNearRest_deg)) return false;
  }
  return true;
}

/// Delay from a pose to the torques for it [s]: one request that returns the pose, one that sets the torques,
/// and the servo's tick between them.
double measure_delay(SerialPort& port, const pantograph::BoardSetup& setup) {
  std::vector<double> round_trips;
  for (int i = 0; i < kDelayProbes; ++i) {
    Reading reading;
    const auto asked = Clock::now();
    if (!port.write(pantograph::torque_packet(setup, {0, 0}).bytes()) ||
        read_answer(port, setup, reading, pantograph::kAnswerWait) != Answer::reading)
      break;
    round_trips.push_back(std::chrono::duration<double>(Clock::now() - asked).count());
  }
  if (round_trips.empty()) return kTooSlow_s;
  const auto middle = round_trips.begin() + static_cast<std::ptrdiff_t>(round_trips.size() / 2);
  std::nth_element(round_trips.begin(), middle, round_trips.end());
  return std::min(2 * *middle + kLinkPeriod_s, kTooSlow_s);
}

class PantographBackEnd final : public BackEnd {
 public:
  explicit PantographBackEnd(PantographSettings settings) : settings_(std::move(settings)) {}
  [[nodiscard]] std::string_view id() const override { return kId; }

  [[nodiscard]] BackEndFindings find() override {
    BackEndFindings found{kName, {}, std::nullopt};
    const std::vector<DeviceNode> nodes = boards();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const DeviceNode& node = nodes[i];
      if (is_open(node)) found.problem = in_use(node).value();
      if (!node.open) continue;
      for (const Model& model : kModels)
        found.devices.push_back(
            {id_of(model, i), std::string(model.name) + " at " + node.path.string(), true, false});
    }
    if (found.devices.empty() || permission_advice(nodes)) found.problem = absent(nodes, kName).value();
    return found;
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view device,
                                                const OpenRequest& request) override {
    const std::vector<DeviceNode> nodes = boards();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const Model& model : kModels) {
        if (device == id() || device == id_of(model, i))
          return open_board(nodes[i], model, id_of(model, i), request);
      }
    }
    return absent(nodes, std::string(device));
  }

 private:
  static std::string id_of(const Model& model, std::size_t board) {
    std::string id = std::string(kId) + ":" + std::string(model.version);
    if (board > 0) id += "." + std::to_string(board + 1);
    return id;
  }
  static tl::unexpected<DeviceProblem> in_use(const DeviceNode& node) {
    return no_device(DeviceTrouble::in_use, "it is already open in this program", node.path.string(),
                     "use the open one");
  }
  static tl::unexpected<DeviceProblem> absent(const std::vector<DeviceNode>& nodes, std::string what) {
    if (const auto advice = permission_advice(nodes))
      return no_device(DeviceTrouble::no_permission, "its board cannot be opened", std::move(what), *advice);
    return no_device(DeviceTrouble::device_absent, "no board is plugged in", std::move(what),
                     "plug it in, see docs/devices.md, Haply 2diy");
  }

  /// The ports that may belong to a board.
  [[nodiscard]] std::vector<DeviceNode> boards() const {
    if (!settings_.port.empty()) {
      const std::filesystem::path path = settings_.port;
      std::vector<DeviceNode> nodes = device_nodes(path.parent_path(), {path.filename().string()});
      std::erase_if(nodes, [&](const DeviceNode& node) { return node.path != path; });
      return nodes;
    }
    std::vector<DeviceNode> nodes = device_nodes(settings_.device_folder, {"ttyACM"});
    std::erase_if(nodes, [&](const DeviceNode& node) {
      const std::string product = usb_product(node.path, settings_.system_folder);
      return std::find(kBoards.begin(), kBoards.end(), product) == kBoards.end();
    });
    return nodes;
  }
  [[nodiscard]] bool is_open(const DeviceNode& node) const {
    const auto found = open_.find(node.path.string());
    return found != open_.end() && !found->second.expired();
  }

  [[nodiscard]] DeviceResult<OpenedDevice> open_board(const DeviceNode& node, const Model& model,
                                                      std::string id, const OpenRequest& request) {
    if (is_open(node)) return in_use(node);
    // The pantograph's plane is the tablet's plane, whatever the pose of the tablet on other devices.
    TabletPosture upright;
    upright.hand = request.posture.hand;
    WorkspaceCalibration fit =
        request.calibration.value_or(fit_workspace(pantograph::plane_workspace(), request.shape, upright));
    fit.posture = upright;
    const auto mapping = WorkspaceMapping::create(fit);
    if (!mapping) return tl::unexpected(DeviceProblem{DeviceTrouble::bad_calibration, mapping.error()});

    auto port = SerialPort::open(node.path);
    if (!port) return tl::unexpected(port.error());
    pantograph::OpenBoard board{*port, model, pantograph::plane_limits(), settings_.give_up_s};
    board.model.setup.has_button = settings_.has_button;
    const auto reading = set_up(**port, board.model.setup);
    if (!reading || !is_near_rest(*reading, board.model.setup))
      return no_device(DeviceTrouble::init_failed,
                       reading ? "its board answers with angles that it was not given"
                               : "what is there does not answer as Haply's board does",
                       node.path.string(),
                       "it must run Haply's firmware, M0 0.3 or M3 1.5; see docs/devices.md, Haply 2diy");
    board.limits.delay_s = settings_.delay_s ? std::clamp(*settings_.delay_s, 0.0, kTooSlow_s)
                                             : measure_delay(**port, board.model.setup);
    open_[node.path.string()] = *port;
    return OpenedDevice{std::move(id), pantograph_device(std::move(board), *mapping, request.shape), fit,
                        pantograph::plane_workspace()};
  }

  PantographSettings settings_;
  std::map<std::string, std::weak_ptr<SerialPort>> open_;
};

}  // namespace

std::unique_ptr<BackEnd> pantograph_back_end(PantographSettings settings) {
  return std::make_unique<PantographBackEnd>(std::move(settings));
}

}  // namespace nazori::devices
