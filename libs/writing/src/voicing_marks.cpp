// SPDX-License-Identifier: Apache-2.0
#include "voicing_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "alignment_costs.h"

namespace nazori::writing {
namespace {

using geometry::GlyphPoint;

constexpr std::u32string_view kVoiced =
    U"がぎぐげござじずぜぞだぢづでどばびぶべぼゔガギグゲゴザジズゼゾダヂヅデドバビブベボヴ";

GlyphPoint centre_of(const Samples& s) {
  return {static_cast<double>(s.centre_x), static_cast<double>(s.centre_y)};
}

GlyphPoint moved(const Affine& map, GlyphPoint p) {
  return {map.a * p.x + map.b * p.y + map.tx, map.c * p.x + map.d * p.y + map.ty};
}

double square(double v) { return v * v; }

double squared_distance(GlyphPoint p, GlyphPoint q) { return square(p.x - q.x) + square(p.y - q.y); }

double distance_from(const Samples& line, GlyphPoint p) {
  double least = squared_distance(centre_of(line), p);
  for (std::size_t k = 0; k < kSamples; ++k)
    least = std::min(least,
                     squared_distance({static_cast<double>(line.x[k]), static_cast<double>(line.y[k])}, p));
  return std::sqrt(least);
}

/// The map that fits all links but one best.
Affine map_of(StrokeComparer& strokes, const Alignment& alignment, const Link* left_out) {
  FitSums sums;
  for (const auto& link : alignment.links)
    if (&link != left_out)
      sums.add(strokes.moments(static_cast<std::size_t>(link.drawn), static_cast<std::size_t>(link.model),
                               link.difference.reversed),
               1);
  const auto& map = alignment.map;
  return strokes.fit(sums, std::sqrt(std::abs(map.a * map.d - map.b * map.c)));
}

/// The drawn mark beside the other strokes, all laid over the model by the map that fits those best.
class DrawnMark {
 public:
  DrawnMark(StrokeComparer& strokes, const Alignment& alignment, const Link& mark,
            const std::optional<Affine>& box)
      : strokes_(strokes), mark_(strokes.drawn()[static_cast<std::size_t>(mark.drawn)].whole) {
    for (const auto& link : alignment.links)
      if (&link != &mark) others_.push_back(&link);
    strokes_.lay(map_of(strokes, alignment, &mark));
    centre_ = centre_of(strokes_.laid_line(static_cast<std::size_t>(mark.drawn)));
    if (box) in_box_ = moved(*box, centre_of(mark_));
  }

  /// How far it is from where the model has that mark; squared glyph units.
  [[nodiscard]] double distance_from_mark(std::size_t mark) const {
    constexpr double kReach = 20;
    const auto there = centre_of(strokes_.model()[mark].whole);
    double sum = 0;
    double weight = 0;
    for (const auto* link : others_) {
      const double of_model =
          distance_from(strokes_.model()[static_cast<std::size_t>(link->model)].whole, there);
      const double of_drawn =
          distance_from(strokes_.laid_line(static_cast<std::size_t>(link->drawn)), centre_);
      const double w = std::exp(-of_model / kReach);
      sum += w * square(of_drawn - of_model);
      weight += w;
    }
    const double beside_others = weight > 0 ? sum / weight : 0;
    return 2 * beside_others + squared_distance(in_box_ ? *in_box_ : centre_, there);
  }

 private:
  StrokeComparer& strokes_;
  const Samples& mark_;
  std::vector<const Link*> others_;
  GlyphPoint centre_;
  std::optional<GlyphPoint> in_box_;
};

}  // namespace

std::optional<std::size_t> first_voicing_mark(const kanji::Character& character) {
  if (character.strokes.size() < 3 || kVoiced.find(character.code_point) == std::u32string_view::npos)
    return {};
  return character.strokes.size() - 2;
}

std::optional<int> settle_voicing_marks(StrokeComparer& strokes, Alignment& alignment, std::size_t first,
                                        const std::optional<Affine>& box) {
  if (alignment.missing.size() != 1 || !alignment.extra.empty()) return {};
  const std::array marks{static_cast<int>(first), static_cast<int>(first) + 1};
  int& missing = alignment.missing.front();
  if (missing != marks[0] && missing != marks[1]) return {};
  const int there = missing == marks[0] ? marks[1] : marks[0];
  const auto mark = std::find_if(alignment.links.begin(), alignment.links.end(),
                                 [there](const Link& link) { return link.model == there; });
  const bool is_one_for_one =
      std::all_of(alignment.links.begin(), alignment.links.end(),
                  [](const Link& link) { return link.drawn_count == 1 && link.model_count == 1; });
  if (mark == alignment.links.end() || !is_one_for_one) return {};
  const DrawnMark drawn(strokes, alignment, *mark, box);
  if (drawn.distance_from_mark(static_cast<std::size_t>(missing)) <
      drawn.distance_from_mark(static_cast<std::size_t>(there))) {
    std::swap(mark->model, missing);
    alignment.map = map_of(strokes, alignment, nullptr);
    strokes.lay(alignment.map);
    for (auto& link : alignment.links)
      link.difference =
          strokes.compare(static_cast<std::size_t>(link.drawn), static_cast<std::size_t>(link.model), kFar);
  } else {
    strokes.lay(alignment.map);
  }
  return mark->model;
}

}  // namespace nazori::writing
