// SPDX-License-Identifier: Apache-2.0
#include "shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nazori::writing {
namespace {

/// Coordinates are at most 1e9: hypot is not needed.
double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// A line with the length from its start to each point.
struct Measured {
  std::span<const double> xs;
  std::span<const double> ys;
  std::vector<double> along;

  Measured(std::span<const double> x, std::span<const double> y) : xs(x), ys(y), along(x.size(), 0.0) {
    for (std::size_t i = 1; i < xs.size(); ++i)
      along[i] = along[i - 1] + length_of(xs[i] - xs[i - 1], ys[i] - ys[i - 1]);
  }
  [[nodiscard]] double length() const { return along.back(); }

  /// Samples of the part from `begin` to `end`, lengths along the line.
  [[nodiscard]] Samples part(double begin, double end) const {
    Samples out;
    const std::size_t last = along.size() - 1;
    const double step = (end - begin) / static_cast<double>(kSamples - 1);
    std::size_t k = 0;
    for (std::size_t i = 0; i < std::max<std::size_t>(last, 1) && k < kSamples; ++i) {
      const std::size_t j = std::min(i + 1, last);
      const double segment = along[j] - along[i];
      const double inverse = segment > 0 ? 1 / segment : 0;
      const double dx = xs[j] - xs[i];
      const double dy = ys[j] - ys[i];
      for (; k < kSamples; ++k) {
        const double s = begin + step * static_cast<double>(k);
        if (s > along[j] && j < last) break;
        const double t = std::clamp((s - along[i]) * inverse, 0.0, 1.0);
        out.x[k] = static_cast<float>(xs[i] + dx * t);
        out.y[k] = static_cast<float>(ys[i] + dy * t);
      }
    }
    out.length = static_cast<float>(end - begin);
    out.find_centre();
    return out;
  }
};

float polyline_length(const Samples& s) {
  float length = 0;
  for (std::size_t k = 1; k < kSamples; ++k) {
    const float dx = s.x[k] - s.x[k - 1];
    const float dy = s.y[k] - s.y[k - 1];
    length += std::sqrt(dx * dx + dy * dy);
  }
  return length;
}

/// Length from the start to the corner where a hook begins; nullopt if there is none.
std::optional<double> kick_start(const Samples& s) {
  constexpr std::size_t kLongestKick = 7;  // of 23 steps
  constexpr float kCosine = 0.57F;         // 55 degrees
  float sharpest = kCosine;
  std::optional<std::size_t> corner;
  for (std::size_t k = kSamples - 1 - kLongestKick; k + 1 < kSamples; ++k) {
    const float bx = s.x[k] - s.x[k - 3];
    const float by = s.y[k] - s.y[k - 3];
    const float ex = s.x[kSamples - 1] - s.x[k];
    const float ey = s.y[kSamples - 1] - s.y[k];
    const float size = std::sqrt((bx * bx + by * by) * (ex * ex + ey * ey));
    if (size <= 0) continue;
    const float cosine = (bx * ex + by * ey) / size;
    if (cosine < sharpest) {
      sharpest = cosine;
      corner = k;
    }
  }
  if (!corner) return std::nullopt;
  return static_cast<double>(s.length) * static_cast<double>(*corner) / static_cast<double>(kSamples - 1);
}

}  // namespace

void Samples::find_centre() {
  centre_x = std::accumulate(x.begin(), x.end(), 0.0F) / static_cast<float>(kSamples);
  centre_y = std::accumulate(y.begin(), y.end(), 0.0F) / static_cast<float>(kSamples);
  inertia = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const float dx = x[k] - centre_x;
    const float dy = y[k] - centre_y;
    inertia += dx * dx + dy * dy;
  }
}

void Samples::smooth(int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    const auto raw_x = x;
    const auto raw_y = y;
    for (std::size_t k = 1; k + 1 < kSamples; ++k) {
      x[k] = 0.25F * raw_x[k - 1] + 0.5F * raw_x[k] + 0.25F * raw_x[k + 1];
      y[k] = 0.25F * raw_y[k - 1] + 0.5F * raw_y[k] + 0.25F * raw_y[k + 1];
    }
  }
  length = polyline_length(*this);
  find_centre();
}

Samples transformed(const Samples& samples, const Affine& map) {
  Samples out;
  const auto a = static_cast<float>(map.a);
  const auto b = static_cast<float>(map.b);
  const auto c = static_cast<float>(map.c);
  const auto d = static_cast<float>(map.d);
  const auto tx = static_cast<float>(map.tx);
  const auto ty = static_cast<float>(map.ty);
  for (std::size_t k = 0; k < kSamples; ++k) {
    out.x[k] = a * samples.x[k] + b * samples.y[k] + tx;
    out.y[k] = c * samples.x[k] + d * samples.y[k] + ty;
  }
  out.length = polyline_length(out);
  out.find_centre();
  return out;
}

Shape transformed(const Shape& shape, const Affine& map) {
  Shape out;
  out.whole = transformed(shape.whole, map);
  if (shape.body) out.body = transformed(*shape.body, map);
  out.kicked = shape.kicked;
  return out;
}

Samples sample_line(std::span<const double> xs, std::span<const double> ys) {
  const Measured line(xs, ys);
  return line.part(0, line.length());
}

Shape make_shape(std::span<const double> xs, std::span<const double> ys) {
  const Measured line(xs, ys);
  Shape out;
  out.whole = line.part(0, line.length());
  if (const auto corner = kick_start(out.whole)) {
    out.body = line.part(0, *corner);
    out.kicked = true;
  }
  // After the search for corners; for both model and ink, so that rounded corners are compared with rounded
  // corners.
  constexpr int kPasses = 2;
  out.whole.smooth(kPasses);
  if (out.body) out.body->smooth(kPasses);
  return out;
}

Shape joined(const Samples& first, const Samples& second) {
  std::array<double, 2 * kSamples> xs{};
  std::array<double, 2 * kSamples> ys{};
  for (std::size_t k = 0; k < kSamples; ++k) {
    xs[k] = static_cast<double>(first.x[k]);
    ys[k] = static_cast<double>(first.y[k]);
    xs[kSamples + k] = static_cast<double>(second.x[k]);
    ys[kSamples + k] = static_cast<double>(second.y[k]);
  }
  return make_shape(xs, ys);
}

}  // namespace nazori::writing
