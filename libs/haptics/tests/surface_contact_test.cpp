// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/surface_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "relief.h"

namespace nazori::haptics {
namespace {

using test::plate;
using test::Relief;

constexpr double kTolerance_m = 2e-7;

double above(const Relief& relief, const Vec3& p) { return p.z - relief.tablet.height(p.x, p.y); }

/// The pull along the surface that remains at the proxy.
double lateral(const Relief& relief, const SurfaceContact& contact, const Vec3& device) {
  const Vec3 n = relief.tablet.at(contact.proxy_m().x, contact.proxy_m().y).normal();
  const Vec3 e = contact.proxy_m() - device;
  return glm::length(e - glm::dot(e, n) * n);
}

/// Smallest distance from `d` to the surface by exhaustive search within `reach`.
double nearest_by_search(const Relief& relief, const Vec3& d, double reach) {
  constexpr int kTries = 100;
  double x = d.x, y = d.y;
  const auto far = [&](double a, double b) {
    return glm::length(Vec3(a, b, relief.tablet.height(a, b)) - d);
  };
  double best = far(x, y);
  double step = reach / kTries;
  while (step > 1e-10) {
    const double from_x = x, from_y = y;
    const int n = step == reach / kTries ? kTries : 8;
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j)
        if (const double r = far(from_x + i * step, from_y + j * step); r < best) {
          best = r;
          x = from_x + i * step;
          y = from_y + j * step;
        }
    step /= 4;
  }
  return best;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(TabletSurface, APatchGivesThePlacesOfTheSurfaceWhereItHasThem) {
  const Relief relief(24, 0.01, [](double x, double y) {
    return -0.005 + 0.004 * std::sin(900 * x) * std::cos(700 * y + 300 * x);
  });
  const double reach = relief.tablet.cell_m() / 2;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> where(-0.06, 0.06), way(-1.5, 1.5);
  int found = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = where(random), y = where(random);
    const TabletSurface::Patch patch = relief.tablet.patch_at(x, y);
    const bool is_beyond = std::max(std::abs(x), std::abs(y)) > 0.05 + reach;
    EXPECT_EQ(patch.has(x, y), !is_beyond);
    // One place in the same patch or beside it, and the place that was asked for.
    for (const double far : {reach * way(random), 0.0}) {
      const double px = x + far, py = y - far;
      if (far != 0 && !patch.has(px, py)) continue;
      const TabletSurface::Place p = patch.at(px, py), q = relief.tablet.at(px, py);
      found += far != 0 ? 1 : 0;
      EXPECT_EQ(p.point().x, px);
      EXPECT_EQ(p.point().y, py);
      EXPECT_NEAR(p.z, q.z, 1e-16);
      EXPECT_NEAR(p.zx, q.zx, 1e-12);
      EXPECT_NEAR(p.zy, q.zy, 1e-12);
      EXPECT_NEAR(p.zxx, q.zxx, 1e-9);
      EXPECT_NEAR(p.zxy, q.zxy, 1e-9);
      EXPECT_NEAR(p.zyy, q.zyy, 1e-9);
    }
  }
  EXPECT_GT(found, 1000);
}

/// Moves in a straight line in `steps` ticks.
void lead(SurfaceContact& contact, const Relief& relief, const Vec3& from, const Vec3& to, int steps,
          const Friction& friction = {}) {
  for (int i = 1; i <= steps; ++i)
    contact.update(relief.tablet, from + (to - from) * (static_cast<double>(i) / steps), friction);
}

TEST(SurfaceContact, InTheAirTheProxyIsTheDevice) {
  const Relief groove(64, 0.01, [](double x, double) { return -0.01 + 0.5 * std::abs(x); });
  SurfaceContact contact;
  for (const Vec3 device : {Vec3(0, 0, 0.02), Vec3(0, 0, -0.004), Vec3(0.3, -0.3, 1e-6)}) {
    contact.update(groove.tablet, device, {});
    EXPECT_FALSE(contact.touching());
    EXPECT_EQ(contact.proxy_m(), device);
  }
}

TEST(SurfaceContact, OnAPlateTheProxyIsStraightAboveTheDeviceWithoutLag) {
  const Relief flat(128, 0.01, plate);
  SurfaceContact contact;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 device{0.04 * std::sin(0.02 * i), 0.03 * std::cos(0.03 * i), -0.002};
    contact.update(flat.tablet, device, {});
    ASSERT_TRUE(contact.touching());
    expect_near(contact.proxy_m(), {device.x, device.y, 0}, 1e-12);
  }
}

