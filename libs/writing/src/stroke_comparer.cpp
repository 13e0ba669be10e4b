// SPDX-License-Identifier: Apache-2.0
#include "stroke_comparer.h"

namespace nazori::writing {
namespace {

/// What makes the drawing about as large as the model: sums of tiny or huge coordinates would lose numbers.
double unit_for(std::span<const Shape> drawn) {
  float largest = 0;
  for (const auto& s : drawn) largest = std::max(largest, s.whole.inertia);
  constexpr double kOfTheModel = 150;  // the root of a long stroke's inertia
  constexpr double kOnePoint = 1e-12;
  const double size = std::sqrt(static_cast<double>(largest));
  return size > kOnePoint ? kOfTheModel / size : 1;
}

}  // namespace

StrokeComparer::StrokeComparer(std::span<const Shape> drawn, std::span<const Shape> model,
                               std::span<const Shape> pairs)
    : drawn_(drawn), model_(model), pairs_(pairs), unit_(unit_for(drawn)) {
  origin_x_ = static_cast<double>(drawn.front().whole.centre_x);
  origin_y_ = static_cast<double>(drawn.front().whole.centre_y);
  parts_.reserve(2 * drawn.size());
  for (const auto& s : drawn) add_part(s.whole);
  bodies_.assign(drawn.size(), kNone);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (!drawn[i].body) continue;
    bodies_[i] = parts_.size();
    add_part(*drawn[i].body);
  }
  joined_.resize(drawn.size());
  side_ = side_of(model);
}

void StrokeComparer::add_part(const Samples& s) {
  auto& part = parts_.emplace_back();
  const auto unit = static_cast<float>(unit_);
  for (std::size_t k = 0; k < kSamples; ++k) {
    part.x[k] = (s.x[k] - s.centre_x) * unit;
    part.y[k] = (s.y[k] - s.centre_y) * unit;
  }
  for (std::size_t k = 0; k < kSamples; ++k) {
    part.xx += part.x[k] * part.x[k];
    part.xy += part.x[k] * part.y[k];
    part.yy += part.y[k] * part.y[k];
  }
  part.centre_x = (static_cast<double>(s.centre_x) - origin_x_) * unit_;
  part.centre_y = (static_cast<double>(s.centre_y) - origin_y_) * unit_;
}

StrokeComparer::Side StrokeComparer::side_of(std::span<const Shape> shapes) const {
  Side side;
  side.parts.reserve(2 * shapes.size());
  for (const auto& s : shapes) side.parts.push_back({&s.whole, model_summary_of(s.whole, s.freedom)});
  side.bodies.assign(shapes.size(), kNone);
  for (std::size_t j = 0; j < shapes.size(); ++j) {
    if (!shapes[j].body) continue;
    side.bodies[j] = side.parts.size();
    side.parts.push_back({&*shapes[j].body, model_summary_of(*shapes[j].body, shapes[j].freedom)});
  }
  side.products.resize(2 * parts_.size() * side.parts.size());
  return side;
}

StrokeComparer::Side& StrokeComparer::pair_side() {
  if (!pair_side_) pair_side_ = side_of(pairs_);
  return *pair_side_;
}

void StrokeComparer::lay(const Affine& map) {
  map_ = map;
  linear_ = {static_cast<float>(map.a / unit_), static_cast<float>(map.b / unit_),
             static_cast<float>(map.c / unit_), static_cast<float>(map.d / unit_)};
  for (auto& part : parts_) place(part);
  for (auto& shape : joined_) shape.reset();
}

/// Its centre; the rest waits until it is asked for.
void StrokeComparer::place(Part& part) const {
  const double x = part.centre_x / unit_ + origin_x_;
  const double y = part.centre_y / unit_ + origin_y_;
  part.laid.x = static_cast<float>(map_.a * x + map_.b * y + map_.tx);
  part.laid.y = static_cast<float>(map_.c * x + map_.d * y + map_.ty);
  part.is_measured = false;
}

