// SPDX-License-Identifier: Apache-2.0
#include "zeros.h"

#include <algorithm>
#include <cmath>

#include "algebra.h"
#include "derivative.h"
#include "one_variable.h"
#include "roots.h"

namespace nazori::functions {
namespace {

/// Zeros between the zeros of the derivative, where the function rises or falls: of cos(x) - 1 + x^2/2, which
/// is smaller than rounding errors far around its zero.
std::vector<double> zeros_by_slope(const Expression& f, Variable v, double low, double high, int most_boxes,
                                   int depth);

std::vector<double> zeros_of_factor(const Expression& f, Variable v, double low, double high, int most_boxes,
                                    int depth) {
  const Roots found = find_roots(f, v, low, high, most_boxes);
  constexpr std::size_t kMostToRefine = 40;
  if (found.undecided > 0 && !found.has_ranges && depth < 4 && found.roots.size() < kMostToRefine &&
      is_total(f)) {
    std::vector<double> all = zeros_by_slope(f, v, low, high, most_boxes, depth + 1);
    if (!all.empty()) return all;
  }
  std::vector<double> all;
  for (const Root& r : found.roots) all.push_back(r.at);
  return all;
}

std::vector<double> zeros_by_slope(const Expression& f, Variable v, double low, double high, int most_boxes,
                                   int depth) {
  const Expression slope = derivative(f, v);
  if (!slope) return {};
  std::vector<double> turns{low};
  for (const Expression& factor : zero_factors(over_common_denominator(reduced(slope)).numerator)) {
    if (!depends_on(factor, v)) continue;
    for (const double t : zeros_of_factor(factor, v, low, high, most_boxes, depth)) turns.push_back(t);
  }
  turns.push_back(high);
  std::sort(turns.begin(), turns.end());
  const OneVariable g(f, v);
  std::vector<double> all;
  const auto is_zero = [&](double t) {
    const double hair = 4.4e-16 * std::max(std::abs(t), 1e-3 * (high - low));
    return g.range(t - hair, t + hair).contains(0);
  };
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double t = turns[i];
    if (i > 0 && i + 1 < turns.size() && is_zero(t)) all.push_back(t);
    if (i + 1 == turns.size() || is_zero(t) || is_zero(turns[i + 1])) continue;
    if ((g.value(t) < 0) != (g.value(turns[i + 1]) < 0))
      all.push_back(bisect(t, turns[i + 1], [&](double x) { return g.value(x); }));
  }
  return all;
}

}  // namespace

std::vector<double> zeros_of(const Expression& f, Variable v, double low, double high, int most_boxes) {
  std::vector<double> all;
  if (!f) return all;
  const double hair = 1e-10 * (high - low);
  for (const Expression& factor : zero_factors(over_common_denominator(reduced(f)).numerator)) {
    const auto p = Polynomial::of(factor);
    if (p && p->is_zero()) return {};
    const Expression root = p ? p->square_root() : nullptr;
    for (const Expression& part : root ? zero_factors(root) : std::vector<Expression>{factor}) {
      if (!depends_on(part, v)) continue;
      for (const double t : zeros_of_factor(part, v, low - hair, high + hair, most_boxes, 0))
        all.push_back(std::clamp(t, low, high));
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace nazori::functions
