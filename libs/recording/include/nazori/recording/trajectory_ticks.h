// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/recording/trajectory_csv.h"

namespace nazori::recording {

/// A trajectory as the ticks of a servo: its rows unchanged or, if a rate is given, points at that rate
/// interpolated linearly between the rows, from the first row's time to the last one's. Thread rules: one
/// thread.
class TrajectoryTicks {
 public:
  static constexpr double kLowestRate_hz = 20, kHighestRate_hz = 20'000;

  /// @param rate_hz  of the ticks; nothing: each row is a tick, and the rate is one over the median distance
  /// of the first kMeasured rows, rounded to a whole number where that is within 0.1 % of it (1000 for a
  /// single row).
  /// @return Errc::parse where this rate lies outside kLowestRate_hz..kHighestRate_hz; the errors of
  /// TrajectoryReader.
  [[nodiscard]] static base::Result<TrajectoryTicks> create(TrajectoryReader reader,
                                                            std::optional<double> rate_hz);

  [[nodiscard]] double rate_hz() const { return rate_hz_; }
  /// The next tick. @return false at the end; the errors of TrajectoryReader::next.
  [[nodiscard]] base::Result<bool> next(TrajectoryPoint& point);
  [[nodiscard]] double progress() const { return reader_.progress(); }

 private:
  static constexpr std::size_t kMeasured = 1001;

  explicit TrajectoryTicks(TrajectoryReader reader) : reader_(std::move(reader)) {}
  [[nodiscard]] base::Result<bool> next_row(TrajectoryPoint& point);

  TrajectoryReader reader_;
  double rate_hz_ = 1000;
  bool resampled_ = false;
  std::vector<TrajectoryPoint> ahead_;  // rows that were read to measure the rate
  std::size_t given_ = 0;               // of these
  TrajectoryPoint from_, to_;           // the rows before and after the tick
  double start_s_ = 0;
  std::uint64_t ticks_ = 0;
};

}  // namespace nazori::recording
