// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/ink.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "learner_fixture.h"

namespace nazori::study {
namespace {

using test::must;
using test::some_ink;

TEST(Ink, ComesBackExactly) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    Ink ink;
    int time = 0;
    for (unsigned s = 0; s < random() % 6; ++s) {
      InkStroke stroke;
      for (unsigned i = 0; i < random() % 50; ++i) {
        const auto coordinate = [&] {
          return static_cast<std::int32_t>(random() % (2 * InkPoint::kFarthest + 1)) - InkPoint::kFarthest;
        };
        time += static_cast<int>(random() % 1000);
        stroke.push_back({coordinate(), coordinate(), time, static_cast<std::uint8_t>(random())});
      }
      ink.strokes.push_back(stroke);
    }
    EXPECT_EQ(must(unpack_ink(must(pack(ink)))), ink);
  }
}

TEST(Ink, IsCompact) {
  // 120 points: 8 ms apart, as a pen gives them.
  EXPECT_LT(must(pack(some_ink())).size(), 400U);
}

TEST(Ink, OfNothingIsNothing) {
  EXPECT_TRUE(must(pack({})).empty());
  EXPECT_TRUE(must(unpack_ink({})).strokes.empty());
}

TEST(Ink, DamagedBytesAreRefused) {
  const std::vector<std::uint8_t> packed = must(pack(some_ink()));
  for (std::size_t i = 0; i < packed.size(); ++i) {
    std::vector<std::uint8_t> bytes = packed;
    bytes[i] ^= 0x5AU;
    EXPECT_FALSE(unpack_ink(bytes)) << i;
    EXPECT_FALSE(unpack_ink(std::span(packed).first(i)) && i > 0) << i;
  }
}

TEST(Ink, WhatCannotBeKeptIsRefused) {
  Ink back{{{{0, 0, 10, 0}, {0, 0, 9, 0}}}};
  EXPECT_FALSE(pack(back));
  EXPECT_FALSE(pack(Ink{std::vector<InkStroke>(101)}));
  EXPECT_FALSE(pack(Ink{{InkStroke(50'001)}}));
  EXPECT_FALSE(pack(Ink{{{{InkPoint::kFarthest + 1, 0, 0, 0}}}}));
}

TEST(Ink, PointsAreRoundedAndBroughtWithinRange) {
  EXPECT_EQ(ink_point({1.0, 2.5}, 3.4, 1.0), (InkPoint{32, 80, 3, 255}));
  EXPECT_EQ(ink_point({1e9, -1e9}, -1, 7), (InkPoint{InkPoint::kFarthest, -InkPoint::kFarthest, 0, 255}));
  EXPECT_EQ(ink_point({NAN, NAN}, NAN, NAN), InkPoint{});
}

Ink line(double seconds, const std::function<double(double)>& place) {
  InkStroke stroke;
  for (double t = 0; t <= seconds; t += 0.004)
    stroke.push_back(ink_point({50 * place(t / seconds), 0}, t * 1000, 1));
  return {{stroke}};
}

TEST(PenMotion, SpeedIsLengthByTime) {
  const auto motion = motion_of(line(0.5, [](double s) { return s; }));
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->speed, 100, 1.5);
}

TEST(PenMotion, MinimumJerkIsSmootherThanHesitation) {
  // Flash and Hogan's minimum-jerk profile is the smoothest reach; halting twice is less smooth.
  const auto reach = [](double s) { return s * s * s * (10 + s * (6 * s - 15)); };
  const auto halting = [&](double s) { return (std::floor(s * 3) + reach(s * 3 - std::floor(s * 3))) / 3; };
  const auto smooth = motion_of(line(0.8, reach));
  const auto rough = motion_of(line(0.8, [&](double s) { return s >= 1 ? 1 : halting(s); }));
  ASSERT_TRUE(smooth && rough);
  EXPECT_GT(smooth->smoothness, rough->smoothness + 0.2);
  // Published for such a reach: -1.4 (with the normalisation of 2015).
  EXPECT_NEAR(smooth->smoothness, -1.4, 0.1);
}

TEST(PenMotion, OfInkWithoutTimesIsUnknown) {
  Ink ink = some_ink();
  for (InkStroke& stroke : ink.strokes) {
    for (InkPoint& point : stroke) point.time_ms = 0;
  }
  EXPECT_FALSE(motion_of(ink));
  EXPECT_FALSE(motion_of({}));
}

}  // namespace
}  // namespace nazori::study
