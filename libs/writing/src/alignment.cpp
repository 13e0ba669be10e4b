// SPDX-License-Identifier: Apache-2.0
#include "alignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "alignment_costs.h"
#include "stroke_comparer.h"
#include "stroke_matching.h"

namespace nazori::writing {
namespace {

constexpr int kRounds = 4;

double scale_of(const Affine& map) { return std::sqrt(std::abs(map.a * map.d - map.b * map.c)); }

/// Cost of a position and size that differ from what the box suggests; small, because it only breaks ties.
float box_cost(const std::optional<Affine>& box, Extent extent, const Affine& map) {
  if (!box) return 0;
  // The middle of the model's box, seen in both maps.
  const double det = map.a * map.d - map.b * map.c;
  if (std::abs(det) < 1e-12) return 50;
  const double ux = geometry::kGlyphSide / 2 - map.tx;
  const double uy = geometry::kGlyphSide / 2 - map.ty;
  const double x = (map.d * ux - map.b * uy) / det;
  const double y = (map.a * uy - map.c * ux) / det;
  const double dx = box->a * x + box->tx - geometry::kGlyphSide / 2;
  const double dy = box->d * y + box->ty - geometry::kGlyphSide / 2;
  const double size = std::log(scale_of(map) / box->a);
  // The beginning says little about its own position; the box says more.
  const double place_sigma = extent == Extent::beginning ? 7 : 12;
  const double size_sigma = 0.25;
  return static_cast<float>(std::min(
      (dx * dx + dy * dy) / (place_sigma * place_sigma) + size * size / (size_sigma * size_sigma), 20.0));
}

/// Whether so many strokes fit one for one that no other map explains the character better.
bool all_but_one_fit(const Alignment& a) {
  constexpr std::size_t kMany = 8;
  constexpr float kFits = kAcceptCost / 3;  // less than one stroke of two that are joined
  const auto strays = std::count_if(a.links.begin(), a.links.end(), [](const Link& l) {
    return l.drawn_count > 1 || l.model_count > 1 || l.difference.cost > kFits;
  });
  return a.links.size() >= kMany && static_cast<std::size_t>(strays) + a.missing.size() + a.extra.size() <= 1;
}

/// Strokes one for one, and perhaps two of the model's in one, without what they differ by.
struct Guess {
  Affine map;
  std::vector<Link> links;
  float cost = kNever;
};

std::vector<Link> one_after_another(std::size_t count) {
  std::vector<Link> links;
  links.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    links.push_back({static_cast<int>(k), 1, static_cast<int>(k), 1, {}});
  return links;
}

/// Links in order with one stroke of the longer side left out at `at`, or joined there.
std::vector<Link> links_around(std::size_t n, std::size_t m, std::size_t at, bool join) {
  auto links = one_after_another(std::min(n, m));
  for (std::size_t k = at; k < links.size(); ++k) {
    if (n > m) ++links[k].drawn;
    if (n < m && (!join || k > at)) ++links[k].model;
  }
  if (join) links[at].model_count = 2;
  return links;
}

/// Alternates between explaining and laying over.
class Aligner {
 public:
  Aligner(StrokeComparer& strokes, const std::optional<Affine>& box, Extent extent, double scale)
      : strokes_(strokes), box_(box), extent_(extent), scale_(scale) {}

  /// From a first map; ends early where the first explanation costs more than `hopeless`.
  [[nodiscard]] Alignment settle(Affine map, int rounds, float hopeless, float far = kFar);
  /// The map under which the strokes, taken in order, fit best.
  [[nodiscard]] Guess guess_in_order(std::size_t count);
  /// The likeliest place where the one stroke too few or too many is left out, or where two are joined. All
  /// places are tried quickly, those that look best once more.
  [[nodiscard]] Guess guess_around_a_gap(bool join);

 private:
  [[nodiscard]] PairMoments moments(const Link& link);
  [[nodiscard]] Affine refit(const std::vector<Link>& links);
  [[nodiscard]] StrokeDifference compare(const Link& link);
  void lay(Guess& g, const Affine& map);
  void find_cost(Guess& g, float limit);
  void improve(Guess& g, int rounds);
  [[nodiscard]] std::vector<Affine> maps_around_gaps(std::size_t places, bool join);

