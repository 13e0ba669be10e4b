// SPDX-License-Identifier: Apache-2.0
#include "../src/counted_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../src/named_values.h"
#include "../src/text_pieces.h"
#include "nazori/study/lesson.h"

namespace nazori::study {
namespace {

using testing::HasSubstr;

TEST(NamedValues, AreThoseWithAName) {
  EXPECT_EQ(value_of<Stage>(0), Stage::watch);
  EXPECT_EQ(value_of<Stage>(3), Stage::memory);
  EXPECT_EQ(value_of<Stage>(4), Stage::brush);
  for (const std::int64_t none : {-1L, 5L, 255L, 256L, 259L})
    EXPECT_EQ(value_of<Stage>(none), std::nullopt) << none;
  EXPECT_EQ(value_of<Rating>(0), std::nullopt);
  EXPECT_EQ(value_of<Rating>(257), std::nullopt);
  EXPECT_EQ(value_named<Stage>(""), std::nullopt);
  EXPECT_EQ(value_named<Stage>("guided"), Stage::guided);
}

/// Hands out a text in pieces of some bytes.
TextSource in_pieces(const std::string& text, std::size_t bytes, std::uintmax_t told) {
  return {[rest = text, bytes](std::span<char> room) mutable -> base::Result<std::size_t> {
            const std::size_t count = rest.copy(room.data(), std::min(bytes, room.size()));
            rest.erase(0, count);
            return count;
          },
          told};
}

TEST(CountedText, IsReadByteByByteWithItsLines) {
  const std::string text = "ab\n\ncd\n";
  const TextSource source = in_pieces(text, 2, text.size());
  CountedText counted(source, {});
  std::string read;
  std::vector<int> lines;
  while (!counted.at_end()) {
    lines.push_back(counted.line());
    read += counted.front();
    counted.pop();
    EXPECT_EQ(counted.last(), read.back());
  }
  EXPECT_EQ(read, text);
  EXPECT_EQ(lines, (std::vector{1, 1, 1, 2, 3, 3, 3}));
  EXPECT_EQ(counted.line(), 4);
  EXPECT_TRUE(counted.at_end());
  EXPECT_FALSE(counted.trouble());
}

TEST(CountedText, KeepsAPartFromTheByteTakenLastOn) {
  const std::string text = "0123456789abcdefghij";
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{3}, std::size_t{7}, std::size_t{100}}) {
    const TextSource source = in_pieces(text, bytes, 0);
    CountedText counted(source, {});
    const auto take = [&](int count) {
      for (; count > 0 && !counted.at_end(); --count) counted.pop();
    };
    take(5);
    counted.begin_part();
    take(6);
    EXPECT_EQ(counted.part(), "456789a") << bytes;
    take(2);
    EXPECT_EQ(counted.part(), "456789abc") << bytes;
    counted.end_part();
    take(3);
    counted.begin_part();
    EXPECT_EQ(counted.part(), "f") << bytes;
    take(100);
    EXPECT_EQ(counted.part(), "fghij") << bytes;
  }
}

TEST(CountedText, TellsWhichShareIsRead) {
  const std::string text(300'000, 'x');
  for (const std::uintmax_t told : {std::uintmax_t{300'000}, std::uintmax_t{150'000}, std::uintmax_t{0}}) {
    std::vector<double> done;
    const TextSource source = in_pieces(text, 100'000, told);
    CountedText counted(source, [&](double share, std::string_view step) {
      EXPECT_EQ(step, "read");
      done.push_back(share);
      return true;
    });
    std::size_t taken = 0;
    for (; !counted.at_end(); ++taken) {
      counted.pop();
      if (told == 300'000) {
        ASSERT_LE(done.back(), static_cast<double>(taken) / 300'000);
      }
    }
    EXPECT_EQ(taken, text.size());
    ASSERT_GT(done.size(), 3U);
    EXPECT_EQ(done.front(), 0);
    EXPECT_EQ(done.back(), told == 0 ? 0 : 1);
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  }
}

TEST(CountedText, HandsOutNoMoreThanAPartMayHold) {
  constexpr std::size_t kMost = CountedText::kLongestPart;
  EXPECT_EQ(kMost, std::size_t{16} * 1'024 * 1'024);
  const TextSource endless{[](std::span<char> room) -> base::Result<std::size_t> {
                             std::fill(room.begin(), room.end(), '\n');
                             return room.size();
                           },
                           0};
  CountedText counted(endless, {});
  std::size_t taken = 0;
  for (; taken < 1'000 && !counted.at_end(); ++taken) counted.pop();
  counted.reset_limit();
  std::size_t more = 0;
  for (; !counted.at_end(); ++more) counted.pop();
  // It looks where it needs another piece.
  EXPECT_GE(more, kMost);
  EXPECT_LE(more, kMost + (std::size_t{64} << 10));
  ASSERT_TRUE(counted.trouble());
  EXPECT_THAT(counted.trouble()->what, HasSubstr("too long"));
  EXPECT_EQ(counted.trouble()->where, "line " + std::to_string(1 + taken + more));
}

TEST(TextPieces, AreHandedOnOnceTheyAreLargeAndAtTheEnd) {
  std::vector<std::size_t> sizes;
  const TextSink sink = [&](std::string_view piece) -> base::Result<void> {
    sizes.push_back(piece.size());
    return {};
  };
  TextPieces pieces(sink);
  EXPECT_TRUE(pieces.finish());
  EXPECT_TRUE(sizes.empty());
  pieces.add(std::string(65'535, 'x'));
  EXPECT_TRUE(sizes.empty());
  pieces.add("x");
  EXPECT_EQ(sizes, (std::vector<std::size_t>{65'536}));
  pieces.add("y");
  EXPECT_TRUE(pieces.finish());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{65'536, 1}));
}

TEST(TextPieces, NothingGoesToASinkThatHasFailed) {
  int calls = 0;
  const TextSink sink = [&](std::string_view) -> base::Result<void> {
    ++calls;
    return base::fail(base::Errc::io, "the disk is full");
  };
  TextPieces pieces(sink);
  pieces.add(std::string(70'000, 'x'));
  EXPECT_FALSE(pieces.ok());
  pieces.add(std::string(70'000, 'x'));
  EXPECT_EQ(pieces.finish().error().what, "the disk is full");
  EXPECT_EQ(calls, 1);
  const auto text =
      as_one_text([](const TextSink&) { return base::Result<void>(base::fail(base::Errc::io, "no")); });
  EXPECT_FALSE(text);
}

}  // namespace
}  // namespace nazori::study
