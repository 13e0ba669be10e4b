// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::changed_pixels;
using fixtures::difference;
using fixtures::pixel;
using fixtures::Rgb;
using fixtures::seen;
using fixtures::Studio;

surface::HeightMap blank() { return surface::HeightMap::create(64).value(); }

InkedStroke level(double glyph_y, Verdict verdict, double half_width_m = 0.002) {
  InkedStroke stroke;
  stroke.verdict = verdict;
  for (const double x : {30.0, 50.0, 80.0})
    stroke.points.push_back({geometry::glyph_to_tablet({x, glyph_y}, {})});
  stroke.half_width_m = half_width_m;
  return stroke;
}

class WritingInEveryLook : public testing::TestWithParam<std::tuple<Style, Theme>> {
 protected:
  WritingInEveryLook() : studio(500, 500) {
    studio.view->set_style(std::get<0>(GetParam()));
    studio.view->set_theme(std::get<1>(GetParam()));
    studio.view->set_height_map(blank());
  }
  Studio studio;
};

TEST_P(WritingInEveryLook, LiesWhereItWasWrittenAndNowhereElse) {
  const Picture bare = studio.shoot();
  const std::vector writing{level(54, Verdict::none)};
  Overlay overlay;
  overlay.writing = writing;
  const Picture written = studio.shoot(overlay);
  EXPECT_GT(difference(pixel(bare, seen(studio, {60, 54})), pixel(written, seen(studio, {60, 54}))), 100);
  EXPECT_EQ(difference(pixel(bare, seen(studio, {60, 60})), pixel(written, seen(studio, {60, 60}))), 0);
  EXPECT_EQ(difference(pixel(bare, seen(studio, {20, 54})), pixel(written, seen(studio, {20, 54}))), 0);
  EXPECT_EQ(changed_pixels(bare, studio.shoot(), 0), 0) << "it leaves nothing behind";
}

TEST_P(WritingInEveryLook, EveryVerdictIsSeenAgainstTheTabletEvenWithoutColour) {
  const Picture bare = studio.shoot();
  for (const auto verdict :
       {Verdict::none, Verdict::right, Verdict::nearly, Verdict::wrong, Verdict::shown}) {
    const std::vector writing{level(54, verdict)};
    Overlay overlay;
    overlay.writing = writing;
    const Picture written = studio.shoot(overlay);
    const auto linear = [](Rgb c) {
      const auto channel = [](int v) {
        const double s = v / 255.0;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
      };
      return 0.2126 * channel(c.red) + 0.7152 * channel(c.green) + 0.0722 * channel(c.blue) + 0.05;
    };
    double a = linear(pixel(bare, seen(studio, {60, 54})));
    double b = linear(pixel(written, seen(studio, {60, 54})));
    if (a < b) std::swap(a, b);
    EXPECT_GE(a / b, 3.0) << static_cast<int>(verdict);
  }
}

TEST_P(WritingInEveryLook, TheSignsOfTheVerdictsDifferInShape) {
  std::vector<Picture> pictures;
  for (const auto verdict : {Verdict::nearly, Verdict::wrong}) {
    const std::vector writing{level(54, verdict)};
    Overlay overlay;
    overlay.writing = writing;
    pictures.push_back(studio.shoot(overlay));
    ASSERT_EQ(studio.view->signs().size(), 1U);
    EXPECT_EQ(studio.view->signs()[0].verdict, verdict);
  }
  const SignPlace sign = studio.view->signs()[0];
  // Which pixels of the disc are ground distinguishes the shapes whatever their colour.
  const auto mask = [&](const Picture& picture) {
    const Rgb ground = pixel(picture, sign.pixel + glm::dvec2(-sign.radius * 0.72, 0));
    std::vector<bool> bits;
    for (int y = -6; y <= 6; ++y)
      for (int x = -6; x <= 6; ++x)
        bits.push_back(difference(ground, pixel(picture, sign.pixel + glm::dvec2(x, y))) > 120);
    return bits;
  };
  int differ = 0;
  const auto one = mask(pictures[0]);
  const auto other = mask(pictures[1]);
  for (std::size_t i = 0; i < one.size(); ++i) differ += one[i] != other[i] ? 1 : 0;
  EXPECT_GT(differ, 12);
}

