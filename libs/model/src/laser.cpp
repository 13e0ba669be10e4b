// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/laser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "nazori/geometry/needed_points.h"

namespace nazori::model {
namespace {

constexpr double kTolerance_mm = 0.01;
constexpr double kLeastDepth_mm = 0.01;

/// An edge of the grid by its lower left end and its direction.
struct GridEdge {
  int column;
  int row;
  bool upwards;
  friend auto operator<=>(const GridEdge&, const GridEdge&) = default;
};

class ContourFinder {
 public:
  ContourFinder(const Plate& plate, double height) : plate_(plate), level_(height) {}

  std::vector<PlateLine> find() {
    for (int row = -1; row < plate_.rows(); ++row)
      for (int column = -1; column < plate_.columns(); ++column) visit(column, row);
    std::vector<PlateLine> lines;
    while (!next_.empty()) {
      PlateLine line;
      auto at = next_.begin();
      const GridEdge first = at->first;
      while (at != next_.end()) {
        line.push_back(crossing(at->first));
        const GridEdge to = at->second;
        next_.erase(at);
        at = to == first ? next_.end() : next_.find(to);
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  [[nodiscard]] bool is_on_plate(int column, int row) const {
    return column >= 0 && row >= 0 && column < plate_.columns() && row < plate_.rows();
  }
  [[nodiscard]] double height(int column, int row) const {
    return static_cast<double>(plate_.at(column, row));
  }
  [[nodiscard]] bool is_low(int column, int row) const {
    return is_on_plate(column, row) && height(column, row) < level_;
  }
  /// Where the level crosses an edge; at the rim where one of its ends lies beyond the plate.
  [[nodiscard]] PlatePoint crossing(const GridEdge& e) const {
    const int column = e.column + (e.upwards ? 0 : 1);
    const int row = e.row + (e.upwards ? 1 : 0);
    const PlatePoint from{e.column * plate_.step_mm(), e.row * plate_.step_mm()};
    const PlatePoint to{column * plate_.step_mm(), row * plate_.step_mm()};
    if (!is_on_plate(e.column, e.row)) return to;
    if (!is_on_plate(column, row)) return from;
    const double a = height(e.column, e.row);
    const double b = height(column, row);
    return from + (to - from) * ((level_ - a) / (b - a));
  }
  /// The pieces of contours in one cell, with what is low on their left.
  void visit(int column, int row) {
    const std::array<bool, 4> low{is_low(column, row), is_low(column + 1, row), is_low(column + 1, row + 1),
                                  is_low(column, row + 1)};
    const auto count = std::count(low.begin(), low.end(), true);
    if (count == 0 || count == 4) return;
    const std::array<GridEdge, 4> edges{GridEdge{column, row, false}, GridEdge{column + 1, row, true},
                                        GridEdge{column, row + 1, false}, GridEdge{column, row, true}};
    // Where two opposite corners are low, the middle of the cell decides whether they are connected.
    bool connected = false;
    if (count == 2 && low[0] == low[2] && is_on_plate(column, row) && is_on_plate(column + 1, row + 1)) {
      const double sum = height(column, row) + height(column + 1, row) + height(column + 1, row + 1) +
                         height(column, row + 1);
      connected = sum / 4 < level_;
    }
    for (std::size_t leaves = 0; leaves < 4; ++leaves) {
      if (!low[leaves] || low[(leaves + 1) % 4]) continue;
      for (std::size_t step = 1; step < 4; ++step) {
        const std::size_t enters = (leaves + (connected ? step : 4 - step)) % 4;
        if (low[enters] || !low[(enters + 1) % 4]) continue;
        next_.emplace(edges[leaves], edges[enters]);
        break;
      }
    }
  }

  const Plate& plate_;
  double level_;
  std::map<GridEdge, GridEdge> next_;
};

/// The corners that a closed line needs.
PlateLine simplified(const PlateLine& loop) {
  PlateLine open = loop;
  open.push_back(loop.front());
  const auto farthest = std::max_element(open.begin(), open.end(), [&](PlatePoint a, PlatePoint b) {
    return geometry::distance(a, loop.front()) < geometry::distance(b, loop.front());
  });
  const auto middle = static_cast<std::size_t>(farthest - open.begin());
  PlateLine kept;
  const std::span<const PlatePoint> all(open);
  for (const auto half : {all.first(middle + 1), all.subspan(middle)}) {
    const auto needed = geometry::needed_points(half, kTolerance_mm);
    // The last point of each half is the first of the other.
    for (std::size_t i = 0; i + 1 < needed.size(); ++i) kept.push_back(half[needed[i]]);
  }
  return kept;
}

std::string xml_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      safe += c;
  }
  return safe;
}

}  // namespace

std::vector<PlateLine> contours(const Plate& plate, double height_mm) {
  return ContourFinder(plate, height_mm).find();
}

base::Result<std::string> to_laser_svg(const Plate& plate, int layers, std::string_view name) {
  if (layers < kFewestLayers || layers > kMostLayers) {
    return base::fail(base::Errc::bad_argument, fmt::format("{} layers are not possible", layers), "layers",
                      fmt::format("give {} to {}", kFewestLayers, kMostLayers));
  }
  const auto heights = plate.heights();
  const double deepest =
      plate.thickness_mm() - static_cast<double>(*std::min_element(heights.begin(), heights.end()));
  if (deepest < kLeastDepth_mm)
    return base::fail(base::Errc::bad_argument, "the plate has no groove", "laser",
                      "give a tablet with grooves");
  const double step = deepest / layers;
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"{0:.3f}mm\" "
      "height=\"{1:.3f}mm\" viewBox=\"0 0 {0:.3f} {1:.3f}\">\n<title>{2}</title>\n"
      "<desc>Depth {3:.3f} mm in {4} layers of {5:.4f} mm, dark is deep. Red: cut through.</desc>\n",
      plate.width_mm(), plate.height_mm(), xml_text(name), deepest, layers, step);
  for (int k = 1; k <= layers; ++k) {
    const auto grey = static_cast<unsigned>(std::lround(255.0 * (layers - k) / layers));
    const auto label = fmt::format("depth {:.3f} mm", k * step);
    svg += fmt::format(
        "<g id=\"layer-{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\" fill=\"#{:02x}{:02x}{:02x}\" "
        "fill-rule=\"evenodd\">\n<path d=\"",
        k, label, grey, grey, grey);
    for (const PlateLine& loop : contours(plate, plate.thickness_mm() - (k - 0.5) * step)) {
      const PlateLine line = simplified(loop);
      if (line.size() < 3) continue;
      for (std::size_t i = 0; i < line.size(); ++i)
        svg += fmt::format("{}{:.3f} {:.3f}", i == 0 ? "M" : "L", line[i].x, plate.height_mm() - line[i].y);
      svg += "Z";
    }
    svg += "\"/>\n</g>\n";
  }
  svg += fmt::format(
      "<g id=\"cut\" inkscape:groupmode=\"layer\" inkscape:label=\"cut\" fill=\"none\" stroke=\"#ff0000\" "
      "stroke-width=\"0.1\">\n<rect x=\"0\" y=\"0\" width=\"{:.3f}\" height=\"{:.3f}\"/>\n",
      plate.width_mm(), plate.height_mm());
  for (const Hole& hole : plate.holes())
    svg += fmt::format("<circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:.3f}\"/>\n", hole.centre.x,
                       plate.height_mm() - hole.centre.y, hole.radius_mm);
  return svg + "</g>\n</svg>\n";
}

}  // namespace nazori::model
