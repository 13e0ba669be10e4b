// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/curve_kinds.h"

#include <cassert>

namespace nazori::functions {
namespace {

Expression difference(Expression a, Expression b) {
  return binary(NodeKind::subtract, std::move(a), std::move(b));
}

Course graph_of_x(const Statement& s) { return {variable(Variable::x), s.terms[0]}; }
Expression above_x(const Statement& s) { return difference(variable(Variable::y), s.terms[0]); }

Course graph_of_y(const Statement& s) { return {s.terms[0], variable(Variable::y)}; }
Expression beside_y(const Statement& s) { return difference(variable(Variable::x), s.terms[0]); }

Expression left_minus_right(const Statement& s) { return difference(s.terms[0], s.terms[1]); }

Course parametric(const Statement& s) { return {s.terms[0], s.terms[1]}; }

Course polar(const Statement& s) {
  const Expression angle = variable(Variable::theta);
  return {binary(NodeKind::multiply, s.terms[0], call(Function::cos, {angle})),
          binary(NodeKind::multiply, s.terms[0], call(Function::sin, {angle}))};
}

using K = StatementKind;
using D = DrawnBy;
using R = RangeFrom;
using V = Variable;

constexpr CurveKind kKinds[] = {
    // kind, name, left, drawn by, range, parameter, course, equation
    {K::explicit_y, "explicit", {V::y}, D::course, R::window, V::x, graph_of_x, above_x},
    {K::explicit_x, "explicit", {V::x}, D::course, R::window, V::y, graph_of_y, beside_y},
    {K::implicit, "implicit", {}, D::equation, R::nothing, V::x, nullptr, left_minus_right},
    {K::inequality, "inequality", {}, D::region, R::if_it_is_given, V::theta, nullptr, nullptr},
    {K::parametric, "parametric", {V::x, V::y}, D::course, R::statement, V::t, parametric, nullptr},
    {K::polar, "polar", {V::r}, D::course, R::statement, V::theta, polar, nullptr},
    {K::polar_implicit, "polar", {}, D::polar_equation, R::statement, V::theta, nullptr, nullptr},
    {K::surface, "surface", {V::z}, D::heights, R::nothing, V::x, nullptr, nullptr},
};

}  // namespace

std::span<const CurveKind> curve_kinds() { return kKinds; }

const CurveKind& curve_kind(StatementKind kind) {
  const CurveKind& row = kKinds[static_cast<std::size_t>(kind)];
  assert(row.kind == kind);
  return row;
}

}  // namespace nazori::functions
