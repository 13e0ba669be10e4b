// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <vector>

#include "nazori/base/assignment.h"
#include "nazori/base/bands.h"
#include "nazori/base/file.h"
#include "nazori/base/progress.h"
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
  EXPECT_EQ(to_line({Errc::parse, "\x01\x1F \x7F~", "", ""}), "    ~") << "control characters are blanks";
  EXPECT_EQ(to_line({Errc::io, "failed", "", ""}), "failed");
}

TEST(Utf8, DecodesEveryLengthAndEncodesItBack) {
  const std::string text = "aé休𠮷";
  const auto decoded = decode_utf8(text);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(*decoded, U"aé休𠮷");
  EXPECT_EQ(encode_utf8(*decoded), text);
}

// Since RFC 3629 no sequence begins with one of these, so nothing may follow that would make it right.
TEST(Utf8, BytesThatBeginNoLetterAreRefused) {
  for (const int lead : {0x80, 0xBF, 0xC0, 0xC1, 0xF5, 0xF8, 0xFC, 0xFE, 0xFF})
    for (const char* rest : {"", "\x80", "\x80\x80", "\x80\x80\x80"})
      EXPECT_FALSE(decode_utf8(std::string(1, static_cast<char>(lead)) + rest)) << lead << " " << rest;
}

