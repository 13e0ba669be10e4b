// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/tablet_view.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::carved;
using fixtures::changed_pixels;
using fixtures::difference;
using fixtures::luminance;
using fixtures::pixel;
using fixtures::rest;
using fixtures::Rgb;
using fixtures::seen;
using fixtures::straight;
using fixtures::Studio;

TEST(TabletView, AnEmptyMapDrawsTheBackgroundOnly) {
  Studio studio(200, 160);
  studio.view->set_style(Style::classic);
  const Picture picture = studio.shoot();
  for (int y = 0; y < picture.height; y += 7)
    for (int x = 0; x < picture.width; x += 7) EXPECT_EQ(difference(pixel(picture, x, y), {0, 0, 255}), 0);
}

TEST(TabletView, TheCameraStaysOverASmallerTablet) {
  Studio studio(64, 64);
  const auto map = surface::HeightMap::create(16).value();
  studio.view->set_height_map(map, {0.2, 0.01});
  Camera camera = studio.view->camera();
  camera.pan = {0.09, -0.09};
  studio.view->set_camera(camera);
  EXPECT_EQ(studio.view->camera().pan.x, 0.09);
  studio.view->set_height_map(map, {0.1, 0.01});
  EXPECT_EQ(studio.view->camera().pan.x, 0.05);
  EXPECT_EQ(studio.view->camera().pan.y, -0.05);
}

TEST(TabletView, ClassicShowsEachHeightAsThatGrey) {
  auto map = surface::HeightMap::create(128).value();
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 128; ++column)
      map.set(column, row, 0.2F + 0.6F * static_cast<float>(column) / 127.0F);
  Studio studio(600, 600);
  studio.view->set_style(Style::classic);
  studio.view->set_height_map(map);
  const Picture picture = studio.shoot();
  for (int column = 10; column < 120; column += 11) {
    const double height = 0.2 + 0.6 * column / 127.0;
    const auto place = geometry::grid_to_tablet({static_cast<double>(column), 60.0}, 128, {});
    const glm::dvec2 at =
        studio.view->project({place.x, place.y, (height - 1) * 0.010}, studio.width, studio.height);
    const Rgb colour = pixel(picture, at);
    EXPECT_NEAR(colour.red, height * 255, 2) << "column " << column;
    EXPECT_EQ(colour.red, colour.green);
    EXPECT_EQ(colour.red, colour.blue);
  }
  EXPECT_EQ(difference(pixel(picture, 5, 5), {0, 0, 255}), 0);
}

TEST(TabletView, TheLightComesFromTheUpperLeftAndForTheLeftHandFromTheUpperRight) {
  const auto lines = std::vector{straight({54, 20}, {54, 90})};
  Studio studio(500, 500);
  studio.view->set_height_map(carved(lines));
  for (const Hand hand : {Hand::right, Hand::left}) {
    studio.view->set_hand(hand);
    const Picture picture = studio.shoot();
    const double left = luminance(pixel(picture, seen(studio, {51.8, 55})));
    const double right = luminance(pixel(picture, seen(studio, {56.2, 55})));
    if (hand == Hand::right)
      EXPECT_GT(right, left + 15);
    else
      EXPECT_GT(left, right + 15);
  }
}

TEST(TabletView, TheDarkThemeHasNoBrightPlateInIt) {
  Studio studio(320, 240);
  studio.view->set_height_map(carved(rest()));
  for (const Style style : {Style::wood, Style::slate}) {
    studio.view->set_style(style);
    studio.view->set_theme(Theme::dark);
    const Picture picture = studio.shoot();
    for (int y = 0; y < picture.height; y += 3)
      for (int x = 0; x < picture.width; x += 3) EXPECT_LT(luminance(pixel(picture, x, y)), 140);
  }
}

TEST(TabletView, NothingIsSentAgainWhileTracingAndOrbiting) {
  Studio studio(320, 240);
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  overlay.strokes_visible = true;
  overlay.cursor = Cursor{};
  std::array<double, 6> ink{};
  overlay.groove_ink = ink;
  (void)studio.shoot(overlay);
  const DrawStatistics before = studio.view->statistics();
  for (int frame = 0; frame < 40; ++frame) {
    ink[0] = frame / 40.0;
    overlay.cursor->proxy_m.x = 0.001 * frame;
    if (frame > 20) studio.view->set_camera({0.02 * frame, 0.4, 1, {}});
    studio.view->draw(320, 240, 1, overlay);
  }
  const DrawStatistics after = studio.view->statistics();
  EXPECT_EQ(after.pictures, before.pictures + 40);
  EXPECT_EQ(after.buffer_uploads, before.buffer_uploads);
  EXPECT_EQ(after.texture_uploads, before.texture_uploads);
}

