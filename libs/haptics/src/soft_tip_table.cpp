// SPDX-License-Identifier: Apache-2.0
// What is prepared of a soft tip; the tick is in soft_contact.cpp.
#include <algorithm>
#include <cmath>

#include "nazori/haptics/soft_contact.h"

namespace nazori::haptics {
namespace {

double within(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

}  // namespace

SoftTipTable::SoftTipTable(const SoftTip& tip, double most_n_m, double most_n) {
  const bool finite =
      std::all_of(tip.push_n.begin(), tip.push_n.end(), [](double n) { return std::isfinite(n); });
  if (tip.push_n.size() < 2 || !finite || !(tip.step_m > 1e-6 && tip.step_m < 1)) return;
  step_ = tip.step_m;
  per_m_ = 1 / tip.step_m;
  const double most_change = std::max(0.0, most_n_m) * step_;
  // It begins at zero: a tip that only just touches does not push.
  push_ = {0};
  stored_ = {0};
  for (std::size_t i = 1; i < tip.push_n.size(); ++i) {
    const double wanted = within(tip.push_n[i], 0, std::max(0.0, most_n));
    push_.push_back(std::clamp(wanted, push_.back() - most_change, push_.back() + most_change));
    stored_.push_back(stored_.back() + 0.5 * step_ * (push_[i - 1] + push_[i]));
  }
  friction_ = within(tip.friction, 0, 10);
  along_hair_ = within(tip.along_hair, 0, 1);
  sideways_ = within(tip.sideways_n_m, 1e-3, std::max(1e-3, most_n_m));
  tow_ = within(tip.tow_m, 1e-4, 1);
}

}  // namespace nazori::haptics
