// SPDX-License-Identifier: Apache-2.0
#include "alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "assignment.h"
#include "fit.h"

namespace nazori::writing {
namespace {

// Costs of everything but a right stroke, in the units of StrokeDifference::cost.
constexpr float kWrong = 34;    // a wrong stroke in place of a right one
constexpr float kMissing = 24;  // wrong < missing + extra
constexpr float kExtra = 24;
constexpr float kJoined = 19;  // joined < missing, or every joined pair would count as a missing stroke
constexpr float kSplit = 16;
constexpr float kOutOfOrder = 3.5F;
constexpr float kFar = 60;  // beyond kWrong, because the learner is told how wrong strokes differ
constexpr float kNever = std::numeric_limits<float>::max();

/// While the character is still being written, a wrong stroke counts as the one that is due.
float extra_cost(Extent extent) { return extent == Extent::beginning ? kWrong + 2 : kExtra; }

/// Cost of `count` strokes not drawn. While the character is still being written, beginning with a later
/// stroke costs the same however many are skipped; otherwise that stroke would count as extra.
float missing_cost(Extent extent, std::size_t count) {
  constexpr float kPassedOver = 12;
  constexpr float kEachMore = 1;
  constexpr float kMost = 16;
  const auto strokes = static_cast<float>(count);
  if (extent == Extent::whole || count == 0) return kMissing * strokes;
  return std::min(kPassedOver + kEachMore * (strokes - 1), kMost);
}

/// Everything that is compared under one map.
struct Table {
  std::size_t drawn_count;
  std::size_t model_count;
  std::vector<Shape> mapped;
  std::vector<StrokeDifference> differences;  // drawn by model