TEST(TabletView, AStillPictureIsKeptAndOnlyTheCursorIsDrawn) {
  Studio studio(320, 240);
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  overlay.strokes_visible = true;
  (void)studio.shoot(overlay);
  const DrawStatistics before = studio.view->statistics();
  overlay.cursor = Cursor{};
  for (int frame = 0; frame < 10; ++frame) {
    overlay.cursor->proxy_m.y = 0.002 * frame;
    (void)studio.shoot(overlay);
  }
  EXPECT_EQ(studio.view->statistics().full_redraws, before.full_redraws);
  EXPECT_EQ(studio.view->statistics().partial_redraws, before.partial_redraws);
}

TEST(TabletView, OnlyTheChosenStrokeIsDrawnAndNoneChosenMeansAll) {
  const auto lines = std::vector{straight({20, 30}, {90, 30}), straight({20, 80}, {90, 80})};
  Studio studio(600, 600);
  studio.view->set_style(Style::classic);
  studio.view->set_height_map(carved(lines));
  studio.view->set_strokes(kanji::centre_lines(lines));
  const auto drawn = [&](int current, geometry::GlyphPoint p) {
    Overlay overlay;
    overlay.strokes_visible = true;
    overlay.numbers_visible = false;
    overlay.current_stroke = current;
    const Picture picture = studio.shoot(overlay);
    const Rgb colour = pixel(picture, seen(studio, p, 0.00008));
    return colour.red > 200 && colour.green < 90;
  };
  EXPECT_TRUE(drawn(0, {55, 30}) && drawn(0, {55, 80}));
  EXPECT_TRUE(drawn(1, {55, 30}));
  EXPECT_FALSE(drawn(1, {55, 80}));
  EXPECT_TRUE(drawn(2, {55, 80}));
  EXPECT_FALSE(drawn(2, {55, 30}));
  EXPECT_TRUE(drawn(7, {55, 30})) << "a number that no stroke has counts as none chosen";
}

TEST(TabletView, AnArrowheadPointsAlongItsStroke) {
  for (const Style style : {Style::classic, Style::wood}) {
    Studio studio(600, 600);
    studio.view->set_style(style);
    studio.view->set_height_map(surface::HeightMap::create(64).value());
    for (const double angle : {0.0, 0.8, 1.9, 3.3, 4.4, 5.6}) {
      const geometry::GlyphPoint way{std::cos(angle), std::sin(angle)};
      const geometry::GlyphPoint middle{54, 54};
      studio.view->set_strokes(
          kanji::centre_lines(std::vector{straight(middle - way * 30, middle + way * 30)}));
      Overlay overlay;
      overlay.strokes_visible = true;
      overlay.numbers_visible = false;
      overlay.arrows_visible = false;
      const Picture bare = studio.shoot(overlay);
      overlay.arrows_visible = true;
      const Picture with = studio.shoot(overlay);
      // The middle of what the arrowhead adds lies behind the tip, on the stroke; its two sides are even.
      const glm::dvec2 tip = seen(studio, middle + way * 30);
      const glm::dvec2 start = seen(studio, middle - way * 30);
      const glm::dvec2 forward = glm::normalize(tip - start);
      double behind = 0;
      double aside = 0;
      double spread = 0;
      int count = 0;
      for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 600; ++x) {
          if (difference(pixel(bare, x, y), pixel(with, x, y)) < 60) continue;
          const glm::dvec2 from_tip = glm::dvec2(x + 0.5, y + 0.5) - tip;
          behind += -glm::dot(from_tip, forward);
          const double across = from_tip.x * forward.y - from_tip.y * forward.x;
          aside += across;
          spread += std::abs(across);
          ++count;
        }
      }
      ASSERT_GT(count, 20);
      EXPECT_GT(behind / count, 3) << "angle " << angle;
      EXPECT_LT(behind / count, 20) << "angle " << angle;
      EXPECT_LT(std::abs(aside / count), 1.0) << "angle " << angle;
      EXPECT_GT(spread / count, 1.5) << "angle " << angle;
    }
  }
}

