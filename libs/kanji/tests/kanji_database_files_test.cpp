// SPDX-License-Identifier: Apache-2.0
// Files that are no kanji.db, or a damaged one.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "published_database.h"

namespace nazori::kanji {
namespace {

namespace fs = std::filesystem;

class BadFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("nazori_kanji_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  /// The real kanji.db, for a test to damage.
  fs::path fresh_copy() {
    const fs::path copy = folder_ / "kanji.db";
    fs::copy_file(published_database_file(), copy, fs::copy_options::overwrite_existing);
    return copy;
  }
  fs::path folder_;
};

TEST_F(BadFiles, AreRefusedByWhatTheyAre) {
  EXPECT_EQ(KanjiDatabase::open(folder_ / "none").error().code, base::Errc::not_found);
  EXPECT_EQ(KanjiDatabase::open(folder_).error().code, base::Errc::schema);
  EXPECT_EQ(KanjiDatabase::open(write("empty", "")).error().code, base::Errc::schema);
  EXPECT_EQ(KanjiDatabase::open(write("text", std::string(5000, 'x'))).error().code, base::Errc::schema);
}

TEST_F(BadFiles, AnotherVersionIsRefusedWithBothNumbers) {
  const fs::path copy = fresh_copy();
  {
    // The version is in bytes 60 to 63 of an SQLite file.
    std::fstream file(copy, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(63);
    file.put(99);
  }
  const auto opened = KanjiDatabase::open(copy);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, base::Errc::schema);
  EXPECT_NE(opened.error().what.find("99"), std::string::npos);
  EXPECT_FALSE(opened.error().remedy.empty());
}

TEST_F(BadFiles, ADatabaseCutOffIsRefusedOrAnswersNothing) {
  const fs::path copy = fresh_copy();
  fs::resize_file(copy, 1'000'000);
  const auto opened = KanjiDatabase::open(copy);
  if (opened) {
    EXPECT_FALSE(opened->find(U'龠') && !opened->words(U'龠', 1).empty());
    EXPECT_TRUE(opened->trouble());
  } else {
    EXPECT_EQ(opened.error().code, base::Errc::schema);
  }
}

TEST_F(BadFiles, ADatabaseThatIsDamagedAfterItWasOpenedSaysSo) {
  using Ask = std::function<void(const KanjiDatabase&, char32_t)>;
  const std::vector<Ask> asked{
      [](const KanjiDatabase& db, char32_t c) { (void)db.find(c); },
      [](const KanjiDatabase& db, char32_t c) { (void)db.words(c, 3); },
      [](const KanjiDatabase& db, char32_t) { db.for_each_stroke([](const StrokePath&) {}); }};
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const fs::path copy = fresh_copy();
    const auto opened = KanjiDatabase::open(copy);
    ASSERT_TRUE(opened);
    const KanjiDatabase& database = *opened;
    asked[i](database, U'休');
    EXPECT_FALSE(database.trouble()) << i;
    fs::resize_file(copy, 8'192);
    // SQLite does not read again what it still has in memory, so query other rows.
    for (const Summary& one : database.list(List::secondary))
      if (!database.trouble()) asked[i](database, one.code_point);
    ASSERT_TRUE(database.trouble()) << i;
    EXPECT_EQ(database.trouble()->code, base::Errc::io);
    EXPECT_EQ(database.trouble()->where, copy.string());
  }
}

TEST_F(BadFiles, AStrokeThatIsNoneIsNotTakenForAPoint) {
  for (const char* damage : {"path = 'no path'", "ending = 9", "ending = -1"}) {
    const fs::path copy = fresh_copy();
    SQLite::Database(copy.string(), SQLite::OPEN_READWRITE)
        .exec(std::string("UPDATE stroke SET ") + damage +
              " WHERE number = 2 AND form = (SELECT id FROM form WHERE code_point = 20241 AND variant = '')");
    const auto opened = KanjiDatabase::open(copy);
    ASSERT_TRUE(opened);
    EXPECT_FALSE(opened->find(U'休')) << damage;
    EXPECT_TRUE(opened->trouble()) << damage;
    EXPECT_TRUE(opened->find(U'木')) << damage;
  }
}

}  // namespace
}  // namespace nazori::kanji
