// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/value_table.h"

#include <array>
#include <cmath>

#include "nazori/functions/curve_kinds.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {

namespace {

/// The points themselves, whatever the steps are.
std::vector<ValueRow> table_of_points(const Statement& statement) {
  std::vector<ValueRow> rows;
  for (const TypedPoint& p : typed_points(statement))
    rows.push_back({static_cast<double>(rows.size()), constant_value(p.x), constant_value(p.y)});
  return rows;
}

}  // namespace

base::Result<std::vector<ValueRow>> value_table(const Statement& statement, const ValueSteps& steps) {
  const CurveKind& kind = curve_kind(statement.kind);
  if (kind.course == nullptr)
    return base::fail(base::Errc::bad_argument, "has no table of values", canonical(statement),
                      "give a curve such as y = f(x)");
  // 0 to 1 by 0.1 has 11 rows, although (1 - 0)/0.1 may be rounded below 10.
  const double count = std::floor((steps.to - steps.from) / steps.step + 1e-9);
  if (!(steps.step > 0) || !(count >= 0) || !(count < ValueSteps::kMostRows) || !std::isfinite(steps.from))
    return base::fail(base::Errc::bad_argument, "the steps of the table lead nowhere", "table",
                      "give a smaller number, a larger one and a step for at most 10000 rows");
  if (statement.is_point) return table_of_points(statement);
  const Course course = kind.course(statement);
  const Tape tape = Tape::compile(std::array{course.x, course.y}, std::array{kind.parameter});
  std::vector<double> registers(tape.size());
  std::vector<ValueRow> rows;
  for (int i = 0; i <= static_cast<int>(count); ++i) {
    const double at = steps.from + i * steps.step;
    tape.evaluate<double>(std::array{at}, registers);
    rows.push_back({at, registers[tape.output(0)], registers[tape.output(1)]});
  }
  return rows;
}

}  // namespace nazori::functions
