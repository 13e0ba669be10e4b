// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "nazori/functions/plate.h"
#include "nazori/functions/tape.h"
#include "plate_settings.h"
#include "work_progress.h"

namespace nazori::functions {
namespace {

constexpr std::array<Variable, 2> kPlane{Variable::x, Variable::y};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// A box that may contain a pole is halved this often before the pole is accepted.
constexpr int kPoleDepth = 24;
// At most this many boxes are examined in one cell, because along a line of poles it would not end.
constexpr int kMostPoleBoxes = 2000;
// A gap is closed where the means of opposite values around it differ by less than this part of the range.
constexpr double kHealed = 0.02;
// If they differ by more than this it is a step, whatever their means are.
constexpr double kSteepest = 0.25;

/// Values of f on the samples of a plate, and the defects of each sample.
class SurfaceSampler {
 public:
  SurfaceSampler(const Expression& f, const Window& window, int size)
      : tape_(Tape::compile(std::array{f}, kPlane)),
        window_(window),
        size_(size),
        values_(tape_.size()),
        intervals_(tape_.size()) {}

  struct Sample {
    double value = kNaN;
    bool torn = false;  ///< a pole or an undefined point lies in the cell
  };

  double value(double u, double v) {
    tape_.evaluate<double>(std::array{window_.x(u), window_.y(v)}, values_);
    const double z = values_[tape_.output(0)];
    return std::isnan(z) ? kNaN : z;
  }

  /// Finds the samples whose cells may be torn: all for which intervals do not prove the opposite.
  void find_tears(std::vector<bool>& torn) { find_tears(torn, 0, 0, size_); }

  Sample sample(int row, int column, bool suspect) {
    const double h = 1.0 / size_;
    const double u = column * h;
    const double v = 1 - (row + 1) * h;
    Sample s;
    s.value = value(u + h / 2, v + h / 2);
    if (!suspect) return s;
    const Interval f = enclose(u, v, h);
    if (f.is_empty()) return {kNaN, true};
    if (has(f.cause, Cause::pole) && f.decoration == Decoration::partial) {
      pole_boxes_ = 0;
      s.torn = has_pole(u, v, h, 0);
    }
    if (std::isnan(s.value)) supersample(u, v, h, s);
    return s;
  }

  /// The highest or lowest value of the cell on a grid of 4 x 4, its border included, or the one in the
  /// middle where the surface is not proven continuous over the cell.
  double extreme(int row, int column, bool highest, double middle) {
    constexpr int kSteps = 4;
    const double h = 1.0 / size_;
    const double u = column * h;
    const double v = 1 - (row + 1) * h;
    const Interval f = enclose(u, v, h);
    if (!f.is_continuous() || !f.is_bounded()) return middle;
    double most = middle;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const double z = value(u + h * i / kSteps, v + h * j / kSteps);
        if (std::isfinite(z)) most = highest ? std::max(most, z) : std::min(most, z);
      }
    }
    return most;
  }

 private:
  void find_tears(std::vector<bool>& torn, int row, int column, int side) {
    if (row >= size_ || column >= size_) return;
    const double h = 1.0 / size_;
    const Interval f = enclose(column * h, 1 - (row + side) * h, side * h);
    if (f.decoration >= Decoration::defined && f.is_bounded()) return;
    if (side == 1) {
      torn[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(column)] = true;
      return;
    }
    const int half = (side + 1) / 2;
    for (const int r : {row, row + half}) {
      for (const int c : {column, column + half}) find_tears(torn, r, c, half);
    }
  }

  Interval enclose(double u, double v, double side) {
    // A cell owns its left and upper border: a pole on a corner belongs to one cell.
    const double hair = side * 1e-9;
    tape_.evaluate<Interval>(std::array{Interval(window_.x(u - hair), window_.x(u + side - hair)),
                                        Interval(window_.y(v + hair), window_.y(v + side + hair))},
                             intervals_);
    return intervals_[tape_.output(0)];
  }

