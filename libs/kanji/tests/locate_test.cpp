// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "nazori/kanji/kanji_database.h"

namespace nazori::kanji {
namespace {

namespace fs = std::filesystem;

class Locate : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("nazori_locate_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    for (const char* name : {"NAZORI_DATA", "XDG_DATA_HOME", "XDG_DATA_DIRS", "HOME"}) {
      const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
      before_[name] = value == nullptr ? std::nullopt : std::optional<std::string>(value);
      ::setenv(name, (folder_ / "nowhere").c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    }
  }
  void TearDown() override {
    for (const auto& [name, value] : before_) {
      if (value) {
        ::setenv(name.c_str(), value->c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
      } else {
        ::unsetenv(name.c_str());  // NOLINT(concurrency-mt-unsafe)
      }
    }
    fs::remove_all(folder_);
  }
  /// Points a variable at a folder of the test.
  void point(const char* name, const std::string& folder) const {
    ::setenv(name, folder.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  }
  [[nodiscard]] fs::path put(const fs::path& folder) const {
    fs::create_directories(folder_ / folder);
    std::ofstream(folder_ / folder / "kanji.db") << "x";
    return folder_ / folder / "kanji.db";
  }
  fs::path folder_;
  std::map<std::string, std::optional<std::string>> before_;
};

TEST_F(Locate, SaysHowToBuildOneWhereThereIsNone) {
  const auto found = KanjiDatabase::locate();
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, base::Errc::not_found);
  EXPECT_NE(found.error().remedy.find("database build"), std::string::npos);
}

TEST_F(Locate, TheFolderNamedByTheUserComesFirst) {
  const fs::path named = put("named");
  const fs::path home = put("share/nazori");
  point("XDG_DATA_HOME", (folder_ / "share").string());
  EXPECT_EQ(KanjiDatabase::locate(), home);
  point("NAZORI_DATA", (folder_ / "named").string());
  EXPECT_EQ(KanjiDatabase::locate(), named);
}

TEST_F(Locate, LooksThroughTheDataFoldersInTheirOrder) {
  const fs::path second = put("b/nazori");
  point("XDG_DATA_DIRS", (folder_ / "a").string() + "::" + (folder_ / "b").string());
  EXPECT_EQ(KanjiDatabase::locate(), second);
  const fs::path first = put("a/nazori");
  EXPECT_EQ(KanjiDatabase::locate(), first);
}

TEST_F(Locate, UsesTheHomeFolderWhereNoDataFolderIsSet) {
  const fs::path own = put("home/.local/share/nazori");
  point("XDG_DATA_HOME", "");
  point("HOME", (folder_ / "home").string());
  EXPECT_EQ(KanjiDatabase::locate(), own);
  point("XDG_DATA_HOME", "relative/is/ignored");
  EXPECT_EQ(KanjiDatabase::locate(), own);
}

}  // namespace
}  // namespace nazori::kanji
