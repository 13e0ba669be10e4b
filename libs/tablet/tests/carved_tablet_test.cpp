// SPDX-License-Identifier: Apache-2.0
#include "nazori/tablet/carved_tablet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include "nazori/geometry/polyline.h"

namespace nazori::tablet {
namespace {

using geometry::GlyphPoint;
using kanji::StrokeEnding;
using kanji::StrokeLine;

constexpr double kMm = 0.001;

StrokeLine line(std::vector<GlyphPoint> points, StrokeEnding ending = StrokeEnding::stop) {
  return {std::move(points), ending, std::nullopt};
}

std::shared_ptr<const CarvedTablet> carved(const std::vector<StrokeLine>& lines, int size = 256,
                                           const carving::Brush& brush = {}) {
  auto tablet = CarvedTablet::from_lines(tablet_lines(lines), size, brush);
  EXPECT_TRUE(tablet) << base::to_line(tablet.error());
  return tablet ? *tablet : nullptr;
}

/// Height of the relief under a point of a path, in metres above the plateau.
double relief_z_m(const CarvedTablet& tablet, const haptics::Vec3& p) {
  const int size = tablet.surface()->size();
  const auto at = geometry::tablet_to_grid({p.x, p.y}, size, tablet.shape());
  return (tablet.surface()->at(at.x, at.y).height - 1) * tablet.shape().depth_m;
}

TEST(CarvedTablet, PathsStartAndEndWhereTheStrokesDoWithTheYAxisUp) {
  // Glyph (10.9, 21.8) is a tenth of the box from the left and a fifth from the top of a 100 mm tablet.
  const auto tablet = carved({line({{10.9, 21.8}, {98.1, 21.8}}), line({{54.5, 0}, {54.5, 109}})});
  ASSERT_EQ(tablet->paths().size(), 2U);
  const auto& first = tablet->paths()[0].points;
  EXPECT_NEAR(first.front().x, -40 * kMm, 1e-12);
  EXPECT_NEAR(first.front().y, 30 * kMm, 1e-12);
  EXPECT_NEAR(first.back().x, 40 * kMm, 1e-12);
  const auto& second = tablet->paths()[1].points;
  EXPECT_NEAR(second.front().y, 50 * kMm, 1e-12);
  EXPECT_NEAR(second.back().y, -50 * kMm, 1e-12);
  EXPECT_NEAR(second.back().x, 0, 1e-12);
}

TEST(CarvedTablet, PathsLieOnTheBottomOfTheGrooveTheyCarved) {
  const auto tablet = carved({line({{20, 30}, {90, 30}, {90, 85}}, StrokeEnding::hook),
                              line({{30, 50}, {70, 95}}, StrokeEnding::taper)},
                             512);
  for (const auto& path : tablet->paths()) {
    for (const auto& p : path.points) {
      // A tenth of the depth: where a sweep is narrower than a sample, the grid cannot represent its depth.
      EXPECT_NEAR(p.z, relief_z_m(*tablet, p), 1.0 * kMm) << p.x << ' ' << p.y;
    }
  }
  const auto& body = tablet->paths()[0].points;
  EXPECT_NEAR(body[body.size() / 4].z, -10 * kMm, 0.2 * kMm);
}

TEST(CarvedTablet, OfACrowdedCharacterThePathsFollowTheNarrowedBrush) {
  // Strokes 5 units apart: a groove of 7 would leave no ridge, so a narrower brush carves them.
  const std::vector<StrokeLine> lines{line({{20, 30}, {90, 30}}), line({{20, 35}, {90, 35}}),
                                      line({{20, 40}, {90, 40}})};
  const carving::Brush narrow = carving::fitted(carving::Brush{}, lines);
  ASSERT_LT(narrow.width, 6);
  const auto tablet = carved(lines, 512);
  for (const auto& p : tablet->paths()[1].points) {
    const double s = (p.x / 0.1 + 0.5) * 109 - 20;
    EXPECT_NEAR(p.z, -0.010 * carving::brush_at(narrow, StrokeEnding::stop, s, 70).depth, 1e-9) << s;
    EXPECT_NEAR(p.z, relief_z_m(*tablet, p), 1.0 * kMm) << s;
  }
}

TEST(CarvedTablet, ATaperRisesToThePlateauAndAStopDoesNot) {
  const auto tablet = carved(
      {line({{20, 30}, {90, 30}}, StrokeEnding::taper), line({{20, 80}, {90, 80}}, StrokeEnding::stop)});
  const auto& taper = tablet->paths()[0].points;
  EXPECT_GT(taper.back().z, -1 * kMm);
  EXPECT_LT(taper[taper.size() / 2].z, -9 * kMm);
  for (std::size_t i = taper.size() * 3 / 4; i + 1 < taper.size(); ++i) {
    EXPECT_LE(taper[i].z, taper[i + 1].z + 1e-12) << i;
  }
  const auto& stop = tablet->paths()[1].points;
  EXPECT_LT(stop[stop.size() - 12].z, -8 * kMm);
}

TEST(CarvedTablet, NeighbouringPointsOfAPathAreCloseEnoughToBeFeltAsOneCurve) {
  const auto tablet = carved({line({{5, 5}, {104, 5}, {104, 104.3}}, StrokeEnding::hook)});
  const auto& points = tablet->paths()[0].points;
  constexpr double kHalfAUnit_m = 0.5 * 0.1 / 109;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_LE(std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y), kHalfAUnit_m + 1e-12);
  }
  // The bend itself is kept and not cut off by equal steps.
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const haptics::Vec3& p) {
    return std::hypot(p.x - (104.0 / 109 - 0.5) * 0.1, p.y - (0.5 - 5.0 / 109) * 0.1) < 1e-12;
  }));
}

