// SPDX-License-Identifier: Apache-2.0
// The search for a ball that covers many samples.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ball_search.h"

namespace nazori::surface {
namespace {

constexpr float kNever = -1e30F;
constexpr int kManySamples = 200;  // more balls that may touch a sample are looked at row by row
constexpr int kBlock = 16;         // columns that are looked at together
constexpr int kWay = 1 << 16;      // from a contact to its ball: rows times this, and columns
constexpr double kSmooth = 32;     // on a ball of a larger radius three points are almost a parabola
constexpr double kMargin = 1e-3;   // for rounding

/// The largest whole number that is not above `value`, without a call.
inline int whole(float value) {
  const int cut = static_cast<int>(value);
  return cut - (value < static_cast<float>(cut) ? 1 : 0);
}

inline float sine(float slope) { return slope / std::sqrt(1 + slope * slope); }

}  // namespace

void BallSearch::prepare_samples() {
  reach_ = static_cast<int>(radius_);
  refines_ = loss(0.5 * radius_ * radius_) > tolerance_;
  // loss() falls: below this it is more than the tolerance.
  double low = 0, high = radius_ * radius_ + 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (loss(middle) < tolerance_ ? high : low) = middle;
  }
  refined_below_ = high;
  for (int y = 0; y <= reach_; ++y)
    for (int x = -reach_; x <= reach_; ++x) {
      const double left = radius_ * radius_ - x * x - y * y;
      cap_.push_back(left >= 0 ? static_cast<float>(std::sqrt(left) - radius_) : kNever);
    }
}

/// The surface at the samples of the rows that can touch a ball above the band [cells].
void BallSearch::measure(Band& band) const {
  const auto n = static_cast<std::size_t>(size_);
  band.z_first = std::max(0, band.first - reach_ - 1);
  const int last = std::min(size_, band.last + reach_ + 1);
  band.z.resize(static_cast<std::size_t>(last - band.z_first) * n);
  std::vector<float> line(n);
  const auto scale = static_cast<float>(steep_ / 64);
  for (int row = band.z_first; row < last; ++row) {
    const float* here = map_.samples().data() + static_cast<std::ptrdiff_t>(row) * size_;
    const float* above = row > 0 ? here - n : here;
    const float* below = row + 1 < size_ ? here + n : here;
    for (std::size_t x = 0; x < n; ++x) line[x] = scale * (above[x] + 6 * here[x] + below[x]);
    float* z = band.z.data() + static_cast<std::ptrdiff_t>(row - band.z_first) * size_;
    z[0] = 7 * line[0] + line[1];
    for (std::size_t x = 1; x + 1 < n; ++x) z[x] = line[x - 1] + 6 * line[x] + line[x + 1];
    z[n - 1] = line[n - 2] + 7 * line[n - 1];
  }
}

/// Offers the sample as contact to balls of one row relative to it, within the band and the map.
inline void BallSearch::offer_row(Band& band, int column, int row, int y, int left, int right) const {
  const float height = band.row(row, size_)[column];
  const float* cap = cap_.data() + (y < 0 ? -y : y) * (2 * reach_ + 1) + reach_;
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row + y - band.first) * size_ + column;
  float* best = band.height.data() + at;
  if (refines_) {
    std::int32_t* contact = band.contact.data() + at;
    for (int x = left; x <= right; ++x) {
      const float found = height + cap[x];
      if (found > best[x]) {
        best[x] = found;
        contact[x] = y * kWay + x;
      }
    }
  } else {
    for (int x = left; x <= right; ++x) best[x] = std::max(best[x], height + cap[x]);
  }
}

/// Offers the sample as contact to the balls above a rectangle relative to it.
inline void BallSearch::offer(Band& band, int column, int row, int top, int bottom, int left,
                              int right) const {
  top = std::max(top, band.first - row);
  bottom = std::min(bottom, band.last - 1 - row);
  left = std::max(left, -column);
  right = std::min(right, size_ - 1 - column);
  for (int y = top; y <= bottom; ++y) offer_row(band, column, row, y, left, right);
}

/// Offers it to the balls above a box that stands on a corner: the sum of column and row is twice its
/// `right`, their difference twice its `down`.
inline void BallSearch::offer_turned(Band& band, int column, int row, const Region& at) const {
  const int west = std::max(-reach_, -column), east = std::min(reach_, size_ - 1 - column);
  const int top = std::max({-reach_, band.first - row, -whole(-at.left - at.top)});
  const int bottom = std::min({reach_, band.last - 1 - row, whole(at.right + at.bottom)});
  for (int y = top; y <= bottom; ++y) {
    const auto way = static_cast<float>(y);
    const int left = -whole(std::min(way - 2 * at.left, 2 * at.bottom - way));
    const int right = whole(std::min(2 * at.right - way, way - 2 * at.top));
    offer_row(band, column, row, y, std::max(left, west), std::min(right, east));
  }
}

