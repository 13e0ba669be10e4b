// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/collection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "environment_variable.h"
#include "nazori/author/character_file.h"
#include "nazori/geometry/svg_path.h"
#include "temporary_folder.h"

namespace nazori::author {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

OwnCharacter sign_called(const std::string& name) {
  OwnCharacter sign;
  sign.facts.name = name;
  sign.facts.readings = {"まなぶ", "ガク"};
  sign.facts.meanings = {"school sign"};
  sign.facts.parts = {{"木", {1}}, {"empty", {}}};
  sign.facts.radical = 75;
  sign.strokes.push_back({{{{10, 20}, 3, 1}, {{90, 20}, 3, 1}}, kanji::StrokeEnding::hook, {}});
  sign.strokes.push_back({{{{50, 10}, 2, 1}, {{60, 50}, 4, 1}, {{50, 100}, 0, 0}},
                          kanji::StrokeEnding::taper,
                          geometry::GlyphPoint{40, 12}});
  return sign;
}

class CollectionTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<char32_t> code_points() const {
    std::vector<char32_t> out;
    const auto content = collection_.read();
    EXPECT_TRUE(content);
    for (const auto& kept : content->characters) out.push_back(kept.code_point);
    return out;
  }
  [[nodiscard]] char32_t keep(const OwnCharacter& character, std::optional<char32_t> as = {}) const {
    const auto kept = collection_.keep(character, as);
    EXPECT_TRUE(kept) << base::to_line(kept.error());
    return kept.value_or(0);
  }
  nazori::test::TemporaryFolder folder_;
  Collection collection_{folder_ / "mine" / "characters"};
};

TEST_F(CollectionTest, IsEmptyBeforeAnythingIsKept) {
  EXPECT_THAT(code_points(), IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "mine"));
  const auto none = Collection(fs::path()).read();
  ASSERT_TRUE(none);
  EXPECT_THAT(none->characters, IsEmpty());
}

TEST_F(CollectionTest, GivesBackWhatItKeepsUnderACodePointOfItsOwn) {
  const OwnCharacter sign = sign_called("our sign");
  const char32_t code_point = keep(sign);
  EXPECT_TRUE(kanji::is_own(code_point));
  EXPECT_EQ(collection_.find(code_point).value(), sign);
  const auto content = collection_.read();
  ASSERT_TRUE(content);
  ASSERT_EQ(content->characters.size(), 1U);
  EXPECT_EQ(content->characters.front().character, sign);
  EXPECT_EQ(load_character(content->characters.front().file).value(), sign);
  EXPECT_EQ(collection_.named("our sign").value(), std::vector<char32_t>{code_point});
  EXPECT_THAT(collection_.named("their sign").value(), IsEmpty());
}

// Two computers that keep a sign of the same name most often agree, so that study data can be moved.
TEST_F(CollectionTest, GivesANameTheSameCodePointEverywhere) {
  const Collection other(folder_ / "other");
  EXPECT_EQ(keep(sign_called("our sign")), other.keep(sign_called("our sign")).value());
  EXPECT_NE(keep(sign_called("their sign")), other.named("our sign").value().front());
}

// FNV-1a of 32 bits of the name, modulo 65,534; of "a" it is published as E40C292C.
TEST_F(CollectionTest, TakesTheCodePointFromTheName) {
  EXPECT_EQ(keep(sign_called("a")), 0xF0000U + 0xE40C292CU % 65534U);
  EXPECT_EQ(keep(sign_called("永")), 0xF71FDU);
  EXPECT_EQ(keep(sign_called("a")), 0xF0001U + 0xE40C292CU % 65534U) << "the next one that is free";
}

TEST_F(CollectionTest, GivesTwoOfOneNameDifferentCodePoints) {
  const char32_t first = keep(sign_called("a"));
  const char32_t second = keep(sign_called("a"));
  EXPECT_NE(first, second);
  EXPECT_EQ(collection_.named("a").value().size(), 2U);
}

TEST_F(CollectionTest, ReadsTheReliefOfOneButNotOfAll) {
  OwnCharacter sign = sign_called("our sign");
  const char32_t plain = keep(sign);
  sign.hand.size = 16;
  sign.hand.heights.assign(256, -0.25F);
  EXPECT_EQ(keep(sign, plain), plain);
  EXPECT_EQ(collection_.find(plain).value(), sign);
  const auto content = collection_.read();
  ASSERT_TRUE(content);
  EXPECT_EQ(content->characters.front().character, sign_called("our sign"));
}

