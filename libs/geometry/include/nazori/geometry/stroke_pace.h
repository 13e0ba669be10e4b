// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nazori::geometry {

/// Minimum-jerk movement from rest to rest: the share of the distance that is covered after the share `t` of
/// the time. 0 for t <= 0, 1 for t >= 1; at both ends speed and acceleration are 0.
/// @source T. Flash, N. Hogan, The coordination of arm movements: an experimentally confirmed mathematical
/// model, J. Neuroscience 5(7), 1985.
[[nodiscard]] inline double minimum_jerk(double t) noexcept {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

/// How a hand paces a stroke: its position along the line at every moment. Every simulated movement of the
/// program uses this model, each with its own movements and rests. The teacher that guidance leads with
/// follows the speeds of the two-thirds power law. The brush that shows a character slows down at starts,
/// corners and stops. The simulated hand moves from rest to rest between corners.
///
/// Movements follow each other along the line, each from the end of the previous one. Lengths are arc lengths
/// from the start of the line in any one unit, times are seconds from the start of the pace, speeds are that
/// unit per second.
///
/// Thread-safe: the const functions. Real-time-safe: at(), speed_at() and functions that only return a
/// number; the functions that add movements allocate.
class StrokePace {
 public:
  /// The position of the hand at one moment.
  struct Moment {
    double along = 0;          ///< arc length
    std::size_t movement = 0;  ///< index of the last movement that has begun; also 0 before the first
  };

  /// The hand stays where it is. @param duration_s  >= 0.
  void rest(double duration_s) {
    assert(duration_s >= 0);
    duration_s_ += duration_s;
  }
  /// Moves on at a speed that changes linearly with the distance. A movement of length 0 takes no time, but
  /// speed_at() takes it into account.
  /// @param to  not before the end of the previous movement.  @param speed_from,speed_to  > 0.
  void move(double to, double speed_from, double speed_to) {
    const double way = to - length();
    const double gain = speed_to / speed_from - 1;
    const double growth = std::log1p(gain);
    // The integral of ds / v for a v that is linear in s.
    const double even_s = way / speed_from;
    add({.from = length(),
         .to = to,
         .begin_s = 0,
         .moving_s = gain == 0 ? even_s : even_s * (growth / gain),
         .speed_from = speed_from,
         .speed_to = speed_to,
         .growth = growth,
         .law = Law::given_speed});
  }
  /// Moves on at one speed. @param to  not before the end of the previous movement.  @param speed  > 0.
  void move(double to, double speed) { move(to, speed, speed); }
  /// Moves on from rest to rest with minimum jerk; see minimum_jerk().
  /// @param to  not before the end of the previous movement.  @param duration_s  > 0.
  void move_from_rest_to_rest(double to, double duration_s) {
    const double mean = (to - length()) / duration_s;
    add({.from = length(),
         .to = to,
         .begin_s = 0,
         .moving_s = duration_s,
         .speed_from = mean,
         .speed_to = mean,
         .growth = 0,
         .law = Law::minimum_jerk});
  }

  /// Whether there is no movement.
  [[nodiscard]] bool empty() const noexcept { return movements_.empty(); }
  /// The arc length at which the last movement ends.
  [[nodiscard]] double length() const noexcept { return empty() ? 0 : movements_.back().to; }
  /// Duration of all movements and rests.
  [[nodiscard]] double duration_s() const noexcept { return duration_s_; }
  /// Arc lengths at which the movement with this index begins and ends. @param movement  an existing index.
  [[nodiscard]] double begin_of(std::size_t movement) const noexcept { return movements_[movement].from; }
  [[nodiscard]] double end_of(std::size_t movement) const noexcept { return movements_[movement].to; }

  /// The position of the hand. Before the start it is 0, after the end length(), within rounding. O(log
  /// movements).
  [[nodiscard]] Moment at(double time_s) const noexcept {
    const auto after = std::upper_bound(movements_.begin(), movements_.end(), time_s,
                                        [](double t, const Movement& m) { return t < m.begin_s; });
    if (after == movements_.begin()) return {};
    const Movement& m = *(after - 1);
    const auto number = static_cast<std::size_t>(after - movements_.begin()) - 1;
    const double time = m.moving_s > 0 ? std::min((time_s - m.begin_s) / m.moving_s, 1.0) : 1.0;
    return {m.from + share_of(m, time) * (m.to - m.from), number};
  }
  /// The speed at an arc length, which is limited to 0..length(); 0 where there is no movement. For a
  /// movement from rest to rest this is its mean speed, because its speed is defined by time and not by
  /// position. O(log movements).
  [[nodiscard]] double speed_at(double along) const noexcept {
    const auto after = std::upper_bound(movements_.begin(), movements_.end(), along,
                                        [](double s, const Movement& m) { return s < m.from; });
    if (empty()) return 0;
    const Movement& m = after == movements_.begin() ? movements_.front() : *(after - 1);
    const double share = m.to > m.from ? std::clamp((along - m.from) / (m.to - m.from), 0.0, 1.0) : 0.0;
    return m.speed_from + share * (m.speed_to - m.speed_from);
  }

 private:
  enum class Law : std::uint8_t { given_speed, minimum_jerk };
  struct Movement {
    double from, to;           // arc lengths
    double begin_s, moving_s;  // a rest is the gap until the next one begins
    double speed_from, speed_to;
    double growth;  // logarithm of speed_to / speed_from
    Law law;
  };

  void add(Movement movement) {
    assert(movement.to >= movement.from);
    movement.begin_s = duration_s_;
    duration_s_ += movement.moving_s;
    movements_.push_back(movement);
  }
  /// The share of its distance that is covered after the share `time` of its duration.
  static double share_of(const Movement& m, double time) noexcept {
    if (m.law == Law::minimum_jerk) return geometry::minimum_jerk(time);
    return m.growth == 0 ? time : std::expm1(m.growth * time) / (m.speed_to / m.speed_from - 1);
  }

  std::vector<Movement> movements_;
  double duration_s_ = 0;
};

}  // namespace nazori::geometry
