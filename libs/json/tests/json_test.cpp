// SPDX-License-Identifier: Apache-2.0
#include "nazori/json/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "nazori/json/reader.h"

namespace nazori::json {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Json, WhatIsNoneIsNamedByItsLineAndColumn) {
  EXPECT_EQ(parse("{\n\"a\": 1,\n}").error().where, "line 3, column 1");
  EXPECT_EQ(parse("x").error().where, "line 1, column 1");
  EXPECT_EQ(parse("").error().where, "line 1, column 1");
  EXPECT_EQ(parse("[1,\n2").error().where, "line 2, column 2");
  EXPECT_EQ(parse("[1\nx]").error().where, "line 2, column 1");
  EXPECT_EQ(parse("[1x\n\n]").error().where, "line 1, column 3");
  EXPECT_EQ(parse("\n\n[1, }").error().where, "line 3, column 5");
  EXPECT_EQ(parse("[1, \"a\nb\"]").error().where, "line 1, column 7") << "a line break in a text is its end";
  // The reason alone, without the parser's own place.
  EXPECT_THAT(parse("[1,").error().what, StartsWith("is not JSON: syntax error"));
  for (const char* wrong : {"1e999", "{} {}", "[1] x", "\"\xff\"", "nul", "01", "[1,]", "{\"a\" 1}", "'a'"})
    EXPECT_EQ(parse(wrong).error().code, base::Errc::parse) << wrong;
}

TEST(Json, IsReadWhole) {
  const auto value =
      parse(R"( {"a": [1, -2, 2.5, "é\u0041", true, null, {}, []], "b": {"c": [[{"d": 7}]]}, "e": 1} )");
  ASSERT_TRUE(value);
  EXPECT_EQ(to_line(*value), R"({"a":[1,-2,2.5,"éA",true,null,{},[]],"b":{"c":[[{"d":7}]]},"e":1})");
  EXPECT_EQ(parse("7")->get<int>(), 7);
  EXPECT_EQ(parse("18446744073709551615")->get<std::uint64_t>(), 18446744073709551615U);
}

TEST(Json, OfTwoMembersOfOneNameTheLastCounts) {
  EXPECT_EQ(to_line(*parse(R"({"a": 1, "b": [2], "a": {"c": 3}})")), R"({"a":{"c":3},"b":[2]})");
}

