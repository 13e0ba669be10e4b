// SPDX-License-Identifier: Apache-2.0
// Strokes and characters for the tests of this room.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "nazori/author/own_character.h"

namespace nazori::author::test {

using geometry::GlyphPoint;
using kanji::StrokeEnding;

/// A groove of one width and depth.
inline OwnStroke even_stroke(const std::vector<GlyphPoint>& points, double half_width = 3, double depth = 1) {
  OwnStroke stroke;
  for (const GlyphPoint p : points) stroke.points.push_back({p, half_width, depth});
  return stroke;
}

/// 十 with its parts, as an own drawing.
inline OwnCharacter cross() {
  OwnCharacter character;
  character.strokes = {even_stroke({{15, 50}, {95, 50}}), even_stroke({{55, 12}, {55, 98}}, 4, 0.75)};
  character.facts.name = "十";
  character.facts.readings = {"ジュウ", "とお"};
  character.facts.meanings = {"ten"};
  character.facts.parts = {{"一", {0}}, {"丨", {1}}};
  character.facts.radical = 24;
  character.facts.rights.licence = "CC0-1.0";
  return character;
}

/// A layer with one height in a box and 0 elsewhere.
inline HandLayer layer_with(int size, const carving::GridBox& box, float height) {
  HandLayer hand{size,
                 std::vector<float>(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0F)};
  for (int row = box.top; row < box.bottom; ++row)
    for (int column = box.left; column < box.right; ++column)
      hand.heights[static_cast<std::size_t>(row * size + column)] = height;
  return hand;
}

inline surface::HeightMap carved(const OwnCharacter& character, int size) {
  auto map = carve(character, size);
  if (!map) {
    ADD_FAILURE() << base::to_line(map.error());
    return {};
  }
  return *std::move(map);
}

/// The place of a refusal; empty where there is none.
template <class T>
std::string place_of_error(const base::Result<T>& result) {
  return result ? std::string() : result.error().where;
}

}  // namespace nazori::author::test
