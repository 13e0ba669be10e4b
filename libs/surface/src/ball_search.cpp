// SPDX-License-Identifier: Apache-2.0
#include "ball_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nazori::surface {
namespace {

constexpr float kNever = -1e30F;
constexpr double kFewSamples = 4;  // a ball of a smaller radius in cells covers few samples
constexpr int kBlock = 16;         // columns that are looked at together
constexpr double kFine = 1e-4;
constexpr double kMargin = 1e-3;  // for rounding
constexpr int kNewtonSteps = 10;

}  // namespace

BallSearch::BallSearch(const HeightMap& map, const SmoothSurface& surface, double radius, double steep,
                       double tolerance)
    : map_(map), surface_(surface), size_(map.size()), radius_(radius), steep_(steep), tolerance_(tolerance) {
  if (radius_ < kFewSamples)
    prepare_points();
  else
    prepare_samples();
}

float BallSearch::to_height(double cells) const {
  return static_cast<float>(std::clamp(cells / steep_, 0.0, 1.0));
}

void BallSearch::rows(int first, int last, std::span<float> out) const {
  if (radius_ >= kFewSamples) return rows_from_samples(first, last, out);
  const auto n = static_cast<std::size_t>(size_);
  for (int row = first; row < last; ++row)
    row_from_points(row, out.subspan(static_cast<std::size_t>(row - first) * n, n));
}

/// The height of the ball above a sample from a contact near (x, y): climbs by Newton's steps to where the
/// ball and the surface have the same slope. The unknown is the slope of the ball, which has no largest value
/// as the distance has.
double BallSearch::refined(int column, int row, double x, double y) const {
  const double dx = column - x, dy = row - y;
  const double start =
      1 / std::sqrt(std::max(1e-4 * radius_ * radius_, radius_ * radius_ - dx * dx - dy * dy));
  double px = dx * start, py = dy * start;
  double best = -std::numeric_limits<double>::infinity();
  double sx = 0, sy = 0;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const double tx = px + sx, ty = py + sy;
    const double w2 = 1 + tx * tx + ty * ty, part = radius_ / std::sqrt(w2);
    const CurvedPoint p = surface_.curved_at(column - part * tx, row - part * ty);
    const double height = p.height * steep_ + part - radius_;
    if (!(height > best)) {
      sx *= 0.25;
      sy *= 0.25;
      continue;
    }
    const bool done = height - best < kFine;
    best = height;
    if (done) break;
    px = tx;
    py = ty;
    const double fx = p.d_column * steep_ + px, fy = p.d_row * steep_ + py;
    // How the contact moves with the slope.
    const double mxx = part * (1 - px * px / w2), mxy = -part * px * py / w2, myy = part * (1 - py * py / w2);
    const double hxx = p.d_column_column * steep_, hxy = p.d_column_row * steep_, hyy = p.d_row_row * steep_;
    const double jxx = 1 - hxx * mxx - hxy * mxy, jxy = -hxx * mxy - hxy * myy;
    const double jyx = -hxy * mxx - hyy * mxy, jyy = 1 - hxy * mxy - hyy * myy;
    const double det = jxx * jyy - jxy * jyx;
    const bool hill = det > 1e-3 && jxx + jyy > 0;  // else along the slope, which always leads up
    sx = hill ? (jxy * fy - jyy * fx) / det : -fx;
    sy = hill ? (jyx * fx - jxx * fy) / det : -fy;
    const double moved = std::max(std::abs(mxx * sx + mxy * sy), std::abs(mxy * sx + myy * sy));
    if (moved < kMargin) break;
    if (moved > 1) {
      sx /= moved;
      sy /= moved;
    }
  }
  return best;
}

/// Points a quarter of the radius or half a cell apart, whatever is less.
void BallSearch::prepare_points() {
  steps_ = std::max(4, static_cast<int>(std::ceil(2 * radius_)));
  step_ = radius_ / steps_;
  for (int i = -steps_; i <= steps_; ++i) {
    const double at = i * step_;
    const int middle = static_cast<int>(std::floor(at + 0.5));
    const double u = at - middle;
    points_.push_back({middle - 1,
                       {static_cast<float>((0.5 - u) * (0.5 - u) / 2), static_cast<float>(0.75 - u * u),
                        static_cast<float>((0.5 + u) * (0.5 + u) / 2)}});
  }
}

