// SPDX-License-Identifier: Apache-2.0
#include "kana_dots.h"

#include <array>

#include "nazori/geometry/svg_path.h"

namespace nazori::writing {
namespace {

/// Written for this project; SVG path data, glyph frame.
struct Way {
  char32_t character = 0;
  std::size_t stroke = 0;
  const char* path = nullptr;
};

constexpr const char* kLeftDotWithFlick = "M23,61C20,67 17,72 15,78C15,82 18,82 26,75";
constexpr const char* kLeftDot = "M25,62C22,69 18,76 12,83";

constexpr std::array kWays{
    Way{U'ふ', 2, kLeftDotWithFlick}, Way{U'ふ', 2, kLeftDot},          Way{U'ぶ', 2, kLeftDotWithFlick},
    Way{U'ぶ', 2, kLeftDot},          Way{U'ぷ', 2, kLeftDotWithFlick}, Way{U'ぷ', 2, kLeftDot},
};

}  // namespace

std::vector<Shape> other_ways(char32_t character, std::size_t stroke, const Shape& shape) {
  constexpr float kLongestDot = 45;   // glyph units
  constexpr double kTolerance = 0.1;  // the same
  std::vector<Shape> ways;
  const auto add = [&](Shape way) {
    way.touch = shape.touch;
    way.freedom = shape.freedom;
    ways.push_back(way);
  };
  if (shape.body && shape.whole.length < kLongestDot) {
    Shape plain;
    plain.whole = *shape.body;
    add(plain);
  }
  for (const auto& way : kWays) {
    if (way.character != character || way.stroke != stroke) continue;
    if (const auto path = geometry::parse_svg_path(way.path))
      add(make_shape<geometry::GlyphFrame>(geometry::flatten(*path, kTolerance)));
  }
  return ways;
}

}  // namespace nazori::writing