  [[nodiscard]] const StrokeDifference& at(std::size_t i, std::size_t j) const {
    return differences[i * model_count + j];
  }
};

Table tabulate(const AlignmentInput& input, const Affine& map, float far) {
  Table t{input.drawn.size(), input.model.size(), {}, {}};
  t.mapped.reserve(t.drawn_count);
  for (const auto& d : input.drawn) t.mapped.push_back(transformed(d, map));
  t.differences.reserve(t.drawn_count * t.model_count);
  for (const auto& d : t.mapped)
    for (const auto& m : input.model) t.differences.push_back(compare(d, m, far));
  return t;
}

Alignment collect(std::vector<Link> links, const AlignmentInput& input, float cost) {
  Alignment a;
  a.links = std::move(links);
  a.cost = cost;
  std::sort(a.links.begin(), a.links.end(), [](const Link& x, const Link& y) { return x.drawn < y.drawn; });
  std::vector<char> drawn(input.drawn.size()), model(input.model.size());
  int last = -1;
  for (const auto& l : a.links) {
    std::fill_n(drawn.begin() + l.drawn, l.drawn_count, 1);
    std::fill_n(model.begin() + l.model, l.model_count, 1);
    last = std::max(last, l.model + l.model_count - 1);
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (drawn[i] == 0) a.extra.push_back(static_cast<int>(i));
  for (std::size_t j = 0; j < model.size(); ++j)
    if (model[j] == 0 && (input.extent == Extent::whole || static_cast<int>(j) < last))
      a.missing.push_back(static_cast<int>(j));
  return a;
}

/// A line that is two strokes written without lifting the pen is about as long as both, and leads from where
/// the first starts to where the second ends. Else it is one of the two, and the other is missing.
bool goes_through_both(const Samples& drawn, const Samples& both, const Samples& first,
                       const Samples& second) {
  const auto ratio = [&drawn](const Samples& model) {
    constexpr float kFloor = 0.3F;
    return std::abs(std::log((drawn.length + kFloor) / (model.length + kFloor)));
  };
  constexpr float kSlack = 0.2F;
  if (ratio(both) > std::min(ratio(first), ratio(second)) + kSlack) return false;
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

/// The best explanation that keeps the order: dynamic programming over prefixes.
Alignment align_in_order(const AlignmentInput& input, const Table& t) {
  const std::size_t n = t.drawn_count;
  const std::size_t m = t.model_count;
  enum Move : unsigned char { none, match, missing, extra, join, split };
  struct Cell {
    float cost = kNever;
    Move move = none;
    std::size_t missed = 1;  // model strokes a `missing` passes over
    StrokeDifference difference;
  };
  std::vector<Cell> cells((n + 1) * (m + 1));
  const auto cell = [&cells, m](std::size_t i, std::size_t j) -> Cell& { return cells[i * (m + 1) + j]; };
  const auto improve = [](Cell& c, float cost, Move move, const StrokeDifference& difference,
                          std::size_t missed = 1) {
    if (cost < c.cost) c = {cost, move, missed, difference};
  };
  cell(0, 0).cost = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) {
      const float here = cell(i, j).cost;
      if (j < m && input.extent == Extent::whole) improve(cell(i, j + 1), here + kMissing, missing, {});
      if (input.extent == Extent::beginning)
        for (std::size_t gap = 1; j + gap <= m; ++gap)
          improve(cell(i, j + gap), here + (i == n ? 0 : missing_cost(input.extent, gap)), missing, {}, gap);
      if (i < n) improve(cell(i + 1, j), here + extra_cost(input.extent), extra, {});
      if (i < n && j < m) {
        const auto& d = t.at(i, j);
        improve(cell(i + 1, j + 1), here + std::min(d.cost, kWrong), match, d);
        // Only where one alone does not explain it.
        if (j < input.pairs.size() && n < m + 1 && d.cost > 2 && here + kJoined < cell(i + 1, j + 2).cost) {
          const auto e = compare(t.mapped[i], input.pairs[j], kFar);
          if (!e.reversed && e.cost < kAcceptCost * 1.5F &&
              goes_through_both(t.mapped[i].whole, input.pairs[j].whole, input.model[j].whole,
                                input.model[j + 1].whole))
            improve(cell(i + 1, j + 2), here + e.cost + kJoined, join, e);
        }
        if (i + 1 < n && n > m && d.cost > 2 && here + kSplit < cell(i + 2, j + 1).cost) {
          const auto e = compare(joined(t.mapped[i].whole, t.mapped[i + 1].whole), input.model[j], kFar);
          if (!e.reversed && e.cost < kAcceptCost)
            improve(cell(i + 2, j + 1), here + e.cost + kSplit, split, e);
        }
      }
    }
  }
  std::vector<Link> links;
  std::size_t i = n;
  std::size_t j = m;
  while (i > 0 || j > 0) {
    const auto& c = cell(i, j);
    const std::size_t used_drawn = c.move == missing ? 0 : c.move == split ? 2 : 1;
    const std::size_t used_model = c.move == extra     ? 0
                                   : c.move == join    ? 2
                                   : c.move == missing ? c.missed
                                                       : 1;
    i -= used_drawn;
    j -= used_model;
    if (used_drawn > 0 && used_model > 0)
      links.push_back({static_cast<int>(i), static_cast<int>(used_drawn), static_cast<int>(j),
                       static_cast<int>(used_model), c.difference});
  }
  return collect(std::move(links), input, cell(n, m).cost);
}

/// The best explanation in any order, without joined or split strokes.
Alignment align_in_any_order(const AlignmentInput& input, const Table& t) {
  const std::size_t size = std::max(t.drawn_count, t.model_count);
  std::vector<float> costs(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      auto& c = costs[i * size + j];
      if (i >= t.drawn_count)
        c = input.extent == Extent::beginning ? 0 : kMissing;
      else if (j >= t.model_count)
        c = extra_cost(input.extent);
      else
        c = std::min(t.at(i, j).cost, kWrong);
    }
  }
  const auto columns = assign(costs, size);
  std::vector<Link> links;
  float total = 0;
  std::vector<std::size_t> strange_drawn;
  std::vector<std::size_t> strange_model;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t j = columns[i];
    total += costs[i * size + j];
    if (i >= t.drawn_count || j >= t.model_count) continue;
    if (t.at(i, j).cost < kWrong) {
      links.push_back({static_cast<int>(i), 1, static_cast<int>(j), 1, t.at(i, j)});
    } else {
      strange_drawn.push_back(i);
      strange_model.push_back(j);
    }
  }
  // Wrong strokes are matched in their order.
  std::sort(strange_model.begin(), strange_model.end());
  for (std::size_t k = 0; k < strange_drawn.size(); ++k)
    links.push_back({static_cast<int>(strange_drawn[k]), 1, static_cast<int>(strange_model[k]), 1,
                     t.at(strange_drawn[k], strange_model[k])});
  auto result = collect(std::move(links), input, total);
  if (input.extent == Extent::beginning) result.cost += missing_cost(input.extent, result.missing.size());
  return result;
}

double scale_of(const Affine& map) { return std::sqrt(std::abs(map.a * map.d - map.b * map.c)); }

