// SPDX-License-Identifier: Apache-2.0
#include "skeleton.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace nazori::author {
namespace {

/// The eight neighbours clockwise from the upper one.
constexpr std::array<Pixel, 8> kAround{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

/// Whether taking away a pixel with these neighbours leaves the lines connected over corners and the paper
/// connected over edges, as they were.
bool is_simple(unsigned around) {
  const auto set = [around](std::size_t k) { return (around >> (k % 8) & 1U) != 0; };
  // The number of connected parts of ink around it (Yokoi's number for ink that is connected over corners).
  int parts = 0;
  for (std::size_t k = 0; k < 8; k += 2) parts += !set(k) && (set(k + 1) || set(k + 2)) ? 1 : 0;
  return parts == 1;
}

std::array<bool, 256> make_table() {
  std::array<bool, 256> table{};
  for (unsigned around = 0; around < 256; ++around) table[around] = is_simple(around);
  return table;
}

}  // namespace

std::vector<std::uint8_t> middle_of(const DistanceMap& map) {
  // The chord between the two feet, in radii: 1.55 is an angle of 102 degrees, so a square corner has no line
  // into it. The feet of neighbours on one smooth outline are a pixel apart.
  constexpr double kChord = 1.55;
  constexpr double kApart = 1.2;
  std::vector<std::uint8_t> middle(map.distance.size());
  const auto compare = [&](int x, int y, int u, int v) {
    const std::size_t i = map.index(x, y);
    const std::size_t k = map.index(u, v);
    if (map.distance[i] <= 0 || map.distance[k] <= 0) return;
    const double dx = map.nearest[i].x - map.nearest[k].x;
    const double dy = map.nearest[i].y - map.nearest[k].y;
    const double chord = kApart + kChord * static_cast<double>(std::min(map.distance[i], map.distance[k]));
    if (dx * dx + dy * dy < chord * chord) return;
    // The one that is closer to the line of equal distances from both feet.
    const auto off = [&](int px, int py) {
      const double a = std::hypot(px - map.nearest[i].x, py - map.nearest[i].y);
      const double b = std::hypot(px - map.nearest[k].x, py - map.nearest[k].y);
      return std::abs(a - b);
    };
    middle[off(x, y) <= off(u, v) ? i : k] = 1;
  };
  for (int y = 0; y < map.side; ++y)
    for (int x = 0; x < map.side; ++x) {
      if (x + 1 < map.side) compare(x, y, x + 1, y);
      if (y + 1 < map.side) compare(x, y, x, y + 1);
    }
  return middle;
}

std::vector<std::uint8_t> thinned(std::vector<std::uint8_t> ink, int side, const std::vector<float>& height,
                                  const std::vector<std::uint8_t>& kept, bool keep_ends) {
  static const std::array<bool, 256> simple = make_table();
  constexpr std::size_t kLevels = 2048;
  float highest = 0;
  for (std::size_t i = 0; i < ink.size(); ++i)
    if (ink[i] != 0) highest = std::max(highest, height[i]);
  const float scale = highest > 0 ? static_cast<float>(kLevels - 1) / highest : 0.0F;
  const auto index = [side](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
  };
  const auto is_ink = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < side && y < side && ink[index(x, y)] != 0;
  };
  const auto around = [&](int x, int y) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 8; ++k)
      if (is_ink(x + kAround[k].x, y + kAround[k].y)) bits |= 1U << k;
    return bits;
  };
  std::vector<std::vector<Pixel>> waiting(kLevels);
  std::vector<std::uint8_t> is_waiting(ink.size());
  std::size_t level = 0;
  const auto wait = [&](int x, int y) {
    const std::size_t i = index(x, y);
    if (ink[i] == 0 || kept[i] != 0 || is_waiting[i] != 0) return;
    is_waiting[i] = 1;
    waiting[std::max(level, static_cast<std::size_t>(height[i] * scale))].push_back({x, y});
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (is_ink(x, y) && around(x, y) != 0xFFU) wait(x, y);
  for (; level < kLevels; ++level) {
    // The list grows while it is read: pixels of one height go in the order in which they became outline.
    for (std::size_t n = 0; n < waiting[level].size(); ++n) {
      const Pixel p = waiting[level][n];
      is_waiting[index(p.x, p.y)] = 0;
      const unsigned beside = around(p.x, p.y);
      if (!simple[beside] || (keep_ends && std::has_single_bit(beside))) continue;
      ink[index(p.x, p.y)] = 0;
      for (const Pixel e : kAround)
        if (is_ink(p.x + e.x, p.y + e.y)) wait(p.x + e.x, p.y + e.y);
    }
    waiting[level] = {};
  }
  return ink;
}

}  // namespace nazori::author
