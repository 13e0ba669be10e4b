// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "device_settings.h"
#include "nazori/devices/device_catalogue.h"
#include "worker.h"

namespace nazori::ui {

/// What is to be opened.
struct DeviceWish {
  std::string id;                    ///< this one first; empty: none in particular
  bool or_best = true;               ///< where it cannot be had: the first with force that opens, best first
  std::vector<std::string> but_not;  ///< ids that or_best leaves out
};

/// What came of a wish.
struct DeviceFind {
  std::optional<devices::OpenedDevice> opened;
  std::optional<devices::DeviceProblem> refused;  ///< why what was asked for by name was not opened
};

/// Looks for devices and opens and closes them on a thread of its own, one after the other: makers' libraries
/// and services take seconds where something is wrong, and the window must not wait.
/// Thread: interface; answers are heard there, and not any more once this is gone. Its end waits for what is
/// being done.
class DeviceSearch {
 public:
  using BackEnds = std::vector<std::unique_ptr<devices::BackEnd>>;
  using Remembered = QHash<QString, DeviceSettings>;

  /// @param shape  of the tablets.
  DeviceSearch(BackEnds back_ends, const geometry::TabletShape& shape);

  /// Every back end's findings.
  void find(std::function<void(std::vector<devices::BackEndFindings>)> done);
  /// What was asked for before and not yet answered is cancelled.
  /// @param remembered  of each device, by id: how it is to be opened.
  void open(DeviceWish wish, Remembered remembered, std::function<void(DeviceFind)> done);
  /// What open() was last asked for is not wanted any more; its answer is not heard.
  void cancel();
  /// Closes a stopped device; what is asked after that finds it closed.
  void close(devices::OpenedDevice device);

 private:
  /// One wish and what came of it. The worker writes `found`, and empties it where it is cancelled; the
  /// interface takes it only where it is not.
  struct Errand {
    std::atomic<bool> wanted{true};
    DeviceFind found;
  };
  [[nodiscard]] DeviceFind open_now(const DeviceWish& wish, const Remembered& remembered);

  devices::DeviceCatalogue catalogue_;  // the worker's
  geometry::TabletShape shape_;
  std::shared_ptr<Errand> errand_;
  Worker worker_;  // last: it ends before the rest goes
};

}  // namespace nazori::ui
