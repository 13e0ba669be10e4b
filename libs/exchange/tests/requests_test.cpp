// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/requests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nazori/exchange/practice_requests.h"

namespace nazori::exchange {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Reply reply(std::string_view line) {
  return reply_to(line, 7, {{"found", false}}, [](const Value& request) -> base::Result<Value> {
    if (request.contains("wrong"))
      return base::fail(base::Errc::bad_argument, "is wrong", "wrong", "leave it out");
    return Value{{"found", true}};
  });
}

TEST(Requests, AreAnsweredInOneLineWithTheirId) {
  EXPECT_EQ(reply("{}").line, "{\"version\":1,\"found\":true}\n");
  EXPECT_FALSE(reply("{}").is_refusal);
  EXPECT_EQ(reply(R"({"id": [1, {"a": null}]})").line,
            "{\"version\":1,\"id\":[1,{\"a\":null}],\"found\":true}\n");
}

TEST(Requests, ThatAreRefusedAreAnsweredWithTheirLine) {
  const Reply refused = reply(R"({"id": "a", "wrong": 1})");
  EXPECT_TRUE(refused.is_refusal);
  EXPECT_EQ(refused.line,
            "{\"version\":1,\"id\":\"a\",\"line\":7,\"error\":\"wrong: is wrong (leave it "
            "out)\",\"found\":false}\n");
}

TEST(Requests, ThatAreNoObjectNameTheLine) {
  for (const char* line : {"", "[]", "7", "null", "\"x\"", "{", "{\"a\":1e999}", "\xff"}) {
    const auto answer = json::parse(reply(line).line);
    ASSERT_TRUE(answer) << line;
    EXPECT_EQ((*answer)["line"], 7) << line;
    EXPECT_THAT((*answer)["error"].get<std::string>(), StartsWith("line 7")) << line;
    EXPECT_TRUE(reply(line).is_refusal) << line;
  }
  EXPECT_THAT(reply("{\"a\" 1}").line, HasSubstr("line 7, column 6: is not JSON"));
  EXPECT_THAT(reply(std::string(100'000, '[')).line, HasSubstr("line 7: is nested too deeply"));
}

TEST(Requests, OfAnotherVersionAreRefused) {
  EXPECT_FALSE(reply(R"({"version": 1})").is_refusal);
  for (const char* version : {"0", "2", "\"1\"", "null", "1.5"}) {
    const Reply refused = reply(std::string("{\"version\": ") + version + "}");
    EXPECT_TRUE(refused.is_refusal) << version;
    EXPECT_THAT(refused.line, HasSubstr("version: is ")) << version;
  }
  EXPECT_THAT(reply(R"({"version": 2})").line, HasSubstr("version: is 2, not 1"));
  const std::string digits(60, '7');
  EXPECT_THAT(
      reply("{\"version\": [" + digits.substr(0, 15) + "," + digits.substr(0, 15) + ",77777777777]}").line,
      HasSubstr("version: is [" + digits.substr(0, 15) + "," + digits.substr(0, 15) + ",7777777, not 1"));
}

base::Result<PracticeRequest> read(const char* text) {
  return read_practice_request(json::parse(text).value());
}

TEST(PracticeRequests, AreStrokesStagesRatingsAndCommands) {
  EXPECT_TRUE(std::holds_alternative<writing::WrittenCharacter>(*read(R"({"strokes": [[[1, 2]]]})")));
  EXPECT_EQ(std::get<StageChoice>(*read(R"({"stage": "guided"})")).stage, "guided");
  EXPECT_EQ(std::get<study::Rating>(*read(R"({"do": "easy"})")), study::Rating::easy);
  EXPECT_EQ(std::get<PracticeCommand>(*read(R"({"do": "go_on"})")).name, "go_on");
}

TEST(PracticeRequests, ComeBackAsTheyWereWritten) {
  for (const PracticeRequest& request :
       {PracticeRequest(PracticeCommand{"hint"}), PracticeRequest(StageChoice{"trace"}),
        PracticeRequest(study::Rating::again)}) {
    const auto again = read_practice_request(to_json(request));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->index(), request.index());
    EXPECT_EQ(to_json(*again), to_json(request));
  }
  const auto ink = read_practice_request(to_json(*read(R"({"strokes": [[[1, 2]]]})")));
  EXPECT_EQ(std::get<writing::WrittenCharacter>(*ink).strokes[0][0].at.y, 2);
}

TEST(PracticeRequests, ThatCannotBeReadSayWhy) {
  EXPECT_EQ(base::to_line(read(R"({"id": 1})").error()),
            "request: asks for nothing (give strokes, stage or do)");
  EXPECT_EQ(read(R"({"do": 7})").error().where, "request");
  EXPECT_EQ(read(R"({"strokes": 7, "do": "undo"})").error().where, "strokes") << "strokes come first";
}

}  // namespace
}  // namespace nazori::exchange
