// SPDX-License-Identifier: Apache-2.0
// The hand trajectories of the benchmark, watched for what other renderers get wrong on them.
#include "../bench/workload.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "nazori/haptics/surface_contact.h"

namespace nazori::haptics {
namespace {

constexpr double kMetresPerUnit = 0.05;

TEST(Workload, IsTheAgreedOne) {
  const workload::Kanji kanji = workload::make_kanji(128);
  EXPECT_EQ(workload::checksum(kanji), 0xb19ad546c7ced0a7U);
  EXPECT_EQ(workload::checksum(workload::trace(kanji, 200'000)), 0x4a4aac82dfc69037U);
  EXPECT_EQ(workload::checksum(workload::sweep(kanji, 200'000)), 0x74094b2f65ce5153U);
  EXPECT_EQ(workload::checksum(workload::scribble(kanji, 200'000)), 0xe62d3d094f4a1d9cU);
}

TEST(Workload, TheProxyIsNeverLeftHangingBehindARidge) {
  const workload::Kanji kanji = workload::make_kanji(128);
  const auto smooth = *surface::SmoothSurface::create(workload::height_map(kanji));
  const TabletSurface tablet(*smooth, workload::shape());
  for (const auto& units : {workload::trace(kanji, 200'000), workload::sweep(kanji, 200'000),
                            workload::scribble(kanji, 200'000)}) {
    const std::vector<Vec3> path = workload::to_metres(units);
    SurfaceContact contact;
    int behind = 0, below = 0, late = 0;
    for (const Vec3& device : path) {
      contact.update(tablet, device, {});
      const double depth = tablet.height(device.x, device.y) - device.z;
      late += (depth > 0) != contact.touching() ? 1 : 0;
      behind += glm::length(contact.proxy_m() - device) > 0.05 * kMetresPerUnit ? 1 : 0;
      const Vec3& p = contact.proxy_m();
      below += p.z < tablet.height(p.x, p.y) - 1e-15 ? 1 : 0;
    }
    EXPECT_EQ(behind, 0);
    EXPECT_EQ(below, 0);
    EXPECT_EQ(late, 0);
  }
}

}  // namespace
}  // namespace nazori::haptics
