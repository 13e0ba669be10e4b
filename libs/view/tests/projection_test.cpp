// SPDX-License-Identifier: Apache-2.0
#include "../src/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "nazori/view/point_under.h"

namespace nazori::view {
namespace {

const geometry::TabletShape kShape{0.2, 0.02};

TEST(Projection, FromAboveTheBoardFillsThePictureButForAMargin) {
  // 87 hundredths of the smaller side, whichever that is; the rim is a sixteenth on each side.
  for (const auto& [width, height] : {std::pair{800, 600}, {600, 800}, {500, 500}}) {
    const Projection view = make_projection({}, Style::wood, kShape, width, height);
    const double half = 0.2 * (0.5 + 0.0625);
    const double reach = std::min(width, height) / 2.0 * 0.87;
    EXPECT_NEAR(view.pixel({half, 0, 0}).x, width / 2.0 + reach, 1e-9);
    EXPECT_NEAR(view.pixel({0, half, 0}).y, height / 2.0 - reach, 1e-9);
    const Projection twice = make_projection({0, 0, 2, {}}, Style::wood, kShape, width, height);
    EXPECT_NEAR(twice.pixel({half, 0, 0}).x, width / 2.0 + 2 * reach, 1e-9);
  }
}

TEST(Projection, TheEyeStandsWhereTurnAndTiltPutIt) {
  const double away = 0.2 * 0.5625 / (0.87 * std::tan(13 * std::numbers::pi / 180));
  for (const double azimuth : {0.0, 0.7, -2.0}) {
    for (const double tilt : {0.0, 0.5, 1.4}) {
      const Projection view =
          make_projection({azimuth, tilt, 3, {0.03, -0.02}}, Style::slate, kShape, 300, 200);
      // Tilted towards the learner's edge, and turned with the tablet's normal.
      EXPECT_NEAR(view.eye_m.x, 0.03 + away * std::sin(tilt) * std::sin(azimuth), 1e-9);
      EXPECT_NEAR(view.eye_m.y, -0.02 - away * std::sin(tilt) * std::cos(azimuth), 1e-9);
      EXPECT_NEAR(view.eye_m.z, away * std::cos(tilt), 1e-9);
      EXPECT_NEAR(view.pixel({0.03, -0.02, 0}).x, 150, 1e-9) << "the pan is in the middle";
      EXPECT_NEAR(view.pixel({0.03, -0.02, 0}).y, 100, 1e-9);
    }
  }
}

TEST(Projection, AllThatCanBeDrawnLiesBetweenItsNearAndFarPlane) {
  for (const Style style : {Style::classic, Style::wood}) {
    for (const geometry::TabletShape& shape : {kShape, geometry::TabletShape{0.1, 0.01}, {0.1, 0.1}}) {
      for (const double azimuth : {0.0, 0.8, 2.4})
        for (const double tilt : {0.0, 0.7, 1.4})
          for (const double pan : {-0.5, 0.0, 0.5}) {
            if (style == Style::classic && pan != 0) continue;
            const Camera camera{azimuth, tilt, 1, {pan * shape.width_m, -pan * shape.width_m}};
            const Projection view = make_projection(camera, style, shape, 400, 300);
            const double half = shape.width_m * (style == Style::classic ? 0.5 : 0.5625);
            for (const double x : {-half, half})
              for (const double y : {-half, half})
                for (const double z : {0.0, -shape.depth_m}) {
                  const glm::dvec4 clip = view.clip_from_tablet * glm::dvec4(x, y, z, 1);
                  if (clip.w <= 0) continue;  // behind the eye of a close camera
                  EXPECT_LE(clip.z / clip.w, 1) << azimuth << ' ' << tilt << ' ' << pan;
                  if (pan == 0 && shape.depth_m < 0.05) {
                    EXPECT_GE(clip.z / clip.w, -1) << azimuth << ' ' << tilt;
                  }
                }
          }
    }
  }
}

TEST(Projection, NearerIsLessDeep) {
  for (const Style style : {Style::classic, Style::wood}) {
    const Projection view = make_projection({0.3, 0.6, 1, {}}, style, kShape, 400, 300);
    double before = 1;
    for (const double z : {-0.02, -0.01, 0.0, 0.01}) {
      const glm::dvec4 clip = view.clip_from_tablet * glm::dvec4(0, 0, z, 1);
      EXPECT_LT(clip.z / clip.w, before);
      before = clip.z / clip.w;
    }
  }
}

TEST(Projection, PixelsPerMetreAreThoseOfAShortStepAside) {
  for (const Style style : {Style::classic, Style::wood}) {
    for (const double azimuth : {0.0, 1.1}) {
      const Projection view = make_projection({azimuth, 0.9, 1.7, {0.01, 0}}, style, kShape, 640, 400);
      const glm::dvec3 aside(std::cos(azimuth), std::sin(azimuth), 0);
      for (const glm::dvec3 at :
           {glm::dvec3(0), glm::dvec3(0.05, -0.03, -0.01), glm::dvec3(-0.08, 0.09, 0)}) {
        const double pixels = glm::distance(view.pixel(at), view.pixel(at + aside * 1e-4));
        EXPECT_NEAR(view.pixels_per_metre(at) * 1e-4, pixels, 1e-8);
      }
    }
  }
}

TEST(Projection, ALineOfSightMeetsEveryPlaneWhereItsPixelSaysSo) {
  const Projection view = make_projection({0.4, 0.8, 1.3, {}}, Style::wood, kShape, 640, 400);
  for (const double z : {-0.02, 0.0, 0.05}) {
    const auto met = view.on_plane({250, 260}, z);
    ASSERT_TRUE(met);
    const glm::dvec2 seen = view.pixel({met->x, met->y, z});
    EXPECT_NEAR(seen.x, 250, 1e-6);
    EXPECT_NEAR(seen.y, 260, 1e-6);
  }
  EXPECT_FALSE(view.on_plane({250, 260}, 5)) << "a plane behind the eye";
}

TEST(Projection, OfNoPixelsIsThatOfOne) {
  const Projection view = make_projection({}, Style::wood, kShape, 0, -3);
  EXPECT_EQ(view.width, 1);
  EXPECT_EQ(view.height, 1);
}

TEST(PointUnder, IsTheInverseOfWhereAPointIsSeenWithinTheLimitsOfTheCamera) {
  const Camera wild{0.3, 9, 1.2, {5, 0}};
  const Projection view = make_projection(within_limits(wild, kShape), Style::wood, kShape, 640, 400);
  const glm::dvec2 seen = view.pixel({0.09, 0.01, 0});
  const auto found = point_under(wild, Style::wood, kShape, seen, 640, 400);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 0.09, 1e-9);
  EXPECT_NEAR(found->y, 0.01, 1e-9);
  EXPECT_FALSE(point_under({}, Style::wood, kShape, {0, 0}, 0, 400));
  EXPECT_FALSE(point_under({}, Style::wood, kShape, {0, 0}, 640, 0));
  EXPECT_TRUE(point_under({}, Style::wood, kShape, {0, 0}, 1, 1));
}

}  // namespace
}  // namespace nazori::view
