// SPDX-License-Identifier: Apache-2.0
// What stands where in the tables to find a character with and in the information about it, and how each part
// is made.
#include <QSignalSpy>
#include <QTest>

#include "characters/confusable_view.h"
#include "characters/glyph_view.h"
#include "characters/information_panel.h"
#include "characters/table_picker.h"
#include "made_widgets.h"
#include "nazori/widgets/words/kanji_text.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;
using test::layout_words;
using test::made_words;

using MadeFinding = test::MadeWidgets;

class MadeTables : public MadeFinding {
 protected:
  static std::shared_ptr<const practice::CharacterTables> tables() {
    return std::make_shared<const practice::CharacterTables>(practice::CharacterTables{
        kanji::PartPicker(
            {{"一", 1, {U'一'}}, {"亻", 2, {U'休'}}, {"木", 4, {U'木', U'休'}}, {"月", 4, {U'月'}}}),
        {{9, "人", {}, {"ひと", "にん"}, "person", 2}, {75, "木", {}, {"き"}, "tree", 4}}});
  }
};

TEST_F(MadeTables, PartsAndRadicalsStandBehindTheirNumbersOfStrokes) {
  TablePicker picker;
  EXPECT_EQ(layout_words(picker).toStdString(), "column 0 0 6 0: QStackedWidget");
  picker.show_tables(tables());
  picker.show_tables(tables());
  const auto content = [&](const char* name) {
    return picker.findChild<QScrollArea*>(QString::fromLatin1(name))->widget();
  };
  EXPECT_EQ(
      layout_words(*content("parts_table")).toStdString(),
      "flow 2 2 2 2 gap 2 2: “1”, table_part_一, “2”, table_part_亻, “4”, table_part_木, table_part_月");
  EXPECT_EQ(layout_words(*content("radicals_table")).toStdString(),
            "flow 2 2 2 2 gap 2 2: “2”, table_radical_9, “4”, table_radical_75");
  const int side = QFontMetrics(textbook_font(QFontInfo(picker.font()).pointSizeF() * 1.2)).height() + 8;
  const std::string fixed =
      QStringLiteral("maximumHeight %1; maximumWidth %1; minimumHeight %1; minimumWidth %1")
          .arg(side)
          .toStdString();
  expect_made(
      picker,
      {{"parts_table",
        "accessibleName Parts by number of strokes; horizontalScrollBarPolicy ScrollBarAlwaysOff; "
        "widgetResizable"},
       {"radicals_table",
        "accessibleName Radicals by number of strokes; hidden; horizontalScrollBarPolicy ScrollBarAlwaysOff; "
        "widgetResizable"},
       {"table_part_木",
        ("accessibleName 木, 4 strokes; checkable; " + letters(1.2) + "; " + fixed + "; role table; text 木")
            .c_str()},
       {"table_radical_9", ("accessibleName 9 人 · ひと にん person; checkable; " + letters(1.2) + "; " +
                            fixed + "; role table; text 人; toolTip 9 人 · ひと にん person")
                               .c_str()}});
  const auto* number = content("parts_table")->findChild<QLabel*>();
  EXPECT_EQ(made_words(*number).toStdString(), "accessibleName 1 stroke; role heading; text 1");
  QFont large = picker.font();
  large.setPointSizeF(2 * QFontInfo(large).pointSizeF());
  picker.setFont(large);
  EXPECT_GT(picker.findChild<QPushButton*>()->minimumWidth(), side) << "with larger letters";
}

TEST_F(MadeTables, TheKeyboardGoesToTheFirstThatIsPossibleAlsoWhereTheTablesComeLater) {
  TablePicker picker;
  picker.show();
  picker.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&picker));
  picker.show_table(TablePicker::kRadicals);
  picker.take_keyboard();
  EXPECT_EQ(qobject_cast<QPushButton*>(picker.focusWidget()), nullptr) << "they are on their way";
  picker.show_tables(tables());
  const auto* person = picker.findChild<QPushButton*>(QStringLiteral("table_radical_9"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return person->hasFocus(); }, 2000));
  kanji::Query query;
  query.parts = {"木"};
  picker.set_query(query);
  picker.show_table(TablePicker::kParts);
  picker.take_keyboard();
  EXPECT_EQ(picker.focusWidget()->objectName(), QStringLiteral("table_part_亻"))
      << "一 is in no character that has 木";
  picker.show_table(TablePicker::kNone);
  EXPECT_TRUE(picker.findChild<QPushButton*>(QStringLiteral("table_part_亻"))->isVisible());
}

