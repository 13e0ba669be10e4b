// SPDX-License-Identifier: Apache-2.0
#include "probability.h"

#include <algorithm>
#include <cmath>

#include "judgement.h"

namespace nazori::writing {
namespace {

// How fast the odds fall: a stroke of twice the limit is accepted by 1 teacher in 17. docs/writing.md has the
// reliability table.
constexpr double kPerFactorE = 4.0;
constexpr double kWithAnotherMistake = 0.01;

double of_deviation(double deviation) {
  constexpr double kLeast = 1e-3;
  return 1 / (1 + std::pow(std::max(deviation, kLeast), kPerFactorE));
}

/// Strokes too few or too many, backwards, out of turn, or another character's: no teacher accepts them.
bool is_of_structure(const Mistake& mistake) {
  return mistake.kind != kanji::MistakeKind::wrong && mistake.kind != kanji::MistakeKind::ending;
}

}  // namespace

double probability_of(const Grade& grade, double deviation) {
  const double p = of_deviation(deviation);
  const auto has_one = [](const std::vector<Mistake>& mistakes) {
    return std::any_of(mistakes.begin(), mistakes.end(), is_of_structure);
  };
  return has_one(grade.mistakes) || has_one(grade.advice) ? std::min(p, kWithAnotherMistake) : p;
}

double deviation_of(double log_odds) { return std::exp(log_odds / kPerFactorE); }

double needed_probability(double strictness) { return of_deviation(deviation_limit(strictness)); }

}  // namespace nazori::writing