  bool has_pole(double u, double v, double side, int depth) {
    const Interval f = enclose(u, v, side);
    if (f.is_empty() || !(has(f.cause, Cause::pole) && f.decoration == Decoration::partial)) return false;
    if (depth == kPoleDepth || ++pole_boxes_ > kMostPoleBoxes) return true;
    const double h = side / 2;
    return has_pole(u, v, h, depth + 1) || has_pole(u + h, v, h, depth + 1) ||
           has_pole(u, v + h, h, depth + 1) || has_pole(u + h, v + h, h, depth + 1);
  }

  /// If the middle of the cell is undefined, uses the height at the nearest defined point of the cell, so
  /// that the edge of a dome reaches down to its end.
  void supersample(double u, double v, double h, Sample& s) {
    constexpr int kSteps = 4;
    const double middle_u = u + h / 2;
    const double middle_v = v + h / 2;
    double nearest = std::numeric_limits<double>::infinity();
    PlatePoint at;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const PlatePoint p{u + h * i / kSteps, v + h * j / kSteps};
        const double off = std::hypot(p.u - middle_u, p.v - middle_v);
        if (off >= nearest || !std::isfinite(value(p.u, p.v))) continue;
        nearest = off;
        at = p;
      }
    }
    if (!std::isfinite(nearest)) return;
    double outside = 0;
    double inside = 1;
    for (int i = 0; i < 40; ++i) {
      const double share = (outside + inside) / 2;
      const bool defined =
          std::isfinite(value(middle_u + share * (at.u - middle_u), middle_v + share * (at.v - middle_v)));
      (defined ? inside : outside) = share;
    }
    s.value = value(middle_u + inside * (at.u - middle_u), middle_v + inside * (at.v - middle_v));
  }

  Tape tape_;
  Window window_;
  int size_;
  int pole_boxes_ = 0;
  std::vector<double> values_;
  std::vector<Interval> intervals_;
};

using Samples = std::vector<SurfaceSampler::Sample>;

/// Calls of(sample) for the undamaged ones among the eight neighbours. @return whether all calls return true.
template <class F>
bool all_around(const Samples& samples, int n, int row, int column, const F& of) {
  for (int r = std::max(0, row - 1); r <= std::min(n - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(n - 1, column + 1); ++c) {
      if (r == row && c == column) continue;
      const auto& s =
          samples[static_cast<std::size_t>(r) * static_cast<std::size_t>(n) + static_cast<std::size_t>(c)];
      if (!s.torn && !std::isnan(s.value) && !of(s.value)) return false;
    }
  }
  return true;
}

/// A peak or a pit gets its true height even if it is not in the middle of its cell: |x| + |y| reaches 0.
void keep_peaks(SurfaceSampler& sampler, Samples& samples, int n) {
  std::vector<std::pair<std::size_t, double>> better;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double z = samples[i].value;
    if (samples[i].torn || !std::isfinite(z)) continue;
    const int row = static_cast<int>(i) / n;
    const int column = static_cast<int>(i) % n;
    const bool peak = all_around(samples, n, row, column, [z](double other) { return other <= z; });
    const bool pit = all_around(samples, n, row, column, [z](double other) { return other >= z; });
    if (peak != pit) better.emplace_back(i, sampler.extreme(row, column, peak, z));
  }
  for (const auto& [i, z] : better) samples[i].value = z;
}

/// Where the surface is cut at an end of its range, every cell that reaches this end belongs to the plateau,
/// so that its edge is not felt half a cell too far in.
void widen_plateaus(SurfaceSampler& sampler, Samples& samples, int n, const HeightRange& range) {
  std::vector<std::pair<std::size_t, double>> better;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double z = samples[i].value;
    if (samples[i].torn || !(z > range.low && z < range.high)) continue;
    const int row = static_cast<int>(i) / n;
    const int column = static_cast<int>(i) % n;
    const bool high = !all_around(samples, n, row, column, [&](double other) { return other < range.high; });
    const bool low = !all_around(samples, n, row, column, [&](double other) { return other > range.low; });
    if (high == low) continue;
    const double most = sampler.extreme(row, column, high, z);
    if (high ? most >= range.high : most <= range.low) better.emplace_back(i, most);
  }
  for (const auto& [i, z] : better) samples[i].value = z;
}

