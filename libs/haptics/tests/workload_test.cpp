// SPDX-License-Identifier: Apache-2.0
#include "../bench/workload.h"

#include <gtest/gtest.h>

namespace nazori::haptics {
namespace {

TEST(Workload, IsTheAgreedOne) {
  const workload::Kanji kanji = workload::make_kanji(128);
  EXPECT_EQ(workload::checksum(kanji), 0xb19ad546c7ced0a7U);
  EXPECT_EQ(workload::checksum(workload::trace(kanji, 200'000)), 0x4a4aac82dfc69037U);
  EXPECT_EQ(workload::checksum(workload::sweep(kanji, 200'000)), 0x74094b2f65ce5153U);
  EXPECT_EQ(workload::checksum(workload::scribble(kanji, 200'000)), 0xe62d3d094f4a1d9cU);
}

}  // namespace
}  // namespace nazori::haptics
