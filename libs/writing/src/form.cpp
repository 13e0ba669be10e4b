// SPDX-License-Identifier: Apache-2.0
#include "form.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nazori::writing {
namespace {

// Square roots of deviations, the mean of all strokes. Of 4,869 accepted writings of three sources a quarter
// lies below the first limit and a tenth above the third; docs/writing.md has the table.
constexpr std::array<double, kBestForm - 1> kLimits{0.25, 0.34, 0.43, 0.52};

}  // namespace

int form_stars(const Grade& grade) {
  double sum = 0;
  for (const auto& stroke : grade.strokes) sum += std::sqrt(stroke.deviation);
  const double mean = sum / static_cast<double>(grade.strokes.size());
  int stars = kBestForm - static_cast<int>(std::count_if(kLimits.begin(), kLimits.end(),
                                                         [mean](double limit) { return mean > limit; }));
  // One spoiled stroke among many right ones hardly moves the mean, but everybody sees it.
  const auto is_about_form = [](const Mistake& m) { return m.kind == kanji::MistakeKind::wrong; };
  stars -= static_cast<int>(std::count_if(grade.advice.begin(), grade.advice.end(), is_about_form));
  const auto is_ending = [](const Mistake& m) { return m.kind == kanji::MistakeKind::ending; };
  if (std::any_of(grade.advice.begin(), grade.advice.end(), is_ending)) --stars;
  return std::clamp(stars, 1, kBestForm);
}

}  // namespace nazori::writing
