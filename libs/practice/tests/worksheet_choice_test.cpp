// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/worksheet_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "learner_under_test.h"
#include "nazori/author/collection.h"

namespace nazori::practice {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool draws_all(char32_t) { return true; }

TEST(CharactersOfText, AreItsKanjiOnceInTheirOrder) {
  EXPECT_THAT(characters_of_text("休日は、休む。ABC 日々", draws_all), ElementsAre(U'休', U'日', U'々'));
}

TEST(CharactersOfText, AreItsKanaWhereItHasNoKanji) {
  EXPECT_THAT(characters_of_text("あい　う\nあ", draws_all), ElementsAre(U'あ', U'い', U'う'));
}

TEST(CharactersOfText, AreOnlyThoseWithStrokes) {
  EXPECT_THAT(characters_of_text("休日", [](char32_t c) { return c == U'日'; }), ElementsAre(U'日'));
  EXPECT_THAT(characters_of_text("\xFF\xFE", draws_all), IsEmpty());
}

TEST(WorksheetChoices, AreStoredAndReadBack) {
  WorksheetChoice choice;
  choice.source = WorksheetSource::text;
  choice.list = "list:street";
  choice.text = "休日\n二行";
  auto& sheet = choice.sheet;
  sheet.layout = print::Layout::cards;
  sheet.paper = print::Paper::letter;
  sheet.guide = print::Guide::diagonals;
  sheet.language = print::Language::japanese;
  sheet.cell_mm = 22.5;
  sheet.rows = 3;
  sheet.copies = 7;
  sheet.per_sheet = 6;
  sheet.whole_page = true;
  sheet.vertical = true;
  sheet.steps = false;
  sheet.numbers = false;
  sheet.arrows = false;
  sheet.facts = false;
  sheet.answers = true;
  sheet.booklet = true;
  sheet.name_line = false;
  sheet.title = "三年一組";
  base::Settings settings;
  save_choice(settings, choice);
  EXPECT_EQ(load_choice(settings, {}), choice);
  // The opposite of every switch.
  for (bool print::SheetSettings::*flag :
       {&print::SheetSettings::whole_page, &print::SheetSettings::vertical, &print::SheetSettings::steps,
        &print::SheetSettings::numbers, &print::SheetSettings::arrows, &print::SheetSettings::facts,
        &print::SheetSettings::answers, &print::SheetSettings::booklet, &print::SheetSettings::name_line})
    sheet.*flag = !(sheet.*flag);
  save_choice(settings, choice);
  EXPECT_EQ(load_choice(settings, {}), choice);
}

TEST(WorksheetChoices, WhatIsMissingOrWrongKeepsItsValue) {
  WorksheetChoice fallback;
  fallback.list = "grade-3";
  fallback.sheet.rows = 5;
  fallback.sheet.title = "Week 3";
  EXPECT_EQ(load_choice({}, fallback), fallback);
  const base::Settings wrong{{"layout", "poster"}, {"cell_mm", "1000"}, {"rows", "-3"}, {"copies", "400"}};
  const WorksheetChoice read = load_choice(wrong, fallback);
  EXPECT_EQ(read.sheet.layout, print::Layout::practice);
  EXPECT_EQ(read.sheet.cell_mm, print::kLargestCell_mm);
  EXPECT_EQ(read.sheet.rows, 0);
  EXPECT_EQ(read.sheet.copies, print::kMostRows);
}

class ChosenCharacters : public LearnerTest {
 protected:
  std::vector<char32_t> chosen(WorksheetSource source, const std::string& list = {}) {
    WorksheetChoice choice;
    choice.source = source;
    choice.list = list;
    choice.shown = U'永';
    return chosen_characters(choice, *learner_).value();
  }
};

TEST_F(ChosenCharacters, AreTheOneThatIsShown) {
  EXPECT_THAT(chosen(WorksheetSource::shown), ElementsAre(U'永'));
  WorksheetChoice nothing_shown;
  nothing_shown.source = WorksheetSource::shown;
  EXPECT_THAT(chosen_characters(nothing_shown, *learner_).value(), IsEmpty());
}

TEST_F(ChosenCharacters, AreThoseOfAList) {
  const auto grade = chosen(WorksheetSource::list, "grade-1");
  EXPECT_EQ(grade.size(), 80U);
  EXPECT_EQ(std::count(grade.begin(), grade.end(), U'休'), 1);
  WorksheetChoice missing;
  missing.list = "list:gone";
  const auto gone = chosen_characters(missing, *learner_);
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().code, base::Errc::not_found);
}

