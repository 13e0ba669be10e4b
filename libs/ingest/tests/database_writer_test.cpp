// SPDX-License-Identifier: Apache-2.0
// What is written lies in the rows and columns where the schema says.
#include "database_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "nazori/kanji/schema.h"

namespace nazori::ingest {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class Writer : public testing::Test {
 protected:
  Writer() {
    std::string pattern = (fs::temp_directory_path() / "nazori-writer-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    path_ = folder_ / "kanji.db";
  }
  ~Writer() override { fs::remove_all(folder_); }

  /// Writes the content that `fill` adds, and finishes the file.
  template <class Fill>
  void write(Fill fill) const {
    fs::remove(path_);
    DatabaseWriter writer(path_);
    fill(writer);
    writer.finish();
  }
  /// The rows that a query finds, columns apart by '|', without a value '~'.
  [[nodiscard]] std::vector<std::string> rows(const std::string& sql) const {
    SQLite::Database db(path_.string(), SQLite::OPEN_READONLY);
    SQLite::Statement query(db, sql);
    std::vector<std::string> out;
    while (query.executeStep()) {
      std::string row;
      for (int i = 0; i < query.getColumnCount(); ++i)
        row += (i > 0 ? "|" : "") + (query.getColumn(i).isNull() ? "~" : query.getColumn(i).getString());
      out.push_back(row);
    }
    return out;
  }

  fs::path folder_, path_;
};

kanji::Stroke stroke(const std::string& path, const std::string& type) {
  kanji::Stroke s;
  s.path = path;
  s.type = type;
  return s;
}

kanji::Component group(const std::string& element, int first, int count) {
  kanji::Component c;
  c.element = element;
  c.first_stroke = first;
  for (int i = 0; i < count; ++i) c.strokes.push_back(first + i);
  return c;
}

TEST_F(Writer, MarksTheFileAsAKanjiDatabaseOfThisVersion) {
  write([](DatabaseWriter&) {});
  EXPECT_THAT(rows("PRAGMA application_id"), ElementsAre(std::to_string(kanji::kSchemaApplicationId)));
  EXPECT_THAT(rows("PRAGMA user_version"), ElementsAre(std::to_string(kanji::kSchemaVersion)));
}

TEST_F(Writer, KeepsNothingBeforeItIsFinished) {
  {
    DatabaseWriter writer(path_);
    writer.add_source({"A", "1", "sum", "free"});
  }
  SQLite::Database db(path_.string(), SQLite::OPEN_READONLY);
  EXPECT_FALSE(db.tableExists("source"));
}

TEST_F(Writer, NumbersTheSources) {
  write([](DatabaseWriter& w) {
    w.add_source({"A", "1", "sum1", "free"});
    w.add_source({"B", "2", "sum2", "open"});
  });
  EXPECT_THAT(rows("SELECT * FROM source"), ElementsAre("0|A|1|sum1|free", "1|B|2|sum2|open"));
}

TEST_F(Writer, WritesTheRadicalsOfTheTable) {
  write([](DatabaseWriter& w) { w.add_radicals(); });
  EXPECT_EQ(rows("SELECT * FROM radical").size(), 214U);
  EXPECT_THAT(rows("SELECT number, form, strokes FROM radical WHERE number IN (1, 9, 214)"),
              ElementsAre("1|一|1", "9|人|2", "214|龠|17"));
  EXPECT_THAT(rows("SELECT english_name FROM radical WHERE number = 9"), ElementsAre("person"));
  EXPECT_THAT(rows("SELECT form FROM radical_form WHERE number = 9"), testing::Contains("亻"));
  EXPECT_THAT(
      rows("SELECT min(position) || ' ' || (max(position) - count(*)) FROM radical_form GROUP BY number"),
      testing::Each("0 -1"))
      << "positions from 0 on";
  EXPECT_THAT(
      rows("SELECT min(position) || ' ' || (max(position) - count(*)) FROM radical_name GROUP BY number"),
      testing::Each("0 -1"));
  EXPECT_EQ(rows("SELECT DISTINCT number FROM radical_name").size(), 214U);
  EXPECT_THAT(rows("SELECT form FROM radical_form WHERE form = ''"), IsEmpty());
}

TEST_F(Writer, WritesAFormWithItsStrokesAndGroups) {
  DrawnForm form{U'休', "Kaisho", {stroke("M1,2L3,4", "㇒"), stroke("M5,6L7,8", "")}, group("休", 0, 2)};
  form.strokes[0].line.ending = kanji::StrokeEnding::taper;
  form.strokes[0].line.number_position = {25.5, 15.25};
  kanji::Component left = group("亻", 0, 1);
  left.original = "人";
  left.position = "left";
  left.radical = "general";
  left.phon = "p";
  left.part = 3;
  left.number = 4;
  left.variant = true;
  kanji::Component inner = group("", 0, 1);
  inner.partial = true;
  left.children.push_back(inner);
  kanji::Component right = group("木", 1, 1);
  right.trad_form = true;
  kanji::Component last = group("x", 1, 0);
  last.radical_form = true;
  last.variant = true;
  form.components.children = {left, right, last};
  write([&](DatabaseWriter& w) {
    w.add_form({U'一', "", {}, {}});
    w.add_form(form);
  });
  EXPECT_THAT(rows("SELECT * FROM form"), ElementsAre("0|19968|", "1|20241|Kaisho"));
  EXPECT_THAT(rows("SELECT * FROM stroke"),
              ElementsAre("1|0|M1,2L3,4|㇒|2|25.5|15.25", "1|1|M5,6L7,8||0|~|~"));
  EXPECT_THAT(
      rows("SELECT * FROM component WHERE form = 1"),
      ElementsAre("1|0|-1|0|2|休|~|~|~|~|~|~|0", "1|1|0|0|1|亻|人|left|general|p|3|4|1",
                  "1|2|1|0|1|~|~|~|~|~|~|~|2", "1|3|0|1|1|木|~|~|~|~|~|~|4", "1|4|0|1|0|x|~|~|~|~|~|~|9"));
}

TEST_F(Writer, WritesOrdersByTheirPlace) {
  const std::vector<kanji::AlternativeOrder> orders{{{1, 3, 2}, "a list"}, {{3, 2, 1}, "another"}};
  write([&](DatabaseWriter& w) { w.add_orders(U'休', orders); });
  EXPECT_THAT(rows("SELECT * FROM alternative_order"),
              ElementsAre("20241|0|1 3 2|a list", "20241|1|3 2 1|another"));
}

kanji::DictionaryEntry rest() {
  kanji::DictionaryEntry e;
  e.on_readings = {"キュウ"};
  e.kun_readings = {"やす.む", "やす.まる"};
  e.nanori = {"やす"};
  e.meanings = {{"en", "Rest"}, {"en", "day off"}, {"fr", "repos"}};
  e.grade = 1;
  e.frequency = 642;
  e.old_jlpt_level = 4;
  e.radical = 9;
  e.stroke_counts = {6, 7};
  e.codes = {{"skip", "1-2-4"}, {"deroo", "2164"}};
  return e;
}

TEST_F(Writer, WritesACharacterWithWhatTheDictionarySays) {
  const DrawnForm main{
      U'休', "", {stroke("M1,2L3,4", ""), stroke("M1,2L3,4", ""), stroke("M1,2L3,4", "")}, {}};
  const auto entry = rest();
  kanji::DictionaryEntry bare;
  bare.on_readings = {"イチ"};
  bare.meanings = {{"fr", "un"}};
  write([&](DatabaseWriter& w) {
    w.add_character(U'休', 7, &main, &entry);
    w.add_character(U'一', 8, nullptr, &bare);
    w.add_character(U'ア', 9, nullptr, nullptr);
  });
  EXPECT_THAT(rows("SELECT * FROM character ORDER BY place"),
              ElementsAre("20241|7|0|3|6|1|642|4|9|Rest|やす.む", "19968|8|0|0|0|~|~|~|~||イチ",
                          "12450|9|2|0|0|~|~|~|~||"));
  EXPECT_THAT(rows("SELECT * FROM stroke_count"), ElementsAre("20241|0|6", "20241|1|7"));
  EXPECT_THAT(rows("SELECT * FROM reading WHERE code_point = 20241"),
              ElementsAre("20241|0|0|キュウ", "20241|1|1|やす.む", "20241|2|1|やす.まる", "20241|3|2|やす"));
  EXPECT_THAT(rows("SELECT * FROM meaning WHERE code_point = 20241"),
              ElementsAre("20241|0|en|Rest", "20241|1|en|day off", "20241|2|fr|repos"));
  EXPECT_THAT(rows("SELECT * FROM code ORDER BY position"),
              ElementsAre("20241|0|skip|1-2-4", "20241|1|deroo|2164"));
}

TEST_F(Writer, AReadingIsFoundWholeWithoutItsOkuriganaAndAsAName) {
  auto entry = rest();
  entry.nanori.emplace_back("きゅう");
  entry.kun_readings.emplace_back("-やす");
  write([&](DatabaseWriter& w) {
    w.add_character(U'休', 0, nullptr, &entry);
    w.add_character(U'あ', 1, nullptr, nullptr);
    w.add_character(U'ア', 2, nullptr, nullptr);
    w.add_character(U'A', 3, nullptr, nullptr);
  });
  EXPECT_THAT(rows("SELECT key, place, fit FROM reading_key ORDER BY place, key"),
              ElementsAre("きゅう|0|0", "やす|0|0", "やすまる|0|0", "やすむ|0|0", "あ|1|0", "あ|2|0"))
      << "the best of two fits of one reading";
  entry.kun_readings.pop_back();
  write([&](DatabaseWriter& w) { w.add_character(U'休', 0, nullptr, &entry); });
  EXPECT_THAT(rows("SELECT fit FROM reading_key WHERE key = 'やす'"), ElementsAre("1"));
  entry.kun_readings.clear();
  write([&](DatabaseWriter& w) { w.add_character(U'休', 0, nullptr, &entry); });
  EXPECT_THAT(rows("SELECT fit FROM reading_key WHERE key = 'やす'"), ElementsAre("2"));
}

TEST_F(Writer, AMeaningIsFoundFromEachOfItsWordsOn) {
  const auto entry = rest();
  kanji::DictionaryEntry other;
  other.meanings = {{"fr", "jour"}, {"en", "one's Own day"}, {"en", "day"}, {"en", "--"}, {"en", "own day"}};
  write([&](DatabaseWriter& w) {
    w.add_character(U'休', 0, nullptr, &entry);
    w.add_character(U'日', 1, nullptr, &other);
  });
  EXPECT_THAT(
      rows("SELECT key, place, fit FROM meaning_key ORDER BY place, key"),
      ElementsAre("day off|0|1", "off|0|2", "rest|0|0", "day|1|1", "one's own day|1|0", "own day|1|1"));
}

TEST_F(Writer, AnElementIsFoundInWhatItIsAPartOf) {
  DrawnForm form{U'休', "", {stroke("M1,2L3,4", "")}, group("休", 0, 1)};
  kanji::Component left = group("亻", 0, 1);
  left.original = "人";
  kanji::Component inner = group("丿", 0, 1);
  kanji::Component own = group("休", 0, 1);
  left.children = {inner, own, group("", 0, 0)};
  form.components.children = {left, group("亻", 0, 0)};
  write([&](DatabaseWriter& w) {
    w.add_character(U'休', 5, &form, nullptr);
    w.add_character(U'一', 6, nullptr, nullptr);
  });
  EXPECT_THAT(rows("SELECT * FROM element_of"), ElementsAre("丿|5", "人|5", "亻|5")) << "but not of itself";
}

TEST_F(Writer, WritesAWordAndWhoseWordItIs) {
  write([](DatabaseWriter& w) {
    w.add_word({"休み", "やすみ", {{"rest", "recess"}, {"vacation"}}, "n,vs", true});
    w.add_word({"ああ", "", {{"ah"}}, "int", true});
    w.add_word({"いい", "いい", {{"good"}}, "adj", false});
    w.add_word({"ペン日日A", "x", {{"pen"}}, "", false});
  });
  EXPECT_THAT(rows("SELECT * FROM word"),
              ElementsAre("0|休み|やすみ|n,vs|2|rest/recess\nvacation", "1|ああ|~|int|1|ah",
                          "2|いい|~|adj|0|good", "3|ペン日日A|x||0|pen"));
  // 休み is in the table of basic words.
  // Of kana only common words that are written in kana alone.
  EXPECT_THAT(rows("SELECT * FROM word_of ORDER BY word"), ElementsAre("20241|0", "12354|1", "26085|3"));
}

TEST_F(Writer, AWordIsFoundByItsReadingTextAndTheGlossesOfCommonOnes) {
  write([](DatabaseWriter& w) {
    w.add_word({"休み", "ヤスみ", {{"(abbr) to rest", "day off (work)"}, {"rest of the day"}}, "n", true});
    w.add_word({"ああ", "", {{"ah"}}, "int", true});
    w.add_word({"欠", "けつ", {{"lack"}}, "n", false});
  });
  EXPECT_THAT(rows("SELECT * FROM word_key ORDER BY word, key"),
              ElementsAre("やすみ|0", "休み|0", "ああ|1", "けつ|2", "欠|2"));
  EXPECT_THAT(rows("SELECT * FROM word_meaning_key ORDER BY word, fit, key"),
              ElementsAre("rest|0|0", "day off|0|1", "rest of the day|0|1", "day|0|2", "off|0|2", "ah|1|0"))
      << "words such as of and the begin nothing";
}

}  // namespace
}  // namespace nazori::ingest