/// Cost of a position and size that differ from what the box suggests; small, because it only breaks ties.
float box_cost(const AlignmentInput& input, const Affine& map) {
  if (!input.box) return 0;
  // The middle of the model's box, seen in both maps.
  const double det = map.a * map.d - map.b * map.c;
  if (std::abs(det) < 1e-12) return 50;
  const double ux = geometry::kGlyphSide / 2 - map.tx;
  const double uy = geometry::kGlyphSide / 2 - map.ty;
  const double x = (map.d * ux - map.b * uy) / det;
  const double y = (map.a * uy - map.c * ux) / det;
  const double dx = input.box->a * x + input.box->tx - geometry::kGlyphSide / 2;
  const double dy = input.box->d * y + input.box->ty - geometry::kGlyphSide / 2;
  const double size = std::log(scale_of(map) / input.box->a);
  // The beginning says little about its own position; the box says more.
  const double place_sigma = input.extent == Extent::beginning ? 7 : 12;
  const double size_sigma = 0.25;
  return static_cast<float>(std::min(
      (dx * dx + dy * dy) / (place_sigma * place_sigma) + size * size / (size_sigma * size_sigma), 20.0));
}

Affine refit(const AlignmentInput& input, const std::vector<Link>& links, double scale) {
  std::vector<FitPair> pairs;
  pairs.reserve(links.size());
  std::vector<Shape> made;
  made.reserve(links.size());
  for (const auto& l : links) {
    const Samples* d = &input.drawn[static_cast<std::size_t>(l.drawn)].whole;
    const Samples* m = &input.model[static_cast<std::size_t>(l.model)].whole;
    if (l.drawn_count == 2)
      d = &made.emplace_back(joined(*d, input.drawn[static_cast<std::size_t>(l.drawn) + 1].whole)).whole;
    if (l.model_count == 2) m = &input.pairs[static_cast<std::size_t>(l.model)].whole;
    const double slip = 1 + static_cast<double>(l.difference.cost) / 8;
    pairs.push_back({d, m, l.difference.reversed, 1 / (slip * slip)});
  }
  return fit(pairs, scale);
}

/// Alternates between explaining and fitting, from a first map; ends early where the first explanation costs
/// more than `hopeless`.
Alignment settle(const AlignmentInput& input, Affine map, double scale, int rounds = 4,
                 float hopeless = kNever, float far = kFar) {
  Alignment best;
  best.cost = kNever;
  for (int round = 0; round < rounds; ++round) {
    const auto table = tabulate(input, map, far);
    auto a = align_in_order(input, table);
    if (a.cost > kOutOfOrder) {
      auto b = align_in_any_order(input, table);
      if (b.cost + kOutOfOrder < a.cost) {
        b.cost += kOutOfOrder;
        a = std::move(b);
      }
    }
    a.map = map;
    a.cost += box_cost(input, map);
    const bool better = a.cost < best.cost - 0.05F;
    if (a.cost < best.cost) best = std::move(a);
    if (!better || best.links.empty() || best.cost > hopeless) break;
    map = refit(input, best.links, scale);
  }
  return best;
}

/// The map under which the strokes, taken in order, fit best; strokes of the longer side may be left out.
struct Guess {
  Affine map;
  std::vector<Link> links;
  float cost = kNever;
};

/// Fits and compares `rounds` times; stops as soon as it costs more than `limit`.
void improve(Guess& g, const AlignmentInput& input, double scale, int rounds, float limit = kNever) {
  for (int round = 0; round < rounds; ++round) {
    g.map = refit(input, g.links, scale);
    g.cost = box_cost(input, g.map);
    for (auto& l : g.links) {
      if (g.cost > limit) return;
      const auto d = transformed(input.drawn[static_cast<std::size_t>(l.drawn)], g.map);
      const auto j = static_cast<std::size_t>(l.model);
      l.difference = compare(d, l.model_count == 2 ? input.pairs[j] : input.model[j], kFar);
      g.cost += std::min(l.difference.cost, kWrong);
    }
  }
}

Guess guess_in_order(const AlignmentInput& input, std::vector<Link> links, double scale) {
  Guess g;
  g.links = std::move(links);
  improve(g, input, scale, 3);
  return g;
}

std::vector<Link> one_after_another(std::size_t count) {
  std::vector<Link> links;
  links.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    links.push_back({static_cast<int>(k), 1, static_cast<int>(k), 1, {}});
  return links;
}

