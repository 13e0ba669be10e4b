// SPDX-License-Identifier: Apache-2.0
#include "remarks.h"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>

namespace nazori::scan {
namespace {

// Beyond these a remark is made; docs/worksheets.md says how much of real writing keeps them.
constexpr double kSmall = 0.7;
constexpr double kLarge = 1.25;
constexpr double kOff = 0.11;  // sides of the cell
constexpr double kLean_rad = 8 * std::numbers::pi / 180;
constexpr double kStrokeGone = 0.3;
constexpr double kStrokeShort = 0.7;
constexpr double kMuchExtra = 0.12;
// Ink is the character where so much of both is common.
constexpr double kMostMissing = 0.3;
constexpr double kMostExtra = 0.3;
constexpr double kMostApart = 0.45;  // both together

}  // namespace

std::vector<CellRemark> remarks_on(const writing::InkShape& shape) {
  std::vector<CellRemark> remarks;
  const auto note = [&](bool is_so, CellFlaw flaw, int stroke = 0) {
    if (is_so) remarks.push_back({flaw, stroke});
  };
  note(shape.size < kSmall, CellFlaw::small);
  note(shape.size > kLarge, CellFlaw::large);
  note(shape.offset_y < -kOff, CellFlaw::high);
  note(shape.offset_y > kOff, CellFlaw::low);
  note(shape.offset_x < -kOff, CellFlaw::left);
  note(shape.offset_x > kOff, CellFlaw::right);
  note(shape.lean_rad < -kLean_rad, CellFlaw::leans_left);
  note(shape.lean_rad > kLean_rad, CellFlaw::leans_right);
  for (std::size_t i = 0; i < shape.covered.size(); ++i) {
    const int stroke = static_cast<int>(i) + 1;
    note(shape.covered[i] < kStrokeGone, CellFlaw::missing_stroke, stroke);
    note(shape.covered[i] >= kStrokeGone && shape.covered[i] < kStrokeShort, CellFlaw::short_stroke, stroke);
  }
  note(shape.extra > kMuchExtra, CellFlaw::extra_ink);
  return remarks;
}

bool is_alike(const writing::InkShape& shape) {
  return shape.missing <= kMostMissing && shape.extra <= kMostExtra &&
         shape.missing + shape.extra <= kMostApart;
}

std::string explain(const CellRemark& remark) {
  switch (remark.flaw) {
    case CellFlaw::small:
      return "too small";
    case CellFlaw::large:
      return "too large";
    case CellFlaw::high:
      return "too high";
    case CellFlaw::low:
      return "too low";
    case CellFlaw::left:
      return "too far left";
    case CellFlaw::right:
      return "too far right";
    case CellFlaw::leans_left:
      return "leans to the left";
    case CellFlaw::leans_right:
      return "leans to the right";
    case CellFlaw::missing_stroke:
      return fmt::format("stroke {} is missing", remark.stroke);
    case CellFlaw::short_stroke:
      return fmt::format("stroke {} is too short", remark.stroke);
    case CellFlaw::extra_ink:
      return "has ink that belongs to no stroke";
  }
  return {};
}

}  // namespace nazori::scan