TEST_F(CollectionTest, KeepsTheCodePointOfWhatIsChanged) {
  const char32_t code_point = keep(sign_called("before"));
  EXPECT_EQ(keep(sign_called("after"), code_point), code_point);
  EXPECT_THAT(code_points(), ElementsAre(code_point));
  EXPECT_EQ(collection_.find(code_point)->facts.name, "after");
}

TEST_F(CollectionTest, OrdersByName) {
  std::vector<char32_t> kept(3);
  kept[2] = keep(sign_called("c"));
  kept[0] = keep(sign_called("a"));
  kept[1] = keep(sign_called("b"));
  EXPECT_EQ(code_points(), kept);
}

TEST_F(CollectionTest, DoesNotGiveTheCodePointOfARemovedCharacterToANewOne) {
  const char32_t code_point = keep(sign_called("a"));
  EXPECT_TRUE(collection_.remove(code_point));
  EXPECT_THAT(code_points(), IsEmpty());
  EXPECT_FALSE(collection_.find(code_point));
  EXPECT_NE(keep(sign_called("a")), code_point);
  EXPECT_EQ(collection_.remove(code_point).error().code, base::Errc::not_found);
}

TEST_F(CollectionTest, LeavesTheFileOfARemovedCharacterForTakingItBack) {
  const char32_t code_point = keep(sign_called("a"));
  const fs::path file = collection_.read()->characters.front().file;
  EXPECT_TRUE(collection_.remove(code_point));
  fs::rename(file.string() + ".removed", file);
  EXPECT_EQ(collection_.find(code_point).value(), sign_called("a"));
}

TEST_F(CollectionTest, RefusesWhatHasNoNameOrNoStrokesOrAForeignCodePoint) {
  EXPECT_EQ(collection_.keep(sign_called("")).error().where, "the character");
  OwnCharacter relief = sign_called("relief");
  relief.strokes.clear();
  relief.facts.parts.clear();
  EXPECT_EQ(collection_.keep(relief).error().what, "has no strokes");
  EXPECT_EQ(collection_.keep(sign_called("a"), U'休').error().code, base::Errc::bad_argument);
  EXPECT_EQ(collection_.keep(sign_called("a"), kanji::kLastOwn + 1).error().code, base::Errc::bad_argument);
  EXPECT_FALSE(Collection(fs::path()).keep(sign_called("a")));
  EXPECT_FALSE(fs::exists(folder_ / "mine"));
}

TEST_F(CollectionTest, NamesADamagedFileAndReadsTheOthers) {
  const char32_t code_point = keep(sign_called("a"));
  const fs::path damaged = collection_.folder() / "U+F0001.nazori";
  std::ofstream(damaged) << "no character";
  const auto content = collection_.read();
  ASSERT_TRUE(content);
  ASSERT_EQ(content->characters.size(), 1U);
  EXPECT_EQ(content->characters.front().code_point, code_point);
  ASSERT_EQ(content->unread.size(), 1U);
  EXPECT_THAT(content->unread.front().where, testing::HasSubstr(damaged.string()));
}

TEST_F(CollectionTest, CountsAFileWithoutStrokesAsDamaged) {
  (void)keep(sign_called("a"));
  OwnCharacter relief = sign_called("relief");
  relief.strokes.clear();
  relief.facts.parts.clear();
  for (const char32_t at : {0xF0002U, 0xF0001U}) ASSERT_TRUE(save_character(relief, collection_.file_of(at)));
  const auto content = collection_.read();
  ASSERT_TRUE(content);
  EXPECT_EQ(content->characters.size(), 1U);
  ASSERT_EQ(content->unread.size(), 2U);
  EXPECT_EQ(content->unread[0].what, "has no strokes");
  EXPECT_EQ(content->unread[0].where, collection_.file_of(0xF0001).string()) << "in the order of their names";
}

// As when another program removes it between the listing and the reading.
TEST_F(CollectionTest, DoesNotCountWhatHasJustGoneAsDamaged) {
  (void)keep(sign_called("a"));
  fs::create_symlink(folder_ / "gone", collection_.folder() / "U+F0001.nazori");
  const auto content = collection_.read();
  ASSERT_TRUE(content);
  EXPECT_EQ(content->characters.size(), 1U);
  EXPECT_THAT(content->unread, IsEmpty());
}

