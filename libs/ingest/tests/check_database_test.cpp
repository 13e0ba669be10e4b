// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "database_writer.h"
#include "nazori/ingest/ingest.h"

namespace nazori::ingest {
namespace {

namespace fs = std::filesystem;

class CheckDatabase : public testing::Test {
 protected:
  CheckDatabase() {
    std::string pattern = (fs::temp_directory_path() / "nazori-check-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    path_ = folder_ / "kanji.db";
  }
  ~CheckDatabase() override { fs::remove_all(folder_); }

  /// Two drawn characters, one of them with a variant, and one that only the dictionary has.
  void fill() const {
    fs::remove(path_);
    const auto stroke = [] {
      kanji::Stroke s;
      s.path = "M1,2L3,4";
      return s;
    };
    const auto group = [](int strokes) {
      kanji::Component c;
      for (int i = 0; i < strokes; ++i) c.strokes.push_back(i);
      return c;
    };
    const DrawnForm one{U'一', "", {stroke()}, group(1)}, variant{U'一', "V", {stroke()}, group(1)};
    DrawnForm two{U'二', "", {stroke(), stroke()}, group(2)};
    two.components.children.push_back(group(1));
    kanji::DictionaryEntry entry;
    entry.stroke_counts = {1, 2};
    entry.kun_readings = {"ひと"};
    entry.meanings = {{"en", "one"}};
    DatabaseWriter writer(path_);
    writer.add_radicals();
    for (const DrawnForm& form : {one, variant, two}) writer.add_form(form);
    writer.add_orders(U'二', std::vector<kanji::AlternativeOrder>{{{2, 1}, "a list"}});
    writer.add_character(U'一', 0, &one, &entry);
    writer.add_character(U'二', 1, &two, nullptr);
    writer.add_character(U'三', 2, nullptr, &entry);
    writer.add_word({"一", "いち", {{"one"}}, "n", true});
    writer.add_word({"三", "みい", {{"three"}}, "n", false});
    writer.finish();
  }
  void exec(const std::string& sql) const {
    SQLite::Database(path_.string(), SQLite::OPEN_READWRITE).exec(sql);
  }

  fs::path folder_, path_;
};

TEST_F(CheckDatabase, CountsWhatIsInIt) {
  fill();
  const auto report = check_database(path_);
  ASSERT_TRUE(report) << base::to_line(report.error());
  EXPECT_EQ(report->counts, (Counts{3, 2, 1, 4, 4, 2, 1, 2, 1, 214}));
  EXPECT_EQ(report->bytes, fs::file_size(path_));
}

TEST_F(CheckDatabase, FindsEachKindOfBrokenRow) {
  const std::vector<std::pair<std::string, std::string>> damages{
      {"INSERT INTO form VALUES(9, 77, ''); INSERT INTO stroke VALUES(9, 0, 'M1,2L3,4', '', 0, 0, 0);"
       "INSERT INTO component SELECT 9, 0, -1, 0, 1, '', '', '', '', '', NULL, NULL, 0",
       "a form has no character"},
      {"DELETE FROM stroke WHERE form = 1", "a form has no strokes"},
      {"INSERT INTO stroke VALUES(9, 0, 'M1,2L3,4', '', 0, 0, 0)", "a stroke has no form"},
      {"UPDATE stroke SET number = 2 WHERE form = 2 AND number = 1", "strokes are not numbered from 0 on"},
      {"UPDATE stroke SET number = 1 WHERE form = 0", "strokes are not numbered from 0 on"},
      {"UPDATE character SET strokes = 3 WHERE code_point = 19968",
       "a character says it has other strokes than it has"},
      {"UPDATE character SET strokes = 1 WHERE code_point = 19977",
       "a character says it has other strokes than it has"},
      {"DELETE FROM component WHERE form = 1", "a form has no groups"},
      {"UPDATE component SET stroke_count = 3 WHERE form = 2 AND position = 0",
       "a group holds strokes that the form lacks"},
      {"UPDATE component SET first_stroke = 2 WHERE form = 2 AND position = 1",
       "a group holds strokes that the form lacks"},
      {"INSERT INTO word_of VALUES(1, 9)", "a word in the index does not exist"},
      {"INSERT INTO word_key VALUES('a', 9)", "a key of a word has no word"},
      {"INSERT INTO word_meaning_key VALUES('a', 9, 0)", "a key of a word has no word"},
      {"INSERT INTO reading_key VALUES('a', 3, 0)", "a search key has no character"},
      {"INSERT INTO meaning_key VALUES('a', 3, 0)", "a search key has no character"},
      {"INSERT INTO element_of VALUES('a', 3)", "a search key has no character"},
      {"UPDATE stroke SET path = 'none' WHERE form = 1", "a stroke cannot be read: "},
      {"DELETE FROM stroke_count", "a table is empty"},
      {"DELETE FROM word; DELETE FROM word_of; DELETE FROM word_key; DELETE FROM word_meaning_key",
       "a table is empty"},
      {"DELETE FROM radical", "a table is empty"}};
  for (const auto& [damage, told] : damages) {
    fill();
    exec(damage);
    const auto checked = check_database(path_);
    ASSERT_FALSE(checked) << damage;
    EXPECT_EQ(checked.error().code, base::Errc::parse) << damage;
    EXPECT_TRUE(checked.error().what.starts_with("is damaged: " + told))
        << damage << ": " << checked.error().what;
    EXPECT_EQ(checked.error().where, path_.string());
    EXPECT_EQ(checked.error().remedy, "build it again: nazori-cli database build");
  }
}

}  // namespace
}  // namespace nazori::ingest