const StrokeSummary& StrokeComparer::measured(std::size_t index) {
  auto& part = parts_[index];
  auto& laid = part.laid;
  if (part.is_measured) return laid;
  const auto [a, b, c, d] = linear_;
  std::array<float, kSamples> x;
  std::array<float, kSamples> y;
  for (std::size_t k = 0; k < kSamples; ++k) {
    x[k] = a * part.x[k] + b * part.y[k];
    y[k] = c * part.x[k] + d * part.y[k];
  }
  float length = 0;
  for (std::size_t k = 1; k < kSamples; ++k) {
    const float dx = x[k] - x[k - 1];
    const float dy = y[k] - y[k - 1];
    length += std::sqrt(dx * dx + dy * dy);
  }
  laid.length = length;
  laid.per_length = per_length(length);
  laid.length_log = std::log(length + kLengthFloor);
  laid.slope = slope_of(x.back() - x.front(), y.back() - y.front());
  laid.inertia = (a * a + c * c) * part.xx + 2 * (a * b + c * d) * part.xy + (b * b + d * d) * part.yy;
  part.is_measured = true;
  return laid;
}

const StrokeComparer::Products& StrokeComparer::products(Side& side, std::size_t index,
                                                         std::size_t model_part, bool reversed) {
  auto& p = side.products[2 * (index * side.parts.size() + model_part) + (reversed ? 1 : 0)];
  if (p.are_known) return p;
  const auto& part = parts_[index];
  const auto& m = *side.parts[model_part].samples;
  const auto add = [&](std::size_t j, std::size_t k) {
    const float u = m.x[k] - m.centre_x;
    const float v = m.y[k] - m.centre_y;
    p.xu += part.x[j] * u;
    p.yu += part.y[j] * u;
    p.xv += part.x[j] * v;
    p.yv += part.y[j] * v;
  };
  if (reversed)
    for (std::size_t k = 0; k < kSamples; ++k) add(kSamples - 1 - k, k);
  else
    for (std::size_t k = 0; k < kSamples; ++k) add(k, k);
  p.are_known = true;
  return p;
}

CentredDifference StrokeComparer::centred(Side& side, std::size_t part, std::size_t model_part) {
  return centred_difference(measured(part), side.parts[model_part].summary, [&](bool reversed) {
    const auto& p = products(side, part, model_part, reversed);
    return linear_.a * p.xu + linear_.b * p.yu + linear_.c * p.xv + linear_.d * p.yv;
  });
}

/// Strokes with and without hooks: what is least counts.
StrokeComparer::Best StrokeComparer::best_of(Side& side, std::size_t drawn, std::size_t model) {
  Best best{drawn, model, centred(side, drawn, model)};
  const auto take = [&](std::size_t part, std::size_t model_part) {
    if (part == kNone || model_part == kNone) return;
    const auto other = centred(side, part, model_part);
    if (other.cost < best.centred.cost) best = {part, model_part, other};
  };
  take(drawn, side.bodies[model]);
  take(bodies_[drawn], model);
  take(bodies_[drawn], side.bodies[model]);
  return best;
}

StrokeDifference StrokeComparer::compare_with(Side& side, std::size_t drawn, std::size_t model, float far) {
  const auto& own = side.parts[model].summary;
  if (cost_of_place(parts_[drawn].laid, own) > far) return difference_from_afar(measured(drawn), own);
  const auto best = best_of(side, drawn, model);
  return difference_of(measured(best.part), side.parts[best.model_part].summary, best.centred);
}

StrokeDifference StrokeComparer::compare(std::size_t drawn, std::size_t model, float far) {
  return compare_with(side_, drawn, model, far);
}

float StrokeComparer::cost(std::size_t drawn, std::size_t model, float far) {
  const float of_place = cost_of_place(parts_[drawn].laid, side_.parts[model].summary);
  return of_place > far ? of_place : best_of(side_, drawn, model).centred.cost;
}

StrokeDifference StrokeComparer::compare_with_pair(std::size_t drawn, std::size_t pair, float far) {
  return compare_with(pair_side(), drawn, pair, far);
}

float StrokeComparer::least_of(const StrokeSummary& laid, const Side& side, std::size_t model) const {
  const float whole = cost_of_place(laid, side.parts[model].summary);
  const auto body = side.bodies[model];
  return body == kNone ? whole : std::min(whole, cost_of_place(laid, side.parts[body].summary));
}

float StrokeComparer::least_with(const Side& side, std::size_t drawn, std::size_t model) const {
  const float whole = least_of(parts_[drawn].laid, side, model);
  const auto body = bodies_[drawn];
  return body == kNone ? whole : std::min(whole, least_of(parts_[body].laid, side, model));
}

