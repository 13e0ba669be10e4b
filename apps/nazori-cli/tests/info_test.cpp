// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"
#include "text_layout.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using Texts = std::vector<std::string>;

Json answer_of(const Outcome& run) {
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return Json::parse(run.out);
}

/// The 休 of issue 2 and of KANJIDIC2, KanjiVG and EDICT themselves.
class InfoOfRest : public testing::Test {
 protected:
  const Json rest = answer_of(nazori_cli({"info", "休", "--json"})).at(0);
};

TEST_F(InfoOfRest, HasSixStrokesWithTheirTypesAndEndings) {
  EXPECT_EQ(rest["character"], "休");
  EXPECT_EQ(rest["code_point"], "U+4F11");
  EXPECT_EQ(rest["stroke_count"], 6);
  EXPECT_EQ(rest["dictionary_stroke_counts"], Json({6}));
  Texts types;
  Texts endings;
  for (const Json& stroke : rest["strokes"]) {
    EXPECT_EQ(stroke["number"], static_cast<int>(types.size()) + 1);
    EXPECT_THAT(stroke["path"].get<std::string>(), testing::StartsWith("M"));
    EXPECT_EQ(stroke["number_position"].size(), 2U);
    types.push_back(stroke["type"]);
    endings.push_back(stroke["ending"]);
  }
  EXPECT_THAT(types, ElementsAre("㇒", "㇑", "㇐", "㇑", "㇒", "㇏"));
  EXPECT_THAT(endings, ElementsAre("taper", "stop", "stop", "stop", "taper", "taper"));
}

TEST_F(InfoOfRest, HasTheDictionarysReadingsMeaningsAndCodes) {
  EXPECT_THAT(rest["readings"]["on"].get<Texts>(), ElementsAre("キュウ"));
  EXPECT_THAT(rest["readings"]["kun"].get<Texts>(), ElementsAre("やす.む", "やす.まる", "やす.める"));
  EXPECT_THAT(rest["meanings"]["en"].get<Texts>(), ElementsAre("rest", "day off", "retire", "sleep"));
  for (const char* language : {"fr", "es", "pt"})
    EXPECT_FALSE(rest["meanings"][language].empty()) << language;
  EXPECT_EQ(rest["grade"], 1);
  EXPECT_EQ(rest["frequency"], 642);
  EXPECT_EQ(rest["old_jlpt_level"], 4);
  const Json& codes = rest["codes"];
  const auto has = [&codes](const std::string& system, const std::string& value) {
    return std::any_of(codes.begin(), codes.end(),
                       [&](const Json& code) { return code["system"] == system && code["value"] == value; });
  };
  EXPECT_TRUE(has("skip", "1-2-4"));
  EXPECT_TRUE(has("four_corner", "2429.0"));
}

TEST_F(InfoOfRest, HasItsRadical) {
  EXPECT_EQ(rest["radical"]["number"], 9);
  EXPECT_EQ(rest["radical"]["form"], "人");
  EXPECT_EQ(rest["radical"]["english_name"], "person");
  EXPECT_THAT(rest["radical"]["variant_forms"].get<Texts>(), Contains("亻"));
  EXPECT_THAT(rest["radical"]["japanese_names"].get<Texts>(), testing::IsSupersetOf({"ひと", "にんべん"}));
}

TEST_F(InfoOfRest, HasItsTreeOfComponents) {
  const Json& root = rest["components"];
  EXPECT_EQ(root["element"], "休");
  EXPECT_EQ(root["strokes"], Json({1, 2, 3, 4, 5, 6}));
  ASSERT_EQ(root["children"].size(), 2U);
  EXPECT_EQ(root["children"][0]["element"], "亻");
  EXPECT_EQ(root["children"][0]["original"], "人");
  EXPECT_EQ(root["children"][0]["position"], "left");
  EXPECT_EQ(root["children"][0]["variant"], true);
  EXPECT_EQ(root["children"][0]["strokes"], Json({1, 2}));
  EXPECT_EQ(root["children"][1]["element"], "木");
  EXPECT_EQ(root["children"][1]["strokes"], Json({3, 4, 5, 6}));
}

TEST_F(InfoOfRest, HasItsWords) {
  Texts words;
  for (const Json& word : rest["words"]) words.push_back(word["text"]);
  EXPECT_THAT(words, testing::IsSupersetOf({"休日", "休む"}));
  const auto holiday = std::find_if(rest["words"].begin(), rest["words"].end(),
                                    [](const Json& word) { return word["text"] == "休日"; });
  EXPECT_EQ((*holiday)["reading"], "きゅうじつ");
  EXPECT_EQ((*holiday)["common"], true);
  EXPECT_EQ((*holiday)["senses"].size(), (*holiday)["glosses"].size());
  EXPECT_THAT((*holiday)["glosses"].get<Texts>(), Contains(HasSubstr("holiday")));
}

