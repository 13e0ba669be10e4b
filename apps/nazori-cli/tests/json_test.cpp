// SPDX-License-Identifier: Apache-2.0
// Every verb that answers can answer in JSON, also where the answer is no.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "help_pages.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

Json answer(const std::vector<std::string>& arguments, int code = 0) {
  const Outcome run = nazori_cli(arguments);
  EXPECT_EQ(run.code, code) << run.err;
  Json document = Json::parse(run.out, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << run.out;
  return document;
}

TEST(JsonAnswers, EveryVerbThatAnswersHasTheOption) {
  // These print lines of JSON, scripts or pages of text anyway, or write what -o - sends to standard output.
  const std::vector<std::string> without{"grade", "recognise", "practise", "completion", "manual", "help"};
  for (const HelpPage& page : help_pages()) {
    if (!page.verbs.empty() || std::find(without.begin(), without.end(), page.path()) != without.end())
      continue;
    EXPECT_THAT(page.options, testing::Contains("--json")) << page.path();
  }
}

TEST(JsonAnswers, OfFilesThatWereWritten) {
  const TemporaryFolder folder;
  const Json carved = answer({"carve", "休木", "--output", folder.path().string(), "--strokes",
                              folder / "{}.str", "--size", "64", "--json"});
  ASSERT_EQ(carved.size(), 2U);
  EXPECT_EQ(carved[0]["character"], "休");
  EXPECT_EQ(carved[0]["code_point"], "U+4F11");
  EXPECT_EQ(carved[0]["file"], folder / "休.png");
  EXPECT_EQ(carved[0]["size"], 64);
  EXPECT_EQ(carved[0]["strokes_file"], folder / "休.str");
  EXPECT_EQ(carved[0]["stroke_count"], 6);
  EXPECT_EQ(answer({"carve", "木", "-o", folder / "a.png", "--json"})[0]["strokes_file"], nullptr);

  const Json drawn = answer({"render", "休", "-o", folder / "b.png", "--size", "64x32", "--json"});
  EXPECT_EQ(
      drawn,
      Json::array(
          {{{"version", 1}, {"subject", "休"}, {"file", folder / "b.png"}, {"width", 64}, {"height", 32}}}));
  const Json own = answer({"render", "--strokes", folder / "休.str", "--map-size", "64", "-o",
                           folder / "c.png", "--size", "64", "--json"});
  EXPECT_EQ(own[0]["subject"], folder / "休.str");

  ASSERT_EQ(
      nazori_cli({"demo", "一", "-o", folder / "d.png", "--size", "64", "--record", folder / "d.nzr"}).code,
      0);
  const Json exported = answer({"record", "export", folder / "d.nzr", "-o", folder / "d.csv", "--json"});
  EXPECT_EQ(exported["file"], folder / "d.csv");
  EXPECT_GT(exported["ticks"].get<int>(), 100);
  EXPECT_EQ(exported["damaged"], 0);
  EXPECT_EQ(exported["finished"], true);
}

TEST(JsonAnswers, OfTheDatabase) {
  const Json path = answer({"database", "path", "--json"});
  EXPECT_EQ(path["path"], (data_folder() / "kanji.db").string());
  const Json built = answer({"database", "build", "-o", data_folder() / "kanji.db", "--json"});
  EXPECT_EQ(built, Json({{"version", 1}, {"path", (data_folder() / "kanji.db").string()}, {"built", false}}));
}

TEST(JsonAnswers, OfStudy) {
  const TemporaryFolder folder;
  const auto study = [&folder](std::vector<std::string> arguments, int code = 0) {
    arguments.insert(arguments.begin(), "study");
    arguments.insert(arguments.end(), {"--learners", folder.path().string(), "--json"});
    return answer(arguments, code);
  };
  EXPECT_EQ(study({"backup"}, 1), nullptr) << "nothing is studied yet";
  EXPECT_EQ(study({"undo"}, 1), nullptr);
  EXPECT_EQ(study({"rebuild"}, 1), nullptr);
  EXPECT_EQ(study({"restore"}, 1), nullptr);
  EXPECT_EQ(study({"lists", "list:none"}, 1), nullptr);
  EXPECT_EQ(study({"lists", "--remove", "none"}, 1), nullptr);

  EXPECT_EQ(study({"tag", "休木", "--with", "trees"}),
            Json::array({{{"version", 1}, {"character", "休"}, {"tags", {"trees"}}},
                         {{"version", 1}, {"character", "木"}, {"tags", {"trees"}}}}));
  EXPECT_EQ(study({"tag", "休"}),
            Json::array({{{"version", 1}, {"character", "休"}, {"tags", Json::array()}}}));
  write(folder / "list.txt", "休木");
  EXPECT_EQ(study({"lists", "--import", folder / "list.txt", "--as", "trees"})["characters"], 2);
  EXPECT_EQ(study({"lists", "--remove", "trees"}), Json::object({{"version", 1}, {"removed", "list:trees"}}));
}

TEST(JsonAnswers, AreThereAlsoWhereTheAnswerIsNo) {
  EXPECT_EQ(answer({"database", "check", "/nowhere/kanji.db", "--json"}, 1), nullptr);
  EXPECT_EQ(answer({"info", "U+10FFFF", "--json"}, 1), Json::array());
  EXPECT_EQ(answer({"search", "xyzzy", "--json"}, 1), Json::array());
  EXPECT_EQ(answer({"devices", "--test", "1", "--device", "none", "--json"}, 1), nullptr);
}

TEST(JsonAnswers, OfASearchAreWholeOrSaidToBeCut) {
  const Json grade = answer({"search", "--grade", "2", "--json"});
  EXPECT_EQ(grade.size(), 160U);
  const Outcome cut = nazori_cli({"search", "--grade", "2", "--limit", "100", "--json"});
  EXPECT_EQ(cut.code, 0);
  EXPECT_EQ(Json::parse(cut.out).size(), 100U);
  EXPECT_EQ(cut.err, "") << "who gives a limit knows of it";
  const Outcome words = nazori_cli({"search", "water"});
  EXPECT_EQ(words.code, 0);
  const std::string said = nazori_cli({"search", "a"}).err;
  EXPECT_THAT(said, HasSubstr("100 of "));
  EXPECT_THAT(said, HasSubstr("--limit "));
  EXPECT_EQ(nazori_cli({"search", "a", "--quiet"}).err, "");
  EXPECT_EQ(nazori_cli({"search", "--grade", "1"}).err, "") << "all 80 are shown";
}

}  // namespace
}  // namespace nazori::cli::test
