// SPDX-License-Identifier: Apache-2.0
#include "../src/stroke_measures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nazori::devices {
namespace {

/// Along x, 10 mm long.
StrokeMeasures along_x() { return StrokeMeasures({{0, 0}, {0.01, 0}}); }

haptics::ServoSample at(double x_m, double y_m, double z_m, bool touching, int stroke = 0) {
  haptics::ServoSample sample;
  sample.proxy_m = {x_m, y_m, z_m};
  sample.touching = touching;
  sample.stroke = stroke;
  return sample;
}

FollowedStroke report(const StrokeMeasures& measures, double length_m = 0.01) {
  FollowedStroke followed;
  followed.length_m = length_m;
  measures.report_to(followed);
  return followed;
}

TEST(StrokeMeasures, AreMeansAndPeaksOverTheTicks) {
  StrokeMeasures measures = along_x();
  // Four ticks: two in contact, 1 and 2 mm off the line and 2 and 5 mm deep; then two in the air, far away.
  measures.add(2, {0.002, 0.003}, 0, at(0.002, 0.001, -0.002, true, 2), {3, 0, 4});
  measures.add(2, {0.004, 0.001}, 1, at(0.004, -0.002, -0.005, true, 1), {0, 1, 0});
  measures.add(2, {0.006, 0.001}, 2, at(0.008, 0.02, 0.01, false, 2), {0, 0, 0});
  measures.add(2, {0.008, 0.001}, 0, at(0.009, 0.03, 0.01, false, 2), {0, 0, 0});
  const FollowedStroke found = report(measures);
  EXPECT_DOUBLE_EQ(found.aim_rms_m, 0.001 * std::sqrt((9 + 1 + 1 + 1) / 4.0));
  EXPECT_DOUBLE_EQ(found.aim_max_m, 0.003);
  EXPECT_DOUBLE_EQ(found.tip_rms_m, 0.001 * std::sqrt((1 + 4) / 2.0)) << "only during contact";
  EXPECT_DOUBLE_EQ(found.tip_max_m, 0.002);
  EXPECT_DOUBLE_EQ(found.mean_force_n, (5 + 1) / 4.0);
  EXPECT_DOUBLE_EQ(found.peak_force_n, 5);
  EXPECT_DOUBLE_EQ(found.contact_share, 0.5);
  EXPECT_DOUBLE_EQ(found.snapped_share, 0.75) << "the second tick was held by stroke 1";
  EXPECT_DOUBLE_EQ(found.mean_depth_m, 0.0035);
  EXPECT_EQ(found.slips, 3);
  EXPECT_DOUBLE_EQ(found.followed_share, 0.4) << "as far as the tip touched";
}

TEST(StrokeMeasures, ATipOfThreeMillimetresAsideDoesNotFollowTheLine) {
  StrokeMeasures measures = along_x();
  measures.add(1, {0, 0}, 0, at(0.003, 0.00299, -0.002, true), {});
  measures.add(1, {0, 0}, 0, at(0.007, 0.00301, -0.002, true), {});
  measures.add(1, {0, 0}, 0, at(0.001, 0, -0.002, true), {});
  EXPECT_DOUBLE_EQ(report(measures).followed_share, 0.3);
  // The line ends, and the share with it.
  measures.add(1, {0, 0}, 0, at(0.012, 0, -0.002, true), {});
  EXPECT_DOUBLE_EQ(report(measures).followed_share, 1);
  EXPECT_DOUBLE_EQ(report(measures, 0.009).followed_share, 1);
}

TEST(StrokeMeasures, ADotIsFollowedWhereItWasTouchedAndNothingIsKnownWithoutTicks) {
  StrokeMeasures dot({{0, 0}});
  dot.add(1, {0, 0}, 0, at(0, 0, 0.01, false), {});
  EXPECT_EQ(report(dot, 0).followed_share, 0);
  EXPECT_EQ(report(dot, 0).mean_depth_m, 0);
  dot.add(1, {0, 0}, 0, at(0, 0, -0.001, true), {});
  EXPECT_EQ(report(dot, 0).followed_share, 1);

  const FollowedStroke none = report(along_x());
  EXPECT_EQ(none.contact_share, 0);
  EXPECT_EQ(none.followed_share, 0);
}

TEST(StrokeMeasures, TheDistanceIsThatFromTheNearestPointOfTheLine) {
  const StrokeMeasures measures = along_x();
  EXPECT_DOUBLE_EQ(measures.off_m({0.005, -0.002}), 0.002);
  EXPECT_DOUBLE_EQ(measures.off_m({0.013, 0.004}), 0.005);
}

}  // namespace
}  // namespace nazori::devices
