// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "embossed_dots.h"
#include "nazori/model/plot_layout.h"

namespace nazori::model {
namespace {

constexpr double kSmallest_mm = 40;

int widest(std::span<const RaisedTick> ticks) {
  std::size_t most = 0;
  for (const RaisedTick& tick : ticks) most = std::max(most, cells_of(tick).size());
  return static_cast<int>(most);
}

/// Whether a dot of a curve is raised.
bool is_raised(CurveStyle style, std::size_t dot) {
  if (style == CurveStyle::dashed) return dot % 6 < 4;
  return style == CurveStyle::solid || dot % 3 == 0;
}

class PlotPage {
 public:
  PlotPage(EmbosserPage page, double left_mm, double bottom_mm, double side_mm)
      : page_(std::move(page)), left_mm_(left_mm), bottom_mm_(bottom_mm), side_mm_(side_mm) {}

  [[nodiscard]] Dot dot_at(double x, double y) const {
    const PlatePoint at = on_page({x, y});
    return nearest_dot(at.x, at.y);
  }
  void add_curve(const RaisedCurve& curve) {
    PlateLine line;
    for (const PlatePoint p : curve.line) line.push_back(on_page(p));
    const auto dots = dots_along(line);
    for (std::size_t i = 0; i < dots.size(); ++i)
      if (is_raised(curve.style, i)) curves_.push_back(dots[i]);
    for (const Dot& dot : dots) beside_curves_.push_back(dot);
  }
  /// Adds the dots of the axes and their ticks that stand clear of curves.
  void add_axes(const RaisedPlot& plot) {
    const Dot low = dot_at(0, 0);
    const Dot high = dot_at(1, 1);
    std::optional<int> axis_row;
    std::optional<int> axis_column;
    if (plot.x_axis) axis_row = dot_at(0, *plot.x_axis).row;
    if (plot.y_axis) axis_column = dot_at(*plot.y_axis, 0).column;
    for (int column = low.column; axis_row && column <= high.column; column += 2)
      add_clear({column, *axis_row});
    for (int row = low.row; axis_column && row >= high.row; row -= 2) add_clear({*axis_column, row});
    for (const RaisedTick& tick : plot.x_ticks) {
      const int column = dot_at(tick.share, 0).column;
      add_clear({column, low.row});
      add_clear({column, low.row - 1});
      for (int by = -1; axis_row && by <= 1; ++by) add_clear({column, *axis_row + by});
    }
    for (const RaisedTick& tick : plot.y_ticks) {
      const int row = dot_at(0, tick.share).row;
      add_clear({low.column, row});
      add_clear({low.column + 1, row});
      for (int by = -1; axis_column && by <= 1; ++by) add_clear({*axis_column + by, row});
    }
  }
  /// Numbers below, in the line under the square.
  void add_x_labels(std::span<const RaisedTick> ticks) {
    const int line = dot_at(0, 0).row / 3 + 1;
    for (const std::size_t i : label_order(ticks)) {
      const auto cells = cells_of(ticks[i]);
      const auto count = static_cast<int>(cells.size());
      const double middle_mm = dot_x_mm(dot_at(ticks[i].share, 0).column);
      const double width_mm = (count - 1) * kCell_mm + kDot_mm;
      const auto first = static_cast<int>(std::lround((middle_mm - width_mm / 2) / kCell_mm));
      if (count > 0 && is_empty(line, first - 1, first + count)) put(line, first, cells);
    }
  }
  /// Numbers to the left, an empty cell before the square.
  void add_y_labels(std::span<const RaisedTick> ticks) {
    const int end = dot_at(0, 0).column / 2 - 1;
    for (const std::size_t i : label_order(ticks)) {
      const auto cells = cells_of(ticks[i]);
      const int line = dot_at(0, ticks[i].share).row / 3;
      const int first = end - static_cast<int>(cells.size());
      if (!cells.empty() && is_empty(line, first, end)) put(line, first, cells);
    }
  }
  void add_letters(const RaisedPlot& plot) {
    const Dot right = dot_at(1, plot.x_axis.value_or(0));
    const Dot top = dot_at(plot.y_axis.value_or(0), 1);
    put(right.row / 3, right.column / 2 + 2, *braille_cells("x"));
    put(top.row / 3 - 1, top.column / 2, *braille_cells("y"));
  }
  [[nodiscard]] EmbosserPage take() {
    for (const Dot& dot : curves_) set_dot(page_, dot);
    return std::move(page_);
  }

