// SPDX-License-Identifier: Apache-2.0
#include "arcs.h"

#include <utility>

#include "nazori/functions/curve_kinds.h"

namespace nazori::functions {

std::optional<Arc> arc_of(const Statement& s, const Window& w, double m) {
  const CurveKind& kind = curve_kind(s.kind);
  if (kind.course == nullptr) return std::nullopt;
  Course course = kind.course(s);
  Arc arc;
  arc.x = std::move(course.x);
  arc.y = std::move(course.y);
  arc.parameter = kind.parameter;
  if (kind.has_own_parameter()) {
    arc.from = constant_value(s.from);
    arc.to = constant_value(s.to);
    arc.ends_are_real = true;
    arc.from_is_open = s.from_is_open;
    arc.to_is_open = s.to_is_open;
  } else {
    const bool along_x = kind.parameter == Variable::x;
    arc.from = along_x ? w.x(-m) : w.y(-m);
    arc.to = along_x ? w.x(1 + m) : w.y(1 + m);
  }
  return arc;
}

Expression equation_of(const Statement& s) {
  const CurveKind& kind = curve_kind(s.kind);
  return kind.equation != nullptr ? kind.equation(s) : nullptr;
}

}  // namespace nazori::functions