/// Offers the sample to all balls for which it is higher than its neighbours in the row, row by row.
void BallSearch::spread_rows(Band& band, int column, int row, const Slopes& s) const {
  const double r2 = radius_ * radius_;
  // How far to the right the sample is higher than its neighbour there, with `slope` between the two: up to
  // the right end of the chord of that slope and a width of one cell. A circle without such a chord is too
  // small for the slope: it touches the higher of the two wherever it reaches it.
  const auto limit = [](double rho2, double slope) {
    const double rho = std::sqrt(rho2);
    if (slope * slope >= 2 * rho - 1) return slope < 0 ? rho : 1 - rho;
    return 0.5 - slope / std::sqrt(1 + slope * slope) * std::sqrt(rho2 - (1 + slope * slope) / 4);
  };
  // The largest limit of all circles from `least2` on.
  const auto farthest = [&](double least2, double slope) {
    return slope < 0 ? std::max(limit(r2, slope), std::min(radius_, (1 + slope * slope) / 2))
                     : limit(least2, slope);
  };
  const double across = std::min(radius_, std::max({1.0, farthest(0, s.right), farthest(0, -s.left)}));
  const double least2 = r2 - across * across;
  const int bottom = std::min(reach_, static_cast<int>(std::floor(farthest(least2, s.down) + kMargin)));
  const int top = std::max(-reach_, static_cast<int>(std::ceil(-farthest(least2, -s.up) - kMargin)));
  for (int y = top; y <= bottom; ++y) {
    const double rho2 = r2 - y * y;
    offer(band, column, row, y, y,
          std::max(-reach_, static_cast<int>(std::ceil(-limit(rho2, -s.left) - kMargin))),
          std::min(reach_, static_cast<int>(std::floor(limit(rho2, s.right) + kMargin))));
  }
}

/// Whether the samples of a block have the height of all their neighbours.
inline bool is_flat(const float* above, const float* here, const float* below) {
  int differ = 0;
  for (int x = 0; x < kBlock; ++x)
    differ |= static_cast<int>(above[x] != here[x]) | static_cast<int>(below[x] != here[x]) |
              static_cast<int>(here[x - 1] != here[x]) | static_cast<int>(here[x + 1] != here[x]);
  return differ == 0;
}

BallSearch::Region BallSearch::region_of(const Slopes& s, float r) {
  // Where balls touch that have the slopes of one corner; four roots at once.
  const float u2[4] = {s.left * s.left, s.left * s.left, s.right * s.right, s.right * s.right};
  const float v2[4] = {s.up * s.up, s.down * s.down, s.up * s.up, s.down * s.down};
  float over[4];
  for (int i = 0; i < 4; ++i) over[i] = r / std::sqrt(1 + u2[i] + v2[i]);
  const float lu = over[0], ld = over[1], ru = over[2], rd = over[3];
  float left = std::min(-s.left * lu, -s.left * ld), right = std::max(-s.right * ru, -s.right * rd);
  float top = std::min(-s.up * lu, -s.up * ru), bottom = std::max(-s.down * ld, -s.down * rd);
  if (s.up * s.down < 0) {
    left = std::min(left, -r * sine(s.left));
    right = std::max(right, -r * sine(s.right));
  }
  if (s.left * s.right < 0) {
    top = std::min(top, -r * sine(s.up));
    bottom = std::max(bottom, -r * sine(s.down));
  }
  // Half a cell to each side, which is more the more the ball leans both ways, to the first order; and what
  // the second order adds, as a part of the height of the ball's middle.
  const float u = std::max(std::abs(s.left), std::abs(s.right)),
              v = std::max(std::abs(s.up), std::abs(s.down));
  const float w = 1 + u * u + v * v, half = 0.5F / w;
  const float across = half * (1 + v * v) * (1 + u * u + u * v),
              along = half * (1 + u * u) * (1 + v * v + u * v);
  const float part = std::max(across, along) * std::sqrt(w) / r;
  const float added = 0.05F + std::min(0.3F, 3 * part), times = 1 + 0.8F * part;
  return {left - times * across - added, right + times * across + added, top - times * along - added,
          bottom + times * along + added, part < 1};
}

