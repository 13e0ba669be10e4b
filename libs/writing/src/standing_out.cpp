// SPDX-License-Identifier: Apache-2.0
#include "standing_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "fit.h"
#include "judgement.h"

namespace nazori::writing {
namespace {

/// A cost at which the word of a stroke counts a quarter.
constexpr double kStrange = 8;
/// Glyph units within which strokes belong to the same part of a character.
constexpr double kReach = 24;
/// Weight of "the neighbours are where they belong" beside what they do.
constexpr double kDoubt = 0.6;
constexpr double kDot = 12;    // glyph units: dots are written in all lengths and slants
constexpr double kShort = 22;  // glyph units: below, limits are wider
/// Natural logarithm of how much too short a stroke is that cannot be meant.
constexpr double kNotTheStroke = 0.95;

bool is_single(const Link& link) { return link.drawn_count == 1 && link.model_count == 1; }

double trust(const Link& link) {
  const double slip = 1 + static_cast<double>(link.difference.cost) / kStrange;
  return 1 / (slip * slip);
}

double closer_to_zero(double a, double b) { return std::abs(a) < std::abs(b) ? a : b; }

/// Of the neighbours of a stroke, under the same map: what all of them do.
struct Shared {
  double x = 0;
  double y = 0;
  double length_log = 0;
  double turn_rad = 0;
};

struct Compared {
  StrokeDifference difference;
  double whole_length_log = 0;
  double turn_rad = 0;
};

/// Each figure by its limit; above 1 the stroke stands out.
struct Excess {
  double most = 0;
  Deviation deviation = Deviation::none;
  bool is_the_stroke = true;
};

Excess excess(const StandingOut& s, double model_length, double tolerance) {
  constexpr double kLonger = 0.52;
  constexpr double kShorter = 0.8;
  constexpr double kTurn = 0.55;
  constexpr double kAway = 16;
  if (model_length < kDot) return {};
  const double wide = tolerance * std::max(1.0, 1 + 0.8 * (kShort - model_length) / (kShort - kDot));
  Excess e;
  const auto look = [&e](double share, Deviation deviation) {
    if (share > e.most) e = {share, deviation, true};
  };
  const double length = static_cast<double>(s.length_log);
  look(length > 0 ? length / (kLonger * wide) : -length / (kShorter * wide), Deviation::length);
  look(std::abs(static_cast<double>(s.turn_rad)) / (kTurn * wide), Deviation::direction);
  look(std::hypot(static_cast<double>(s.offset_x), static_cast<double>(s.offset_y)) / (kAway * wide),
       Deviation::place);
  if (const double whole = -static_cast<double>(s.whole_length_log) / (kNotTheStroke * tolerance);
      model_length >= kShort && whole > 1) {
    e = {std::max(e.most, whole), Deviation::length, false};
  }
  return e;
}

StandingOut plain(const Compared& own) {
  StandingOut s;
  s.whole_length_log = static_cast<float>(own.whole_length_log);
  s.length_log = static_cast<float>(
      closer_to_zero(own.whole_length_log, static_cast<double>(own.difference.length_log)));
  s.turn_rad = static_cast<float>(own.turn_rad);
  s.offset_x = own.difference.offset_x;
  s.offset_y = own.difference.offset_y;
  return s;
}

/// Each figure beside what the neighbours do, where that is smaller.
StandingOut beside(const Compared& own, const Shared& shared) {
  const auto& d = own.difference;
  const double x = static_cast<double>(d.offset_x);
  const double y = static_cast<double>(d.offset_y);
  const bool is_nearer_beside = std::hypot(x - shared.x, y - shared.y) < std::hypot(x, y);
  StandingOut s;
  const double whole = closer_to_zero(own.whole_length_log, own.whole_length_log - shared.length_log);
  const double length = static_cast<double>(d.length_log);
  s.whole_length_log = static_cast<float>(whole);
  s.length_log =
      static_cast<float>(closer_to_zero(whole, closer_to_zero(length, length - shared.length_log)));
  const double turn = own.turn_rad;
  s.turn_rad =
      static_cast<float>(closer_to_zero(turn, std::remainder(turn - shared.turn_rad, 2 * std::numbers::pi)));
  s.offset_x = static_cast<float>(is_nearer_beside ? x - shared.x : x);
  s.offset_y = static_cast<float>(is_nearer_beside ? y - shared.y : y);
  return s;
}

/// Looks for the strokes that stand out, one after the other.
class Search {
 public:
  Search(StrokeComparer& strokes, std::span<const Link> links, const Affine& map, double tolerance);

