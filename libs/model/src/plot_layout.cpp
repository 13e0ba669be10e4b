// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/plot_layout.h"

#include <algorithm>
#include <utility>

#include "boxes.h"
#include "nazori/geometry/polyline.h"

namespace nazori::model {
namespace {

constexpr int kWidestLabel = 5;  // cells: "-10.5"

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

PlatePoint in_square(const PlotLayout& layout, double x, double y) {
  return {layout.lower_left.x + x * layout.side_mm, layout.lower_left.y + y * layout.side_mm};
}

void add_axes(PlotLayout& layout, const RaisedPlot& plot, double tick_mm) {
  const double tick = tick_mm / 2 / layout.side_mm;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    layout.axes.push_back({in_square(layout, x0, y0), in_square(layout, x1, y1)});
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
void add_labels(PlotLayout& layout, Occupied& taken, const std::vector<RaisedTick>& ticks, double gap_mm,
                const Place& place) {
  for (const std::size_t i : label_order(ticks)) {
    auto cells = cells_of(ticks[i]);
    if (cells.empty()) continue;
    const double width = braille_width_mm(cells.size());
    const PlatePoint at = place(ticks[i], width);
    const Box box{at.x, at.y, at.x + width, at.y + braille_height_mm()};
    if (box.left < 0 || box.bottom < 0 || box.right > layout.width_mm || box.top > layout.height_mm ||
        !taken.has_room(box.wider(gap_mm / 2)))
      continue;
    taken.add_box(box.wider(gap_mm / 2));
    layout.labels.push_back({std::move(cells), at});
  }
}

}  // namespace

std::vector<BrailleCell> cells_of(const RaisedTick& tick) {
  constexpr std::size_t kMost = 6;  // "-10.5" with the sign for numbers
  auto cells = braille_cells(tick.label).value_or(std::vector<BrailleCell>());
  if (cells.size() > kMost) cells.clear();
  return cells;
}

std::vector<std::size_t> label_order(std::span<const RaisedTick> ticks) {
  std::vector<std::size_t> order;
  const auto add = [&](std::size_t i) {
    if (std::find(order.begin(), order.end(), i) == order.end()) order.push_back(i);
  };
  for (std::size_t i = 0; i < ticks.size(); ++i)
    if (ticks[i].label == "0") add(i);
  if (!ticks.empty()) add(0);
  if (ticks.size() > 1) add(ticks.size() - 1);
  for (std::size_t i = 0; i < ticks.size(); ++i) add(i);
  return order;
}

PlotLayout plot_layout(const RaisedPlot& plot, double side_mm, const PlotDistances& distances) {
  const double edge = distances.edge_mm;
  const double gap = distances.gap_mm;
  const double high = braille_height_mm();
  PlotLayout layout;
  layout.side_mm = side_mm;
  // The label of the lowest tick stands above the labels of the x axis.
  layout.lower_left = {edge + braille_width_mm(kWidestLabel) + gap, edge + high * 1.5 + gap};
  const double beyond = edge + high + gap;  // for the letters of the axes
  layout.width_mm = layout.lower_left.x + side_mm + beyond;
  layout.height_mm = layout.lower_left.y + side_mm + beyond;
  if (plot.surface == nullptr) add_axes(layout, plot, distances.tick_mm);
  for (const RaisedCurve& curve : plot.curves) {
    PlateLine line;
    for (const PlatePoint p : curve.line) line.push_back(in_square(layout, p.x, p.y));
    for_each_piece(line, curve.style, [&](PlateLine piece) { layout.curves.push_back(std::move(piece)); });
  }
  Occupied taken;
  add_labels(layout, taken, plot.x_ticks, gap, [&](const RaisedTick& t, double width) {
    return PlatePoint{in_square(layout, t.share, 0).x - width / 2, edge};
  });
  add_labels(layout, taken, plot.y_ticks, gap, [&](const RaisedTick& t, double width) {
    return PlatePoint{layout.lower_left.x - gap - width, in_square(layout, 0, t.share).y - high / 2};
  });
  const PlatePoint right = in_square(layout, 1, plot.x_axis.value_or(0));
  const PlatePoint top = in_square(layout, plot.y_axis.value_or(0), 1);
  layout.labels.push_back({*braille_cells("x"), {right.x + gap, right.y - high / 2}});
  layout.labels.push_back({*braille_cells("y"), {top.x - braille_width_mm(1) / 2, top.y + gap}});
  return layout;
}

}  // namespace nazori::model
