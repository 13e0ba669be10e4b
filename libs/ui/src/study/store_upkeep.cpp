// SPDX-License-Identifier: Apache-2.0
#include "study/store_upkeep.h"

#include <semaphore>
#include <utility>

namespace nazori::ui {

StoreUpkeep::StoreUpkeep(QObject* parent) : QObject(parent) {}

// What runs now sees that its answer is no longer awaited.
StoreUpkeep::~StoreUpkeep() { ++newest_; }

void StoreUpkeep::request(const std::filesystem::path& learner, study::Day day) {
  const std::uint64_t number = ++newest_;
  busy_ = true;
  worker_.post([this, learner, day, number] {
    if (number != newest_) return;
    const auto progress = [this, number](double, std::string_view) { return number == newest_; };
    auto found = study::keep_up(learner, day, progress);
    worker_.answer([this, number, found = std::move(found)] {
      if (number != newest_) return;
      busy_ = false;
      if (found)
        emit done(*found);
      else
        emit failed(found.error());
    });
  });
}

void StoreUpkeep::stop() {
  if (!busy_) return;
  busy_ = false;
  ++newest_;
  std::binary_semaphore idle(0);
  worker_.post([&idle] { idle.release(); });
  idle.acquire();
}

}  // namespace nazori::ui