  StrokeComparer& strokes_;
  const std::optional<Affine>& box_;
  Extent extent_;
  double scale_;
};

PairMoments Aligner::moments(const Link& l) {
  const auto i = static_cast<std::size_t>(l.drawn);
  const auto j = static_cast<std::size_t>(l.model);
  if (l.drawn_count == 2) return strokes_.moments_of_joined(i, j, l.difference.reversed);
  return l.model_count == 2 ? strokes_.moments_of_pair(i, j, l.difference.reversed)
                            : strokes_.moments(i, j, l.difference.reversed);
}

Affine Aligner::refit(const std::vector<Link>& links) {
  FitSums sums;
  for (const auto& l : links) {
    const double slip = 1 + static_cast<double>(l.difference.cost) / 8;
    sums.add(moments(l), 1 / (slip * slip));
  }
  return strokes_.fit(sums, scale_);
}

Alignment Aligner::settle(Affine map, int rounds, float hopeless, float far) {
  StrokeMatching matching(strokes_, extent_, far);
  Alignment best;
  best.cost = kNever;
  for (int round = 0; round < rounds; ++round) {
    auto a = matching.best(map);
    a.cost += box_cost(box_, extent_, map);
    const bool better = a.cost < best.cost - 0.05F;
    if (a.cost < best.cost) best = std::move(a);
    if (!better || best.links.empty() || best.cost > hopeless) break;
    map = refit(best.links);
  }
  return best;
}

StrokeDifference Aligner::compare(const Link& l) {
  const auto i = static_cast<std::size_t>(l.drawn);
  const auto j = static_cast<std::size_t>(l.model);
  return l.model_count == 2 ? strokes_.compare_with_pair(i, j, kFar) : strokes_.compare(i, j, kFar);
}

void Aligner::lay(Guess& g, const Affine& map) {
  g.map = map;
  strokes_.lay(map);
  g.cost = box_cost(box_, extent_, map);
}

/// Stops as soon as it is more than `limit`.
void Aligner::find_cost(Guess& g, float limit) {
  for (auto& l : g.links) {
    if (g.cost > limit) return;
    l.difference = compare(l);
    g.cost += std::min(l.difference.cost, kWrong);
  }
}

void Aligner::improve(Guess& g, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    lay(g, refit(g.links));
    find_cost(g, kNever);
  }
}

Guess Aligner::guess_in_order(std::size_t count) {
  Guess g;
  g.links = one_after_another(count);
  improve(g, 3);
  return g;
}

/// The map for each place of the gap. Gaps side by side differ in one pair of strokes.
std::vector<Affine> Aligner::maps_around_gaps(std::size_t places, bool join) {
  const std::size_t n = strokes_.drawn().size();
  const std::size_t m = strokes_.model().size();
  FitSums sums;
  for (const auto& l : links_around(n, m, 0, join))
    if (l.model_count == 1) sums.add(moments(l), 1);
  std::vector<Affine> maps;
  maps.reserve(places);
  for (std::size_t k = 0; k < places; ++k) {
    FitSums with_pair = sums;
    if (join) with_pair.add(strokes_.moments_of_pair(k, k, false), 1);
    maps.push_back(strokes_.fit(with_pair, scale_));
    if (k + 1 == places) break;
    const std::size_t shifted = join ? k + 1 : k;
    const auto before = n > m ? std::pair(k + 1, k) : std::pair(shifted, shifted + 1);
    sums.add(strokes_.moments(before.first, before.second, false), -1);
    sums.add(strokes_.moments(k, k, false), 1);
  }
  return maps;
}

Guess Aligner::guess_around_a_gap(bool join) {
  constexpr std::size_t kLookedAtAgain = 3;
  const std::size_t n = strokes_.drawn().size();
  const std::size_t m = strokes_.model().size();
  const auto maps = maps_around_gaps(std::max(n, m) - (join ? 1 : 0), join);
  std::vector<Guess> best;  // ascending
  for (std::size_t k = 0; k < maps.size(); ++k) {
    Guess g;
    lay(g, maps[k]);
    const bool full = best.size() == kLookedAtAgain;
    const float limit = full ? best.back().cost : kNever;
    g.links = links_around(n, m, k, join);
    find_cost(g, limit);
    if (full && g.cost >= limit) continue;
    if (full) best.pop_back();
    const auto place = std::upper_bound(best.begin(), best.end(), g.cost,
                                        [](float cost, const Guess& other) { return cost < other.cost; });
    best.insert(place, std::move(g));
  }
  for (auto& g : best) improve(g, 2);
  return std::move(*std::min_element(best.begin(), best.end(),
                                     [](const Guess& a, const Guess& b) { return a.cost < b.cost; }));
}

}  // namespace

