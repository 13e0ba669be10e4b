// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nazori/json/reader.h"

namespace nazori::json {
namespace {

using testing::HasSubstr;

std::string object_of(int members) {
  std::string text = "{";
  for (int i = 0; i < members; ++i) text += (i == 0 ? "\"" : ",\"") + std::to_string(i) + "\":0";
  return text + "}";
}

TEST(JsonLimits, AnObjectHasAThousandMembersUnlessToldOtherwise) {
  EXPECT_TRUE(parse(object_of(1000)));
  EXPECT_EQ(parse(object_of(1001)).error().what, "has an object of more than 1000 members");
  EXPECT_EQ(parse(object_of(1001)).error().where, "the JSON text");
}

TEST(JsonLimits, ATextIsSixteenMebibytesLongUnlessToldOtherwise) {
  std::string text = "7";
  text.resize(std::size_t{16} * 1024 * 1024, ' ');
  EXPECT_TRUE(parse(text));
  EXPECT_EQ(parse(text + ' ').error().what, "is longer than 16777216 bytes");
}

/// What reading says is wrong with {"a": value}.
template <class Read>
std::string refusal_of(const std::string& value, Read read) {
  const std::string text = "{\"a\": " + value + "}";
  const auto document = parse(text);
  Reader reader(text);
  Reader::Object root = reader.root(*document);
  read(root);
  return reader.ok() ? std::string() : base::to_line(reader.error());
}

TEST(JsonLimits, AMembersTextIsTenThousandBytesLongUnlessToldOtherwise) {
  std::string read;
  const auto take = [&](Reader::Object& object) { read = object.text("a"); };
  EXPECT_EQ(refusal_of('"' + std::string(10'000, 'x') + '"', take), "");
  EXPECT_EQ(read.size(), 10'000U);
  EXPECT_THAT(refusal_of('"' + std::string(10'001, 'x') + '"', take), HasSubstr("longer than 10000 bytes"));
  EXPECT_EQ(read, "") << "what is refused is not given";
}

TEST(JsonLimits, WholeNumbersEndWithTheirRange) {
  std::int64_t read = 0;
  const auto take = [&](Reader::Object& object) { read = object.whole("a", 2, 5); };
  for (const int fine : {2, 5}) {
    EXPECT_EQ(refusal_of(std::to_string(fine), take), "");
    EXPECT_EQ(read, fine);
  }
  for (const int wrong : {1, 6}) {
    EXPECT_THAT(refusal_of(std::to_string(wrong), take), HasSubstr("give 2 to 5")) << wrong;
    EXPECT_EQ(read, 2) << "the lowest stands for what is refused";
  }
  int left_out = 9;
  const auto read_to = [&](Reader::Object& object) { object.read("a", left_out, 2, 5); };
  EXPECT_EQ(refusal_of("2", read_to), "");
  EXPECT_EQ(left_out, 2);
  EXPECT_THAT(refusal_of("1", read_to), HasSubstr("give 2 to 5"));
  EXPECT_EQ(left_out, 2);
}

TEST(JsonLimits, WhatIsOfAnotherKindIsRefusedWithADefault) {
  const auto truth = [](Reader::Object& object) { EXPECT_FALSE(object.truth("a")); };
  EXPECT_THAT(refusal_of("1", truth), HasSubstr("is neither true nor false"));
  EXPECT_EQ(refusal_of("false", truth), "");
  EXPECT_EQ(refusal_of("true", [](Reader::Object& object) { EXPECT_TRUE(object.truth("a")); }), "");
  EXPECT_THAT(refusal_of("\"1\"", [](Reader::Object& object) { EXPECT_EQ(object.number("a", 0.5, 2), 0.5); }),
              HasSubstr("is not a number"));
  // An object that is none has no members.
  EXPECT_THAT(refusal_of("[]",
                         [](Reader::Object& object) {
                           Reader::Object inner = object.object("a");
                           EXPECT_FALSE(inner.has("b"));
                           EXPECT_EQ(inner.text("b"), "");
                         }),
              HasSubstr("line 1, a: is not an object"));
  EXPECT_THAT(
      refusal_of("1", [](Reader::Object& object) { object.each("a", [](Reader::Object&) { FAIL(); }); }),
      HasSubstr("is not a list"));
}

TEST(JsonLimits, EachElementIsReadInItsOrder) {
  std::vector<std::int64_t> read;
  EXPECT_EQ(refusal_of(R"([{"b": 3}, {"b": 1}, {"b": 2}])",
                       [&](Reader::Object& object) {
                         object.each("a", [&](Reader::Object& one) {
                           EXPECT_EQ(one.pointer_to("b"), "/a/" + std::to_string(read.size()) + "/b");
                           read.push_back(one.whole("b", 0, 9));
                         });
                       }),
            "");
  EXPECT_EQ(read, (std::vector<std::int64_t>{3, 1, 2}));
}

TEST(JsonLimits, WhatIsWrongHasTheLineOfItsMemberAndWhatIsMissingThatOfItsObject) {
  const std::string text = "{\n\"a\":\n{\n\"b\": 1,\n\"c\": 2\n}\n}";
  const auto document = parse(text);
  const auto where = [&](const char* member) {
    Reader reader(text);
    Reader::Object root = reader.root(*document);
    (void)root.object("a").text(member);
    return reader.error().where;
  };
  EXPECT_EQ(where("b"), "line 4, a/b");
  EXPECT_EQ(where("c"), "line 5, a/c");
  EXPECT_EQ(where("d"), "line 3, a/d");
}

}  // namespace
}  // namespace nazori::json