TEST_F(CollectionTest, PassesOverFilesOfOtherNames) {
  const char32_t code_point = keep(sign_called("a"));
  const fs::path kept = collection_.read()->characters.front().file;
  for (const char* name :
       {"U+F000.nazori", "U+f0001.nazori", "U+0F0001.nazori", "U+FFFFE.nazori", "F0001.nazori", "U+F0001.svg",
        "U+F0001.nazori.journal", "U+F00G1.nazori", "U+4F11.nazori"})
    fs::copy_file(kept, collection_.folder() / name);
  EXPECT_THAT(code_points(), ElementsAre(code_point));
}

TEST_F(CollectionTest, SaysThatItHasChanged) {
  const auto before = collection_.changed_at();
  const char32_t code_point = keep(sign_called("a"));
  // The clock of files moves in steps of a few milliseconds: the past is put far away.
  const auto past = [this] {
    fs::last_write_time(collection_.folder(), fs::file_time_type::clock::now() - std::chrono::hours(1));
    return collection_.changed_at();
  };
  EXPECT_NE(collection_.changed_at(), before);
  auto last = past();
  EXPECT_EQ(collection_.changed_at(), last);
  (void)keep(sign_called("b"), code_point);
  EXPECT_NE(collection_.changed_at(), last);
  last = past();
  EXPECT_TRUE(collection_.remove(code_point));
  EXPECT_NE(collection_.changed_at(), last);
}

TEST_F(CollectionTest, SaysSoAfterEachOfManyFastChanges) {
  const char32_t code_point = keep(sign_called("a"));
  auto last = collection_.changed_at();
  for (int i = 0; i < 50; ++i) {
    (void)keep(sign_called("a"), code_point);
    EXPECT_NE(collection_.changed_at(), std::exchange(last, collection_.changed_at())) << i;
  }
}

OwnCharacter form_of(char32_t published, const std::string& name) {
  OwnCharacter form = sign_called(name);
  form.facts.instead_of = published;
  return form;
}

TEST_F(CollectionTest, UsesOneFormInThePlaceOfAPublishedCharacter) {
  const char32_t code_point = keep(form_of(U'永', "永"));
  EXPECT_TRUE(kanji::is_own(code_point));
  const auto content = collection_.read();
  ASSERT_TRUE(content);
  EXPECT_EQ(content->characters.front().instead_of, U'永');
  EXPECT_EQ(collection_.find(code_point)->facts.instead_of, U'永');
  const char32_t other = keep(sign_called("休"));
  EXPECT_NE(other, code_point);
  const auto both = collection_.read();
  ASSERT_EQ(both->characters.size(), 2U);
  for (const auto& kept : both->characters)
    EXPECT_EQ(kept.instead_of.has_value(), kept.code_point == code_point);
}

TEST_F(CollectionTest, PutsAnEarlierFormOfTheSameCharacterBesideTheOthers) {
  const char32_t first = keep(form_of(U'永', "b"));
  const char32_t elsewhere = keep(form_of(U'休', "c"));
  OwnCharacter with_relief = form_of(U'永', "a");
  with_relief.hand.size = 16;
  with_relief.hand.heights.assign(256, 0.5F);
  const char32_t second = keep(with_relief);
  EXPECT_FALSE(collection_.find(first)->facts.instead_of);
  EXPECT_EQ(collection_.find(elsewhere)->facts.instead_of, U'休');
  EXPECT_EQ(keep(form_of(U'永', "b"), first), first);
  OwnCharacter now_beside = with_relief;
  now_beside.facts.instead_of.reset();
  EXPECT_EQ(collection_.find(second).value(), now_beside) << "with all of it, the relief, too";
  EXPECT_EQ(collection_.find(first)->facts.instead_of, U'永');
}

// As where files of two computers were put together.
TEST_F(CollectionTest, OfTwoFormsInOnePlaceUsesTheFirst) {
  const char32_t second = keep(form_of(U'永', "b"));
  ASSERT_TRUE(save_character(form_of(U'永', "a"), collection_.file_of(0xF0001)));
  const auto content = collection_.read();
  ASSERT_EQ(content->characters.size(), 2U);
  EXPECT_EQ(content->characters[0].code_point, 0xF0001U);
  EXPECT_EQ(content->characters[0].instead_of, U'永');
  EXPECT_EQ(content->characters[1].code_point, second);
  EXPECT_FALSE(content->characters[1].instead_of);
  const auto database = open_with_own(*kanji::KanjiDatabase::locate(), collection_);
  ASSERT_TRUE(database) << base::to_line(database.error());
  EXPECT_EQ(database->find(U'永')->own_form, 0xF0001U);
  EXPECT_TRUE(database->find(second));
}