TEST(Bands, CoverEveryRowOnce) {
  for (const int rows : {1, 7, 100, 1023}) {
    const Bands bands(rows, 10);
    EXPECT_EQ(bands.first(0), 0);
    EXPECT_EQ(bands.last(bands.count() - 1), rows);
    for (int band = 1; band < bands.count(); ++band) EXPECT_EQ(bands.first(band), bands.last(band - 1));
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(rows));
    bands.run([&](int band) {
      for (int row = bands.first(band); row < bands.last(band); ++row) ++done[static_cast<std::size_t>(row)];
    });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(Utf8, RefusesWhatIsNotUtf8) {
  for (const std::string_view bad :
       {"\x80", "\xC0\x80", "\xE4\xBC", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF", "a\xE4"}) {
    EXPECT_FALSE(decode_utf8(bad)) << testing::PrintToString(bad);
  }
}

TEST(Utf8, TheFirstAndTheLastOfEachLengthAreAsInTheStandard) {
  // Table 3-6 of the Unicode Standard.
  const std::pair<char32_t, std::string> edges[] = {{0, std::string(1, '\0')},
                                                    {0x7F, "\x7F"},
                                                    {0x80, "\xC2\x80"},
                                                    {0x7FF, "\xDF\xBF"},
                                                    {0x800, "\xE0\xA0\x80"},
                                                    {0xFFF, "\xE0\xBF\xBF"},
                                                    {0x1000, "\xE1\x80\x80"},
                                                    {0xD7FF, "\xED\x9F\xBF"},
                                                    {0xE000, "\xEE\x80\x80"},
                                                    {0xFFFF, "\xEF\xBF\xBF"},
                                                    {0x10000, "\xF0\x90\x80\x80"},
                                                    {0x3FFFF, "\xF0\xBF\xBF\xBF"},
                                                    {0x40000, "\xF1\x80\x80\x80"},
                                                    {0x10FFFF, "\xF4\x8F\xBF\xBF"}};
  std::u32string all;
  std::string bytes;
  for (const auto& [code_point, text] : edges) {
    EXPECT_EQ(encode_utf8(code_point), text) << std::hex << static_cast<std::uint32_t>(code_point);
    EXPECT_EQ(decode_utf8(text), std::u32string(1, code_point)) << testing::PrintToString(text);
    all += code_point;
    bytes += text;
  }
  EXPECT_EQ(decode_utf8(bytes), all);
  EXPECT_EQ(encode_utf8(std::u32string_view(all)), bytes);
  EXPECT_EQ(decode_utf8(""), std::u32string());
}

TEST(Utf8, WhatIsOneBeyondTheEdgesIsRefused) {
  // Table 3-7 of the Unicode Standard: which bytes may follow which.
  for (const std::string_view bad :
       {"\x80", "\xBF", "\xC1\xBF", "\xC2\x7F", "\xC2\xC0", "\xDF", "\xE0\x9F\xBF", "\xE1\x7F\x80",
        "\xE1\x80\xC0", "\xEF\xBF", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF", "\xF1\x80\x80\xC0", "\xF4\x8F\xBF",
        "\xF5\x80\x80\x80"}) {
    EXPECT_FALSE(decode_utf8(bad)) << testing::PrintToString(bad);
    EXPECT_FALSE(decode_utf8(std::string(bad) + "a")) << testing::PrintToString(bad);
  }
}

TEST(Utf8, EncodesASurrogateAsTheReplacementCharacter) {
  for (const char32_t none : {char32_t{0xD800}, char32_t{0xDFFF}, char32_t{0x110000}})
    EXPECT_EQ(encode_utf8(none), "\xEF\xBF\xBD");
}

TEST(CheapestAssignment, CostsNoMoreThanAnyOther) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> cost(0, 1);
  for (int round = 0; round < 200; ++round) {
    const std::size_t size = 1 + static_cast<std::size_t>(round) % 6;
    std::vector<double> costs(size * size);
    for (double& c : costs) c = cost(random);
    const auto sum = [&](const std::vector<std::size_t>& column_of) {
      double total = 0;
      for (std::size_t row = 0; row < size; ++row) total += costs[row * size + column_of[row]];
      return total;
    };
    std::vector<std::size_t> any(size);
    std::iota(any.begin(), any.end(), std::size_t{0});
    double least = sum(any);
    while (std::next_permutation(any.begin(), any.end())) least = std::min(least, sum(any));
    auto found = cheapest_assignment(std::span<const double>(costs), size);
    EXPECT_NEAR(sum(found), least, 1e-12);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "a column is used twice";
  }
}

TEST_F(Files, AreReadPieceByPiece) {
  const fs::path file = folder_ / "numbers";
  std::string bytes(100'000, ' ');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>('a' + i % 26);
  ASSERT_TRUE(write_file(file, std::string_view(bytes)));
  auto input = InputFile::open(file);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->size(), bytes.size());
  InputFile moved(std::move(*input));
  std::string read;
  std::array<std::uint8_t, 333> room{};
  for (auto count = moved.read(room); count && *count > 0; count = moved.read(room)) {
    ASSERT_LE(*count, room.size());
    read.append(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(*count));
  }
  EXPECT_EQ(read, bytes);
  EXPECT_EQ(moved.read(room), 0U) << "the end stays the end";
}

TEST_F(Files, OnlyRegularOnesAreReadPieceByPiece) {
  EXPECT_EQ(InputFile::open(folder_ / "none").error().code, Errc::not_found);
  EXPECT_EQ(InputFile::open(folder_).error().code, Errc::io);
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(InputFile::open(folder_ / "pipe").error().code, Errc::io) << "and does not wait for a writer";
}

TEST(ProgressOfAPart, IsToldAsAPartOfTheWhole) {
  std::vector<double> reported;
  const Progress part = part_of(
      [&](double done, std::string_view step) {
        EXPECT_EQ(step, "copy");
        reported.push_back(done);
        return reported.size() < 3;
      },
      0.2, 0.6);
  EXPECT_TRUE(part(0, "copy"));
  EXPECT_TRUE(part(0.5, "copy"));
  EXPECT_FALSE(part(1, "copy"));
  ASSERT_EQ(reported.size(), 3U);
  EXPECT_DOUBLE_EQ(reported[0], 0.2);
  EXPECT_DOUBLE_EQ(reported[1], 0.4);
  EXPECT_DOUBLE_EQ(reported[2], 0.6);
  EXPECT_FALSE(part_of({}, 0, 1)) << "nobody to tell";
}

TEST_F(Files, ReadBackWhatWasWritten) {
  ASSERT_TRUE(write_file(folder_ / "a", "休み"));
  const auto read = read_file(folder_ / "a", 6);
  ASSERT_TRUE(read) << "as large as is allowed";
  EXPECT_EQ(std::string(read->begin(), read->end()), "休み");
  EXPECT_EQ(read_file(folder_ / "a", 5).error().what, "has 6 bytes; the limit is 5");
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

TEST_F(Files, OnceCommittedTheNameBesideThemIsFreeForOthers) {
  fs::path beside;
  {
    auto file = OutputFile::create(folder_ / "a");
    ASSERT_TRUE(file);
    beside = fs::directory_iterator(folder_)->path();
    ASSERT_TRUE(file->commit());
    std::ofstream(beside) << "of somebody else";
  }
  EXPECT_TRUE(fs::exists(beside));
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