Alignment align_in_order(StrokeComparer& strokes, const std::optional<Affine>& box) {
  const auto moments = fit_by_moments(strokes.drawn(), strokes.model());
  const std::size_t count = strokes.drawn().size();
  auto guess = Aligner(strokes, box, Extent::whole, moments.a).guess_in_order(count);
  auto alignment = explanation_of(std::move(guess.links), guess.cost, count, count, Extent::whole);
  alignment.map = guess.map;
  return alignment;
}

bool is_one_wrong_in_order(StrokeComparer& strokes, const std::optional<Affine>& box) {
  const auto alignment = align_in_order(strokes, box);
  return std::any_of(alignment.links.begin(), alignment.links.end(),
                     [](const Link& link) { return link.difference.cost >= kWrong; });
}

Alignment align(const AlignmentInput& input) {
  StrokeComparer strokes(input.drawn, input.model, input.pairs);
  return align(strokes, input.box, input.extent);
}

Alignment align(StrokeComparer& strokes, const std::optional<Affine>& box, Extent extent) {
  const std::size_t n = strokes.drawn().size();
  const std::size_t m = strokes.model().size();
  const auto moments = fit_by_moments(strokes.drawn(), strokes.model());
  Aligner aligner(strokes, box, extent, extent == Extent::beginning && box ? box->a : moments.a);

  Alignment best;
  best.cost = kNever;
  // Where three of four strokes are wrong, no better map makes the character of it.
  const float hopeless = 0.75F * kWrong * static_cast<float>(std::max(n, m));
  const auto settle = [&](const Affine& map) {
    auto a = aligner.settle(map, kRounds, hopeless);
    if (a.cost < best.cost) best = std::move(a);
  };
  if (n == m) {
    settle(aligner.guess_in_order(n).map);
    const bool is_good = best.cost < std::min(2.5F * static_cast<float>(m), kJoined);
    if (is_good || all_but_one_fit(best)) return best;
  } else if (extent == Extent::whole && (n + 1 == m || m + 1 == n)) {
    const auto left_out = aligner.guess_around_a_gap(false);
    settle(left_out.map);
    // No explanation with one stroke too few or too many costs less.
    const auto settled = [&best, m] {
      return best.cost - std::min(kMissing, kExtra) < std::min(1.0F * static_cast<float>(m), kJoined);
    };
    if (settled() || all_but_one_fit(best)) return best;
    if (n < m) {
      const auto together = aligner.guess_around_a_gap(true);
      if (together.cost < left_out.cost + kMissing) settle(together.map);
      if (settled()) return best;
    }
  }
  if (extent == Extent::beginning && n < m)
    settle(aligner.guess_in_order(n).map);
  else
    settle(moments);
  if (box) settle(*box);
  return best;
}

Alignment align_roughly(const AlignmentInput& input, float hopeless) {
  const std::size_t n = input.drawn.size();
  const std::size_t m = input.model.size();
  const auto moments = fit_by_moments(input.drawn, input.model);
  StrokeComparer strokes(input.drawn, input.model, input.pairs);
  const bool in_turn = n == m || (input.extent == Extent::beginning && n < m);
  if (in_turn) {
    // Strokes in order first, because most writing is in order.
    Aligner aligner(strokes, input.box, input.extent, fit_by_moments(input.drawn, input.model.first(n)).a);
    auto g = aligner.guess_in_order(n);
    if (g.cost < 4 * static_cast<float>(n)) {
      auto a = explanation_of(std::move(g.links), g.cost, n, m, input.extent);
      a.map = g.map;
      return a;
    }
  }
  // A second round hardly ever halves the cost of the first.
  return Aligner(strokes, input.box, input.extent, moments.a).settle(moments, 2, 2 * hopeless, kWrong);
}

}  // namespace nazori::writing
