// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// 一 and 十 in the box of the glyphs, 109 x 109.
const char* const kOne = "[[14,54],[95,54]]";
const char* const kCross[] = {"[[14,50],[95,50]]", "[[54,14],[54,98]]"};

struct Answers {
  int code = -1;
  std::vector<Json> lines;

  /// The values of a member in the events of an answer.
  [[nodiscard]] std::vector<std::string> all(std::size_t line, const char* member) const {
    std::vector<std::string> found;
    if (line < lines.size())
      for (const Json& event : lines[line]["events"])
        if (event.contains(member)) found.push_back(event[member]);
    return found;
  }
};

Answers practise(const std::string& arguments, const std::vector<std::string>& requests) {
  const TemporaryFolder folder;
  std::string text;
  for (const std::string& request : requests) text += request + "\n";
  write(folder / "requests", text);
  const Outcome run = shell("\"$NAZORI\" practise " + arguments + " < '" + (folder / "requests") + "'");
  EXPECT_EQ(run.err, "");
  Answers answers{run.code, {}};
  std::istringstream out(run.out);
  for (std::string line; std::getline(out, line);) answers.lines.push_back(Json::parse(line));
  return answers;
}

std::string strokes(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : ",") + one;
  return R"({"strokes":[)" + text + "]}";
}

TEST(PractiseVerb, GoesThroughTheStagesOfACharacter) {
  const auto a = practise("十", {R"({"do":"watch"})", R"({"stage":"trace"})", strokes({kCross[0], kCross[1]}),
                                 R"({"stage":"guided"})", strokes({kCross[0], kCross[1]}),
                                 R"({"stage":"memory"})", strokes({kCross[0]}), strokes({kCross[1]})});
  EXPECT_EQ(a.code, 0);
  ASSERT_EQ(a.lines.size(), 9U);
  EXPECT_EQ(a.lines[0]["events"][0]["char"], "十");
  EXPECT_EQ(a.lines[0]["events"][0]["strokes"], 2);
  EXPECT_THAT(a.all(1, "event"), Contains("finished"));
  EXPECT_THAT(a.all(2, "what"), ElementsAre("draw_from_one"));
  EXPECT_THAT(a.all(3, "what"), ElementsAre("stroke_began", "stroke_written", "stroke_began", "all_written"));
  EXPECT_THAT(a.all(3, "event"), Contains("finished"));
  EXPECT_THAT(a.all(5, "what"), Contains("guided_less_help"));
  EXPECT_THAT(a.all(6, "what"), ElementsAre("write_character"));
  EXPECT_THAT(a.all(7, "what"), ElementsAre("stroke_right"));
  ASSERT_THAT(a.all(8, "what"), ElementsAre("judged"));
  EXPECT_EQ(a.lines[8]["events"][0]["accepted"], true);
}

TEST(PractiseVerb, AMistakeIsNamedAndAStrokeUndone) {
  const auto a = practise("一 --stage memory", {strokes({"[[95,54],[14,54]]"}), R"({"do":"undo"})",
                                                R"({"do":"hint"})", R"({"do":"answer"})"});
  EXPECT_EQ(a.code, 0);
  ASSERT_EQ(a.lines.size(), 5U);
  EXPECT_THAT(a.all(1, "tone"), Contains("wrong"));
  EXPECT_THAT(a.all(1, "mistake"), Contains("reversed"));
  EXPECT_THAT(a.all(2, "what"), ElementsAre("stroke_undone"));
  EXPECT_THAT(a.all(3, "what"), ElementsAre("hint_given"));
  EXPECT_THAT(a.all(4, "what"), ElementsAre("answer_shown"));
}

TEST(PractiseVerb, ALineThatCannotBeDoneIsAnsweredAndTheRestGoesOn) {
  const auto a = practise("一 --stage trace", {R"({"do":"fly"})", R"({"stage":"sleep"})", R"({"id":7})", "[]",
                                               R"({"strokes":[[1]]})", strokes({kOne})});
  EXPECT_EQ(a.code, 2);
  ASSERT_EQ(a.lines.size(), 7U);
  for (std::size_t i = 1; i <= 5; ++i) EXPECT_EQ(a.lines[i]["line"], static_cast<int>(i));
  EXPECT_THAT(std::string(a.lines[1]["error"]), HasSubstr("fly: cannot be done now"));
  EXPECT_THAT(std::string(a.lines[2]["error"]), HasSubstr("sleep: is not a stage"));
  EXPECT_EQ(a.lines[3]["id"], 7);
  EXPECT_THAT(a.all(6, "what"), ElementsAre("stroke_began", "all_written"));
}

/// The only event of a name in the answers.
Json event_of(const Answers& answers, const char* what) {
  Json found;
  for (const Json& line : answers.lines)
    for (const Json& event : line["events"])
      if (event.value("what", "") == what) found = event;
  return found;
}

