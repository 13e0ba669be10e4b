// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/base/result.h"
#include "nazori/functions/braille.h"
#include "nazori/functions/drawing.h"
#include "nazori/model/embosser.h"
#include "nazori/practice/touch_file.h"
#include "nazori/print/worksheet.h"

namespace nazori::practice {

/// The paper of a plot for fingers.
struct PlotPaper {
  double side_mm = 120;  ///< of the square of the plot on swell paper
  print::Paper paper = print::Paper::a4;
  model::EmbosserPaper embosser;
  functions::BrailleCode code = functions::BrailleCode::ueb;  ///< of the expression below the plot
};

/// A plot on paper: curves, axes with ticks, their numbers and the letters x and y in braille, the expression
/// below. On swell paper curves are 1.6 mm wide and axes 1 mm, interrupted 2 mm beside a curve; labels stand
/// 6.4 mm clear. For an embosser it is laid out as model::embossed_plot() does.
/// @return Errc::bad_argument for a machine without paper, a surface, or a square that does not fit, and the
/// errors of model::embossed_plot(). Thread-safe: yes.
/// @source BANA guidelines for tactile graphics: distances, gaps where lines cross.
[[nodiscard]] base::Result<TouchFile> plot_touch_file(TouchKind kind, const functions::Plot& plot,
                                                      const functions::Picture& picture,
                                                      const PlotPaper& paper = {});

}  // namespace nazori::practice