void BallSearch::row_from_points(int row, std::span<float> out) const {
  const auto n = static_cast<std::size_t>(size_);
  const auto border = static_cast<std::size_t>(radius_) + 2;
  std::vector<float> line(n + 2 * border + 2), best(n, kNever);
  std::vector<std::int32_t> best_at(n, 0);
  const int side = 2 * steps_ + 1;
  std::vector<std::pair<std::size_t, std::size_t>> uneven;  // columns to look at, from and to
  for (int column = 0; column < size_; column += kBlock) {
    const int to = std::min(size_, column + kBlock);
    if (is_level(column, to, row)) {
      std::copy_n(map_.samples().begin() + row * size_ + column, to - column, out.begin() + column);
    } else if (!uneven.empty() && uneven.back().second == static_cast<std::size_t>(column)) {
      uneven.back().second = static_cast<std::size_t>(to);
    } else {
      uneven.emplace_back(column, to);
    }
  }
  if (uneven.empty()) return;
  for (int j = 0; j < side; ++j) {
    const Point& down = points_[static_cast<std::size_t>(j)];
    const auto samples = [&](int k) {
      return map_.samples().data() +
             static_cast<std::size_t>(std::clamp(row + down.first + k, 0, size_ - 1)) * n;
    };
    const float *a = samples(0), *b = samples(1), *c = samples(2);
    const auto scale = static_cast<float>(steep_);
    for (std::size_t x = 0; x < n; ++x)
      line[border + x] = scale * (down.of[0] * a[x] + down.of[1] * b[x] + down.of[2] * c[x]);
    std::fill_n(line.begin(), border, line[border]);
    std::fill(line.begin() + static_cast<std::ptrdiff_t>(border + n), line.end(), line[border + n - 1]);
    for (int i = 0; i < side; ++i) {
      const double left =
          radius_ * radius_ - step_ * step_ * ((i - steps_) * (i - steps_) + (j - steps_) * (j - steps_));
      if (left < 0) continue;
      const auto cap = static_cast<float>(std::sqrt(left) - radius_);
      const Point& along = points_[static_cast<std::size_t>(i)];
      const float u = along.of[0], v = along.of[1], w = along.of[2];
      const float* from = line.data() + static_cast<std::ptrdiff_t>(border) + along.first;
      const std::int32_t at = j * side + i;
      for (const auto& [begin, end] : uneven)
        for (std::size_t x = begin; x < end; ++x) {
          const float found = u * from[x] + v * from[x + 1] + w * from[x + 2] + cap;
          best_at[x] = found > best[x] ? at : best_at[x];
          best[x] = found > best[x] ? found : best[x];
        }
    }
  }
  for (const auto& [begin, end] : uneven)
    for (std::size_t x = begin; x < end; ++x) {
      const int column = static_cast<int>(x);
      if (best[x] >= static_cast<float>(steep_)) {  // on the plateau, than which nothing is higher
        out[x] = 1;
        continue;
      }
      const double found = refined(column, row, column + step_ * (best_at[x] % side - steps_),
                                   row + step_ * (best_at[x] / side - steps_));
      out[x] = to_height(std::max(found, static_cast<double>(best[x])));
    }
}

/// Whether all samples are the same that a ball above these columns of the row can touch.
bool BallSearch::is_level(int from, int to, int row) const {
  const int border = static_cast<int>(radius_) + 2;
  const int left = std::max(0, from - border), right = std::min(size_, to + border);
  const float level = map_.at(from, row);
  for (int y = std::max(0, row - border); y <= std::min(size_ - 1, row + border); ++y)
    for (int x = left; x < right; ++x)
      if (map_.at(x, y) != level) return false;
  return true;
}

}  // namespace nazori::surface