TEST_F(ChosenCharacters, AreThoseOfTodayAndThoseThatWereForgottenTooOften) {
  write(U'一');
  write(U'二');
  EXPECT_THAT(chosen(WorksheetSource::list), ElementsAre(U'一', U'二'));  // studied
  EXPECT_THAT(chosen(WorksheetSource::difficult), IsEmpty());
  clock_.advance(std::chrono::hours(24 * 30));
  learner_->tick();
  EXPECT_THAT(chosen(WorksheetSource::due), testing::UnorderedElementsAre(U'一', U'二'));
}

TEST_F(ChosenCharacters, OfATextAreReadLater) { EXPECT_THAT(chosen(WorksheetSource::text), IsEmpty()); }

TEST_F(ChosenCharacters, NameWhoMadeAForm) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "made_forms";
  std::filesystem::remove_all(folder);
  const author::Collection own(folder);
  author::OwnCharacter sign;
  sign.facts.name = "our sign";
  sign.facts.rights = {"CC-BY-4.0", "Hanako Yamada", "a.png"};
  sign.strokes.push_back({{{{20, 30}, 3, 1}, {{90, 35}, 3, 1}}, kanji::StrokeEnding::stop, {}});
  const char32_t code_point = own.keep(sign).value();
  author::OwnCharacter form = sign;
  form.facts.name = "一";
  form.facts.instead_of = U'一';
  form.facts.rights = author::kanjivg_rights();
  ASSERT_TRUE(own.keep(form));
  const auto database = author::open_with_own(kanji_db(), own);
  ASSERT_TRUE(database);
  const auto found =
      sheet_characters(*database,
                       std::vector<kanji::CharacterName>{{code_point, {}}, {U'一', {}}, {U'二', {}}}, {},
                       folder)
          .found;
  ASSERT_EQ(found.size(), 3U);
  ASSERT_TRUE(found[0].made);
  EXPECT_EQ(found[0].made->name, "our sign");
  EXPECT_EQ(found[0].made->author, "Hanako Yamada");
  EXPECT_EQ(found[0].made->licence, "CC-BY-4.0");
  EXPECT_FALSE(found[0].made->is_from_kanjivg);
  ASSERT_TRUE(found[1].made);
  EXPECT_TRUE(found[1].made->is_from_kanjivg);
  EXPECT_FALSE(found[2].made);
  // Removed meanwhile, it is still printed.
  ASSERT_TRUE(own.remove(code_point));
  const auto gone =
      sheet_characters(*database, std::vector<kanji::CharacterName>{{code_point, {}}}, {}, folder).found;
  ASSERT_TRUE(gone.at(0).made);
  EXPECT_EQ(gone[0].made->name, "");
}

TEST_F(ChosenCharacters, HaveWordsOnlyWhereTheSheetShowsThem) {
  const auto database = kanji::KanjiDatabase::open(kanji_db());
  ASSERT_TRUE(database);
  const std::vector<kanji::CharacterName> names{{U'休', {}}, {U'\U0010FFFF', {}}};
  print::SheetSettings sheet;
  const SheetCharacters with = sheet_characters(*database, names, sheet);
  ASSERT_EQ(with.found.size(), 1U);
  EXPECT_EQ(with.found.front().character.code_point, U'休');
  EXPECT_EQ(with.found.front().words.size(), 3U);
  EXPECT_THAT(with.missing, ElementsAre(names[1]));
  sheet.facts = false;
  EXPECT_THAT(sheet_characters(*database, names, sheet).found.front().words, IsEmpty());
  sheet.layout = print::Layout::quiz;
  EXPECT_EQ(sheet_characters(*database, names, sheet).found.front().words.size(), 3U);
}

}  // namespace
}  // namespace nazori::practice
