// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "nazori/kanji/stroke.h"

namespace nazori::author::test {

/// A character as another hand writes it: turned by up to 3 degrees, sides up to a tenth longer or shorter,
/// moved by up to 3 units, bent by waves of up to 1.5 units, and each stroke moved by up to 1 unit. For lines
/// that were traced, so that their place must come from the ink.
/// @param wave  the most by which the waves bend it, instead of 1.5.
inline std::vector<kanji::StrokeLine> moved(std::vector<kanji::StrokeLine> strokes, unsigned seed,
                                            double wave = 1.5) {
  std::mt19937 random(seed);
  const auto value = [&random](double most) {
    return (static_cast<double>(random()) / 4294967295.0 * 2 - 1) * most;
  };
  const double turn = value(3 * 3.14159265358979323846 / 180);
  const double wide = 1 + value(0.1);
  const double high = 1 + value(0.1);
  const double x = value(3);
  const double y = value(3);
  const double wave_x = value(wave);
  const double wave_y = value(wave);
  const double phase = value(3);
  constexpr double kMiddle = 54.5;
  for (kanji::StrokeLine& stroke : strokes) {
    const double own_x = value(1);
    const double own_y = value(1);
    for (geometry::GlyphPoint& p : stroke.points) {
      const double u = (p.x - kMiddle) * wide;
      const double v = (p.y - kMiddle) * high;
      p = {kMiddle + x + own_x + std::cos(turn) * u - std::sin(turn) * v + wave_x * std::sin(v / 14 + phase),
           kMiddle + y + own_y + std::sin(turn) * u + std::cos(turn) * v + wave_y * std::sin(u / 14 - phase)};
    }
  }
  return strokes;
}

}  // namespace nazori::author::test
