// SPDX-License-Identifier: Apache-2.0
#include "strangeness.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "decision_trees.h"
#include "probability.h"

namespace nazori::writing {

/// libs/writing/data/strokes.trees, made part of the program by CMake.
extern const unsigned char stroke_trees_bytes[];
extern const std::size_t stroke_trees_size;

namespace {

/// Where the deviation as a share of the allowance lies among the features.
constexpr std::size_t kOfAllowance = 19;

const DecisionTrees& trained_trees() {
  static const auto trees =
      DecisionTrees::read(std::span(stroke_trees_bytes, stroke_trees_size), kStrokeFeatures);
  assert(trees);
  return *trees;
}

/// What a stroke says of the hand: 0 steady, 1 as rough as any.
double roughness_of(const JudgedStroke& stroke) {
  return std::sqrt(std::min(stroke.judgement.deviation, 1.0));
}

/// How much of the limit a stroke may use, from the mean roughness of the others: in careful writing a stroke
/// that is off is wrong; in hasty writing all are a little off.
double allowance(double roughness) { return std::clamp(0.525 + 2.4 * roughness, 0.5, 1.5); }

/// Sums over all strokes of a writing, from which those of the others follow.
struct Sums {
  double roughness = 0;
  double turn = 0;
  double bend = 0;
  double along = 0;
  double signed_turn = 0;
  double away = 0;

  void add(const JudgedStroke& s, double times) {
    roughness += times * roughness_of(s);
    turn += times * std::abs(static_cast<double>(s.residue.turn_rad));
    bend += times * static_cast<double>(s.residue.bend);
    along += times * static_cast<double>(s.course.along);
    signed_turn += times * static_cast<double>(s.residue.turn_rad);
    away += times * static_cast<double>(std::hypot(s.placement.x, s.placement.y));
  }
};

/// Writes features one after the other.
class Row {
 public:
  explicit Row(StrokeFeatures& to) : to_(&to) {}
  template <class Number>
  void put(Number value) {
    (*to_)[next_++] = static_cast<float>(value);
  }
  [[nodiscard]] bool is_full() const { return next_ == to_->size(); }

