// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/trajectory_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <string>
#include <vector>

#include "files_under_test.h"
#include "piece_source.h"

namespace nazori::recording {
namespace {

using testing::HasSubstr;

struct Read {
  std::vector<TrajectoryPoint> points;
  std::string trouble;  ///< in one line; empty where there was none
};

Read read_all(base::Result<TrajectoryReader> reader) {
  Read read;
  while (reader) {
    TrajectoryPoint point;
    const auto more = reader->next(point);
    if (!more) {
      read.trouble = base::to_line(more.error());
      return read;
    }
    if (!*more) return read;
    read.points.push_back(point);
  }
  read.trouble = base::to_line(reader.error());
  return read;
}

Read read(const std::string& text) {
  return read_all(TrajectoryReader::from(memory_source(text, "hand.csv")));
}

TEST(TrajectoryCsv, ReadsSecondsAndMetres) {
  const Read got = read("t,x,y,z\n0,0.01,-0.02,3e-3\n0.001,1,2,+3.5\n");
  EXPECT_EQ(got.trouble, "");
  ASSERT_EQ(got.points.size(), 2U);
  EXPECT_EQ(got.points[0].time_s, 0);
  EXPECT_EQ(got.points[0].position_m, haptics::Vec3(0.01, -0.02, 0.003));
  EXPECT_EQ(got.points[1].time_s, 0.001);
  EXPECT_EQ(got.points[1].position_m, haptics::Vec3(1, 2, 3.5));
}

TEST(TrajectoryCsv, TakesColumnsInAnyOrderAndPassesOverOthers) {
  const Read got = read("name,z,force,y,x,t\nfirst,3,junk,2,1,0.5\n\"a, b\",6,,5,4,0.6\n");
  EXPECT_EQ(got.trouble, "");
  ASSERT_EQ(got.points.size(), 2U);
  EXPECT_EQ(got.points[0].time_s, 0.5);
  EXPECT_EQ(got.points[0].position_m, haptics::Vec3(1, 2, 3));
  EXPECT_EQ(got.points[1].position_m, haptics::Vec3(4, 5, 6));
}

TEST(TrajectoryCsv, TakesByteOrderMarkCarriageReturnsQuotesSpacesAndEmptyLines) {
  const Read got = read("\xEF\xBB\xBF\"t\", \"x\",y ,z\r\n\r\n0 , 1,2,3\r\n\n1,\"2\",3,4\r\n\r\n");
  EXPECT_EQ(got.trouble, "");
  ASSERT_EQ(got.points.size(), 2U);
  EXPECT_EQ(got.points[1].position_m, haptics::Vec3(2, 3, 4));
}

TEST(TrajectoryCsv, TakesALastLineWithoutItsEnd) { EXPECT_EQ(read("t,x,y,z\n0,1,2,3").points.size(), 1U); }

TEST(TrajectoryCsv, ReadsWhatAnyLocaleWouldReadOtherwise) {
  const std::string old = std::setlocale(LC_ALL, nullptr);
  const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
  const Read got = read("t,x,y,z\n0.5,1.5,2.5,3.5\n");
  std::setlocale(LC_ALL, old.c_str());
  ASSERT_EQ(got.points.size(), 1U) << (german != nullptr ? german : "C");
  EXPECT_EQ(got.points[0].position_m.x, 1.5);
}

TEST(TrajectoryCsv, NamesLineAndFaultOfEveryBadInput) {
  const std::string head = "t,x,y,z\n0,0,0,0\n";
  for (const auto& [text, line, words] : std::vector<std::tuple<std::string, int, std::string>>{
           {"", 1, "empty"},
           {"\n\n\n", 3, "empty"},
           {"t,x,y\n0,0,0\n", 1, "lacks the column z"},
           {"0,0,0,0\n", 1, "lacks the columns t, x, y, z"},
           {"t;x;y;z\n0;0;0;0\n", 1, "lacks the columns"},
           {"t,x,y,z,x\n0,0,0,0,0\n", 1, "column x twice"},
           {"t,x,y,z\n", 1, "at least one row"},
           {"t,x,y,z\n\n", 2, "at least one row"},
           {head + "1,nan,0,0\n", 3, "x is not a finite number: 'nan'"},
           {head + "1,0,inf,0\n", 3, "y is not a finite number"},
           {head + "1,0,0,-Infinity\n", 3, "z is not a finite number"},
           {head + "1,0,0,1e999\n", 3, "z is not a finite number"},
           {head + "1,0,0,0x10\n", 3, "'0x10'"},
           {head + "1,0,0,1.2.3\n", 3, "'1.2.3'"},
           {head + "1,0,0,3 mm\n", 3, "'3 mm'"},
           {head + "1,0,,0\n", 3, "y is missing"},
           {head + "1,0,0\n", 3, "3 of the header's 4"},
           {head + "1,0,0,0,0\n", 3, "more values than the header's 4"},
           {head + "\n-1,0,0,0\n", 4, "time goes back from 0 to -1"},
           {head + "0,0,0,0\n", 3, "the time 0 comes twice"},
           {head + "1,+,0,0\n", 3, "x is not a finite number: '+'"},
           {head + "1,+-2,0,0\n", 3, "'+-2'"},
           {head + "1,++2,0,0\n", 3, "'++2'"},
           {head + "1,\"2,0,0\n", 3, "'\"2'"},
           {head + "1,\",0,0\n", 3, "'\"'"},
           {head + "1,\"\",0,0\n", 3, "x is missing"},
           {head + "1,\"2,5\",0,0\n", 3, "'2,5'"},
           {head + "1,2\r3,0,0\n", 3, "'2?3'"},
           {head + "1,2\x7F\x1F~ 3,0,0\n", 3, "'2??~ 3'"},
           {"x,y\n", 1, "lacks the columns t, z"},
           {"\n\xEF\xBB\xBFt,x,y,z\n0,0,0,0\n", 2, "lacks the column t"},
           {"t,x,y,z,t\n", 1, "the header names the column t twice"},
       }) {
    const Read got = read(text);
    EXPECT_THAT(got.trouble, HasSubstr("hand.csv:" + std::to_string(line) + ": ")) << text;
    EXPECT_THAT(got.trouble, HasSubstr(words)) << text;
  }
}

TEST(TrajectoryCsv, RefusesALineWithoutEndBeforeItFillsTheMemory) {
  EXPECT_THAT(read(std::string(200'000, 'x')).trouble,
              HasSubstr("hand.csv:1: the line is longer than 65536"));
  EXPECT_THAT(read("t,x,y,z\n0,0,0,0\n1,0,0," + std::string(3'000'000, '1') + "\n").trouble,
              HasSubstr("hand.csv:3: the line is longer"));
}

TEST(TrajectoryCsv, ALineOfTheGreatestLengthIsRead) {
  const auto with = [](std::size_t length) {
    std::string line = "1,2,3,4,";
    line.resize(length, ' ');
    return read("t,x,y,z,note\n" + line + "\n");
  };
  const Read longest = with(TrajectoryReader::kLongestLine);
  EXPECT_EQ(longest.trouble, "");
  EXPECT_EQ(longest.points.size(), 1U);
  EXPECT_THAT(with(65537).trouble,
              HasSubstr("hand.csv:2: the line is longer than 65536 bytes (is this a CSV file?)"));
  std::string last = "t,x,y,z,note\n1,2,3,4,";
  last.resize(13 + 65536, ' ');
  EXPECT_EQ(read(last).points.size(), 1U) << "and without its end";
}

TEST(TrajectoryCsv, FieldsInQuotesMayHoldCommasAndBlanksAroundThemDoNotCount) {
  const Read got = read("note, \"t\" ,\tx,y,z\n \"a,b\" , \" 1 \",\"2\",3\t, 4 \n\"\",2,3,4,5\n");
  EXPECT_EQ(got.trouble, "");
  ASSERT_EQ(got.points.size(), 2U);
  EXPECT_EQ(got.points[0].time_s, 1);
  EXPECT_EQ(got.points[0].position_m, haptics::Vec3(2, 3, 4));
}

TEST(TrajectoryCsv, IsReadAsWellInPieces) {
  std::string text = "t,x,y,z\r\n";
  for (int i = 0; i < 100; ++i) text += std::to_string(i) + ",1,2,3\r\n";
  for (const std::size_t piece : {1U, 7U, 1000U}) {
    const Read got = read_all(TrajectoryReader::from(std::make_unique<test::PieceSource>(text, piece)));
    EXPECT_EQ(got.trouble, "");
    EXPECT_EQ(got.points.size(), 100U);
  }
  EXPECT_EQ(read_all(TrajectoryReader::from(std::make_unique<test::PieceSource>("", 7, 0, true))).trouble,
            "pieces: the plug was pulled");
  const Read broken = read_all(TrajectoryReader::from(std::make_unique<test::PieceSource>(text, 7, 0, true)));
  EXPECT_EQ(broken.points.size(), 100U);
  EXPECT_EQ(broken.trouble, "pieces: the plug was pulled");
}

TEST(TrajectoryCsv, ProgressIsTheShareOfTheInputThatWasRead) {
  const std::string text = "t,x,y,z\n1,0,0,0\n2,0,0,0\n";  // three lines of eight bytes
  auto reader = TrajectoryReader::from(memory_source(text, "hand.csv"));
  ASSERT_TRUE(reader);
  TrajectoryPoint point;
  EXPECT_EQ(reader->line(), 1U);
  EXPECT_DOUBLE_EQ(reader->progress(), 1.0 / 3);
  ASSERT_TRUE(*reader->next(point));
  EXPECT_EQ(reader->line(), 2U);
  EXPECT_DOUBLE_EQ(reader->progress(), 2.0 / 3);
  ASSERT_TRUE(*reader->next(point));
  EXPECT_EQ(reader->progress(), 1);
  EXPECT_FALSE(*reader->next(point));
  auto piped = TrajectoryReader::from(std::make_unique<test::PieceSource>(text, 100));
  EXPECT_EQ(piped->progress(), 0) << "of a length that nobody knows";
  auto grown = TrajectoryReader::from(std::make_unique<test::PieceSource>(text, 100, 4));
  EXPECT_EQ(grown->progress(), 1) << "a file that has grown since";
}

TEST(TrajectoryCsv, FortyBytesOfAWrongFieldAreShown) {
  const std::string shown(40, 'q');
  EXPECT_THAT(read("t,x,y,z\n0,0,0," + shown + "\n").trouble, HasSubstr("'" + shown + "' "));
  EXPECT_THAT(read("t,x,y,z\n0,0,0," + shown + "r\n").trouble, HasSubstr("'" + shown + "...' "));
}

TEST(TrajectoryCsv, AFieldBeyondTheLongestShownIsCutInTheMessage) {
  EXPECT_LT(read("t,x,y,z\n0,0,0,\x01" + std::string(5000, 'q') + "\n").trouble.size(), 200U);
}

TEST(TrajectoryCsv, MissingFilesAndFoldersAreRefused) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(TrajectoryReader::open(folder / "none.csv").error().code, base::Errc::not_found);
  EXPECT_EQ(TrajectoryReader::open(folder / ".").error().code, base::Errc::io);
}

/// A hand that never ends, made as it is read.
class LongSource final : public ByteSource {
 public:
  explicit LongSource(std::uint64_t rows) : rows_(rows) {}
  base::Result<std::size_t> read(std::span<char> out) override {
    largest = std::max(largest, out.size());
    if (pending_.empty() && row_ < rows_) {
      if (row_ == 0) pending_ = "t,x,y,z\n";
      for (int i = 0; i < 1000 && row_ < rows_; ++i) pending_ += std::to_string(row_++) + ",0.01,0.02,0.03\n";
    }
    const std::size_t n = std::min(out.size(), pending_.size());
    std::copy_n(pending_.begin(), n, out.begin());
    pending_.erase(0, n);
    return n;
  }
  [[nodiscard]] std::uint64_t size() const override { return 0; }
  [[nodiscard]] const std::string& name() const override { return name_; }
  inline static std::size_t largest = 0;

 private:
  std::uint64_t rows_, row_ = 0;
  std::string pending_, name_ = "long";
};

TEST(TrajectoryCsv, StreamsAnyLengthThroughOneMegabyte) {
  constexpr std::uint64_t kRows = 300'000;
  auto reader = TrajectoryReader::from(std::make_unique<LongSource>(kRows));
  ASSERT_TRUE(reader);
  TrajectoryPoint point;
  std::uint64_t rows = 0;
  while (*reader->next(point)) EXPECT_EQ(point.time_s, static_cast<double>(rows++));
  EXPECT_EQ(rows, kRows);
  EXPECT_EQ(reader->line(), kRows + 1);
  EXPECT_LE(LongSource::largest, std::size_t{1} << 20);
}

}  // namespace
}  // namespace nazori::recording
