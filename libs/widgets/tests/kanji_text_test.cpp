// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/kanji_text.h"

#include <gtest/gtest.h>

namespace {

using nazori::kanji::split_kun;
using nazori::ui::kun_rich;

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

TEST(KunReading, IsTheSameInTheWindow) {
  EXPECT_EQ(nazori::ui::kun_plain(split_kun("-づか.い")), QStringLiteral("～づか・い"));
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
