// SPDX-License-Identifier: Apache-2.0
#include "stroke_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "nazori/geometry/polyline.h"

namespace nazori::calligraphy {
namespace {

using geometry::PaperPoint;
constexpr double kPi = std::numbers::pi;
constexpr int kLast = EvenStroke::kPoints - 1;

// Lengths in sides of the square. Judgements of a teacher are not that sharp; docs/brush.md lists them.
constexpr double kModelEntry = 0.06;    // over which the model's direction is taken
constexpr double kEntry = 0.045;        // over which the direction of the pen is taken
constexpr double kMostOfStroke = 0.25;  // but no more of a short stroke
constexpr double kTurned = 25 * kPi / 180;
constexpr double kKaishoEntry = -kPi / 4;  // the tip enters at 45 degrees, to the lower right
constexpr double kMostToEntry = 120 * kPi / 180;
constexpr double kHidden = 0.012;
constexpr double kNoStop = 0.5;       // width at the end over the body
constexpr double kHalfStop = 0.8;     // likewise, where the pen is lifted while it moves
constexpr double kStillMoving = 1.0;  // speed over the mean
constexpr double kBlunt = 0.7;        // a sweep or hook that ends so broad
constexpr double kHookTurned = 50 * kPi / 180;
constexpr double kThin = 0.5, kThick = 1.6;
constexpr double kUneven = 3;  // fastest speed over slowest
constexpr double kCorner = 40 * kPi / 180;
constexpr double kLeastLength = 0.08;  // shorter strokes have no speed worth judging

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }
double angle_of(PaperPoint way) { return std::atan2(way.y, way.x); }

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The mean or median of the width between two shares of the length.
double width_between(const EvenStroke& stroke, double from, double to) {
  const auto first = stroke.half_width_m.begin() + static_cast<std::ptrdiff_t>(std::lround(from * kLast));
  const auto last = stroke.half_width_m.begin() + static_cast<std::ptrdiff_t>(std::lround(to * kLast)) + 1;
  return median({first, last});
}

PaperPoint point(const EvenStroke& stroke, double share) {
  return stroke.at[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * kLast))];
}

/// The point so far from the start, but no more than a part of the stroke.
PaperPoint entry_point(const EvenStroke& stroke, double way_m) {
  const double length_m = std::max(stroke.length_m, 1e-9);
  return geometry::point_at(std::span<const PaperPoint>(stroke.at),
                            std::min(way_m, kMostOfStroke * length_m));
}

std::optional<Advice> start_advice(const StrokePair& pair, const EvenStroke& written,
                                   const EvenStroke& model) {
  const double right = start_direction(model, pair.side_m);
  const PaperPoint along{std::cos(right), std::sin(right)};
  double back_m = 0;
  for (int i = 0; i <= kLast / 5; ++i)
    back_m = std::max(back_m, -geometry::dot(written.at[static_cast<std::size_t>(i)] - written.at[0], along));
  if (back_m > kHidden * pair.side_m)
    return Advice{.kind = AdviceKind::hidden_tip, .stroke = pair.number, .amount = back_m / pair.side_m};
  // The right entry lies between the direction of the stroke and that of the brush in kaisho.
  double to_entry = pair.is_hiragana ? 0 : wrapped(kKaishoEntry - right);
  if (std::abs(to_entry) > kMostToEntry) to_entry = 0;
  const double turned = wrapped(angle_of(entry_point(written, kEntry * pair.side_m) - written.at[0]) - right);
  const double beyond = turned - std::clamp(turned, std::min(to_entry, 0.0), std::max(to_entry, 0.0));
  if (std::abs(beyond) <= kTurned) return {};
  return Advice{.kind = AdviceKind::start_turned, .stroke = pair.number, .amount = turned};
}

double end_speed_over_mean(const EvenStroke& stroke) {
  constexpr int kEnd = kLast - 4;
  const double all_s = stroke.time_s.back() - stroke.time_s.front();
  const double end_s = stroke.time_s.back() - stroke.time_s[kEnd];
  if (all_s <= 0 || end_s <= 0) return 0;
  return static_cast<double>(kLast - kEnd) / kLast / end_s * all_s;
}

