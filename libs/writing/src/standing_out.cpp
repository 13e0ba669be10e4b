// SPDX-License-Identifier: Apache-2.0
#include "standing_out.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit.h"
#include "judgement.h"
#include "residue.h"

namespace nazori::writing {
namespace {

/// A cost at which the word of a stroke counts a quarter.
constexpr double kStrange = 8;
/// Glyph units within which strokes belong to the same part of a character.
constexpr double kReach = 24;
/// Weight of "the neighbours are where they belong" beside what they do.
constexpr double kDoubt = 0.6;

bool is_single(const Link& link) { return link.drawn_count == 1 && link.model_count == 1; }

double trust(const Link& link) {
  const double slip = 1 + static_cast<double>(link.difference.cost) / kStrange;
  return 1 / (slip * slip);
}

double closer_to_zero(double a, double b) { return std::abs(a) < std::abs(b) ? a : b; }

/// The map that lays the other strokes over the model.
std::optional<Affine> fit_others(std::size_t own, std::span<const Link> links, std::span<const Shape> drawn,
                                 std::span<const Shape> model, double scale,
                                 const std::vector<bool>& left_out) {
  std::vector<FitPair> pairs;
  pairs.reserve(links.size());
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto& l = links[k];
    if (k == own || left_out[k] || !is_single(l)) continue;
    pairs.push_back({&drawn[static_cast<std::size_t>(l.drawn)].whole,
                     &model[static_cast<std::size_t>(l.model)].whole, l.difference.reversed, trust(l)});
  }
  if (pairs.empty()) return {};
  return fit(pairs, scale);
}

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

Compared compare_under(const Link& link, std::span<const Shape> drawn, std::span<const Shape> model,
                       const Affine& map) {
  const auto laid = transformed(drawn[static_cast<std::size_t>(link.drawn)], map);
  const auto& own_model = model[static_cast<std::size_t>(link.model)];
  constexpr float kAnyDistance = 1e9F;
  Compared c{compare(laid, own_model, kAnyDistance), 0, 0};
  c.whole_length_log = std::log((static_cast<double>(laid.whole.length) + 0.3) /
                                (static_cast<double>(own_model.whole.length) + 0.3));
  c.turn_rad = static_cast<double>(residue(laid, own_model, c.difference, {}).turn_rad);
  return c;
}

Shared shared_by_neighbours(std::size_t own, std::span<const Link> links, std::span<const Compared> compared,
                            std::span<const Shape> model, const std::vector<bool>& left_out) {
  constexpr double kLong = 30;  // glyph units: shorter strokes say less of size and slant
  const auto& here = model[static_cast<std::size_t>(links[own].model)].whole;
  Shared s;
  double near = kDoubt;
  double sizes = kDoubt;
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (k == own || left_out[k] || !is_single(links[k])) continue;
    const auto& there = model[static_cast<std::size_t>(links[k].model)].whole;
    const double dx = static_cast<double>(there.centre_x - here.centre_x);
    const double dy = static_cast<double>(there.centre_y - here.centre_y);
    const double beside = trust(links[k]) * std::exp(-(dx * dx + dy * dy) / (2 * kReach * kReach));
    const double said = trust(links[k]) * std::min(static_cast<double>(there.length) / kLong, 1.0);
    const auto& d = compared[k].difference;
    near += beside;
    s.x += beside * static_cast<double>(d.offset_x);
    s.y += beside * static_cast<double>(d.offset_y);
    sizes += said;
    s.length_log += said * static_cast<double>(d.length_log);
    s.turn_rad += said * std::clamp(compared[k].turn_rad, -0.5, 0.5);
  }
  s.x /= near;
  s.y /= near;
  s.length_log /= sizes;
  s.turn_rad /= sizes;
  return s;
}

/// Each figure by its limit; above 1 the stroke stands out.
struct Excess {
  double most = 0;
  Deviation deviation = Deviation::none;
  bool is_the_stroke = true;
};

Excess excess(const StandingOut& s, double model_length, double tolerance) {
  constexpr double kDot = 12;    // glyph units: dots are written in all lengths and slants
  constexpr double kShort = 22;  // glyph units: below, limits are wider
  constexpr double kLonger = 0.52;
  constexpr double kShorter = 0.8;
  constexpr double kNotTheStroke = 0.95;
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

}  // namespace

std::optional<StandingOut> standing_out(std::size_t own, std::span<const Link> links,
                                        std::span<const Shape> drawn, std::span<const Shape> model,
                                        const Affine& map, const std::vector<bool>& left_out) {
  if (!is_single(links[own])) return {};
  const double scale = std::sqrt(std::abs(map.a * map.d - map.b * map.c));
  const auto others = fit_others(own, links, drawn, model, scale, left_out);
  if (!others) return {};
  std::vector<Compared> compared(links.size());
  for (std::size_t k = 0; k < links.size(); ++k)
    if (is_single(links[k]) && !left_out[k]) compared[k] = compare_under(links[k], drawn, model, *others);
  const auto shared = shared_by_neighbours(own, links, compared, model, left_out);
  const auto& d = compared[own].difference;
  const double x = static_cast<double>(d.offset_x);
  const double y = static_cast<double>(d.offset_y);
  const bool is_nearer_beside = std::hypot(x - shared.x, y - shared.y) < std::hypot(x, y);
  StandingOut s;
  const double whole =
      closer_to_zero(compared[own].whole_length_log, compared[own].whole_length_log - shared.length_log);
  const double length = static_cast<double>(d.length_log);
  s.whole_length_log = static_cast<float>(whole);
  s.length_log =
      static_cast<float>(closer_to_zero(whole, closer_to_zero(length, length - shared.length_log)));
  const double turn = compared[own].turn_rad;
  s.turn_rad =
      static_cast<float>(closer_to_zero(turn, std::remainder(turn - shared.turn_rad, 2 * std::numbers::pi)));
  s.offset_x = static_cast<float>(is_nearer_beside ? x - shared.x : x);
  s.offset_y = static_cast<float>(is_nearer_beside ? y - shared.y : y);
  return s;
}

std::vector<Conspicuous> conspicuous_strokes(std::span<const Link> links, std::span<const Shape> drawn,
                                             std::span<const Shape> model, const Affine& map,
                                             double tolerance) {
  std::vector<Conspicuous> found;
  std::vector<bool> left_out(links.size(), false);
  // Where more than a few strokes differ, the hand is hasty and no single stroke is at fault.
  const std::size_t most = std::max<std::size_t>(1, links.size() / 4);
  while (found.size() < most) {
    Conspicuous next;
    double greatest = 1;
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (left_out[k]) continue;
      auto s = standing_out(k, links, drawn, model, map, left_out);
      if (!s) continue;
      const auto& own = model[static_cast<std::size_t>(links[k].model)];
      if (own.free_slant && is_level_or_upright(own.whole, s->turn_rad)) s->turn_rad = 0;
      const double length = static_cast<double>(own.whole.length);
      const auto e = excess(*s, length, tolerance);
      if (e.most <= greatest) continue;
      greatest = e.most;
      next = {k, e.deviation, e.is_the_stroke, *s};
    }
    if (next.deviation == Deviation::none) break;
    left_out[next.link] = true;
    found.push_back(next);
  }
  return found;
}

}  // namespace nazori::writing