 private:
  StrokeFeatures* to_;
  std::size_t next_ = 0;
};

void put_measured(Row& row, const JudgedStroke& s) {
  const auto& d = s.difference;
  row.put(s.judgement.deviation);
  row.put(s.judgement.place);
  for (const float v :
       {d.offset_x, d.offset_y, s.placement.x, s.placement.y, s.placement.length_log, d.proportion, d.shape,
        d.steeper, d.model_length, d.freedom, s.course.chord_turn, s.course.along, s.residue.turn_rad,
        s.residue.bend, s.residue.nearer_end, d.length_log})
    row.put(v);
}

void put_others(Row& row, const JudgedStroke& s, Sums others, std::size_t count) {
  constexpr double kUsual = 0.095;  // roughness of a hand of which nothing is known
  constexpr double kUsualCount = 9.3;
  others.add(s, -1);
  const auto n = static_cast<double>(count - 1);
  const double roughness = (others.roughness + kUsualCount * kUsual) / (n + kUsualCount);
  const double each = 1 / std::max(n, 1.0);
  row.put(roughness);
  row.put(s.judgement.deviation / allowance(roughness));
  row.put(count);
  for (const double sum : {others.turn, others.bend, others.along, others.signed_turn}) row.put(sum * each);
  row.put(std::hypot(s.placement.x, s.placement.y));
  row.put(others.away * each);
}

/// The turn from the model's line between two samples to the drawn one, clockwise.
float turn_between(const Samples& d, const Samples& m, std::size_t from, std::size_t to) {
  const float dx = d.x[to] - d.x[from];
  const float dy = d.y[to] - d.y[from];
  const float mx = m.x[to] - m.x[from];
  const float my = m.y[to] - m.y[from];
  return std::atan2(mx * dy - my * dx, mx * dx + my * dy);
}

void put_lines(Row& row, const JudgedStroke& s) {
  constexpr std::size_t kLast = kSamples - 1;
  const auto& d = s.drawn;
  const auto& m = s.model;
  // An offset that the neighbours share is not a deviation of this stroke.
  const float shared_x = s.difference.offset_x - s.placement.x;
  const float shared_y = s.difference.offset_y - s.placement.y;
  for (const std::size_t k : {std::size_t{0}, kLast})
    row.put(std::hypot(d.x[k] - m.x[k] - shared_x, d.y[k] - m.y[k] - shared_y));
  const float across = m.x[kLast] - m.x[0];
  const float down = m.y[kLast] - m.y[0];
  const float chord = std::max(std::hypot(across, down), 1e-3F);
  for (const float v : {across / chord, down / chord, chord}) row.put(v);
  row.put(std::abs(turn_between(d, m, 0, 6)));
  row.put(std::abs(turn_between(d, m, 6, 12)));
  row.put(std::abs(turn_between(d, m, 12, 18)));
  row.put(std::abs(turn_between(d, m, 18, kLast)));
}

void put_points(Row& row, const JudgedStroke& s) {
  constexpr std::array<std::size_t, 8> kPoints{0, 3, 7, 10, 13, 16, 20, 23};
  const auto& d = s.drawn;
  const auto& m = s.model;
  const float of_drawn = 1 / std::max(d.length, 1e-3F);
  const float of_model = 1 / std::max(m.length, 1e-3F);
  const float near = 1 / (10 + 0.2F * m.length);
  const auto model_x = [&](std::size_t k) { return (m.x[k] - m.centre_x) * of_model; };
  const auto model_y = [&](std::size_t k) { return (m.y[k] - m.centre_y) * of_model; };
  for (const std::size_t k : kPoints) {
    row.put(model_x(k));
    row.put(model_y(k));
  }
  for (const std::size_t k : kPoints) {
    row.put((d.x[k] - d.centre_x) * of_drawn - model_x(k));
    row.put((d.y[k] - d.centre_y) * of_drawn - model_y(k));
  }
  for (const std::size_t k : kPoints) {
    row.put((d.x[k] - m.x[k]) * near);
    row.put((d.y[k] - m.y[k]) * near);
  }
}

/// The point of another stroke of the model that is nearest to one end of this stroke's model.
struct NearestPoint {
  const JudgedStroke* stroke = nullptr;
  std::size_t sample = 0;
  float distance = 100;  // glyph units; of a stroke that has no others
};

NearestPoint nearest_point(std::span<const JudgedStroke> all, std::size_t own, std::size_t end) {
  const auto& line = all[own].model;
  NearestPoint nearest;
  for (std::size_t other = 0; other < all.size(); ++other) {
    if (other == own) continue;
    const auto& m = all[other].model;
    // No point of a line is farther from its centre than half its length.
    if (std::hypot(m.centre_x - line.x[end], m.centre_y - line.y[end]) - m.length / 2 > nearest.distance)
      continue;
    float least = nearest.distance * nearest.distance;
    for (std::size_t k = 0; k < kSamples; ++k) {
      const float dx = m.x[k] - line.x[end];
      const float dy = m.y[k] - line.y[end];
      const float squared = dx * dx + dy * dy;
      if (squared >= least) continue;
      least = squared;
      nearest = {&all[other], k, std::sqrt(squared)};
    }
  }
  return nearest;
}

/// How the ends lie beside the strokes that they touch, or come nearest to, in the model.
void put_ends(Row& row, std::span<const JudgedStroke> all, std::size_t own) {
  constexpr std::array<std::size_t, 2> kEnds{0, kSamples - 1};
  const auto& s = all[own];
  std::array<float, 2> off{};
  std::array<float, 2> distance{};
  for (std::size_t e = 0; e < kEnds.size(); ++e) {
    const std::size_t k = kEnds[e];
    const auto nearest = nearest_point(all, own, k);
    float x = s.drawn.x[k] - s.model.x[k];
    float y = s.drawn.y[k] - s.model.y[k];
    if (nearest.stroke != nullptr) {
      x -= nearest.stroke->drawn.x[nearest.sample] - nearest.stroke->model.x[nearest.sample];
      y -= nearest.stroke->drawn.y[nearest.sample] - nearest.stroke->model.y[nearest.sample];
    }
    off[e] = std::hypot(x, y);
    distance[e] = nearest.distance;
  }
  for (const float v : {off[0], off[1], std::min(off[0], off[1]), distance[0], distance[1]}) row.put(v);
}

/// How the strokes are turned that go in the same direction, or lie near: a hand turns them alike.
/// @param turns  of each stroke, between both ends
void put_turns(Row& row, std::span<const JudgedStroke> all, std::span<const float> turns, std::size_t own) {
  constexpr std::size_t kLast = kSamples - 1;
  constexpr float kDoubt = 0.3F;  // weight of "not turned"
  constexpr float kLong = 30;     // glyph units: shorter strokes say less about a direction
  constexpr float kReach = 24;    // glyph units
  constexpr float kStrange = 13;  // cost at which another stroke has a quarter of its weight
  constexpr float kMostRough = 4;
  const auto& s = all[own];
  const auto chord = [](const Samples& m) { return std::pair{m.x[kLast] - m.x[0], m.y[kLast] - m.y[0]}; };
  const auto [x, y] = chord(s.model);
  float alike = 0, alike_weight = kDoubt;
  float near = 0, near_weight = kDoubt;
  float roughest = 0, rougher = 0;
  for (std::size_t other = 0; other < all.size(); ++other) {
    if (other == own) continue;
    const auto& o = all[other];
    const float slip = 1 + o.difference.cost / kStrange;
    const auto [ox, oy] = chord(o.model);
    const float length = std::max(std::hypot(ox, oy), 1e-3F);
    const float cosine = (x * ox + y * oy) / (std::max(std::hypot(x, y), 1e-3F) * length);
    const float in_direction =
        cosine * cosine * cosine * cosine * std::min(length / kLong, 1.0F) / (slip * slip);
    alike += in_direction * turns[other];
    alike_weight += in_direction;
    const float dx = o.model.centre_x - s.model.centre_x;
    const float dy = o.model.centre_y - s.model.centre_y;
    const float beside = std::exp(-(dx * dx + dy * dy) / (2 * kReach * kReach)) / (slip * slip);
    near += beside * o.residue.turn_rad;
    near_weight += beside;
    roughest = std::max(roughest, static_cast<float>(o.judgement.deviation));
    if (o.judgement.deviation > s.judgement.deviation) ++rougher;
  }
  row.put(alike / alike_weight);
  row.put(std::abs(turns[own] - alike / alike_weight));
  row.put(near / near_weight);
  row.put(std::abs(s.residue.turn_rad - near / near_weight));
  row.put(std::min(roughest, kMostRough));
  row.put(rougher / static_cast<float>(std::max<std::size_t>(all.size() - 1, 1)));
}

/// Mean distance of the points of both lines, centred and of length 1.
float unit_distance(const Samples& d, const Samples& m) {
  const float of_drawn = 1 / std::max(d.length, 1e-6F);
  const float of_model = 1 / std::max(m.length, 1e-6F);
  float sum = 0;
  for (std::size_t k = 0; k < kSamples; ++k)
    sum += std::hypot((d.x[k] - d.centre_x) * of_drawn - (m.x[k] - m.centre_x) * of_model,
                      (d.y[k] - d.centre_y) * of_drawn - (m.y[k] - m.centre_y) * of_model);
  return sum / static_cast<float>(kSamples);
}

/// How far apart both lines are: their shapes, also as drawn, because a strange stroke bends the map to its
/// own favour; and where they lie, also beside the neighbours.
void put_distances(Row& row, const JudgedStroke& s) {
  row.put(unit_distance(s.as_drawn, s.model));
  row.put(unit_distance(s.drawn, s.model));
  const float shared_x = s.difference.offset_x - s.placement.x;
  const float shared_y = s.difference.offset_y - s.placement.y;
  float apart = 0, apart_beside = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const float x = s.drawn.x[k] - s.model.x[k];
    const float y = s.drawn.y[k] - s.model.y[k];
    apart += std::hypot(x, y);
    apart_beside += std::hypot(x - shared_x, y - shared_y);
  }
  row.put(apart / static_cast<float>(kSamples));
  row.put(apart_beside / static_cast<float>(kSamples));
}

/// What the map makes of the whole writing: how much wider it is than high, how it is turned and slanted.
void put_map(Row& row, const Affine& map) {
  const double size = map.a + map.d;
  row.put(std::log(map.a / map.d));
  row.put((map.c - map.b) / size);
  row.put((map.c + map.b) / size);
}

}  // namespace

