// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "nazori/view/point_under.h"
#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::Studio;

TEST(Camera, IsHeldWithinItsLimits) {
  Camera wild{40.0, 3.0, 1e9, {5, -5}};
  const Camera held = within_limits(wild);
  EXPECT_NEAR(std::remainder(held.azimuth - 40.0, 2 * std::numbers::pi), 0, 1e-9);
  EXPECT_LE(std::abs(held.azimuth), std::numbers::pi);
  EXPECT_EQ(held.tilt, Camera::kMaxTilt);
  EXPECT_EQ(held.zoom, Camera::kMaxZoom);
  EXPECT_EQ(held.pan, (geometry::TabletPoint{0.05, -0.05}));
  EXPECT_EQ(within_limits({0, -1, 0.001, {}}).tilt, 0);
  EXPECT_EQ(within_limits({0, -1, 0.001, {}}).zoom, Camera::kMinZoom);
}

TEST(Camera, NumbersThatAreNotFiniteBecomeTheDefault) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const Camera held = within_limits({nan, infinite, nan, {nan, infinite}});
  EXPECT_EQ(held.azimuth, 0);
  EXPECT_EQ(held.tilt, 0);
  EXPECT_EQ(held.zoom, 1);
  EXPECT_EQ(held.pan, geometry::TabletPoint{});
}

TEST(Camera, TurnsTheShorterWayBetweenTwoPlaces) {
  const Camera from{3.0, 0, 1, {}};
  const Camera to{-3.0, 0.4, 4, {0.02, 0}};
  const Camera half = between(from, to, 0.5);
  EXPECT_NEAR(std::abs(half.azimuth), std::numbers::pi, 1e-9);
  EXPECT_NEAR(half.zoom, 2, 1e-12);
  EXPECT_NEAR(half.tilt, 0.2, 1e-12);
  EXPECT_NEAR(half.pan.x, 0.01, 1e-12);
}

class EveryStyle : public testing::TestWithParam<Style> {};

TEST_P(EveryStyle, PickIsTheInverseOfProject) {
  const Studio studio(640, 400);
  studio.view->set_style(GetParam());
  for (const Camera& camera : {Camera{}, Camera{0.7, 0.9, 2.5, {0.01, -0.02}}, Camera{-2.5, 1.4, 0.3, {}}}) {
    studio.view->set_camera(camera);
    for (const double x : {-0.05, -0.013, 0.0, 0.044}) {
      for (const double y : {-0.05, 0.021, 0.05}) {
        const glm::dvec2 seen = studio.view->project({x, y, 0}, 640, 400);
        const auto picked = studio.view->pick(seen, 640, 400);
        ASSERT_TRUE(picked.has_value());
        EXPECT_NEAR(picked->x, x, 1e-9);
        EXPECT_NEAR(picked->y, y, 1e-9);
      }
    }
  }
}

TEST_P(EveryStyle, ADragMovesThePointUnderThePointerWithIt) {
  const Studio studio(640, 400);
  studio.view->set_style(GetParam());
  studio.view->set_camera({0.4, 0.6, 1.5, {}});
  const auto grabbed = studio.view->pick({300, 210}, 640, 400);
  studio.view->set_camera(panned(studio.view->camera(), GetParam(), {}, {300, 210}, {330, 180}, 640, 400));
  const auto found = studio.view->pick({330, 180}, 640, 400);
  ASSERT_TRUE(grabbed && found);
  EXPECT_NEAR(found->x, grabbed->x, 1e-9);
  EXPECT_NEAR(found->y, grabbed->y, 1e-9);
}

TEST_P(EveryStyle, ZoomingKeepsThePointUnderThePointer) {
  const Studio studio(640, 400);
  studio.view->set_style(GetParam());
  studio.view->set_camera({-0.4, 0.3, 1, {}});
  const auto before = studio.view->pick({350, 230}, 640, 400);
  studio.view->set_camera(zoomed(studio.view->camera(), GetParam(), {}, 1.8, {350, 230}, 640, 400));
  const auto after = studio.view->pick({350, 230}, 640, 400);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(studio.view->camera().zoom, 1.8, 1e-12);
  EXPECT_NEAR(after->x, before->x, 1e-9);
  EXPECT_NEAR(after->y, before->y, 1e-9);
}

