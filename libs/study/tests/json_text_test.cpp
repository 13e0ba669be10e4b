// SPDX-License-Identifier: Apache-2.0
#include "../src/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../src/counted_text.h"
#include "../src/named_values.h"
#include "../src/text_pieces.h"
#include "nazori/study/lesson.h"

namespace nazori::study {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(JsonText, WhatIsNoneIsNamedByItsLine) {
  EXPECT_EQ(parse_json("{\n\"a\": 1,\n}").error().where, "line 3");
  EXPECT_EQ(parse_json("x").error().where, "line 1");
  EXPECT_EQ(parse_json("").error().where, "line 1");
  EXPECT_EQ(parse_json("[1,\n2").error().where, "line 2");
  EXPECT_EQ(parse_json("[1\nx]").error().where, "line 2");
  EXPECT_EQ(parse_json("[1x\n\n]").error().where, "line 1");
  // The reason alone, without the parser's own place.
  EXPECT_THAT(parse_json("[1,").error().what, StartsWith("is not JSON: syntax error"));
  EXPECT_EQ(parse_json("1e999").error().code, base::Errc::parse);
}

TEST(JsonText, IsNestedSixtyFourDeepAtMost) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(parse_json(nested(64)));
  EXPECT_EQ(parse_json(nested(65)).error().what, "is nested too deeply");
}

TEST(JsonText, TheLineOfAValueIsWhereItStands) {
  const std::string text =
      "{\n"                        // 1
      " \"a\": 1,\n"               // 2
      " \"b\": [\n"                // 3
      "  true, null,\n"            // 4
      "  {\"c\": \"x\", \"d\":\n"  // 5
      "   2.5},\n"                 // 6
      "  [], [7,\n"                // 7
      "  8\n"                      // 8
      "  ], false\n"               // 9
      " ],\n"                      // 10
      " \"e\": {}, \"f\": -3\n"    // 11
      "}\n";
  EXPECT_EQ(line_of(text, ""), 1);
  EXPECT_EQ(line_of(text, "/a"), 2);
  EXPECT_EQ(line_of(text, "/b"), 3);
  EXPECT_EQ(line_of(text, "/b/0"), 4);
  EXPECT_EQ(line_of(text, "/b/1"), 4);
  EXPECT_EQ(line_of(text, "/b/2"), 5);
  EXPECT_EQ(line_of(text, "/b/2/c"), 5);
  EXPECT_EQ(line_of(text, "/b/2/d"), 6);
  EXPECT_EQ(line_of(text, "/b/3"), 7);
  EXPECT_EQ(line_of(text, "/b/4"), 7);
  EXPECT_EQ(line_of(text, "/b/4/0"), 7);
  EXPECT_EQ(line_of(text, "/b/4/1"), 8) << "the line break after a number belongs to what follows";
  EXPECT_EQ(line_of(text, "/b/5"), 9);
  EXPECT_EQ(line_of(text, "/e"), 11);
  EXPECT_EQ(line_of(text, "/f"), 11);
  EXPECT_EQ(line_of(text, "/g"), std::nullopt);
  EXPECT_EQ(line_of(text, "/b/6"), std::nullopt);
  EXPECT_EQ(line_of("[\n", "/0"), std::nullopt);
}

/// What reading says is wrong with a text.
template <class Read>
std::string refusal(const std::string& text, Read read) {
  const auto document = parse_json(text);
  EXPECT_TRUE(document) << text;
  JsonReader reader(text);
  JsonReader::Object root = reader.root(*document);
  read(root);
  return reader.ok() ? std::string() : base::to_line(reader.error());
}

TEST(JsonReader, TextIsAsLongAsItMayBe) {
  const auto read = [](JsonReader::Object& object) { (void)object.text("a", 3); };
  EXPECT_EQ(refusal(R"({"a": "abc"})", read), "");
  EXPECT_THAT(refusal(R"({"a": "abcd"})", read), HasSubstr("longer than 3 bytes"));
  EXPECT_THAT(refusal(R"({"a": 7})", read), HasSubstr("is no text"));
  EXPECT_THAT(refusal("{}", read), HasSubstr("is missing"));
  EXPECT_THAT(refusal("[]", read), HasSubstr("is no object"));
}

