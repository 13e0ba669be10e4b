// SPDX-License-Identifier: Apache-2.0
// What the panel shows of a character that the test makes up.
#include "characters/information_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTextDocument>

#include "window/language.h"

namespace nazori::ui {
namespace {

class InformationPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    install_language(QStringLiteral("en"));
    panel_.resize(700, 500);
    panel_.show();
  }
  static std::shared_ptr<practice::CharacterSheet> sheet(char32_t character, std::size_t strokes = 2) {
    auto made = std::make_shared<practice::CharacterSheet>();
    made->character.code_point = character;
    made->character.strokes.resize(strokes);
    return made;
  }
  void show(const std::shared_ptr<practice::CharacterSheet>& sheet) { panel_.show_character(sheet); }
  QString text(const char* name) { return panel_.findChild<QLabel*>(QString::fromLatin1(name))->text(); }
  QStringList texts(const char* name) {
    QStringList all;
    for (const auto* label : panel_.findChildren<QLabel*>(QString::fromLatin1(name)))
      if (!label->isHidden()) all.append(label->text());
    return all;
  }
  bool has(const char* section) {
    return !panel_.findChild<QWidget*>(QString::fromLatin1(section) + QStringLiteral("_section"))->isHidden();
  }
  InformationPanel panel_;
};

TEST_F(InformationPanelTest, WithoutMeaningsItSaysWhatKindOfLetterItIs) {
  const std::pair<char32_t, const char*> kinds[] = {
      {0x3040, "No meaning given"}, {0x3041, "Hiragana"},        {0x309F, "Hiragana"},
      {0x30A0, "Katakana"},         {0x30FF, "Katakana"},        {0x3100, "No meaning given"},
      {0x24F, "Letter or digit"},   {0x250, "No meaning given"}, {0xFF00, "No meaning given"},
      {0xFF01, "Letter or digit"},  {0xFF5E, "Letter or digit"}, {0xFF5F, "No meaning given"},
      {U'休', "No meaning given"}};
  for (const auto& [character, words] : kinds) {
    show(sheet(character));
    EXPECT_EQ(text("meanings").toStdString(), words) << std::hex << static_cast<std::uint32_t>(character);
  }
}

TEST_F(InformationPanelTest, MeaningsAreThoseOfTheLanguageElseEnglish) {
  auto made = sheet(U'休');
  made->character.entry.meanings = {{"en", "rest"}, {"fr", "repos"}, {"en", "day off"}};
  show(made);
  EXPECT_EQ(text("meanings"), QStringLiteral("rest, day off"));
  QLocale::setDefault(QLocale(QStringLiteral("fr_FR")));
  show(made);
  EXPECT_EQ(text("meanings"), QStringLiteral("repos"));
  QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
  show(made);
  EXPECT_EQ(text("meanings"), QStringLiteral("rest, day off"));
  install_language(QStringLiteral("en"));
}

TEST_F(InformationPanelTest, FactsAreStrokesGradeRankAndLevel) {
  auto made = sheet(U'休', 6);
  const auto facts = [&](const std::function<void(kanji::DictionaryEntry&)>& what) {
    made->character.entry = {};
    what(made->character.entry);
    show(made);
    return text("facts").toStdString();
  };
  EXPECT_EQ(facts([](auto&) {}), "6 strokes");
  EXPECT_EQ(facts([](auto& e) { e.stroke_counts = {6, 7}; }), "6 strokes");
  EXPECT_EQ(facts([](auto& e) { e.stroke_counts = {7, 6}; }), "6 strokes here, 7 in the dictionary");
  EXPECT_EQ(facts([](auto& e) { e.grade = 6; }), "6 strokes · grade 6");
  EXPECT_EQ(facts([](auto& e) { e.grade = 8; }), "6 strokes · secondary school");
  EXPECT_EQ(facts([](auto& e) { e.grade = 9; }), "6 strokes · used in names");
  EXPECT_EQ(facts([](auto& e) {
              e.grade = 1;
              e.frequency = 1204;
              e.old_jlpt_level = 3;
            }),
            "6 strokes · grade 1 · newspaper frequency: no. 1,204 · old JLPT level 3");
}