std::optional<Advice> ending_advice(const StrokePair& pair, const EvenStroke& written,
                                    const EvenStroke& model) {
  constexpr double kEnd = 0.94;
  const double body = width_between(written, 0.2, 0.7);
  const double left = body > 0 ? width_between(written, kEnd, 1) / body : 0;
  const bool can_thin = width_from(*pair.written) != WidthFrom::nothing;
  const auto advice = [&](AdviceKind kind) {
    return Advice{.kind = kind, .stroke = pair.number, .amount = left};
  };
  switch (pair.ending) {
    case kanji::StrokeEnding::stop:
      if (left < kNoStop || (left < kHalfStop && end_speed_over_mean(written) > kStillMoving))
        return advice(AdviceKind::no_stop);
      break;
    case kanji::StrokeEnding::taper:
      if (left > kBlunt && can_thin) return advice(AdviceKind::no_sweep);
      break;
    case kanji::StrokeEnding::hook: {
      const double right = angle_of(point(model, 1) - point(model, kEnd));
      const double drawn = angle_of(point(written, 1) - point(written, kEnd));
      if ((left > kBlunt && can_thin) || std::abs(wrapped(drawn - right)) > kHookTurned)
        return advice(AdviceKind::no_hook);
      break;
    }
    case kanji::StrokeEnding::either:
      break;
  }
  return {};
}

std::optional<Advice> width_advice(const StrokePair& pair, const EvenStroke& written,
                                   const EvenStroke& model) {
  if (width_from(*pair.written) != WidthFrom::hand) return {};  // a mouse cannot press more
  std::vector<double> ratios;
  for (int i = kLast / 10; i <= kLast * 6 / 10; ++i) {
    const auto at = static_cast<std::size_t>(i);
    ratios.push_back(written.half_width_m[at] / std::max(model.half_width_m[at], 1e-9));
  }
  const double ratio = median(ratios);
  if (ratio < kThin) return Advice{.kind = AdviceKind::thin, .stroke = pair.number, .amount = ratio};
  if (ratio > kThick) return Advice{.kind = AdviceKind::thick, .stroke = pair.number, .amount = ratio};
  return {};
}

/// Turn of the model at a share of its length.
double turn_at(const EvenStroke& model, int at) {
  constexpr int kReach = 4;
  if (at < kReach || at + kReach > kLast) return 0;
  const auto i = static_cast<std::size_t>(at);
  return geometry::angle_between(model.at[i] - model.at[i - kReach], model.at[i + kReach] - model.at[i]);
}

std::optional<Advice> speed_advice(const StrokePair& pair, const EvenStroke& written,
                                   const EvenStroke& model) {
  if (written.length_m < kLeastLength * pair.side_m) return {};
  constexpr int kStep = 5;
  const bool ends_fast =
      pair.ending == kanji::StrokeEnding::taper || pair.ending == kanji::StrokeEnding::hook;
  struct Piece {
    double share, speed;
  };
  std::vector<Piece> pieces;
  for (int i = kLast / 6; i + kStep <= (ends_fast ? kLast * 2 / 3 : kLast * 5 / 6); i += kStep) {
    // Every hand slows down at a corner.
    double turn = 0;
    for (int k = i - 2; k <= i + kStep + 2; ++k) turn = std::max(turn, turn_at(model, k));
    if (turn > kCorner) continue;
    const auto from = static_cast<std::size_t>(i);
    const double seconds = written.time_s[from + std::size_t{kStep}] - written.time_s[from];
    if (seconds > 0) pieces.push_back({(i + kStep / 2.0) / kLast, 1 / seconds});
  }
  if (pieces.size() < 4) return {};
  const auto [slowest, fastest] = std::minmax_element(
      pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.speed < b.speed; });
  const double ratio = fastest->speed / slowest->speed;
  if (ratio < kUneven) return {};
  // What is less than half of the stroke stands out from the rest.
  const double between = std::sqrt(fastest->speed * slowest->speed);
  const auto fast = std::count_if(pieces.begin(), pieces.end(),
                                  [between](const Piece& piece) { return piece.speed > between; });
  const bool is_hasty = 2 * static_cast<std::size_t>(fast) <= pieces.size();
  double sum = 0;
  int count = 0;
  for (const Piece& piece : pieces) {
    if ((piece.speed > between) != is_hasty) continue;
    sum += piece.share;
    ++count;
  }
  const double share = sum / std::max(count, 1);
  return Advice{.kind = is_hasty ? AdviceKind::hasty : AdviceKind::halting,
                .stroke = pair.number,
                .part = share < 0.36   ? StrokePart::beginning
                        : share < 0.64 ? StrokePart::middle
                                       : StrokePart::end,
                .amount = ratio};
}