TEST(CarvedTablet, APathHasNoMorePointsThanItNeeds) {
  const auto tablet = carved(
      {line({{20, 20}, {90, 20}}), line({{20, 50}, {20.4, 50}}), line({{20, 80}, {20, 80}, {20, 80.6}})});
  EXPECT_EQ(tablet->paths()[0].points.size(), 141U);
  EXPECT_EQ(tablet->paths()[1].points.size(), 2U);
  EXPECT_EQ(tablet->paths()[2].points.size(), 4U) << "a bend between points that are repeated is kept, too";
}

TEST(CarvedTablet, ACurveIsCarvedToItsEndAndStaysWithoutAnEnding) {
  const std::vector<GlyphPoint> points{{20, 30}, {90, 30}};
  const auto curve = *CarvedTablet::from_lines({TabletLine(points)}, 128);
  const auto stops = carved({line(points, StrokeEnding::stop)}, 128);
  const auto sweeps = carved({line(points, StrokeEnding::taper)}, 128);
  EXPECT_FALSE(curve->lines().front().ending);
  EXPECT_EQ(stops->lines().front().ending, StrokeEnding::stop);
  EXPECT_EQ(curve->height_map(), stops->height_map());
  EXPECT_NE(curve->height_map(), sweeps->height_map());
  EXPECT_EQ(curve->paths().front().points, stops->paths().front().points);
}

TEST(CarvedTablet, ThePathsRiseByTheLengthWalkedRoundEveryBend) {
  const std::vector<StrokeLine> lines{line({{20, 30}, {90, 30}, {90, 85}, {84, 80}}, StrokeEnding::hook),
                                      line({{30, 50}, {50, 50}, {50, 95}}, StrokeEnding::taper)};
  const geometry::TabletShape shape{0.3, 0.02};
  const auto tablet = *CarvedTablet::from_lines(tablet_lines(lines), 128, {}, shape);
  const carving::Brush brush = carving::fitted({}, lines);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double hook = carving::hook_length(lines[k]);
    const double length = geometry::arc_length(std::span<const GlyphPoint>(lines[k].points));
    double s = 0;
    const haptics::Vec3* before = nullptr;
    for (const haptics::Vec3& p : tablet->paths()[k].points) {
      if (before != nullptr) s += std::hypot(p.x - before->x, p.y - before->y) / 0.3 * 109;
      before = &p;
      const double depth = carving::brush_at(brush, lines[k].ending, s, length, hook).depth;
      EXPECT_NEAR(p.z, -0.02 * depth, 1e-9) << k << ' ' << s;
    }
    EXPECT_NEAR(s, length, 1e-9);
  }
  EXPECT_EQ(tablet->shape().width_m, 0.3);
  EXPECT_EQ(tablet->shape().depth_m, 0.02);
  EXPECT_EQ(tablet->lines(), tablet_lines(lines));
  EXPECT_EQ(tablet->height_map(), *carving::carve(lines, 128));
  EXPECT_EQ(tablet->friction(), nullptr);
}

TEST(CarvedTablet, ALineWithoutPointsHasAPathWithoutPoints) {
  const auto tablet =
      CarvedTablet::from_height_map(*surface::HeightMap::create(8), {line({}), line({{1, 1}, {2, 1}})});
  ASSERT_TRUE(tablet);
  ASSERT_EQ((*tablet)->paths().size(), 2U);
  EXPECT_TRUE((*tablet)->paths()[0].points.empty());
  EXPECT_EQ((*tablet)->paths()[1].points.size(), 3U);
}

