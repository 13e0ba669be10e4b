// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/point.h"
#include "nazori/surface/height_map.h"

namespace nazori::model {

/// The plane of a plate in millimetres: x right, y up, origin at the lower left corner.
struct PlateFrame {};
using PlatePoint = geometry::Point2<PlateFrame>;
using PlateLine = geometry::Polyline<PlateFrame>;

/// The cross section of a raised line. It is rounded, without an edge at its foot.
/// @source Nazori's default: 1.0 mm high and 1.1 mm wide, the robust line in studies of tactile graphics.
struct RaisedLine {
  double height_mm = 1.0;
  double width_mm = 1.1;  ///< at half its height; at its foot it is 1.84 times as wide
};

/// How a raised line ends, so that a finger can tell it.
enum class LineEnd : std::uint8_t {
  full,   ///< at its full height: a stroke that stops
  sinks,  ///< over its last part it sinks to a third of its height: a sweep, or the flick of a hook
};

/// The length over which a line that LineEnd::sinks goes down [mm]: 8 mm, at most 40 % of it.
[[nodiscard]] double sinking_mm(double length_mm);

/// A round hole through a plate.
struct Hole {
  PlatePoint centre;
  double radius_mm = 2;
};

/// A solid plate whose upper face is a grid of heights above the table. It stands with its lower face at
/// z = 0. Samples lie on the corners of the cells: column 0 is x = 0, row 0 is y = 0. Thread-safe: reading
/// yes, writing no.
class Plate {
 public:
  static constexpr int kMostSamples = 4'000'000;
  static constexpr double kFinestStep_mm = 0.02;  ///< between neighbouring samples

  /// A flat plate; both sides are rounded up to whole steps.
  /// @param step_mm  distance of neighbouring samples, kFinestStep_mm..5.
  /// @return Errc::bad_argument for a side out of 1..1000 mm, a thickness out of 0.4..100 mm, or more than
  /// kMostSamples samples.
  [[nodiscard]] static base::Result<Plate> create(double width_mm, double height_mm, double step_mm,
                                                  double thickness_mm);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double step_mm() const { return step_mm_; }
  [[nodiscard]] double width_mm() const { return (columns_ - 1) * step_mm_; }
  [[nodiscard]] double height_mm() const { return (rows_ - 1) * step_mm_; }
  [[nodiscard]] double thickness_mm() const { return thickness_mm_; }
  /// Height of the upper face above the table [mm]. @param column,row  within the grid.
  [[nodiscard]] float at(int column, int row) const { return heights_[index(column, row)]; }
  /// All heights, row by row from the lower edge up.
  [[nodiscard]] std::span<const float> heights() const { return heights_; }
  [[nodiscard]] const std::vector<Hole>& holes() const { return holes_; }

  /// Sinks a tablet's relief into the plate: a sample of height 1 leaves the plate as it is, one of height 0
  /// lowers it by `depth_mm`. Between its samples the map is read linearly.
  /// @param lower_left  of the square that the map covers; what lies outside the plate is left out.
  void sink(const surface::HeightMap& map, PlatePoint lower_left, double side_mm, double depth_mm);
  /// Puts a relief on the plate: a sample of height 0 leaves it, one of height 1 raises it by `height_mm`.
  void put(const surface::HeightMap& map, PlatePoint lower_left, double side_mm, double height_mm);
  /// A raised line. Where it meets what is raised already, the higher one counts.
  /// @param line  at least one point.
  void add_line(std::span<const PlatePoint> line, const RaisedLine& profile, LineEnd end = LineEnd::full);
  /// A round dot, a piece of a sphere. @param width_mm  of its foot.
  void add_dot(PlatePoint centre, double width_mm, double height_mm);
  /// A border along the edge of the plate, inside it.
  void add_border(double width_mm, double height_mm);
  /// A hole through the plate. The face must be flat there and 1 mm around it.
  /// @return Errc::bad_argument where it is too close to an edge, too small for the grid, or not on flat
  /// ground.
  [[nodiscard]] base::Result<void> add_hole(const Hole& hole);

  /// The mould of this plate: what lies high becomes deep, and left and right are exchanged, so that a cast
  /// from it has this plate's face. Holes are left out.
  [[nodiscard]] Plate negative() const;

 private:
  Plate(int columns, int rows, double step_mm, double thickness_mm);
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  void lay(const surface::HeightMap& map, PlatePoint lower_left, double side_mm, double from_mm,
           double to_mm);

  int columns_;
  int rows_;
  double step_mm_;
  double thickness_mm_;
  std::vector<float> heights_;
  std::vector<Hole> holes_;
};

}  // namespace nazori::model
