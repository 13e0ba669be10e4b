// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/long_work.h"

#include <algorithm>

namespace nazori::practice {

LongWork::LongWork(const std::string& name, base::Inbox& inbox) : background_(name, inbox) {}

LongWork::~LongWork() { stop(); }

bool LongWork::begin() {
  if (is_busy_) return false;
  is_busy_ = true;
  is_wanted_ = true;
  return true;
}

base::Progress LongWork::progress() {
  return [this, reported = 0](double done, std::string_view) mutable {
    const int percent = std::clamp(static_cast<int>(100 * done), 0, 99);
    if (percent > std::exchange(reported, percent)) {
      background_.answer([this, percent] {
        if (is_busy_ && is_wanted_) progressed(percent);
      });
    }
    return is_wanted_.load();
  };
}

}  // namespace nazori::practice
