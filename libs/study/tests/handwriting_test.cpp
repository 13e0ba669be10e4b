// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/handwriting.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <random>

#include "learner_fixture.h"

namespace nazori::study {
namespace {

using test::must;
using test::some_ink;

constexpr int kFarthest = 32'000;  // a thousand units

/// A point in the units in which it is saved.
HandwritingPoint steps(int x, int y, int time_ms, int pressure) {
  return {{x / 32.0, y / 32.0}, time_ms / 1000.0, pressure / 255.0};
}

TEST(Handwriting, ComesBackExactly) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    Handwriting ink;
    int time = 0;
    for (unsigned s = 0; s < random() % 6; ++s) {
      HandwritingStroke stroke;
      for (unsigned i = 0; i < random() % 50; ++i) {
        const auto coordinate = [&] { return static_cast<int>(random() % (2 * kFarthest + 1)) - kFarthest; };
        time += static_cast<int>(random() % 1000);
        const int x = coordinate();
        stroke.push_back(steps(x, coordinate(), time, static_cast<std::uint8_t>(random())));
      }
      ink.push_back(stroke);
    }
    EXPECT_EQ(must(unpack_handwriting(must(pack(ink)))), ink);
  }
}

TEST(Handwriting, IsCompact) {
  // 120 points, 8 ms apart, as from a pen.
  EXPECT_LT(must(pack(some_ink())).size(), 400U);
}

TEST(Handwriting, OfNothingIsNothing) {
  EXPECT_TRUE(must(pack({})).empty());
  EXPECT_TRUE(must(unpack_handwriting({})).empty());
}

TEST(Handwriting, DamagedBytesAreRefused) {
  const std::vector<std::uint8_t> packed = must(pack(some_ink()));
  for (std::size_t i = 0; i < packed.size(); ++i) {
    std::vector<std::uint8_t> bytes = packed;
    bytes[i] ^= 0x5AU;
    EXPECT_FALSE(unpack_handwriting(bytes)) << i;
    EXPECT_FALSE(unpack_handwriting(std::span(packed).first(i)) && i > 0) << i;
  }
}

