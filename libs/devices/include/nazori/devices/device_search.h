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

/// Which device to open.
struct DeviceWish {
  std::string id;                    ///< tried first; empty: none in particular
  bool or_best = true;               ///< if that fails, the first with force that opens, best first
  std::vector<std::string> but_not;  ///< ids that or_best leaves out
};

/// The result of a request.
struct DeviceFind {
  std::optional<OpenedDevice> opened;
  std::optional<DeviceProblem> refused;  ///< why the device requested by name was not opened
};

/// Looks for devices and opens and closes them on a thread of its own, one after the other: makers' libraries
/// and services take seconds where something is wrong, and the window must not wait. Thread: the owner of the
/// inbox. Answers run there, and never after this object is destroyed. The destructor waits for the operation
/// in progress.
class DeviceSearch {
 public:
  using BackEnds = std::vector<std::unique_ptr<BackEnd>>;

  /// @param inbox  of the thread that makes and destroys this object; outlives it.
  /// @param shape  of the tablets.
  DeviceSearch(base::Inbox& inbox, BackEnds back_ends, const geometry::TabletShape& shape);

  /// Every back end's findings.
  void find(std::function<void(std::vector<BackEndFindings>)> done);
  /// Opens the requested device. An earlier request without an answer is cancelled.
  /// @param remembered  for each device: how to open it.
  void open(DeviceWish wish, RememberedDevices remembered, std::function<void(DeviceFind)> done);
  /// Cancels the last open(); there will be no answer.
  void cancel();
  /// Closes a stopped device. Later requests find it closed.
  void close(OpenedDevice device);

 private:
  /// One request and its result. The executor's thread writes `found`, and empties it if the request is
  /// cancelled. The owner's thread moves it out only if the request is not cancelled.
  struct Request {
    std::atomic<bool> wanted{true};
    DeviceFind found;
  };
  [[nodiscard]] DeviceFind open_now(const DeviceWish& wish, const RememberedDevices& remembered);

  DeviceCatalogue catalogue_;  // used by the executor's thread only
  geometry::TabletShape shape_;
  std::shared_ptr<Request> request_;
  base::Background
      background_;  // declared last, so that its thread ends before the other members are destroyed
};

}  // namespace nazori::devices
