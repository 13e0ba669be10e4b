// SPDX-License-Identifier: Apache-2.0
// The parts of which finding a character is made, each by its definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "drawing.h"
#include "handwritten_forms.h"
#include "ink_match.h"
#include "ink_moments.h"
#include "known_characters.h"
#include "nazori/geometry/svg_path.h"
#include "quick_strokes.h"
#include "steady_line.h"
#include "stroke_picture.h"

namespace nazori::writing {
namespace {

using Flat = std::vector<float>;
using Flats = std::vector<Flat>;

std::vector<FlatLine> lines(const Flats& strokes) { return {strokes.begin(), strokes.end()}; }

/// Strokes that a hand might draw, always the same.
Flats some_strokes(int number, std::size_t count) {
  std::mt19937 luck(static_cast<unsigned>(number));
  std::uniform_real_distribution<float> place(0, 100);
  Flats strokes(count);
  for (Flat& stroke : strokes)
    for (int k = 0; k < 8; ++k) stroke.push_back(place(luck));
  return strokes;
}

/// All strokes with each point mapped. @param to  x, y to a pair
template <class Map>
Flats mapped(Flats strokes, Map to) {
  for (Flat& stroke : strokes)
    for (std::size_t i = 0; i + 1 < stroke.size(); i += 2)
      std::tie(stroke[i], stroke[i + 1]) = to(stroke[i], stroke[i + 1]);
  return strokes;
}
const auto kMoved = [](float x, float y) { return std::pair(3 * x - 70, 3 * y + 20); };
const auto kMirrored = [](float x, float y) { return std::pair(100 - x, y); };

/// The same ink with its strokes in another order and each drawn from its other end.
Flats drawn_backwards(Flats strokes) {
  std::reverse(strokes.begin(), strokes.end());
  for (Flat& stroke : strokes) {
    Flat back;
    for (std::size_t i = stroke.size(); i >= 2; i -= 2)
      back.insert(back.end(), {stroke[i - 2], stroke[i - 1]});
    stroke = back;
  }
  return strokes;
}

TEST(ThreePoints, AreTheStartTheMiddleOfTheWayAndTheEnd) {
  // 30 to the right, then 10 down: the middle lies after 20.
  const Flat hook{10, 50, 40, 50, 40, 60};
  ThreePoints p = three_points(hook);
  EXPECT_EQ((std::vector<float>(p.x, p.x + 3)), (std::vector<float>{10, 30, 40}));
  EXPECT_EQ((std::vector<float>(p.y, p.y + 3)), (std::vector<float>{50, 50, 60}));
  // The middle on the last of three pieces.
  const Flat long_end{0, 0, 3, 0, 3, 3, 3, 23};
  p = three_points(long_end);
  EXPECT_NEAR(p.x[1], 3, 1e-5);
  EXPECT_NEAR(p.y[1], 10, 1e-5);
  const Flat dot{7, 8};
  p = three_points(dot);
  EXPECT_EQ((std::vector<float>(p.x, p.x + 3)), (std::vector<float>{7, 7, 7}));
  EXPECT_EQ((std::vector<float>(p.y, p.y + 3)), (std::vector<float>{8, 8, 8}));
}

std::vector<ThreePoints> three_points_of(const Flats& strokes) {
  std::vector<ThreePoints> all;
  for (const Flat& stroke : strokes) all.push_back(three_points(stroke));
  return all;
}

struct Points {
  std::vector<double> x, y;
};

/// Centred, with the mean square of the points 1.
Points normalised(std::span<const ThreePoints> strokes) {
  Points p;
  for (const auto& stroke : strokes)
    for (int k = 0; k < 3; ++k) {
      p.x.push_back(static_cast<double>(stroke.x[k]));
      p.y.push_back(static_cast<double>(stroke.y[k]));
    }
  const auto n = static_cast<double>(p.x.size());
  double mx = 0, my = 0, square = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) mx += p.x[i] / n, my += p.y[i] / n;
  for (std::size_t i = 0; i < p.x.size(); ++i)
    square += (std::pow(p.x[i] - mx, 2) + std::pow(p.y[i] - my, 2)) / n;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    p.x[i] = (p.x[i] - mx) / std::sqrt(square);
    p.y[i] = (p.y[i] - my) / std::sqrt(square);
  }
  return p;
}