TEST(Json, IsNestedSixtyFourDeepAtMost) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(parse(nested(64)));
  EXPECT_EQ(parse(nested(65)).error().what, "is nested too deeply");
  EXPECT_EQ(parse(std::string(10'000'000, '[')).error().what, "is nested too deeply") << "never closed";
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += R"({"a":)";
  EXPECT_EQ(parse(objects).error().what, "is nested too deeply");
  // Brackets and braces count together, those in texts and those one after another do not.
  const Limits three{.depth = 3};
  EXPECT_TRUE(parse(R"({"a":[{"b":1},{"c":2}]})", three));
  EXPECT_FALSE(parse(R"({"a":[{"b":[]},{"c":2}]})", three));
  EXPECT_TRUE(parse(R"(["[[[[{{{{", "\"[[[[", "\\"])", {.depth = 1}));
  EXPECT_TRUE(parse("[[],[],{}]", {.depth = 2}));
  EXPECT_TRUE(parse("7", {.depth = 0}));
  EXPECT_FALSE(parse("[]", {.depth = 0}));
}

TEST(Json, IsNoLongerThanItMayBe) {
  EXPECT_TRUE(parse("[1,2]", {.bytes = 5}));
  const auto longer = parse("[1,2]", {.bytes = 4});
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().code, base::Errc::parse);
  EXPECT_EQ(longer.error().what, "is longer than 4 bytes");
}

TEST(Json, AnObjectHasNoMoreMembersThanItMay) {
  const Limits two{.members = 2};
  EXPECT_TRUE(parse(R"({"a":1,"b":2})", two));
  EXPECT_TRUE(parse(R"({"a":1,"b":2,"a":3})", two)) << "it is there already";
  EXPECT_EQ(parse(R"({"a":1,"b":2,"c":3})", two).error().what, "has an object of more than 2 members");
  EXPECT_TRUE(parse(R"([{"a":1,"b":2},{"c":3},1,2,3])", two));
}

TEST(Json, IsWrittenInTheOrderOfItsMembersWhateverTheTextsHold) {
  Value value;
  value["z"] = 1;
  value["a"] = Value::array({0.1, std::numeric_limits<double>::infinity(), "\xff"});
  EXPECT_EQ(to_line(value), "{\"z\":1,\"a\":[0.1,null,\"\xEF\xBF\xBD\"]}");
  EXPECT_EQ(to_text(Value{{"b", 1}, {"a", Value::object()}}), "{\n  \"b\": 1,\n  \"a\": {}\n}\n");
}

TEST(Json, TheLineOfAValueIsWhereItStands) {
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
  const auto document = parse(text);
  EXPECT_TRUE(document) << text;
  Reader reader(text);
  Reader::Object root = reader.root(*document);
  read(root);
  return reader.ok() ? std::string() : base::to_line(reader.error());
}

TEST(JsonReader, TextIsAsLongAsItMayBe) {
  const auto read = [](Reader::Object& object) { (void)object.text("a", 3); };
  EXPECT_EQ(refusal(R"({"a": "abc"})", read), "");
  EXPECT_THAT(refusal(R"({"a": "abcd"})", read), HasSubstr("longer than 3 bytes"));
  EXPECT_THAT(refusal(R"({"a": 7})", read), HasSubstr("is not a text"));
  EXPECT_THAT(refusal("{}", read), HasSubstr("is missing"));
  EXPECT_THAT(refusal("[]", read), HasSubstr("is not an object"));
}

TEST(JsonReader, WholeNumbersAreThoseOfTheRange) {
  const auto read = [](Reader::Object& object) { (void)object.whole("a", -5, INT64_MAX); };
  EXPECT_EQ(refusal(R"({"a": -5})", read), "");
  EXPECT_EQ(refusal(R"({"a": 9223372036854775807})", read), "");
  for (const char* wrong :
       {"-6", "9223372036854775808", "18446744073709551615", "1.0", "\"1\"", "null", "true"})
    EXPECT_THAT(refusal(std::string("{\"a\": ") + wrong + "}", read), HasSubstr("is not a whole number"))
        << wrong;
  // What is said repeats no more than forty bytes of what stands there.
  const std::string said = refusal("{\"a\": \"" + std::string(100, 'x') + "\"}", read);
  EXPECT_THAT(said, HasSubstr("\"" + std::string(39, 'x') + " is no"));
}

TEST(JsonReader, NumbersAreThoseOfTheRange) {
  const auto read = [](Reader::Object& object) { (void)object.number("a", -0.5, 2); };
  for (const char* fine : {"-0.5", "0", "2", "2.0", "1e-3"})
    EXPECT_EQ(refusal(std::string("{\"a\": ") + fine + "}", read), "") << fine;
  for (const char* wrong : {"-0.51", "2.001", "3", "\"1\"", "null", "[]"})
    EXPECT_THAT(refusal(std::string("{\"a\": ") + wrong + "}", read), HasSubstr("give -0.5 to 2")) << wrong;
  const std::string said = refusal("{\"a\": \"" + std::string(100, 'x') + "\"}", read);
  EXPECT_THAT(said, HasSubstr("\"" + std::string(39, 'x') + " is no"));
}

TEST(JsonReader, TheFirstFaultIsTheOneThatIsSaid) {
  const std::string text = "{\"a\": 1,\n\"b\": [{\"c\": 1},\n{\"c\": \"x\"},\n{\"c\": 3}],\n\"d\": true}";
  const auto document = parse(text);
  Reader reader(text);
  Reader::Object root = reader.root(*document);
  std::vector<std::int64_t> read;
  root.each("b", [&](Reader::Object& one) { read.push_back(one.whole("c", 0, 10)); });
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
  const auto document = parse(part);
  Reader reader(part, "/entries/7", 20);
  Reader::Object root = reader.root(*document);
  Reader::Object inner = root.object("a");
  EXPECT_EQ(inner.whole("b", 0, 1), 1);
  EXPECT_TRUE(reader.ok());
  (void)inner.whole("c", 0, 1);
  EXPECT_EQ(reader.error().where, "line 22, entries/7/a/c");
  EXPECT_EQ(reader.error().what, "is missing");
}

TEST(JsonReader, TellsWhatIsThere) {
  const std::string text = R"({"a": null, "b": false, "c": {"d": [1, "é"]}})";
  const auto document = parse(text);
  Reader reader(text);
  Reader::Object root = reader.root(*document);
  EXPECT_FALSE(root.has("a"));
  EXPECT_TRUE(root.has("b"));
  EXPECT_FALSE(root.has("x"));
  EXPECT_FALSE(root.truth("b"));
  EXPECT_EQ(root.raw("c"), R"({"d":[1,"é"]})");
  EXPECT_TRUE(reader.ok());
  const Value list = Value::array();
  EXPECT_FALSE(reader.root(list).has("a"));
}

TEST(JsonReader, WhatMayBeLeftOutKeepsItsValue) {
  int whole = 3;
  double number = 0.5;
  bool truth = true;
  std::string text = "x";
  const auto read = [&](Reader::Object& object) {
    object.read("whole", whole, 1, 5);
    object.read("number", number, 0, 1);
    object.read("truth", truth);
    object.read("text", text);
  };
  EXPECT_EQ(refusal("{}", read), "");
  EXPECT_EQ(refusal(R"({"whole": 5, "number": 1, "truth": false, "text": ""})", read), "");
  EXPECT_EQ(whole, 5);
  EXPECT_EQ(number, 1);
  EXPECT_FALSE(truth);
  EXPECT_EQ(text, "");
  EXPECT_THAT(refusal(R"({"whole": 6})", read), HasSubstr("line 1, whole: 6 is not a whole number"));
  EXPECT_THAT(refusal(R"({"number": -0.1})", read), HasSubstr("give 0 to 1"));
  EXPECT_THAT(refusal(R"({"truth": 1})", read), HasSubstr("truth: is neither true nor false"));
  EXPECT_THAT(refusal(R"({"text": 1})", read), HasSubstr("text: is not a text"));
  for (const char* member : {"whole", "number", "truth", "text"})
    EXPECT_THAT(refusal(std::string("{\"") + member + "\": null}", read), HasSubstr(member))
        << "null is there";
  EXPECT_EQ(whole, 5) << "what is refused is not taken";
  EXPECT_EQ(number, 1);
  EXPECT_EQ(text, "");
}

TEST(JsonReader, AnArrayOfNumbersHasTheLengthItShould) {
  std::vector<double> numbers;
  const auto read = [&](Reader::Object& object) { numbers = object.numbers("a", 2); };
  EXPECT_EQ(refusal(R"({"a": [1, -2.5]})", read), "");
  EXPECT_EQ(numbers, (std::vector<double>{1, -2.5}));
  for (const char* wrong : {"[1]", "[1, 2, 3]", "[1, \"2\"]", "[1, 2, null]"}) {
    EXPECT_THAT(refusal(std::string("{\"a\": ") + wrong + "}", read), HasSubstr("give 2 numbers")) << wrong;
    EXPECT_EQ(numbers.size(), 2U);
  }
  EXPECT_THAT(refusal(R"({"a": 1})", read), HasSubstr("is not a list"));
  EXPECT_EQ(numbers.size(), 2U);
  EXPECT_THAT(refusal("{}", read), HasSubstr("is missing"));
}

}  // namespace
}  // namespace nazori::json
