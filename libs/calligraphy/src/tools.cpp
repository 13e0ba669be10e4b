// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nazori::calligraphy {
namespace {

using paint::InkLoad;
using paint::TotalAmount;

constexpr TotalAmount kTipShare = 4;  // the tip is a quarter of the tuft, as in paint::dipped()
constexpr double kAssumedTilt_deg = 7;
constexpr double kMost_deg = 89;

struct Scale {
  int number;
  double scale;
};
constexpr std::array kScales{Scale{4, 1.0}, Scale{6, 1.0}, Scale{6, 0.62}, Scale{6, 0.44}};

void halve(InkLoad::Part& part) {
  part.water /= 2;
  for (TotalAmount& pigment : part.pigment) pigment /= 2;
}

/// So much water that the part is full, with ink of kOne of pigment in kOne of water.
void fill(InkLoad::Part& part, TotalAmount capacity, int slot) {
  const TotalAmount missing = std::max<TotalAmount>(capacity - part.water, 0);
  part.water += missing;
  if (slot >= 0) part.pigment[static_cast<std::size_t>(slot)] += missing;
}

}  // namespace

brush::TuftForm form_of(const BrushChoice& choice) {
  const Scale& size = kScales[static_cast<std::size_t>(choice.size)];
  brush::TuftForm form = brush::tuft_form(size.number, choice.hair).value();
  const double s = size.scale;
  form.shaft_m *= s;
  form.hair_m *= s;
  form.root_radius_m *= s;
  form.stiffness_n_m2 *= s * s;
  form.holds_m3 *= s * s * s;
  return form;
}

void dip_in_ink(InkLoad& load, int slot) {
  const TotalAmount tip = load.capacity / kTipShare;
  load.tip = {};
  fill(load.tip, tip, slot);
  fill(load.root, load.capacity - tip, slot);
}

void dip_in_water(InkLoad& load) {
  const TotalAmount tip = load.capacity / kTipShare;
  for (InkLoad::Part* part : {&load.tip, &load.root})
    for (TotalAmount& pigment : part->pigment) pigment /= 2;
  fill(load.tip, tip, -1);
  fill(load.root, load.capacity - tip, -1);
}

void wipe(InkLoad& load) {
  halve(load.tip);
  halve(load.root);
}

InkLoad moved_to_brush(const InkLoad& load, double capacity_m3) {
  InkLoad moved = paint::dipped(capacity_m3, 0, {}, {});
  if (load.capacity <= 0) return moved;
  const double ratio = static_cast<double>(moved.capacity) / static_cast<double>(load.capacity);
  if (moved.capacity == load.capacity) return load;
  const auto part = [ratio](const InkLoad::Part& from, InkLoad::Part& to) {
    const auto scaled = [ratio](TotalAmount amount) {
      return static_cast<TotalAmount>(static_cast<double>(amount) * ratio);
    };
    to.water = scaled(from.water);
    for (std::size_t k = 0; k < paint::kSlots; ++k) to.pigment[k] = scaled(from.pigment[k]);
  };
  part(load.tip, moved.tip);
  part(load.root, moved.root);
  return moved;
}

double strength_of(const InkLoad& load) {
  const TotalAmount water = load.tip.water + load.root.water;
  if (water <= 0) return 0;
  TotalAmount pigment = 0;
  for (std::size_t k = 0; k < paint::kSlots; ++k) pigment += load.tip.pigment[k] + load.root.pigment[k];
  return static_cast<double>(pigment) / static_cast<double>(water);
}

HolderTilt holder_tilt(double right_deg, double towards_learner_deg, bool mirrored) {
  const auto slope = [](double deg) {
    return std::tan(std::clamp(deg, -kMost_deg, kMost_deg) * std::numbers::pi / 180);
  };
  const double right = mirrored ? -slope(right_deg) : slope(right_deg);
  const double up = -slope(towards_learner_deg);
  return {std::atan(std::hypot(right, up)), std::atan2(up, right)};
}

HolderTilt assumed_tilt(bool mirrored) { return holder_tilt(kAssumedTilt_deg, kAssumedTilt_deg, mirrored); }

}  // namespace nazori::calligraphy
