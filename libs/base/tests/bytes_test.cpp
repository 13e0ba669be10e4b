// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/bytes.h"

#include <gtest/gtest.h>

namespace nazori::base {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Bytes, NumbersBeginWithTheirLeastByte) {
  ByteWriter out;
  out.u8(0x01);
  out.u16(0x0302);
  out.u32(0x07060504);
  out.i64(0x0F0E0D0C0B0A0908);
  EXPECT_EQ(out.bytes(), (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

TEST(Bytes, FloatingPointNumbersAreThoseOfIeee754) {
  ByteWriter out;
  out.f32(1.5F);
  out.f64(-2);
  EXPECT_EQ(out.bytes(), (Bytes{0, 0, 0xC0, 0x3F, 0, 0, 0, 0, 0, 0, 0, 0xC0}));
}

TEST(Bytes, WhatIsWrittenIsReadAgain) {
  ByteWriter out;
  out.u8(200);
  out.u16(60000);
  out.u32(4000000000U);
  out.i32(-5);
  out.i64(-6000000000);
  out.f32(0.1F);
  out.f64(1e300);
  out.text("永");
  out.count(1);
  out.raw(Bytes{9});
  ByteReader in(out.bytes());
  EXPECT_EQ(in.u8(), 200);
  EXPECT_EQ(in.u16(), 60000);
  EXPECT_EQ(in.u32(), 4000000000U);
  EXPECT_EQ(in.i32(), -5);
  EXPECT_EQ(in.i64(), -6000000000);
  EXPECT_EQ(in.f32(), 0.1F);
  EXPECT_EQ(in.f64(), 1e300);
  EXPECT_EQ(in.text(), "永");
  EXPECT_EQ(in.count(1), 1U);
  EXPECT_EQ(in.left(), 1U);
  EXPECT_TRUE(in.ok());
  EXPECT_EQ(in.u8(), 9);
  EXPECT_EQ(in.left(), 0U);
}

TEST(Bytes, BehindTheEndEverythingIsZeroForEver) {
  const Bytes three{1, 2, 3};
  ByteReader in(three);
  EXPECT_EQ(in.u32(), 0U);
  EXPECT_FALSE(in.ok());
  EXPECT_EQ(in.left(), 0U);
  EXPECT_EQ(in.u8(), 0);
  EXPECT_TRUE(in.take(0).empty());
  EXPECT_FALSE(in.ok());
}

TEST(Bytes, ACountThatTheRestCannotHoldIsNone) {
  const Bytes bytes{2, 0, 0, 0, 7, 7, 7, 7};
  EXPECT_EQ(ByteReader(bytes).count(2), 2U);
  ByteReader in(bytes);
  EXPECT_EQ(in.count(3), 0U);
  EXPECT_FALSE(in.ok());
}

TEST(Bytes, ATextThatIsTooLongIsNone) {
  const Bytes bytes{3, 0, 0, 0, 'a', 'b'};
  ByteReader in(bytes);
  EXPECT_EQ(in.text(), "");
  EXPECT_FALSE(in.ok());
}

}  // namespace
}  // namespace nazori::base
