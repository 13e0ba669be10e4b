// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/touch_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "nazori/model/plot_layout.h"
#include "nazori/print/drawing_file.h"
#include "swell_page.h"

namespace nazori::practice {
namespace {

using Cells = std::vector<model::BrailleCell>;
using model::PlateLine;
using model::PlatePoint;

constexpr double kClear_mm = 2;  // of a curve from what is less important
constexpr double kSmallest_mm = 40;
constexpr double kBelow_mm = 16;  // from the numbers of the x axis to the upper side of a line of text
constexpr double kWhite = 1;
constexpr double kMeet_mm = 1;
constexpr std::size_t kMostPoints = 6'000;  // 1 mm apart; their pairs are compared
constexpr char32_t kFirstPattern = U'\u2800';

/// The statements of a plot in braille, one a line.
std::vector<Cells> expression_lines(const functions::Plot& plot, functions::BrailleCode code) {
  std::vector<Cells> lines(1);
  for (const char32_t c : base::decode_utf8(functions::in_braille(plot, code)).value_or(U"")) {
    if (c == U'\n')
      lines.emplace_back();
    else
      lines.back().push_back(c < kFirstPattern ? 0 : static_cast<model::BrailleCell>(c - kFirstPattern));
  }
  return lines;
}

bool meet(const PlateLine& a, const PlateLine& b) {
  return std::any_of(a.begin(), a.end(), [&b](PlatePoint p) {
    return std::any_of(b.begin(), b.end(), [p](PlatePoint q) { return geometry::distance(p, q) < kMeet_mm; });
  });
}

/// The distance of curves that run side by side on a square of this side; 0 if none do or there are too many.
/// Curves that meet are close there whatever their size is, so they do not count.
double closest_curves(const model::RaisedPlot& plot, double side_mm) {
  std::vector<PlateLine> lines;
  std::size_t points = 0;
  for (const model::RaisedCurve& curve : plot.curves) {
    PlateLine line;
    for (const PlatePoint p : curve.line) line.push_back(p * side_mm);
    if (line.empty()) continue;
    const std::span<const PlatePoint> whole(line);
    lines.push_back(geometry::resample(whole, static_cast<std::size_t>(geometry::arc_length(whole)) + 2));
    points += lines.back().size();
  }
  if (points > kMostPoints) return 0;
  double closest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j)
      if (!meet(lines[i], lines[j]))
        closest = std::min(closest, closest_lines(std::array{lines[i], lines[j]}));
  return std::isfinite(closest) ? closest : 0;
}

base::Result<TouchFile> swell_plot(const model::RaisedPlot& plot, std::span<const Cells> text,
                                   const PlotPaper& settings, const std::string& subject) {
  const auto [width, height] = print::paper_size(settings.paper);
  const double side = settings.side_mm;
  const model::PlotLayout layout = model::plot_layout(plot, side, {.edge_mm = 0, .gap_mm = kSwellGap_mm});
  const double most = width - 2 * print::kMargin_mm - (layout.width_mm - side);
  if (!(side >= kSmallest_mm && side <= most)) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a square of {:.4g} mm does not fit on this paper", side), "swell paper",
                      fmt::format("give {:.4g} to {:.4g} mm", kSmallest_mm, std::floor(most)));
  }
  const PlatePoint corner{(width - layout.width_mm) / 2, height - print::kMargin_mm - layout.height_mm};
  SwellPage page(width, height);
  const auto add = [&](const PlateLine& line, double width_mm, double grey = 0) {
    PlateLine moved;
    for (const PlatePoint p : line) moved.push_back(corner + p);
    page.add_line(moved, width_mm, grey);
  };
  for (const PlateLine& line : layout.axes) add(line, kSwellThinLine_mm);
  // White below all curves before any of them, so that no curve is interrupted by another.
  for (const PlateLine& line : layout.curves) add(line, kSwellLine_mm + 2 * kClear_mm, kWhite);
  for (const PlateLine& line : layout.curves) add(line, kSwellLine_mm);
  for (const model::PlacedBraille& label : layout.labels)
    page.add_braille(label.cells, corner + label.lower_left);
  page.add_text(text, corner.y - kBelow_mm);
  TouchFile file{TouchKind::swell_paper, {}, width, height, 1, {}, {}, closest_curves(plot, side)};
  const std::array pages{page.take()};
  file.content = print::drawing_pdf(pages, subject);
  return file;
}

}  // namespace

base::Result<TouchFile> plot_touch_file(TouchKind kind, const functions::Plot& plot,
                                        const functions::Picture& picture, const PlotPaper& paper) {
  if (kind != TouchKind::swell_paper && kind != TouchKind::embosser)
    return base::fail(base::Errc::bad_argument, "a plot is not cut", "plot", "give .stl, .3mf, .pdf or .brf");
  if (plot.is_surface())
    return base::fail(base::Errc::bad_argument, "a surface has no lines for paper", "plot",
                      "give a curve, or make a solid (.stl or .3mf)");
  const model::RaisedPlot raised = raised_plot_of(plot, picture);
  const std::vector<Cells> text = expression_lines(plot, paper.code);
  if (kind == TouchKind::swell_paper) return swell_plot(raised, text, paper, functions::canonical(plot));
  auto page = model::embossed_plot(raised, text, paper.embosser);
  if (!page) return tl::unexpected(std::move(page.error()));
  TouchFile file{TouchKind::embosser, {}, 0, 0, 1, {}, {}, 0};
  file.width_mm = model::dot_x_mm(2 * paper.embosser.columns - 1);
  file.height_mm = model::dot_y_mm(3 * paper.embosser.lines - 1);
  file.content = model::to_brf({&*page, 1});
  return file;
}

}  // namespace nazori::practice
