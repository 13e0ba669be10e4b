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

TEST(KunReading, EveryMarkOfAReadingIsMutedAndItsSignsAreNoMarkup) {
  EXPECT_EQ(
      kun_rich(split_kun("-<び-"), QColor(0x102030)),
      QStringLiteral("<span style=\"color:#102030\">～</span>&lt;び<span style=\"color:#102030\">～</span>"));
  EXPECT_EQ(kun_rich(split_kun("ひと"), QColor(0x102030)), QStringLiteral("ひと"));
}

TEST(KunReading, TellsOnWhichSideItIsJoined) {
  EXPECT_TRUE(split_kun("-び").as_suffix);
  EXPECT_FALSE(split_kun("-び").as_prefix);
  EXPECT_TRUE(split_kun("ひと-").as_prefix);
  EXPECT_FALSE(split_kun("ひと-").as_suffix);
  EXPECT_EQ(split_kun("-び").stem, QStringLiteral("び"));
  EXPECT_EQ(split_kun("ひと-").stem, QStringLiteral("ひと"));
}

TEST(KanjiText, ACharacterBeyondTheFirstPlaneIsWhole) {
  EXPECT_EQ(nazori::ui::to_text(U'𠮟'), QString::fromUtf8("𠮟"));
  EXPECT_EQ(nazori::ui::to_text("休日").size(), 2);
}

TEST(KanjiText, TheTextbookFaceHasTheSizeThatIsAskedForButAtLeastAPoint) {
  EXPECT_EQ(nazori::ui::textbook_font(14, QFont::DemiBold).pointSizeF(), 14);
  EXPECT_EQ(nazori::ui::textbook_font(14, QFont::DemiBold).weight(), QFont::DemiBold);
  EXPECT_EQ(nazori::ui::textbook_font(0).pointSizeF(), 1);
  EXPECT_EQ(nazori::ui::textbook_font(14).family(), QStringLiteral("Klee One"));
}

}  // namespace
