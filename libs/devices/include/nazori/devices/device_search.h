// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/device_settings.h"

namespace nazori::devices {

/// What is to be opened.
struct DeviceWish {
  std::string id;                    ///< this one first; empty: none in particular
  bool or_best = true;               ///< if that fails, the first with force that opens, best first
  std::vector<std::string> but_not;  ///< ids that or_best leaves out
};

/// What came of a wish.
struct DeviceFind {
  std::optional<OpenedDevice> opened;
  std::optional<DeviceProblem> refused;  ///< why what was asked for by name was not opened
};

/// Looks for devices and opens and closes them on a thread of its own, one after the other: makers' libraries
/// and services take seconds where something is wrong, and the window must not wait.
/// Thread: the owner of the inbox; answers run there, and never once this is gone. The destructor waits for
/// what is being done.
class DeviceSearch {
 public:
  using BackEnds = std::vector<std::unique_ptr<BackEnd>>;

  /// @param inbox  of the thread that makes and destroys this object; outlives it.
  /// @param shape  of the tablets.
  DeviceSearch(base::Inbox& inbox, BackEnds back_ends, const geometry::TabletShape& shape);

  /// Every back end's findings.
  void find(std::function<void(std::vector<BackEndFindings>)> done);
  /// Opens what is wished. An earlier wish that has no answer yet is cancelled.
  /// @param remembered  of each device: how it is to be opened.
  void open(DeviceWish wish, RememberedDevices remembered, std::function<void(DeviceFind)> done);
  /// What open() was last asked for is no longer wanted; there is no answer.
  void cancel();
  /// Closes a stopped device; what is asked after that finds it closed.
  void close(OpenedDevice device);

 private:
  /// One wish and what came of it. The executor's thread writes `found`, and empties it if the request is
  /// cancelled; the owner's thread takes it only if it is not.
  struct Request {
    std::atomic<bool> wanted{true};
    DeviceFind found;
  };
  [[nodiscard]] DeviceFind open_now(const DeviceWish& wish, const RememberedDevices& remembered);

  DeviceCatalogue catalogue_;  // used by the executor's thread only
  geometry::TabletShape shape_;
  std::shared_ptr<Request> request_;
  base::Background background_;  // declared last, so that its thread ends before the rest goes
};

}  // namespace nazori::devices
