// SPDX-License-Identifier: Apache-2.0
#include "device_search.h"

#include <algorithm>
#include <utility>

#include "kanji_text.h"

namespace nazori::ui {

DeviceSearch::DeviceSearch(BackEnds back_ends, const geometry::TabletShape& shape)
    : catalogue_(std::move(back_ends)), shape_(shape), worker_(QStringLiteral("devices")) {}

void DeviceSearch::find(std::function<void(std::vector<devices::BackEndFindings>)> done) {
  worker_.post(
      [this, done = std::move(done)] { worker_.answer([done, found = catalogue_.find()] { done(found); }); });
}

void DeviceSearch::open(DeviceWish wish, Remembered remembered, std::function<void(DeviceFind)> done) {
  cancel();
  errand_ = std::make_shared<Errand>();
  worker_.post([this, errand = errand_, wish = std::move(wish), remembered = std::move(remembered),
                done = std::move(done)] {
    if (!errand->wanted) return;
    errand->found = open_now(wish, remembered);
    worker_.answer([this, errand, done] {
      if (errand != errand_) return;
      errand_.reset();
      done(std::move(errand->found));
    });
  });
}

void DeviceSearch::cancel() {
  if (!errand_) return;
  errand_->wanted = false;
  // It may have been opened already: closed before the next is opened.
  worker_.post([errand = std::move(errand_)] { errand->found.opened.reset(); });
  errand_.reset();
}

void DeviceSearch::close(devices::OpenedDevice device) {
  auto closing = std::make_shared<devices::OpenedDevice>(std::move(device));
  worker_.post([closing] { closing->device.reset(); });
}

DeviceFind DeviceSearch::open_now(const DeviceWish& wish, const Remembered& remembered) {
  const auto open = [&](const std::string& id) {
    const auto request = [&](const std::string& of) {
      const DeviceSettings settings = remembered.value(to_text(of));
      return devices::OpenRequest{shape_, settings.posture, settings.calibration};
    };
    auto opened = catalogue_.open(id, request(id));
    // A name that is not an id was asked for: what is remembered belongs to the id.
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

}  // namespace nazori::ui