TEST_F(CollectionTest, BringsThePublishedCharacterBackWhenItsFormIsRemoved) {
  const auto strokes_of_it = [this] {
    const auto database = open_with_own(*kanji::KanjiDatabase::locate(), collection_);
    EXPECT_TRUE(database);
    return database->find(U'永')->strokes.size();
  };
  EXPECT_EQ(strokes_of_it(), 5U);
  const char32_t code_point = keep(form_of(U'永', "永"));
  EXPECT_EQ(strokes_of_it(), 2U);
  EXPECT_TRUE(collection_.remove(code_point));
  EXPECT_EQ(strokes_of_it(), 5U);
}

TEST_F(CollectionTest, RefusesANameThatIsKeptWhereItIsToBeAsked) {
  const char32_t first = keep(sign_called("a"));
  const auto refused = collection_.keep(sign_called("a"), {}, SameName::refuse);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::Errc::in_use);
  EXPECT_EQ(refused.error().where, "a");
  EXPECT_THAT(code_points(), ElementsAre(first));
  EXPECT_EQ(collection_.keep(sign_called("a"), first, SameName::refuse).value(), first) << "it is replaced";
  EXPECT_TRUE(collection_.keep(sign_called("b"), {}, SameName::refuse));
}

TEST_F(CollectionTest, WaitsForAnotherProgramThatWrites) {
  (void)keep(sign_called("a"));
  const char32_t removed = keep(sign_called("b"));
  bool is_locked = false;
  {
    const auto lock = base::FileLock::take(collection_.folder() / ".lock", is_locked);
    ASSERT_TRUE(lock);
    const auto refused = collection_.keep(sign_called("c"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, base::Errc::in_use);
    EXPECT_EQ(refused.error().where, collection_.folder().string());
    EXPECT_EQ(collection_.remove(removed).error().code, base::Errc::in_use);
    EXPECT_EQ(code_points().size(), 2U) << "reading does not wait";
  }
  EXPECT_TRUE(collection_.keep(sign_called("c")));
  EXPECT_TRUE(collection_.remove(removed));
}

// Two processes keep characters of the same names; one more reads all the while.
TEST_F(CollectionTest, LosesNothingWhereTwoProgramsKeepAtOnce) {
  constexpr int kEach = 12;
  std::vector<pid_t> programs;
  for (int program = 0; program < 2; ++program) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      int failed = 0;
      for (int i = 0; i < kEach; ++i)
        if (!collection_.keep(sign_called("sign " + std::to_string(i)))) ++failed;
      ::_exit(failed);
    }
    programs.push_back(child);
  }
  std::size_t running = programs.size();
  while (running > 0) {
    const auto content = collection_.read();
    ASSERT_TRUE(content);
    EXPECT_THAT(content->unread, IsEmpty()) << "no file is half written";
    for (pid_t& program : programs) {
      int status = 0;
      if (program == 0 || ::waitpid(program, &status, WNOHANG) != program) continue;
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
      program = 0;
      --running;
    }
  }
  EXPECT_EQ(code_points().size(), 2U * kEach);
}

TEST_F(CollectionTest, IsWhereTheVariableSaysOrElseWithTheUsersData) {
  const nazori::test::EnvironmentVariable data("XDG_DATA_HOME", "/somewhere");
  {
    const nazori::test::EnvironmentVariable none("NAZORI_CHARACTERS", nullptr);
    EXPECT_EQ(Collection::usual_folder(), "/somewhere/nazori/characters");
  }
  {
    const nazori::test::EnvironmentVariable other("NAZORI_CHARACTERS", "/elsewhere");
    EXPECT_EQ(Collection::usual_folder(), "/elsewhere");
  }
  const nazori::test::EnvironmentVariable off("NAZORI_CHARACTERS", "");
  EXPECT_EQ(Collection::usual_folder(), "");
}

