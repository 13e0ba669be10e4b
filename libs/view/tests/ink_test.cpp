// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::carved;
using fixtures::changed_pixels;
using fixtures::difference;
using fixtures::pixel;
using fixtures::rest;
using fixtures::Rgb;
using fixtures::seen;
using fixtures::straight;
using fixtures::Studio;

class InkInEveryLook : public testing::TestWithParam<std::tuple<Style, Theme>> {};

TEST_P(InkInEveryLook, InkAddedPieceByPieceGivesThePictureOfInkAddedAtOnce) {
  Studio studio(400, 300);
  studio.view->set_style(std::get<0>(GetParam()));
  studio.view->set_theme(std::get<1>(GetParam()));
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  studio.view->set_camera({0.3, 0.7, 1.2, {}});
  Overlay overlay;
  overlay.strokes_visible = true;
  overlay.current_stroke = 4;
  std::array<double, 6> ink{};
  overlay.groove_ink = ink;
  for (std::size_t stroke = 0; stroke < 4; ++stroke) {
    for (int step = 0; step <= 7; ++step) {
      ink[stroke] = step / 8.0;
      studio.view->draw(400, 300, 1, overlay);
    }
  }
  EXPECT_GT(studio.view->statistics().partial_redraws, 20U);
  const Picture slowly = studio.context->read();

  Studio again(400, 300);
  again.view->set_style(std::get<0>(GetParam()));
  again.view->set_theme(std::get<1>(GetParam()));
  again.view->set_height_map(carved(rest()));
  again.view->set_strokes(kanji::centre_lines(rest()));
  again.view->set_camera({0.3, 0.7, 1.2, {}});
  EXPECT_EQ(changed_pixels(slowly, again.shoot(overlay), 6), 0);
}

TEST_P(InkInEveryLook, InkGrowsWithTheShareTraced) {
  Studio studio(400, 300);
  studio.view->set_style(std::get<0>(GetParam()));
  studio.view->set_theme(std::get<1>(GetParam()));
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  const Picture bare = studio.shoot(overlay);
  std::array<double, 6> ink{};
  overlay.groove_ink = ink;
  int last = 0;
  for (int step = 1; step <= 8; ++step) {
    ink[3] = step / 8.0;
    const int inked = changed_pixels(bare, studio.shoot(overlay), 18);
    EXPECT_GT(inked, last) << "at " << step << "/8";
    last = inked;
  }
  ink[3] = 0;
  EXPECT_EQ(changed_pixels(bare, studio.shoot(overlay), 0), 0);
}

INSTANTIATE_TEST_SUITE_P(View, InkInEveryLook,
                         testing::Combine(testing::Values(Style::wood, Style::slate),
                                          testing::Values(Theme::light, Theme::dark)));

TEST(Ink, InkFollowsTheStrokeFromItsStartByArcLength) {
  const auto lines = std::vector{straight({20, 54}, {90, 54})};
  Studio studio(500, 500);
  studio.view->set_height_map(carved(lines));
  studio.view->set_strokes(kanji::centre_lines(lines));
  Overlay overlay;
  const Picture bare = studio.shoot(overlay);
  const std::array<double, 1> ink{0.5};
  overlay.groove_ink = ink;
  const Picture half = studio.shoot(overlay);
  const auto inked = [&](double x) {
    const glm::dvec2 at = seen(studio, {x, 54}, -0.010);
    return difference(pixel(bare, at), pixel(half, at)) > 100;
  };
  EXPECT_TRUE(inked(24));
  EXPECT_TRUE(inked(50));
  EXPECT_FALSE(inked(62));
  EXPECT_FALSE(inked(86));
}

