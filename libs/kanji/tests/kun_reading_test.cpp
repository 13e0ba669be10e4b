// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/kun_reading.h"

#include <gtest/gtest.h>

namespace nazori::kanji {
namespace {

TEST(KunReading, TheDotPartsTheStemFromTheOkurigana) {
  const auto reading = split_kun("やす.む");
  EXPECT_EQ(reading.stem, "やす");
  EXPECT_EQ(reading.okurigana, "む");
  EXPECT_EQ(kun_text(reading), "やす・む");
}

TEST(KunReading, WithoutADotAllOfItIsTheStem) {
  const auto reading = split_kun("ひと");
  EXPECT_EQ(reading.stem, "ひと");
  EXPECT_TRUE(reading.okurigana.empty());
  EXPECT_EQ(kun_text(reading), "ひと");
}

TEST(KunReading, HyphensBecomeWaveDashesOnTheirSide) {
  EXPECT_EQ(kun_text(split_kun("-び")), "～び");
  EXPECT_EQ(kun_text(split_kun("ひと-")), "ひと～");
  EXPECT_EQ(kun_text(split_kun("-づか.い")), "～づか・い");
}

TEST(KunReading, KnowsOnWhichSideItIsJoined) {
  EXPECT_TRUE(split_kun("-び").as_suffix);
  EXPECT_FALSE(split_kun("-び").as_prefix);
  EXPECT_TRUE(split_kun("ひと-").as_prefix);
  EXPECT_FALSE(split_kun("ひと-").as_suffix);
  EXPECT_EQ(split_kun("-び").stem, "び");
  EXPECT_EQ(split_kun("ひと-").stem, "ひと");
}

TEST(KunReading, TextWithoutAReadingIsTakenAsItIs) {
  EXPECT_EQ(split_kun(""), KunReading());
  EXPECT_EQ(split_kun("-"), (KunReading{"", "", true, false}));
  EXPECT_EQ(split_kun("."), KunReading());
}

}  // namespace
}  // namespace nazori::kanji