/// Links in order with `gap` strokes of the longer side left out at `at`, or joined there.
std::vector<Link> links_in_order(std::size_t n, std::size_t m, std::size_t at, bool join) {
  std::vector<Link> links;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < n && j < m) {
    if (i == at && n > m) {
      ++i;
      if (i >= n) break;
    }
    if (j == at && n < m && !join) {
      ++j;
      if (j >= m) break;
    }
    const int count = join && j == at && j + 1 < m ? 2 : 1;
    links.push_back({static_cast<int>(i), 1, static_cast<int>(j), count, {}});
    ++i;
    j += static_cast<std::size_t>(count);
  }
  return links;
}

/// The likeliest place where the one stroke too few or too many is left out, or where two are joined. All
/// places are tried quickly, those that look best once more.
Guess guess_around_a_gap(const AlignmentInput& input, bool join, double scale) {
  constexpr std::size_t kLookedAtAgain = 3;
  const std::size_t n = input.drawn.size();
  const std::size_t m = input.model.size();
  std::vector<Guess> best;  // ascending
  for (std::size_t k = 0; k < std::max(n, m) - (join ? 1 : 0); ++k) {
    Guess g;
    g.links = links_in_order(n, m, k, join);
    const bool full = best.size() == kLookedAtAgain;
    improve(g, input, scale, 1, full ? best.back().cost : kNever);
    if (full && g.cost >= best.back().cost) continue;
    if (full) best.pop_back();
    const auto place = std::upper_bound(best.begin(), best.end(), g.cost,
                                        [](float cost, const Guess& other) { return cost < other.cost; });
    best.insert(place, std::move(g));
  }
  for (auto& g : best) improve(g, input, scale, 2);
  return std::move(*std::min_element(best.begin(), best.end(),
                                     [](const Guess& a, const Guess& b) { return a.cost < b.cost; }));
}

}  // namespace

Alignment align(const AlignmentInput& input) {
  const std::size_t n = input.drawn.size();
  const std::size_t m = input.model.size();
  const auto moments = fit_by_moments(input.drawn, input.model);
  const double scale = input.extent == Extent::beginning && input.box ? input.box->a : moments.a;

  Alignment best;
  best.cost = kNever;
  const auto take = [&best](Alignment a) {
    if (a.cost < best.cost) best = std::move(a);
  };
  const auto good = [&best, m] { return best.cost < 2.5F * static_cast<float>(m) && best.cost < kJoined; };

  if (n == m) {
    const auto g = guess_in_order(input, one_after_another(n), scale);
    take(settle(input, g.map, scale));
    if (good()) return best;
  } else if (input.extent == Extent::whole && (n + 1 == m || m + 1 == n)) {
    const auto left_out = guess_around_a_gap(input, false, scale);
    take(settle(input, left_out.map, scale));
    // No explanation with one stroke too few or too many costs less.
    const auto settled = [&best, m] {
      return best.cost - std::min(kMissing, kExtra) < std::min(1.0F * static_cast<float>(m), kJoined);
    };
    if (settled()) return best;
    if (n < m) {
      const auto together = guess_around_a_gap(input, true, scale);
      if (together.cost < left_out.cost + kMissing) take(settle(input, together.map, scale));
      if (settled()) return best;
    }
  }
  if (input.extent == Extent::beginning && n < m) {
    take(settle(input, guess_in_order(input, one_after_another(n), scale).map, scale));
  } else {
    take(settle(input, moments, scale));
  }
  if (input.box) take(settle(input, *input.box, scale));
  return best;
}

Alignment align_roughly(const AlignmentInput& input, float hopeless) {
  const std::size_t n = input.drawn.size();
  const std::size_t m = input.model.size();
  const auto moments = fit_by_moments(input.drawn, input.model);
  const bool in_turn = n == m || (input.extent == Extent::beginning && n < m);
  if (in_turn) {
    // Strokes in order first, because most writing is in order.
    auto g = guess_in_order(input, one_after_another(n), fit_by_moments(input.drawn, input.model.first(n)).a);
    if (g.cost < 4 * static_cast<float>(n)) {
      auto a = collect(std::move(g.links), input, g.cost);
      a.map = g.map;
      return a;
    }
  }
  // A second round hardly ever halves the cost of the first.
  return settle(input, moments, moments.a, 2, 2 * hopeless, kWrong);
}

}  // namespace nazori::writing