/// The mean squared distance of the points of both, by its definition.
double mean_square(std::span<const ThreePoints> drawn, std::span<const ThreePoints> model) {
  const Points a = normalised(drawn), b = normalised(model);
  double sum = 0;
  for (std::size_t i = 0; i < a.x.size(); ++i)
    sum += std::pow(a.x[i] - b.x[i], 2) + std::pow(a.y[i] - b.y[i], 2);
  return sum / static_cast<double>(a.x.size());
}

/// The least distance if one stroke of the longer one is left out.
double least_but_one(std::span<const ThreePoints> shorter, const std::vector<ThreePoints>& longer) {
  double least = 4;
  for (std::size_t gap = 0; gap < longer.size(); ++gap) {
    auto rest = longer;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(gap));
    least = std::min(least, mean_square(shorter, rest));
  }
  return least;
}

TEST(QuickDrawing, IsCentredWithTheMeanSquareOfItsPointsOne) {
  const auto strokes = three_points_of(some_strokes(1, 4));
  const QuickDrawing drawing = quick_drawing(strokes);
  const Points wanted = normalised(strokes);
  ASSERT_EQ(drawing.strokes.size(), 4U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(drawing.strokes[i / 3].x[i % 3], wanted.x[i], 1e-4);
    EXPECT_NEAR(drawing.strokes[i / 3].y[i % 3], wanted.y[i], 1e-4);
  }
}

TEST(QuickDrawing, DistancesAreThoseOfTheDefinition) {
  for (int i = 0; i < 20; ++i) {
    const std::size_t count = 1 + static_cast<std::size_t>(i % 5);
    const auto drawn = three_points_of(some_strokes(i, count));
    const auto model = three_points_of(some_strokes(100 + i, count + 1));
    const std::span first(model.data(), count);
    EXPECT_NEAR(distance_in_order(quick_drawing(drawn), model), mean_square(drawn, first), 1e-3)
        << "only as many strokes as were drawn count";
    EXPECT_NEAR(distance_with_a_gap(quick_drawing(drawn), model), least_but_one(drawn, model), 1e-3);
    EXPECT_NEAR(distance_with_one_too_many(quick_drawing(model), drawn), least_but_one(drawn, model), 1e-3);
  }
}

TEST(QuickDrawing, TheSameDrawingElsewhereIsNoFartherThanNothingWhicheverStrokeIsLeftOut) {
  const Flats whole = some_strokes(3, 4);
  const auto model = three_points_of(whole);
  EXPECT_NEAR(distance_in_order(quick_drawing(three_points_of(mapped(whole, kMoved))), model), 0, 1e-3);
  for (std::size_t gap = 0; gap < 4; ++gap) {
    Flats rest = mapped(whole, kMoved);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(gap));
    EXPECT_NEAR(distance_with_a_gap(quick_drawing(three_points_of(rest)), model), 0, 1e-3) << gap;
    EXPECT_NEAR(distance_with_one_too_many(quick_drawing(model), three_points_of(rest)), 0, 1e-3) << gap;
  }
}

/// The point of a line after a part of its way.
std::pair<double, double> on_line(const Flat& line, double share) {
  double whole = 0;
  for (std::size_t i = 2; i + 1 < line.size(); i += 2)
    whole += std::hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
  double left = share * whole;
  for (std::size_t i = 2; i + 1 < line.size(); i += 2) {
    const double dx = line[i] - line[i - 2], dy = line[i + 1] - line[i - 1];
    const double piece = std::hypot(dx, dy);
    if (left <= piece || i + 3 >= line.size()) {
      const double t = piece > 0 ? std::min(left / piece, 1.0) : 0;
      return {line[i - 2] + t * dx, line[i - 1] + t * dy};
    }
    left -= piece;
  }
  return {line[0], line[1]};
}

