// SPDX-License-Identifier: Apache-2.0
#include "../src/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <utility>
#include <vector>

#include "nazori/haptics/servo.h"
#include "relief.h"

namespace nazori::haptics {
namespace {

constexpr Texture kAll[] = {Texture::paper, Texture::wood, Texture::stone};

TEST(Texture, SlopesAreBoundedTheSameEveryTimeAndWithoutAMean) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-0.06, 0.06);
  for (const Texture t : kAll) {
    Vec3 sum(0);
    double squares = 0;
    constexpr int kPlaces = 50'000;
    for (int i = 0; i < kPlaces; ++i) {
      const double x = any(random), y = any(random);
      const Vec3 slope = texture_slope(t, x, y);
      ASSERT_LE(glm::length(slope), kSteepestTexture);
      ASSERT_EQ(slope.z, 0);
      ASSERT_EQ(slope, texture_slope(t, x, y));
      sum += slope;
      squares += glm::dot(slope, slope);
    }
    EXPECT_LT(glm::length(sum) / kPlaces, 0.002);
    EXPECT_GT(std::sqrt(squares / kPlaces), 0.03) << "steep enough to be felt";
  }
  EXPECT_EQ(texture_slope(Texture::none, 0.01, 0.02), Vec3(0));
}

// The slope is a gradient: a closed path comes back to the same height.
TEST(Texture, SlopesAreThoseOfOneReliefSoAClosedWayGivesNoEnergy) {
  for (const Texture t : kAll) {
    double height = 0, most = 0;
    constexpr int kSteps = 200'000;
    Vec3 before{0.003, 0, 0};
    for (int i = 1; i <= kSteps; ++i) {
      const double turn = 2 * 3.14159265358979 * i / kSteps;
      const Vec3 at{0.003 * std::cos(turn), 0.002 * std::sin(3 * turn), 0};
      const Vec3 middle = 0.5 * (before + at);
      height += glm::dot(texture_slope(t, middle.x, middle.y), at - before);
      most = std::max(most, std::abs(height));
      before = at;
    }
    EXPECT_NEAR(height, 0, 1e-9);
    EXPECT_GT(most, 1e-6);
  }
}

TEST(Texture, NeitherSlopesNorTheirChangeHaveSteps) {
  for (const Texture t : kAll)
    for (int i = 0; i < 100'000; ++i) {
      const double x = -0.02 + 4e-7 * i;
      const Vec3 a = texture_slope(t, x, 0.3 * x), b = texture_slope(t, x + 1e-9, 0.3 * (x + 1e-9));
      ASSERT_LT(glm::length(a - b), 1e-9 * kSteepestTexture * 20 / 0.0004);
    }
}

TEST(Texture, WoodIsRoughAcrossItsGrainAndSmoothAlongIt) {
  double along = 0, across = 0;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 slope = texture_slope(Texture::wood, any(random), any(random));
    along += slope.x * slope.x;
    across += slope.y * slope.y;
  }
  EXPECT_GT(across, 100 * along);
}

TEST(Texture, ItsSteepestPlacesAreNearlyAsSteepAsTheBoundSays) {
  // Half way between two corners of the lattice that differ most. Among 10,000 some nearly reach both bounds.
  double most = 0;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j)
      most = std::max(most, std::abs(texture_slope(Texture::paper, 0.0004 * (i + 0.5), 0.0004 * j).x));
  EXPECT_LE(most, kSteepestTexture / std::sqrt(2.0));
  EXPECT_GT(most, 0.97 * kSteepestTexture / std::sqrt(2.0));
}

TEST(Texture, APatternIsLevelAtTheCornersOfItsLatticeAndNowhereElse) {
  const auto steepness = [](Texture t, double x, double y) { return glm::length(texture_slope(t, x, y)); };
  for (int i = -5; i < 6; ++i) {
    EXPECT_LT(steepness(Texture::paper, 0.0004 * i, 0.0004 * 3), 1e-9);
    EXPECT_LT(steepness(Texture::wood, 0.012 * i, 0.0006 * 7), 1e-9);
    EXPECT_GT(steepness(Texture::paper, 0.0004 * (i + 0.37), 0.0004 * 3.5), 1e-4);
    EXPECT_GT(steepness(Texture::wood, 0.012 * (i + 0.37), 0.0006 * 7.5), 1e-4);
  }
}

/// The noise of paper, in the coordinates of its lattice.
Vec3 noise(double u, double v) { return texture_slope(Texture::paper, 0.0004 * u, 0.0004 * v); }

TEST(Texture, APatternIsBlendedFromTheFourCornersOfACell) {
  // By t^3 (10 - 15 t + 6 t^2), which rises by 30 t^2 (1 - t)^2.
  const auto blend = [](double t) { return t * t * t * (10 - 15 * t + 6 * t * t); };
  const auto rise = [](double t) { return 30 * t * t * (1 - t) * (1 - t); };
  for (const auto& [i, j] : {std::pair{0, 0}, {3, 8}, {-4, 5}, {7, -6}, {-9, -2}}) {
    const double low_edge = noise(i + 0.5, j).x, high_edge = noise(i + 0.5, j + 1).x;
    const double left_edge = noise(i, j + 0.5).y, right_edge = noise(i + 1, j + 0.5).y;
    EXPECT_NEAR(low_edge + right_edge, left_edge + high_edge, 1e-9) << "both ways to the opposite corner";
    for (const double a : {0.1, 0.3, 0.85})
      for (const double b : {0.2, 0.7}) {
        const Vec3 inside = noise(i + a, j + b);
        EXPECT_NEAR(inside.x, rise(a) / rise(0.5) * std::lerp(low_edge, high_edge, blend(b)), 1e-9);
        EXPECT_NEAR(inside.y, rise(b) / rise(0.5) * std::lerp(left_edge, right_edge, blend(a)), 1e-9);
      }
  }
}