TEST(SurfaceContact, PushesBackInTheVeryFirstTickInside) {
  const Relief flat(128, 0.01, plate);
  SurfaceContact contact;
  contact.update(flat.tablet, {0.01, 0, 1e-5}, {});
  ASSERT_FALSE(contact.touching());
  contact.update(flat.tablet, {0.01, 0, -1e-6}, {});
  EXPECT_TRUE(contact.touching());
  EXPECT_NEAR(contact.proxy_m().z, 0, 1e-12);
}

TEST(SurfaceContact, OnAnInclineTheProxyIsThePerpendicularFoot) {
  const double a = 0.15, b = 0.05;
  const Relief incline(128, 0.02, [&](double x, double y) { return -0.01 + a * x + b * y; });
  const Vec3 n = glm::normalize(Vec3(-a, -b, 1));
  SurfaceContact contact;
  for (int i = 0; i < 500; ++i) {
    const Vec3 device{0.03 * std::sin(0.02 * i), 0.03 * std::cos(0.033 * i), -0.016};
    contact.update(incline.tablet, device, {});
    const double depth = glm::dot(Vec3(0, 0, -0.01) - device, n);
    if (depth <= 0) continue;
    expect_near(contact.proxy_m(), device + depth * n, kTolerance_m);
  }
}

// Walls at 63 and 72 degrees: the vertical depth would point into the opposite wall.
TEST(SurfaceContact, InAVGrooveTheProxyIsOnTheWallThatIsPressedAndInTheCornerBelow) {
  for (const double slope : {1.0, 2.0, 3.0}) {
    const Relief groove(256, 0.012,
                        [&](double x, double) { return std::min(0.0, -0.012 + slope * std::abs(x)); });
    const double cell = groove.tablet.cell_m();
    SurfaceContact contact;
    const Vec3 n = glm::normalize(Vec3(-slope, 0, 1));  // of the right wall
    const Vec3 wall{0.5 * 0.012 / slope, 0.003, -0.006};
    lead(contact, groove, wall + 0.001 * n, wall - 0.001 * n, 20);
    ASSERT_TRUE(contact.touching());
    expect_near(contact.proxy_m(), wall, 2 * kTolerance_m);
    // Straight below the corner, which the samples beside it round by a quarter of a sample's rise.
    SurfaceContact below;
    lead(below, groove, {0, 0.003, -0.005}, {0, 0.003, -0.014}, 50);
    const double x = groove.tablet.cell_m() / 2;  // samples lie at half cells from x = 0 for an even size
    EXPECT_NEAR(std::abs(below.proxy_m().x), 0, x);
    EXPECT_NEAR(below.proxy_m().z, -0.012 + slope * cell / 2, slope * cell / 2);
  }
}

TEST(SurfaceContact, InABowlTheProxyLiesOnTheRayFromItsCentre) {
  const double radius = 0.1;
  const Relief bowl(512, 0.02, [&](double x, double y) {
    return std::min(0.0, -0.012 + radius - std::sqrt(std::max(0.0, radius * radius - x * x - y * y)));
  });
  const Vec3 centre{0, 0, -0.012 + radius};
  SurfaceContact contact;
  for (int i = 0; i < 400; ++i) {
    const double r = 0.03 * std::sin(0.011 * i), at = 0.05 * i;
    const Vec3 on = centre + radius * glm::normalize(Vec3(r * std::cos(at), r * std::sin(at), -0.1));
    const Vec3 device = on + 0.002 * glm::normalize(on - centre);
    contact.update(bowl.tablet, device, {});
    expect_near(contact.proxy_m(), on, 5e-7);
  }
}

