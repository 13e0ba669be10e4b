// SPDX-License-Identifier: Apache-2.0
// Rows of a search, the tables of parts and radicals, standing and confusable characters, with made-up data.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "characters/character_list_model.h"
#include "characters/confusable_view.h"
#include "characters/drill_dialog.h"
#include "characters/search_words.h"
#include "characters/standing_bar.h"
#include "characters/table_picker.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

class SearchRows : public testing::Test {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }

  static practice::SearchRow row(kanji::Reason reason, const std::string& text) {
    practice::SearchRow made;
    made.character = {U'休', "rest", "やす.む", 6, 1};
    made.reason = reason;
    made.text = text;
    return made;
  }
  static practice::SearchRow word() {
    auto made = row(kanji::Reason::reading, "");
    made.word = practice::FoundWord{"休日", "きゅうじつ", {"holiday", "day off"}};
    return made;
  }
};

TEST_F(SearchRows, SayWhyTheyAreFound) {
  using kanji::Reason;
  EXPECT_EQ(SearchWords::why(row(Reason::reading, "やす.まる")), QStringLiteral("やす・まる · rest"));
  EXPECT_EQ(SearchWords::why(row(Reason::name, "のぶ")), QStringLiteral("in names: のぶ · rest"));
  EXPECT_EQ(SearchWords::why(row(Reason::meaning, "day off")), QStringLiteral("day off · やす・む"));
  EXPECT_EQ(SearchWords::why(row(Reason::condition, "")), QStringLiteral("やす・む · rest · 6 strokes"));
  EXPECT_EQ(SearchWords::why(word()), QStringLiteral("きゅうじつ · holiday; day off"));
  EXPECT_EQ(SearchWords::head(word()), QStringLiteral("休日"));
  EXPECT_EQ(SearchWords::head(row(Reason::itself, "")), QStringLiteral("休"));
}

TEST_F(SearchRows, OpenTheirCharacterAndTellItsStrength) {
  CharacterListModel model;
  auto answer = std::make_shared<practice::SearchAnswer>();
  answer->rows = {word(), row(kanji::Reason::itself, "")};
  model.set_strengths([](char32_t) { return study::Strength::mature; });
  model.set_answer(answer);
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(model.at(0), U'休');
  EXPECT_EQ(model.row_of(U'休'), 1) << "a word is not the character";
  EXPECT_EQ(model.row_of(U'日'), -1);
  EXPECT_FALSE(model.data(model.index(0), CharacterListModel::kStrengthRole).isValid());
  EXPECT_EQ(model.data(model.index(1), CharacterListModel::kStrengthRole).toInt(),
            static_cast<int>(study::Strength::mature));
  EXPECT_FALSE(model.data(model.index(1), CharacterListModel::kWhyRole).toString().isEmpty());
  model.set_characters(std::make_shared<const std::vector<kanji::Summary>>(
      std::vector<kanji::Summary>{{U'木', "tree", "き", 4, 1}}));
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_TRUE(model.data(model.index(0), CharacterListModel::kWhyRole).toString().isEmpty());
  EXPECT_EQ(model.data(model.index(0), Qt::AccessibleTextRole).toString(),
            QStringLiteral("木, tree, き, well known"));
}

TEST_F(SearchRows, PartsThatAreImpossibleAreGrey) {
  TablePicker picker;
  picker.show_tables(std::make_shared<const practice::CharacterTables>(practice::CharacterTables{
      kanji::PartPicker({{"亻", 2, {U'休'}}, {"木", 4, {U'木', U'休'}}, {"月", 4, {U'月'}}}),
      {{9, "人", {}, {"ひと"}, "person", 2}, {75, "木", {}, {"き"}, "tree", 4}}}));
  const auto part = [&picker](const char* name) {
    return picker.findChild<QPushButton*>(QStringLiteral("table_part_") + QString::fromUtf8(name));
  };
  QSignalSpy chosen(&picker, &TablePicker::parts_chosen);
  part("木")->click();
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.at(0).at(0).toString(), QStringLiteral("木"));
  kanji::Query query;
  query.parts = {"木"};
  query.radical = 75;
  picker.set_query(query);
  EXPECT_TRUE(part("木")->isChecked());
  EXPECT_TRUE(part("亻")->isEnabled());
  EXPECT_FALSE(part("月")->isEnabled());
  EXPECT_EQ(part("亻")->accessibleName(), QStringLiteral("亻, 2 strokes"));
  part("亻")->click();
  EXPECT_EQ(chosen.at(1).at(0).toString(), QStringLiteral("木亻"));
  part("木")->click();
  EXPECT_EQ(chosen.at(2).at(0).toString(), QString()) << "it is taken back";
  auto* tree = picker.findChild<QPushButton*>(QStringLiteral("table_radical_75"));
  auto* person = picker.findChild<QPushButton*>(QStringLiteral("table_radical_9"));
  EXPECT_TRUE(tree->isChecked());
  EXPECT_EQ(person->accessibleName(), QStringLiteral("9 人 · ひと person"));
  QSignalSpy radical(&picker, &TablePicker::radical_chosen);
  person->click();
  EXPECT_EQ(radical.at(0).at(0).toInt(), 9);
  person->click();
  EXPECT_EQ(radical.at(1).at(0).toInt(), 0);
}

