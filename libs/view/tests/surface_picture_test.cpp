// SPDX-License-Identifier: Apache-2.0
#include "../src/surface_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "../src/exposure.h"
#include "../src/material.h"

namespace nazori::view {
namespace {

// Two fifths of the light come from the sky, three from the lamp. Shadows are those of grooves 0.55 times as
// deep, and no further away than 32 of 511 parts of the tablet the sky is shut out.
constexpr double kSky = 0.4;
constexpr double kKey = 0.6;
constexpr double kShaded = 0.55;
constexpr int kSamples = 512;

surface::HeightMap map_of(auto height) {
  surface::HeightMap map = surface::HeightMap::create(128).value();
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 128; ++column)
      map.set(column, row, static_cast<float>(height(column / 127.0, row / 127.0)));
  return map;
}

double linear(int level) { return linear_from_srgb({static_cast<float>(level) / 255, 0, 0}).x; }

/// A picture and its values at points of the square, 0..1 in each direction.
struct Lit {
  SurfacePicture picture;
  [[nodiscard]] std::size_t texel(double x, double y) const {
    const auto column = static_cast<std::size_t>(std::lround(x * (kSamples - 1)) + picture.rim);
    const auto row = static_cast<std::size_t>(std::lround(y * (kSamples - 1)) + picture.rim);
    return row * static_cast<std::size_t>(picture.size) + column;
  }
  [[nodiscard]] double light(double x, double y) const {
    return linear(picture.rgba[texel(x, y) * 4 + 3]) * 1.6;
  }
};

Lit lit(const surface::HeightMap& map, double depth_m, const PlainFace& face) {
  return {lit_picture(map, {0.1, depth_m}, face)};
}
Lit lit(const surface::HeightMap& map, double depth_m, Look look = {}) {
  return lit(map, depth_m, make_plain_face(look, kSamples));
}

TEST(Light, ComesFromBesideAndAboveTheOtherHand) {
  const glm::vec3 right = light_direction(Hand::right), left = light_direction(Hand::left);
  EXPECT_NEAR(glm::length(right), 1, 1e-6);
  EXPECT_NEAR(right.x, -0.438, 1e-3);
  EXPECT_NEAR(right.y, 0.4905, 1e-3);
  EXPECT_NEAR(right.z, 0.7533, 1e-3);
  EXPECT_EQ(left, glm::vec3(-right.x, right.y, right.z));
}

TEST(Light, OnThePlateauIsOneAndOnASideThatOfLampSkyAndDesk) {
  EXPECT_NEAR(open_light({0, 0, 1}, Hand::right), 1, 1e-6);
  const glm::vec3 lamp = light_direction(Hand::right);
  // A side sees four fifths of the sky's light and 0.12 from the table.
  EXPECT_NEAR(open_light({0, 1, 0}, Hand::right), kSky * 0.8 + 0.12 + kKey * lamp.y / lamp.z, 1e-5);
  EXPECT_NEAR(open_light({1, 0, 0}, Hand::right), kSky * 0.8 + 0.12, 1e-5) << "away from the lamp";
  EXPECT_NEAR(open_light({-1, 0, 0}, Hand::left), kSky * 0.8 + 0.12, 1e-5);
  EXPECT_GT(open_light(lamp, Hand::right), 1);
}

TEST(ShadedSize, IsThatOfTheMapBetween1024And2048) {
  EXPECT_EQ(shaded_size(2), 1024);
  EXPECT_EQ(shaded_size(1024), 1024);
  EXPECT_EQ(shaded_size(1025), 1025);
  EXPECT_EQ(shaded_size(2048), 2048);
  EXPECT_EQ(shaded_size(2049), 2048);
}

TEST(PlainFace, IsTheMaterialInPlainLightWithARimAround) {
  for (const Look look :
       {Look{Style::wood, Theme::light, Hand::right}, Look{Style::slate, Theme::dark, Hand::left}}) {
    const PlainFace face = make_plain_face(look, 160);
    EXPECT_EQ(face.look, look);
    EXPECT_EQ(face.rim, 10);
    ASSERT_EQ(face.size, 180);
    ASSERT_EQ(face.rgba.size(), 180U * 180 * 4);
    const Material material(look.style, look.theme);
    for (int y = 0; y < 180; y += 7) {
      for (int x = 0; x < 180; x += 7) {
        const std::size_t at = (static_cast<std::size_t>(y) * 180 + static_cast<std::size_t>(x)) * 4;
        const float step = 0.1F / 159;
        const glm::vec3 colour = material.reflectance(
            {static_cast<float>(x - 10) * step - 0.05F, 0.05F - static_cast<float>(y - 10) * step, 0}, 0);
        // Lamp and sky are hardly tinted, and even each other out.
        EXPECT_NEAR(linear(face.rgba[at]) / colour.x, 1, 0.03);
        EXPECT_NEAR(linear(face.rgba[at + 1]) / colour.y, 1, 0.03);
        EXPECT_NEAR(linear(face.rgba[at + 2]) / colour.z, 1, 0.03);
        EXPECT_NEAR(linear(face.rgba[at + 3]) * 1.6, 1, 0.006);
      }
    }
  }
}

TEST(LitPicture, OfAPlateauIsThePlainFace) {
  const Lit flat = lit(map_of([](double, double) { return 1.0; }), 0.01);
  const PlainFace plain = make_plain_face({}, kSamples);
  EXPECT_EQ(flat.picture.size, plain.size);
  EXPECT_EQ(flat.picture.rim, 32);
  EXPECT_EQ(flat.picture.rgba, plain.rgba);
  EXPECT_EQ(flat.picture.heights, std::vector<std::uint8_t>(plain.rgba.size() / 4, 255));
}

TEST(LitPicture, OfALevelThatLiesLowerHasAllTheLightAndItsOwnHeight) {
  const Lit low = lit(map_of([](double, double) { return 0.4; }), 0.01);
  for (const double x : {0.0, 0.3, 0.5, 1.0}) {
    for (const double y : {0.0, 0.6, 1.0}) {
      EXPECT_NEAR(low.light(x, y), 1, 0.006);
      EXPECT_EQ(low.picture.heights[low.texel(x, y)], 102);
      const glm::vec3 colour =
          Material(Style::wood, Theme::light)
              .reflectance({static_cast<float>(x * 0.1 - 0.05), static_cast<float>(0.05 - y * 0.1), -0.006F},
                           0.6F);
      EXPECT_NEAR(linear(low.picture.rgba[low.texel(x, y) * 4]) / colour.x, 1, 0.05);
    }
  }
}

TEST(LitPicture, ASlopeIsLitAsItLeansTowardsTheLamp) {
  for (const Hand hand : {Hand::right, Hand::left}) {
    const PlainFace face = make_plain_face({Style::slate, Theme::light, hand}, kSamples);
    for (int way = 0; way < 8; way += hand == Hand::right ? 1 : 3) {
      const double c = std::cos(way * std::numbers::pi / 4), s = std::sin(way * std::numbers::pi / 4);
      // As deep as wide: the slope is the change of height.
      const Lit slope = lit(
          map_of([&](double x, double y) { return 0.5 + 0.6 * (c * (x - 0.5) - s * (y - 0.5)); }), 0.1, face);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.6 * c, -0.6 * s, 1));
      const glm::dvec3 lamp(light_direction(hand));
      double sky = 0;
      for (int k = 0; k < 8; ++k) {
        const double a = (k + 0.5) * std::numbers::pi / 4;
        const double rise = std::max(0.0, 0.6 * kShaded * (std::cos(a) * c + std::sin(a) * s));
        sky += 1 / (1 + rise * rise) / 8;
      }
      const double expected = kKey * glm::dot(normal, lamp) / lamp.z + kSky * sky;
      EXPECT_NEAR(slope.light(0.5, 0.5), expected, 0.012) << way;
      EXPECT_NEAR(slope.light(0.42, 0.55), expected, 0.012) << way;
    }
  }
}

