// SPDX-License-Identifier: Apache-2.0
#include "stroke_matching.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "alignment_costs.h"
#include "assignment.h"

namespace nazori::writing {
namespace {

/// Whether a line leads from where the first stroke starts to where the second ends.
bool goes_through_both(const Samples& drawn, const Samples& both, const Samples& first,
                       const Samples& second) {
  const auto at = [](const Samples& samples, std::size_t k) {
    return geometry::GlyphPoint{static_cast<double>(samples.x[k]), static_cast<double>(samples.y[k])};
  };
  const auto nearer = [&](const Samples& wanted, const Samples& other, std::size_t k) {
    const auto right = at(wanted, k), wrong = at(other, k), here = at(drawn, k);
    // Where both strokes end in one corner, that end is not significant.
    return 6 * geometry::dot(right - wrong, right - wrong) < static_cast<double>(both.length * both.length) ||
           geometry::distance(here, right) <= geometry::distance(here, wrong);
  };
  return nearer(first, second, 0) && nearer(second, first, kSamples - 1);
}

}  // namespace

Alignment explanation_of(std::vector<Link> links, float cost, std::size_t drawn_count,
                         std::size_t model_count, Extent extent) {
  Alignment a;
  a.links = std::move(links);
  a.cost = cost;
  std::sort(a.links.begin(), a.links.end(), [](const Link& x, const Link& y) { return x.drawn < y.drawn; });
  std::vector<char> drawn(drawn_count), model(model_count);
  int last = -1;
  for (const auto& l : a.links) {
    std::fill_n(drawn.begin() + l.drawn, l.drawn_count, 1);
    std::fill_n(model.begin() + l.model, l.model_count, 1);
    last = std::max(last, l.model + l.model_count - 1);
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (drawn[i] == 0) a.extra.push_back(static_cast<int>(i));
  for (std::size_t j = 0; j < model.size(); ++j)
    if (model[j] == 0 && (extent == Extent::whole || static_cast<int>(j) < last))
      a.missing.push_back(static_cast<int>(j));
  return a;
}

StrokeMatching::StrokeMatching(StrokeComparer& strokes, Extent extent, float far)
    : strokes_(strokes),
      extent_(extent),
      far_(far),
      n_(strokes.drawn().size()),
      m_(strokes.model().size()),
      costs_(n_ * m_),
      cells_((n_ + 1) * (m_ + 1)) {}

Alignment StrokeMatching::best(const Affine& map) {
  strokes_.lay(map);
  std::fill(costs_.begin(), costs_.end(), -1.0F);
  auto a = in_order();
  if (a.cost > kOutOfOrder && least_in_any_order() + kOutOfOrder < a.cost) {
    auto b = in_any_order();
    if (b.cost + kOutOfOrder < a.cost) {
      b.cost += kOutOfOrder;
      a = std::move(b);
    }
  }
  a.map = map;
  return a;
}

float StrokeMatching::cost(std::size_t i, std::size_t j) {
  float& known = costs_[i * m_ + j];
  if (known < 0) known = strokes_.cost(i, j, far_);
  return known;
}

float StrokeMatching::match_cost(std::size_t i, std::size_t j) {
  return strokes_.least_cost(i, j) >= kWrong ? kWrong : std::min(cost(i, j), kWrong);
}

/// The cost of one explanation: strokes in their order, and those of the longer side left out at one place.
float StrokeMatching::around_a_gap() {
  const std::size_t shorter = std::min(n_, m_);
  const std::size_t more_drawn = n_ - shorter;
  const std::size_t more_model = m_ - shorter;
  const float gap = static_cast<float>(more_drawn) * extra_cost(extent_) +
                    (extent_ == Extent::whole ? kMissing * static_cast<float>(more_model) : 0);
  float sum = 0;
  for (std::size_t k = 0; k < shorter; ++k) sum += match_cost(k, k);
  // While the character is being written, what is left out comes last.
  if (n_ == m_ || (extent_ == Extent::beginning && n_ < m_)) return sum + gap;
  float least = sum;
  for (std::size_t k = shorter; k-- > 0;) {
    sum += match_cost(k + more_drawn, k + more_model) - match_cost(k, k);
    least = std::min(least, sum);
  }
  return least + gap;
}

/// What strokes i and j and all after them cost at least, because one side has more.
float StrokeMatching::rest(std::size_t i, std::size_t j) const {
  const std::size_t drawn = n_ - i;
  const std::size_t model = m_ - j;
  if (drawn > model) return kSplit * static_cast<float>(drawn - model);
  return extent_ == Extent::whole ? kJoined * static_cast<float>(model - drawn) : 0;
}

void StrokeMatching::improve(std::size_t i, std::size_t j, float cost, Move move, std::size_t missed) {
  auto& c = cell(i, j);
  if (cost < c.cost) c = {cost, move, static_cast<unsigned char>(missed)};
}

void StrokeMatching::try_match(std::size_t i, std::size_t j, float here) {
  const float least = std::min(strokes_.least_cost(i, j), kWrong);
  if (here + least + rest(i + 1, j + 1) > enough_) return;
  improve(i + 1, j + 1, here + match_cost(i, j), Move::match);
}

/// A line that is two strokes written without lifting the pen is about as long as both, and leads from where
/// the first starts to where the second ends. Else it is one of the two, and the other is missing.
void StrokeMatching::try_join(std::size_t i, std::size_t j, float here) {
  const auto pairs = strokes_.pairs();
  if (j >= pairs.size() || n_ >= m_ + 1 || here + kJoined >= cell(i + 1, j + 2).cost ||
      here + kJoined + rest(i + 1, j + 2) > enough_)
    return;
  constexpr float kAccept = kAcceptCost * 1.5F;
  if (strokes_.least_cost_with_pair(i, j) >= kAccept || !strokes_.is_as_long_as_pair(i, j)) return;
  // Only where one alone does not explain it.
  if (cost(i, j) <= 2) return;
  const auto e = strokes_.compare_with_pair(i, j, kFar);
  if (e.reversed || e.cost >= kAccept) return;
  // A short stroke makes little difference to a long one: where it was left out, the shape of the long one
  // alone fits better.
  constexpr float kSlack = 1.15F;
  const float alone =
      std::min(strokes_.compare(i, j, kFar).proportion, strokes_.compare(i, j + 1, kFar).proportion);
  if (e.proportion >= kSlack * alone) return;
  if (goes_through_both(strokes_.laid_line(i), pairs[j].whole, strokes_.model()[j].whole,
                        strokes_.model()[j + 1].whole))
    improve(i + 1, j + 2, here + e.cost + kJoined, Move::join);
}

void StrokeMatching::try_split(std::size_t i, std::size_t j, float here) {
  if (i + 1 >= n_ || n_ <= m_ || here + kSplit >= cell(i + 2, j + 1).cost ||
      here + kSplit + rest(i + 2, j + 1) > enough_)
    return;
  if (strokes_.least_cost_of_joined(i, j) >= kAcceptCost || cost(i, j) <= 2) return;
  const auto e = compare(strokes_.joined_drawn(i), strokes_.model()[j], kFar);
  if (!e.reversed && e.cost < kAcceptCost) improve(i + 2, j + 1, here + e.cost + kSplit, Move::split);
}

void StrokeMatching::go_on_from(std::size_t i, std::size_t j) {
  const float here = cell(i, j).cost;
  if (here + rest(i, j) > enough_) return;
  if (j < m_ && extent_ == Extent::whole) improve(i, j + 1, here + kMissing, Move::missing);
  if (extent_ == Extent::beginning)
    for (std::size_t gap = 1; j + gap <= m_; ++gap)
      improve(i, j + gap, here + (i == n_ ? 0 : missing_cost(extent_, gap)), Move::missing, gap);
  if (i < n_) improve(i + 1, j, here + extra_cost(extent_), Move::extra);
  if (i >= n_ || j >= m_) return;
  try_match(i, j, here);
  try_join(i, j, here);
  try_split(i, j, here);
}

Link StrokeMatching::link_of(std::size_t i, std::size_t j, Move move) {
  Link link{static_cast<int>(i), 1, static_cast<int>(j), 1, {}};
  if (move == Move::join) {
    link.model_count = 2;
    link.difference = strokes_.compare_with_pair(i, j, kFar);
  } else if (move == Move::split) {
    link.drawn_count = 2;
    link.difference = compare(strokes_.joined_drawn(i), strokes_.model()[j], kFar);
  } else {
    link.difference = strokes_.compare(i, j, far_);
  }
  return link;
}

/// The best explanation that keeps the order: dynamic programming over prefixes.
Alignment StrokeMatching::in_order() {
  constexpr float kRounding = 1e-3F;
  enough_ = around_a_gap() * (1 + kRounding) + kRounding;
  std::fill(cells_.begin(), cells_.end(), Cell{kNever, Move::none, 1});
  cell(0, 0).cost = 0;
  for (std::size_t i = 0; i <= n_; ++i)
    for (std::size_t j = 0; j <= m_; ++j) go_on_from(i, j);
  std::vector<Link> links;
  links.reserve(n_);
  std::size_t i = n_;
  std::size_t j = m_;
  while (i > 0 || j > 0) {
    const auto [unused, move, missed] = cell(i, j);
    const std::size_t used_drawn = move == Move::missing ? 0 : move == Move::split ? 2 : 1;
    const std::size_t used_model = move == Move::extra     ? 0
                                   : move == Move::join    ? 2
                                   : move == Move::missing ? missed
                                                           : 1;
    i -= used_drawn;
    j -= used_model;
    if (used_drawn > 0 && used_model > 0) links.push_back(link_of(i, j, move));
  }
  return explanation_of(std::move(links), cell(n_, m_).cost, n_, m_, extent_);
}

/// What the best explanation in any order costs at least: each drawn stroke as the one that suits it best.
float StrokeMatching::least_in_any_order() {
  std::vector<float> least(n_, kWrong);
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < m_; ++j)
      if (strokes_.least_cost(i, j) < least[i]) least[i] = std::min(least[i], cost(i, j));
  std::sort(least.begin(), least.end());
  float sum = 0;
  for (std::size_t i = 0; i < n_; ++i) sum += i < m_ ? least[i] : extra_cost(extent_);
  if (extent_ == Extent::whole && m_ > n_) sum += kMissing * static_cast<float>(m_ - n_);
  return sum;
}

/// The best explanation in any order, without joined or split strokes.
Alignment StrokeMatching::in_any_order() {
  const std::size_t size = std::max(n_, m_);
  std::vector<float> costs(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      auto& c = costs[i * size + j];
      if (i >= n_)
        c = extent_ == Extent::beginning ? 0 : kMissing;
      else if (j >= m_)
        c = extra_cost(extent_);
      else
        c = match_cost(i, j);
    }
  }
  const auto columns = assign(costs, size);
  std::vector<Link> links;
  links.reserve(n_);
  float total = 0;
  std::vector<std::size_t> strange_drawn;
  std::vector<std::size_t> strange_model;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t j = columns[i];
    total += costs[i * size + j];
    if (i >= n_ || j >= m_) continue;
    if (costs[i * size + j] < kWrong) {
      links.push_back(link_of(i, j, Move::match));
    } else {
      strange_drawn.push_back(i);
      strange_model.push_back(j);
    }
  }
  // Wrong strokes are matched in their order.
  std::sort(strange_model.begin(), strange_model.end());
  for (std::size_t k = 0; k < strange_drawn.size(); ++k)
    links.push_back(link_of(strange_drawn[k], strange_model[k], Move::match));
  auto result = explanation_of(std::move(links), total, n_, m_, extent_);
  if (extent_ == Extent::beginning) result.cost += missing_cost(extent_, result.missing.size());
  return result;
}

}  // namespace nazori::writing