 private:
  [[nodiscard]] PlatePoint on_page(PlatePoint p) const {
    return {left_mm_ + std::clamp(p.x, 0.0, 1.0) * side_mm_,
            bottom_mm_ - std::clamp(p.y, 0.0, 1.0) * side_mm_};
  }
  void add_clear(const Dot& dot) {
    const Dot low = dot_at(0, 0);
    const Dot high = dot_at(1, 1);
    const bool is_inside =
        dot.column >= low.column && dot.column <= high.column && dot.row <= low.row && dot.row >= high.row;
    const bool touches = std::any_of(beside_curves_.begin(), beside_curves_.end(), [&](const Dot& other) {
      return std::abs(other.column - dot.column) <= 1 && std::abs(other.row - dot.row) <= 1;
    });
    if (is_inside && !touches) set_dot(page_, dot);
  }
  /// Whether the cells of a line from `first` to `last` are on the page and empty. An empty cell may also lie
  /// just beyond the page.
  [[nodiscard]] bool is_empty(int line, int first, int last) const {
    if (line >= page_.lines() || first < -1 || last > page_.columns()) return false;
    for (int column = std::max(0, first); column <= std::min(last, page_.columns() - 1); ++column)
      if (page_.at(column, line) != 0) return false;
    return true;
  }
  void put(int line, int first, const std::vector<BrailleCell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) page_.set(first + static_cast<int>(i), line, cells[i]);
  }

  EmbosserPage page_;
  double left_mm_;
  double bottom_mm_;
  double side_mm_;
  std::vector<Dot> curves_;
  std::vector<Dot> beside_curves_;
};

}  // namespace

base::Result<EmbosserPage> embossed_plot(const RaisedPlot& plot,
                                         std::span<const std::vector<BrailleCell>> text,
                                         const EmbosserPaper& paper) {
  if (auto good = check_paper(paper); !good) return tl::unexpected(std::move(good.error()));
  if (plot.surface != nullptr)
    return base::fail(base::Errc::bad_argument, "a surface has no lines to emboss", "embosser",
                      "give a curve");
  auto below = wrapped(text, static_cast<std::size_t>(paper.columns));
  below.resize(std::min(below.size(), static_cast<std::size_t>(paper.lines / 4)));
  const int text_lines = below.empty() ? 0 : static_cast<int>(below.size()) + 1;
  // At each side there is room for half of the numbers that stand below the ends of the x axis.
  const int half = (widest(plot.x_ticks) + 1) / 2;
  const int left = std::max(widest(plot.y_ticks) + 1, half);
  const int right = std::max(2, half);            // an empty cell and the letter x
  const int last = paper.lines - text_lines - 2;  // line of the square, above the numbers
  const double wide = dot_x_mm(2 * (paper.columns - left - right) - 1);
  const double high = dot_y_mm(3 * last + 2) - dot_y_mm(3);  // the letter y stands above
  const double side = std::min(wide, high);
  if (side < kSmallest_mm) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("{} lines of {} cells are too few for a plot", paper.lines, paper.columns),
                      "embosser", "give more cells in a line, or more lines");
  }
  PlotPage page(EmbosserPage(paper), dot_x_mm(2 * left), dot_y_mm(3 * last + 2), side);
  for (const RaisedCurve& curve : plot.curves)
    if (!curve.line.empty()) page.add_curve(curve);
  page.add_axes(plot);
  page.add_x_labels(plot.x_ticks);
  page.add_y_labels(plot.y_ticks);
  page.add_letters(plot);
  EmbosserPage made = page.take();
  put_text(made, below, paper.lines - static_cast<int>(below.size()));
  return made;
}

}  // namespace nazori::model
