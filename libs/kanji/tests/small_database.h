// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/schema.h"

namespace nazori::kanji::test {

/// A kanji.db that a test fills row by row.
class SmallDatabase : public testing::Test {
 protected:
  SmallDatabase() {
    std::string pattern = (std::filesystem::temp_directory_path() / "nazori-small-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    path_ = folder_ / "kanji.db";
    exec("PRAGMA application_id = " + std::to_string(kSchemaApplicationId) +
         "; PRAGMA user_version = " + std::to_string(kSchemaVersion));
    exec(std::string(schema_sql()));
  }
  ~SmallDatabase() override { std::filesystem::remove_all(folder_); }

  void exec(const std::string& sql) const {
    SQLite::Database(path_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
  }

  /// The optional columns of a character's row.
  struct Row {
    CharacterKind kind = CharacterKind::ideograph;
    int strokes = 1;
    int counted = 1;
    std::string grade = "NULL", frequency = "NULL", old_jlpt = "NULL", radical = "NULL";
    std::string meaning = {}, reading = {};
  };
  /// At the next place.
  void add(char32_t code_point, const Row& row) {
    const auto text = [](const std::string& s) { return ",'" + s + "'"; };
    exec("INSERT INTO character VALUES(" + std::to_string(static_cast<std::uint32_t>(code_point)) + "," +
         std::to_string(places_++) + "," + std::to_string(static_cast<int>(row.kind)) + "," +
         std::to_string(row.strokes) + "," + std::to_string(row.counted) + "," + row.grade + "," +
         row.frequency + "," + row.old_jlpt + "," + row.radical + text(row.meaning) + text(row.reading) +
         ")");
  }
  void add(char32_t code_point) { add(code_point, Row{}); }

  [[nodiscard]] KanjiDatabase open() const {
    auto opened = KanjiDatabase::open(path_);
    EXPECT_TRUE(opened) << base::to_line(opened.error());
    return *std::move(opened);
  }
  static std::u32string characters(const std::vector<Summary>& summaries) {
    std::u32string out;
    for (const Summary& s : summaries) out += s.code_point;
    return out;
  }

  std::filesystem::path folder_, path_;

 private:
  int places_ = 0;
};

}  // namespace nazori::kanji::test