HeightRange range_of(const Samples& samples) {
  std::vector<double> values;
  for (const auto& s : samples) {
    if (std::isfinite(s.value) && !s.torn) values.push_back(s.value);
  }
  if (values.empty()) return {-1, 1};
  // Poles would flatten everything else, so the outermost hundredths do not count if they lie far out.
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  double low = at(0);
  double high = at(1);
  const double core = at(0.98) - at(0.02);
  if (high - at(0.98) > 3 * core) high = at(0.98);
  if (at(0.02) - low > 3 * core) low = at(0.02);
  if (!(high > low)) return {low - 1, low + 1};
  return {low, high};
}

}  // namespace

base::Result<Plate> carve_surface(const Statement& surface, const Window& window,
                                  const PlateSettings& settings, const base::Progress& progress) {
  if (auto good = window.check(); !good) return tl::unexpected(std::move(good.error()));
  if (auto good = check(settings); !good) return tl::unexpected(std::move(good.error()));
  if (surface.kind != StatementKind::surface)
    return base::fail(base::Errc::bad_argument, "only a surface z = f(x, y) has heights", "statement");
  auto map = surface::HeightMap::create(settings.size, 0.0F);
  if (!map) return tl::unexpected(std::move(map.error()));
  WorkProgress work(progress);
  work.begin_part(0, 1, "surface");
  const int n = settings.size;
  SurfaceSampler sampler(surface.terms[0], window, n);
  Samples samples;
  samples.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  std::vector<bool> suspect(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), false);
  sampler.find_tears(suspect);
  for (int row = 0; row < n; ++row) {
    if (!work.report(static_cast<double>(row) / n))
      return base::fail(base::Errc::cancelled, "the carving was stopped");
    for (int column = 0; column < n; ++column) {
      samples.push_back(sampler.sample(row, column, suspect[samples.size()]));
    }
  }
  keep_peaks(sampler, samples, n);
  Plate plate;
  plate.range = settings.heights ? *settings.heights : range_of(samples);
  widen_plateaus(sampler, samples, n, plate.range);
  const double span = plate.range.high - plate.range.low;
  plate.heights = std::move(*map);
  plate.mask.assign(samples.size(), 0);
  plate.statement.assign(samples.size(), 0);

  const auto at = [n](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(column);
  };
  // A torn or undefined sample is a closed gap where the means of opposite whole samples two steps around
  // agree: a slope does not matter, a pole or a jump does.
  const auto healed = [&](int row, int column) -> std::optional<double> {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double low = kInfinity;
    double high = -kInfinity;
    double low_mean = kInfinity;
    double high_mean = -kInfinity;
    double sum = 0;
    int count = 0;
    for (int dr = -2; dr <= 2; ++dr) {
      for (int dc = -2; dc <= 2; ++dc) {
        const int r = row + dr;
        const int c = column + dc;
        if (r < 0 || c < 0 || r >= n || c >= n) continue;
        const auto& s = samples[at(r, c)];
        if (s.torn) continue;
        if (!std::isfinite(s.value)) return std::nullopt;
        low = std::min(low, s.value);
        high = std::max(high, s.value);
        const int other_row = row - dr;
        const int other_column = column - dc;
        double mean = s.value;
        if (other_row >= 0 && other_column >= 0 && other_row < n && other_column < n) {
          const auto& other = samples[at(other_row, other_column)];
          if (other.torn) continue;
          mean = (s.value + other.value) / 2;
        }
        low_mean = std::min(low_mean, mean);
        high_mean = std::max(high_mean, mean);
        sum += mean;
        ++count;
      }
    }
    if (count < 8 || high - low > kSteepest * span || high_mean - low_mean > kHealed * span)
      return std::nullopt;
    return sum / count;
  };
  const std::span<float> heights = plate.heights.samples();
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const std::size_t i = at(row, column);
      double z = samples[i].value;
      bool whole = !samples[i].torn && !std::isnan(z);
      if (!whole) {
        if (const auto closed = healed(row, column)) {
          whole = true;
          if (!std::isfinite(z)) z = *closed;
        }
      }
      plate.mask[i] = whole ? 255 : 0;
      plate.statement[i] = whole ? 1 : 0;
      if (!std::isnan(z)) heights[i] = static_cast<float>(std::clamp((z - plate.range.low) / span, 0.0, 1.0));
    }
  }
  return plate;
}

}  // namespace nazori::functions
