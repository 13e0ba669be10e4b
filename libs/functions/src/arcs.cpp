// SPDX-License-Identifier: Apache-2.0
#include "arcs.h"

namespace nazori::functions {

std::optional<Arc> arc_of(const Statement& s, const Window& w, double m) {
  switch (s.kind) {
    case StatementKind::explicit_y:
      return Arc{variable(Variable::x), s.terms[0], Variable::x, w.x(-m), w.x(1 + m), false};
    case StatementKind::explicit_x:
      return Arc{s.terms[0], variable(Variable::y), Variable::y, w.y(-m), w.y(1 + m), false};
    case StatementKind::parametric:
      return Arc{s.terms[0],           s.terms[1], Variable::t,    constant_value(s.from),
                 constant_value(s.to), true,       s.from_is_open, s.to_is_open};
    case StatementKind::polar: {
      const Expression angle = variable(Variable::theta);
      return Arc{binary(NodeKind::multiply, s.terms[0], call(Function::cos, {angle})),
                 binary(NodeKind::multiply, s.terms[0], call(Function::sin, {angle})),
                 Variable::theta,
                 constant_value(s.from),
                 constant_value(s.to),
                 true,
                 s.from_is_open,
                 s.to_is_open};
    }
    default:
      return std::nullopt;
  }
}

Expression equation_of(const Statement& s) {
  switch (s.kind) {
    case StatementKind::explicit_y:
      return binary(NodeKind::subtract, variable(Variable::y), s.terms[0]);
    case StatementKind::explicit_x:
      return binary(NodeKind::subtract, variable(Variable::x), s.terms[0]);
    case StatementKind::implicit:
      return binary(NodeKind::subtract, s.terms[0], s.terms[1]);
    default:
      return nullptr;
  }
}

}  // namespace nazori::functions
