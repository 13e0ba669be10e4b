// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "nazori/model/braille.h"
#include "nazori/model/raised.h"
#include "nazori/print/page_drawing.h"

namespace nazori::practice {

/// Widths on swell paper [mm]. @source lines of 1 to 3 mm: guidelines for tactile graphics.
inline constexpr double kSwellLine_mm = 1.6;
inline constexpr double kSwellThinLine_mm = 1.0;  // thinner lines hardly swell

/// A page whose marks are given with y up, as plates are.
class SwellPage {
 public:
  SwellPage(double width_mm, double height_mm) : drawing_{width_mm, height_mm, {}, {}} {}

  /// @param grey  0 black, 1 white.
  void add_line(std::span<const model::PlatePoint> line, double width_mm, double grey = 0);
  void add_dot(model::PlatePoint at, double width_mm);
  void add_braille(std::span<const model::BrailleCell> cells, model::PlatePoint lower_left);
  /// Lines of braille below one another from `y_mm` down, as far as the margin of the page. A line that is
  /// too long goes on in the next.
  void add_text(std::span<const std::vector<model::BrailleCell>> lines, double y_mm);
  /// A stroke. Where its end sinks it becomes thinner, and so swells less.
  void add_stroke(const model::RaisedStroke& stroke);
  [[nodiscard]] print::PageDrawing take() { return std::move(drawing_); }

 private:
  [[nodiscard]] print::PaperPoint on_paper(model::PlatePoint p) const {
    return {p.x, drawing_.height_mm - p.y};
  }
  print::PageDrawing drawing_;
};

/// The distance of different lines that run side by side, where they are closest [mm]; infinite if none do.
/// Where one line leaves another they are closer, so the closest twentieth does not count.
[[nodiscard]] double closest_lines(std::span<const model::PlateLine> lines);

}  // namespace nazori::practice