TEST(SteadyLine, HasAPointForEachFortiethOfTheSideFromThreeToFortyEight) {
  const auto points = [](float length, float side) {
    return steady_line(Flat{0, 0, length, 0}, side).size() / 2;
  };
  EXPECT_EQ(points(50.5F, 100), 20U);
  EXPECT_EQ(points(1, 100), 3U);
  EXPECT_EQ(points(0, 100), 3U);
  EXPECT_EQ(points(1000, 100), 48U);
  // What counts is how far it reaches to both sides, not how long it is.
  EXPECT_EQ(steady_line(Flat{0, 0, 25.5F, 25.5F}, 100).size() / 2, 20U);
  EXPECT_EQ(steady_line(Flat{0, 0, 25.5F, 0, 0, 0, 25.5F, 0}, 100).size() / 2, 10U);
  EXPECT_EQ(steady_line(Flat{-5, 10, 20.5F, 10, 20.5F, 35.5F, -5, 35.5F}, 100).size() / 2, 20U);
}

TEST(SteadyLine, OfFewerThanTwoPointsIsTheLineItself) {
  EXPECT_EQ(steady_line(Flat{}, 100), Flat{});
  EXPECT_EQ(steady_line(Flat{3, 4}, 100), (Flat{3, 4}));
}

TEST(SteadyLine, EachPointIsTheMeanOfTheLineAroundItAndTheEndsStay) {
  for (int number = 0; number < 10; ++number) {
    const Flat line = some_strokes(number, 1).front();
    const Flat steady = steady_line(line, 100);
    const std::size_t count = steady.size() / 2;
    EXPECT_EQ(steady[0], line[0]);
    EXPECT_EQ(steady[1], line[1]);
    EXPECT_NEAR(steady[2 * count - 2], line[6], 1e-3);
    EXPECT_NEAR(steady[2 * count - 1], line[7], 1e-3);
    // Four points of the fine line lie between two, and nine of them make a mean.
    for (std::size_t k = 1; k + 1 < count; ++k) {
      double x = 0, y = 0;
      for (std::size_t i = 4 * k - 4; i <= 4 * k + 4; ++i) {
        const auto [px, py] = on_line(line, static_cast<double>(i) / static_cast<double>(4 * (count - 1)));
        x += px / 9;
        y += py / 9;
      }
      EXPECT_NEAR(steady[2 * k], x, 0.02) << number << " " << k;
      EXPECT_NEAR(steady[2 * k + 1], y, 0.02) << number << " " << k;
    }
  }
}

TEST(InkMoments, AreMeanAndSpreadOfTheLine) {
  // A level line of 12 and an upright one of 6.
  const Flats strokes{{0, 0, 12, 0}, {12, 0, 12, 6}};
  const InkMoments m = ink_moments(lines(strokes));
  EXPECT_NEAR(m.x, (12 * 6 + 6 * 12) / 18.0, 1e-5);
  EXPECT_NEAR(m.y, 6 * 3 / 18.0, 1e-5);
  const double xx = (12 * 48 + 6 * 144) / 18.0, yy = 6 * 12 / 18.0;  // of x^2: 12^2 / 3 on the level line
  EXPECT_NEAR(m.spread_x, std::sqrt(xx - 8 * 8), 1e-4);
  EXPECT_NEAR(m.spread_y, std::sqrt(yy - 1), 1e-4);
  const Flats dot{{5, 5, 5, 5}};
  EXPECT_EQ(ink_moments(lines(dot)).spread_x, 1);
  EXPECT_EQ(ink_moments(lines(dot)).x, 0);
  EXPECT_EQ(extent_of(lines(strokes)), 12);
  EXPECT_EQ(extent_of(lines({{0, 0, 1, 30}})), 30);
  EXPECT_EQ(extent_of({}), 0);
}

float ink_in(const Picture& picture, int column, int row, std::size_t slant) {
  const float root =
      picture[(static_cast<std::size_t>(row) * kPictureCells + static_cast<std::size_t>(column)) *
                  kPictureSlants +
              slant];
  return root * root;
}

