// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/plate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nazori/geometry/polyline.h"

namespace nazori::model {
namespace {

// (1 - x^2)^2 is one half here: the foot of a line is this much farther out than its half height.
const double half_height = std::sqrt(1 - std::sqrt(0.5));
constexpr double kSunkShare = 1.0 / 3;
constexpr double kSinkingMm = 8;
constexpr double kSinkingShare = 0.4;
constexpr double kFlatAroundHole_mm = 1;

int steps_in(double length_mm, double step_mm) {
  // A side that is a whole number of steps must not get one more because of rounding.
  return static_cast<int>(std::ceil(length_mm / step_mm - 1e-6));
}

}  // namespace

double sinking_mm(double length_mm) { return std::min(kSinkingMm, kSinkingShare * length_mm); }

Plate::Plate(int columns, int rows, double step_mm, double thickness_mm)
    : columns_(columns),
      rows_(rows),
      step_mm_(step_mm),
      thickness_mm_(thickness_mm),
      heights_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
               static_cast<float>(thickness_mm)) {}

base::Result<Plate> Plate::create(double width_mm, double height_mm, double step_mm, double thickness_mm) {
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!within(width_mm, 1, 1000) || !within(height_mm, 1, 1000)) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a plate cannot be {:.4g} x {:.4g} mm", width_mm, height_mm), "plate",
                      "give sides of 1 to 1000 mm");
  }
  if (!within(thickness_mm, 0.4, 100)) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a plate cannot be {:.4g} mm thick", thickness_mm), "plate",
                      "give 0.4 to 100 mm");
  }
  if (!within(step_mm, kFinestStep_mm, 5)) {
    return base::fail(base::Errc::bad_argument, fmt::format("samples cannot be {:.4g} mm apart", step_mm),
                      "plate", "give 0.02 to 5 mm");
  }
  const int columns = std::max(1, steps_in(width_mm, step_mm)) + 1;
  const int rows = std::max(1, steps_in(height_mm, step_mm)) + 1;
  if (static_cast<long>(columns) * rows > kMostSamples) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("the plate would have {} x {} samples", columns, rows), "plate",
                      fmt::format("make it smaller, or its step larger: {} samples at most", kMostSamples));
  }
  return Plate(columns, rows, step_mm, thickness_mm);
}

void Plate::lay(const surface::HeightMap& map, PlatePoint lower_left, double side_mm, double from_mm,
                double to_mm) {
  const int size = map.size();
  const double per_mm = (size - 1) / side_mm;
  const auto span = [&](double low, int count) {
    const int first = std::max(0, static_cast<int>(std::ceil(low / step_mm_ - 1e-9)));
    const int last = std::min(count - 1, static_cast<int>(std::floor((low + side_mm) / step_mm_ + 1e-9)));
    return std::pair{first, last};
  };
  const auto [first_column, last_column] = span(lower_left.x, columns_);
  const auto [first_row, last_row] = span(lower_left.y, rows_);
  for (int row = first_row; row <= last_row; ++row) {
    const double v = std::clamp((side_mm - (row * step_mm_ - lower_left.y)) * per_mm, 0.0, size - 1.0);
    const int v0 = std::min(static_cast<int>(v), size - 2);
    const double dv = v - v0;
    for (int column = first_column; column <= last_column; ++column) {
      const double u = std::clamp((column * step_mm_ - lower_left.x) * per_mm, 0.0, size - 1.0);
      const int u0 = std::min(static_cast<int>(u), size - 2);
      const double du = u - u0;
      const double share = (1 - dv) * ((1 - du) * map.at(u0, v0) + du * map.at(u0 + 1, v0)) +
                           dv * ((1 - du) * map.at(u0, v0 + 1) + du * map.at(u0 + 1, v0 + 1));
      heights_[index(column, row)] += static_cast<float>(from_mm + (to_mm - from_mm) * share);
    }
  }
}

void Plate::sink(const surface::HeightMap& map, PlatePoint lower_left, double side_mm, double depth_mm) {
  lay(map, lower_left, side_mm, -depth_mm, 0);
}

void Plate::put(const surface::HeightMap& map, PlatePoint lower_left, double side_mm, double height_mm) {
  lay(map, lower_left, side_mm, 0, height_mm);
}

