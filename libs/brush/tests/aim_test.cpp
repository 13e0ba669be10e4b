// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/aim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nazori::brush {
namespace {

TuftForm medium() { return tuft_form(6, Hair::mixed).value(); }

TEST(Aim, TheFootIsAheadAsFarAsTheHairBends) {
  const TuftForm form = medium();
  Tuft tuft(form);
  std::vector<geometry::BristleSegment> swept;
  Aim aim(form);
  HolderPose above;
  above.depth_m = -0.005;
  tuft.move_to(above, swept);
  // The tip points up to the left, so the foot comes down to the lower right of the pen, farther the deeper.
  double before = 0;
  for (const double depth : {0.0, 1e-13, 0.1, 0.2, 0.3}) {
    Aim fresh(form);
    HolderPose pose;
    pose.at = {0.01, 0.02};
    pose.depth_m = depth * form.hair_m;
    fresh.lead(pose, tuft);
    const geometry::PaperPoint foot = pose.at;
    EXPECT_NEAR(foot.x - 0.01, -(foot.y - 0.02), 1e-9);
    const double lead = geometry::distance(foot, {0.01, 0.02});
    if (depth < 1e-9) {
      EXPECT_NEAR(lead, 0, 1e-12);
    } else {
      EXPECT_GT(lead, before);
    }
    EXPECT_LT(lead, form.hair_m);
    before = lead;
  }
}

}  // namespace
}  // namespace nazori::brush