TEST_P(WritingInEveryLook, WhatIsRightIsPlainInkWithoutASign) {
  const std::vector plain{level(54, Verdict::none)};
  const std::vector right{level(54, Verdict::right)};
  Overlay overlay;
  overlay.writing = plain;
  const Picture written = studio.shoot(overlay);
  overlay.writing = right;
  EXPECT_EQ(changed_pixels(written, studio.shoot(overlay), 0), 0);
  EXPECT_TRUE(studio.view->signs().empty());
}

TEST_P(WritingInEveryLook, ACrossDividesTheTabletInDashesAndLeavesNothingBehind) {
  const Picture bare = studio.shoot();
  Overlay overlay;
  overlay.cross = WritingCross::halves;
  const Picture halves = studio.shoot(overlay);
  const auto marked_on = [&](const Picture& picture, bool across, double at) {
    int marked = 0;
    for (double x = 10; x <= 99; x += 0.25) {
      const auto place = across ? geometry::GlyphPoint{x, at} : geometry::GlyphPoint{at, x};
      marked +=
          difference(pixel(bare, seen(studio, place)), pixel(picture, seen(studio, place))) > 20 ? 1 : 0;
    }
    return marked;
  };
  for (const bool across : {true, false}) {
    EXPECT_GT(marked_on(halves, across, 54.5), 100) << "a line through the middle";
    EXPECT_LT(marked_on(halves, across, 54.5), 300) << "with gaps";
    EXPECT_LT(marked_on(halves, across, 30), 15) << "and nothing beside it";
  }
  overlay.cross = WritingCross::quarters;
  const Picture quarters = studio.shoot(overlay);
  EXPECT_GT(changed_pixels(halves, quarters), changed_pixels(bare, halves)) << "a square around it";
  EXPECT_EQ(changed_pixels(bare, studio.shoot(), 0), 0);
}

INSTANTIATE_TEST_SUITE_P(View, WritingInEveryLook,
                         testing::Combine(testing::Values(Style::classic, Style::wood, Style::slate),
                                          testing::Values(Theme::light, Theme::dark)));

TEST(Writing, IsAsWideAsItsLineOrAsItWasPressed) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  const Picture bare = studio.shoot();
  const auto inked = [&](double half_width_m) {
    const std::vector writing{level(54, Verdict::none, half_width_m)};
    Overlay overlay;
    overlay.writing = writing;
    return changed_pixels(bare, studio.shoot(overlay));
  };
  const double thin = inked(0.0005);
  const double wide = inked(0.002);
  EXPECT_NEAR(wide / thin, 4.0, 0.8);
  const auto pressed = [&](double pressure) {
    InkedStroke stroke = level(54, Verdict::none);
    stroke.half_width_m.reset();
    for (auto& point : stroke.points) point.pressure = pressure;
    const std::vector writing{stroke};
    Overlay overlay;
    overlay.writing = writing;
    return changed_pixels(bare, studio.shoot(overlay));
  };
  EXPECT_NEAR(pressed(1), wide, 0.02 * wide) << "2 mm";
  EXPECT_LT(pressed(0), thin) << "0.4 mm";
}

TEST(Writing, SignsOfStrokesThatStartTogetherDoNotHideEachOther) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  const std::vector writing{level(54, Verdict::wrong), level(54.5, Verdict::wrong),
                            level(53.5, Verdict::nearly)};
  Overlay overlay;
  overlay.writing = writing;
  (void)studio.shoot(overlay);
  const auto signs = studio.view->signs();
  ASSERT_EQ(signs.size(), 3U);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b)
      EXPECT_GE(glm::distance(signs[a].pixel, signs[b].pixel), 2 * signs[a].radius - 1e-6);
}