TEST(Info, ForPeopleFitsEightyColumnsAndSetsOkuriganaApart) {
  const Outcome run = nazori_cli({"info", "休"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  for (const char* part : {"休", "U+4F11", "6 strokes", "grade 1", "rest", "キュウ", "やす・む", "9 人",
                           "person", "にんべん", "亻", "木", "taper", "休日", "きゅうじつ"}) {
    EXPECT_THAT(run.out, HasSubstr(part));
  }
  EXPECT_EQ(run.out.find('\x1b'), std::string::npos);
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 80) << line;
}

TEST(Info, ForPeopleNamesGradesCountsAndPlacesOfParts) {
  const auto told = [](const std::string& character) {
    const Outcome run = nazori_cli({"info", character});
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  const auto headline = [&](const std::string& character) {
    const std::string text = told(character);
    return text.substr(0, text.find('\n'));
  };
  // KANJIDIC2: 一 is taught in the first year, 鬱 in secondary school, 佑 is for names.
  EXPECT_EQ(headline("一"), "一  U+4E00 · 1 stroke · grade 1");
  EXPECT_EQ(headline("議"), "議  U+8B70 · 20 strokes · grade 4");
  EXPECT_EQ(headline("胃"), "胃  U+80C3 · 9 strokes · grade 6");
  EXPECT_EQ(headline("鬱"), "鬱  U+9B31 · 29 strokes · secondary school (jōyō)");
  EXPECT_EQ(headline("佑"), "佑  U+4F51 · 7 strokes · for names (jinmeiyō)");
  EXPECT_THAT(headline("丂"), HasSubstr("U+4E02 · 2 strokes · no strokes"));
  EXPECT_EQ(headline("あ"), "あ  U+3042 · 3 strokes");
  // 明 in names is read あけ among others; 国's frame lies around 玉.
  EXPECT_THAT(told("明"), HasSubstr("\nin names    "));
  EXPECT_THAT(told("国"), HasSubstr("\nparts       囗 kamae (piece 1)   玉   囗 kamae (piece 2)\n"));
  EXPECT_THAT(told("正"), HasSubstr("\nother order 1 3 2 4 5  (KanjiVG variant HzFst)\n"));
  EXPECT_THAT(told("正"), HasSubstr("HzFst"));
}

TEST(Info, WordsStandInColumnsAndTheirMeaningsAreSetApart) {
  const std::string text = nazori_cli({"info", "休", "--words", "2"}).out;
  const std::size_t at = text.find("\nwords       ");
  ASSERT_NE(at, std::string::npos) << text;
  EXPECT_EQ(text.find("in words"), std::string::npos);
  std::istringstream lines(text.substr(at + 1));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_GE(rows.size(), 2U);
  int words = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    words += i == 0 || (rows[i].starts_with(std::string(12, ' ')) && rows[i][12] != ' ') ? 1 : 0;
  EXPECT_EQ(words, 2) << text;
  const std::string two = nazori_cli({"info", "休", "一"}).out;
  EXPECT_THAT(two, HasSubstr("\n\n一  U+4E00")) << "an empty line stands between two characters";
}

TEST(Info, SeveralCharactersAnswerInTheOrderAsked) {
  const Json answer = answer_of(nazori_cli({"info", "木休", "人", "U+4E00", "休", "--json", "--words", "0"}));
  Texts names;
  for (const Json& one : answer) names.push_back(one["character"]);
  EXPECT_THAT(names, ElementsAre("木", "休", "人", "一"));
  EXPECT_TRUE(answer[0]["words"].empty());
}

TEST(Info, AVariantFormIsAskedForByItsSuffix) {
  const Json form = answer_of(nazori_cli({"info", "正-HzFst", "--json"})).at(0);
  EXPECT_EQ(form["variant"], "HzFst");
  EXPECT_EQ(form["stroke_count"], 5);
  const Json main = answer_of(nazori_cli({"info", "正", "--json"})).at(0);
  EXPECT_THAT(main["variants"].get<Texts>(), Contains("HzFst"));
  // 1 3 2 4 5: the order of KanjiVG's file 06b63-HzFst.svg.
  EXPECT_EQ(main["alternative_orders"].at(0)["order"], Json({1, 3, 2, 4, 5}));
  EXPECT_NE(main["alternative_orders"].at(0)["source"], "");
}

TEST(Info, AWordCountKeepsTheCommonest) {
  const Json answer = answer_of(nazori_cli({"info", "休", "--json", "--words", "3"}));
  ASSERT_EQ(answer[0]["words"].size(), 3U);
  for (const Json& word : answer[0]["words"]) EXPECT_EQ(word["common"], true);
}

TEST(Info, KanaAndLettersHaveStrokesAndNoDictionary) {
  const Json answer = answer_of(nazori_cli({"info", "あ", "A", "7", "か\u3099", "--json"}));
  ASSERT_EQ(answer.size(), 4U);
  EXPECT_EQ(answer[0]["stroke_count"], 3);
  EXPECT_TRUE(answer[0]["grade"].is_null());
  EXPECT_TRUE(answer[0]["radical"].is_null());
  EXPECT_EQ(answer[3]["character"], "が");
}

TEST(Info, OutputIsTheSameEveryTime) {
  EXPECT_EQ(nazori_cli({"info", "休木人", "--json"}).out, nazori_cli({"info", "休木人", "--json"}).out);
}

TEST(Info, WhatIsNotFoundIsNamedAndTheRestIsTold) {
  const Outcome run = nazori_cli({"info", "休", "☃", "--json"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(Json::parse(run.out).size(), 1U);
  EXPECT_THAT(run.err, HasSubstr("☃"));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  expect_one_line(nazori_cli({"info", "☃"}), 1, {"☃", "not in the database"});
  expect_one_line(nazori_cli({"info", "休-NoSuchForm"}), 1, {"休-NoSuchForm"});
}

TEST(Info, TextThatIsNotUtf8IsRefused) {
  expect_one_line(nazori_cli({"info", "\xE4\xBC"}), 2, {"UTF-8", "\\xE4\\xBC"});
  expect_one_line(nazori_cli({"info", ""}), 2, {"no character"});
  for (const char* wrong : {"U+110000", "U+D800", "U+4F1G", "休-", "休-漢", "U+4F11-"}) {
    expect_one_line(nazori_cli({"info", wrong}), 2, {wrong, "is not the name of a character"});
  }
}

}  // namespace
}  // namespace nazori::cli::test