TEST(TabletView, TheCursorStandsAtTheProxyAndShowsTheDeviceWhereItDiffers) {
  Studio studio(500, 500);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  const Picture bare = studio.shoot();
  Overlay overlay;
  overlay.cursor = Cursor{};
  overlay.cursor->touching = true;
  const Picture together = studio.shoot(overlay);
  overlay.cursor->device_m = {-0.03, -0.03, -0.004};
  const Picture apart = studio.shoot(overlay);
  const glm::dvec2 proxy = studio.view->project({0, 0, 0}, 500, 500);
  const glm::dvec2 device = studio.view->project({-0.03, -0.03, -0.004}, 500, 500);
  const auto near = [&](const Picture& picture, glm::dvec2 at) {
    int count = 0;
    for (int dy = -6; dy <= 6; ++dy)
      for (int dx = -6; dx <= 6; ++dx) {
        const glm::dvec2 p = at + glm::dvec2(dx, dy);
        count += difference(pixel(bare, p), pixel(picture, p)) > 20 ? 1 : 0;
      }
    return count;
  };
  EXPECT_GT(near(together, proxy), 20);
  EXPECT_EQ(near(together, device), 0);
  EXPECT_GT(near(apart, device), 20);
}

TEST(TabletView, TheClassicCursorIsAGreenConeOfAboutTwentyPixels) {
  Studio studio(600, 600);
  studio.view->set_style(Style::classic);
  studio.view->set_height_map(surface::HeightMap::create(64).value());
  Overlay overlay;
  overlay.cursor = Cursor{};
  const Picture picture = studio.shoot(overlay);
  int left = 600;
  int right = 0;
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < 600; ++x) {
      const Rgb c = pixel(picture, x, y);
      if (c.green > 100 && c.red < 60 && c.blue < 60) {
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
  }
  EXPECT_GE(right - left, 15);
  EXPECT_LE(right - left, 30);
}

TEST(TabletView, DrawsIntoTheFramebufferThatIsBoundWhateverTheStateOfTheContext) {
  Studio studio(300, 200);
  studio.view->set_height_map(carved(rest()));
  studio.view->set_strokes(kanji::centre_lines(rest()));
  Overlay overlay;
  overlay.strokes_visible = true;
  overlay.cursor = Cursor{};
  const Picture clean = studio.shoot(overlay);

  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 3, 3);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_NEVER, 0, 0);
  glDepthFunc(GL_NEVER);
  glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  studio.view->set_strokes(kanji::centre_lines(rest()));
  const Picture dirty = studio.shoot(overlay);
  EXPECT_EQ(changed_pixels(clean, dirty, 0), 0);

  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  EXPECT_NE(before, 0);
  studio.view->draw(300, 200, 1, overlay);
  GLint after = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &after);
  EXPECT_EQ(after, before);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(TabletView, APictureDrawnQuicklyInMotionAsksForOneMoreAndThenIsTheStillPicture) {
  Studio studio(300, 200);
  studio.view->set_height_map(carved(rest()));
  studio.view->set_camera({0.3, 0.5, 1, {}});
  const Picture still = studio.shoot();
  EXPECT_FALSE(studio.view->wants_redraw());
  for (const double azimuth : {0.1, 0.2, 0.3}) {
    studio.view->set_camera({azimuth, 0.5, 1, {}});
    (void)studio.shoot();
  }
  EXPECT_TRUE(studio.view->wants_redraw());
  const Picture settled = studio.shoot();
  EXPECT_FALSE(studio.view->wants_redraw());
  EXPECT_EQ(changed_pixels(still, settled, 0), 0);
}

TEST(TabletView, TheMapIsSeenAtItsOwnPlaceInEveryTurn) {
  // A pit in one corner is dark there and nowhere else.
  auto map = surface::HeightMap::create(128).value();
  for (int row = 12; row < 28; ++row)
    for (int column = 12; column < 28; ++column) map.set(column, row, 0);
  Studio studio(400, 400);
  studio.view->set_style(Style::classic);
  studio.view->set_height_map(map);
  for (const double azimuth : {0.0, 1.0, 2.5, -2.0}) {
    studio.view->set_camera({azimuth, 0.2, 0.8, {}});
    const Picture picture = studio.shoot();
    const auto corner = [&](double column, double row, double z) {
      const auto place = geometry::grid_to_tablet({column, row}, 128, {});
      return pixel(picture, studio.view->project({place.x, place.y, z}, 400, 400));
    };
    EXPECT_LT(luminance(corner(20, 20, -0.01)), 10);
    EXPECT_GT(luminance(corner(107, 20, 0)), 250);
    EXPECT_GT(luminance(corner(20, 107, 0)), 250);
  }
}

}  // namespace
}  // namespace nazori::view
