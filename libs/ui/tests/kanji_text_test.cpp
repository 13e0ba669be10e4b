// SPDX-License-Identifier: Apache-2.0
#include "kanji_text.h"

#include <gtest/gtest.h>

namespace {

using nazori::ui::kun_plain;
using nazori::ui::kun_rich;
using nazori::ui::split_kun;

TEST(KunReading, TheDotPartsTheStemFromTheOkurigana) {
  const auto reading = split_kun("やす.む");
  EXPECT_EQ(reading.stem, QStringLiteral("やす"));
  EXPECT_EQ(reading.okurigana, QStringLiteral("む"));
  EXPECT_EQ(kun_plain(reading), QStringLiteral("やす・む"));
}

TEST(KunReading, WithoutADotAllOfItIsTheStem) {
  const auto reading = split_kun("ひと");
  EXPECT_EQ(reading.stem, QStringLiteral("ひと"));
  EXPECT_TRUE(reading.okurigana.isEmpty());
  EXPECT_EQ(kun_plain(reading), QStringLiteral("ひと"));
}

TEST(KunReading, HyphensBecomeWaveDashesOnTheirSide) {
  EXPECT_EQ(kun_plain(split_kun("-び")), QStringLiteral("～び"));
  EXPECT_EQ(kun_plain(split_kun("ひと-")), QStringLiteral("ひと～"));
  EXPECT_EQ(kun_plain(split_kun("-づか.い")), QStringLiteral("～づか・い"));
}

TEST(KunReading, OnlyTheOkuriganaIsMuted) {
  const QString rich = kun_rich(split_kun("やす.まる"), QColor(0x625C52));
  EXPECT_EQ(rich, QStringLiteral("やす<span style=\"color:#625c52\">・まる</span>"));
}

}  // namespace
