// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/trajectory_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::recording {
namespace {

constexpr double kNearlyWhole = 0.001;
constexpr double kRounding = 1e-6;  // of a period

double median_distance(const std::vector<TrajectoryPoint>& points) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < points.size(); ++i)
    distances.push_back(points[i].time_s - points[i - 1].time_s);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace

base::Result<TrajectoryTicks> TrajectoryTicks::create(TrajectoryReader reader,
                                                      std::optional<double> rate_hz) {
  TrajectoryTicks ticks(std::move(reader));
  ticks.resampled_ = rate_hz.has_value();
  const std::size_t wanted = rate_hz ? 1 : kMeasured;
  while (ticks.ahead_.size() < wanted) {
    TrajectoryPoint point;
    const auto more = ticks.reader_.next(point);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    ticks.ahead_.push_back(point);
  }
  if (rate_hz) {
    ticks.rate_hz_ = *rate_hz;
    ticks.from_ = ticks.to_ = ticks.ahead_.front();
    ticks.start_s_ = ticks.from_.time_s;
    ticks.given_ = 1;
    return ticks;
  }
  if (ticks.ahead_.size() < 2) return ticks;
  const double distance_s = median_distance(ticks.ahead_);
  const double measured = 1 / distance_s;
  // Rounded first: the times of rows at the highest rate are rounded, so a distance may be a little too
  // short.
  const double whole = std::round(measured);
  ticks.rate_hz_ = std::abs(measured - whole) <= kNearlyWhole * whole ? whole : measured;
  if (!(ticks.rate_hz_ >= kLowestRate_hz && ticks.rate_hz_ <= kHighestRate_hz)) {
    return base::fail(base::Errc::parse,
                      fmt::format("the rows are {:g} s apart, which is not the rate of a servo", distance_s),
                      "t", "give --rate 1000 to have points between them");
  }
  return ticks;
}

base::Result<bool> TrajectoryTicks::next_row(TrajectoryPoint& point) {
  if (given_ < ahead_.size()) {
    point = ahead_[given_++];
    return true;
  }
  return reader_.next(point);
}

base::Result<bool> TrajectoryTicks::next(TrajectoryPoint& point) {
  if (!resampled_) return next_row(point);
  const double time_s = start_s_ + static_cast<double>(ticks_) / rate_hz_;
  // Rounding must not lose the last tick.
  while (to_.time_s < time_s - kRounding / rate_hz_) {
    from_ = to_;
    auto more = next_row(to_);
    if (!more || !*more) return more;
  }
  const double whole = to_.time_s - from_.time_s;
  const double part = whole > 0 ? std::min(1.0, (time_s - from_.time_s) / whole) : 0;
  point.time_s = time_s;
  point.position_m = from_.position_m + part * (to_.position_m - from_.position_m);
  ++ticks_;
  return true;
}

}  // namespace nazori::recording
