// SPDX-License-Identifier: Apache-2.0
#include "asymptotes.h"

#include <algorithm>

#include "algebra.h"
#include "far_out.h"
#include "nazori/functions/curve_kinds.h"

namespace nazori::functions {
namespace {

/// Whether the line y = slope x + intercept (or the same with x and y exchanged) passes through the window.
bool is_in_window(const Window& w, double slope, double intercept, bool of_x) {
  const double from = of_x ? w.x0 : w.y0;
  const double to = of_x ? w.x1 : w.y1;
  const double low = of_x ? w.y0 : w.x0;
  const double high = of_x ? w.y1 : w.x1;
  const double a = slope * from + intercept;
  const double b = slope * to + intercept;
  return std::max(a, b) >= low && std::min(a, b) <= high;
}

}  // namespace

void add_asymptotes(int statement, PointList& list) {
  const Statement& s = list.statement(statement);
  const CurveKind& kind = curve_kind(s.kind);
  if (!kind.is_graph_of_x() && !kind.is_graph_of_y()) return;
  const bool of_x = kind.is_graph_of_x();
  const Window& w = list.window();
  // A line is no asymptote of itself.
  const auto q = Polynomial::of(reduced(s.terms[0]));
  if (q && q->constant()) return;
  if (q && q->linear_factor(kind.parameter)) {
    const auto rest = Polynomial::of(substitute(reduced(s.terms[0]), kind.parameter, number(0)));
    if (rest && rest->constant()) return;
  }
  const FarBehaviour before = far_behaviour(s.terms[0], kind.parameter, -1);
  const FarBehaviour after = far_behaviour(s.terms[0], kind.parameter, 1);
  const bool alike = before == after;
  const auto add = [&](const FarBehaviour& far, int side) {
    if (far.coincides) return;
    if (far.kind == FarOut::level && is_in_window(w, 0, far.intercept, of_x)) {
      PointOfInterest* const added =
          of_x ? list.add(statement, PointKind::horizontal_asymptote, PointList::kNaN, far.intercept)
               : list.add(statement, PointKind::vertical_asymptote, far.intercept, PointList::kNaN);
      if (added != nullptr) {
        added->side = side;
        added->along_y = !of_x;
      }
    }
    if (far.kind == FarOut::slanted && is_in_window(w, far.slope, far.intercept, of_x))
      list.add_slanted(statement, of_x ? far.slope : 1 / far.slope,
                       of_x ? far.intercept : -far.intercept / far.slope, side)
          .along_y = !of_x;
  };
  if (alike) {
    add(before, 0);
  } else {
    add(before, -1);
    add(after, 1);
  }
}

}  // namespace nazori::functions