TEST(LitPicture, BesideAWallTheLampIsHiddenAndTheSkyHalf) {
  constexpr double kDepth = 0.03;  // of a tablet 0.1 wide
  const Lit wall = lit(map_of([](double x, double) { return x < 0.5 ? 1.0 : 0.0; }), kDepth);
  const Lit other = lit(map_of([](double x, double) { return x > 0.5 ? 1.0 : 0.0; }), kDepth,
                        Look{Style::wood, Theme::light, Hand::left});
  // The last sample of the plateau; from there on the map goes down.
  const double wall_at = 63.0 / 127;
  const auto light = [&](double away) {
    EXPECT_NEAR(wall.light(wall_at + away, 0.7), other.light(1 - wall_at - away, 0.7), 0.02) << away;
    return wall.light(wall_at + away, 0.7);
  };
  const glm::dvec3 lamp(light_direction(Hand::right));
  const double rise = lamp.z / std::hypot(lamp.x, lamp.y);
  const double aside = -lamp.x / std::hypot(lamp.x, lamp.y);
  const double height = kDepth / 0.1 * kShaded;
  // The lamp is a window: its lower and upper edge lie 0.55 below and above its middle, as slopes.
  const auto away = [&](double slope) { return height / slope * aside; };
  EXPECT_NEAR(light(away(rise)), kSky + kKey / 2, 0.04);
  EXPECT_NEAR(light(away(rise + 0.55)), kSky, 0.02);
  EXPECT_NEAR(light(away(rise - 0.55) + 0.004), 1, 0.012);
  // A quarter and three quarters of the window: 3 t^2 - 2 t^3.
  EXPECT_NEAR(light(away(rise + 0.275)), kSky + kKey * 0.15625, 0.04);
  EXPECT_NEAR(light(away(rise - 0.275)), kSky + kKey * 0.84375, 0.04);
  // Close to the wall it is in four of the eight directions.
  double sky = 0.5;
  for (const double a : {std::numbers::pi / 8, 3 * std::numbers::pi / 8}) {
    const double slope = height * std::cos(a) / 0.02;
    sky += 0.25 / (1 + slope * slope);
  }
  EXPECT_NEAR(light(0.02), kSky * sky, 0.02);
  EXPECT_NEAR(light(0.3), 1, 0.006);
}

