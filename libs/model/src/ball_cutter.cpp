// SPDX-License-Identifier: Apache-2.0
#include "ball_cutter.h"

#include <algorithm>
#include <cmath>

namespace nazori::model {

// Between two samples the ball could touch a steep wall a little higher than at either of them.
BallCutter::BallCutter(const Plate& plate, double radius_mm)
    : columns_(2 * plate.columns() - 1),
      rows_(2 * plate.rows() - 1),
      step_mm_(plate.step_mm() / 2),
      radius_mm_(radius_mm) {
  heights_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  const auto face = static_cast<float>(plate.thickness_mm());
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const int c = column / 2;
      const int r = row / 2;
      const int c1 = c + column % 2;
      const int r1 = r + row % 2;
      heights_.push_back((plate.at(c, r) + plate.at(c1, r) + plate.at(c, r1) + plate.at(c1, r1)) / 4 - face);
    }
  }
}

double BallCutter::lowest_tip(PlatePoint at) const {
  const double u = at.x / step_mm_;
  const double v = at.y / step_mm_;
  if (u < 0 || v < 0 || u > columns_ - 1 || v > rows_ - 1) return 0;
  const double reach = radius_mm_ / step_mm_;
  const int first_row = std::max(0, static_cast<int>(std::ceil(v - reach)));
  const int last_row = std::min(rows_ - 1, static_cast<int>(v + reach));
  float highest = -1e9F;
  for (int row = first_row; row <= last_row; ++row) {
    const double dy = (row - v) * step_mm_;
    const double left = radius_mm_ * radius_mm_ - dy * dy;
    const double half = std::sqrt(std::max(0.0, left)) / step_mm_;
    const int first = std::max(0, static_cast<int>(std::ceil(u - half)));
    const int last = std::min(columns_ - 1, static_cast<int>(u + half));
    const float* const heights =
        heights_.data() + static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(columns_);
    const auto left_f = static_cast<float>(left);
    for (int column = first; column <= last; ++column) {
      const auto dx = static_cast<float>((column - u) * step_mm_);
      highest = std::max(highest, heights[column] + std::sqrt(std::max(0.0F, left_f - dx * dx)));
    }
  }
  return static_cast<double>(highest) - radius_mm_;
}

}  // namespace nazori::model
