// SPDX-License-Identifier: Apache-2.0
#include "judgement.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {
namespace {

Samples backwards(const Samples& forwards) {
  auto samples = forwards;
  std::reverse(samples.x.begin(), samples.x.end());
  std::reverse(samples.y.begin(), samples.y.end());
  return samples;
}

/// Turned about the centre, clockwise.
Samples turned(const Samples& straight, float angle_rad) {
  auto samples = straight;
  const float c = std::cos(angle_rad);
  const float s = std::sin(angle_rad);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const float x = samples.x[k] - samples.centre_x;
    const float y = samples.y[k] - samples.centre_y;
    samples.x[k] = samples.centre_x + c * x - s * y;
    samples.y[k] = samples.centre_y + s * x + c * y;
  }
  return samples;
}

}  // namespace

// The weights, rounded, separate strokes of real writing best from wrong strokes in their places;
// docs/writing.md names the data and the figures.
Judgement judge(const StrokeDifference& d, const Placement& placement, const Residue& residue,
                const Course& course, float touch) {
  const double length = static_cast<double>(d.model_length);
  const double shortness = 1 / (length + 3);
  // 1 for a dot, 0 for a long stroke: dots vary more in place, and less in bends.
  const double dot = std::exp(-(length / 17) * (length / 17));
  const auto between = [dot](double of_long, double of_dot) { return of_long + (of_dot - of_long) * dot; };
  const auto square = [](auto v) { return static_cast<double>(v * v); };
  const double off = square(d.offset_x) + square(d.offset_y);
  const double off_beside = square(placement.x) + square(placement.y);
  const double place = (0.152 * off + between(0.143, 0) * off_beside) / 100;
  // Quick dots fall steeper than the model's; hardly any is flatter.
  const double steeper = std::clamp(static_cast<double>(d.steeper), -0.5, 0.5);
  const double freedom = static_cast<double>(d.freedom) * (1 + 0.46 * dot * steeper);
  const double usual = freedom * (0.074 + 0.21 * shortness);
  const double proportion = static_cast<double>(d.proportion) / usual;
  const double wide = 1 + 12 * shortness;
  const double chord = static_cast<double>(course.chord_turn) / (0.27 * freedom * wide);
  const double along = static_cast<double>(course.along) / (0.06 * freedom * freedom * wide);
  // A pen trembles by as much in a dot as in a long stroke.
  const double tremble = 0.8 * shortness;
  const double bent = std::max(square(residue.bend) - square(tremble), 0.0);
  const double bend = bent / square(0.07 + 1.05 * shortness);
  const double end = static_cast<double>(residue.nearer_end) / 10;
  // A dot may be as short as a touch.
  const double free_length = std::exp(-std::pow(length / static_cast<double>(touch), 4));
  const double stretch = std::min(std::abs(static_cast<double>(d.length_log)), 1.2);
  // An intended stroke is hardly ever only half as long as it should be.
  const double beyond = std::clamp(-static_cast<double>(placement.length_log) - 0.7, 0.0, 0.5);
  const double size_part =
      (1 - free_length) * (0.35 * square(stretch) + 6.5 * square(beyond) * (1 - free_length));
  const double shape_part = 0.03 * square(proportion) + between(0.2, 0.3) * square(chord) +
                            between(0.11, 0.031) * along + between(0.133, 0.874) * bend +
                            between(0.114, 0.057) * square(end);
  Judgement j;
  j.place = place;
  j.deviation = place + size_part + shape_part;
  if (place > size_part + shape_part)
    j.most = Deviation::place;
  else if (size_part > shape_part)
    j.most = Deviation::length;
  else
    j.most = Deviation::shape;
  return j;
}

bool is_level_or_upright(const Samples& model, float turn_rad) {
  constexpr float kMostTurn = 0.95F;  // radians; a dot that is drawn backwards is turned further
  constexpr float kOff = 0.14F;       // sine of what a level or upright line may be off
  if (std::abs(turn_rad) > kMostTurn) return false;
  const float dx = model.x.back() - model.x.front();
  const float dy = model.y.back() - model.y.front();
  const float across = dx * std::cos(turn_rad) - dy * std::sin(turn_rad);
  const float down = dx * std::sin(turn_rad) + dy * std::cos(turn_rad);
  return std::min(std::abs(across), std::abs(down)) <= kOff * std::hypot(dx, dy);
}

bool ignore_slant(const Samples& model, Residue& residue, StrokeDifference& difference, Course& course) {
  constexpr float kStraight = 0.05F;
  if (residue.bend > kStraight || !is_level_or_upright(model, residue.turn_rad)) return false;
  difference.proportion = std::min(difference.proportion, residue.bend);
  residue.turn_rad = 0;
  course = {};
  return true;
}

JudgedStroke judge_stroke(const Shape& laid, const Shape& model, std::span<const Shape> other_ways,
                          const StrokeDifference& difference, const Placement& placement) {
  constexpr double kUsedFreedom = 0.35;
  const auto drawn = difference.reversed ? backwards(laid.whole) : laid.whole;
  const auto beside = [&](const Shape& way, const StrokeDifference& d, const Placement& p) {
    JudgedStroke j{{},    d,         p, residue(laid, way, d, p), course(laid.whole, way.whole, d.reversed),
                   drawn, way.whole, {}};
    j.judgement = judge(j.difference, j.placement, j.residue, j.course, way.touch);
    return j;
  };
  auto best = beside(model, difference, placement);
  const auto take = [&best](const JudgedStroke& other) {
    if (other.judgement.deviation + other.used_freedom < best.judgement.deviation + best.used_freedom)
      best = other;
  };
  if (auto free = best; model.free_slant) {
    const float turn = free.residue.turn_rad;
    if (ignore_slant(model.whole, free.residue, free.difference, free.course)) {
      free.drawn = turned(free.drawn, -turn);
      free.judgement = judge(free.difference, free.placement, free.residue, free.course, model.touch);
      free.used_freedom = kUsedFreedom;
      take(free);
    }
  }
  for (const auto& other : other_ways) {
    constexpr float kAnyDistance = 1e9F;
    const auto d = compare(laid, other, kAnyDistance);
    if (d.reversed != difference.reversed) continue;
    take(beside(
        other, d,
        {placement.x + d.offset_x - difference.offset_x, placement.y + d.offset_y - difference.offset_y,
         placement.length_log + d.length_log - difference.length_log}));
  }
  return best;
}

std::vector<JudgedStroke> judged_strokes(const Alignment& alignment, std::span<const Shape> drawn,
                                         const Form& form) {
  const auto places = placements(alignment, form.shapes);
  std::vector<JudgedStroke> result;
  result.reserve(alignment.links.size());
  for (std::size_t k = 0; k < alignment.links.size(); ++k) {
    const auto& link = alignment.links[k];
    const auto model = static_cast<std::size_t>(link.model);
    const auto laid = transformed(drawn[static_cast<std::size_t>(link.drawn)], alignment.map);
    result.push_back(
        judge_stroke(laid, form.shapes[model], form.other_ways[model], link.difference, places[k]));
    const auto& as_drawn = drawn[static_cast<std::size_t>(link.drawn)].whole;
    result.back().as_drawn = link.difference.reversed ? backwards(as_drawn) : as_drawn;
  }
  return result;
}

double deviation_limit(double strictness) {
  constexpr double kAtLenient = 1.7;
  constexpr double kAtStrict = 1 / 1.7;
  return kAtLenient * std::pow(kAtStrict / kAtLenient, strictness);
}

}  // namespace nazori::writing
