// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/sample_ring.h"

#include <gtest/gtest.h>

#include <memory>

namespace nazori::haptics {
namespace {

ServoSample numbered(std::uint64_t n) {
  ServoSample sample;
  sample.tick = n;
  return sample;
}

TEST(SampleRing, HoldsEverySampleInItsOrderAndCountsIt) {
  const auto ring = std::make_unique<SampleRing>();
  for (std::uint64_t n = 0; n < 5; ++n) {
    ring->push(numbered(100 + n));
    EXPECT_EQ(ring->pushed, n + 1);
    EXPECT_EQ(ring->slots[n].tick, 100 + n);
  }
  EXPECT_EQ(ring->lost, 0U);
}

TEST(SampleRing, FullItLosesTheNewestAndKeepsWhatNobodyTook) {
  const auto ring = std::make_unique<SampleRing>();
  for (std::uint64_t n = 0; n < SampleRing::kCapacity; ++n) ring->push(numbered(n));
  EXPECT_EQ(ring->lost, 0U);
  ring->push(numbered(1'000'000));
  ring->push(numbered(1'000'001));
  EXPECT_EQ(ring->lost, 2U);
  EXPECT_EQ(ring->pushed, SampleRing::kCapacity);
  EXPECT_EQ(ring->slots[0].tick, 0U);
  ring->taken = 1;  // one was stored elsewhere: its slot is free
  ring->push(numbered(2'000'000));
  EXPECT_EQ(ring->slots[0].tick, 2'000'000U);
  EXPECT_EQ(ring->pushed, SampleRing::kCapacity + 1);
  ring->push(numbered(2'000'001));
  EXPECT_EQ(ring->lost, 3U);
}

}  // namespace
}  // namespace nazori::haptics