TEST(StrokePicture, OfALineLiesInItsRowsWithItsSlant) {
  // A level line has a spread of 1 / sqrt(12) of its length, and the picture is 4.4 spreads wide.
  const Picture level = make_picture(lines({{10, 40, 90, 40}}));
  const double cells = 8 / 4.4 * std::sqrt(12);
  double sum = 0;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      for (std::size_t slant = 0; slant < 4; ++slant) {
        const double ink = ink_in(level, column, row, slant);
        sum += ink;
        if (slant != 0 || row < 3 || row > 4) {
          EXPECT_EQ(ink, 0) << column << " " << row << " " << slant;
        }
      }
  EXPECT_NEAR(sum, 1, 1e-5);
  for (int column = 2; column < 6; ++column)
    for (const int row : {3, 4}) EXPECT_NEAR(ink_in(level, column, row, 0), 0.5 / cells, 0.015) << column;
  // Left of the middle of the second cell all of it, and half of what lies between that and the next.
  const double ends = (cells / 2 - 2.5 + 0.5) / cells / 2;
  EXPECT_NEAR(ink_in(level, 1, 3, 0) + ink_in(level, 0, 3, 0), ends, 0.01);
}

TEST(StrokePicture, TheFourSlantsAreLevelFallingUprightAndRising) {
  const std::vector<std::pair<Flat, std::size_t>> slants{
      {{0, 50, 100, 50}, 0}, {{0, 0, 100, 100}, 1}, {{50, 0, 50, 100}, 2}, {{0, 100, 100, 0}, 3}};
  for (const auto& [line, wanted] : slants) {
    const Picture picture = make_picture(lines({line}));
    for (std::size_t i = 0; i < picture.size(); ++i)
      if (i % kPictureSlants != wanted) {
        EXPECT_NEAR(picture[i], 0, 1e-3) << wanted;
      }
  }
  // Half way between two slants both have their share. The height is drawn out by 1 / 0.6: it is less than
  // 0.6 of the width.
  const double steepness = 0.6 * std::tan(std::numbers::pi / 8);
  const Picture between = make_picture(lines({{0, 0, 100, static_cast<float>(100 * steepness)}}));
  double level = 0, falling = 0;
  for (std::size_t i = 0; i < between.size(); i += 4) {
    level += std::pow(between[i], 2);
    falling += std::pow(between[i + 1], 2);
  }
  EXPECT_NEAR(level, 0.5, 1e-3);
  EXPECT_NEAR(falling, 0.5, 1e-3);
}

TEST(StrokePicture, DoesNotDependOnPlaceSizeOrderOrDirection) {
  for (int i = 0; i < 10; ++i) {
    const Flats strokes = some_strokes(i, 3);
    const Picture picture = make_picture(lines(strokes));
    EXPECT_NEAR(likeness(picture, picture), 1, 1e-4);
    EXPECT_NEAR(likeness(picture, make_picture(lines(mapped(strokes, kMoved)))), 1, 1e-3);
    EXPECT_NEAR(likeness(picture, make_picture(lines(drawn_backwards(strokes)))), 1, 1e-3);
    EXPECT_LT(likeness(picture, make_picture(lines(some_strokes(50 + i, 3)))), 0.97);
  }
}

TEST(StrokePicture, OfTheMirrorImageIsTheMirrorImage) {
  for (int i = 0; i < 10; ++i) {
    const Flats strokes = some_strokes(i, 3);
    const Picture picture = make_picture(lines(strokes)),
                  mirrored = make_picture(lines(mapped(strokes, kMirrored)));
    for (int row = 0; row < 8; ++row)
      for (int column = 0; column < 8; ++column)
        for (std::size_t slant = 0; slant < 4; ++slant)
          EXPECT_NEAR(ink_in(picture, column, row, slant), ink_in(mirrored, 7 - column, row, (4 - slant) % 4),
                      1e-3);
  }
}

TEST(StrokePicture, AFlatCharacterStaysFlat) {
  // Three parallel level lines close together fill no more rows than their spread, held to 0.6 of the other.
  const Picture flat = make_picture(lines({{0, 0, 100, 0}, {0, 10, 100, 10}, {0, 20, 100, 20}}));
  for (const int row : {0, 1, 6, 7})
    for (int column = 0; column < 8; ++column) EXPECT_EQ(ink_in(flat, column, row, 0), 0) << row;
  EXPECT_EQ(likeness(make_picture({}), flat), 0) << "without length there is no ink";
}

