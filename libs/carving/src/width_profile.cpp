// SPDX-License-Identifier: Apache-2.0
#include "width_profile.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace nazori::carving {
namespace {

/// The slope at a knot between two pieces of lengths h0, h1 with the slopes d0, d1: their weighted harmonic
/// mean, 0 at a peak.
double slope_between(double h0, double d0, double h1, double d1) {
  if (d0 * d1 <= 0) return 0;
  const double w0 = 2 * h1 + h0;
  const double w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// At an end the slope of the parabola through three knots, limited so that the curve stays monotone.
double slope_at_end(double h0, double d0, double h1, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  return d0 > 0 ? std::min(slope, 3 * d0) : std::max(slope, 3 * d0);
}

/// The slopes of one quantity, `Value` of a knot, written to `Slope` of each mark.
template <class Value, class Slope>
void find_slopes(const std::vector<WidthKnot>& knots, std::vector<BrushMark>& slopes, Value value,
                 Slope slope) {
  const std::size_t n = knots.size();
  const auto h = [&knots](std::size_t i) { return knots[i + 1].s - knots[i].s; };
  const auto d = [&](std::size_t i) { return (knots[i + 1].*value - knots[i].*value) / h(i); };
  if (n < 2) return;
  if (n == 2) {
    slopes[0].*slope = slopes[1].*slope = d(0);
    return;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) slopes[i].*slope = slope_between(h(i - 1), d(i - 1), h(i), d(i));
  slopes[0].*slope = slope_at_end(h(0), d(0), h(1), d(1));
  slopes[n - 1].*slope = slope_at_end(h(n - 2), d(n - 2), h(n - 3), d(n - 3));
}

}  // namespace

WidthProfile::WidthProfile(std::vector<WidthKnot> knots)
    : knots_(std::move(knots)), slopes_(knots_.size(), BrushMark{0, 0}) {
  assert(!knots_.empty());
  find_slopes(knots_, slopes_, &WidthKnot::half_width, &BrushMark::half_width);
  find_slopes(knots_, slopes_, &WidthKnot::depth, &BrushMark::depth);
}

BrushMark WidthProfile::at(double s) const {
  if (s <= knots_.front().s) return {knots_.front().half_width, knots_.front().depth};
  if (s >= knots_.back().s) return {knots_.back().half_width, knots_.back().depth};
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), s,
                                      [](double value, const WidthKnot& knot) { return value < knot.s; });
  const auto i = static_cast<std::size_t>(after - knots_.begin()) - 1;
  const WidthKnot& a = knots_[i];
  const WidthKnot& b = knots_[i + 1];
  const double h = b.s - a.s;
  const double t = (s - a.s) / h;
  const auto between = [h, t](double v0, double m0, double v1, double m1) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double value =
        v0 * (2 * t3 - 3 * t2 + 1) + m0 * h * (t3 - 2 * t2 + t) + v1 * (3 * t2 - 2 * t3) + m1 * h * (t3 - t2);
    return std::clamp(value, std::min(v0, v1), std::max(v0, v1));
  };
  return {between(a.half_width, slopes_[i].half_width, b.half_width, slopes_[i + 1].half_width),
          between(a.depth, slopes_[i].depth, b.depth, slopes_[i + 1].depth)};
}

double WidthProfile::usual_half_width() const {
  // Each piece counts with its length and the mean of its ends.
  std::vector<std::pair<double, double>> pieces;
  double length = 0;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const double piece = knots_[i + 1].s - knots_[i].s;
    pieces.emplace_back((knots_[i].half_width + knots_[i + 1].half_width) / 2, piece);
    length += piece;
  }
  std::sort(pieces.begin(), pieces.end());
  double before = 0;
  for (const auto& [half_width, piece] : pieces) {
    before += piece;
    if (before >= length / 2) return half_width;
  }
  return knots_.front().half_width;
}

}  // namespace nazori::carving
