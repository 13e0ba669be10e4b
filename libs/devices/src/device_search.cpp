// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_search.h"

#include <algorithm>
#include <utility>

namespace nazori::devices {

DeviceSearch::DeviceSearch(base::Inbox& inbox, BackEnds back_ends, const geometry::TabletShape& shape)
    : catalogue_(std::move(back_ends)), shape_(shape), background_("devices", inbox) {}

void DeviceSearch::find(std::function<void(std::vector<BackEndFindings>)> done) {
  background_.post([this, done = std::move(done)] {
    background_.answer([done, found = catalogue_.find()] { done(found); });
  });
}

void DeviceSearch::open(DeviceWish wish, RememberedDevices remembered, std::function<void(DeviceFind)> done) {
  cancel();
  request_ = std::make_shared<Request>();
  background_.post([this, request = request_, wish = std::move(wish), remembered = std::move(remembered),
                    done = std::move(done)] {
    if (!request->wanted) return;
    request->found = open_now(wish, remembered);
    background_.answer([this, request, done] {
      if (request != request_) return;
      request_.reset();
      done(std::move(request->found));
    });
  });
}

void DeviceSearch::cancel() {
  if (!request_) return;
  request_->wanted = false;
  // It may have been opened already: close it before the next one is opened.
  background_.post([request = std::move(request_)] { request->found.opened.reset(); });
  request_.reset();
}

void DeviceSearch::close(OpenedDevice device) {
  auto closing = std::make_shared<OpenedDevice>(std::move(device));
  background_.post([closing] { closing->device.reset(); });
}

DeviceFind DeviceSearch::open_now(const DeviceWish& wish, const RememberedDevices& remembered) {
  const auto open = [&](const std::string& id) {
    const auto request = [&](const std::string& of) {
      const DeviceSettings settings = settings_of(remembered, of);
      return OpenRequest{shape_, settings.posture, settings.calibration};
    };
    auto opened = catalogue_.open(id, request(id));
    // The request may be a name that is not an id; saved settings belong to the id.
    if (opened && opened->id != id) {
      const std::string found = opened->id;
      opened->device.reset();
      opened = catalogue_.open(found, request(found));
    }
    return opened;
  };
  DeviceFind found;
  if (!wish.id.empty()) {
    auto opened = open(wish.id);
    if (opened)
      found.opened = std::move(*opened);
    else
      found.refused = opened.error();
  }
  if (found.opened || !wish.or_best) return found;
  std::vector<std::string> ids;
  for (const auto& findings : catalogue_.find())
    for (const auto& device : findings.devices)
      if (device.automatic && device.has_force && device.id != wish.id &&
          std::find(wish.but_not.begin(), wish.but_not.end(), device.id) == wish.but_not.end())
        ids.push_back(device.id);
  for (const std::string& id : ids) {
    auto opened = open(id);
    if (!opened) continue;
    found.opened = std::move(*opened);
    break;
  }
  return found;
}

}  // namespace nazori::devices