TEST(PractiseVerb, AsksForAWordInADictationAndJudgesEachOfItsCharacters) {
  const auto before = practise("十 --stage dictation", {});
  ASSERT_EQ(before.lines.size(), 1U);
  EXPECT_THAT(before.all(0, "what"), ElementsAre("word_asked"));
  EXPECT_THAT(before.all(0, "reading"), testing::SizeIs(1));
  EXPECT_THAT(before.all(0, "meaning"), testing::SizeIs(1));
  // The answers are shown, so that the test needs not to know the word.
  const auto a =
      practise("十 --stage dictation",
               {R"({"do":"speak"})", R"({"do":"hint"})", R"({"do":"answer"})", R"({"do":"finish"})",
                R"({"do":"answer"})", R"({"do":"finish"})", R"({"do":"finish"})"});
  EXPECT_EQ(a.code, 0);
  EXPECT_THAT(a.all(1, "what"), ElementsAre("speech_wanted"));
  EXPECT_THAT(a.all(1, "reading"), ElementsAre(before.all(0, "reading").front()));
  EXPECT_THAT(a.all(2, "what"), ElementsAre("hint_given"));
  EXPECT_THAT(a.all(3, "what"), ElementsAre("answer_shown"));
  EXPECT_THAT(a.all(4, "what"), ElementsAre("character_written"));
  EXPECT_FALSE(event_of(a, "character_written")["accepted"]);
  const Json verdict = event_of(a, "word_judged");
  ASSERT_EQ(verdict["characters"].size(), 2U) << verdict;
  EXPECT_FALSE(verdict["accepted"]);
  EXPECT_EQ(verdict["word"],
            std::string(verdict["characters"][0]["char"]) + std::string(verdict["characters"][1]["char"]));
  EXPECT_TRUE(verdict["characters"][1]["shown"]);
  EXPECT_THAT(a.all(6, "event"), Contains("finished"));
  EXPECT_THAT(a.all(7, "what"), ElementsAre("word_asked")) << "the next word";
}

TEST(PractiseVerb, ACharacterWithoutAWordHasNoDictationAndSaysSo) {
  const auto a = practise("A --stage dictation", {strokes({kOne})});
  EXPECT_EQ(a.code, 0);
  ASSERT_EQ(a.lines.size(), 2U);
  EXPECT_THAT(a.all(0, "what"), ElementsAre("no_word"));
  EXPECT_EQ(a.lines[1]["events"].size(), 0U);
}

TEST(PractiseVerb, StudiesADayAndSavesIt) {
  const TemporaryFolder folder;
  const std::string learners = "--learners '" + folder.path().string() + "' ";
  const std::string at = "--now 2026-03-02T10:00Z ";
  write(folder / "few.txt", "一\n");
  ASSERT_EQ(
      shell("\"$NAZORI\" study lists --import '" + (folder / "few.txt") + "' --as few " + learners + at).code,
      0);
  ASSERT_EQ(shell("\"$NAZORI\" study settings 'new_lists=[\"list:few\"]' " + learners + at).code, 0);
  const auto a = practise("--study " + learners + at,
                          {R"({"do":"watch"})", R"({"do":"go_on"})", strokes({kOne}), R"({"do":"go_on"})",
                           strokes({kOne}), R"({"do":"go_on"})", strokes({kOne}), R"({"do":"good"})"});
  EXPECT_EQ(a.code, 0);
  ASSERT_EQ(a.lines.size(), 9U);
  EXPECT_THAT(a.all(0, "char"), Contains("一"));
  EXPECT_THAT(a.all(7, "state"), Contains("judged"));
  EXPECT_THAT(a.all(7, "proposed"), Not(testing::IsEmpty()));
  EXPECT_THAT(a.all(8, "what"), Contains("rated"));
  const Outcome stats = shell("\"$NAZORI\" study stats --json " + learners + at);
  EXPECT_EQ(stats.code, 0) << stats.err;
  EXPECT_THAT(shell("\"$NAZORI\" study due --json " + learners + at).out, Not(HasSubstr("\"fresh\"")));
}

TEST(PractiseVerb, WhereNothingIsDueItSaysSo) {
  const TemporaryFolder folder;
  const std::string learners = "--learners '" + folder.path().string() + "' ";
  ASSERT_EQ(shell("\"$NAZORI\" study settings new_per_day=0 " + learners).code, 0);
  const auto a = practise("--study " + learners, {});
  EXPECT_EQ(a.code, 0);
  ASSERT_EQ(a.lines.size(), 1U);
  EXPECT_THAT(a.all(0, "what"), ElementsAre("nothing_due"));
}

TEST(PractiseVerb, RefusesWhatItCannotBeginWith) {
  const auto refused = [](const std::string& arguments, const char* why) {
    const Outcome run = shell("\"$NAZORI\" practise " + arguments + " < /dev/null");
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr(why));
  };
  refused("", "needs a character or --study");
  refused("一 --study", "not both");
  refused("一二", "must be one character");
  refused("☃", "has no strokes");
  refused("一 --database /nowhere/kanji.db", "/nowhere/kanji.db");
}

}  // namespace
}  // namespace nazori::cli::test