TEST_F(InformationPanelTest, AnOwnTabletHasItsNameSizeAndStrokes) {
  show(sheet(U'休'));
  panel_.show_own(QStringLiteral("leaf.png"), 512, 3);
  EXPECT_EQ(text("meanings"), QStringLiteral("leaf.png"));
  EXPECT_EQ(text("facts"), QStringLiteral("Your own tablet · 512 × 512 samples · 3 strokes"));
  EXPECT_TRUE(panel_.findChild<QWidget*>(QStringLiteral("glyph"))->isHidden());
  panel_.show_own(QStringLiteral("leaf.str"), 0, 1);
  EXPECT_EQ(text("facts"), QStringLiteral("Your own tablet · 1 stroke"));
}

TEST_F(InformationPanelTest, SectionsAreThereWhereTheyHaveSomething) {
  auto made = sheet(U'休');
  show(made);
  for (const char* name : {"on", "kun", "radical", "parts", "words"}) EXPECT_FALSE(has(name)) << name;
  made->character.entry.on_readings = {"キュウ"};
  show(made);
  EXPECT_TRUE(has("on"));
  EXPECT_FALSE(has("kun"));
  made->character.entry = {};
  made->character.entry.kun_readings = {"やす.む", "やす"};
  show(made);
  EXPECT_FALSE(has("on"));
  EXPECT_TRUE(has("kun"));
  QStringList tips;
  for (const auto* label : panel_.findChildren<QLabel*>(QStringLiteral("kun_reading")))
    if (!label->isHidden()) tips.append(label->toolTip());
  EXPECT_EQ(tips, (QStringList{QStringLiteral("The kanji is read やす; む follows in kana (okurigana)"),
                               QString()}));
}

TEST_F(InformationPanelTest, TheFormOfTheRadicalThatIsInTheCharacterIsNamed) {
  auto made = sheet(U'休');
  made->radical = kanji::Radical{9, "人", {"亻", "𠆢"}, {"ひと", "にんべん"}, "person", 2};
  show(made);
  EXPECT_EQ(texts("radical_variant"), QStringList());
  made->parts = {{"亻", U'人', "人", "person"}, {"木", U'木', "", "tree"}};
  show(made);
  EXPECT_TRUE(has("radical"));
  EXPECT_EQ(texts("radical_number"), QStringList{QStringLiteral("9")});
  EXPECT_EQ(texts("radical_form"), QStringList{QStringLiteral("人")});
  EXPECT_EQ(texts("radical_variant"), QStringList{QStringLiteral("亻")});
  EXPECT_EQ(texts("radical_name"), (QStringList{QStringLiteral("ひと"), QStringLiteral("にんべん")}));
  EXPECT_EQ(texts("radical_english"), QStringList{QStringLiteral("person")});
}

TEST_F(InformationPanelTest, PartsLeadOnWhereTheyCan) {
  auto made = sheet(U'休');
  made->parts = {{"亻", U'人', "人", "person"}, {"木", U'木', "木", ""}, {"𠂉", 0, "", ""}};
  show(made);
  const auto part = [this](const char* element) {
    QPushButton* found = nullptr;
    for (auto* button :
         panel_.findChildren<QPushButton*>(QStringLiteral("part_") + QString::fromUtf8(element)))
      if (!button->isHidden()) found = button;
    return found;
  };
  EXPECT_EQ(part("亻")->accessibleName(), QStringLiteral("亻, a form of 人: person"));
  EXPECT_EQ(part("亻")->toolTip(), QStringLiteral("亻, a form of 人: person. Open this character"));
  EXPECT_EQ(part("木")->accessibleName(), QStringLiteral("木"));
  EXPECT_EQ(part("𠂉")->toolTip(), QStringLiteral("𠂉"));
  EXPECT_TRUE(part("木")->isEnabled());
  EXPECT_FALSE(part("𠂉")->isEnabled());
  QSignalSpy chosen(&panel_, &InformationPanel::character_chosen);
  part("亻")->click();
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.at(0).at(0).value<char32_t>(), U'人');
}

TEST_F(InformationPanelTest, AWordHasItsReadingAndMeanings) {
  auto made = sheet(U'休');
  practice::HelpfulWord word;
  word.word.text = "休日";
  word.word.reading = "きゅうじつ";
  word.meanings = {"holiday", "day < off", "rest"};
  practice::HelpfulWord kana;
  kana.word.text = kana.word.reading = "やすみ";
  kana.meanings = {"rest"};
  kana.cost = 1;
  made->helpful.words = {word, kana};
  show(made);
  QStringList spoken;
  for (const auto* label : panel_.findChildren<QLabel*>(QStringLiteral("word")))
    if (!label->isHidden()) spoken.append(label->accessibleName());
  EXPECT_EQ(spoken, (QStringList{QStringLiteral("休日, きゅうじつ, holiday; day < off; rest"),
                                 QStringLiteral("やすみ, , rest")}));
  QTextDocument text;
  text.setHtml(texts("word").front());
  EXPECT_EQ(text.toPlainText().replace(QChar::Nbsp, QLatin1Char(' ')).simplified(),
            QStringLiteral("休日 きゅうじつ holiday; day < off; rest"));
}

