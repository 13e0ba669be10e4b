// SPDX-License-Identifier: Apache-2.0
#include "distortion.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing::training {
namespace {

float apart(Spot a, Spot b) { return std::hypot(a.x - b.x, a.y - b.y); }

float length_of(const Line& line) {
  float sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += apart(line[i - 1], line[i]);
  return sum;
}

class Chance {
 public:
  explicit Chance(std::mt19937& random) : random_(random) {}
  /// Nearly normal: the sum of four numbers, which is several times faster than the standard library's.
  float normal(float deviation) {
    constexpr float kOneOfFour = 1.7320508F;
    return (part() + part() + part() + part() - 2) * kOneOfFour * deviation;
  }
  float between(float from, float to) { return from + (to - from) * part(); }
  bool happens(float probability) { return between(0, 1) < probability; }

 private:
  float part() { return static_cast<float>(random_() >> 8U) * 0x1p-24F; }

  std::mt19937& random_;
};

/// Leaves off a last part of at most 0.35 of the line that turns by more than 50 degrees.
void cut_hook(Line& line) {
  const auto n = line.size();
  if (n < 8) return;
  for (std::size_t i = n - 2; i > n - 1 - n * 35 / 100; --i) {
    const float ax = line[i].x - line[i - 2].x;
    const float ay = line[i].y - line[i - 2].y;
    const float bx = line[n - 1].x - line[i].x;
    const float by = line[n - 1].y - line[i].y;
    if (ax * bx + ay * by < 0.64F * std::hypot(ax, ay) * std::hypot(bx, by)) {
      line.resize(i + 1);
      return;
    }
  }
}

void lengthen(Line& line, float by_start, float by_end) {
  const auto n = line.size();
  const auto move = [&line](std::size_t end, std::size_t inner, float by) {
    const float d = std::max(apart(line[end], line[inner]), 1e-3F);
    line[end].x += (line[end].x - line[inner].x) / d * by;
    line[end].y += (line[end].y - line[inner].y) / d * by;
  };
  const auto cut = [&](bool at_end, float by) {
    const auto away = static_cast<std::size_t>(by / std::max(length_of(line), 1e-3F) * static_cast<float>(n));
    if (away == 0 || away + 4 > line.size()) return;
    if (at_end)
      line.resize(line.size() - away);
    else
      line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(away));
  };
  if (by_start > 0)
    move(0, 2, by_start);
  else
    cut(false, -by_start);
  if (by_end > 0)
    move(line.size() - 1, line.size() - 3, by_end);
  else
    cut(true, -by_end);
}

/// Rounds corners off: each point halfway to its neighbours, some times.
void smooth(Line& line, int times) {
  for (int k = 0; k < times; ++k) {
    Line copy = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      copy[i].x = (line[i - 1].x + 2 * line[i].x + line[i + 1].x) / 4;
      copy[i].y = (line[i - 1].y + 2 * line[i].y + line[i + 1].y) / 4;
    }
    line = std::move(copy);
  }
}

void distort_stroke(Line& line, float wild, Chance& chance) {
  const float length = length_of(line);
  const float loose = 1.5F + 0.06F * length;  // glyph units by which ends may be off
  if (chance.happens(0.4F * wild)) cut_hook(line);
  if (chance.happens(0.3F)) smooth(line, static_cast<int>(chance.between(1, 8)));
  if (length > 8) lengthen(line, chance.normal(loose * wild), chance.normal(loose * wild));
  Spot centre;
  for (const auto& p : line) {
    centre.x += p.x / static_cast<float>(line.size());
    centre.y += p.y / static_cast<float>(line.size());
  }
  const float turn = chance.normal(0.10F * wild);
  const float scale = std::exp(chance.normal(0.10F * wild));
  const float slender = std::exp(chance.normal(0.07F * wild));
  const float dx = chance.normal(3.0F * wild);
  const float dy = chance.normal(3.0F * wild);
  const float bow = chance.normal(0.045F * wild * length);
  const auto n = static_cast<float>(line.size() - 1);
  const Spot chord{line.back().x - line.front().x, line.back().y - line.front().y};
  const float chord_length = std::max(std::hypot(chord.x, chord.y), 1e-3F);
  const float c = std::cos(turn) * scale;
  const float s = std::sin(turn) * scale;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const float t = static_cast<float>(i) / n;
    const float b = 4 * t * (1 - t) * bow - bow * 0.667F;
    const float x = (line[i].x - centre.x - chord.y / chord_length * b) * slender;
    const float y = (line[i].y - centre.y + chord.x / chord_length * b) / slender;
    line[i] = {centre.x + dx + c * x - s * y, centre.y + dy + s * x + c * y};
  }
}