float StrokeComparer::least_cost(std::size_t drawn, std::size_t model) const {
  return least_with(side_, drawn, model);
}

float StrokeComparer::least_cost_with_pair(std::size_t drawn, std::size_t pair) {
  return least_with(pair_side(), drawn, pair);
}

bool StrokeComparer::is_as_long_as_pair(std::size_t drawn, std::size_t pair) {
  constexpr float kSlack = 0.2F;
  const float own = measured(drawn).length_log;
  const auto ratio = [own](const ModelPart& part) { return std::abs(own - part.summary.stroke.length_log); };
  return ratio(pair_side().parts[pair]) <=
         std::min(ratio(side_.parts[pair]), ratio(side_.parts[pair + 1])) + kSlack;
}

float StrokeComparer::least_cost_of_joined(std::size_t drawn, std::size_t model) {
  const auto& both = joined_drawn(drawn);
  const auto least = [&](const Samples& samples) {
    StrokeSummary laid;
    laid.x = samples.centre_x;
    laid.y = samples.centre_y;
    return least_of(laid, side_, model);
  };
  return both.body ? std::min(least(both.whole), least(*both.body)) : least(both.whole);
}

const Shape& StrokeComparer::joined_drawn(std::size_t k) {
  if (!joined_[k])
    joined_[k] = joined(transformed(drawn_[k].whole, map_), transformed(drawn_[k + 1].whole, map_));
  return *joined_[k];
}

float StrokeComparer::whole_length_log(std::size_t drawn, std::size_t model) {
  return measured(drawn).length_log - side_.parts[model].summary.stroke.length_log;
}

float StrokeComparer::turn(std::size_t drawn, std::size_t model, bool reversed) {
  const auto& p = products(side_, drawn, model, reversed);
  const float along = linear_.a * p.xu + linear_.b * p.yu + linear_.c * p.xv + linear_.d * p.yv;
  const float across = linear_.c * p.xu + linear_.d * p.yu - linear_.a * p.xv - linear_.b * p.yv;
  return std::atan2(across, along);
}

PairMoments StrokeComparer::moments_with(Side& side, std::size_t drawn, std::size_t model, bool reversed) {
  const auto& part = parts_[drawn];
  const auto& m = side.parts[model].summary.stroke;
  const auto& p = products(side, drawn, model, reversed);
  const auto mean = [](float sum) { return static_cast<double>(sum) / static_cast<double>(kSamples); };
  return {part.centre_x,
          part.centre_y,
          static_cast<double>(m.x),
          static_cast<double>(m.y),
          mean(part.xx),
          mean(part.xy),
          mean(part.yy),
          mean(p.xu),
          mean(p.yu),
          mean(p.xv),
          mean(p.yv)};
}

PairMoments StrokeComparer::moments(std::size_t drawn, std::size_t model, bool reversed) {
  return moments_with(side_, drawn, model, reversed);
}

PairMoments StrokeComparer::moments_of_pair(std::size_t drawn, std::size_t pair, bool reversed) {
  return moments_with(pair_side(), drawn, pair, reversed);
}

PairMoments StrokeComparer::moments_of_joined(std::size_t drawn, std::size_t model, bool reversed) const {
  const auto line = joined(drawn_[drawn].whole, drawn_[drawn + 1].whole).whole;
  auto p = writing::moments_of({&line, &model_[model].whole, reversed, 1});
  p.x = (p.x - origin_x_) * unit_;
  p.y = (p.y - origin_y_) * unit_;
  for (double* product : {&p.xx, &p.xy, &p.yy}) *product *= unit_ * unit_;
  for (double* product : {&p.xu, &p.yu, &p.xv, &p.yv}) *product *= unit_;
  return p;
}

Affine StrokeComparer::fit(const FitSums& sums, double expected_scale) const {
  if (sums.weight <= 0) return {};
  auto map = writing::fit(sums, expected_scale / unit_);
  for (double* factor : {&map.a, &map.b, &map.c, &map.d}) *factor *= unit_;
  map.tx -= map.a * origin_x_ + map.b * origin_y_;
  map.ty -= map.c * origin_x_ + map.d * origin_y_;
  return map;
}

}  // namespace nazori::writing