TEST(Ink, InkStaysInTheGroove) {
  Studio studio(500, 500);
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  const Picture bare = studio.shoot(overlay);
  const std::array<double, 6> ink{1, 1, 1, 1, 1, 1};
  overlay.groove_ink = ink;
  const Picture full = studio.shoot(overlay);
  const auto map = carved(rest());
  for (int row = 4; row < 252; row += 6) {
    for (int column = 4; column < 252; column += 6) {
      if (map.at(column, row) < 0.9999F) continue;
      const auto place = geometry::grid_to_tablet({column * 1.0, row * 1.0}, 256, {});
      const glm::dvec2 at = studio.view->project({place.x, place.y, 0}, 500, 500);
      EXPECT_LT(difference(pixel(bare, at), pixel(full, at)), 12) << column << ", " << row;
    }
  }
}

/// A plot's plateau lies lower than 1: its axes and its rim are ridges.
TEST(Ink, InkStaysInTheGrooveWhereThePlateauIsLower) {
  constexpr float kPlateau = 0.9F;
  const auto lines = std::vector{straight({20, 54}, {90, 54})};
  auto map = carved(lines);
  for (int row = 0; row < map.size(); ++row)
    for (int column = 0; column < map.size(); ++column) map.set(column, row, map.at(column, row) * kPlateau);
  Studio studio(500, 500);
  studio.view->set_height_map(map);
  studio.view->set_strokes(kanji::centre_lines(lines));
  Overlay overlay;
  const Picture bare = studio.shoot(overlay);
  const std::array<double, 1> ink{0.8};
  overlay.groove_ink = ink;
  const Picture inked = studio.shoot(overlay);
  const auto change = [&](geometry::GlyphPoint p, double z_m) {
    const glm::dvec2 at = seen(studio, p, z_m);
    return difference(pixel(bare, at), pixel(inked, at));
  };
  EXPECT_GT(change({50, 54}, -0.010), 100);
  for (const double beside : {10.0, 14.0, 18.0}) {
    EXPECT_LT(change({50, 54 - beside}, -0.002), 12) << beside;
    EXPECT_LT(change({50, 54 + beside}, -0.002), 12) << beside;
  }
}

TEST(Ink, OfTheCharacterBeforeNothingIsLeft) {
  const auto before = std::vector{straight({30, 15}, {30, 95}), straight({80, 15}, {80, 95})};
  const auto after = std::vector{straight({15, 54}, {95, 54})};
  Overlay overlay;
  const std::array<double, 2> full{1, 1};
  const std::array<double, 1> none{0};
  const std::array<double, 1> one{1};
  Studio studio(500, 500);
  studio.view->set_height_map(carved(before));
  studio.view->set_strokes(kanji::centre_lines(before));
  overlay.groove_ink = full;
  (void)studio.shoot(overlay);
  studio.view->set_height_map(carved(after));
  studio.view->set_strokes(kanji::centre_lines(after));
  overlay.groove_ink = none;
  (void)studio.shoot(overlay);
  overlay.groove_ink = one;
  const Picture picture = studio.shoot(overlay);

  Studio fresh(500, 500);
  fresh.view->set_height_map(carved(after));
  fresh.view->set_strokes(kanji::centre_lines(after));
  EXPECT_EQ(changed_pixels(fresh.shoot(overlay), picture, 6), 0);
}

TEST(Ink, TheCurrentStrokeIsVermilionAndFinishedStrokesAreNot) {
  const auto lines = std::vector{straight({20, 30}, {90, 30}), straight({20, 80}, {90, 80})};
  Studio studio(500, 500);
  studio.view->set_height_map(carved(lines));
  studio.view->set_strokes(kanji::centre_lines(lines));
  Overlay overlay;
  overlay.current_stroke = 2;
  const std::array<double, 2> ink{1, 1};
  overlay.groove_ink = ink;
  const Picture picture = studio.shoot(overlay);
  const Rgb finished = pixel(picture, seen(studio, {55, 30}, -0.01));
  const Rgb current = pixel(picture, seen(studio, {55, 80}, -0.01));
  EXPECT_GT(current.red, current.green + 60);
  EXPECT_LT(std::abs(finished.red - finished.green), 25);
}

}  // namespace
}  // namespace nazori::view
