// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/raised.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "boxes.h"
#include "nazori/geometry/polyline.h"
#include "nazori/model/plot_layout.h"

namespace nazori::model {
namespace {

constexpr double kFarthestNumber_mm = 16;

/// The nearest free box for a label beside `at`; behind the direction of writing before other sides.
std::optional<Box> box_beside(PlatePoint at, PlatePoint direction, double width, double height, double clear,
                              const Box& page, const Occupied& occupied) {
  const double behind = std::atan2(-direction.y, -direction.x);
  for (int half_mm = 4; 0.5 * half_mm <= kFarthestNumber_mm; ++half_mm) {
    const double distance = 0.5 * half_mm;
    for (int step = 0; step < 24; ++step) {
      const int turns = (step % 2 == 0 ? 1 : -1) * ((step + 1) / 2);
      const double angle = behind + turns * std::numbers::pi / 12;
      // The box touches the circle around the start with the side that looks to it.
      const double x = at.x + std::cos(angle) * (distance + width / 2);
      const double y = at.y + std::sin(angle) * (distance + height / 2);
      const Box box{x - width / 2, y - height / 2, x + width / 2, y + height / 2};
      const Box around = box.wider(clear);
      if (around.left >= page.left && around.bottom >= page.bottom && around.right <= page.right &&
          around.top <= page.top && occupied.has_room(around))
        return box;
    }
  }
  return std::nullopt;
}

double foot_of(const RaisedLine& line) { return line.width_mm * 0.92; }

void occupy(Occupied& occupied, std::span<const RaisedStroke> strokes, const RaisedStrokeSettings& settings) {
  for (const RaisedStroke& stroke : strokes) {
    occupied.add_line(stroke.line, foot_of(settings.line));
    if (settings.start_dots) occupied.add_point(stroke.line.front(), settings.dot_width_mm / 2);
  }
}

/// Finds places for the numbers of one character, which are occupied then.
StrokeNumbers place_numbers(std::span<const RaisedStroke> strokes, const Box& page,
                            const RaisedStrokeSettings& settings, Occupied& occupied) {
  StrokeNumbers made;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const PlateLine& line = strokes[i].line;
    auto cells = braille_cells(std::to_string(i + 1)).value_or(std::vector<BrailleCell>());
    cells.erase(cells.begin());
    const double ahead = std::min(5.0, geometry::arc_length(std::span<const PlatePoint>(line)));
    const PlatePoint direction = geometry::point_at(std::span<const PlatePoint>(line), ahead) - line.front();
    const auto box = box_beside(line.front(), direction, braille_width_mm(cells.size()), braille_height_mm(),
                                settings.clear_mm, page, occupied);
    if (!box) {
      made.without_room.push_back(static_cast<int>(i) + 1);
      continue;
    }
    occupied.add_box(*box);
    made.numbers.push_back({std::move(cells), {box->left, box->bottom}});
  }
  return made;
}

}  // namespace

StrokeNumbers stroke_numbers(std::span<const RaisedStroke> strokes, double width_mm, double height_mm,
                             const RaisedStrokeSettings& settings) {
  if (!settings.numbers) return {};
  Occupied occupied;
  occupy(occupied, strokes, settings);
  return place_numbers(strokes, {0, 0, width_mm, height_mm}, settings, occupied);
}

std::vector<int> add_strokes(Plate& plate, std::span<const std::vector<RaisedStroke>> characters,
                             const RaisedStrokeSettings& settings) {
  Occupied occupied;
  for (const std::vector<RaisedStroke>& strokes : characters) {
    for (const RaisedStroke& stroke : strokes) {
      plate.add_line(stroke.line, settings.line, stroke.end);
      if (settings.start_dots)
        plate.add_dot(stroke.line.front(), settings.dot_width_mm,
                      settings.line.height_mm + settings.dot_rise_mm);
    }
    occupy(occupied, strokes, settings);
  }
  std::vector<int> without;
  if (!settings.numbers) return without;
  const Box page{0, 0, plate.width_mm(), plate.height_mm()};
  for (const std::vector<RaisedStroke>& strokes : characters) {
    const StrokeNumbers made = place_numbers(strokes, page, settings, occupied);
    for (const StrokeNumber& number : made.numbers) add_braille(plate, number.cells, number.lower_left);
    without.insert(without.end(), made.without_room.begin(), made.without_room.end());
  }
  return without;
}

std::vector<int> add_strokes(Plate& plate, std::span<const RaisedStroke> strokes,
                             const RaisedStrokeSettings& settings) {
  return add_strokes(plate, std::array{std::vector(strokes.begin(), strokes.end())}, settings);
}

base::Result<Plate> raised_plot(const RaisedPlot& plot, const RaisedPlotSettings& settings) {
  const PlotLayout layout = plot_layout(plot, settings.side_mm);
  auto plate = Plate::create(layout.width_mm, layout.height_mm, settings.step_mm, settings.thickness_mm);
  if (!plate) return plate;
  if (plot.surface != nullptr)
    plate->put(*plot.surface, layout.lower_left, layout.side_mm, settings.surface_height_mm);
  for (const PlateLine& line : layout.axes) plate->add_line(line, settings.axis);
  for (const PlateLine& line : layout.curves) plate->add_line(line, settings.line);
  for (const PlacedBraille& label : layout.labels) add_braille(*plate, label.cells, label.lower_left);
  return plate;
}

}  // namespace nazori::model
