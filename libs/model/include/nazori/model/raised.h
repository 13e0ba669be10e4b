// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/braille.h"
#include "nazori/model/plate.h"

namespace nazori::model {

/// A stroke as fingers read it.
struct RaisedStroke {
  PlateLine line;  ///< in writing direction, at least one point
  LineEnd end = LineEnd::full;
};

struct RaisedStrokeSettings {
  RaisedLine line;
  bool start_dots = true;  ///< a dot, higher than the line, where each stroke starts
  double dot_width_mm = 3.0;
  double dot_rise_mm = 0.8;  ///< above the line
  bool numbers = true;       ///< the place in the order as digits in braille, without the sign for numbers
  double clear_mm = 1.2;     ///< between a number and all else that is raised
};

/// A number in braille at its place.
struct StrokeNumber {
  std::vector<BrailleCell> cells;  ///< the digits, without the sign for numbers
  PlatePoint lower_left;           ///< of their box
};

/// Places for the numbers of strokes, beside their starts. A number stands where nothing else is, at most 16
/// mm from its start.
struct StrokeNumbers {
  std::vector<StrokeNumber> numbers;
  std::vector<int> without_room;  ///< numbers of the strokes (from 1) that have no place
};
/// @param width_mm,height_mm  of the plate or the paper.
[[nodiscard]] StrokeNumbers stroke_numbers(std::span<const RaisedStroke> strokes, double width_mm,
                                           double height_mm, const RaisedStrokeSettings& settings = {});

/// Puts the strokes of one character on a flat plate: lines, starting dots, and the numbers of
/// stroke_numbers().
/// @return numbers of the strokes (from 1) for which there was no room.
std::vector<int> add_strokes(Plate& plate, std::span<const RaisedStroke> strokes,
                             const RaisedStrokeSettings& settings = {});

/// The same for several characters. Their numbers keep clear of the strokes and numbers of all.
std::vector<int> add_strokes(Plate& plate, std::span<const std::vector<RaisedStroke>> characters,
                             const RaisedStrokeSettings& settings = {});

/// How a curve is drawn, so that several can be told apart.
enum class CurveStyle : std::uint8_t { solid, dashed, dotted };

/// A curve of a plot. x and y are shares of the sides of its square, 0..1, y up.
struct RaisedCurve {
  PlateLine line;
  CurveStyle style = CurveStyle::solid;
};

/// A tick of an axis, and what stands beside it.
struct RaisedTick {
  double share = 0;   ///< of the side, 0..1
  std::string label;  ///< for braille_cells(); left out where it has no cells or no room
};

/// A plot as fingers read it.
struct RaisedPlot {
  std::vector<RaisedCurve> curves;
  std::optional<double> x_axis;  ///< share of the height at which y = 0 lies; nothing: outside
  std::optional<double> y_axis;  ///< share of the width at which x = 0 lies
  std::vector<RaisedTick> x_ticks;
  std::vector<RaisedTick> y_ticks;
  const surface::HeightMap* surface = nullptr;  ///< relief of z = f(x, y) instead of curves; may be null
};

struct RaisedPlotSettings {
  double side_mm = 120;  ///< of the square of the plot
  double thickness_mm = 3;
  double surface_height_mm = 20;
  double step_mm = 0.15;
  RaisedLine line;
  RaisedLine axis{0.5, 0.8};  ///< lower and finer than a curve
};

/// A plate with the plot: curves, axes, ticks, the labels of the ticks in braille to the left and below, and
/// the letters x and y at the ends of the axes.
/// @return the errors of Plate::create().
[[nodiscard]] base::Result<Plate> raised_plot(const RaisedPlot& plot,
                                              const RaisedPlotSettings& settings = {});

}  // namespace nazori::model