TEST_P(EveryStyle, AMoveWithoutATabletUnderItsEndsMovesNothingAndZoomsInTheMiddle) {
  const Camera flat{0.1, Camera::kMaxTilt, 0.2, {0.01, 0.02}};
  const glm::dvec2 sky(320, 0), ground(320, 390);
  for (const auto& [from, to] : {std::pair(sky, ground), {ground, sky}})
    EXPECT_EQ(panned(flat, GetParam(), {}, from, to, 640, 400).pan, flat.pan);
  const Camera nearer = zoomed(flat, GetParam(), {}, 1.5, sky, 640, 400);
  EXPECT_EQ(nearer.pan, flat.pan);
  EXPECT_NEAR(nearer.zoom, 0.3, 1e-12);
  const Camera smallest = zoomed(flat, GetParam(), {}, 0.1, ground, 640, 400);
  EXPECT_EQ(smallest.zoom, 0.2);
  EXPECT_NEAR(smallest.pan.x, 0.01, 1e-12) << "it stays where it is";
  EXPECT_NEAR(smallest.pan.y, 0.02, 1e-12);
}

TEST_P(EveryStyle, ASightLineOverTheHorizonPicksNothing) {
  const Studio studio(640, 400);
  studio.view->set_style(GetParam());
  studio.view->set_camera({0, Camera::kMaxTilt, 0.2, {}});
  EXPECT_FALSE(studio.view->pick({320, 0}, 640, 400).has_value());
}

TEST_P(EveryStyle, FromAboveRightIsRightAndUpIsUp) {
  const Studio studio(640, 400);
  studio.view->set_style(GetParam());
  const glm::dvec2 middle = studio.view->project({0, 0, 0}, 640, 400);
  EXPECT_GT(studio.view->project({0.04, 0, 0}, 640, 400).x, middle.x + 50);
  EXPECT_LT(studio.view->project({0, 0.04, 0}, 640, 400).y, middle.y - 50);
}

INSTANTIATE_TEST_SUITE_P(View, EveryStyle, testing::Values(Style::classic, Style::wood, Style::slate));

/// The pixel at which the 2005 program showed a vertex, worked out step by step from its transforms:
/// translate(-1, -1, -0.5), scale(2/124), eye at (0, 0, 1/tan 20 + 1), 40 degrees, 600 x 600.
glm::dvec2 pixel_of_2005(double column, double row, double level) {
  const double near = 1 / std::tan(20 * std::numbers::pi / 180);
  const double x = column * 2 / 124 - 1;
  const double y = (128 - row) * 2 / 124 - 1;
  const double z = level * 0.05 * 2 / 124 - 0.5;
  const double away = near + 1 - z;
  return {300 + x * near / away * 300, 300 - y * near / away * 300};
}

TEST(ClassicCamera, ShowsEveryVertexWhere2005ShowedIt) {
  const Studio studio(600, 600);
  studio.view->set_style(Style::classic);
  const geometry::TabletShape shape;
  for (const double column : {0.0, 31.0, 64.0, 127.0}) {
    for (const double row : {0.0, 50.0, 127.0}) {
      for (const double level : {0.0, 100.0, 255.0}) {
        const auto place = geometry::grid_to_tablet({column, row}, 128, shape);
        const glm::dvec2 seen =
            studio.view->project({place.x, place.y, (level / 255 - 1) * shape.depth_m}, 600, 600);
        const glm::dvec2 then = pixel_of_2005(column, row, level);
        EXPECT_NEAR(seen.x, then.x, 1e-6);
        EXPECT_NEAR(seen.y, then.y, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace nazori::view
