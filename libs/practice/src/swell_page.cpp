// SPDX-License-Identifier: Apache-2.0
#include "swell_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "nazori/geometry/polyline.h"
#include "nazori/print/worksheet.h"

namespace nazori::practice {
namespace {

using model::PlateLine;
using model::PlatePoint;
using print::PageMark;
using print::PathStep;

constexpr double kPiece_mm = 0.5;
constexpr double kLabelLine_mm = 10;
constexpr double kParallel = 0.94;
constexpr double kSameLine_mm = 1.0;

}  // namespace

void SwellPage::add_line(std::span<const PlatePoint> line, double width_mm, double grey) {
  PageMark mark;
  for (const PlatePoint p : line)
    mark.path.push_back({mark.path.empty() ? PathStep::Kind::move : PathStep::Kind::line, {on_paper(p)}});
  // A line without length would not be painted.
  if (line.size() == 1) mark.path.push_back({PathStep::Kind::line, {on_paper(line[0])}});
  mark.width_mm = width_mm;
  mark.grey = grey;
  mark.round = true;
  drawing_.marks.push_back(std::move(mark));
}

void SwellPage::add_dot(PlatePoint at, double width_mm) {
  // Four curves with this reach of their control points are a circle to within 0.03 %.
  const double r = width_mm / 2;
  const double k = r * 4 / 3 * (std::numbers::sqrt2 - 1);
  const auto p = [&](double x, double y) { return on_paper({at.x + x, at.y + y}); };
  PageMark mark;
  mark.filled = true;
  mark.path = {{PathStep::Kind::move, {p(r, 0)}},
               {PathStep::Kind::curve, {p(r, k), p(k, r), p(0, r)}},
               {PathStep::Kind::curve, {p(-k, r), p(-r, k), p(-r, 0)}},
               {PathStep::Kind::curve, {p(-r, -k), p(-k, -r), p(0, -r)}},
               {PathStep::Kind::curve, {p(k, -r), p(r, -k), p(r, 0)}},
               {PathStep::Kind::close, {}}};
  drawing_.marks.push_back(std::move(mark));
}

void SwellPage::add_braille(std::span<const model::BrailleCell> cells, PlatePoint lower_left) {
  const model::BrailleSize size;
  for (const PlatePoint dot : model::braille_dots(cells, lower_left, size)) add_dot(dot, size.dot_width_mm);
}

void SwellPage::add_text(std::span<const std::vector<model::BrailleCell>> lines, double y_mm) {
  const auto cells_a_line = static_cast<std::size_t>((drawing_.width_mm - 2 * print::kMargin_mm) /
                                                     model::BrailleSize().cell_distance_mm);
  for (const auto& line : lines) {
    for (std::size_t from = 0; from < line.size(); from += cells_a_line) {
      const auto part = std::span(line).subspan(from, std::min(cells_a_line, line.size() - from));
      if (y_mm >= print::kMargin_mm) add_braille(part, {print::kMargin_mm, y_mm});
      y_mm -= kLabelLine_mm;
    }
  }
}

void SwellPage::add_stroke(const model::RaisedStroke& stroke) {
  const std::span<const PlatePoint> line(stroke.line);
  const double length = geometry::arc_length(line);
  const double sinking = stroke.end == model::LineEnd::sinks ? model::sinking_mm(length) : 0;
  PlateLine body;
  double before = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) before += geometry::distance(line[i - 1], line[i]);
    if (before <= length - sinking) body.push_back(line[i]);
  }
  body.push_back(geometry::point_at(line, length - sinking));
  add_line(body, kSwellLine_mm);
  const int pieces = static_cast<int>(std::ceil(sinking / kPiece_mm));
  for (int k = 0; k < pieces; ++k) {
    const auto at = [&](int step) {
      return geometry::point_at(line, length - sinking + sinking * step / pieces);
    };
    const double share = (k + 1.0) / pieces;
    add_line(PlateLine{at(k), at(k + 1)}, kSwellLine_mm + (kSwellThinLine_mm - kSwellLine_mm) * share);
  }
}

double closest_lines(std::span<const PlateLine> lines) {
  struct Step {
    PlatePoint at;
    PlatePoint forward;
    std::size_t line;
  };
  std::vector<Step> steps;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const std::span<const PlatePoint> line(lines[l]);
    const auto count = static_cast<std::size_t>(geometry::arc_length(line)) + 2;
    const PlateLine points = geometry::resample(line, count);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = geometry::distance(points[i], points[i + 1]);
      if (length > 0) steps.push_back({points[i], (points[i + 1] - points[i]) * (1 / length), l});
    }
  }
  std::vector<double> gaps(steps.size() + 1, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = i + 1; j < steps.size(); ++j) {
      if (steps[i].line == steps[j].line ||
          std::abs(geometry::dot(steps[i].forward, steps[j].forward)) < kParallel)
        continue;
      const PlatePoint apart = steps[j].at - steps[i].at;
      if (std::abs(geometry::dot(steps[i].forward, apart)) > 1) continue;
      const double gap = std::abs(steps[i].forward.x * apart.y - steps[i].forward.y * apart.x);
      if (gap <= kSameLine_mm) continue;
      gaps[i] = std::min(gaps[i], gap);
      gaps[j] = std::min(gaps[j], gap);
    }
  }
  const auto crowded = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 20);
  std::nth_element(gaps.begin(), crowded, gaps.end());
  return *crowded;
}

}  // namespace nazori::practice
