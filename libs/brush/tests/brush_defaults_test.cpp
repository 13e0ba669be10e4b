// SPDX-License-Identifier: Apache-2.0
// The default values of the structs of this room, as their headers say them.
#include <gtest/gtest.h>

#include "nazori/brush/force_table.h"
#include "nazori/brush/pen.h"
#include "nazori/brush/tuft.h"

namespace nazori::brush {
namespace {

TEST(BrushDefaults, AHairIsEvenAndBendsALittleToOneSide) {
  const SpineForm form;
  EXPECT_EQ(form.segments, 6);
  EXPECT_EQ(form.tip_segment, 1);
  EXPECT_EQ(form.taper, 1);
  EXPECT_EQ(form.thickness, 0);
  EXPECT_EQ(form.bulge, 4);
  EXPECT_EQ(form.taper_power, 2);
  EXPECT_EQ(form.own_bend_rad, 0.005);
  EXPECT_EQ(Spine::kMostSegments, 24);
  EXPECT_EQ(Spine::kStep, 0.02);
  EXPECT_EQ(Spine::kTurn_rad, 0.05);
  EXPECT_EQ(Spine::kMostSteps, 64);
  EXPECT_EQ(Spine::kTouching, 1e-3);
}

TEST(BrushDefaults, NothingRubs) {
  const SpineFriction friction;
  for (const double value : {friction.paper, friction.along_hair, friction.yield_rad, friction.keeps_rad,
                             friction.inner_share, friction.inner_rad})
    EXPECT_EQ(value, 0);
  EXPECT_EQ(friction.exponent, 1);
  EXPECT_EQ(friction.sideways, 300);
  const SpinePose pose;
  for (const double value : {pose.root.x, pose.root.z, pose.tilt_rad}) EXPECT_EQ(value, 0);
}

TEST(BrushDefaults, ATuftHasNoSizeAndAPenIsDownAndUpright) {
  const TuftForm form;
  for (const double value :
       {form.shaft_m, form.hair_m, form.root_radius_m, form.stiffness_n_m2, form.holds_m3})
    EXPECT_EQ(value, 0);
  const TuftSection section;
  for (const double value :
       {section.at.x, section.at.y, section.z_m, section.rise_rad, section.half_width_m, section.thickness_m})
    EXPECT_EQ(value, 0);
  const PenSample pen;
  EXPECT_TRUE(pen.down);
  EXPECT_FALSE(pen.pressure.has_value());
  EXPECT_FALSE(pen.height_m.has_value());
  for (const double value : {pen.time_s, pen.at.x, pen.at.y, pen.lean_rad, pen.lean_to_rad, pen.twist_rad})
    EXPECT_EQ(value, 0);
}

TEST(BrushDefaults, ForcesAndSizesAreThoseOfTheHeaders) {
  EXPECT_EQ(kTouchPressure, 0.3);
  EXPECT_EQ(kLowestRoot, 0.15);
  EXPECT_EQ(kThickestBrush, 1);
  EXPECT_EQ(kThinnestBrush, 6);
  EXPECT_EQ(Tuft::kBristles, 400);
  EXPECT_EQ(Tuft::kMostLean_rad, 1.1);
  EXPECT_EQ(Tuft::kMostDepth, 0.6);
  EXPECT_EQ(ForceTable::kDepthStep, 0.01);
  EXPECT_EQ(ForceTable::kDeepest, 0.6);
  EXPECT_EQ(ForceTable::kLeanStep_rad, 0.1);
  EXPECT_EQ(ForceTable::kMostLean_rad, 1.1);
  EXPECT_EQ(kStrengthened, 4);
  EXPECT_EQ(kMostStrengthened_n, 1);
  EXPECT_EQ(kMostTrue_n, 0.5);
}

}  // namespace
}  // namespace nazori::brush
