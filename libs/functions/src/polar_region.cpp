// SPDX-License-Identifier: Apache-2.0
#include "polar_region.h"

#include <algorithm>

#include "algebra.h"

namespace nazori::functions {
namespace {

Expression angle(const Statement& s) {
  const Expression x = variable(Variable::x);
  const Expression y = variable(Variable::y);
  if (s.from && constant_value(s.from) < 0) return call(Function::atan2, {y, x});
  return binary(NodeKind::add, call(Function::atan2, {negate(y), negate(x)}), constant(Constant::pi));
}

}  // namespace

Statement in_the_plane(const Statement& s) {
  if (std::none_of(s.terms.begin(), s.terms.end(), [](const Expression& e) {
        return depends_on(e, Variable::r) || depends_on(e, Variable::theta);
      }))
    return s;
  const Expression x = variable(Variable::x);
  const Expression y = variable(Variable::y);
  const Expression theta = variable(Variable::theta);
  const Expression r = call(Function::sqrt, {binary(NodeKind::add, binary(NodeKind::power, x, number(2)),
                                                    binary(NodeKind::power, y, number(2)))});
  Statement plane = s;
  for (Expression& e : plane.terms) {
    e = substitute(e, Variable::r, r);
    // Without the discontinuity of an angle.
    e = replaced(e, call(Function::cos, {theta}), binary(NodeKind::divide, x, r));
    e = replaced(e, call(Function::sin, {theta}), binary(NodeKind::divide, y, r));
    e = substitute(e, Variable::theta, angle(s));
  }
  return plane;
}

std::vector<Condition> angle_bounds(const Statement& s) {
  if (!s.range_given) return {};
  const Expression at = angle(s);
  return {{binary(NodeKind::subtract, at, s.from), s.from_is_open},
          {binary(NodeKind::subtract, s.to, at), s.to_is_open}};
}

}  // namespace nazori::functions
