// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/model_fit.h"

#include <algorithm>

#include "nazori/geometry/polyline.h"

namespace nazori::practice {
namespace {

using geometry::TabletFrame;
using geometry::TabletPoint;
using Line = geometry::Polyline<TabletFrame>;

constexpr int kPoints = 17;
constexpr double kLeastScale = 0.2;
constexpr double kMostScale = 2;
constexpr double kLineHalfWidth_m = 0.0007;

Line evenly(const Line& line) {
  Line out;
  const double length_m = geometry::arc_length<TabletFrame>(line);
  for (int i = 0; i < kPoints; ++i)
    out.push_back(geometry::point_at<TabletFrame>(line, length_m * i / (kPoints - 1)));
  return out;
}

Line line_of(const haptics::StrokePath& stroke) {
  Line line;
  for (const auto& p : stroke.points) line.push_back({p.x, p.y});
  return line;
}

}  // namespace

ModelFit fit_model(const std::vector<HandStroke>& written, const writing::Grade& grade,
                   std::span<const haptics::StrokePath> model) {
  Line from;
  Line to;
  for (std::size_t i = 0; i < written.size() && i < grade.strokes.size(); ++i) {
    const auto& verdict = grade.strokes[i];
    if (!verdict.matched || static_cast<std::size_t>(*verdict.matched) >= model.size() || written[i].empty())
      continue;
    Line hand;
    for (const auto& point : written[i]) hand.push_back(point.at);
    if (verdict.reversed) std::reverse(hand.begin(), hand.end());
    const Line a = evenly(line_of(model[static_cast<std::size_t>(*verdict.matched)]));
    const Line b = evenly(hand);
    from.insert(from.end(), a.begin(), a.end());
    to.insert(to.end(), b.begin(), b.end());
  }
  ModelFit fit;
  if (from.empty()) return fit;
  const auto mean = [](const Line& line) {
    TabletPoint sum{0, 0};
    for (const auto& p : line) sum = sum + p;
    return TabletPoint{sum.x / static_cast<double>(line.size()), sum.y / static_cast<double>(line.size())};
  };
  const TabletPoint a = mean(from);
  const TabletPoint b = mean(to);
  double both = 0;
  double alone = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const TabletPoint p = from[i] - a;
    const TabletPoint q = to[i] - b;
    both += p.x * q.x + p.y * q.y;
    alone += p.x * p.x + p.y * p.y;
  }
  if (alone > 0) fit.scale = std::clamp(both / alone, kLeastScale, kMostScale);
  fit.x_m = b.x - fit.scale * a.x;
  fit.y_m = b.y - fit.scale * a.y;
  return fit;
}

view::InkedStroke model_line(const haptics::StrokePath& stroke, const ModelFit& fit, double opacity,
                             double share) {
  view::InkedStroke line;
  line.verdict = view::Verdict::shown;
  line.opacity = opacity;
  line.half_width_m = kLineHalfWidth_m;
  const auto points = line_of(stroke);
  double length_m = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length_m += geometry::distance(points[i - 1], points[i]);
  double left_m = length_m * share;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double step_m = i == 0 ? 0 : geometry::distance(points[i - 1], points[i]);
    if (share < 1 && step_m > left_m) {
      line.points.push_back({fit.apply(points[i - 1] + (points[i] - points[i - 1]) * (left_m / step_m))});
      break;
    }
    left_m -= step_m;
    line.points.push_back({fit.apply(points[i])});
  }
  return line;
}

std::vector<view::Verdict> verdicts(const writing::Grade& grade, std::size_t strokes) {
  std::vector<view::Verdict> out(strokes, view::Verdict::none);
  for (std::size_t i = 0; i < strokes && i < grade.strokes.size(); ++i)
    out[i] = grade.strokes[i].ok ? view::Verdict::right : view::Verdict::wrong;
  const auto mark = [&out](const writing::Mistake& mistake, view::Verdict verdict) {
    if (mistake.kind == kanji::MistakeKind::missing) return;
    if (mistake.stroke >= 0 && static_cast<std::size_t>(mistake.stroke) < out.size())
      out[static_cast<std::size_t>(mistake.stroke)] = verdict;
  };
  for (const auto& advice : grade.advice) mark(advice, view::Verdict::nearly);
  for (const auto& mistake : grade.mistakes) mark(mistake, view::Verdict::wrong);
  return out;
}

std::vector<int> missing_strokes(const writing::Grade& grade, int model_strokes) {
  std::vector<int> missing;
  for (int n = 0; n < model_strokes; ++n) {
    const bool there = std::any_of(grade.strokes.begin(), grade.strokes.end(),
                                   [n](const writing::StrokeVerdict& v) { return v.matched == n; });
    if (!there) missing.push_back(n);
  }
  return missing;
}

}  // namespace nazori::practice
