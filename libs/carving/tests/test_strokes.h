// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "nazori/carving/carve.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/svg_path.h"
#include "test_paths.h"

namespace nazori::carving::test {

using geometry::GlyphPoint;
using kanji::StrokeEnding;
using kanji::StrokeLine;

inline StrokeLine stroke(std::initializer_list<GlyphPoint> points, StrokeEnding ending = StrokeEnding::stop) {
  return {points, ending, {}};
}

/// A brush of a fixed width, not fitted to the strokes.
inline Brush plain_brush(double width = 7) {
  Brush brush;
  brush.width = width;
  brush.fit = false;
  return brush;
}

/// A brush without press and endings, for closed forms.
inline Brush even_brush(double width, CrossSection cross_section = CrossSection::rounded) {
  Brush brush = plain_brush(width);
  brush.cross_section = cross_section;
  brush.endings = false;
  return brush;
}

inline surface::HeightMap carved(const std::vector<StrokeLine>& strokes, int size, const Brush& brush) {
  auto map = carve(strokes, size, brush);
  if (!map) {
    ADD_FAILURE() << base::to_line(map.error());
    return {};
  }
  return *std::move(map);
}

/// Height at a point of the glyph box, interpolated bilinearly between its four samples.
inline double height_at(const surface::HeightMap& map, GlyphPoint p) {
  const geometry::GridPoint g = geometry::glyph_to_grid(p, map.size());
  const int x = std::min(static_cast<int>(g.x), map.size() - 2);
  const int y = std::min(static_cast<int>(g.y), map.size() - 2);
  const double u = g.x - x;
  const double v = g.y - y;
  return (map.at(x, y) * (1 - u) + map.at(x + 1, y) * u) * (1 - v) +
         (map.at(x, y + 1) * (1 - u) + map.at(x + 1, y + 1) * u) * v;
}

/// The strokes of a character of the fixture as KanjiVG draws them.
inline std::vector<StrokeLine> kanjivg(const std::string& character) {
  std::ifstream file(std::string(test_paths::kFixtures) + "/kanjivg.tsv");
  std::vector<StrokeLine> strokes;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string name;
    std::string number;
    std::string type;
    std::string ending;
    std::string path;
    std::getline(fields, name, '\t');
    std::getline(fields, number, '\t');
    std::getline(fields, type, '\t');
    std::getline(fields, ending, '\t');
    std::getline(fields, path);
    if (name != character) continue;
    const auto parsed = geometry::parse_svg_path(path);
    if (!parsed) {
      ADD_FAILURE() << base::to_line(parsed.error());
      continue;
    }
    strokes.push_back({geometry::flatten(*parsed, 0.05),
                       ending == "hook"    ? StrokeEnding::hook
                       : ending == "taper" ? StrokeEnding::taper
                       : ending == "stop"  ? StrokeEnding::stop
                                           : StrokeEnding::either,
                       {}});
  }
  EXPECT_FALSE(strokes.empty()) << character;
  return strokes;
}

/// Strokes as a hand might scrawl them: wandering lines with corners, some leaving the box.
inline std::vector<StrokeLine> random_strokes(unsigned seed, int count = 6) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-5, 114);
  std::uniform_real_distribution<double> step(0.3, 14);
  std::normal_distribution<double> turn(0, 0.6);
  std::vector<StrokeLine> strokes;
  for (int k = 0; k < count; ++k) {
    StrokeLine line;
    line.ending = static_cast<StrokeEnding>(random() % 4);
    GlyphPoint p{place(random), place(random)};
    double direction = place(random);
    const auto points = 1 + random() % 12;
    for (std::size_t i = 0; i < points; ++i) {
      line.points.push_back(p);
      direction += turn(random) + (random() % 5 == 0 ? 1.8 : 0.0);
      const double length = step(random);
      p = p + GlyphPoint{std::cos(direction), std::sin(direction)} * length;
    }
    strokes.push_back(std::move(line));
  }
  return strokes;
}

}  // namespace nazori::carving::test