TEST(SurfaceContact, OnADomeTheProxyLiesOnTheRayFromItsCentre) {
  const double radius = 0.08;
  const Relief dome(512, 0.02, [&](double x, double y) {
    return std::sqrt(std::max(0.0, radius * radius - x * x - y * y)) - radius;
  });
  const Vec3 centre{0, 0, -radius};
  SurfaceContact contact;
  for (int i = 0; i < 400; ++i) {
    const double r = 0.02 * std::sin(0.011 * i), at = 0.02 * i;
    const Vec3 on = centre + radius * glm::normalize(Vec3(r * std::cos(at), r * std::sin(at), radius));
    contact.update(dome.tablet, on + 0.003 * glm::normalize(centre - on), {});
    expect_near(contact.proxy_m(), on, 1e-6);
  }
}

TEST(SurfaceContact, AStepIsAWallThatPushesSideways) {
  for (const int size : {128, 1024}) {
    const Relief step(size, 0.01, [](double x, double) { return x < 0 ? -0.01 : 0.0; });
    SurfaceContact contact;
    lead(contact, step, {-0.003, 0, -0.005}, {0.002, 0, -0.005}, 40);
    ASSERT_TRUE(contact.touching());
    const Vec3 push = contact.proxy_m() - Vec3(0.002, 0, -0.005);
    EXPECT_LT(push.x, -0.0015);
    EXPECT_LT(std::abs(push.z), 0.25 * std::abs(push.x));
    EXPECT_LT(std::abs(contact.proxy_m().x), 1.5 * step.tablet.cell_m());
  }
}

TEST(SurfaceContact, BeyondARidgeItGoesAtMostSixStepsOfHalfASampleInATick) {
  // A roof with slopes of 45 degrees. The device passes below its ridge.
  const Relief roof(128, 0.02, [](double x, double) { return -std::abs(x); });
  const double step = roof.tablet.cell_m() / 2;
  EXPECT_DOUBLE_EQ(step, 0.1 / 127 / 2) << "128 samples over 0.1 m";
  for (const double depth : {0.004, 0.01}) {
    SurfaceContact contact;
    lead(contact, roof, {-0.004, 0, 0}, {-0.0005, 0, -depth}, 200);
    ASSERT_LT(contact.proxy_m().x, 0);
    const Vec3 device{0.002, 0, -depth};
    contact.update(roof.tablet, device, {});
    // The nearest point of the other slope, or the farthest that it reaches from straight above.
    const double nearest = (device.x - device.z) / 2;
    EXPECT_NEAR(contact.proxy_m().x, std::min(nearest, device.x + 6 * step), 1e-6) << depth;
    for (int i = 0; i < 3; ++i) contact.update(roof.tablet, device, {});
    EXPECT_NEAR(contact.proxy_m().x, nearest, 1e-6) << depth;
  }
}

