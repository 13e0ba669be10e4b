// SPDX-License-Identifier: Apache-2.0
#include "lookalike_contrast.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "fit.h"

namespace nazori::writing {
namespace {

/// Squared deviation of both ends and of the shape, in units of the natural variation. Unlike
/// StrokeDifference::cost it includes hooks and is strict about lengths and ends, because they distinguish
/// lookalikes.
double contrast(const Samples& d, const Samples& m) {
  constexpr double kEnds = 5.0;         // glyph units
  constexpr double kProportion = 0.07;  // of the length
  const auto squared = [](float x, float y) { return static_cast<double>(x * x + y * y); };
  const double ends = squared(d.x.front() - m.x.front(), d.y.front() - m.y.front()) +
                      squared(d.x.back() - m.x.back(), d.y.back() - m.y.back());
  const float fd = 1 / std::max(d.length, 1.0F);
  const float fm = 1 / std::max(m.length, 1.0F);
  double proportion = 0;
  for (std::size_t k = 0; k < kSamples; ++k)
    proportion += squared((d.x[k] - d.centre_x) * fd - (m.x[k] - m.centre_x) * fm,
                          (d.y[k] - d.centre_y) * fd - (m.y[k] - m.centre_y) * fm);
  return ends / (kEnds * kEnds) + proportion / static_cast<double>(kSamples) / (kProportion * kProportion);
}

/// Deviation of each stroke, in order, under the map that fits best.
std::vector<double> deviations(std::span<const Shape> drawn, std::span<const Shape> model) {
  std::vector<FitPair> pairs;
  pairs.reserve(drawn.size());
  for (std::size_t k = 0; k < drawn.size(); ++k)
    pairs.push_back({&drawn[k].whole, &model[k].whole, false, 1});
  const auto map = fit(pairs, fit_by_moments(drawn, model).a);
  std::vector<double> result;
  result.reserve(drawn.size());
  for (std::size_t k = 0; k < drawn.size(); ++k)
    result.push_back(contrast(transformed(drawn[k].whole, map), model[k].whole));
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
  // the model and +apart for the other: the limit lies on the other's side of the middle, further away the
  // smaller the difference is.
  constexpr double kBorder = 0.1;
  constexpr double kDoubt = 2.0;
  std::optional<Mistaken> result;
  double worst = 0;
  const auto own = deviations(drawn, asked.shapes);
  const double own_sum = sum(own);
  for (const auto& other : lookalikes) {
    const auto& form = other.inside().main;
    if (form.shapes.size() != drawn.size()) continue;
    const auto theirs = deviations(drawn, form.shapes);
    const double apart = distance_of_forms(form, asked);
    if (!(apart > 0)) continue;
    const double share = (own_sum - sum(theirs)) / apart - kBorder - kDoubt / apart;
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