template <class Points, class Width, class Time>
EvenStroke evened(const Points& points, Width width, Time time) {
  EvenStroke even;
  std::vector<double> along{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    along.push_back(along.back() + geometry::distance(points[i - 1], points[i]));
  even.length_m = along.back();
  std::size_t i = 0;
  for (int k = 0; k <= kLast; ++k) {
    const double s = even.length_m * k / kLast;
    while (i + 2 < points.size() && along[i + 1] < s) ++i;
    const std::size_t next = std::min(i + 1, points.size() - 1);
    const double way = along[next] - along[i];
    const double share = way > 0 ? std::clamp((s - along[i]) / way, 0.0, 1.0) : 0.0;
    even.at.push_back(points[i] + (points[next] - points[i]) * share);
    even.half_width_m.push_back(width(i) + (width(next) - width(i)) * share);
    even.time_s.push_back(time(i) + (time(next) - time(i)) * share);
  }
  return even;
}

}  // namespace

EvenStroke even(const BrushStroke& stroke) {
  std::vector<PaperPoint> pens;
  std::vector<double> half_width_m;
  for (const BrushPoint& point : stroke) {
    pens.push_back(point.pen);
    half_width_m.push_back(point.half_width_m);
  }
  // Where the pen rests, the ink is as broad as the brush was at most.
  constexpr double kRests_m = 0.0001;
  const auto broaden = [&](std::size_t i, std::size_t from) {
    if (geometry::distance(pens[i], pens[from]) < kRests_m)
      half_width_m[i] = std::max(half_width_m[i], half_width_m[from]);
  };
  for (std::size_t i = 1; i < pens.size(); ++i) broaden(i, i - 1);
  for (std::size_t i = pens.size(); i-- > 1;) broaden(i - 1, i);
  return evened(
      pens, [&](std::size_t i) { return half_width_m[i]; }, [&](std::size_t i) { return stroke[i].time_s; });
}

EvenStroke even(const ModelStroke& stroke) {
  return evened(
      stroke.points, [&](std::size_t i) { return stroke.half_width_m[i]; }, [](std::size_t) { return 0.0; });
}

double start_direction(const EvenStroke& model, double side_m) {
  return angle_of(entry_point(model, kModelEntry * side_m) - model.at[0]);
}

std::vector<Advice> advice_on(const StrokePair& pair) {
  const EvenStroke written = even(*pair.written), model = even(*pair.model);
  std::vector<Advice> all;
  for (const auto& judge : {start_advice, ending_advice, width_advice, speed_advice})
    if (const auto advice = judge(pair, written, model)) all.push_back(*advice);
  return all;
}

bool is_near(const StrokePair& pair) {
  const EvenStroke written = even(*pair.written), model = even(*pair.model);
  constexpr double kNear = 0.02, kThinnest = 0.75, kThickest = 1.35;
  double sum = 0;
  std::vector<double> ratios;
  for (int i = 0; i <= kLast; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sum += geometry::distance(written.at[at], model.at[at]);
    ratios.push_back(written.half_width_m[at] / std::max(model.half_width_m[at], 1e-9));
  }
  const double ratio = median(ratios);
  if (sum / EvenStroke::kPoints >= kNear * pair.side_m) return false;
  return width_from(*pair.written) != WidthFrom::hand || (ratio > kThinnest && ratio < kThickest);
}

}  // namespace nazori::calligraphy
