// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;

/// 休 carved, as RAW or PNG.
std::string carved_yasumu(const TemporaryFolder& folder, const std::string& name) {
  EXPECT_EQ(nazori_cli({"carve", "休", "--size", "512", "--output", folder / name}).code, 0);
  return folder / name;
}

TEST(AuthorTrace, AKnownCharacterComesBackWithItsStrokes) {
  const TemporaryFolder folder;
  const std::string map = carved_yasumu(folder, "a.raw");
  const Outcome run = nazori_cli({"author", "trace", map, "--character", "休", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto answer = nlohmann::json::parse(run.out);
  EXPECT_EQ(answer.at("character"), "休");
  const auto& strokes = answer.at("strokes");
  ASSERT_EQ(strokes.size(), 6U);
  EXPECT_EQ(strokes[0].at("ending"), "taper");
  EXPECT_EQ(strokes[0].at("ending_of_ink"), "taper");
  EXPECT_GT(strokes[0].at("covered").get<double>(), 0.7);
  EXPECT_LT(strokes[0].at("moved").get<double>(), 1);
  // The first stroke falls from the upper right to the lower left.
  const auto& points = strokes[0].at("points");
  EXPECT_GT(points.front()[0], points.back()[0]);
  EXPECT_LT(points.front()[1], points.back()[1]);
  ASSERT_EQ(points.front().size(), 4U);
}

TEST(AuthorTrace, WithoutACharacterPrintsALineForEachStroke) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"author", "trace", carved_yasumu(folder, "a.png"), "--relief"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 6);
  EXPECT_THAT(run.out, HasSubstr("taper"));
  // The same picture in grey is also ink on paper.
  EXPECT_EQ(nazori_cli({"author", "trace", folder / "a.png"}).code, 0);
}

TEST(AuthorTrace, ThePointsAreWhereTheStrokeIsInHundredthsOfAUnit) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"carve", "一", "--size", "512", "--width", "7", "-o", folder / "a.png"}).code, 0);
  const Outcome run =
      nazori_cli({"author", "trace", folder / "a.png", "--relief", "--character", "一", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto stroke = nlohmann::json::parse(run.out).at("strokes").at(0);
  const auto& points = stroke.at("points");
  // KanjiVG 4e00: from (11, 54.25) to (96.88, 50).
  EXPECT_NEAR(points.front()[0].get<double>(), 11, 0.5);
  EXPECT_NEAR(points.front()[1].get<double>(), 54.25, 0.5);
  EXPECT_NEAR(points.back()[0].get<double>(), 96.88, 0.5);
  EXPECT_NEAR(points.back()[1].get<double>(), 50, 0.5);
  const auto& middle = points[points.size() / 2];
  EXPECT_NEAR(middle[2].get<double>(), 3.5, 0.5) << "half of 7 units wide";
  EXPECT_NEAR(middle[3].get<double>(), 1, 0.1);
  EXPECT_GT(stroke.at("covered").get<double>(), 0.95);
  EXPECT_LT(stroke.at("moved").get<double>(), 0.5);
  for (const auto& point : points)
    for (const auto& value : point) {
      const double hundredths = value.get<double>() * 100;
      EXPECT_NEAR(hundredths, std::round(hundredths), 1e-6);
    }
}

TEST(AuthorTrace, ForPeopleNamesBothEndsAndDoubtsAStrokeThatIsNotThere) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"carve", "一", "--size", "512", "-o", folder / "a.png"}).code, 0);
  const auto trace = [&](const std::string& character) {
    const Outcome run =
        nazori_cli({"author", "trace", folder / "a.png", "--relief", "--character", character});
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  EXPECT_THAT(trace("一"), testing::MatchesRegex(
                               "  1   1[01]\\.[0-9], 54\\.[0-9] to  9[67]\\.[0-9], (49|50)\\.[0-9]  stop  "
                               "(100| 9[5-9]) % on ink, moved by 0\\.[0-9]\n"));
  // The first stroke of 永 is far away, and the second has no ink for much of its length.
  const std::string other = trace("永");
  std::vector<bool> doubted;
  std::istringstream lines(other);
  for (std::string line; std::getline(lines, line);) doubted.push_back(line.ends_with("  check this stroke"));
  EXPECT_EQ(doubted, (std::vector<bool>{true, true, false, false, false})) << other;
}

TEST(AuthorTrace, WritesEachKindOfFile) {
  const TemporaryFolder folder;
  const std::string map = carved_yasumu(folder, "a.raw");
  for (const std::string name : {"b.svg", "b.nazori", "b.str", "b.raw", "b.png"}) {
    const Outcome run =
        nazori_cli({"author", "trace", map, "--character", "休", "--size", "128", "--output", folder / name});
    ASSERT_EQ(run.code, 0) << name << run.err;
    EXPECT_GT(std::filesystem::file_size(folder / name), 200U) << name;
  }
  EXPECT_EQ(std::filesystem::file_size(folder / "b.raw"), 128U * 128U);
  const Outcome svg = nazori_cli({"author", "trace", map, "--output", "-"});
  ASSERT_EQ(svg.code, 0) << svg.err;
  EXPECT_THAT(svg.out, HasSubstr("\n<svg "));
  EXPECT_THAT(svg.out, HasSubstr("-s6\""));
}

TEST(AuthorTrace, WhatCannotBeTracedIsRefusedInOneLine) {
  const TemporaryFolder folder;
  write(folder / "text.png", "no picture");
  write(folder / "flat.raw", std::string(128 * 128, '\xFF'));
  const std::string map = carved_yasumu(folder, "a.raw");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{folder / "none.png"}, "none.png"},
      {{folder / "text.png"}, "neither a PNG nor a JPEG"},
      {{folder / "flat.raw"}, "flat.raw: the height map has no groove"},
      {{map, "--character", "休永"}, "--character: is for one character (give one)"},
      {{map, "--output", folder / "m.gif"}, "m.gif"},
      {{map, "--output", map}, "a.raw"},
      {{map, "--output", "-", "--json"}, "--json"},
  };
  for (const auto& [arguments, expected] : cases) {
    std::vector<std::string> command{"author", "trace"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome run = nazori_cli(command);
    EXPECT_NE(run.code, 0) << expected;
    EXPECT_THAT(run.err, HasSubstr(expected));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

}  // namespace
}  // namespace nazori::cli::test
