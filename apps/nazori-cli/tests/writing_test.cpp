// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

const std::string kBar = R"({"id":"a","char":"一","strokes":[[[0.1,0.5],[0.9,0.5]]]})";
const std::string kBackwards = R"({"char":"一","strokes":[[[0.9,0.5],[0.1,0.5]]]})";

struct Answers {
  int code = -1;
  std::vector<Json> lines;
};

Answers ask(const std::string& verb, const std::string& requests) {
  const TemporaryFolder folder;
  write(folder / "requests", requests);
  const Outcome run = shell("\"$NAZORI\" " + verb + " < '" + (folder / "requests") + "'");
  EXPECT_EQ(run.err, "");
  Answers answers{run.code, {}};
  std::istringstream out(run.out);
  for (std::string line; std::getline(out, line);) answers.lines.push_back(Json::parse(line));
  return answers;
}

TEST(GradeVerb, AnswersEachLineAndHandsTheIdBack) {
  const auto a = ask("grade --explain en", kBar + "\n\n" + kBackwards + "\n");
  EXPECT_EQ(a.code, 0);
  ASSERT_EQ(a.lines.size(), 2U);
  EXPECT_EQ(a.lines[0]["id"], "a");
  EXPECT_EQ(a.lines[0]["accepted"], true);
  EXPECT_EQ(a.lines[0]["strokes"][0]["matched"], 0);
  EXPECT_EQ(a.lines[1]["accepted"], false);
  EXPECT_EQ(a.lines[1]["strokes"][0]["reversed"], true);
  EXPECT_EQ(a.lines[1]["explanation"], Json::array({"Stroke 1 starts at the left."}));
  for (const char* member : {"offset", "size", "angle", "shape", "deviation"})
    EXPECT_TRUE(a.lines[0]["strokes"][0].contains(member)) << member;
  for (const char* part : {"strokes", "order", "direction", "shape", "place"})
    EXPECT_TRUE(a.lines[0]["parts"].contains(part)) << part;
}

TEST(GradeVerb, ExplainsTheScoreAndWhereItIsTimedThePen) {
  const auto a =
      ask("grade --explain ja",
          kBar + "\n" + R"({"char":"一","strokes":[[[0.1,0.5],[0.5,0.5],[0.9,0.5]]],"times":[[0,400,600]]})" +
              "\n");
  ASSERT_EQ(a.lines.size(), 2U);
  EXPECT_EQ(a.lines[0]["score_explanation"][1], "書き順：15点中15点");
  EXPECT_FALSE(a.lines[0].contains("motion_explanation"));
  EXPECT_EQ(a.lines[1]["motion_explanation"][0], "0.6秒で書きました。1画のうち1画がなめらかでした。");
  EXPECT_EQ(a.lines[1]["motion_explanation"][1], "1画目は、とめます。ペンを止めてから離しましょう。");
}

TEST(GradeVerb, NamesTheLineOfBadInputAndAnswersTheRest) {
  std::string many = R"({"char":"一","strokes":[[)";
  for (int i = 0; i < 100'000; ++i) many += (i == 0 ? "[0." : ",[0.") + std::to_string(100'000 + i) + ",0.5]";
  many += "]]}";
  const std::vector<std::string> bad = {
      R"({"char":"一","strokes":[]})",
      R"({"char":"一","strokes":[[]]})",
      R"({"char":"一","strokes":[[[0.1,0.5]]]})",
      R"({"char":"一","strokes":[[[0.1,0.5],[0.1,0.5]]]})",
      R"({"char":"一","strokes":[[[NaN,0.5],[0.1,0.5]]]})",
      R"({"char":"一","strokes":[[[1e300,0.5],[0.1,0.5]]]})",
      R"({"char":"一","strokes":[[["a",0.5],[0.1,0.5]]]})",
      R"({"char":"一"})",
      R"({"strokes":[[[0.1,0.5],[0.9,0.5]]]})",
      R"({"char":"☃","strokes":[[[0.1,0.5],[0.9,0.5]]]})",
      R"({"char":"一二","strokes":[[[0.1,0.5],[0.9,0.5]]]})",
      R"({"char":"一", broken)",
      "[1,2]",
      "\xff\xfe",
      many,
  };
  std::string requests;
  for (const auto& line : bad) requests += line + "\n";
  for (const std::string verb : {"grade", "grade --live"}) {
    const auto a = ask(verb, requests + kBar + "\n");
    EXPECT_EQ(a.code, 2);
    ASSERT_EQ(a.lines.size(), bad.size() + 1);
    for (std::size_t i = 0; i < bad.size(); ++i) {
      EXPECT_EQ(a.lines[i]["line"], i + 1) << bad[i].substr(0, 80);
      EXPECT_TRUE(a.lines[i]["error"].is_string());
      EXPECT_EQ(a.lines[i]["accepted"], false);
    }
    EXPECT_EQ(a.lines.back()["accepted"], true);
  }
}

TEST(GradeVerb, AnswersEachLineAsItComes) {
  // The second request is written only after the first answer has been read.
  const Outcome run = shell(R"(d=$(mktemp -d); mkfifo $d/in $d/out
    "$NAZORI" grade < $d/in > $d/out &
    exec 3> $d/in 4< $d/out
    echo '{"id":1,"char":"一","strokes":[[[0.1,0.5],[0.9,0.5]]]}' >&3
    read -r first <&4
    echo '{"id":2,"char":"一","strokes":[[[0.1,0.5],[0.9,0.5]]]}' >&3
    read -r second <&4
    exec 3>&-
    wait
    echo "$first"; echo "$second"; rm -r $d)");
  EXPECT_THAT(run.out, HasSubstr(R"("id":1)"));
  EXPECT_THAT(run.out, HasSubstr(R"("id":2)"));
}

TEST(GradeVerb, RefusesAStrictnessThatIsNone) {
  expect_one_line(nazori_cli({"grade", "--strictness", "2"}), 2, {"--strictness", "lenient, normal, strict"});
  expect_one_line(nazori_cli({"grade", "--strictness", "hard"}), 2, {"--strictness", "hard"});
  EXPECT_EQ(nazori_cli({"grade", "--strictness", "0.7"}).code, 0);
}

TEST(GradeVerb, TellsHowThePenMovedWhereItIsTimed) {
  const auto a = ask("grade", R"({"char":"一","strokes":[[[0.1,0.5],[0.5,0.5],[0.9,0.5]]],)"
                              R"("times":[[0,400,600]],"pressures":[[0.5,0.6,0.2]]})"
                              "\n");
  ASSERT_EQ(a.lines.size(), 1U);
  EXPECT_DOUBLE_EQ(a.lines[0]["motion"][0]["duration_s"], 0.6);
  EXPECT_TRUE(a.lines[0]["motion"][0].contains("pressure_at_end"));
}

TEST(RecogniseVerb, RanksCandidatesAndNamesBadLines) {
  const auto a = ask("recognise --top 3", kBar + "\nx\n" + R"({"strokes":[]})" + "\n" + kBackwards + "\n");
  EXPECT_EQ(a.code, 2);
  ASSERT_EQ(a.lines.size(), 4U);
  EXPECT_EQ(a.lines[0]["candidates"][0], "一");
  EXPECT_EQ(a.lines[0]["candidates"].size(), 3U);
  EXPECT_EQ(a.lines[1]["line"], 2);
  EXPECT_EQ(a.lines[2]["line"], 3);
  EXPECT_EQ(a.lines[3]["candidates"][0], "一");
}

}  // namespace
}  // namespace nazori::cli::test
