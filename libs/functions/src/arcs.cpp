// SPDX-License-Identifier: Apache-2.0
#include "arcs.h"

#include <utility>

#include "algebra.h"
#include "nazori/functions/curve_kinds.h"

namespace nazori::functions {

namespace {

/// Each point is an arc without length. Its parameter is its number, which tells it from the others.
std::vector<Arc> arcs_of_points(const Statement& s) {
  std::vector<Arc> arcs;
  for (const TypedPoint& p : typed_points(s)) {
    Arc arc;
    arc.x = p.x;
    arc.y = p.y;
    arc.parameter = Variable::t;
    arc.from = static_cast<double>(arcs.size());
    arc.to = arc.from + 1;
    arc.ends_are_real = true;
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

}  // namespace

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

std::vector<Arc> arcs_of(const Statement& s, const Window& window, double margin) {
  if (s.is_point) return arcs_of_points(s);
  if (auto arc = arc_of(s, window, margin)) return {std::move(*arc)};
  if (curve_kind(s.kind).drawn_by != DrawnBy::polar_equation) return {};
  const Expression whole = reduced(binary(NodeKind::subtract, s.terms[0], s.terms[1]));
  const auto polynomial = Polynomial::of(whole);
  const auto lone = polynomial ? polynomial->lone_power(Variable::r) : std::nullopt;
  if (!lone) return {};
  // c r^n + rest(theta) = 0
  const Expression rest = substitute(whole, Variable::r, number(0));
  const Expression power = binary(NodeKind::divide, negate(rest), number(lone->factor));
  const Expression radius = call(Function::root, {number(lone->power), power});
  const auto with = [&s](const Expression& r) {
    const Expression angle = variable(Variable::theta);
    return Arc{binary(NodeKind::multiply, r, call(Function::cos, {angle})),
               binary(NodeKind::multiply, r, call(Function::sin, {angle})),
               Variable::theta,
               constant_value(s.from),
               constant_value(s.to),
               true,
               s.from_is_open,
               s.to_is_open};
  };
  if (lone->power % 2 == 1) return {with(radius)};
  return {with(radius), with(negate(radius))};
}

Expression equation_of(const Statement& s) {
  const CurveKind& kind = curve_kind(s.kind);
  return kind.equation != nullptr ? kind.equation(s) : nullptr;
}

}  // namespace nazori::functions
