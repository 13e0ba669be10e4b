// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/raised.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nazori/geometry/polyline.h"

namespace nazori::model {
namespace {

constexpr double kFarthestNumber_mm = 16;
constexpr double kTick_mm = 4;
constexpr double kEdge_mm = 5;
constexpr double kLabelGap_mm = 3;
constexpr int kWidestLabel = 5;  // cells: "-10.5"

struct Box {
  double left;
  double bottom;
  double right;
  double top;

  [[nodiscard]] Box wider(double by) const { return {left - by, bottom - by, right + by, top + by}; }
  [[nodiscard]] bool meets(const Box& o) const {
    return left < o.right && o.left < right && bottom < o.top && o.bottom < top;
  }
};

/// What is raised already: points of lines with a foot around each, and boxes of labels.
class Occupied {
 public:
  void add_line(std::span<const PlatePoint> line, double foot) {
    const double length = geometry::arc_length(line);
    const auto count = static_cast<std::size_t>(length / 0.5) + 2;
    for (const PlatePoint p : geometry::resample(line, count)) add_point(p, foot);
  }
  void add_point(PlatePoint p, double foot) {
    boxes_.push_back({p.x - foot, p.y - foot, p.x + foot, p.y + foot});
  }
  void add_box(const Box& box) { boxes_.push_back(box); }
  [[nodiscard]] bool has_room(const Box& box) const {
    return std::none_of(boxes_.begin(), boxes_.end(), [&](const Box& o) { return o.meets(box); });
  }

 private:
  std::vector<Box> boxes_;
};

/// The nearest free box for a label beside `at`; behind the direction of writing before other sides.
std::optional<Box> box_beside(PlatePoint at, PlatePoint direction, double width, double height, double clear,
                              const Plate& plate, const Occupied& occupied) {
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
      if (around.left >= 0 && around.bottom >= 0 && around.right <= plate.width_mm() &&
          around.top <= plate.height_mm() && occupied.has_room(around))
        return box;
    }
  }
  return std::nullopt;
}

double foot_of(const RaisedLine& line) { return line.width_mm * 0.92; }

/// Calls `add` for each piece of a line that is raised in this style.
template <class Add>
void for_each_piece(const PlateLine& line, CurveStyle style, const Add& add) {
  if (style == CurveStyle::solid || line.size() < 2) {
    add(line);
    return;
  }
  const double length = geometry::arc_length(std::span<const PlatePoint>(line));
  const double raised_mm = style == CurveStyle::dashed ? 8 : 0;
  const double period_mm = style == CurveStyle::dashed ? 12 : 4.5;
  for (int number = 0; number * period_mm <= length; ++number) {
    const double from = number * period_mm;
    const double to = std::min(from + raised_mm, length);
    PlateLine piece{geometry::point_at(std::span<const PlatePoint>(line), from)};
    double before = 0;
    for (std::size_t i = 1; i < line.size() && raised_mm > 0; ++i) {
      before += geometry::distance(line[i - 1], line[i]);
      if (before > from && before < to) piece.push_back(line[i]);
    }
    if (raised_mm > 0) piece.push_back(geometry::point_at(std::span<const PlatePoint>(line), to));
    add(piece);
  }
}

/// The place of the square of a plot on its plate.
struct Square {
  PlatePoint lower_left;
  double side;
  [[nodiscard]] PlatePoint at(double x, double y) const {
    return {lower_left.x + x * side, lower_left.y + y * side};
  }
};

void add_axes(Plate& plate, const RaisedPlot& plot, const Square& square, const RaisedLine& axis) {
  const double tick = kTick_mm / 2 / square.side;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    plate.add_line(PlateLine{square.at(x0, y0), square.at(x1, y1)}, axis);
  };
  if (plot.x_axis) line(0, *plot.x_axis, 1, *plot.x_axis);
  if (plot.y_axis) line(*plot.y_axis, 0, *plot.y_axis, 1);
  for (const RaisedTick& t : plot.x_ticks) {
    if (plot.x_axis) line(t.share, *plot.x_axis - tick, t.share, *plot.x_axis + tick);
    line(t.share, 0, t.share, tick);
  }
  for (const RaisedTick& t : plot.y_ticks) {
    if (plot.y_axis) line(*plot.y_axis - tick, t.share, *plot.y_axis + tick, t.share);
    line(0, t.share, tick, t.share);
  }
}

