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

}  // namespace nazori::carving