void Plate::add_line(std::span<const PlatePoint> line, const RaisedLine& profile, LineEnd end) {
  const double total = geometry::arc_length(line);
  const double sinking = sinking_mm(total);
  const double radius = profile.width_mm / 2 / half_height;
  const auto raise = [&](PlatePoint from, PlatePoint to, double before) {
    const double segment = geometry::distance(from, to);
    const auto cell = [&](double mm, int count, bool up) {
      const double at = mm / step_mm_;
      return std::clamp(static_cast<int>(up ? std::ceil(at) : std::floor(at)), 0, count - 1);
    };
    const int last_row = cell(std::max(from.y, to.y) + radius, rows_, false);
    const int last_column = cell(std::max(from.x, to.x) + radius, columns_, false);
    const int first_column = cell(std::min(from.x, to.x) - radius, columns_, true);
    for (int row = cell(std::min(from.y, to.y) - radius, rows_, true); row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const PlatePoint p{column * step_mm_, row * step_mm_};
        const double share = geometry::nearest_share(p, from, to);
        const double x = geometry::distance(from + (to - from) * share, p) / radius;
        if (x >= 1) continue;
        double height = profile.height_mm;
        const double left = total - before - share * segment;
        if (end == LineEnd::sinks && left < sinking) height *= kSunkShare + (1 - kSunkShare) * left / sinking;
        const double rise = height * (1 - x * x) * (1 - x * x);
        float& at = heights_[index(column, row)];
        at = std::max(at, static_cast<float>(thickness_mm_ + rise));
      }
    }
  };
  if (line.size() == 1) raise(line[0], line[0], 0);
  double before = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    raise(line[i], line[i + 1], before);
    before += geometry::distance(line[i], line[i + 1]);
  }
}

void Plate::add_dot(PlatePoint centre, double width_mm, double height_mm) {
  const double foot = width_mm / 2;
  const double ball = (foot * foot + height_mm * height_mm) / (2 * height_mm);
  const int last_row = std::min(rows_ - 1, static_cast<int>((centre.y + foot) / step_mm_));
  const int last_column = std::min(columns_ - 1, static_cast<int>((centre.x + foot) / step_mm_));
  const int first_column = std::max(0, static_cast<int>((centre.x - foot) / step_mm_));
  for (int row = std::max(0, static_cast<int>((centre.y - foot) / step_mm_)); row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const double d = geometry::distance(centre, PlatePoint{column * step_mm_, row * step_mm_});
      if (d >= foot) continue;
      const double rise = std::sqrt(ball * ball - d * d) - (ball - height_mm);
      float& at = heights_[index(column, row)];
      at = std::max(at, static_cast<float>(thickness_mm_ + rise));
    }
  }
}

void Plate::add_border(double width_mm, double height_mm) {
  const int width = std::max(1, steps_in(width_mm, step_mm_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (std::min({row, column, rows_ - 1 - row, columns_ - 1 - column}) <= width)
        heights_[index(column, row)] += static_cast<float>(height_mm);
    }
  }
}

base::Result<void> Plate::add_hole(const Hole& hole) {
  const double reach = hole.radius_mm + kFlatAroundHole_mm;
  const auto refuse = [](const std::string& what, const std::string& remedy) {
    return base::fail(base::Errc::bad_argument, what, "hole", remedy);
  };
  if (hole.radius_mm < 8 * step_mm_) return refuse("is too small for the grid", "make it wider");
  if (hole.centre.x - reach < 0 || hole.centre.y - reach < 0 || hole.centre.x + reach > width_mm() ||
      hole.centre.y + reach > height_mm())
    return refuse("is too close to the edge", "leave 1 mm around it");
  for (const Hole& other : holes_) {
    if (geometry::distance(other.centre, hole.centre) < reach + other.radius_mm)
      return refuse("is too close to another one", "leave 1 mm between them");
  }
  const auto middle = at(static_cast<int>(std::lround(hole.centre.x / step_mm_)),
                         static_cast<int>(std::lround(hole.centre.y / step_mm_)));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (geometry::distance(hole.centre, PlatePoint{column * step_mm_, row * step_mm_}) <= reach &&
          at(column, row) != middle)
        return refuse("is not on flat ground", "put it into the margin");
    }
  }
  holes_.push_back(hole);
  return {};
}

Plate Plate::negative() const {
  Plate mould(columns_, rows_, step_mm_, thickness_mm_);
  const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column)
      mould.heights_[index(column, row)] = *low + *high - at(columns_ - 1 - column, row);
  }
  return mould;
}

}  // namespace nazori::model
