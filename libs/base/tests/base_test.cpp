// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "nazori/base/file.h"
#include "nazori/base/result.h"
#include "nazori/base/utf8.h"

namespace nazori::base {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("nazori_files_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST(ErrorLine, NamesPlaceEventAndRemedyOnOneLine) {
  EXPECT_EQ(to_line({Errc::parse, "has 3\nbytes", "a.raw", "4 are right"}),
            "a.raw: has 3 bytes (4 are right)");
  EXPECT_EQ(to_line({Errc::io, "failed", "", ""}), "failed");
}

TEST(Utf8, DecodesEveryLengthAndEncodesItBack) {
  const std::string text = "aé休𠮷";
  const auto decoded = decode_utf8(text);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(*decoded, U"aé休𠮷");
  EXPECT_EQ(encode_utf8(*decoded), text);
}

TEST(Utf8, RefusesWhatIsNotUtf8) {
  for (const std::string_view bad :
       {"\x80", "\xC0\x80", "\xE4\xBC", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF", "a\xE4"}) {
    EXPECT_FALSE(decode_utf8(bad)) << testing::PrintToString(bad);
  }
}

TEST(Utf8, EncodesASurrogateAsTheReplacementCharacter) {
  EXPECT_EQ(encode_utf8(char32_t{0xD800}), "\xEF\xBF\xBD");
}

TEST_F(Files, ReadBackWhatWasWritten) {
  ASSERT_TRUE(write_file(folder_ / "a", "休み"));
  const auto read = read_file(folder_ / "a", 100);
  ASSERT_TRUE(read);
  EXPECT_EQ(std::string(read->begin(), read->end()), "休み");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, AFailedWriteLeavesTheOldContentAndNothingBeside) {
  fs::create_directories(folder_ / "busy" / "inside");
  EXPECT_FALSE(write_file(folder_ / "busy", "text"));
  EXPECT_TRUE(fs::is_directory(folder_ / "busy"));
  EXPECT_EQ(entries(), 1U);
  EXPECT_FALSE(write_file(folder_ / "no" / "such" / "folder", "text"));
}

TEST_F(Files, RefusesFoldersMissingFilesAndTooLargeOnesBeforeReading) {
  EXPECT_EQ(read_file(folder_, 100).error().code, Errc::io);
  EXPECT_EQ(read_file(folder_ / "none", 100).error().code, Errc::not_found);
  ASSERT_TRUE(write_file(folder_ / "large", std::string(101, 'x')));
  EXPECT_EQ(read_file(folder_ / "large", 100).error().code, Errc::io);
  EXPECT_EQ(read_file("/dev/zero", 100).error().code, Errc::io);
}

TEST_F(Files, WrittenPieceByPieceAppearWholeOnlyWithTheCommit) {
  ASSERT_TRUE(write_file(folder_ / "a", "old"));
  auto file = OutputFile::create(folder_ / "a");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->append("new "));
  OutputFile moved = std::move(*file);
  ASSERT_TRUE(moved.append("text"));
  const auto before = read_file(folder_ / "a", 100);
  EXPECT_EQ(std::string(before->begin(), before->end()), "old");
  ASSERT_TRUE(moved.commit());
  const auto after = read_file(folder_ / "a", 100);
  EXPECT_EQ(std::string(after->begin(), after->end()), "new text");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, NeverCommittedLeaveTheOldContentAndNothingBeside) {
  ASSERT_TRUE(write_file(folder_ / "a", "old"));
  {
    auto file = OutputFile::create(folder_ / "a");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->append("new"));
  }
  const auto read = read_file(folder_ / "a", 100);
  EXPECT_EQ(std::string(read->begin(), read->end()), "old");
  EXPECT_EQ(entries(), 1U);
}

}  // namespace
}  // namespace nazori::base
