// SPDX-License-Identifier: Apache-2.0
#include <QPushButton>

#include "window_under_test.h"

namespace nazori::ui {
namespace {

using Information = WindowTest;

TEST_F(Information, TellsMeaningsReadingsGradeAndStrokesOfKyuu) {
  EXPECT_TRUE(text("meanings").startsWith(QStringLiteral("rest, day off"))) << text("meanings").toStdString();
  EXPECT_TRUE(text("facts").contains(QStringLiteral("6 strokes"))) << text("facts").toStdString();
  EXPECT_TRUE(text("facts").contains(QStringLiteral("grade 1")));
  ASSERT_EQ(texts("on_reading").size(), 1);
  EXPECT_TRUE(texts("on_reading")[0].startsWith(QStringLiteral("キュウ <span")));
  EXPECT_TRUE(texts("on_reading")[0].contains(QStringLiteral("休日"))) << "a word that has the reading";
}

TEST_F(Information, SetsTheOkuriganaApart) {
  QStringList spoken;
  for (const auto* label : window_->findChildren<QLabel*>(QStringLiteral("kun_reading")))
    if (!label->isHidden()) spoken.append(label->accessibleName());
  EXPECT_EQ(spoken, (QStringList{QStringLiteral("Read やす・む, as in 休む (やすむ)"),
                                 QStringLiteral("やす・まる"), QStringLiteral("やす・める")}));
  const auto shown = texts("kun_reading");
  ASSERT_FALSE(shown.isEmpty());
  EXPECT_TRUE(shown.front().contains(QStringLiteral("・む</span>"))) << shown.front().toStdString();
}

TEST_F(Information, NamesTheRadical) {
  EXPECT_EQ(text("radical_number"), QStringLiteral("9"));
  EXPECT_EQ(text("radical_form"), QStringLiteral("人"));
  const QStringList names = texts("radical_name");
  ASSERT_FALSE(names.isEmpty());
  EXPECT_EQ(names.front(), QStringLiteral("ひと"));
  EXPECT_TRUE(names.contains(QStringLiteral("にんべん")));
  EXPECT_EQ(text("radical_english"), QStringLiteral("person"));
}

TEST_F(Information, AClickOnAPartGoesThere) {
  auto* tree = find<QPushButton>("part_木");
  if (tree == nullptr) tree = window_->findChild<QPushButton*>(QStringLiteral("part_木"));
  ASSERT_NE(tree, nullptr);
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  tree->click();
  ASSERT_TRUE(shown.wait(20000));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("木 – Nazori"));
  EXPECT_TRUE(text("meanings").startsWith(QStringLiteral("tree")));
}

TEST_F(Information, ShowsWordsWithReadingsAndMeanings) {
  QStringList words;
  for (const auto* label : window_->findChildren<QLabel*>(QStringLiteral("word")))
    words.append(label->accessibleName());
  EXPECT_LE(words.size(), 6);
  const QString all = words.join(QLatin1Char('\n'));
  EXPECT_TRUE(all.contains(QStringLiteral("休日")));
  EXPECT_TRUE(all.contains(QStringLiteral("きゅうじつ")));
  EXPECT_TRUE(all.contains(QStringLiteral("休む")));
}

TEST_F(Information, GivesBothCountsWhereTheSourcesDiffer) {
  // KanjiVG writes 堵 with the dot, KANJIDIC2 counts it without.
  show(U'堵');
  EXPECT_TRUE(text("facts").contains(QStringLiteral("12 strokes here, 11 in the dictionary")))
      << text("facts").toStdString();
}

TEST_F(Information, KanaHaveNoDictionaryEntryAndSayWhatTheyAre) {
  show(U'あ');
  EXPECT_EQ(text("meanings"), QStringLiteral("Hiragana"));
  EXPECT_TRUE(texts("on_reading").isEmpty());
  EXPECT_TRUE(text("facts").contains(QStringLiteral("3 strokes")));
}

TEST_F(Information, ACharacterWithoutStrokesKeepsTheTablet) {
  window_->show_character(U'☃');
  EXPECT_TRUE(QTest::qWaitFor([this] { return feedback().contains(QStringLiteral("☃")); }, 5000));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("休 – Nazori"));
}

}  // namespace
}  // namespace nazori::ui
