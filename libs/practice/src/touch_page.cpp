// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "nazori/practice/touch_file.h"
#include "nazori/print/drawing_file.h"
#include "swell_page.h"

namespace nazori::practice {
namespace {

using Cells = std::vector<model::BrailleCell>;
using model::PlateLine;
using model::PlatePoint;

constexpr double kStartDot_mm = 3.0;
constexpr double kNumberClear_mm = 3.0;
constexpr double kBelow_mm = 20;  // from the square to the first line of the label

}  // namespace

base::Result<TouchFile> swell_file(std::span<const LabelledTablet> tablets, const SwellSettings& settings,
                                   const std::string& subject) {
  const auto [width, height] = print::paper_size(settings.paper);
  const double most = std::min(width, height) - 2 * print::kMargin_mm;
  if (!(settings.side_mm >= 10 && settings.side_mm <= most)) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a square of {:.4g} mm does not fit on this paper", settings.side_mm),
                      "swell paper", fmt::format("give 10 to {:.4g} mm", most));
  }
  if (tablets.empty())
    return base::fail(base::Errc::bad_argument, "there is no tablet", "swell paper", "give one or more");
  TouchFile file{TouchKind::swell_paper, {}, width, height, static_cast<int>(tablets.size()), {}, {}, 0};
  double closest = std::numeric_limits<double>::infinity();
  std::vector<print::PageDrawing> pages;
  for (const LabelledTablet& labelled : tablets) {
    std::vector<model::RaisedStroke> strokes = raised_strokes(labelled.tablet.strokes);
    if (strokes.empty()) {
      return base::fail(base::Errc::bad_argument, "a height map alone has no lines", "swell paper",
                        "add its strokes");
    }
    const PlatePoint corner{(width - settings.side_mm) / 2, height - print::kMargin_mm - settings.side_mm};
    SwellPage page(width, height);
    for (model::RaisedStroke& stroke : strokes) {
      for (PlatePoint& p : stroke.line) p = corner + p * settings.side_mm;
      page.add_stroke(stroke);
      if (settings.start_dots) page.add_dot(stroke.line.front(), kStartDot_mm);
    }
    model::RaisedStrokeSettings marks;
    marks.line.width_mm = kSwellLine_mm;
    marks.start_dots = settings.start_dots;
    marks.dot_width_mm = kStartDot_mm;
    marks.numbers = settings.numbers;
    marks.clear_mm = kNumberClear_mm;
    const model::StrokeNumbers numbers = model::stroke_numbers(strokes, width, height, marks);
    for (const model::StrokeNumber& number : numbers.numbers)
      page.add_braille(number.cells, number.lower_left);
    file.without_number.insert(file.without_number.end(), numbers.without_room.begin(),
                               numbers.without_room.end());
    std::vector<PlateLine> lines;
    for (model::RaisedStroke& stroke : strokes) lines.push_back(std::move(stroke.line));
    closest = std::min(closest, closest_lines(lines));
    if (settings.label) {
      const auto label = braille_lines(labelled.label, settings.english);
      if (!label) return tl::unexpected(label.error());
      page.add_text(*label, corner.y - kBelow_mm);
    }
    pages.push_back(page.take());
  }
  if (std::isfinite(closest)) file.closest_mm = closest;
  file.content = print::drawing_pdf(pages, subject);
  return file;
}

base::Result<TouchFile> embosser_file(std::span<const LabelledTablet> tablets,
                                      const EmbosserSettings& settings) {
  if (tablets.empty())
    return base::fail(base::Errc::bad_argument, "there is no tablet", "embosser", "give one or more");
  TouchFile file{TouchKind::embosser, {}, 0, 0, static_cast<int>(tablets.size()), {}, {}, 0};
  std::vector<model::EmbosserPage> pages;
  for (const LabelledTablet& labelled : tablets) {
    const auto label =
        settings.label ? braille_lines(labelled.label, settings.english) : base::Result<std::vector<Cells>>();
    if (!label) return tl::unexpected(label.error());
    auto made =
        model::embossed(raised_strokes(labelled.tablet.strokes), *label, settings.marks, settings.paper);
    if (!made) return tl::unexpected(std::move(made.error()));
    file.without_number.insert(file.without_number.end(), made->without_number.begin(),
                               made->without_number.end());
    pages.push_back(std::move(made->page));
  }
  file.width_mm = model::dot_x_mm(2 * settings.paper.columns - 1);
  file.height_mm = model::dot_y_mm(3 * settings.paper.lines - 1);
  file.content = model::to_brf(pages);
  return file;
}

}  // namespace nazori::practice