TEST(Writing, ASignStandsBeforeTheStartOnTheLineOfItsStroke) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  InkedStroke slanted = level(54, Verdict::wrong, 0.001);
  slanted.points = {{{0, 0}}, {{0.02, 0.01}}, {{0.03, -0.04}}};
  InkedStroke point = level(54, Verdict::nearly, 0.001);
  point.points = {{{-0.03, 0.03}}};
  InkedStroke none = level(54, Verdict::wrong);
  none.points.clear();
  const std::vector writing{level(20, Verdict::right), slanted, none, point, level(100, Verdict::shown)};
  Overlay overlay;
  overlay.writing = writing;
  for (const double scale : {1.0, 2.0}) {
    overlay.text_scale = scale == 1.0 ? 1.5 : 1.0;
    (void)studio.shoot(overlay, scale);
    const auto signs = studio.view->signs();
    ASSERT_EQ(signs.size(), 2U) << "only what could be better has a sign";
    const double radius = 10 * scale * overlay.text_scale;
    const glm::dvec2 start = studio.view->project({0, 0, 0}, 500, 500);
    const glm::dvec2 end = studio.view->project({0.03, -0.04, 0}, 500, 500);
    EXPECT_EQ(signs[0].stroke, 1);
    EXPECT_EQ(signs[0].verdict, Verdict::wrong);
    EXPECT_EQ(signs[0].radius, radius);
    EXPECT_NEAR(glm::distance(signs[0].pixel, start + glm::normalize(start - end) * (radius + 3)), 0, 1e-6);
    // A point has no direction: its sign stands to the upper left of it.
    EXPECT_EQ(signs[1].stroke, 3);
    const glm::dvec2 at = studio.view->project({-0.03, 0.03, 0}, 500, 500);
    EXPECT_NEAR(glm::distance(signs[1].pixel, at - glm::dvec2(0.7, 0.7) * (radius + 3)), 0, 1e-6);
  }
  overlay.text_scale = 9;
  (void)studio.shoot(overlay);
  EXPECT_EQ(studio.view->signs()[0].radius, 40);
  (void)studio.shoot();
  EXPECT_TRUE(studio.view->signs().empty());
}

TEST(Writing, SignsStayInThePictureAndStepAsideByThreeQuartersOfTheirRadius) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  const std::vector together{level(54, Verdict::nearly), level(54, Verdict::wrong)};
  Overlay overlay;
  overlay.writing = together;
  (void)studio.shoot(overlay);
  ASSERT_EQ(studio.view->signs().size(), 2U);
  const glm::dvec2 apart = studio.view->signs()[1].pixel - studio.view->signs()[0].pixel;
  EXPECT_NEAR(apart.x, 0, 1e-6);
  EXPECT_NEAR(std::abs(apart.y), 3 * 7.5, 1e-6) << "two steps are not enough";
  // A stroke that starts at the border of the picture.
  const std::vector writing{level(54, Verdict::wrong)};
  overlay.writing = writing;
  studio.view->set_camera({0, 0, 3, {0.01, 0}});
  (void)studio.shoot(overlay);
  EXPECT_EQ(studio.view->signs()[0].pixel.x, 10);
  studio.view->set_camera({0, 0, 3, {-0.049, 0.049}});
  (void)studio.shoot(overlay);
  EXPECT_EQ(studio.view->signs()[0].pixel.y, 490);
}