TEST(Texture, WoodIsTheNoiseStretchedAndStoneTwoOfThem) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  for (int i = 0; i < 200; ++i) {
    const double x = any(random), y = any(random);
    const Vec3 grain = noise(x / 0.012, y / 0.0006);
    const Vec3 wood = texture_slope(Texture::wood, x, y);
    EXPECT_NEAR(wood.x, grain.x / 20, 1e-9);
    EXPECT_NEAR(wood.y, grain.y, 1e-9);
    const Vec3 both =
        0.6 * noise(x / 0.0014, y / 0.0014) + 0.4 * noise(x / 0.0005 + 37.5, y / 0.0005 - 11.25);
    const Vec3 stone = texture_slope(Texture::stone, x, y);
    EXPECT_NEAR(stone.x, both.x, 1e-9);
    EXPECT_NEAR(stone.y, both.y, 1e-9);
  }
}

TEST(Texture, TurnsThePushOfTheSurfaceAndKeepsItsLengthAndFriction) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  double most = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 normal = glm::normalize(Vec3(20 * any(random), 20 * any(random), 1));
    const Vec3 place{any(random), any(random), 0};
    const Vec3 push = 2.0 * normal;
    const Vec3 turned = textured(push, normal, place, Texture::stone, 1);
    ASSERT_NEAR(glm::length(turned), 2, 1e-12);
    most = std::max(most, std::acos(std::min(1.0, glm::dot(turned, normal) / 2)));
    const Vec3 aside = glm::cross(normal, Vec3(0, 1, 0));
    ASSERT_NEAR(glm::length(textured(push + aside, normal, place, Texture::stone, 1) - turned - aside), 0,
                1e-12);
    ASSERT_EQ(textured(push, normal, place, Texture::stone, 0), push);
    ASSERT_EQ(textured(push, normal, place, Texture::none, 1), push);
  }
  EXPECT_LE(most, std::atan(kSteepestTexture));
  EXPECT_GT(most, 0.1);
}

TEST(Texture, IsFeltSidewaysWhileTheProxyStaysOnTheTrueSurface) {
  const test::Relief flat(64, 0.01, test::plate);
  for (const Texture t : kAll) {
    auto scene = flat.scene();
    scene->material.texture = t;
    scene->material.roughness = 1;
    Servo servo{DeviceDescription{}};
    servo.set_scene(scene);
    double squares = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 at{-0.03 + 2e-5 * i, 0.01 + 1e-5 * i, i < 400 ? 0.001 : -0.002};
      const Vec3 force = servo.tick({0.001 * i, at, 0, true});
      const Vec3 proxy = servo.latest().proxy_m;
      if (i < 500) continue;
      ASSERT_NEAR(proxy.x, at.x, 1e-9);
      ASSERT_NEAR(proxy.y, at.y, 1e-9);
      ASSERT_NEAR(proxy.z, 0, 1e-12);
      ASSERT_LE(glm::length(force), 0.8 + 1e-9);
      squares += force.x * force.x + force.y * force.y;
    }
    EXPECT_GT(std::sqrt(squares / 2500), 0.02);
  }
}

TEST(Texture, TiltsThePushAgainstTheSlopeOnASurfaceOfAnyTilt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 normal = glm::normalize(Vec3(any(random), any(random), 1));
    const Vec3 at{0.05 * any(random), 0.05 * any(random), 0};
    const Vec3 force = 2.0 * normal + 0.1 * Vec3(any(random), any(random), any(random));
    const double push = glm::dot(force, normal);
    // The part of the slope that lies in the surface.
    const Vec3 slope = 0.8 * texture_slope(Texture::stone, at.x, at.y);
    const Vec3 along = slope - glm::dot(slope, normal) * normal;
    const Vec3 added = textured(force, normal, at, Texture::stone, 0.8) - force;
    const double size = std::sqrt(1 + glm::dot(along, along));
    EXPECT_LT(glm::length(added - push * ((normal - along) / size - normal)), 1e-12);
  }
}

TEST(Texture, WhatDoesNotPushIsNotTilted) {
  const Vec3 normal{0, 0, 1}, at{0.0123, 0.004, 0};
  for (const Vec3 force : {Vec3(0.1, 0, 0), Vec3(0.1, 0.2, -1)})
    EXPECT_EQ(textured(force, normal, at, Texture::stone, 1), force);
  EXPECT_NE(textured({0.1, 0, 1}, normal, at, Texture::stone, 1), Vec3(0.1, 0, 1));
  EXPECT_EQ(textured({0.1, 0, 1}, normal, at, Texture::stone, 0), Vec3(0.1, 0, 1));
}

}  // namespace
}  // namespace nazori::haptics
