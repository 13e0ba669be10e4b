// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/profiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "environment_variable.h"
#include "learner_fixture.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;
using test::must;
using test::TemporaryFolder;
using testing::ElementsAre;

std::string folder_with(const char* own, const char* data, const char* home) {
  const nazori::test::EnvironmentVariable one("NAZORI_LEARNERS", own);
  const nazori::test::EnvironmentVariable two("XDG_DATA_HOME", data);
  const nazori::test::EnvironmentVariable three("HOME", home);
  const auto folder = profiles_folder();
  return folder ? folder->string() : base::to_line(folder.error());
}

TEST(ProfilesFolder, IsThatOfTheEnvironmentElseOneOfTheDataElseOfTheHome) {
  EXPECT_EQ(folder_with("/own", "/data", "/home/me"), "/own");
  EXPECT_EQ(folder_with("relative", "/data", "/home/me"), "relative");
  EXPECT_EQ(folder_with("", "/data", "/home/me"), "/data/nazori/learners");
  EXPECT_EQ(folder_with(nullptr, "data", "/home/me"), "/home/me/.local/share/nazori/learners")
      << "the standard says that a relative folder is none";
  EXPECT_EQ(folder_with(nullptr, nullptr, "/home/me"), "/home/me/.local/share/nazori/learners");
  const nazori::test::EnvironmentVariable one("NAZORI_LEARNERS", nullptr);
  const nazori::test::EnvironmentVariable two("XDG_DATA_HOME", nullptr);
  for (const char* home : {"", static_cast<const char*>(nullptr)}) {
    const nazori::test::EnvironmentVariable three("HOME", home);
    ASSERT_FALSE(profiles_folder());
    EXPECT_EQ(profiles_folder().error().code, Errc::not_found);
  }
}

TEST(ProfileNames, AreSixtyBytesWithoutSlashAndDot) {
  EXPECT_TRUE(can_be_profile(std::string(60, 'x')));
  EXPECT_FALSE(can_be_profile(std::string(61, 'x')));
  EXPECT_TRUE(can_be_profile("x.y"));
  EXPECT_TRUE(can_be_profile("健太"));
  for (const char* name : {"", ".", "..", ".x", "/", "x/", "/x", " x", "x ", "x\ty"})
    EXPECT_FALSE(can_be_profile(name));
}

TEST(Names, AreAHundredBytesWithoutControlCharacters) {
  EXPECT_TRUE(can_be_name("x"));
  EXPECT_TRUE(can_be_name(std::string(100, 'x')));
  EXPECT_FALSE(can_be_name(std::string(101, 'x')));
  for (const char* fine : {"a b", "~", "!", "\xC2\xA0", "é", ".x/y"}) EXPECT_TRUE(can_be_name(fine)) << fine;
  for (const char* wrong : {"", " ", " a", "a ", "a\x1F", "\x7F", "\xC2\x80", "\xC2\x9F", "\xFF", "a\nb"})
    EXPECT_FALSE(can_be_name(wrong)) << wrong;
}

TEST(Profiles, ThatAreRemovedAreAllKept) {
  const TemporaryFolder folder;
  const fs::path root = folder / "learners";
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) {
    (void)must(LearnerStore::open(must(learner_file(root, "Mari")), Access::write));
    const fs::path gone = must(remove_profile(root, "Mari"));
    EXPECT_TRUE(fs::exists(gone / "learner.db"));
    EXPECT_EQ(gone.parent_path(), root / ".removed");
    names.push_back(gone.filename().string());
    EXPECT_TRUE(profiles(root).empty());
  }
  EXPECT_THAT(names, ElementsAre("Mari", "Mari 2", "Mari 3"));
  EXPECT_EQ(remove_profile(root, "Mari").error().code, Errc::not_found);
  EXPECT_EQ(remove_profile(root, "a/b").error().code, Errc::bad_argument);
}

TEST(Profiles, AreFoldersWithALearner) {
  const TemporaryFolder folder;
  const fs::path root = folder / "learners";
  for (const char* name : {"b", "a", ".c"}) fs::create_directories(root / name);
  for (const char* name : {"b", ".c"}) std::ofstream(root / name / "learner.db") << "";
  EXPECT_THAT(profiles(root), ElementsAre("b"));
  std::ofstream(root / "a" / "learner.db") << "";
  EXPECT_THAT(profiles(root), ElementsAre("a", "b"));
  EXPECT_EQ(must(learner_file(root, "b")), root / "b" / "learner.db");
}

TEST(Profiles, GetNoNameThatIsTakenOrNone) {
  const TemporaryFolder folder;
  const fs::path root = folder / "learners";
  (void)must(LearnerStore::open(must(learner_file(root, "Mari")), Access::write));
  fs::create_directories(root / "empty");
  EXPECT_EQ(rename_profile(root, "Mari", "empty").error().what, "already exists");
  EXPECT_EQ(rename_profile(root, "Mari", "Mari").error().what, "already exists");
  EXPECT_EQ(rename_profile(root, "Mari", ".x").error().code, Errc::bad_argument);
  EXPECT_EQ(rename_profile(root, "none", "x").error().code, Errc::not_found);
  {
    const LearnerStore held = must(LearnerStore::open(must(learner_file(root, "Mari")), Access::write));
    EXPECT_EQ(rename_profile(root, "Mari", "x").error().code, Errc::in_use);
  }
  EXPECT_THAT(profiles(root), ElementsAre("Mari"));
  EXPECT_TRUE(rename_profile(root, "Mari", "x"));
  EXPECT_THAT(profiles(root), ElementsAre("x"));
}

}  // namespace
}  // namespace nazori::study