kanji::Character other_one(char32_t character) {
  kanji::Character made;
  made.code_point = character;
  made.entry.meanings = {{"fr", "autre"}, {"en", "meaning"}, {"en", "second"}};
  return made;
}

class MadeInformation : public MadeFinding {
 protected:
  static std::shared_ptr<practice::CharacterSheet> sheet() {
    auto made = std::make_shared<practice::CharacterSheet>();
    made->character.code_point = U'休';
    made->character.strokes.resize(6);
    auto& entry = made->character.entry;
    entry.meanings = {{"en", "rest"}};
    entry.on_readings = {"キュウ", "ク"};
    entry.kun_readings = {"やす.む", "やす"};
    made->radical = kanji::Radical{9, "人", {"亻"}, {"ひと"}, "person", 2};
    made->parts = {{"亻", U'人', "人", "person"}, {"木", U'木', "木", "tree"}};
    practice::HelpfulWord word;
    word.word.text = "休日";
    word.word.reading = "きゅうじつ";
    word.meanings = {"holiday"};
    made->helpful.words = {word};
    made->helpful.uses = {{"キュウ", "きゅう", word}};
    return made;
  }
};

TEST_F(MadeInformation, SectionsStandBelowTheGlyphAndItsMeanings) {
  InformationPanel panel;
  expect_laid_out(
      panel,
      {{"information_content",
        "column 16 16 16 16 gap 14: (row: glyph left top, (column gap 6: meanings, facts, stretch*1)*1), "
        "on_section, kun_section, radical_section, parts_section, words_section, confusables_section, "
        "stretch*1"}});
  test::resize_unseen(*panel.viewport(), {700, 500});
  panel.show_character(sheet());
  expect_laid_out(
      panel,
      {{"on_section", "column 0 0 0 0 gap 3: “On'yomi”, (flow gap 14 2: on_reading, on_reading)"},
       {"kun_section", "column 0 0 0 0 gap 3: “Kun'yomi”, (flow gap 14 2: kun_reading, kun_reading)"},
       {"radical_section",
        "column 0 0 0 0 gap 3: “Radical”, (flow gap 8 2: radical_number, radical_form, radical_variant, "
        "radical_name, radical_english)"},
       {"parts_section", "column 0 0 0 0 gap 3: “Parts”, (flow gap 8 8: part_亻, part_木)"},
       {"words_section", "column 0 0 0 0 gap 3: “Words”, (flow: ), (column gap 9: word)"},
       {"confusables_section", "column 0 0 0 0 gap 3: “Easily confused”, (flow: )"}});
}

