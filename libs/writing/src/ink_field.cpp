// SPDX-License-Identifier: Apache-2.0
#include "ink_field.h"

#include <algorithm>
#include <cmath>

#include "ink_moments.h"

namespace nazori::writing {
namespace {

constexpr auto kCells = static_cast<int>(kFieldCells);

/// Distributes `length` cells of ink at a place among the four cells around it.
void add_mark(InkField& field, float x, float y, float length, const std::array<float, kFieldSlants>& share) {
  constexpr float kEdge = static_cast<float>(kCells) - 0.5F;
  x = std::clamp(x, 0.5F, kEdge) - 0.5F;
  y = std::clamp(y, 0.5F, kEdge) - 0.5F;
  const int column = std::min(static_cast<int>(x), kCells - 2);
  const int row = std::min(static_cast<int>(y), kCells - 2);
  const float fx = x - static_cast<float>(column);
  const float fy = y - static_cast<float>(row);
  const std::array<float, 4> corner{(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
  for (std::size_t q = 0; q < 4; ++q) {
    const auto cell = static_cast<std::size_t>((row + static_cast<int>(q / 2)) * kCells + column) + q % 2;
    for (std::size_t a = 0; a < kFieldSlants; ++a)
      field[cell * kFieldSlants + a] += length * corner[q] * share[a];
  }
}

/// Strokes this short are dots where nothing else is as near, as parts of `larger`, the spread of the ink.
constexpr float kDot = 0.5F;

float length_of(FlatLine line) {
  float sum = 0;
  for (std::size_t i = 2; i + 1 < line.size(); i += 2)
    sum += std::hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
  return sum;
}

/// A short stroke away from all others: the dot of an i. It would leave hardly any ink. A short piece of a
/// broken line is none.
bool is_dot(std::span<const FlatLine> strokes, std::size_t which, float reach) {
  const auto& dot = strokes[which];
  if (dot.size() < 2 || length_of(dot) > reach) return false;
  for (std::size_t k = 0; k < strokes.size(); ++k)
    for (std::size_t i = 0; k != which && i + 1 < strokes[k].size(); i += 2)
      if (std::hypot(strokes[k][i] - dot[0], strokes[k][i + 1] - dot[1]) < reach) return false;
  return true;
}

}  // namespace

InkField make_field(std::span<const FlatLine> strokes) {
  constexpr float kHalfWidth = 2.2F;     // of the field, in spreads
  constexpr float kMostSquashed = 0.6F;  // a flat character stays flat
  constexpr float kStep = 0.6F;          // cells between two marks
  constexpr float kHalfFull = 0.5F;      // cells of ink
  constexpr float kMiddle = static_cast<float>(kCells) / 2;
  const auto m = ink_moments(strokes);
  const float larger = std::max({m.spread_x, m.spread_y, 1e-6F});
  const float scale_x =
      static_cast<float>(kCells) / (2 * kHalfWidth * std::max(m.spread_x, kMostSquashed * larger));
  const float scale_y =
      static_cast<float>(kCells) / (2 * kHalfWidth * std::max(m.spread_y, kMostSquashed * larger));
  InkField field{};
  float ink = 0;
  for (std::size_t stroke = 0; stroke < strokes.size(); ++stroke) {
    const auto& s = strokes[stroke];
    if (is_dot(strokes, stroke, kDot * larger)) {
      constexpr float kInk = 0.4F;  // cells, in each slant
      add_mark(field, (s[0] - m.x) * scale_x + kMiddle, (s[1] - m.y) * scale_y + kMiddle, kInk, {1, 1, 1, 1});
    }
    for (std::size_t i = 2; i + 1 < s.size(); i += 2) {
      const float x0 = (s[i - 2] - m.x) * scale_x + kMiddle;
      const float y0 = (s[i - 1] - m.y) * scale_y + kMiddle;
      const float dx = (s[i] - s[i - 2]) * scale_x;
      const float dy = (s[i + 1] - s[i - 1]) * scale_y;
      const float length2 = dx * dx + dy * dy;
      if (length2 <= 1e-12F) continue;
      const float length = std::sqrt(length2);
      const float c = (dx * dx - dy * dy) / length2;
      const float d = 2 * dx * dy / length2;
      const std::array<float, kFieldSlants> share{std::max(c, 0.0F), std::max(d, 0.0F), std::max(-c, 0.0F),
                                                  std::max(-d, 0.0F)};
      const int marks = std::max(1, static_cast<int>(length / kStep + 0.5F));
      for (int k = 0; k < marks; ++k) {
        const float t = (static_cast<float>(k) + 0.5F) / static_cast<float>(marks);
        add_mark(field, x0 + dx * t, y0 + dy * t, length / static_cast<float>(marks), share);
      }
      ink += length;
    }
  }
  for (auto& v : field) v /= kHalfFull + v;
  const float slim = std::clamp(
      std::log((m.spread_x + 0.05F * larger + 1e-9F) / (m.spread_y + 0.05F * larger + 1e-9F)), -3.0F, 3.0F);
  field[kFieldSize] = slim;
  field[kFieldSize + 1] = std::abs(slim);
  field[kFieldSize + 2] = std::min(ink / 60, 4.0F);
  return field;
}

}  // namespace nazori::writing