  /// The most conspicuous of those that were not found before.
  [[nodiscard]] std::optional<Conspicuous> next();

 private:
  /// A stroke under the map that lays the others over the model. It stands out by no more than `at_most`: the
  /// neighbours can only excuse it.
  struct Suspect {
    std::size_t link = 0;
    Affine map;
    double at_most = 0;
  };

  [[nodiscard]] bool counts(std::size_t link) const { return !left_out_[link] && is_single(links_[link]); }
  [[nodiscard]] const Samples& model_line(std::size_t link) const {
    return strokes_.model()[static_cast<std::size_t>(links_[link].model)].whole;
  }
  [[nodiscard]] std::vector<Suspect> suspects();
  [[nodiscard]] Compared compared(std::size_t link);
  [[nodiscard]] Shared shared_by_neighbours(std::size_t own);
  [[nodiscard]] double at_most(std::size_t link);

  StrokeComparer& strokes_;
  std::span<const Link> links_;
  double scale_;
  double tolerance_;
  std::vector<PairMoments> moments_;
  std::vector<double> trust_;
  std::vector<bool> left_out_;
};

Search::Search(StrokeComparer& strokes, std::span<const Link> links, const Affine& map, double tolerance)
    : strokes_(strokes),
      links_(links),
      scale_(std::sqrt(std::abs(map.a * map.d - map.b * map.c))),
      tolerance_(tolerance),
      moments_(links.size()),
      trust_(links.size()),
      left_out_(links.size(), false) {
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto& l = links[k];
    if (!is_single(l)) continue;
    trust_[k] = trust(l);
    moments_[k] = strokes.moments(static_cast<std::size_t>(l.drawn), static_cast<std::size_t>(l.model),
                                  l.difference.reversed);
  }
}

Compared Search::compared(std::size_t link) {
  constexpr float kAnyDistance = 1e9F;
  const auto i = static_cast<std::size_t>(links_[link].drawn);
  const auto j = static_cast<std::size_t>(links_[link].model);
  const auto d = strokes_.compare(i, j, kAnyDistance);
  return {d, static_cast<double>(strokes_.whole_length_log(i, j)),
          static_cast<double>(strokes_.turn(i, j, d.reversed))};
}

Shared Search::shared_by_neighbours(std::size_t own) {
  constexpr double kLong = 30;  // glyph units: shorter strokes say less of size and slant
  const auto& here = model_line(own);
  Shared s;
  double near = kDoubt;
  double sizes = kDoubt;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (k == own || !counts(k)) continue;
    const auto& there = model_line(k);
    const double dx = static_cast<double>(there.centre_x - here.centre_x);
    const double dy = static_cast<double>(there.centre_y - here.centre_y);
    const double next_to = trust_[k] * std::exp(-(dx * dx + dy * dy) / (2 * kReach * kReach));
    const double said = trust_[k] * std::min(static_cast<double>(there.length) / kLong, 1.0);
    const auto c = compared(k);
    near += next_to;
    s.x += next_to * static_cast<double>(c.difference.offset_x);
    s.y += next_to * static_cast<double>(c.difference.offset_y);
    sizes += said;
    s.length_log += said * static_cast<double>(c.difference.length_log);
    s.turn_rad += said * std::clamp(c.turn_rad, -0.5, 0.5);
  }
  s.x /= near;
  s.y /= near;
  s.length_log /= sizes;
  s.turn_rad /= sizes;
  return s;
}