TEST_F(SearchRows, StandingSaysStrengthAndWhenItComes) {
  practice::CharacterStanding standing;
  EXPECT_EQ(StandingBar::words(standing), QStringLiteral("not studied"));
  standing.strength = study::Strength::mature;
  standing.comes_again = true;
  standing.card.memory.phase = study::Phase::review;
  standing.card.due_day = standing.today + std::chrono::days(12);
  standing.recall = 0.96;
  EXPECT_EQ(StandingBar::words(standing),
            QStringLiteral("● well known · comes again in 12 days · 96% likely to be remembered"));
  standing.is_due = true;
  EXPECT_EQ(StandingBar::words(standing),
            QStringLiteral("● well known · due today · 96% likely to be remembered"));
}

TEST_F(SearchRows, ConfusableCharactersStandSideBySide) {
  ConfusableView view({}, nullptr);
  practice::CharacterSheet sheet;
  sheet.character.code_point = U'土';
  kanji::Character other;
  other.code_point = U'士';
  other.entry.meanings = {{"en", "gentleman"}};
  sheet.confusables = {other};
  view.show_sheet(sheet);
  QSignalSpy chosen(&view, &ConfusableView::character_chosen);
  auto* picture = view.findChild<QPushButton*>(QStringLiteral("confusable_士"));
  ASSERT_NE(picture, nullptr);
  EXPECT_NE(view.findChild<QPushButton*>(QStringLiteral("confusable_土")), nullptr);
  EXPECT_EQ(picture->accessibleName(), QStringLiteral("士, gentleman"));
  picture->click();
  EXPECT_EQ(chosen.at(0).at(0).value<char32_t>(), U'士');
}

TEST_F(SearchRows, ADrillAsksUntilAllAreToldApart) {
  DrillDialog dialog({{U'待', "wait", "ま.つ", {}}, {U'持', "hold", "も.つ", {}}}, 1, nullptr);
  const auto text = [&dialog](const char* name) {
    return dialog.findChild<QLabel*>(QString::fromLatin1(name))->text();
  };
  auto* wait = dialog.findChild<QPushButton*>(QStringLiteral("drill_choice_1"));
  auto* hold = dialog.findChild<QPushButton*>(QStringLiteral("drill_choice_2"));
  auto* write = dialog.findChild<QPushButton*>(QStringLiteral("drill_write"));
  EXPECT_EQ(text("drill_progress"), QStringLiteral("1 of 6"));
  EXPECT_FALSE(write->isEnabled());
  const auto right = [&] { return text("drill_meaning") == QStringLiteral("wait") ? wait : hold; };
  (right() == wait ? hold : wait)->click();
  EXPECT_TRUE(text("drill_verdict").startsWith(QStringLiteral("✗ It is ")));
  for (int i = 0; i < 6; ++i) {
    right()->click();
    EXPECT_TRUE(text("drill_verdict").startsWith(QStringLiteral("✓ Correct"))) << i;
  }
  EXPECT_EQ(text("drill_meaning"), QStringLiteral("6 of 7 right"));
  EXPECT_FALSE(wait->isEnabled());
  EXPECT_TRUE(write->isEnabled());
  EXPECT_FALSE(dialog.wants_to_write());
  write->click();
  EXPECT_TRUE(dialog.wants_to_write());
}

}  // namespace
}  // namespace nazori::ui
