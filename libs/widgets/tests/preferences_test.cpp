// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/settings/preferences.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace {

using nazori::ui::Preferences;
using nazori::ui::ThemeChoice;

TEST(Preferences, WhatIsSavedIsReadAgain) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("a/nazori.ini"));
  Preferences p;
  p.geometry = QByteArray("\x01\x00\x7f", 3);
  p.pane_widths = {240, 340};
  p.kanji = U'𠮟';
  p.list = nazori::kanji::List::katakana;
  p.left_open = false;
  p.strokes_visible = false;
  p.numbers_visible = false;
  p.snapping = true;
  p.style = nazori::view::Style::classic;
  p.theme = ThemeChoice::dark;
  p.text_pt = 20;
  p.reduced_motion = true;
  p.language = QStringLiteral("ja");
  p.profile = QStringLiteral("花子");
  p.begin_at_home = false;
  p.asks_by_words = false;
  p.left_handed = true;
  p.one_hand = nazori::ui::OneHand::right;
  p.speaks = false;
  p.voice = QStringLiteral("open-jtalk");
  p.voice_file = folder.filePath(QStringLiteral("声.htsvoice"));
  p.folder = folder.filePath(QStringLiteral("漢字"));
  ASSERT_TRUE(p.save(file));
  const auto read = Preferences::load(file);
  EXPECT_EQ(read.geometry, p.geometry);
  EXPECT_EQ(read.pane_widths, p.pane_widths);
  EXPECT_EQ(read.kanji, U'𠮟');
  EXPECT_EQ(read.list, nazori::kanji::List::katakana);
  EXPECT_FALSE(read.left_open);
  EXPECT_TRUE(read.right_open);
  EXPECT_FALSE(read.strokes_visible);
  EXPECT_FALSE(read.numbers_visible);
  EXPECT_TRUE(read.snapping);
  EXPECT_EQ(read.style, nazori::view::Style::classic);
  EXPECT_EQ(read.theme, ThemeChoice::dark);
  EXPECT_EQ(read.text_pt, 20);
  EXPECT_TRUE(read.reduced_motion);
  EXPECT_EQ(read.language, QStringLiteral("ja"));
  EXPECT_EQ(read.profile, p.profile);
  EXPECT_FALSE(read.begin_at_home);
  EXPECT_FALSE(read.asks_by_words);
  EXPECT_TRUE(read.left_handed);
  EXPECT_EQ(read.one_hand, nazori::ui::OneHand::right);
  EXPECT_FALSE(read.speaks);
  EXPECT_EQ(read.voice, p.voice);
  EXPECT_EQ(read.voice_file, p.voice_file);
  EXPECT_EQ(read.folder, p.folder);
}

TEST(Preferences, EachOneIsKeptByItself) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("nazori.ini"));
  using Flag = bool Preferences::*;
  const Flag flags[] = {
      &Preferences::left_open,       &Preferences::right_open,     &Preferences::strokes_visible,
      &Preferences::numbers_visible, &Preferences::arrows_visible, &Preferences::snapping,
      &Preferences::groove_sound,    &Preferences::slope_help,     &Preferences::reduced_motion,
      &Preferences::asks_by_words,   &Preferences::left_handed,    &Preferences::begin_at_home};
  for (const Flag turned : flags) {
    Preferences p;
    p.*turned = !(p.*turned);
    ASSERT_TRUE(p.save(file));
    const auto read = Preferences::load(file);
    for (const Flag flag : flags) EXPECT_EQ(read.*flag, p.*flag);
  }
  Preferences p;
  p.sound_volume = 0.3;
  p.page = QStringLiteral("functions");
  p.text_pt = 14;
  ASSERT_TRUE(p.save(file));
  const auto read = Preferences::load(file);
  EXPECT_EQ(read.sound_volume, 0.3);
  EXPECT_EQ(read.page, p.page);
  EXPECT_EQ(read.text_pt, 14);
}

TEST(Preferences, EveryChoiceOfARowIsKeptUnderAWordOfItsOwn) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("nazori.ini"));
  for (int i = 0; i < 12; ++i) {
    Preferences p;
    p.list = static_cast<nazori::kanji::List>(i);
    p.style = static_cast<nazori::view::Style>(i % 3);
    p.theme = static_cast<ThemeChoice>(i % 3);
    p.one_hand = static_cast<nazori::ui::OneHand>(i % 3);
    ASSERT_TRUE(p.save(file));
    const auto read = Preferences::load(file);
    EXPECT_EQ(read.list, p.list) << i;
    EXPECT_EQ(read.style, p.style) << i;
    EXPECT_EQ(read.theme, p.theme) << i;
    EXPECT_EQ(read.one_hand, p.one_hand) << i;
  }
}

TEST(Preferences, NumbersAreHeldWithinWhatTheyCanBe) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("nazori.ini"));
  const auto read = [&](const char* text) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    return Preferences::load(path);
  };
  EXPECT_EQ(read("[sound]\nvolume=1.3\n").sound_volume, 1);
  EXPECT_EQ(read("[sound]\nvolume=-1\n").sound_volume, 0);
  EXPECT_EQ(read("[window]\ntext_pt=5\n").text_pt, 12);
  EXPECT_EQ(read("[window]\ntext_pt=29\n").text_pt, 28);
  EXPECT_EQ(read("[window]\npane_widths=-5,300\n").pane_widths, (QList<int>{0, 300}));
  EXPECT_TRUE(read("[window]\npane_widths=300\n").pane_widths.isEmpty());
  EXPECT_EQ(read("[window]\nlanguage=en\n").language, QStringLiteral("en"));
}

TEST(Preferences, AFileOfNonsenseGivesTheDefaults) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("nazori.ini"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      "[tablet]\nkanji=too long\nstyle=marble\n[window]\ntext_pt=900\ntheme=pink\nlanguage=xx\n"
      "pane_widths=1,2,3\n[library]\nlist=moon\n\xff\xfe\x00junk");
  file.close();
  const auto read = Preferences::load(path);
  EXPECT_EQ(read.kanji, U'休');
  EXPECT_EQ(read.style, nazori::view::Style::wood);
  EXPECT_EQ(read.text_pt, Preferences::kMaxText_pt);
  EXPECT_EQ(read.theme, ThemeChoice::desktop);
  EXPECT_TRUE(read.language.isEmpty());
  EXPECT_TRUE(read.pane_widths.isEmpty());
  EXPECT_EQ(read.list, nazori::kanji::List::grade_1);
}

TEST(Preferences, AMissingFileGivesTheDefaults) {
  const auto read = Preferences::load(QStringLiteral("/nonexistent/nazori.ini"));
  EXPECT_EQ(read.kanji, U'休');
  EXPECT_TRUE(read.left_open && read.right_open);
  EXPECT_TRUE(read.strokes_visible && read.numbers_visible && read.arrows_visible);
  EXPECT_FALSE(read.snapping || read.groove_sound || read.slope_help);
  EXPECT_EQ(read.sound_volume, 0.5);
  EXPECT_EQ(read.text_pt, 12);
  EXPECT_FALSE(read.reduced_motion || read.left_handed);
  EXPECT_TRUE(read.asks_by_words && read.begin_at_home);
  EXPECT_EQ(read.profile, QStringLiteral("learner"));
  EXPECT_EQ(read.one_hand, nazori::ui::OneHand::none);
  EXPECT_EQ(read.theme, ThemeChoice::desktop);
}

TEST(Preferences, AFolderThatCannotBeWrittenIsReported) {
  EXPECT_FALSE(Preferences().save(QStringLiteral("/proc/nazori/nazori.ini")));
}

}  // namespace
