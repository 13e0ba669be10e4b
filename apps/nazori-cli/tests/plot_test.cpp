// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "nazori/surface/height_map.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(Plot, WritesThePlateAndTheMaskOfACircle) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"plot", "x^2 + y^2 = 1", "--window=-2,2,-2,2", "--size", "128", "--axes",
                                  "off", "--output", folder / "circle.png", "--mask", folder / "mask.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto plate = surface::load_png(folder / "circle.png");
  const auto mask = surface::load_png(folder / "mask.png");
  ASSERT_TRUE(plate && mask);
  // The middle of the sample at (1, 0) is 1/254 of the plate outside the circle: by the raised cosine of half
  // width 1/80 the groove is 0.77 deep there. The middle of the circle is untouched.
  EXPECT_LT(plate->at(96, 64), 0.25F);
  EXPECT_EQ(plate->at(64, 64), 1.0F);
  EXPECT_EQ(mask->at(96, 64), 1.0F);
  EXPECT_EQ(mask->at(64, 64), 0.0F);
}

TEST(Plot, NamesTheColumnOfAWrongExpressionInOneLineAndWritesNothing) {
  for (const auto& [expression, column] :
       {std::pair{"y = 2 +", "column 8"}, std::pair{"y = foo(x)", "column 5"},
        std::pair{"y = (x+1", "column 9"}}) {
    const TemporaryFolder folder;
    const Outcome run = nazori_cli({"plot", expression, "--output", folder / "a.png"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr(column));
    EXPECT_THAT(run.err, HasSubstr("expected"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    EXPECT_THAT(folder.names(), IsEmpty());
  }
}

TEST(Plot, JsonTellsPointsOfInterestWithTheirExactNames) {
  const Outcome run = nazori_cli({"plot", "y = tan(x)", "--window=-2,2,-4,4", "--size", "64", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto document = nlohmann::json::parse(run.out);
  EXPECT_EQ(document["kind"], "explicit");
  EXPECT_EQ(document["canonical"], "y = tan(x)");
  EXPECT_EQ(document["words"], "y equals tangent of x");
  EXPECT_EQ(document["undecided_share"], 0.0);
  int asymptotes = 0;
  for (const auto& p : document["points"]) {
    if (p["kind"] != "vertical_asymptote") continue;
    ++asymptotes;
    EXPECT_NEAR(std::abs(p["x"].get<double>()), std::acos(0.0), 1e-9);
    EXPECT_THAT(p["x_name"].get<std::string>(), HasSubstr("pi/2"));
  }
  EXPECT_EQ(asymptotes, 2);
}

TEST(Plot, WritesASoundWithTheHeadOfAWav) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"plot", "y = x", "--size", "64", "--sound", folder / "line.wav"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto bytes = bytes_of(folder / "line.wav");
  ASSERT_GT(bytes.size(), 44U);
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "RIFF");
}

TEST(Plot, PrintsBlackLinesOnWhite) {
  const TemporaryFolder folder;
  const Outcome run =
      nazori_cli({"plot", "y = x", "--window=-1,1,-1,1", "--size", "64", "--print", folder / "line.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto print = surface::load_png(folder / "line.png");
  ASSERT_TRUE(print);
  EXPECT_EQ(print->size(), 1890);
  EXPECT_EQ(print->at(600, 1890 - 601), 0.0F);
  EXPECT_EQ(print->at(600, 600), 1.0F);
  EXPECT_EQ(nazori_cli({"plot", "z = x", "--print", folder / "a.png"}).code, 2);
}

TEST(Plot, ADecimalCommaCanBeAskedForInLists) {
  EXPECT_THAT(nazori_cli({"plot", "y = min(1,5; x)", "--decimal-comma", "--size", "32"}).out,
              HasSubstr("min(1.5, x)"));
  EXPECT_THAT(nazori_cli({"plot", "y = 1,5x", "--size", "32"}).out, HasSubstr("1.5*x"));
}

TEST(Plot, RefusesHeightsOutOfOrderAndFilesOfOtherKindsWithoutWriting) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"plot", "z = x", "--z=2,1", "--output", folder / "a.png"},
        std::vector<std::string>{"plot", "y = x", "--output", folder / "a.jpg"},
        std::vector<std::string>{"plot", "y = x", "--size", "31", "--output", folder / "a.png"},
        std::vector<std::string>{"plot", "z = x", "--sound", folder / "a.wav"}}) {
    const Outcome run = nazori_cli(arguments);
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(folder.names(), IsEmpty());
  }
}

TEST(Plot, FitsAModelToTheDataOfAFile) {
  const TemporaryFolder folder;
  write(folder / "data.csv", "x,y\n1,3\n2,5\n4,9\n");
  const Outcome run =
      nazori_cli({"plot", "y ~ a x + b", "--data", folder / "data.csv", "--size", "64", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto document = nlohmann::json::parse(run.out);
  const auto& fit = document["statements"][0]["fit"];
  EXPECT_NEAR(fit["letters"][0]["value"].get<double>(), 2, 1e-14);
  EXPECT_NEAR(fit["letters"][1]["value"].get<double>(), 1, 1e-14);
  EXPECT_EQ(fit["points"], 3);
  EXPECT_EQ(document["statements"][0]["typed"], "y ~ a*x + b");
  EXPECT_EQ(document["statements"][1]["kind"], "points");
  // What was typed is not followed by all the points.
  const Outcome text = nazori_cli({"plot", "y ~ a x + b", "--data", folder / "data.csv", "--size", "64"});
  EXPECT_THAT(text.out, testing::StartsWith("y ~ a*x + b\n"));
  EXPECT_THAT(text.out, HasSubstr("R squared is 1"));
}

TEST(Plot, NamesTheLineOfWrongDataInOneLine) {
  const TemporaryFolder folder;
  write(folder / "data.csv", "x,y\n1,3\n2\n");
  const Outcome run = nazori_cli({"plot", "y ~ a x", "--data", folder / "data.csv"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("data.csv: line 3"));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  EXPECT_NE(nazori_cli({"plot", "y ~ a x", "--data", folder / "none.csv"}).code, 0);
}

TEST(Plot, JsonHasTheListAndEachOfItsCurves) {
  const Outcome run = nazori_cli({"plot", "a = [1, 2]; y = a x", "--size", "64", "--json", "--table=0,1,1"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto document = nlohmann::json::parse(run.out);
  EXPECT_EQ(document["canonical"], "y = a*x; a = [1, 2]");
  ASSERT_EQ(document["statements"].size(), 2U);
  EXPECT_EQ(document["statements"][1]["canonical"], "y = 2*x");
  EXPECT_EQ(document["statements"][1]["typed"], "y = a*x");
  EXPECT_EQ(document["statements"][1]["element"], 2);
  EXPECT_EQ(document["lists"][0]["values"][1], 2.0);
  EXPECT_EQ(document["tables"][1][1][1], 2.0);
}

TEST(Plot, AParameterIsSetByItsLetter) {
  EXPECT_THAT(nazori_cli({"plot", "y = a x; a = 2", "--set", "a=1.5", "--size", "32"}).out,
              testing::StartsWith("y = a*x; a = 1.5\n"));
  EXPECT_THAT(
      nazori_cli({"plot", "y = a x + b; a = 2; b = 1", "--set", "a=3", "--set", "b=-4", "--size", "32"}).out,
      testing::StartsWith("y = a*x + b; a = 3; b = -4\n"));
  for (const char* bad : {"a", "a=", "a=1x", "a=x", "c=1", "=1"})
    expect_one_line(nazori_cli({"plot", "y = a x; a = 2", "--set", bad}), 2,
                    {"--set", "\"" + std::string(bad) + "\" sets no parameter"});
  EXPECT_THAT(nazori_cli({"plot", "y = foo(x)", "--set", "a=1"}).err, HasSubstr("column 5"));
}

TEST(Plot, ATableHasARowForEachStepAndSaysWhereThereIsNothing) {
  const Outcome run = nazori_cli({"plot", "y = 1/x; y = 2", "--size", "32", "--table=-1,1,0.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::EndsWith("\ny = 1/x\n  -1\t-1\n  -0.5\t-2\n  0\tundefined\n  0.5\t2\n  1\t1\n"
                                         "y = 2\n  -1\t2\n  -0.5\t2\n  0\t2\n  0.5\t2\n  1\t2\n"));
  EXPECT_THAT(nazori_cli({"plot", "y = 2", "--size", "32"}).out, testing::Not(HasSubstr("\t")));
  expect_one_line(nazori_cli({"plot", "y = x", "--size", "32", "--table=0,1,0"}), 2, {"--table"});
}

TEST(Plot, SpeaksAsMuchAndInTheLanguageAsAskedFor) {
  const auto told = [](const std::vector<std::string>& more) {
    std::vector<std::string> words{"plot", "y = (x + 1)/(x - 1)", "--size", "32"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = nazori_cli(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  const std::string verbose = told({}), brief = told({"--speech", "brief"}),
                    superbrief = told({"--speech", "superbrief"});
  EXPECT_EQ(told({"--speech", "verbose"}), verbose);
  EXPECT_GT(verbose.size(), brief.size());
  EXPECT_GT(brief.size(), superbrief.size());
  EXPECT_THAT(told({"--language", "ja"}), HasSubstr("分"));
  EXPECT_EQ(told({"--language", "en"}), verbose);
  EXPECT_EQ(std::count(verbose.begin(), verbose.end(), '\n'), 2);
  EXPECT_GT(told({"--points"}).size(), verbose.size());
  const std::string nemeth = told({"--braille", "nemeth"}), ueb = told({"--braille", "ueb"});
  EXPECT_NE(nemeth, ueb);
  EXPECT_TRUE(nemeth.starts_with(verbose));
  EXPECT_TRUE(ueb.starts_with(verbose));
  const auto json = nlohmann::json::parse(told({"--json", "--speech", "brief", "--language", "ja"}));
  EXPECT_THAT(json["words"].get<std::string>(), HasSubstr("分"));
  EXPECT_FALSE(json.contains("tables"));
}

TEST(Plot, ARawIsTheSamePlateInEightBits) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"plot", "y = x", "--size", "64", "-o", folder / "a.raw"}).code, 0);
  ASSERT_EQ(nazori_cli({"plot", "y = x", "--size", "64", "-o", folder / "a.png"}).code, 0);
  const auto raw = bytes_of(folder / "a.raw");
  ASSERT_EQ(raw.size(), 64U * 64);
  const auto png = surface::load_png(folder / "a.png");
  ASSERT_TRUE(png);
  for (std::size_t i = 0; i < raw.size(); ++i) ASSERT_NEAR(raw[i] / 255.0, png->samples()[i], 0.51 / 255);
}

TEST(Plot, ASurfaceHasNeitherSoundNorLines) {
  const TemporaryFolder folder;
  expect_one_line(nazori_cli({"plot", "z = x", "--sound", folder / "a.wav"}), 2,
                  {"--sound: a surface has no sound", "give a curve"});
  expect_one_line(nazori_cli({"plot", "z = x", "--print", folder / "a.png"}), 2,
                  {"--print: a surface has no lines to print"});
  expect_one_line(nazori_cli({"plot", "z = x", "--model", folder / "a.brf"}), 2,
                  {"--model: a surface has no lines for paper"});
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Plot, RefusesAnEmptyWindow) {
  const Outcome run = nazori_cli({"plot", "y = x", "--window=2,1,0,1"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--window"));
}

}  // namespace
}  // namespace nazori::cli::test
