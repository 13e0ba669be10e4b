// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/placement_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nazori::practice {
namespace {

constexpr double kScale = 16;
/// After the fewest questions the check ends where half of what is probable spans less than this on the
/// scale.
constexpr double kNarrow = 0.15;
constexpr double kDoubt = 0.05;
/// Kanji of many strokes take long to write; fewer answers than these place nobody well.
constexpr int kFewestInTime = 8;
constexpr int kInTens = 100;
constexpr int kInFives = 20;

}  // namespace

PlacementCheck::PlacementCheck(std::vector<char32_t> by_difficulty, const PlacementRates& rates)
    : characters_(std::move(by_difficulty)), rates_(rates), asked_(characters_.size(), false) {
  const auto count = static_cast<int>(characters_.size());
  // Equal on the scale: each ability weighs as much as the part of the scale around it.
  for (int ability = 0; ability <= count; ++ability)
    weights_.push_back(scale(std::min<double>(count, ability + 0.5)) - scale(std::max(0.0, ability - 0.5)));
  choose_next();
}

double PlacementCheck::scale(double position) const {
  return std::log1p(kScale * position / std::max<double>(1, static_cast<double>(characters_.size())));
}

double PlacementCheck::chance(int ability, int position, PlacementAnswer answer) const {
  const double known =
      1 / (1 + std::exp((scale(position + 0.5) - scale(ability)) / std::max(rates_.spread, 1e-9)));
  switch (answer) {
    case PlacementAnswer::written:
      return rates_.luck + (1 - rates_.luck - rates_.slip - rates_.modest) * known;
    case PlacementAnswer::refused:
      // Of the characters that cannot be written about half are tried.
      return rates_.slip * known + 0.5 * (1 - rates_.luck) * (1 - known);
    case PlacementAnswer::unknown:
      return rates_.modest * known + 0.5 * (1 - rates_.luck) * (1 - known);
  }
  return 1;
}

std::optional<char32_t> PlacementCheck::question() const {
  if (!next_) return std::nullopt;
  return characters_[static_cast<std::size_t>(*next_)];
}

void PlacementCheck::answer(PlacementAnswer answer, std::chrono::milliseconds elapsed) {
  if (!next_) return;
  for (std::size_t ability = 0; ability < weights_.size(); ++ability)
    weights_[ability] *= chance(static_cast<int>(ability), *next_, answer);
  const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  if (sum > 0)
    for (double& weight : weights_) weight /= sum;
  asked_[static_cast<std::size_t>(*next_)] = true;
  ++answered_;
  next_.reset();
  if (answered_ >= kMost || (elapsed >= kLongest && answered_ >= kFewestInTime)) return;
  const bool narrow = scale(quantile(0.75)) - scale(quantile(0.25)) < kNarrow;
  if (answered_ >= kFewest && narrow) return;
  choose_next();
}

int PlacementCheck::quantile(double share) const {
  const double all = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  double so_far = 0;
  for (std::size_t ability = 0; ability < weights_.size(); ++ability) {
    so_far += weights_[ability];
    if (so_far >= share * all) return static_cast<int>(ability);
  }
  return static_cast<int>(characters_.size());
}

int PlacementCheck::rounded_ability() const {
  // Nobody is said to know a few who may well know none.
  if (quantile(kDoubt) == 0) return 0;
  const int exact = ability();
  const int step = exact >= kInTens ? 10 : exact >= kInFives ? 5 : 1;
  return std::min((exact + step / 2) / step * step, static_cast<int>(characters_.size()));
}

void PlacementCheck::choose_next() {
  const int middle = ability();
  const auto count = static_cast<int>(characters_.size());
  // The character at the median and those around it, the easier one first.
  for (int distance = 0; distance <= count; ++distance) {
    for (const int position : {middle - 1 - distance, middle + distance}) {
      if (position < 0 || position >= count || asked_[static_cast<std::size_t>(position)]) continue;
      next_ = position;
      return;
    }
  }
}

}  // namespace nazori::practice
