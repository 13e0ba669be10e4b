// SPDX-License-Identifier: Apache-2.0
#include "strangeness.h"

#include <algorithm>
#include <cassert>
#include <cmath>

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

/// The turn from the model's line between two samples to the drawn one, without its sign.
float turn_between(const Samples& d, const Samples& m, std::size_t from, std::size_t to) {
  const float dx = d.x[to] - d.x[from];
  const float dy = d.y[to] - d.y[from];
  const float mx = m.x[to] - m.x[from];
  const float my = m.y[to] - m.y[from];
  return std::abs(std::atan2(mx * dy - my * dx, mx * dx + my * dy));
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
  row.put(turn_between(d, m, 0, 6));
  row.put(turn_between(d, m, 6, 12));
  row.put(turn_between(d, m, 12, 18));
  row.put(turn_between(d, m, 18, kLast));
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

}  // namespace

std::vector<StrokeFeatures> stroke_features(std::span<const JudgedStroke> strokes, std::size_t of_model) {
  Sums all;
  for (const auto& s : strokes) all.add(s, 1);
  std::vector<StrokeFeatures> result(strokes.size());
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    Row row(result[k]);
    put_measured(row, strokes[k]);
    put_others(row, strokes[k], all, strokes.size());
    put_lines(row, strokes[k]);
    put_points(row, strokes[k]);
    row.put(of_model);
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