TEST(InkPoints, LieEvenlyAlongTheInkWithItsSlant) {
  const InkPoints level = ink_points(lines({{0, 0, 64, 0}}));
  // Evenly spread from -1 to 1 times the square root of three, but for half a step at each end.
  const double spread = std::sqrt((64.0 * 64 - 1) / 12);
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    EXPECT_NEAR(level.x[k], (static_cast<double>(k) - 31.5) / spread, 1e-4) << k;
    EXPECT_NEAR(level.y[k], 0, 1e-6);
    EXPECT_NEAR(level.cosine[k], 1, 1e-6);
    EXPECT_NEAR(level.sine[k], 0, 1e-6);
  }
  // A quarter of the ink falls, in a stroke of its own.
  const float diagonal = 16 / std::numbers::sqrt2_v<float>;
  const InkPoints two = ink_points(lines({{0, 0, 48, 0}, {0, 20, diagonal, 20 + diagonal}}));
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    EXPECT_NEAR(two.cosine[k], k < 48 ? 1 : 0, 1e-4) << k;
    EXPECT_NEAR(two.sine[k], k < 48 ? 0 : 1, 1e-4) << k;
  }
  EXPECT_NEAR(two.x[47] - two.x[0], 47 * (two.x[1] - two.x[0]), 1e-3);
  double square = 0, mean = 0;
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    square += (std::pow(two.x[k], 2) + std::pow(two.y[k], 2)) / kInkPoints;
    mean += (two.x[k] + two.y[k]) / kInkPoints;
  }
  EXPECT_NEAR(square, 1, 1e-4);
  EXPECT_NEAR(mean, 0, 1e-5);
  EXPECT_EQ(ink_points({}).x[5], 0);
}

TEST(InkDistance, IsNothingForTheSameInkAndOneForNoneNear) {
  for (int i = 0; i < 10; ++i) {
    const InkPoints a = ink_points(lines(some_strokes(i, 3)));
    const InkDistance same = ink_distance(a, a);
    // The least square that is told is a thousandth, of 0.16.
    EXPECT_NEAR(same.drawn, 1e-3 / 0.16, 2e-3);
    EXPECT_NEAR(same.model, 1e-3 / 0.16, 2e-3);
    const InkDistance other = ink_distance(a, ink_points(lines(some_strokes(50 + i, 3))));
    EXPECT_GT(other.drawn + other.model, 0.1);
    EXPECT_LE(std::max(other.drawn, other.model), 1);
  }
}

TEST(InkDistance, TellsInkThatIsTooMuchFromInkThatIsMissing) {
  const Flats part{{0, 0, 100, 0}, {50, 0, 50, 100}};
  Flats whole = part;
  whole.push_back({0, 100, 100, 100});
  const InkPoints fewer = ink_points(lines(part)), more = ink_points(lines(whole));
  const InkDistance missing = ink_distance(fewer, more), too_much = ink_distance(more, fewer);
  EXPECT_GT(missing.model, missing.drawn);
  EXPECT_GT(too_much.drawn, too_much.model);
}

/// The distances of both without fitting, by their definition.
double unfitted(const InkPoints& a, const InkPoints& b) {
  const auto from = [](const InkPoints& one, const InkPoints& other) {
    double sum = 0;
    for (std::size_t i = 0; i < kInkPoints; ++i) {
      double least = 0.16;
      for (std::size_t j = 0; j < kInkPoints; ++j) {
        const double dx = one.x[i] - other.x[j], dy = one.y[i] - other.y[j];
        const double likeness = one.cosine[i] * other.cosine[j] + one.sine[i] * other.sine[j];
        least = std::min(least, 1e-3 + dx * dx + dy * dy + 0.15 * (1 - likeness));
      }
      sum += least / 0.16 / kInkPoints;
    }
    return sum;
  };
  return from(a, b) + from(b, a);
}