TEST(Handwriting, WhatCannotBeKeptIsRefused) {
  const Handwriting back{{steps(0, 0, 10, 0), steps(0, 0, 9, 0)}};
  EXPECT_FALSE(pack(back));
  EXPECT_FALSE(pack(Handwriting(101)));
  EXPECT_FALSE(pack(Handwriting{HandwritingStroke(50'001)}));
  EXPECT_FALSE(pack(Handwriting{{steps(kFarthest + 1, 0, 0, 0)}}));
}

TEST(Handwriting, AsMuchAsMayBeKeptIsKept) {
  constexpr int kDay = 86'400'000;  // in milliseconds
  for (const HandwritingPoint& fine :
       {steps(kFarthest, 0, 0, 0), steps(-kFarthest, 0, 0, 0), steps(0, kFarthest, 0, 0),
        steps(0, -kFarthest, 0, 0), steps(0, 0, kDay, 0), steps(0, 0, 0, 255)}) {
    const Handwriting ink{{fine}};
    EXPECT_EQ(must(unpack_handwriting(must(pack(ink)))), ink);
  }
  for (const HandwritingPoint& wrong :
       {steps(kFarthest + 1, 0, 0, 0), steps(-kFarthest - 1, 0, 0, 0), steps(0, kFarthest + 1, 0, 0),
        steps(0, -kFarthest - 1, 0, 0), steps(0, 0, kDay + 1, 0), steps(0, 0, -1, 0)})
    EXPECT_EQ(pack(Handwriting{{wrong}}).error().code, base::Errc::bad_argument);
  const Handwriting strokes(100);
  EXPECT_EQ(must(unpack_handwriting(must(pack(strokes)))), strokes);
  const Handwriting points{HandwritingStroke(20'000, steps(0, 0, 0, 0)),
                           HandwritingStroke(30'000, steps(0, 0, 0, 0))};
  EXPECT_EQ(must(unpack_handwriting(must(pack(points)))), points);
  EXPECT_FALSE(pack(Handwriting{HandwritingStroke(20'000), HandwritingStroke(30'001)}));
  // Time continues across strokes and may stay the same.
  EXPECT_TRUE(pack(Handwriting{{steps(0, 0, 5, 0), steps(1, 0, 5, 0)}, {steps(0, 0, 5, 0)}}));
  EXPECT_FALSE(pack(Handwriting{{steps(0, 0, 5, 0)}, {steps(0, 0, 4, 0)}}));
}

/// Bytes in the layout of pack(), with any numbers.
std::vector<std::uint8_t> packed_by_hand(std::vector<std::uint8_t> plain, std::uint8_t version = 1) {
  uLongf size = compressBound(static_cast<uLong>(plain.size()));
  std::vector<std::uint8_t> bytes(1 + size);
  bytes[0] = version;
  EXPECT_EQ(compress2(&bytes[1], &size, plain.data(), static_cast<uLong>(plain.size()), 9), Z_OK);
  bytes.resize(1 + size);
  return bytes;
}

TEST(Handwriting, IsLaidOutAsTheManualSays) {
  // Strokes, points; then differences of x, y (zigzag), time, pressure (zigzag), as varints.
  const Handwriting ink{{steps(1, -1, 300, 255), steps(0, 63, 300, 254)}, {steps(0, -2, 301, 0)}};
  const std::vector<std::uint8_t> plain{2,    2, 2, 1, 0xAC, 0x02, 0xFE, 0x03, 1,    0x80,
                                        0x01, 0, 1, 1, 0,    0x81, 0x01, 1,    0xFB, 0x03};
  EXPECT_EQ(must(unpack_handwriting(packed_by_hand(plain))), ink);
  EXPECT_EQ(must(pack(ink)), packed_by_hand(plain));
}

TEST(Handwriting, BytesThatPackDoesNotWriteAreRefused) {
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0, 0}, 2))) << "another version";
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0, 0, 0}))) << "a byte too many";
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0}))) << "a byte too few";
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({2, 1, 0, 0, 0, 0}))) << "a stroke too few";
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({101}))) << "too many strokes";
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({})));
  EXPECT_FALSE(unpack_handwriting(std::vector<std::uint8_t>{1}));
  std::vector<std::uint8_t> longer = packed_by_hand({1, 1, 0, 0, 0, 0});
  longer.push_back(0);
  EXPECT_FALSE(unpack_handwriting(longer)) << "something behind its end";
  // Pressure from 0 to 255: zigzag 510 is 255, 512 is 256, 1 is -1.
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0, 0xFE, 0x03})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0, 0x80, 0x04})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0, 1})));
  // x to 32000: zigzag 64000 and, below, 63999; one farther is 64002 and 64001. The same of y.
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({1, 1, 0x80, 0xF4, 0x03, 0, 0, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0x82, 0xF4, 0x03, 0, 0, 0})));
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({1, 1, 0xFF, 0xF3, 0x03, 0, 0, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0x81, 0xF4, 0x03, 0, 0, 0})));
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({1, 1, 0, 0x80, 0xF4, 0x03, 0, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0x82, 0xF4, 0x03, 0, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0x81, 0xF4, 0x03, 0, 0})));
  // Time to 86,400,000 (0x5265C00).
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0x80, 0xB8, 0x99, 0x29, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 1, 0, 0, 0x81, 0xB8, 0x99, 0x29, 0})));
}

