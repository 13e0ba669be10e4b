// SPDX-License-Identifier: Apache-2.0
#include "lookalikes.h"

#include <limits>
#include <vector>

#include "fit.h"
#include "stroke_difference.h"

namespace nazori::writing {
namespace {

/// Deviation of each stroke, in order, under the map that fits best.
std::vector<double> deviations(std::span<const Shape> drawn, std::span<const Shape> model) {
  std::vector<FitPair> pairs;
  pairs.reserve(drawn.size());
  for (std::size_t k = 0; k < drawn.size(); ++k)
    pairs.push_back({&drawn[k].whole, &model[k].whole, false, 1});
  const auto map = fit(pairs, fit_by_moments(drawn, model).a);
  std::vector<double> result;
  result.reserve(drawn.size());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    Shape mapped;
    mapped.whole = transformed(drawn[k].whole, map);
    Shape whole;
    whole.whole = model[k].whole;
    const auto d = compare(mapped, whole);
    result.push_back(d.reversed ? std::numeric_limits<double>::infinity() : static_cast<double>(d.cost));
  }
  return result;
}

double sum(const std::vector<double>& values) {
  double s = 0;
  for (const double v : values) s += v;
  return s;
}

}  // namespace

double distance_of_forms(const Form& a, const Form& b) {
  if (a.shapes.size() != b.shapes.size()) return std::numeric_limits<double>::infinity();
  return sum(deviations(a.shapes, b.shapes));
}

std::optional<Mistaken> mistaken_for(std::span<const Shape> drawn, const Form& asked,
                                     std::span<const Model> lookalikes) {
  // Where the two models are `apart`, the difference of deviations is -apart for the asked character drawn as
  // the model and +apart for the other: the border lies a little on the other's side of the middle.
  constexpr double kBorder = 0.1;
  std::optional<Mistaken> result;
  double worst = kBorder;
  const auto own = deviations(drawn, asked.shapes);
  const double own_sum = sum(own);
  for (const auto& other : lookalikes) {
    const auto& form = other.inside().main;
    if (form.shapes.size() != drawn.size()) continue;
    const auto theirs = deviations(drawn, form.shapes);
    const double apart = distance_of_forms(form, asked);
    if (!(apart > 0)) continue;
    const double share = (own_sum - sum(theirs)) / apart;
    if (!(share > worst)) continue;
    worst = share;
    Mistaken m{other.code_point(), 0};
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < own.size(); ++k)
      if (own[k] - theirs[k] > most) {
        most = own[k] - theirs[k];
        m.stroke = static_cast<int>(k);
      }
    result = m;
  }
  return result;
}

}  // namespace nazori::writing
