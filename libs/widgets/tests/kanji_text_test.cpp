// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/kanji_text.h"

#include <gtest/gtest.h>

#include <QFontDatabase>
#include <QFontInfo>
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "nazori/widgets/words/line_stretch.h"
#include "print_qt.h"

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

TEST(KanjiText, TextsAreJoinedFromTheFirstOnUpToTheMostThatFit) {
  const std::vector<std::string> all{"休", "b", "c"};
  const QString between = QStringLiteral(" - ");
  EXPECT_EQ(nazori::ui::joined(all, between), QStringLiteral("休 - b - c"));
  EXPECT_EQ(nazori::ui::joined(all, between, 2), QStringLiteral("休 - b"));
  EXPECT_EQ(nazori::ui::joined(all, between, 3), QStringLiteral("休 - b - c"));
  EXPECT_EQ(nazori::ui::joined(all, between, 0), QString());
  EXPECT_EQ(nazori::ui::joined({}, between), QString());
}

TEST(KanjiText, AFormThatSomebodyMadeIsWrittenInItsOwnFont) {
  using nazori::ui::character_font;
  nazori::ui::set_own_forms(QStringLiteral("Own forms"), {U'休', U'木'});
  const QFont own = character_font(QStringLiteral("木"), 14, QFont::DemiBold);
  EXPECT_EQ(own.family(), QStringLiteral("Own forms"));
  EXPECT_EQ(own.pointSizeF(), 14);
  EXPECT_EQ(own.weight(), QFont::DemiBold);
  for (const char* other : {"日", "休木", ""})
    EXPECT_EQ(character_font(QString::fromUtf8(other), 14).family(), QStringLiteral("Klee One")) << other;
  nazori::ui::set_own_forms({}, {});
  EXPECT_EQ(character_font(QStringLiteral("木"), 14).family(), QStringLiteral("Klee One"));
  EXPECT_EQ(character_font(QStringLiteral("木"), 14).weight(), QFont::Normal);
}

TEST(KanjiText, ATextbookHasKanjiAndNoHieroglyphs) {
  // Without the font it has nothing at all.
  EXPECT_FALSE(nazori::ui::textbook_font_has(0x13080));
  EXPECT_EQ(nazori::ui::textbook_font_has(U'休'), QFontDatabase::hasFamily(QStringLiteral("Klee One")));
}

/// Lines of letters that are as high as those of an alphabet need no more room; higher ones need their share.
TEST(LineStretch, IsTheHeightOfALineOverTheUsualOneButAtLeastOne) {
  for (const char* family : {"DejaVu Sans", "Noto Sans CJK JP", "Klee One", "Nimbus Sans"}) {
    QFont font(QString::fromLatin1(family));
    font.setPixelSize(40);
    const double em = QFontInfo(font).pixelSize();
    // A line of Latin letters, in the font itself.
    const double high = std::ceil(QFontMetricsF(font).ascent()) + std::ceil(QFontMetricsF(font).descent());
    EXPECT_NEAR(nazori::ui::line_stretch(font), std::max(1.0, high / (1.2 * em)), 1 / em) << family;
    EXPECT_GE(nazori::ui::line_stretch(font), 1) << family;
  }
}

}  // namespace