TEST(InkDistance, ASlightSlantOrStretchIsFittedAway) {
  for (const auto& [slant, stretch] : std::vector<std::pair<float, float>>{
           {-0.1F, 1.F}, {0.1F, 1.F}, {0.F, 0.85F}, {0.F, 1.15F}, {0.F, 1.F}}) {
    double found = 0, without = 0;
    for (int i = 0; i < 12; ++i) {
      const Flats strokes = some_strokes(i, 4);
      const auto map = [slant = slant, stretch = stretch](float x, float y) {
        return std::pair(x * stretch + slant * y, y);
      };
      const InkPoints model = ink_points(lines(strokes));
      for (const bool upright : {false, true}) {
        // The same across and along.
        const auto turned = [](float x, float y) { return std::pair(y, x); };
        const Flats drawn =
            upright ? mapped(mapped(mapped(strokes, turned), map), turned) : mapped(strokes, map);
        const InkPoints points = ink_points(lines(drawn));
        const InkDistance d = ink_distance(points, model);
        EXPECT_LT(d.drawn + d.model, unfitted(points, model) + 2e-3);
        found += static_cast<double>(d.drawn + d.model) / 24;
        without += unfitted(points, model) / 24;
      }
    }
    if (slant != 0 || stretch != 1) {
      EXPECT_LT(found, 0.7 * without) << slant << " " << stretch;
    } else {
      EXPECT_NEAR(found, without, 2e-3);
    }
  }
}

TEST(InkDistance, InkOfAnotherSlantIsFartherThanThatOfTheSame) {
  const InkPoints level = ink_points(lines({{0, 0, 100, 0}}));
  InkPoints turned = level;
  for (std::size_t k = 0; k < kInkPoints; ++k) turned.cosine[k] = -1;
  // Slants at right angles are worth 0.3, which is farther than counts.
  const InkDistance apart = ink_distance(turned, level);
  EXPECT_NEAR(apart.drawn, 1, 1e-3);
  EXPECT_NEAR(apart.model, 1, 1e-3);
  InkPoints half = level;
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    half.cosine[k] = 0;
    half.sine[k] = 1;
  }
  EXPECT_NEAR(ink_distance(half, level).drawn, (1e-3 + 0.15) / 0.16, 0.01);
}

/// A form as a hand would draw it, in many points.
Flats drawn(const HandwrittenForm& form) {
  Flats strokes(1);
  for (const char c : form.strokes)
    if (c == '|') strokes.emplace_back();
  std::string_view rest = form.strokes;
  for (Flat& stroke : strokes) {
    const auto path = geometry::parse_svg_path(std::string(rest.substr(0, rest.find('|'))));
    EXPECT_TRUE(path);
    rest.remove_prefix(std::min(rest.size(), rest.find('|') + 1));
    geometry::GlyphPoint from = path->start;
    for (const auto& piece : path->pieces) {
      for (int k = 0; k <= 16; ++k) {
        const double t = k / 16.0, s = 1 - t;
        const auto at = from * (s * s * s) + piece[0] * (3 * s * s * t) + piece[1] * (3 * s * t * t) +
                        piece[2] * (t * t * t);
        stroke.insert(stroke.end(), {static_cast<float>(at.x), static_cast<float>(at.y)});
      }
      from = piece[2];
    }
  }
  return strokes;
}

TEST(KnownCharacters, AreKnownInEachFormOfAHandToo) {
  // Unlike any letter; the forms of a hand are all that could be near.
  const std::vector<kanji::Character> letters{test::character(U'f', {"㇑|M50,10L50,100"}),
                                              test::character(U'g', {"㇑|M50,10L50,100"})};
  const auto known = KnownCharacters::load(letters);
  ASSERT_TRUE(known);
  ASSERT_EQ(known->characters().size(), 2U);
  int forms = 0;
  for (const HandwrittenForm& form : handwritten_forms()) {
    const std::size_t index = known->characters()[0].code_point == form.character ? 0 : 1;
    if (known->characters()[index].code_point != form.character) continue;
    ++forms;
    const Flats strokes = drawn(form);
    const InkDistance near = known->ink_distance(ink_points(lines(strokes)), index);
    const InkDistance far = known->ink_distance(ink_points(lines(strokes)), 1 - index);
    // Kept in fewer points than here, the curves differ a little.
    EXPECT_LT(near.drawn + near.model, 0.12) << form.strokes;
    EXPECT_GT(far.drawn + far.model, 0.3) << form.strokes;
  }
  EXPECT_GE(forms, 4);
  EXPECT_EQ(known->forms().size(), 2U + static_cast<std::size_t>(forms));
}

}  // namespace
}  // namespace nazori::writing
