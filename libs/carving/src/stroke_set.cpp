// SPDX-License-Identifier: Apache-2.0
#include "stroke_set.h"

#include <algorithm>
#include <tuple>

namespace nazori::carving {
namespace {

bool comes_before(const kanji::StrokeLine* a, const kanji::StrokeLine* b) {
  if (a->points == b->points) return a->ending < b->ending;
  return std::lexicographical_compare(
      a->points.begin(), a->points.end(), b->points.begin(), b->points.end(),
      [](geometry::GlyphPoint p, geometry::GlyphPoint q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); });
}

}  // namespace

std::vector<const kanji::StrokeLine*> stroke_set(std::span<const kanji::StrokeLine> strokes) {
  std::vector<const kanji::StrokeLine*> set;
  set.reserve(strokes.size());
  for (const kanji::StrokeLine& stroke : strokes) set.push_back(&stroke);
  std::sort(set.begin(), set.end(), comes_before);
  const auto same = [](const kanji::StrokeLine* a, const kanji::StrokeLine* b) {
    return a->points == b->points && a->ending == b->ending;
  };
  set.erase(std::unique(set.begin(), set.end(), same), set.end());
  return set;
}

std::vector<const Groove*> groove_set(std::span<const Groove> grooves) {
  std::vector<const Groove*> set;
  set.reserve(grooves.size());
  for (const Groove& groove : grooves) set.push_back(&groove);
  const auto key = [](const GroovePoint& p) { return std::tie(p.at.x, p.at.y, p.half_width, p.depth); };
  std::sort(set.begin(), set.end(), [&key](const Groove* a, const Groove* b) {
    return std::lexicographical_compare(
        a->begin(), a->end(), b->begin(), b->end(),
        [&key](const GroovePoint& p, const GroovePoint& q) { return key(p) < key(q); });
  });
  set.erase(std::unique(set.begin(), set.end(), [](const Groove* a, const Groove* b) { return *a == *b; }),
            set.end());
  return set;
}

}  // namespace nazori::carving