TEST_F(CollectionTest, JoinsTheDatabase) {
  const char32_t code_point = keep(sign_called("our sign"));
  std::ofstream(collection_.folder() / "U+F0001.nazori") << "no character";
  std::vector<base::Error> unread;
  const auto database = open_with_own(*kanji::KanjiDatabase::locate(), collection_, &unread);
  ASSERT_TRUE(database);
  EXPECT_EQ(unread.size(), 1U);
  ASSERT_TRUE(database->find(code_point));
  EXPECT_EQ(database->list(kanji::List::own).size(), 1U);
  kanji::Query query;
  query.text = "school sign";
  const auto found = database->search(query);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().code_point, code_point);
  EXPECT_TRUE(database->draws(U'休'));
}

// Lines, as everything that teaches and judges takes them.
TEST(KanjiCharacter, HasTheCentreLinesThatAreCarved) {
  const OwnCharacter sign = sign_called("our sign");
  const kanji::Character character = kanji_character(sign, 0xF0005);
  EXPECT_EQ(character.code_point, 0xF0005U);
  ASSERT_EQ(character.strokes.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const kanji::StrokeLine& line = character.strokes[i].line;
    EXPECT_EQ(line.ending, sign.strokes[i].ending);
    EXPECT_EQ(line.number_position, sign.strokes[i].number_position);
    EXPECT_EQ(line.points.front(), sign.strokes[i].points.front().at);
    EXPECT_EQ(line.points.back(), sign.strokes[i].points.back().at);
    for (const GroovePoint& point : sign.strokes[i].points) EXPECT_THAT(line.points, Contains(point.at));
    const auto path = geometry::parse_svg_path(character.strokes[i].path);
    ASSERT_TRUE(path);
    EXPECT_EQ(geometry::flatten(*path, 0.05), line.points);
  }
}

TEST(KanjiCharacter, SaysWhatIsKnownOfIt) {
  const kanji::Character character = kanji_character(sign_called("our sign"), 0xF0005);
  EXPECT_THAT(character.entry.kun_readings, ElementsAre("まなぶ"));
  EXPECT_THAT(character.entry.on_readings, ElementsAre("ガク"));
  EXPECT_THAT(character.entry.meanings,
              ElementsAre(kanji::Meaning{"en", "school sign"}, kanji::Meaning{"en", "our sign"}));
  EXPECT_EQ(character.entry.radical, 75);
  EXPECT_THAT(character.entry.stroke_counts, ElementsAre(2));
  EXPECT_EQ(character.components.element, "");
  ASSERT_EQ(character.components.children.size(), 1U);
  EXPECT_EQ(character.components.children.front().element, "木");
  EXPECT_THAT(character.components.children.front().strokes, ElementsAre(1));
  EXPECT_EQ(character.components.children.front().first_stroke, 1);
}

TEST(KanjiCharacter, HasReadingsOfKatakanaAloneAsOnyomi) {
  OwnCharacter sign = sign_called("our sign");
  sign.facts.readings = {"ラーヿ", "らー", "カか", "a", "カ木", "゠ア"};
  const kanji::Character character = kanji_character(sign, 0xF0005);
  EXPECT_THAT(character.entry.on_readings, ElementsAre("ラーヿ", "゠ア"));
  EXPECT_THAT(character.entry.kun_readings, ElementsAre("らー", "カか", "a", "カ木"));
}

TEST(KanjiCharacter, WithTheNameOfOneLetterHasThatLetterAsItsPart) {
  const kanji::Character character = kanji_character(sign_called("永"), 0xF0005);
  ASSERT_EQ(character.components.children.size(), 1U);
  const kanji::Component& own = character.components.children.front();
  EXPECT_EQ(own.element, "永");
  EXPECT_THAT(own.strokes, ElementsAre(0, 1));
  ASSERT_EQ(own.children.size(), 1U);
  EXPECT_EQ(own.children.front().element, "木");
}

TEST(KanjiCharacter, DoesNotRepeatANameThatIsAMeaning) {
  OwnCharacter sign = sign_called("school sign");
  EXPECT_THAT(kanji_character(sign, 0xF0005).entry.meanings,
              ElementsAre(kanji::Meaning{"en", "school sign"}));
  sign.facts.name.clear();
  EXPECT_THAT(kanji_character(sign, 0xF0005).entry.meanings,
              ElementsAre(kanji::Meaning{"en", "school sign"}));
}

}  // namespace
}  // namespace nazori::author