TEST(CarvedTablet, ALongFileOfStrokesDoesNotMakePathsWithoutBound) {
  std::vector<GlyphPoint> zigzag;
  for (int i = 0; i < 60'000; ++i) zigzag.push_back({i % 2 == 0 ? 0.0 : 109.0, 109.0 * i / 60'000});
  auto map = surface::HeightMap::create(16);
  ASSERT_TRUE(map);
  const auto tablet = CarvedTablet::from_height_map(*map, {line(zigzag)});
  ASSERT_TRUE(tablet);
  // 200,000 steps, and each of the 59,999 segments may end with a short one.
  EXPECT_LE((*tablet)->paths()[0].points.size(), 260'000U);
}

TEST(CarvedTablet, OfAHeightMapThePathsLieAsDeepAsTheReliefUnderThem) {
  auto map = surface::HeightMap::create(65);
  ASSERT_TRUE(map);
  // A plane that falls from the plateau on the left to the deepest on the right.
  for (int row = 0; row < 65; ++row) {
    for (int column = 0; column < 65; ++column) map->set(column, row, 1.0F - static_cast<float>(column) / 64);
  }
  const geometry::TabletShape shape{0.2, 0.008};
  const auto tablet = CarvedTablet::from_height_map(*map, {line({{10.9, 50}, {98.1, 50}})}, shape);
  ASSERT_TRUE(tablet) << base::to_line(tablet.error());
  EXPECT_EQ((*tablet)->height_map(), *map);
  EXPECT_EQ((*tablet)->lines(), std::vector<TabletLine>{line({{10.9, 50}, {98.1, 50}})});
  const auto& points = (*tablet)->paths()[0].points;
  for (const auto& p : points) EXPECT_NEAR(p.z, -(p.x / 0.2 + 0.5) * 0.008, 0.05 * kMm);
  EXPECT_NEAR(points.front().x, -80 * kMm, 1e-12);
}

TEST(CarvedTablet, StrokesMayBeNone) {
  auto map = surface::HeightMap::create(8);
  ASSERT_TRUE(map);
  const auto tablet = CarvedTablet::from_height_map(*map, {});
  ASSERT_TRUE(tablet);
  EXPECT_TRUE((*tablet)->paths().empty());
  EXPECT_NE((*tablet)->surface(), nullptr);
}

TEST(CarvedTablet, EachLineKeepsItsNumberEvenADot) {
  const auto tablet = carved({line({{20, 20}, {80, 20}}), line({{50, 50}}), line({{20, 80}, {80, 80}})});
  ASSERT_EQ(tablet->paths().size(), 3U);
  EXPECT_EQ(tablet->paths()[1].points.size(), 1U);
  EXPECT_EQ(tablet->lines().size(), 3U);
}

TEST(CarvedTablet, RefusesWhatCannotBeCarved) {
  const auto check = [](const auto& made, base::Errc code, const std::string& where) {
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, code);
    EXPECT_FALSE(made.error().what.empty());
    EXPECT_EQ(made.error().where, where);
  };
  check(CarvedTablet::from_lines({line({{1, 1}, {2, 2}})}, 1), base::Errc::bad_argument, "size");
  check(CarvedTablet::from_lines({line({{1, 1}, {2, 2}})}, 1'000'000), base::Errc::bad_argument, "size");
  carving::Brush brush;
  brush.width = -3;
  check(CarvedTablet::from_lines({line({{1, 1}, {2, 2}})}, 64, brush), base::Errc::bad_argument,
        "brush.width");
  check(CarvedTablet::from_lines({line({{1, 1}, {2, 2}})}, 64, {}, {0, 0.01}), base::Errc::bad_argument,
        "shape");
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  for (const geometry::TabletShape& shape : {geometry::TabletShape{kEndless, 0.01},
                                             {0.1, kEndless},
                                             {std::nan(""), 0.01},
                                             {0.1, std::nan("")},
                                             {-0.1, 0.01},
                                             {0.1, 0}})
    check(CarvedTablet::from_lines({line({{1, 1}, {2, 2}})}, 64, {}, shape), base::Errc::bad_argument,
          "shape");
  check(CarvedTablet::from_height_map(surface::HeightMap{}, {}), base::Errc::bad_argument, "map");
  auto map = surface::HeightMap::create(8);
  ASSERT_TRUE(map);
  check(CarvedTablet::from_height_map(*map, {}, {0.1, -0.01}), base::Errc::bad_argument, "shape");
  check(CarvedTablet::from_height_map(*map, {line({{1, std::nan("")}})}), base::Errc::bad_argument,
        "stroke 1");
  check(CarvedTablet::from_height_map(*map, {line({{1, 1}}), line({{1, 1}, {kEndless, 1}})}),
        base::Errc::bad_argument, "stroke 2");
}

