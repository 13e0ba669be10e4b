// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/force_table.h"

#include <algorithm>
#include <cmath>

namespace nazori::brush {
namespace {

constexpr std::size_t kDepths = 61, kLeans = 12;
// A beam whose ends do not turn resists sideways with 12 EI/L^3.
constexpr double kSideways = 12;
// The patch of contact follows the holder at about this distance [L].
constexpr double kTow = 0.4;

}  // namespace

ForceTable::ForceTable(const TuftForm& form) : form_(form), push_(kLeans, std::vector<double>(kDepths)) {
  for (std::size_t row = 0; row < kLeans; ++row) {
    const double lean = kLeanStep_rad * static_cast<double>(row);
    Spine spine(form.spine);
    spine.place({{0, 1.1}, lean});
    for (std::size_t i = 1; i < kDepths; ++i) {
      const double height = std::max(kLowestRoot, std::cos(lean) - kDepthStep * static_cast<double>(i));
      // A step that fails keeps the last good shape, and with it the last push.
      (void)spine.move_to({{-height * std::tan(lean), height}, lean});
      push_[row][i] = spine.push();
    }
  }
}

ForceTable::Between ForceTable::between(double lean_rad) noexcept {
  const double lean = std::isfinite(lean_rad) ? std::clamp(lean_rad, 0.0, kMostLean_rad) : 0.0;
  const double place = lean / kLeanStep_rad;
  const std::size_t row = std::min(kLeans - 2, static_cast<std::size_t>(place));
  return {row, std::min(1.0, place - static_cast<double>(row))};
}

double ForceTable::at(const std::vector<double>& push, double depth) noexcept {
  const double place = depth / kDepthStep;
  if (!(place < kDepths - 1)) return push.back();
  const auto i = static_cast<std::size_t>(place);
  return push[i] + (place - static_cast<double>(i)) * (push[i + 1] - push[i]);
}

double ForceTable::integral(const std::vector<double>& push, double depth) noexcept {
  double sum = 0;
  std::size_t i = 0;
  for (; i + 1 < kDepths && kDepthStep * static_cast<double>(i + 1) <= depth; ++i)
    sum += 0.5 * kDepthStep * (push[i] + push[i + 1]);
  const double rest = depth - kDepthStep * static_cast<double>(i);
  return sum + 0.5 * rest * (push[i] + at(push, depth));
}

double ForceTable::push_n(double depth_m, double lean_rad) const noexcept {
  if (!(depth_m > 0)) return 0;
  const auto [row, part] = between(lean_rad);
  const double depth = depth_m / form_.hair_m;
  return form_.force_unit_n() * ((1 - part) * at(push_[row], depth) + part * at(push_[row + 1], depth));
}

double ForceTable::stored_j(double depth_m, double lean_rad) const noexcept {
  if (!(depth_m > 0)) return 0;
  const auto [row, part] = between(lean_rad);
  const double depth = depth_m / form_.hair_m;
  return form_.force_unit_n() * form_.hair_m *
         ((1 - part) * integral(push_[row], depth) + part * integral(push_[row + 1], depth));
}

haptics::SoftTip soft_tip(const ForceTable& table, double lean_rad, double wetness, Feel feel) {
  const TuftForm& form = table.form();
  const SpineFriction friction = form.friction(std::isfinite(wetness) ? wetness : 0.0);
  const bool strong = feel == Feel::strengthened;
  const double times = strong ? kStrengthened : 1.0;
  haptics::SoftTip tip;
  tip.step_m = ForceTable::kDepthStep * form.hair_m;
  for (std::size_t i = 0; i < kDepths; ++i)
    tip.push_n.push_back(std::min(strong ? kMostStrengthened_n : kMostTrue_n,
                                  times * table.push_n(tip.step_m * static_cast<double>(i), lean_rad)));
  tip.friction = friction.paper;
  tip.along_hair = friction.along_hair;
  tip.sideways_n_m = times * kSideways * form.force_unit_n() / form.hair_m;
  tip.tow_m = kTow * form.hair_m;
  return tip;
}

}  // namespace nazori::brush