TEST(SurfaceContact, OutsideTheTabletThePlateauGoesOn) {
  const Relief flat(64, 0.01, plate);
  SurfaceContact contact;
  lead(contact, flat, {0.04, 0.04, -0.001}, {0.09, 0.2, -0.001}, 100);
  EXPECT_TRUE(contact.touching());
  expect_near(contact.proxy_m(), {0.09, 0.2, 0}, 1e-12);
  // The rim has no edge either where a groove runs out of it.
  const Relief groove(64, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  SurfaceContact along;
  for (int i = 150; i < 350; ++i) {
    const double x = 0.0002 * i;
    along.update(groove.tablet, {x, 0, -0.011}, {});
    EXPECT_NEAR(along.proxy_m().x, x, kTolerance_m);
  }
}

Relief crossing_grooves(int size) {
  return Relief(size, 0.01, [](double x, double y) {
    const auto groove = [](double d) {
      return d > 0.006 ? 0.0 : -0.005 * (1 + std::cos(d / 0.006 * 3.14159265));
    };
    return std::min(
        {groove(std::abs(x - 0.3 * y)), groove(std::abs(y)), groove(std::abs(std::hypot(x, y) - 0.03))});
  });
}

TEST(SurfaceContact, AtRestNoOtherPlaceNearbyIsNearer) {
  const Relief relief = crossing_grooves(256);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> where(-0.045, 0.045), deep(0.0002, 0.003), way(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const double x = where(random), y = where(random);
    const Vec3 to{x, y, relief.tablet.height(x, y) - deep(random)};
    SurfaceContact contact;
    lead(contact, relief, to + Vec3(0.003 * way(random), 0.003 * way(random), 0.015), to, 60);
    for (int rest = 0; rest < 3; ++rest) contact.update(relief.tablet, to, {});
    EXPECT_LT(lateral(relief, contact, to), kTolerance_m);
    EXPECT_NEAR(above(relief, contact.proxy_m()), 0, 1e-15);
    const double depth = relief.tablet.height(x, y) - to.z;
    const double far = glm::length(contact.proxy_m() - to);
    EXPECT_LE(far, nearest_by_search(relief, to, depth) + SurfaceContact::kRidge_m + 1e-4);
  }
}

TEST(SurfaceContact, AStepThatWouldLeadFartherAwayIsShortenedUntilItLeadsNearer) {
  constexpr double kWave = 2 * std::numbers::pi / 0.006;
  const Relief waves(128, 0.004, [](double x, double y) {
    return -0.002 + 0.0015 * std::sin(kWave * x) * std::cos(0.8 * kWave * y);
  });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> where(-0.03, 0.03), deep(0.0005, 0.006);
  for (int i = 0; i < 1000; ++i) {
    const double x = where(random), y = where(random);
    const Vec3 to{x, y, waves.tablet.height(x, y) - deep(random)};
    SurfaceContact contact;
    lead(contact, waves, {x, y, 0.001}, to, 30);
    for (int rest = 0; rest < 3; ++rest) contact.update(waves.tablet, to, {});
    EXPECT_LT(lateral(waves, contact, to), kTolerance_m) << i;
  }
}

TEST(SurfaceContact, IsNeverBelowTheSurfaceWhateverTheDeviceDoes) {
  const Relief relief = crossing_grooves(128);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> where(-0.08, 0.08), height(-0.03, 0.01), any(0, 1);
  SurfaceContact contact;
  Vec3 device{0, 0, 0.01};
  for (int i = 0; i < 100'000; ++i) {
    const double what = any(random);
    if (what < 0.1)
      device = {where(random), where(random), height(random)};  // teleport
    else if (what < 0.11)
      contact.forget();
    else
      device += 0.001 * Vec3(any(random) - 0.5, any(random) - 0.5, any(random) - 0.5);
    const Friction friction = i % 2000 < 1000 ? Friction{} : Friction{0.6, 0.4};
    contact.update(relief.tablet, device, friction);
    ASSERT_GE(above(relief, contact.proxy_m()), -1e-15);
    if (!contact.touching()) {
      ASSERT_EQ(contact.proxy_m(), device);
    }
    ASSERT_LE(glm::length(contact.proxy_m() - device) / std::sqrt(1 + 0.36),
              std::max(0.0, -above(relief, device)) + SurfaceContact::kRidge_m + 1e-9);
  }
}

TEST(SurfaceContact, ADiveAtFiftyMetresASecondIsStoppedWhereItWentIn) {
  const Relief relief = crossing_grooves(128);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> where(-0.03, 0.03), tilt(0, 1), phase(0, 0.05);
  for (int dive = 0; dive < 500; ++dive) {
    const double x = where(random), y = where(random), lean = tilt(random), turn = 6 * tilt(random);
    const Vec3 way = glm::normalize(Vec3(lean * std::cos(turn), lean * std::sin(turn), -1));
    const Vec3 entry{x, y, relief.tablet.height(x, y)};
    SurfaceContact contact;
    const double start = -0.1 - phase(random);
    for (int i = 0; start + 0.05 * i < 0.05; ++i) {
      const Vec3 device = entry + (start + 0.05 * i) * way;
      contact.update(relief.tablet, device, {});
      EXPECT_EQ(contact.touching(), above(relief, device) < 0);
      EXPECT_GE(above(relief, contact.proxy_m()), -1e-15);
    }
    contact.update(relief.tablet, entry + 0.05 * way, {});  // below every groove
    EXPECT_TRUE(contact.touching());
    EXPECT_NEAR(above(relief, contact.proxy_m()), 0, 1e-15);
  }
}

TEST(SurfaceContact, ADiveIntoAGrooveIsHeldByFrictionWhereItMetTheFloor) {
  // The path is inclined by 30 degrees. It passes the plateau's level long before it meets the floor.
  constexpr double kFloor_m = -0.01;
  const Relief groove(256, 0.01, [](double, double y) { return std::abs(y) < 0.03 ? kFloor_m : 0.0; });
  const double lean = std::tan(std::numbers::pi / 6);
  const auto on_the_way = [&](double z) { return Vec3(-lean * z - 0.02, 0, z); };
  SurfaceContact contact;
  const Friction friction{1, 1};
  contact.update(groove.tablet, on_the_way(0.002), friction);
  ASSERT_FALSE(contact.touching());
  contact.update(groove.tablet, on_the_way(kFloor_m - 0.001), friction);
  ASSERT_TRUE(contact.touching());
  expect_near(contact.proxy_m(), on_the_way(kFloor_m), kTolerance_m);
}

TEST(SurfaceContact, ADiveIntoWavesIsHeldByFrictionWhereItFirstMetOne) {
  const Relief waves(128, 0.01, [](double x, double y) {
    return -0.005 +
           0.003 * std::sin(2 * std::numbers::pi * x / 0.012) * std::cos(2 * std::numbers::pi * y / 0.02);
  });
  const Friction rough{10, 10};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> where(-0.03, 0.03), lean(-1.5, 1.5), high(-0.0005, 0.004);
  int grazing = 0;
  for (int dive = 0; dive < 300; ++dive) {
    const Vec3 from{where(random), where(random), high(random)};
    const double lean_x = lean(random), lean_y = lean(random);
    const Vec3 way = glm::normalize(Vec3(lean_x, lean_y, -1));
    // The first place below the surface, a thousandth of a sample at a time.
    double met = 0;
    while (above(waves, from + met * way) > 0) met += 2e-7;
    const Vec3 entry = from + met * way;
    const double beyond = dive % 2 == 0 ? 1e-4 : 1.5e-3;
    const Vec3 device = entry + beyond * way;
    // Where the path barely touches a crest it is outside the cone, or outside again.
    bool grazes = glm::dot(way, waves.tablet.at(entry.x, entry.y).normal()) > -0.3;
    for (double s = 1e-5; s <= beyond; s += 1e-5) grazes = grazes || above(waves, entry + s * way) > 0;
    if (grazes) {
      ++grazing;
      continue;
    }
    SurfaceContact contact;
    contact.update(waves.tablet, from, rough);
    ASSERT_FALSE(contact.touching());
    contact.update(waves.tablet, device, rough);
    ASSERT_TRUE(contact.touching());
    expect_near(contact.proxy_m(), entry, 1e-6);
  }
  EXPECT_LT(grazing, 60);
}

TEST(SurfaceContact, AnotherSurfaceOfTheSameSizeIsFeltAtOnceAlsoWhileTouching) {
  const Relief low(16, 0.01, [](double x, double) { return -0.006 + 0.1 * x; });
  const Relief high(16, 0.01, [](double, double y) { return -0.004 - 0.1 * y; });
  SurfaceContact contact;
  for (int i = 0; i < 6; ++i) {
    const Relief& relief = i % 2 == 0 ? low : high;
    const Vec3 device{0.001, 0.002, i == 3 ? 0.01 : -0.008};
    contact.update(relief.tablet, device, {});
    EXPECT_EQ(contact.touching(), i != 3);
    if (!contact.touching()) continue;
    EXPECT_NEAR(above(relief, contact.proxy_m()), 0, 1e-15);
    EXPECT_LT(lateral(relief, contact, device), kTolerance_m);
  }
}

TEST(SurfaceContact, ASurfaceThatRisesUnderARestingStylusLiftsIt) {
  int lifted = 0;
  for (int i = 0; i < 1000; ++i) {
    const Relief low(16, 0.01, [&](double, double) { return -0.01 + 0.000001 * i; });
    const Relief high(16, 0.01, [&](double, double) { return -0.009 + 0.000001 * i; });
    SurfaceContact contact;
    const Vec3 device{0.001, 0.002, -0.0099 + 0.000001 * i};
    contact.update(low.tablet, device, {});
    ASSERT_FALSE(contact.touching());
    contact.update(high.tablet, device, {});
    lifted += contact.touching() && std::abs(above(high, contact.proxy_m())) < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(lifted, 1000);
}

TEST(SurfaceContact, FrictionHoldsWithinTheConeAndDragsBehindByTheDynamicCoefficient) {
  const Relief flat(128, 0.01, plate);
  const Friction friction{0.5, 0.3};
  const double depth = 0.002;
  SurfaceContact contact;
  contact.update(flat.tablet, {0, 0, 0.001}, friction);
  contact.update(flat.tablet, {0, 0, -depth}, friction);
  double x = 0;
  while (x < 0.49 * depth) contact.update(flat.tablet, {x += 1e-6, 0, -depth}, friction);
  EXPECT_NEAR(contact.proxy_m().x, 0, 1e-12);
  EXPECT_TRUE(contact.held());
  while (x < 0.01) contact.update(flat.tablet, {x += 1e-6, 0, -depth}, friction);
  EXPECT_NEAR(contact.proxy_m().x, x - 0.3 * depth, 0.002 * 0.3 * depth + 1e-6);
  EXPECT_FALSE(contact.held());
  // Stopping brings static friction back.
  const double stopped = contact.proxy_m().x;
  for (int i = 0; i < 5; ++i) contact.update(flat.tablet, {x, 0, -depth}, friction);
  EXPECT_TRUE(contact.held());
  contact.update(flat.tablet, {stopped + 0.49 * depth, 0, -depth}, friction);
  EXPECT_NEAR(contact.proxy_m().x, stopped, 2e-6);
}

TEST(SurfaceContact, InTheTickInWhichItBeginsToSlideItSlidesAsFarAsItsDragAllows) {
  const Relief flat(128, 0.01, plate);
  const double depth = 0.002;
  SurfaceContact contact;
  const auto press = [&](double x, const Friction& friction) {
    contact.update(flat.tablet, {x, 0, -depth}, friction);
    return contact.proxy_m().x;
  };
  contact.update(flat.tablet, {0, 0, 0.001}, {0.5, 0.3});
  EXPECT_NEAR(press(0, {0.5, 0.3}), 0, 1e-12);
  EXPECT_NEAR(press(0.49 * depth, {0.5, 0.3}), 0, 1e-12) << "held";
  EXPECT_NEAR(press(2 * depth, {0.5, 0.3}), (2 - 0.3) * depth, 0.01 * depth);
  EXPECT_FALSE(contact.held());
  // While it slides, the drag alone counts, and never more than what holds.
  EXPECT_NEAR(press(2.4 * depth, {0.5, 0.3}), (2.4 - 0.3) * depth, 0.01 * depth);
  EXPECT_NEAR(press(3 * depth, {0.2, 0.4}), (3 - 0.2) * depth, 0.01 * depth);
}

TEST(SurfaceContact, OnAnInclineFrictionHoldsUpToItsAngle) {
  const double slope = 0.15;
  const Relief incline(128, 0.02, [&](double x, double) { return -0.01 + slope * x; });
  // Pressed straight down, the pull along the surface is tan(angle) of the pull into it: the slope itself.
  for (const double hold : {0.9 * slope, 1.1 * slope}) {
    SurfaceContact contact;
    lead(contact, incline, {0, 0, -0.009}, {0, 0, -0.012}, 300, {hold, hold});
    const bool slipped = std::abs(contact.proxy_m().x) > 1e-6;
    EXPECT_EQ(slipped, hold < slope);
  }
}

// The remaining pull along the surface lies within the cone; where the proxy slid it came to rest at the
// cone's edge, not deep inside it.
TEST(SurfaceContact, AtRestWithFrictionThePullLiesInTheCone) {
  const Relief relief = crossing_grooves(256);
  std::mt19937 random(14);
  std::uniform_real_distribution<double> where(-0.045, 0.045), deep(0.0002, 0.003), way(-1, 1);
  int slid = 0;
  for (const double mu : {0.1, 0.3, 0.8})
    for (int i = 0; i < 200; ++i) {
      const double x = where(random), y = where(random);
      const Vec3 to{x, y, relief.tablet.height(x, y) - deep(random)};
      SurfaceContact contact;
      lead(contact, relief, to + Vec3(0.003 * way(random), 0.003 * way(random), 0.015), to, 60, {mu, mu});
      for (int rest = 0; rest < 5; ++rest) contact.update(relief.tablet, to, {mu, mu});
      EXPECT_TRUE(contact.held());
      const Vec3 lag = contact.proxy_m() - to;
      const double along = lateral(relief, contact, to), into = glm::dot(lag, contact.normal());
      EXPECT_LE(along, mu * into * 1.002 + kTolerance_m);
      slid += along > 0.95 * mu * into ? 1 : 0;
      const Vec3 before = contact.proxy_m();
      contact.update(relief.tablet, to, {mu, mu});
      EXPECT_EQ(contact.proxy_m(), before);
    }
  EXPECT_GT(slid, 100);
}

TEST(SurfaceContact, WithoutFrictionAClosedWayCostsNoWorkAndWithFrictionItDoes) {
  const Relief relief = crossing_grooves(256);
  const auto work = [&](const Friction& friction) {
    SurfaceContact contact;
    double sum = 0;
    constexpr int kSteps = 60'000;
    Vec3 before{0.02, 0, 0};
    Vec3 force(0);
    for (int round = 0; round < 2; ++round)
      for (int i = 0; i <= kSteps; ++i) {
        const double at = 2 * std::numbers::pi * i / kSteps;
        const double x = 0.02 * std::cos(at), y = 0.02 * std::sin(at);
        const Vec3 device{x, y, relief.tablet.height(x, y) - 0.0005};
        contact.update(relief.tablet, device, friction);
        const Vec3 now = 1000.0 * (contact.proxy_m() - device);
        if (round == 1) sum -= glm::dot(0.5 * (now + force), device - before);  // done by the hand
        force = now;
        before = device;
      }
    return sum;
  };
  EXPECT_NEAR(work({}), 0, 2e-5);
  EXPECT_GT(work({0.3, 0.3}), 0.005);
}

}  // namespace
}  // namespace nazori::haptics