TEST(JsonReader, WholeNumbersAreThoseOfTheRange) {
  const auto read = [](JsonReader::Object& object) { (void)object.whole("a", -5, INT64_MAX); };
  EXPECT_EQ(refusal(R"({"a": -5})", read), "");
  EXPECT_EQ(refusal(R"({"a": 9223372036854775807})", read), "");
  for (const char* wrong :
       {"-6", "9223372036854775808", "18446744073709551615", "1.0", "\"1\"", "null", "true"})
    EXPECT_THAT(refusal(std::string("{\"a\": ") + wrong + "}", read), HasSubstr("no whole number")) << wrong;
  // What is said repeats no more than forty bytes of what stands there.
  const std::string said = refusal("{\"a\": \"" + std::string(100, 'x') + "\"}", read);
  EXPECT_THAT(said, HasSubstr("\"" + std::string(39, 'x') + " is no"));
}

TEST(JsonReader, NumbersAreThoseOfTheRange) {
  const auto read = [](JsonReader::Object& object) { (void)object.number("a", -0.5, 2); };
  for (const char* fine : {"-0.5", "0", "2", "2.0", "1e-3"})
    EXPECT_EQ(refusal(std::string("{\"a\": ") + fine + "}", read), "") << fine;
  for (const char* wrong : {"-0.51", "2.001", "3", "\"1\"", "null", "[]"})
    EXPECT_THAT(refusal(std::string("{\"a\": ") + wrong + "}", read), HasSubstr("give -0.5 to 2")) << wrong;
  const std::string said = refusal("{\"a\": \"" + std::string(100, 'x') + "\"}", read);
  EXPECT_THAT(said, HasSubstr("\"" + std::string(39, 'x') + " is no"));
}

TEST(JsonReader, TheFirstFaultIsTheOneThatIsSaid) {
  const std::string text = "{\"a\": 1,\n\"b\": [{\"c\": 1},\n{\"c\": \"x\"},\n{\"c\": 3}],\n\"d\": true}";
  const auto document = parse_json(text);
  JsonReader reader(text);
  JsonReader::Object root = reader.root(*document);
  std::vector<std::int64_t> read;
  root.each("b", [&](JsonReader::Object& one) { read.push_back(one.whole("c", 0, 10)); });
  EXPECT_EQ(read, (std::vector<std::int64_t>{1, 0})) << "after the fault nothing more is read";
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.error().where, "line 3, b/1/c");
  // Every answer is a default one now.
  EXPECT_EQ(root.whole("a", 0, 10), 0);
  EXPECT_FALSE(root.truth("d"));
  EXPECT_EQ(root.text("d"), "");
  EXPECT_EQ(root.raw("a"), "");
  EXPECT_EQ(root.number("a", 0.25, 2), 0.25);
  EXPECT_EQ(root.array("b"), nullptr);
  EXPECT_EQ(reader.error().where, "line 3, b/1/c");
}

TEST(JsonReader, OfAPartNamesThePlaceInTheWhole) {
  const std::string part = "{\n\"a\":\n{\"b\": 1}}";
  const auto document = parse_json(part);
  JsonReader reader(part, "/entries/7", 20);
  JsonReader::Object root = reader.root(*document);
  JsonReader::Object inner = root.object("a");
  EXPECT_EQ(inner.whole("b", 0, 1), 1);
  EXPECT_TRUE(reader.ok());
  (void)inner.whole("c", 0, 1);
  EXPECT_EQ(reader.error().where, "line 22, entries/7/a/c");
  EXPECT_EQ(reader.error().what, "is missing");
}

TEST(JsonReader, TellsWhatIsThere) {
  const std::string text = R"({"a": null, "b": false, "c": {"d": [1, "é"]}})";
  const auto document = parse_json(text);
  JsonReader reader(text);
  JsonReader::Object root = reader.root(*document);
  EXPECT_FALSE(root.has("a"));
  EXPECT_TRUE(root.has("b"));
  EXPECT_FALSE(root.has("x"));
  EXPECT_FALSE(root.truth("b"));
  EXPECT_EQ(root.raw("c"), R"({"d":[1,"é"]})");
  EXPECT_TRUE(reader.ok());
  const Json list = Json::array();
  EXPECT_FALSE(reader.root(list).has("a"));
}

TEST(NamedValues, AreThoseWithAName) {
  EXPECT_EQ(value_of<Stage>(0), Stage::watch);
  EXPECT_EQ(value_of<Stage>(3), Stage::memory);
  for (const std::int64_t none : {-1L, 4L, 255L, 256L, 259L})
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