/// Slow waves over the whole picture move parts against each other.
void bend_all(Lines& lines, float wild, Chance& chance) {
  constexpr float kBox = 109;
  struct Wave {
    float kx, ky, phase, ax, ay;
  };
  std::vector<Wave> waves(4);
  for (auto& w : waves)
    w = {chance.normal(3.5F) / kBox, chance.normal(3.5F) / kBox, chance.between(0, 6.283F),
         chance.normal(1.8F * wild), chance.normal(1.8F * wild)};
  const float turn = chance.normal(0.08F * wild);
  const float slant = chance.normal(0.15F * wild);
  const float wide = std::exp(chance.normal(0.22F * wild));
  const float lean_x = chance.normal(0.10F * wild);  // perspective
  const float lean_y = chance.normal(0.10F * wild);
  for (auto& line : lines)
    for (auto& p : line) {
      float x = p.x;
      float y = p.y;
      for (const auto& w : waves) {
        const float v = std::sin(p.x * w.kx + p.y * w.ky + w.phase);
        x += v * w.ax;
        y += v * w.ay;
      }
      x = (x - kBox / 2) * wide;
      y = y - kBox / 2;
      const float far = 1 + (lean_x * x + lean_y * y) / (kBox / 2);
      x = (x + slant * y) * far;
      y *= far;
      p = {std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y};
    }
}

/// A trembling hand.
void tremble(Lines& lines, float amount, Chance& chance) {
  for (auto& line : lines) {
    float x = 0;
    float y = 0;
    for (auto& p : line) {
      x = 0.6F * x + chance.normal(amount);
      y = 0.6F * y + chance.normal(amount);
      p.x += x;
      p.y += y;
    }
  }
}

}  // namespace

Line resampled(const Line& line, int count) {
  Line result;
  const float length = length_of(line);
  std::size_t i = 1;
  float before = 0;
  for (int k = 0; k < count; ++k) {
    const float at = length * static_cast<float>(k) / static_cast<float>(count - 1);
    while (i + 1 < line.size() && before + apart(line[i - 1], line[i]) < at) {
      before += apart(line[i - 1], line[i]);
      ++i;
    }
    if (line.size() < 2) {
      result.push_back(line.front());
      continue;
    }
    const float piece = apart(line[i - 1], line[i]);
    const float t = piece > 0 ? std::clamp((at - before) / piece, 0.0F, 1.0F) : 0;
    result.push_back(
        {line[i - 1].x + t * (line[i].x - line[i - 1].x), line[i - 1].y + t * (line[i].y - line[i - 1].y)});
  }
  return result;
}

Lines distorted(const Lines& model, float wildness, std::mt19937& random) {
  Chance chance(random);
  Lines result = model;
  const auto n = result.size();
  // In crowded characters the strokes are smaller and their places tighter.
  const float crowd = wildness * std::clamp(2.2F / std::sqrt(static_cast<float>(n + 1)), 0.45F, 1.2F);
  for (auto& line : result) distort_stroke(line, crowd, chance);
  if (n >= 5 && chance.happens(0.06F))
    result.erase(result.begin() +
                 static_cast<std::ptrdiff_t>(chance.between(0, static_cast<float>(n) - 0.01F)));
  if (n >= 2 && chance.happens(0.15F)) {
    for (std::size_t k = 0; k + 1 < n && k + 1 < result.size(); ++k)
      if (chance.happens(0.3F)) result.push_back(resampled({result[k].back(), result[k + 1].front()}, 6));
  }
  if (chance.happens(0.04F)) {
    const Spot spot{chance.between(10, 100), chance.between(10, 100)};
    result.push_back(resampled({spot, {spot.x + chance.normal(4), spot.y + chance.normal(4)}}, 6));
  }
  bend_all(result, wildness, chance);
  if (chance.happens(0.7F)) tremble(result, chance.between(0, 0.7F * wildness), chance);
  return result;
}

}  // namespace nazori::writing::training
