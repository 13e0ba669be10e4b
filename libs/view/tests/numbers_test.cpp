// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>
#include <vector>

#include "../src/number_layout.h"
#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::difference;
using fixtures::luminance;
using fixtures::pixel;
using fixtures::rest;
using fixtures::straight;
using fixtures::Studio;

/// The usual 5 x 7 dot-matrix figures, top row first.
constexpr std::array<std::string_view, 10> kFigures{
    " ### #   ##  ### # ###  ##   # ### ", "  #   ##    #    #    #    #   ### ",
    " ### #   #    #   #   #   #   #####", " ### #   #    #  ##     ##   # ### ",
    "   #   ##  # # #  # #####   #    # ", "######    ####     #    ##   # ### ",
    " ### #    #    #### #   ##   # ### ", "#####    #   #   #    #    #    #  ",
    " ### #   ##   # ### #   ##   # ### ", " ### #   ##   # ####    #    # ### "};

/// Likeness (Pearson) of the disc's figure and a dot-matrix figure over the figure's box.
double likeness(const Picture& picture, const NumberPlace& place, int digit, bool mirrored) {
  // The box of pixels near the middle of the disc that are darker than its ground.
  const int reach = static_cast<int>(place.radius * 0.72);
  const int x0 = static_cast<int>(place.pixel.x);
  const int y0 = static_cast<int>(place.pixel.y);
  int left = x0 + reach;
  int right = x0 - reach;
  int top = y0 + reach;
  int bottom = y0 - reach;
  for (int y = y0 - reach; y <= y0 + reach; ++y) {
    for (int x = x0 - reach; x <= x0 + reach; ++x) {
      if (std::hypot(x - x0, y - y0) > reach || luminance(pixel(picture, x, y)) > 140) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  if (right <= left || bottom <= top) return -1;
  double sum_a = 0, sum_b = 0, sum_ab = 0, sum_aa = 0, sum_bb = 0;
  int count = 0;
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const int column = std::min(4, (x - left) * 5 / (right - left + 1));
      const int row = std::min(6, (y - top) * 7 / (bottom - top + 1));
      const std::size_t place_of_dot =
          static_cast<std::size_t>(row) * 5 + static_cast<std::size_t>(mirrored ? 4 - column : column);
      const char dot = kFigures[static_cast<std::size_t>(digit)][place_of_dot];
      const double a = 255 - luminance(pixel(picture, x, y));
      const double b = dot == '#' ? 1 : 0;
      sum_a += a;
      sum_b += b;
      sum_ab += a * b;
      sum_aa += a * a;
      sum_bb += b * b;
      ++count;
    }
  }
  const double covariance = sum_ab - sum_a * sum_b / count;
  return covariance / std::sqrt((sum_aa - sum_a * sum_a / count) * (sum_bb - sum_b * sum_b / count) + 1e-9);
}

std::vector<kanji::StrokeLine> nine_strokes() {
  std::vector<kanji::StrokeLine> lines;
  for (const double y : {20.0, 52.0, 84.0}) {
    for (const double x : {15.0, 45.0, 75.0}) lines.push_back(straight({x, y}, {x + 20, y + 4}));
  }
  return lines;
}

Overlay all_strokes() {
  Overlay overlay;
  overlay.strokes_visible = true;
  overlay.text_scale = 1.6;
  return overlay;
}

TEST(StrokeNumbers, AreReadableAndNeverMirroredFromAnySide) {
  Studio studio(700, 700);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  studio.view->set_strokes(kanji::centre_lines(nine_strokes()));
  for (const Camera& camera :
       {Camera{}, Camera{3.1, 0.3, 1, {}}, Camera{1.5, 1.0, 1, {}}, Camera{-0.8, 1.35, 1, {}}}) {
    studio.view->set_camera(camera);
    const Picture picture = studio.shoot(all_strokes());
    ASSERT_EQ(studio.view->numbers().size(), 9U);
    for (const NumberPlace& place : studio.view->numbers()) {
      const double upright = likeness(picture, place, place.stroke, false);
      EXPECT_GT(upright, 0.3) << "number " << place.stroke;
      for (const int other : {1, 2, 3, 4, 5, 6, 7, 9}) {
        if (other == place.stroke) continue;
        EXPECT_GT(upright, likeness(picture, place, other, false)) << place.stroke << " looks like " << other;
      }
      if (place.stroke == 1 || place.stroke == 8) continue;
      EXPECT_GT(upright, likeness(picture, place, place.stroke, true)) << place.stroke;
    }
  }
}

TEST(StrokeNumbers, StandBesideTheirStarts) {
  Studio studio(700, 700);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  studio.view->set_strokes(kanji::centre_lines(nine_strokes()));
  (void)studio.shoot(all_strokes());
  const auto lines = nine_strokes();
  for (const NumberPlace& place : studio.view->numbers()) {
    const auto start =
        geometry::glyph_to_tablet(lines[static_cast<std::size_t>(place.stroke) - 1].points[0], {});
    const glm::dvec2 at = studio.view->project({start.x, start.y, 0}, 700, 700);
    EXPECT_GE(glm::distance(at, place.pixel), place.radius - 1);
    EXPECT_LE(glm::distance(at, place.pixel), place.radius + 6);
  }
}