std::vector<StrokeFeatures> stroke_features(std::span<const JudgedStroke> strokes, std::size_t of_model,
                                            const Affine& map) {
  Sums all;
  std::vector<float> turns;
  turns.reserve(strokes.size());
  for (const auto& s : strokes) {
    all.add(s, 1);
    turns.push_back(turn_between(s.drawn, s.model, 0, kSamples - 1));
  }
  std::vector<StrokeFeatures> result(strokes.size());
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    Row row(result[k]);
    put_measured(row, strokes[k]);
    put_others(row, strokes[k], all, strokes.size());
    put_lines(row, strokes[k]);
    put_points(row, strokes[k]);
    row.put(of_model);
    put_ends(row, strokes, k);
    put_turns(row, strokes, turns, k);
    put_map(row, map);
    put_distances(row, strokes[k]);
    assert(row.is_full());
  }
  return result;
}

double strangeness(const StrokeFeatures& stroke, double used_freedom) {
  // Hardly any strange stroke deviates less than this share of the allowance. The trees know hands; of lines
  // drawn with a ruler, or by a program, they know less.
  constexpr double kSurelyRight = 0.25;
  // No right stroke deviates more.
  constexpr double kSurelyWrong = 4;
  const auto of_allowance = static_cast<double>(stroke[kOfAllowance]);
  if (of_allowance >= kSurelyWrong) return of_allowance;
  const double of_trees = deviation_of(static_cast<double>(trained_trees().answer(stroke)));
  return std::min(of_trees, of_allowance / kSurelyRight) + used_freedom;
}

}  // namespace nazori::writing