/// The labels of one axis where none covers another. @param place  lower left corner for a width.
template <class Place>
void add_labels(Plate& plate, Occupied& taken, const std::vector<RaisedTick>& ticks, const Place& place) {
  const auto add = [&](const RaisedTick& tick) {
    const auto cells = braille_cells(tick.label);
    if (!cells || cells->empty() || cells->size() > kWidestLabel + 1) return;
    const double width = braille_width_mm(cells->size());
    const PlatePoint at = place(tick, width);
    const Box box{at.x, at.y, at.x + width, at.y + braille_height_mm()};
    if (box.left < 0 || box.bottom < 0 || box.right > plate.width_mm() || box.top > plate.height_mm() ||
        !taken.has_room(box.wider(kLabelGap_mm / 2)))
      return;
    taken.add_box(box.wider(kLabelGap_mm / 2));
    add_braille(plate, *cells, at);
  };
  // Zero and the ends are the most useful ones, so they are placed first.
  for (const RaisedTick& tick : ticks)
    if (tick.label == "0") add(tick);
  if (!ticks.empty() && ticks.front().label != "0") add(ticks.front());
  if (ticks.size() > 1 && ticks.back().label != "0") add(ticks.back());
  for (std::size_t i = 1; i + 1 < ticks.size(); ++i)
    if (ticks[i].label != "0") add(ticks[i]);
}

}  // namespace

std::vector<int> add_strokes(Plate& plate, std::span<const RaisedStroke> strokes,
                             const RaisedStrokeSettings& settings) {
  Occupied occupied;
  for (const RaisedStroke& stroke : strokes) {
    plate.add_line(stroke.line, settings.line, stroke.end);
    occupied.add_line(stroke.line, foot_of(settings.line));
  }
  if (settings.start_dots) {
    for (const RaisedStroke& stroke : strokes) {
      plate.add_dot(stroke.line.front(), settings.dot_width_mm,
                    settings.line.height_mm + settings.dot_rise_mm);
      occupied.add_point(stroke.line.front(), settings.dot_width_mm / 2);
    }
  }
  std::vector<int> without_room;
  if (!settings.numbers) return without_room;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const PlateLine& line = strokes[i].line;
    auto cells = braille_cells(std::to_string(i + 1)).value_or(std::vector<BrailleCell>());
    cells.erase(cells.begin());
    const double ahead = std::min(5.0, geometry::arc_length(std::span<const PlatePoint>(line)));
    const PlatePoint direction = geometry::point_at(std::span<const PlatePoint>(line), ahead) - line.front();
    const auto box = box_beside(line.front(), direction, braille_width_mm(cells.size()), braille_height_mm(),
                                settings.clear_mm, plate, occupied);
    if (!box) {
      without_room.push_back(static_cast<int>(i) + 1);
      continue;
    }
    add_braille(plate, cells, {box->left, box->bottom});
    occupied.add_box(*box);
  }
  return without_room;
}

base::Result<Plate> raised_plot(const RaisedPlot& plot, const RaisedPlotSettings& settings) {
  const double left = kEdge_mm + braille_width_mm(kWidestLabel) + kLabelGap_mm;
  // The label of the lowest tick stands above the labels of the x axis.
  const double below = kEdge_mm + braille_height_mm() * 1.5 + kLabelGap_mm;
  const double beyond = kEdge_mm + braille_height_mm() + kLabelGap_mm;  // for the letters of the axes
  const Square square{{left, below}, settings.side_mm};
  auto plate = Plate::create(left + settings.side_mm + beyond, below + settings.side_mm + beyond,
                             settings.step_mm, settings.thickness_mm);
  if (!plate) return plate;
  if (plot.surface != nullptr)
    plate->put(*plot.surface, square.lower_left, square.side, settings.surface_height_mm);
  if (plot.surface == nullptr) add_axes(*plate, plot, square, settings.axis);
  for (const RaisedCurve& curve : plot.curves) {
    PlateLine line;
    for (const PlatePoint p : curve.line) line.push_back(square.at(p.x, p.y));
    for_each_piece(line, curve.style, [&](const PlateLine& piece) { plate->add_line(piece, settings.line); });
  }
  Occupied taken;
  add_labels(*plate, taken, plot.x_ticks, [&](const RaisedTick& tick, double width) {
    return PlatePoint{square.at(tick.share, 0).x - width / 2, kEdge_mm};
  });
  add_labels(*plate, taken, plot.y_ticks, [&](const RaisedTick& tick, double width) {
    return PlatePoint{left - kLabelGap_mm - width, square.at(0, tick.share).y - braille_height_mm() / 2};
  });
  const double half = braille_height_mm() / 2;
  const double letter = braille_width_mm(1);
  add_braille(*plate, *braille_cells("x"),
              {square.at(1, 0).x + kLabelGap_mm, square.at(0, plot.x_axis.value_or(0)).y - half});
  add_braille(*plate, *braille_cells("y"),
              {square.at(plot.y_axis.value_or(0), 0).x - letter / 2, square.at(0, 1).y + kLabelGap_mm});
  return plate;
}

}  // namespace nazori::model