TEST(CarvedTablet, FrictionHasOneZoneForEachSample) {
  for (const int size : {7, 8, 9}) {
    auto map = surface::HeightMap::create(8);
    ASSERT_TRUE(map);
    const haptics::FrictionZones zones{
        size, std::vector<std::uint8_t>(static_cast<std::size_t>(size) * size, 0), {}};
    const auto tablet =
        CarvedTablet::from_height_map(*map, {}, {}, std::make_shared<haptics::FrictionZones>(zones));
    ASSERT_EQ(tablet.has_value(), size == 8) << size;
    if (!tablet) {
      EXPECT_EQ(tablet.error().where, "friction");
      continue;
    }
    ASSERT_NE((*tablet)->friction(), nullptr);
    EXPECT_EQ((*tablet)->scene({}, {})->friction_zones, (*tablet)->friction());
  }
}

TEST(CarvedTablet, TheSceneIsWhatTheHandFeels) {
  const auto tablet = carved({line({{20, 20}, {80, 20}}), line({{20, 80}, {80, 80}})});
  haptics::Material material;
  material.stiffness = 0.5;
  haptics::Snapping snapping;
  snapping.enabled = true;
  snapping.stroke = 2;
  haptics::Guiding guiding;
  guiding.mode = haptics::GuidingMode::lesson;
  guiding.stroke = 2;
  const auto scene = tablet->scene(material, snapping, guiding);
  EXPECT_EQ(scene->surface, tablet->surface());
  EXPECT_EQ(scene->strokes.size(), 2U);
  EXPECT_EQ(scene->material.stiffness, 0.5);
  EXPECT_TRUE(scene->snapping.enabled);
  EXPECT_EQ(scene->snapping.stroke, 2);
  EXPECT_EQ(scene->guiding.mode, haptics::GuidingMode::lesson);
  EXPECT_EQ(scene->guiding.stroke, 2);
  EXPECT_EQ(tablet->scene(material, snapping)->guiding.mode, haptics::GuidingMode::off);
  EXPECT_EQ(scene->strokes[1].points.size(), tablet->paths()[1].points.size());
  EXPECT_EQ(scene->friction_zones, nullptr);
}

TEST(CarvedTablet, TheSceneHasTheShapeOfTheTablet) {
  const auto tablet = *CarvedTablet::from_height_map(*surface::HeightMap::create(8), {}, {0.2, 0.015});
  EXPECT_EQ(tablet->shape().width_m, 0.2);
  const auto scene = tablet->scene({}, {});
  EXPECT_EQ(scene->shape.width_m, 0.2);
  EXPECT_EQ(scene->shape.depth_m, 0.015);
}

TEST(CarvedTablet, WithABallAtTheTipOnlyWhatIsFeltChanges) {
  auto map = surface::HeightMap::create(64);
  ASSERT_TRUE(map);
  for (int row = 0; row < 64; ++row) map->set(30, row, 0.2F);
  const auto tablet = *CarvedTablet::from_height_map(*map, {});
  EXPECT_EQ(tablet->tip_radius_m(), 0);
  EXPECT_EQ(tablet->scene({}, {})->tip_radius_m, 0);
  const auto ball = tablet->with_tip(0.002);
  ASSERT_TRUE(ball);
  EXPECT_EQ((*ball)->tip_radius_m(), 0.002);
  EXPECT_EQ((*ball)->surface(), tablet->surface());
  EXPECT_EQ((*ball)->height_map(), *map);
  const auto scene = (*ball)->scene({}, {});
  EXPECT_EQ(scene->tip_radius_m, 0.002);
  EXPECT_NE(scene->surface, tablet->surface());
  // Between sharp edges two samples apart it would hang 0.8 mm deep, between rounded ones a little deeper.
  EXPECT_GT(scene->surface->at(30, 30).height, 0.8) << "the ball does not fall into the groove";
  EXPECT_LT(tablet->surface()->at(30, 30).height, 0.7);
  const auto again = (*ball)->with_tip(0);
  ASSERT_TRUE(again);
  EXPECT_EQ((*again)->scene({}, {})->surface, tablet->surface());
  EXPECT_EQ((*again)->tip_radius_m(), 0);
  for (const double radius : {-0.001, 0.0031, std::nan("")}) {
    const auto refused = tablet->with_tip(radius);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, base::Errc::bad_argument);
  }
}

}  // namespace
}  // namespace nazori::tablet
