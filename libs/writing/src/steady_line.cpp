// SPDX-License-Identifier: Apache-2.0
#include "steady_line.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {
namespace {

/// `count` points at equal steps; count >= 2.
std::vector<float> at_equal_steps(FlatLine line, float length, std::size_t count) {
  std::vector<float> result;
  result.reserve(2 * count);
  std::size_t i = 2;
  float before = 0;
  float piece = std::hypot(line[2] - line[0], line[3] - line[1]);
  for (std::size_t k = 0; k < count; ++k) {
    const float at = length * static_cast<float>(k) / static_cast<float>(count - 1);
    while (i + 3 < line.size() && before + piece < at) {
      before += piece;
      i += 2;
      piece = std::hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
    }
    const float t = piece > 0 ? std::clamp((at - before) / piece, 0.0F, 1.0F) : 0;
    result.push_back(line[i - 2] + t * (line[i] - line[i - 2]));
    result.push_back(line[i - 1] + t * (line[i + 1] - line[i - 1]));
  }
  return result;
}

}  // namespace

std::vector<float> steady_line(FlatLine line, float side) {
  constexpr float kPerSide = 40;  // points of a line as long as the side
  constexpr std::size_t kFewest = 3;
  constexpr std::size_t kMost = 48;
  constexpr std::size_t kMean = 4;  // points of the fine line for one
  if (line.size() < 4) return {line.begin(), line.end()};
  float left = line[0], right = line[0], top = line[1], bottom = line[1], length = 0;
  for (std::size_t i = 2; i + 1 < line.size(); i += 2) {
    left = std::min(left, line[i]);
    right = std::max(right, line[i]);
    top = std::min(top, line[i + 1]);
    bottom = std::max(bottom, line[i + 1]);
    length += std::hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
  }
  // A trembling line is longer than it looks, its box is not.
  const float reach = (right - left + bottom - top) / std::max(side, 1e-6F);
  const auto count = std::clamp(static_cast<std::size_t>(reach * kPerSide), kFewest, kMost);
  const auto fine = at_equal_steps(line, length, (count - 1) * kMean + 1);
  std::vector<float> result{fine[0], fine[1]};
  for (std::size_t k = 1; k + 1 < count; ++k) {
    float x = 0;
    float y = 0;
    for (std::size_t i = k * kMean - kMean; i <= k * kMean + kMean; ++i) {
      x += fine[2 * i] / (2 * kMean + 1);
      y += fine[2 * i + 1] / (2 * kMean + 1);
    }
    result.push_back(x);
    result.push_back(y);
  }
  result.insert(result.end(), fine.end() - 2, fine.end());
  return result;
}

}  // namespace nazori::writing