/// A figure may change its sign beside the neighbours; it does not grow.
double Search::at_most(std::size_t link) {
  auto s = plain(compared(link));
  const double length = static_cast<double>(model_line(link).length);
  const double as_it_is = excess(s, length, tolerance_).most;
  s.length_log = -s.length_log;
  s.whole_length_log = -s.whole_length_log;
  return std::max(as_it_is, excess(s, length, tolerance_).most);
}

std::vector<Search::Suspect> Search::suspects() {
  FitSums all;
  std::size_t count = 0;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (!counts(k)) continue;
    all.add(moments_[k], trust_[k]);
    ++count;
  }
  std::vector<Suspect> result;
  if (count < 2) return result;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (!counts(k) || static_cast<double>(model_line(k).length) < kDot) continue;
    auto others = all;
    others.add(moments_[k], -trust_[k]);
    Suspect s{k, strokes_.fit(others, scale_), 0};
    strokes_.lay(s.map);
    s.at_most = at_most(k);
    if (s.at_most > 1) result.push_back(s);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Suspect& a, const Suspect& b) { return a.at_most > b.at_most; });
  return result;
}

std::optional<Conspicuous> Search::next() {
  std::optional<Conspicuous> worst;
  double greatest = 1;
  for (const auto& suspect : suspects()) {
    if (suspect.at_most < greatest) break;
    const auto k = suspect.link;
    strokes_.lay(suspect.map);
    auto s = beside(compared(k), shared_by_neighbours(k));
    const auto& own = strokes_.model()[static_cast<std::size_t>(links_[k].model)];
    if (own.free_slant && is_level_or_upright(own.whole, s.turn_rad)) s.turn_rad = 0;
    const auto e = excess(s, static_cast<double>(own.whole.length), tolerance_);
    const bool is_earlier = worst && e.most == greatest && k < worst->link;
    if (e.most <= greatest && !is_earlier) continue;
    greatest = e.most;
    worst = Conspicuous{k, e.deviation, e.is_the_stroke, s};
  }
  if (worst) left_out_[worst->link] = true;
  return worst;
}

/// Of two strokes the one that is far too short beside the other. Laying over hides it: it makes the whole
/// wider, or higher, until both are nearly right.
std::optional<Conspicuous> shorter_of_two(const StrokeComparer& strokes, std::span<const Link> links,
                                          double tolerance) {
  if (links.size() != 2 || !is_single(links[0]) || !is_single(links[1])) return {};
  std::array<double, 2> length_log{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto drawn =
        static_cast<double>(strokes.drawn()[static_cast<std::size_t>(links[k].drawn)].whole.length);
    const auto model =
        static_cast<double>(strokes.model()[static_cast<std::size_t>(links[k].model)].whole.length);
    if (model < kShort || drawn <= 0) return {};
    length_log[k] = std::log(drawn / model);
  }
  const double shorter = std::abs(length_log[0] - length_log[1]);
  if (shorter <= kNotTheStroke * tolerance) return {};
  StandingOut by;
  by.length_log = by.whole_length_log = static_cast<float>(-shorter);
  return Conspicuous{length_log[0] < length_log[1] ? std::size_t{0} : std::size_t{1}, Deviation::length,
                     false, by};
}

}  // namespace

std::vector<Conspicuous> conspicuous_strokes(StrokeComparer& strokes, std::span<const Link> links,
                                             const Affine& map, double tolerance) {
  if (const auto shorter = shorter_of_two(strokes, links, tolerance)) return {*shorter};
  std::vector<Conspicuous> found;
  Search search(strokes, links, map, tolerance);
  // Where more than a few strokes differ, the hand is hasty and no single stroke is at fault.
  const std::size_t most = std::max<std::size_t>(1, links.size() / 4);
  while (found.size() < most) {
    const auto next = search.next();
    if (!next) break;
    found.push_back(*next);
  }
  return found;
}

}  // namespace nazori::writing