/// Every sample is offered only to balls for which it is higher than its four neighbours: on an even slope to
/// about one, on a ridge to all that can touch it, in a groove narrower than the ball to none.
void BallSearch::spread(Band& band) const {
  const auto r = static_cast<float>(radius_);
  const int from = std::max(0, band.first - reach_), to = std::min(size_, band.last + reach_);
  for (int row = from; row < to; ++row) {
    const float* middle = band.row(row, size_);
    const float* above = row > 0 ? middle - size_ : middle;
    const float* below = row + 1 < size_ ? middle + size_ : middle;
    for (int column = 0; column < size_; ++column) {
      if (column % kBlock == 1 && column + kBlock < size_ &&
          is_flat(above + column, middle + column, below + column)) {
        column += kBlock - 1;
        continue;
      }
      const float here = middle[column];
      const Slopes s{here - middle[column > 0 ? column - 1 : 0],
                     middle[column + 1 < size_ ? column + 1 : column] - here, here - above[column],
                     below[column] - here};
      if (s.left == 0 && s.right == 0 && s.up == 0 && s.down == 0) continue;  // only the ball straight above
      // Where both slopes are large the four neighbours leave much to be tried along the side of the ball;
      // the four neighbours across the corners leave little.
      const float u = std::abs(s.left + s.right), v = std::abs(s.up + s.down);
      const bool inside = column > 0 && column + 1 < size_ && row > 0 && row + 1 < size_;
      const auto at_most = [this](float way) { return std::clamp(whole(way), -reach_, reach_); };
      if (inside && u * v > 4 && 2 * u * v > std::abs(u * u - v * v)) {
        constexpr float kTurned = std::numbers::sqrt2_v<float> / 2;
        const Region at =
            region_of({kTurned * (here - above[column - 1]), kTurned * (below[column + 1] - here),
                       kTurned * (here - above[column + 1]), kTurned * (below[column - 1] - here)},
                      kTurned * r);
        if (at.is_empty()) continue;
        if (at.is_sure && 2 * (at.right - at.left) * (at.bottom - at.top) < kManySamples) {
          offer_turned(band, column, row, at);
          continue;
        }
      } else {
        const Region at = region_of(s, r);
        if (at.is_empty()) continue;
        if (at.is_sure && (at.right - at.left) * (at.bottom - at.top) < kManySamples) {
          offer(band, column, row, -at_most(-at.top), at_most(at.bottom), -at_most(-at.left),
                at_most(at.right));
          continue;
        }
      }
      spread_rows(band, column, row, s);
    }
  }
}

void BallSearch::rows_from_samples(int first, int last, std::span<float> out) const {
  Band band{first, last, 0, {}, {}, {}};
  measure(band);
  band.height.assign(band.row(first, size_), band.row(first, size_) + out.size());
  if (refines_) band.contact.resize(band.height.size());
  spread(band);
  const auto scale = static_cast<float>(1 / steep_);
  for (std::size_t i = 0; i < band.height.size(); ++i)
    out[i] = std::clamp(scale * band.height[i], 0.0F, 1.0F);
  if (!refines_) return;
  std::size_t i = 0;
  for (int row = first; row < last; ++row)
    for (int column = 0; column < size_; ++column, ++i) {
      if (out[i] == 1) continue;
      const int dx = static_cast<std::int16_t>(band.contact[i]), dy = (band.contact[i] - dx) / kWay;
      const int x = column - dx, y = row - dy;
      const double left = radius_ * radius_ - dx * dx - dy * dy;
      if (left > refined_below_) continue;
      const bool inside = x > 0 && y > 0 && x + 1 < size_ && y + 1 < size_;
      if (radius_ > kSmooth && left > kSmooth * kSmooth && inside)
        out[i] = to_height(static_cast<double>(band.height[i]) + gain(band, x, y, dx, dy));
      else
        out[i] = std::max(out[i], to_height(refined(column, row, x, y)));
    }
}

/// How much lower the nearest sample can be than a contact half a cell away along both axes, where the square
/// of the height of the ball's middle above the contact is `left`.
double BallSearch::loss(double left) const { return (radius_ * radius_ / left + 1) / (8 * std::sqrt(left)); }

/// What the contact of a large ball gains where it lies between the samples: the top of a paraboloid. The
/// sample is not at the edge.
double BallSearch::gain(const Band& band, int x, int y, int dx, int dy) const {
  if (std::max(std::abs(dx), std::abs(dy)) >= reach_) return 0;
  const float* z = band.row(y, size_) + x;
  const auto at = [&](int i, int j) {
    const int across = dx - i, down = dy - j;
    return static_cast<double>(
        z[static_cast<std::ptrdiff_t>(j) * size_ + i] +
        cap_[static_cast<std::size_t>((down < 0 ? -down : down) * (2 * reach_ + 1) + reach_ + across)]);
  };
  const double here = at(0, 0), east = at(1, 0), west = at(-1, 0), south = at(0, 1), north = at(0, -1);
  const double gx = (east - west) / 2, gy = (south - north) / 2;
  const double axx = 2 * here - east - west, ayy = 2 * here - south - north;
  const double axy = (at(1, -1) + at(-1, 1) - at(1, 1) - at(-1, -1)) / 4;
  const double det = axx * ayy - axy * axy;
  if (!(axx > 0 && det > 0.1 * axx * ayy)) return 0;
  return std::clamp((ayy * gx * gx - 2 * axy * gx * gy + axx * gy * gy) / (2 * det), 0.0,
                    0.125 * (axx + ayy));
}

}  // namespace nazori::surface