TEST(LitPicture, AWallAboveHidesTheLampForBothHandsAndOneBelowForNone) {
  constexpr double kDepth = 0.03;
  for (const Hand hand : {Hand::right, Hand::left}) {
    const Look look{Style::wood, Theme::light, hand};
    const Lit above = lit(map_of([](double, double y) { return y < 0.5 ? 1.0 : 0.0; }), kDepth, look);
    const Lit below = lit(map_of([](double, double y) { return y > 0.5 ? 1.0 : 0.0; }), kDepth, look);
    const glm::dvec3 lamp(light_direction(hand));
    // How far below the wall the middle of the shadow's edge lies.
    const double reach = kDepth / 0.1 * kShaded / lamp.z * lamp.y;
    EXPECT_NEAR(above.light(0.4, 63.0 / 127 + reach), kSky + kKey / 2, 0.05);
    EXPECT_LT(above.light(0.4, 63.0 / 127 + reach / 3), kSky);
    EXPECT_NEAR(above.light(0.4, 63.0 / 127 + 0.3), 1, 0.006);
    // Only sky is lost there: half of it beside the wall.
    EXPECT_GT(below.light(0.4, 64.0 / 127 - reach / 3), kKey + kSky * 0.45);
    EXPECT_NEAR(below.light(0.4, 64.0 / 127 - 0.3), 1, 0.006);
  }
}

TEST(LitPicture, LightBetweenWallsTakesTheirColour) {
  // A narrow pit: the light on its floor is reflected by the wood.
  const Lit pit = lit(map_of([](double x, double) { return std::abs(x - 0.5) < 0.04 ? 0.0 : 1.0; }), 0.03);
  double warmth = 0;
  for (double y = 0.2; y < 0.8; y += 0.01) {
    const std::size_t at = pit.texel(0.5, y);
    const glm::vec3 wood =
        Material(Style::wood, Theme::light).reflectance({0, static_cast<float>(0.05 - y * 0.1), -0.03F}, 1);
    const double red = linear(pit.picture.rgba[at * 4]) / wood.x;
    const double blue = linear(pit.picture.rgba[at * 4 + 2]) / wood.z;
    warmth += red / blue / 60;
  }
  EXPECT_GT(warmth, 1.04);
  EXPECT_LT(warmth, 1.8);
}

TEST(LitPicture, ALineOfOneTexelIsLitWithItsTwoSidesWhereverItRuns) {
  constexpr int kSide = 128;
  const PlainFace plain = make_plain_face({}, kSide);
  for (const bool upright : {true, false}) {
    for (const int line : {0, 1, 2, 30, 31, 32, 33, 63, 64, 95, 96, 125, 126, 127}) {
      surface::HeightMap map = surface::HeightMap::create(kSide).value();
      for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
          map.set(column, row, (upright ? column : row) == line ? 0.5F : 1.0F);
      const SurfacePicture lit = lit_picture(map, {0.1, 0.01}, plain);
      for (int place = 0; place < kSide; ++place) {
        const int column = (upright ? place : 70) + plain.rim, row = (upright ? 70 : place) + plain.rim;
        const auto texel = static_cast<std::size_t>(row * plain.size + column);
        EXPECT_EQ(lit.heights[texel], place == line ? 128 : 255) << upright << ' ' << line << ' ' << place;
        const bool as_plain = std::equal(lit.rgba.begin() + static_cast<std::ptrdiff_t>(texel * 4),
                                         lit.rgba.begin() + static_cast<std::ptrdiff_t>(texel * 4 + 4),
                                         plain.rgba.begin() + static_cast<std::ptrdiff_t>(texel * 4));
        EXPECT_EQ(as_plain, std::abs(place - line) > 1) << upright << ' ' << line << ' ' << place;
      }
    }
  }
}

