// SPDX-License-Identifier: Apache-2.0
// Models of a plot, y ~ a x + b, become the curves that fit its points best.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "least_squares.h"
#include "regression_model.h"
#include "restricted_statement.h"

namespace nazori::functions {
namespace {

/// Each finite point of the statements.
std::vector<DataPoint> points_of(const Plot& plot) {
  std::vector<DataPoint> points;
  for (const Statement& s : plot.statements) {
    for (const TypedPoint& p : typed_points(s)) {
      const DataPoint at{constant_value(p.x), constant_value(p.y)};
      if (std::isfinite(at.x) && std::isfinite(at.y)) points.push_back(at);
    }
  }
  return points;
}

/// Those where the conditions behind the model hold.
std::vector<DataPoint> where(std::vector<DataPoint> points, const std::vector<Expression>& conditions) {
  for (const Expression& c : conditions) {
    const Tape tape = Tape::compile(std::array{c}, std::array{Variable::x});
    std::erase_if(
        points, [&tape](const DataPoint& p) { return !(tape.evaluate_one<double>(std::array{p.x}) > 0.5); });
  }
  return points;
}

/// 1 minus the residual sum as a share of the spread of y.
double r_squared(const std::vector<DataPoint>& points, double residual_sum) {
  long double sum = 0;
  for (const DataPoint& p : points) sum += p.y;
  const long double mean = sum / static_cast<long double>(points.size());
  long double spread = 0;
  for (const DataPoint& p : points) spread += (p.y - mean) * (p.y - mean);
  if (!(spread > 0)) return std::nan("");
  return static_cast<double>(1 - residual_sum / spread);
}

SyntaxError refusal(const Statement& s, const LeastSquares& best) {
  switch (best.outcome) {
    case FitOutcome::undefined:
      return {s.column, SyntaxFault::model_undefined, to_text(number(best.where))};
    case FitOutcome::undetermined:
      return {s.column, SyntaxFault::letters_undetermined};
    default:
      return {s.column, SyntaxFault::fit_not_found};
  }
}

tl::expected<Statement, SyntaxError> fitted(const Statement& typed, const std::vector<DataPoint>& all) {
  const auto [plain, conditions] = without_conditions(typed);
  const RegressionModel model(plain.terms[0]);
  const auto refuse = [&typed](SyntaxFault fault) {
    return tl::unexpected(SyntaxError{typed.column, fault});
  };
  if (model.letters().empty()) return refuse(SyntaxFault::no_letter);
  if (const std::string& letter = model.searched_under_integral(); !letter.empty())
    return tl::unexpected(SyntaxError{typed.column, SyntaxFault::letter_under_integral, letter});
  const std::vector<DataPoint> points = where(all, conditions);
  if (points.size() < model.letters().size()) {
    SyntaxError error{typed.column, SyntaxFault::too_few_points};
    error.number = static_cast<int>(points.size());
    error.wanted = static_cast<int>(model.letters().size());
    return tl::unexpected(std::move(error));
  }
  const LeastSquares best = fit(model, points);
  if (best.outcome != FitOutcome::found) return tl::unexpected(refusal(typed, best));
  auto result = std::make_shared<Fit>();
  for (std::size_t i = 0; i < best.values.size(); ++i)
    result->letters.push_back({model.letters()[i], best.values[i] + 0.0});
  result->points = points.size();
  result->residual_sum = best.residual_sum;
  result->r_squared = r_squared(points, best.residual_sum);
  Statement curve = typed;
  curve.is_model = false;
  curve.terms[0] = model.with_values(best.values);
  for (auto c = conditions.rbegin(); c != conditions.rend(); ++c)
    curve.terms[0] = call(Function::where, {*c, curve.terms[0]});
  curve.typed = std::make_shared<const Statement>(typed);
  curve.fit = std::move(result);
  return curve;
}

Statement statement_of(std::span<const DataPoint> data) {
  std::array<std::vector<Expression>, 2> places;
  for (const DataPoint& p : data) {
    places[0].push_back(number(p.x));
    places[1].push_back(number(p.y));
  }
  Statement s;
  s.kind = StatementKind::parametric;
  s.terms = {call(Function::list, std::move(places[0])), call(Function::list, std::move(places[1]))};
  s.is_point = s.range_given = s.is_data = true;
  s.from = number(0);
  s.to = number(1);
  return s;
}

}  // namespace

tl::expected<void, SyntaxError> fit_models(Plot& plot, std::span<const DataPoint> data) {
  if (!data.empty()) plot.statements.push_back(statement_of(data));
  const std::vector<DataPoint> points = points_of(plot);
  for (Statement& s : plot.statements) {
    if (!s.is_model) continue;
    auto curve = fitted(s, points);
    if (!curve) return tl::unexpected(std::move(curve.error()));
    s = std::move(*curve);
  }
  return {};
}

}  // namespace nazori::functions