TEST(Handwriting, NumbersAreFiveBytesAtMost) {
  // 2^32 - 1 in five bytes is a valid number, though not a valid count of strokes; a sixth byte or more bits
  // are invalid.
  EXPECT_TRUE(unpack_handwriting(packed_by_hand({0x81, 0x80, 0x80, 0x80, 0x00, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({0x81, 0x80, 0x80, 0x80, 0x10, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({0x81, 0x80, 0x80, 0x80, 0x80, 0x00, 0})));
  EXPECT_FALSE(unpack_handwriting(packed_by_hand({1, 0xFF, 0xFF, 0xFF, 0xFF, 0x0F}))) << "points";
  // 50,000 points (0xC350) and one more, all at the same position.
  std::vector<std::uint8_t> most{1, 0xD0, 0x86, 0x03};
  most.resize(most.size() + std::size_t{4} * 50'000);
  EXPECT_TRUE(unpack_handwriting(packed_by_hand(most)));
  std::vector<std::uint8_t> more{1, 0xD1, 0x86, 0x03};
  more.resize(more.size() + std::size_t{4} * 50'001);
  EXPECT_FALSE(unpack_handwriting(packed_by_hand(more)));
  std::vector<std::uint8_t> apart{2, 0xD0, 0x86, 0x03};
  apart.resize(apart.size() + std::size_t{4} * 50'000);
  apart.insert(apart.end(), {1, 0, 0, 0, 0});
  EXPECT_FALSE(unpack_handwriting(packed_by_hand(apart))) << "in two strokes";
}

HandwritingPoint saved(geometry::GlyphPoint at, double time_ms, double pressure) {
  return saved_point({at, time_ms / 1000, pressure});
}

TEST(Handwriting, PointsHalfwayAreRoundedUp) {
  EXPECT_EQ(saved({0.5 / 32, -0.5 / 32}, 0.5, 0.5), steps(1, -1, 1, 128));
  EXPECT_EQ(saved({0.49 / 32, -0.49 / 32}, 0.49, 0.001), steps(0, 0, 0, 0));
  EXPECT_EQ(saved({0, 0}, 1e12, -1), steps(0, 0, 86'400'000, 0));
  EXPECT_EQ(saved({1.5, -0.5}, 0, 0), steps(48, -16, 0, 0));
  EXPECT_EQ(saved_point({}), steps(0, 0, 0, 0));
}

TEST(Handwriting, PointsAreRoundedAndBroughtWithinRange) {
  EXPECT_EQ(saved({1.0, 2.5}, 3.4, 1.0), steps(32, 80, 3, 255));
  EXPECT_EQ(saved({1e9, -1e9}, -1, 7), steps(kFarthest, -kFarthest, 0, 255));
  EXPECT_EQ(saved({NAN, NAN}, NAN, NAN), steps(0, 0, 0, 0));
}

TEST(Handwriting, OfAnyPointsIsSavedAsRounded) {
  const HandwritingStroke stroke{{{1.01, 2.02}, 0.0004, 0.3}, {{1.5, 2.5}, 0.0126}, {{7, -8}, 0.5, 1, 0.25}};
  HandwritingStroke rounded;
  for (const HandwritingPoint& point : stroke) rounded.push_back(saved_point(point));
  EXPECT_EQ(must(unpack_handwriting(must(pack({stroke})))), Handwriting{rounded});
  EXPECT_EQ(must(pack({stroke})), must(pack({rounded})));
  EXPECT_FALSE(pack({{{{NAN, 0}, 0, 0}}}));
  EXPECT_FALSE(pack({{{{0, 0}, NAN, 0}}}));
}

Handwriting line(double seconds, const std::function<double(double)>& place) {
  HandwritingStroke stroke;
  for (double t = 0; t <= seconds; t += 0.004)
    stroke.push_back(saved({50 * place(t / seconds), 0}, t * 1000, 1));
  return {stroke};
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
  Handwriting ink = some_ink();
  for (HandwritingStroke& stroke : ink) {
    for (HandwritingPoint& point : stroke) point.time_s = 0;
  }
  EXPECT_FALSE(motion_of(ink));
  for (HandwritingStroke& stroke : ink) {
    for (HandwritingPoint& point : stroke) point.time_s.reset();
  }
  EXPECT_FALSE(motion_of(ink));
  EXPECT_FALSE(motion_of({}));
}

}  // namespace
}  // namespace nazori::study
