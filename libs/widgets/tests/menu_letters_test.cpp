// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/menu_letters.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "print_qt.h"

namespace nazori::ui {
namespace {

QStringList given(const QStringList& texts) {
  std::vector<std::unique_ptr<QAction>> made;
  QList<QAction*> entries;
  for (const QString& text : texts) {
    made.push_back(std::make_unique<QAction>(text));
    made.back()->setSeparator(text == QStringLiteral("-"));
    entries.append(made.back().get());
  }
  give_own_letters(entries);
  QStringList after;
  for (const auto& entry : made) after.append(entry->text());
  return after;
}

TEST(GiveOwnLetters, LeavesLettersThatDiffer) {
  const QStringList menu{"&New", "&Open…", "-", "S&ave as…", "Keep && &go"};
  EXPECT_EQ(given(menu), menu);
}

TEST(GiveOwnLetters, TheSecondEntryGetsTheFirstFreeLetterOfAWordOrElseAnyOther) {
  EXPECT_EQ(given({"&New", "&Name and details"}), (QStringList{"&New", "Name &and details"}));
  EXPECT_EQ(given({"&New", "&Ask", "&Draw", "Name and details"}),
            (QStringList{"&New", "&Ask", "&Draw", "Na&me and details"}));
  EXPECT_EQ(given({"&Again", "A&gain", "Again"}), (QStringList{"&Again", "A&gain", "Aga&in"}));
  EXPECT_EQ(given({"&new", "&New", "-", "N&ew"}), (QStringList{"&new", "Ne&w", "-", "N&ew"}))
      << "a capital is the same letter, and a letter of a later entry is not free";
}

TEST(GiveOwnLetters, WithoutAFreeLetterOneStandsInBrackets) {
  EXPECT_EQ(given({"&Go", "&On", "&No", "Go on"}), (QStringList{"&Go", "&On", "&No", "Go on (&A)"}));
  EXPECT_EQ(given({"開く(&O)…", "保存(&O)…", "終了"}), (QStringList{"開く(&O)…", "保存(&A)…", "終了(&B)"}));
}

TEST(GiveOwnLetters, AnAmpersandThatIsShownIsNoMark) {
  EXPECT_EQ(given({"Ink && &paper", "&Paper"}), (QStringList{"Ink && &paper", "P&aper"}));
  EXPECT_EQ(given({"A && B"}), (QStringList{"&A && B"}));
}

TEST(GiveOwnLetters, TheTwentySeventhEntryHasNone) {
  QStringList menu;
  for (char letter = 'A'; letter <= 'Z'; ++letter) menu.append(QStringLiteral("&%1").arg(letter));
  menu.append("Again");
  EXPECT_EQ(given(menu).last(), "Again");
}

}  // namespace
}  // namespace nazori::ui
