// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "database_places.h"
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
  /// What a program finds that is in none of the other folders.
  [[nodiscard]] base::Result<fs::path> locate() const { return locate_for(folder_ / "apart" / "nazori"); }
  /// Makes a CMake build folder for the test's sources in src and returns the path of the program in it.
  [[nodiscard]] fs::path build_in(const fs::path& folder, const std::string& project = "nazori") const {
    fs::create_directories(folder_ / folder / "bin");
    std::ofstream(folder_ / folder / "CMakeCache.txt")
        << "# a comment\nCMAKE_PROJECT_NAME:STATIC=" << project
        << "\nCMAKE_HOME_DIRECTORY:INTERNAL=" << (folder_ / "src").string() << "\n";
    return folder_ / folder / "bin" / "nazori";
  }
  fs::path folder_;
  std::map<std::string, std::optional<std::string>> before_;
};

TEST_F(Locate, SaysHowToBuildOneWhereThereIsNone) {
  const auto found = locate();
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, base::Errc::not_found);
  EXPECT_NE(found.error().remedy.find("database build"), std::string::npos);
}

TEST_F(Locate, TheFolderNamedByTheUserComesFirst) {
  const fs::path named = put("named");
  const fs::path home = put("share/nazori");
  point("XDG_DATA_HOME", (folder_ / "share").string());
  EXPECT_EQ(locate(), home);
  point("NAZORI_DATA", (folder_ / "named").string());
  EXPECT_EQ(locate(), named);
}

TEST_F(Locate, LooksThroughTheDataFoldersInTheirOrder) {
  const fs::path second = put("b/nazori");
  point("XDG_DATA_DIRS", (folder_ / "a").string() + "::" + (folder_ / "b").string());
  EXPECT_EQ(locate(), second);
  const fs::path first = put("a/nazori");
  EXPECT_EQ(locate(), first);
}

TEST_F(Locate, UsesTheHomeFolderWhereNoDataFolderIsSet) {
  const fs::path own = put("home/.local/share/nazori");
  point("XDG_DATA_HOME", "");
  point("HOME", (folder_ / "home").string());
  EXPECT_EQ(locate(), own);
  point("XDG_DATA_HOME", "relative/is/ignored");
  EXPECT_EQ(locate(), own);
}

TEST_F(Locate, AProgramInItsBuildTreeFindsTheDatabaseOfMakeRun) {
  const fs::path database = put("src/build/data");
  EXPECT_EQ(locate_for(build_in("src/build/release")), database);
  // A build folder elsewhere has its data next to it; one directly in the sources has them inside.
  const fs::path other = put("elsewhere/data");
  EXPECT_EQ(locate_for(build_in("elsewhere/release")), other);
  EXPECT_EQ(locate_for(build_in("src/build")), database);
}

TEST_F(Locate, WhatIsNoBuildOfNazoriIsNoBuildTree) {
  const fs::path database = put("src/build/data");
  const fs::path program = build_in("src/build/release", "other");
  EXPECT_FALSE(locate_for(program));
  (void)build_in("src/build/release");
  EXPECT_EQ(locate_for(program), database);
  EXPECT_FALSE(locate_for(folder_ / "src/build/release/tools/nazori"));
  EXPECT_FALSE(locate_for({}));
}

TEST_F(Locate, AnInstalledProgramFindsWhatWasInstalledWithIt) {
  const fs::path database = put("opt/nazori/share/nazori");
  EXPECT_EQ(locate_for(folder_ / "opt/nazori/bin/nazori"), database);
  EXPECT_FALSE(locate_for(folder_ / "opt/nazori/tools/nazori"));
}

TEST_F(Locate, TheRunningProgramIsTheOneThatIsAsked) {
  const fs::path database = put("named");
  point("NAZORI_DATA", (folder_ / "named").string());
  EXPECT_EQ(KanjiDatabase::locate(), database);
  EXPECT_EQ(KanjiDatabase::place_to_build(), database);
}

TEST_F(Locate, TheNearestPlaceComesFirst) {
  const fs::path program = build_in("src/build/release");
  point("NAZORI_DATA", (folder_ / "named").string());
  point("XDG_DATA_HOME", (folder_ / "home").string());
  point("XDG_DATA_DIRS", (folder_ / "system").string());
  // From the last place to the first: each one added takes precedence over those after it.
  for (const char* place : {"src/build/release/share/nazori", "system/nazori", "home/nazori",
                            "src/build/data", "src/build/release/bin", "named"}) {
    const fs::path database = put(place);
    EXPECT_EQ(locate_for(program), database) << place;
  }
}

TEST_F(Locate, ThePlacesAreTheseAndNoOthers) {
  const fs::path apart = "/apart/nazori";
  point("NAZORI_DATA", "");
  point("XDG_DATA_HOME", "/data");
  point("XDG_DATA_DIRS", "");
  const std::vector<fs::path> usual{"/apart/kanji.db", "/data/nazori/kanji.db",
                                    "/usr/local/share/nazori/kanji.db", "/usr/share/nazori/kanji.db"};
  EXPECT_EQ(database_places(apart), usual) << "the folders of the XDG specification where none are named";
  point("XDG_DATA_DIRS", "/a:relative::/b");
  point("XDG_DATA_HOME", "");
  point("HOME", "");
  point("NAZORI_DATA", "/named");
  EXPECT_EQ(database_places(apart), (std::vector<fs::path>{"/named/kanji.db", "/apart/kanji.db",
                                                           "/a/nazori/kanji.db", "/b/nazori/kanji.db"}));
  EXPECT_EQ(database_places({}),
            (std::vector<fs::path>{"/named/kanji.db", "/a/nazori/kanji.db", "/b/nazori/kanji.db"}));
  EXPECT_EQ(database_places("/usr/bin/nazori"),
            (std::vector<fs::path>{"/named/kanji.db", "/usr/bin/kanji.db", "/a/nazori/kanji.db",
                                   "/b/nazori/kanji.db", "/usr/share/nazori/kanji.db"}));
}

TEST_F(Locate, AFolderOfThatNameIsNoDatabase) {
  fs::create_directories(folder_ / "named" / "kanji.db");
  point("NAZORI_DATA", (folder_ / "named").string());
  EXPECT_FALSE(locate());
}

TEST_F(Locate, ANewDatabaseNeverGoesBesideAnInstalledProgram) {
  point("NAZORI_DATA", "");
  const fs::path installed = folder_ / "usr/bin/nazori-cli";
  point("XDG_DATA_HOME", (folder_ / "home").string());
  EXPECT_EQ(place_to_build_for(installed), folder_ / "home/nazori/kanji.db");
  EXPECT_EQ(place_to_build_for(build_in("src/build/release")), folder_ / "src/build/data/kanji.db");
}

TEST_F(Locate, ANewDatabaseGoesToTheFolderNamedByTheUserFirst) {
  point("NAZORI_DATA", (folder_ / "named").string());
  EXPECT_EQ(place_to_build_for(build_in("src/build/release")), folder_ / "named/kanji.db");
}

TEST_F(Locate, WithoutAnyFolderANewDatabaseHasNoPlace) {
  for (const char* name : {"NAZORI_DATA", "XDG_DATA_HOME", "HOME"}) point(name, "");
  const auto place = place_to_build_for("/usr/bin/nazori-cli");
  ASSERT_FALSE(place);
  EXPECT_NE(place.error().remedy.find("--output"), std::string::npos);
}

}  // namespace
}  // namespace nazori::kanji