TEST_F(InformationPanelTest, AKanjiOfAWordOpensIt) {
  auto made = sheet(U'休');
  practice::HelpfulWord word;
  word.word.text = "休み日";
  made->helpful.words = {word};
  show(made);
  QSignalSpy chosen(&panel_, &InformationPanel::character_chosen);
  auto* label = panel_.findChild<QLabel*>(QStringLiteral("word"));
  EXPECT_TRUE(label->text().contains(QStringLiteral("<a href=\"日\"")));
  EXPECT_FALSE(label->text().contains(QStringLiteral("<a href=\"み\""))) << "kana are not links";
  emit label->linkActivated(QStringLiteral("日"));
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.at(0).at(0).value<char32_t>(), U'日');
}

TEST_F(InformationPanelTest, WordsOfKnownKanjiComeFirst) {
  auto made = sheet(U'木');
  practice::HelpfulWord unknown;
  unknown.word.text = "木造";
  unknown.others = {U'造'};
  practice::HelpfulWord known;
  known.word.text = "大木";
  known.others = {U'大'};
  known.cost = 1;
  made->helpful.words = {unknown, known};
  panel_.set_knows([](char32_t c) { return c == U'大'; });
  show(made);
  EXPECT_TRUE(
      panel_.findChild<QLabel*>(QStringLiteral("word"))->accessibleName().startsWith(QStringLiteral("大木")));
}

TEST_F(InformationPanelTest, WhatIsToBeRememberedIsHidden) {
  auto made = sheet(U'休');
  made->character.entry.meanings = {{"en", "rest"}};
  made->character.entry.on_readings = {"キュウ"};
  made->radical = kanji::Radical{9, "人", {}, {"ひと"}, "person", 2};
  made->parts = {{"木", U'木', "", "tree"}};
  practice::HelpfulWord word;
  word.word.text = "休日";
  made->helpful.words = {word};
  made->helpful.uses = {{"キュウ", "きゅう", word}};
  show(made);
  EXPECT_TRUE(texts("on_reading").front().contains(QStringLiteral("休日"))) << "a word shows the reading";
  const auto* glyph = panel_.findChild<QWidget*>(QStringLiteral("glyph"));
  for (const bool hidden : {true, false, true}) {
    panel_.set_hidden_character(hidden);
    EXPECT_EQ(glyph->isHidden(), hidden);
    EXPECT_EQ(text("meanings"), QStringLiteral("rest"));
    EXPECT_TRUE(has("on"));
    EXPECT_EQ(texts("on_reading").front().contains(QStringLiteral("休日")), !hidden);
    for (const char* name : {"radical", "parts", "words"}) EXPECT_EQ(has(name), !hidden) << name;
  }
}

TEST_F(InformationPanelTest, AnotherCharacterIsReadFromTheTop) {
  auto made = sheet(U'休');
  for (int i = 0; i < 300; ++i) made->parts.push_back({"木" + std::to_string(i), U'木', "", "tree"});
  show(made);
  QTest::qWait(0);
  auto* bar = panel_.verticalScrollBar();
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar->maximum() > 100; }));
  bar->setValue(100);
  panel_.refresh();
  EXPECT_EQ(bar->value(), 100) << "the same character";
  show(sheet(U'木'));
  EXPECT_EQ(bar->value(), 0);
}

TEST_F(InformationPanelTest, InANarrowPanelTheGlyphStandsAboveTheMeanings) {
  auto made = sheet(U'休');
  made->character.entry.meanings = {{"en", "rest"}};
  show(made);
  const auto* glyph = panel_.findChild<QWidget*>(QStringLiteral("glyph"));
  const auto* meanings = panel_.findChild<QLabel*>(QStringLiteral("meanings"));
  panel_.resize(700, 500);
  QCoreApplication::processEvents();
  EXPECT_GT(meanings->x(), glyph->geometry().right());
  panel_.resize(200, 500);
  QCoreApplication::processEvents();
  EXPECT_GT(meanings->y(), glyph->geometry().bottom());
}

}  // namespace
}  // namespace nazori::ui
