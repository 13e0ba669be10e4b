// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/mill.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "ball_cutter.h"
#include "nazori/geometry/needed_points.h"
#include "nazori/geometry/polyline.h"

namespace nazori::model {
namespace {

constexpr double kKept_mm = 0.01;       // of material, for the straight pieces between the points of the way
constexpr double kDip_mm = 0.002;       // how much lower than that a straight piece may be
constexpr double kSimplify_mm = 0.002;  // how far from the way a point that is left out may be
constexpr double kAlong_mm = 0.25;      // between the points at which the depth is computed
constexpr double kShallow_mm = 0.02;    // what lies less deep is not worth a move
constexpr double kRoughStep = 0.8;      // of the radius, between the lines of the passes before the last
constexpr double kArcStep = 10 * std::numbers::pi / 180;
constexpr int kHalvings = 5;

base::Result<void> check(const MillSettings& s) {
  struct Limit {
    const char* what;
    double value, low, high;
  };
  const std::array<Limit, 7> limits{{{"cutter", s.cutter_mm, 0.2, 20},
                                     {"step over", s.step_over_mm, 0.02, 5},
                                     {"depth of a pass", s.pass_depth_mm, 0.05, 50},
                                     {"safe height", s.safe_mm, 1, 100},
                                     {"feed rate", s.feed_mm_min, 10, 20'000},
                                     {"plunge rate", s.plunge_mm_min, 10, 20'000},
                                     {"spindle speed", s.spindle_rpm, 0, 60'000}}};
  for (const Limit& limit : limits) {
    if (limit.value >= limit.low && limit.value <= limit.high) continue;
    return base::fail(base::Errc::bad_argument,
                      fmt::format("the {} cannot be {:.6g}", limit.what, limit.value), "mill",
                      fmt::format("give {:.6g} to {:.6g}", limit.low, limit.high));
  }
  return {};
}

PlatePoint left_of(PlatePoint from, PlatePoint to) {
  const PlatePoint along = (to - from) * (1 / geometry::distance(from, to));
  return {-along.y, along.x};
}

/// The line without repeated points and longer by `by` at both ends. A single point becomes a short line.
PlateLine extended(const PlateLine& given, double by) {
  PlateLine line;
  for (const PlatePoint p : given)
    if (line.empty() || geometry::distance(line.back(), p) > 1e-6) line.push_back(p);
  if (line.size() == 1) line.push_back(line.front() + PlatePoint{1e-3, 0});
  const auto beyond = [by](PlatePoint end, PlatePoint before) {
    return end + (end - before) * (by / geometry::distance(end, before));
  };
  line.insert(line.begin(), beyond(line[0], line[1]));
  line.push_back(beyond(line[line.size() - 1], line[line.size() - 2]));
  return line;
}

/// A line beside another one, to its left; around its outer corners it is an arc.
PlateLine beside(const PlateLine& line, double offset) {
  PlateLine made;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PlatePoint normal = left_of(line[i], line[i + 1]);
    made.push_back(line[i] + normal * offset);
    made.push_back(line[i + 1] + normal * offset);
    if (i + 2 == line.size()) continue;
    const PlatePoint next = left_of(line[i + 1], line[i + 2]);
    const double turn = std::atan2(normal.x * next.y - normal.y * next.x, geometry::dot(normal, next));
    if (turn * offset >= 0) continue;
    const double start = std::atan2(normal.y, normal.x);
    const int steps = static_cast<int>(std::abs(turn) / kArcStep);
    for (int k = 1; k <= steps; ++k) {
      const double angle = start + turn * k / (steps + 1);
      made.push_back(line[i + 1] + PlatePoint{std::cos(angle), std::sin(angle)} * offset);
    }
  }
  return made;
}

class PathMaker {
 public:
  PathMaker(const BallCutter& cutter, const MillSettings& settings) : cutter_(cutter), s_(settings) {
    path_.moves.push_back({0, 0, s_.safe_mm, MillMove::Speed::rapid});
  }

  /// One pass along a guide: lines side by side, to and fro.
  /// @param above  what lies higher than this was cut before. @param floor  the lowest height of this pass.
  void follow(const MillGuide& guide, double step, double above, double floor) {
    above_ = above;
    floor_ = floor;
    const PlateLine line = extended(guide.line, guide.half_width_mm);
    const int side = std::max(1, static_cast<int>(std::ceil(guide.half_width_mm / step)));
    for (int k = -side; k <= side; ++k) {
      PlateLine way = beside(line, guide.half_width_mm * k / side);
      if ((k + side) % 2 == 1) std::reverse(way.begin(), way.end());
      const double length = geometry::arc_length(std::span<const PlatePoint>(way));
      const auto count = static_cast<std::size_t>(length / kAlong_mm) + 2;
      bool before = false;
      for (const PlatePoint p : geometry::resample(std::span<const PlatePoint>(way), count)) {
        const double tip = cutter_.lowest_tip(p);
        const bool cuts = tip < above - kShallow_mm;
        if (cuts) {
          // A new line begins beside the end of the last one: the cutter stays in the groove.
          if (!before && !run_.empty() && geometry::distance(run_.back().at, p) > 2.5 * step) finish_run();
          append({p, std::max(tip + kKept_mm, floor)}, 0);
        }
        before = cuts;
      }
    }
    finish_run();
  }

  MillPath finish(int passes) {
    path_.passes = passes;
    return std::move(path_);
  }

 private:
  /// A point of the way in space.
  struct Station {
    PlatePoint at;
    double z = 0;
    friend Station operator+(Station a, Station b) { return {a.at + b.at, a.z + b.z}; }
    friend Station operator-(Station a, Station b) { return {a.at - b.at, a.z - b.z}; }
    friend Station operator*(Station a, double by) { return {a.at * by, a.z * by}; }
    friend double dot(Station a, Station b) { return geometry::dot(a.at, b.at) + a.z * b.z; }
    friend double distance(Station a, Station b) { return std::sqrt(dot(a - b, a - b)); }
  };

  [[nodiscard]] double height_at(PlatePoint p) const {
    return std::max(cutter_.lowest_tip(p) + kKept_mm, floor_);
  }
  /// Adds a station, and others before it where the straight piece would cut too deep.
  void append(const Station& to, int halvings) {
    if (!run_.empty() && halvings < kHalvings) {
      const Station from = run_.back();
      const auto dips = [&](double share) {
        const Station between = from * (1 - share) + to * share;
        return between.z < height_at(between.at) - kDip_mm;
      };
      if (dips(0.5) || dips(0.25) || dips(0.75)) {
        const PlatePoint middle = (from.at + to.at) * 0.5;
        append({middle, height_at(middle)}, halvings + 1);
        append(to, halvings + 1);
        return;
      }
    }
    run_.push_back(to);
  }

  void finish_run() {
    if (run_.empty()) return;
    using Speed = MillMove::Speed;
    const Station& first = run_.front();
    path_.moves.push_back({first.at.x, first.at.y, s_.safe_mm, Speed::rapid});
    path_.moves.push_back({first.at.x, first.at.y, first.z, Speed::plunge});
    path_.cut_length_mm += s_.safe_mm - first.z;
    path_.minutes += (s_.safe_mm - first.z) / s_.plunge_mm_min;
    const auto kept = geometry::needed_points(std::span<const Station>(run_), kSimplify_mm);
    for (std::size_t k = 1; k < kept.size(); ++k) {
      const Station& to = run_[kept[k]];
      const double length = distance(run_[kept[k - 1]], to);
      path_.cut_length_mm += length;
      path_.minutes += length / s_.feed_mm_min;
      path_.moves.push_back({to.at.x, to.at.y, to.z, Speed::feed});
    }
    for (const Station& station : run_) path_.deepest_mm = std::max(path_.deepest_mm, -station.z);
    const Station& last = run_.back();
    path_.moves.push_back({last.at.x, last.at.y, s_.safe_mm, Speed::rapid});
    run_.clear();
  }

  const BallCutter& cutter_;
  const MillSettings& s_;
  MillPath path_;
  std::vector<Station> run_;
  double above_ = 0;
  double floor_ = 0;
};

}  // namespace

base::Result<MillPath> mill_path(const Plate& plate, std::span<const MillGuide> guides,
                                 const MillSettings& settings) {
  if (auto fine = check(settings); !fine) return tl::unexpected(std::move(fine.error()));
  const BallCutter cutter(plate, settings.cutter_mm / 2);
  std::vector<MillGuide> all(guides.begin(), guides.end());
  if (all.empty()) {
    const double middle = plate.height_mm() / 2;
    all.push_back({{{0, middle}, {plate.width_mm(), middle}}, middle});
  }
  double deepest = 0;
  for (const MillGuide& guide : all) {
    const double length = geometry::arc_length(std::span<const PlatePoint>(guide.line));
    const auto count = static_cast<std::size_t>(length / kAlong_mm) + 2;
    for (const PlatePoint p : geometry::resample(std::span<const PlatePoint>(guide.line), count))
      deepest = std::min(deepest, cutter.lowest_tip(p));
  }
  if (guides.empty()) {
    const auto heights = plate.heights();
    deepest = static_cast<double>(*std::min_element(heights.begin(), heights.end())) - plate.thickness_mm();
  }
  const int passes = std::max(1, static_cast<int>(std::ceil(-deepest / settings.pass_depth_mm - 1e-6)));
  PathMaker maker(cutter, settings);
  const double rough = std::max(settings.step_over_mm, kRoughStep * settings.cutter_mm / 2);
  for (int pass = 1; pass < passes; ++pass)
    for (const MillGuide& guide : all)
      maker.follow(guide, rough, -(pass - 1) * settings.pass_depth_mm, -pass * settings.pass_depth_mm);
  for (const MillGuide& guide : all) maker.follow(guide, settings.step_over_mm, 0, -1e9);
  MillPath path = maker.finish(passes);
  if (path.cut_length_mm == 0) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a ball of {:.4g} mm fits into no groove", settings.cutter_mm), "mill",
                      "take a finer cutter or a larger tablet");
  }
  return path;
}

std::string to_gcode(const MillPath& path, const MillSettings& s, std::string_view name) {
  std::string safe_name;
  for (const char c : name)
    if (c >= ' ' && c <= '~' && c != '(' && c != ')' && c != ';' && c != '%') safe_name += c;
  std::string code = fmt::format(
      "(Nazori {})\n(Ball cutter {:.3f} mm, {} passes, about {:.0f} min)\n"
      "(Origin: lower left corner of the upper face)\nG21\nG90\nG17\nG94\nG0 Z{:.3f}\nM3 S{:.0f}\nG4 P2\n",
      safe_name, s.cutter_mm, path.passes, std::ceil(path.minutes), s.safe_mm, s.spindle_rpm);
  using Speed = MillMove::Speed;
  std::optional<Speed> speed;
  for (const MillMove& move : path.moves) {
    code += fmt::format("G{} X{:.3f} Y{:.3f} Z{:.3f}", move.speed == Speed::rapid ? 0 : 1, move.x, move.y,
                        move.z);
    if (move.speed != Speed::rapid && speed != move.speed) {
      code += fmt::format(" F{:.0f}", move.speed == Speed::plunge ? s.plunge_mm_min : s.feed_mm_min);
      speed = move.speed;
    }
    code += '\n';
  }
  return code + fmt::format("G0 Z{:.3f}\nM5\nG0 X0 Y0\nM30\n", s.safe_mm);
}

}  // namespace nazori::model
