// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/program_folders.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "environment_variable.h"

namespace nazori::base {
namespace {

namespace fs = std::filesystem;

class ProgramFolders : public testing::Test {
 protected:
  ProgramFolders() {
    std::string pattern = (fs::temp_directory_path() / "nazori-folders-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~ProgramFolders() override { fs::remove_all(folder_); }

  /// Writes a build cache next to the program folder and returns the path of a program in it.
  [[nodiscard]] fs::path build_in(const fs::path& folder, const std::string& cache) const {
    fs::create_directories(folder_ / folder);
    std::ofstream(folder_ / folder / "CMakeCache.txt") << cache;
    return folder_ / folder / "bin" / "nazori";
  }
  [[nodiscard]] std::string cache_of(const fs::path& sources) const {
    return "# a comment\nCMAKE_HOME_DIRECTORY:INTERNAL=" + (folder_ / sources).string() +
           "\nCMAKE_PROJECT_NAME:STATIC=nazori\nOTHER:STRING=1\n";
  }

  fs::path folder_;
};

TEST_F(ProgramFolders, TheRunningProgramIsThisTest) {
  EXPECT_TRUE(fs::is_regular_file(program_file()));
  EXPECT_EQ(program_file().filename(), "nazori_base_tests");
}

TEST_F(ProgramFolders, ABuildOfAPresetSharesItsDataWithTheOthers) {
  const auto tree = build_tree_of(build_in("src/build/release", cache_of("src")));
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->sources, folder_ / "src");
  EXPECT_EQ(tree->data, folder_ / "src/build/data");
}

TEST_F(ProgramFolders, ABuildRightInTheSourcesHasDataOfItsOwn) {
  const auto tree = build_tree_of(build_in("src/build", cache_of("src")));
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->sources, folder_ / "src");
  EXPECT_EQ(tree->data, folder_ / "src/build/data");
}

TEST_F(ProgramFolders, WhatIsNoBuildOfThisProgramIsNoBuildTree) {
  const fs::path program = build_in("src/build/release", cache_of("src"));
  ASSERT_TRUE(build_tree_of(program));
  EXPECT_FALSE(build_tree_of(program.parent_path().parent_path() / "tools" / "nazori"));
  EXPECT_FALSE(build_tree_of(folder_ / "elsewhere/bin/nazori")) << "no cache";
  EXPECT_FALSE(build_tree_of({}));
  EXPECT_FALSE(build_tree_of(build_in("a", "CMAKE_PROJECT_NAME:STATIC=nazori\n"))) << "no sources";
  EXPECT_FALSE(build_tree_of(build_in(
      "b", "CMAKE_PROJECT_NAME:STATIC=nazori2\nCMAKE_HOME_DIRECTORY:INTERNAL=" + folder_.string() + "\n")));
}

TEST(UserDataFolder, IsThatOfTheSpecification) {
  // XDG Base Directory Specification: a path that is not absolute is ignored.
  const test::EnvironmentVariable home("HOME", "/home/a");
  {
    const test::EnvironmentVariable data("XDG_DATA_HOME", "/data");
    EXPECT_EQ(user_data_folder(), "/data/nazori");
  }
  for (const char* none : {"", "relative/data", static_cast<const char*>(nullptr)}) {
    const test::EnvironmentVariable data("XDG_DATA_HOME", none);
    EXPECT_EQ(user_data_folder(), "/home/a/.local/share/nazori");
    const test::EnvironmentVariable no_home("HOME", none == nullptr ? nullptr : "");
    EXPECT_EQ(user_data_folder(), "");
  }
}

}  // namespace
}  // namespace nazori::base