TEST_F(MadeInformation, EachKindOfTextHasItsSizeAndItsLetters) {
  InformationPanel panel;
  test::resize_unseen(*panel.viewport(), {700, 500});
  panel.show_character(sheet());
  const std::string copied = "cursor IBeamCursor; ";
  const std::string flags = "textInteractionFlags TextSelectableByMouse";
  expect_made(
      panel,
      {{"information_panel",
        "accessibleName About the character; horizontalScrollBarPolicy ScrollBarAlwaysOff; widgetResizable"},
       {"meanings",
        (copied + "letters 1.2; text rest; textFormat PlainText; " + flags + "; wordWrap").c_str()},
       {"facts",
        (copied + "role muted; text 6 strokes; textFormat PlainText; " + flags + "; wordWrap").c_str()},
       {"radical_number", (copied + "text 9; " + flags).c_str()},
       {"radical_form", (copied + letters(1.4) + "; text 人; " + flags).c_str()},
       {"radical_variant", (copied + letters(1.4) + "; text 亻; " + flags).c_str()},
       {"radical_name", (copied + letters(1.1) + "; text ひと; " + flags).c_str()},
       {"radical_english", (copied + "role muted; text person; " + flags).c_str()},
       {"part_亻", ("accessibleName 亻, a form of 人: person; cursor PointingHandCursor; " + letters(1.45) +
                    "; role part; text 亻; toolTip 亻, a form of 人: person. Open this character")
                       .c_str()}});
  const auto* heading = panel.findChild<QWidget*>(QStringLiteral("on_section"))->findChild<QLabel*>();
  EXPECT_EQ(made_words(*heading).toStdString(), "letters 0.9; role heading; text On'yomi; wordWrap");
  const auto readings = panel.findChildren<QLabel*>(QStringLiteral("on_reading"));
  ASSERT_EQ(readings.size(), 2);
  EXPECT_EQ(made_words(*readings[1]).toStdString(), copied + letters(1.25) + "; text ク; " + flags);
  const double points = QFontInfo(panel.font()).pointSizeF();
  EXPECT_EQ(readings[0]->text(), QStringLiteral("キュウ <span style=\"color:%1; font-size:%2pt\">休日</span>")
                                     .arg(current_colours().muted.name())
                                     .arg(points * 0.95));
  EXPECT_EQ(readings[0]->toolTip(), QStringLiteral("Read キュウ, as in 休日 (きゅうじつ)"));
  EXPECT_EQ(readings[0]->accessibleName(), readings[0]->toolTip());
}

TEST_F(MadeInformation, TheGlyphIsAboveWhereLessThanEightLettersAreBesideIt) {
  InformationPanel panel;
  panel.show_character(sheet());
  const int glyph = panel.findChild<GlyphView*>()->sizeHint().width();
  const int needed = 8 * em() + 2 * 16 + glyph + 14;
  const auto laid_out = [&](int width) {
    test::resize_unseen(*panel.viewport(), {width, 500});
    return layout_words(*panel.widget()).left(60).toStdString();
  };
  laid_out(needed + 100);
  EXPECT_TRUE(laid_out(needed).starts_with("column 16 16 16 16 gap 14: (row: glyph")) << laid_out(needed);
  EXPECT_TRUE(laid_out(needed - 1).starts_with("column 8 16 8 16 gap 14: (column: glyph"))
      << laid_out(needed - 1);
}

TEST_F(MadeInformation, WhatIsGivenToItStandsInItsPlace) {
  QWidget window;
  InformationPanel panel;
  auto* head = new QWidget;
  auto* standing = new QWidget;
  head->setObjectName(QStringLiteral("head"));
  standing->setObjectName(QStringLiteral("standing"));
  panel.set_head(head);
  panel.set_standing(standing);
  EXPECT_TRUE(standing->isHidden()) << "there is no character";
  expect_laid_out(panel,
                  {{"information_content",
                    "column 16 16 16 16 gap 14: head, (row: glyph left top, (column gap 6: meanings, facts, "
                    "stretch*1)*1), standing, on_section, kun_section, radical_section, parts_section, "
                    "words_section, confusables_section, stretch*1"}});
  auto* confusables = new ConfusableView({}, &window);
  panel.set_confusables(confusables);
  auto made = sheet();
  panel.show_character(made);
  EXPECT_FALSE(standing->isHidden());
  const auto* section = panel.findChild<QWidget*>(QStringLiteral("confusables_section"));
  EXPECT_TRUE(section->isHidden());
  made->confusables = {other_one(U'体')};
  panel.show_character(made);
  EXPECT_FALSE(section->isHidden());
  QSignalSpy chosen(&panel, &InformationPanel::character_chosen);
  panel.findChild<QPushButton*>(QStringLiteral("confusable_体"))->click();
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.at(0).at(0).value<char32_t>(), U'体');
  panel.set_hidden_character(true);
  EXPECT_TRUE(standing->isHidden());
  EXPECT_TRUE(section->isHidden());
  panel.show_own(QStringLiteral("leaf"), 0, 1);
  EXPECT_EQ(panel.findChild<QLabel*>(QStringLiteral("meanings"))->text(), QStringLiteral("leaf"));
}

}  // namespace
}  // namespace nazori::ui