TEST(StrokeNumbers, NeverHideEachOtherHoweverCrowded) {
  std::vector<kanji::StrokeLine> lines;
  for (const double y : {50.0, 51.5, 53.0, 54.5, 56.0, 57.5}) {
    for (const double x : {50.0, 52.0, 54.0, 56.0, 58.0}) lines.push_back(straight({x, y}, {70, 60}));
  }
  lines.push_back(lines.front());  // two strokes from one point
  Studio studio(640, 480);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  studio.view->set_strokes(kanji::centre_lines(lines));
  for (const double text_scale : {1.0, 28.0 / 12.0}) {
    for (const Camera& camera :
         {Camera{}, Camera{1, 1.3, 1, {}}, Camera{0, 0, 0.2, {}}, Camera{2, 0.5, 3, {}}}) {
      studio.view->set_camera(camera);
      Overlay overlay = all_strokes();
      overlay.text_scale = text_scale;
      const Picture picture = studio.shoot(overlay);
      const auto numbers = studio.view->numbers();
      ASSERT_EQ(numbers.size(), 31U);
      for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t j = i + 1; j < numbers.size(); ++j)
          EXPECT_GE(glm::distance(numbers[i].pixel, numbers[j].pixel), 2 * numbers[i].radius - 2)
              << numbers[i].stroke << " and " << numbers[j].stroke;
    }
  }
}

TEST(StrokeNumbers, AThousandThatStartInOnePlaceOverlapNowhereAndStayNear) {
  const std::vector<NumberWish> wishes(1'000, NumberWish{{500, 500}, {0, -1}});
  constexpr double kRadius = 10;
  const std::vector<glm::dvec2> places = lay_out_numbers(wishes, kRadius, 3);
  ASSERT_EQ(places.size(), wishes.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE(glm::distance(places[i], places[j]), 2 * kRadius - 1e-9);
    // Discs of that number fill a circle of 316 pixels; no disc needs to be twice as far.
    EXPECT_LT(glm::distance(places[i], wishes[i].start), 2 * 316);
  }
}

TEST(StrokeNumbers, KeepTheirSizeOnScreenAtEveryZoomAndGrowWithTheText) {
  Studio studio(640, 480);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  overlay.strokes_visible = true;
  for (const double zoom : {0.2, 1.0, 3.0}) {
    studio.view->set_camera({0, 0, zoom, {}});
    (void)studio.shoot(overlay);
    ASSERT_FALSE(studio.view->numbers().empty());
    EXPECT_NEAR(studio.view->numbers()[0].radius, 10, 0.6);
  }
  (void)studio.shoot(overlay, 2.0);
  EXPECT_NEAR(studio.view->numbers()[0].radius, 20, 0.6);
  overlay.text_scale = 28.0 / 12.0;
  (void)studio.shoot(overlay, 1.0);
  EXPECT_NEAR(studio.view->numbers()[0].radius, 10 * 28.0 / 12.0, 0.6);
}

TEST(StrokeNumbers, AreNeverHiddenByTheTabletOnAnyOrbit) {
  Studio studio(500, 400);
  studio.view->set_height_map(fixtures::carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  studio.view->set_refinement(Refinement::always);
  Overlay overlay;
  overlay.strokes_visible = true;
  for (const double azimuth : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
    for (const double tilt : {0.0, 0.7, 1.4}) {
      studio.view->set_camera({azimuth, tilt, 1, {}});
      const Picture picture = studio.shoot(overlay);
      ASSERT_EQ(studio.view->numbers().size(), 6U);
      for (const NumberPlace& place : studio.view->numbers()) {
        // The upper edge of the disc, between ring and figure, has the ground's colour.
        const auto ground = pixel(picture, place.pixel + glm::dvec2(0, -place.radius * 0.72));
        EXPECT_LT(difference(ground, {0xFF, 0xFD, 0xF8}), 40)
            << "number " << place.stroke << " azimuth " << azimuth;
      }
    }
  }
}

TEST(StrokeNumbers, AreNotHiddenByTheStylus) {
  Studio studio(500, 400);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  overlay.strokes_visible = true;
  const Picture without = studio.shoot(overlay);
  const auto number = studio.view->numbers()[3];
  const auto under = studio.view->pick(number.pixel + glm::dvec2(-14, 14), 500, 400);
  ASSERT_TRUE(under.has_value());
  overlay.cursor = Cursor{{under->x, under->y, 0}, {under->x, under->y, 0}, true, {}};
  const Picture with = studio.shoot(overlay);
  int changed = 0;
  for (int y = -12; y <= 12; ++y) {
    for (int x = -12; x <= 12; ++x) {
      const glm::dvec2 at = number.pixel + glm::dvec2(x, y);
      const bool inside = std::hypot(x, y) < number.radius - 1.5;
      if (inside) {
        EXPECT_EQ(difference(pixel(without, at), pixel(with, at)), 0) << x << ", " << y;
      }
      changed += !inside && difference(pixel(without, at), pixel(with, at)) > 60 ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 20) << "the stylus does not pass under the number, so this proves nothing";
}

TEST(StrokeNumbers, CanBeSwitchedOffAndFollowTheChosenStroke) {
  Studio studio(500, 400);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  (void)studio.shoot(overlay);
  EXPECT_TRUE(studio.view->numbers().empty());
  overlay.strokes_visible = true;
  overlay.current_stroke = 3;
  (void)studio.shoot(overlay);
  ASSERT_EQ(studio.view->numbers().size(), 1U);
  EXPECT_EQ(studio.view->numbers()[0].stroke, 3);
  overlay.numbers_visible = false;
  (void)studio.shoot(overlay);
  EXPECT_TRUE(studio.view->numbers().empty());
}

}  // namespace
}  // namespace nazori::view