TEST(LitPicture, NearAnEdgeTheTabletGoesOnAsItEndsThere) {
  // The same valley at each side, so far from the corners that no ray sees them: the samples of the edge are
  // repeated beyond it, so what is lit there is lit as in the middle of a valley that is twice as wide.
  const PlainFace face = make_plain_face({Style::slate, Theme::light, Hand::right}, kSamples);
  const auto is_low = [](double place, double first, double last) {
    return place > (first - 0.5) / 127 && place < (last + 0.5) / 127 ? 0.4 : 1.0;
  };
  const Lit narrow = lit(map_of([&](double x, double) { return is_low(x, 0, 31); }), 0.03, face);
  const Lit wide = lit(map_of([&](double x, double) { return is_low(x, 32, 95); }), 0.03, face);
  for (const int samples : {4, 8, 16, 31})
    EXPECT_NEAR(narrow.light((31 - samples) / 127.0, 0.5), wide.light((95 - samples) / 127.0, 0.5), 0.012)
        << samples;
}

TEST(ExposureRow, IsBetweenTheSamplesOfTheCoarserLattice) {
  Exposure exposure{3, {}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      exposure.samples.push_back(
          {static_cast<float>(column * column), static_cast<float>(row + 10 * column)});
  ExposureRow between(exposure, 9);
  for (int row = 0; row < 9; ++row) {
    between.set_row(row);
    for (int column = 0; column < 9; ++column) {
      const float x = static_cast<float>(column) / 4;
      // 0, 1, 4 at the samples.
      EXPECT_FLOAT_EQ(between.at(column).key, x <= 1 ? x : 3 * x - 2);
      EXPECT_FLOAT_EQ(between.at(column).sky, static_cast<float>(row) / 4 + 10 * x);
    }
  }
}

TEST(GreyPicture, ShowsEachHeightAsAGrey) {
  const auto map = map_of([](double x, double y) { return x * y; });
  const SurfacePicture picture = grey_picture(map);
  EXPECT_EQ(picture.size, 128);
  EXPECT_EQ(picture.rim, 0);
  ASSERT_EQ(picture.heights.size(), 128U * 128);
  for (std::size_t i = 0; i < picture.heights.size(); ++i) {
    const auto grey = static_cast<int>(std::lround(map.samples()[i] * 255));
    ASSERT_EQ(picture.heights[i], grey);
    for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(picture.rgba[4 * i + k], k == 3 ? 255 : grey);
  }
  EXPECT_EQ(grey_picture(surface::HeightMap::create(2100).value()).size, 2048);
}

TEST(SharedFace, IsMadeOnceForALookAndASizeAndTheLastTwoAreKept) {
  const Look light{Style::wood, Theme::light, Hand::right};
  const Look dark{Style::wood, Theme::dark, Hand::right};
  const auto first = shared_plain_face(light, 32);
  const PlainFace own = make_plain_face(light, 32);
  EXPECT_EQ(first->rgba, own.rgba);
  EXPECT_EQ(shared_plain_face(dark, 32)->rgba, make_plain_face(dark, 32).rgba);
  EXPECT_EQ(shared_plain_face(light, 32), first);
  EXPECT_EQ(shared_plain_face(light, 48)->size, make_plain_face(light, 48).size);
  EXPECT_EQ(shared_plain_face(light, 32), first);
  const std::weak_ptr<const PlainFace> oldest = shared_plain_face(dark, 32);
  (void)shared_plain_face(light, 32);
  EXPECT_FALSE(oldest.expired());
  (void)shared_plain_face(light, 48);
  EXPECT_TRUE(oldest.expired());
}

TEST(KeptGrain, IsTheGrainToLessThanAnEyeCouldTell) {
  const Material wood(Style::wood, Theme::light);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec2 p{-0.05F + 0.0001F * static_cast<float>(i), 0.03F - 0.00005F * static_cast<float>(i)};
    const Grain grain = wood.grain(p);
    const Grain kept = KeptGrain(grain, p.x).at(p.x);
    ASSERT_NEAR(kept.across_m, grain.across_m, 0.5e-6) << i << ": a thousandth of a ring is 3 um";
    ASSERT_NEAR(kept.cloud, grain.cloud, 5e-5) << i;
    ASSERT_NEAR(kept.detail, grain.detail, 5e-5) << i;
  }
  const Grain stone{0, 0.75F, 1.3F};
  EXPECT_NEAR(KeptGrain(stone, 0.04F).at(0.04F).cloud, 0.75, 5e-5);
  EXPECT_NEAR(KeptGrain(stone, 0.04F).at(0.04F).detail, 1.3, 5e-5);
}

}  // namespace
}  // namespace nazori::view