TEST(Writing, ASignHasItsColourOnItsGroundAndARing) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  for (const auto verdict : {Verdict::nearly, Verdict::wrong}) {
    const std::vector writing{level(54, verdict)};
    Overlay overlay;
    overlay.writing = writing;
    overlay.text_scale = 2;
    const Picture picture = studio.shoot(overlay, 2);
    const SignPlace sign = studio.view->signs()[0];
    const auto at = [&](double x, double y) {
      return pixel(picture, sign.pixel + glm::dvec2(x, y) * sign.radius);
    };
    const Rgb ground = at(0.7, 0);
    EXPECT_LT(difference(ground, {0xFF, 0xFD, 0xF8}), 8);
    const Rgb ink = pixel(picture, seen(studio, {60, 54}));
    EXPECT_LT(difference(at(0, 0.975), ink), 60) << "the ring has the colour of the writing";
    const auto marked = [&](double x, double y) { return difference(at(x, y), ink) < 60; };
    // Places on the exclamation mark and the cross.
    EXPECT_EQ(marked(0, -0.4), verdict == Verdict::nearly);
    EXPECT_EQ(marked(0, 0.48), verdict == Verdict::nearly);
    EXPECT_EQ(marked(-0.3, -0.3), verdict == Verdict::wrong);
    EXPECT_EQ(marked(0.3, 0.3), verdict == Verdict::wrong);
  }
}

TEST(Writing, IsAsOpaqueAsToldAndTapersFromPointToPoint) {
  Studio studio(500, 500);
  studio.view->set_height_map(blank());
  const Picture bare = studio.shoot();
  Overlay overlay;
  std::vector writing{level(54, Verdict::none)};
  overlay.writing = writing;
  const glm::dvec2 at = seen(studio, {60, 54});
  const double full = fixtures::luminance(pixel(studio.shoot(overlay), at));
  writing[0].opacity = 0.5;
  const double half = fixtures::luminance(pixel(studio.shoot(overlay), at));
  EXPECT_NEAR(half, (full + fixtures::luminance(pixel(bare, at))) / 2, 3);
  // From no pressure to full pressure, which is from 0.4 to 2 mm: at the middle it is twice 1.2 mm wide.
  writing[0].opacity = 1;
  writing[0].half_width_m.reset();
  writing[0].points = {{geometry::glyph_to_tablet({30, 54}, {}), {}, 0.0},
                       {geometry::glyph_to_tablet({80, 54}, {}), {}, 1.0}};
  const Picture wedge = studio.shoot(overlay);
  const auto width_m = [&](double x) {
    double sum = 0;
    for (double y = 45; y < 63; y += 0.02) {
      const glm::dvec2 p = seen(studio, {x, y});
      sum += difference(pixel(bare, p), pixel(wedge, p)) > 150 ? 0.02 : 0;
    }
    return sum * 0.1 / 109;
  };
  EXPECT_NEAR(width_m(35), 2 * 0.00056, 0.0004);
  EXPECT_NEAR(width_m(55), 2 * 0.0012, 0.0004);
  EXPECT_NEAR(width_m(75), 2 * 0.00184, 0.0004);
  // A point alone is a dot.
  writing[0].points = {{geometry::glyph_to_tablet({55, 54}, {}), {}, 1.0}};
  const Picture dot = studio.shoot(overlay);
  EXPECT_GT(difference(pixel(bare, seen(studio, {55, 54})), pixel(dot, seen(studio, {55, 54}))), 100);
  EXPECT_GT(difference(pixel(bare, seen(studio, {56.5, 54})), pixel(dot, seen(studio, {56.5, 54}))), 100);
  EXPECT_EQ(difference(pixel(bare, seen(studio, {58, 54})), pixel(dot, seen(studio, {58, 54}))), 0);
}

TEST(Writing, IsSentToTheGraphicsOnceWhileItStaysTheSame) {
  Studio studio(300, 300);
  studio.view->set_height_map(blank());
  const std::vector writing{level(54, Verdict::none)};
  Overlay overlay;
  overlay.writing = writing;
  (void)studio.shoot(overlay);
  const auto before = studio.view->statistics();
  (void)studio.shoot(overlay);
  EXPECT_EQ(studio.view->statistics().buffer_uploads, before.buffer_uploads);
  EXPECT_EQ(studio.view->statistics().full_redraws, before.full_redraws);
}

}  // namespace
}  // namespace nazori::view
