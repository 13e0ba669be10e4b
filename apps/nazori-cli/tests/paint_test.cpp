// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;

std::string write(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
  return path;
}

/// A line of 6 cm from left to right, pressed 8 mm deep, in `seconds`.
std::string line_csv(double seconds) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i <= 60; ++i)
    text += std::to_string(i * seconds / 60) + "," + std::to_string(-0.03 + i * 1e-3) + ",0,-0.008\n";
  return text;
}

nlohmann::json painted(const TemporaryFolder& folder, const std::string& script,
                       std::vector<std::string> options = {}) {
  std::vector<std::string> arguments{"paint",  script,    "--output", folder / "p.png", "--cells", "256",
                                     "--json", "--after", "0"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = nazori_cli(arguments);
  EXPECT_EQ(run.code, 0) << run.err;
  return nlohmann::json::parse(run.out, nullptr, false);
}

TEST(Paint, ATrajectoryBecomesALineOfItsLength) {
  const TemporaryFolder folder;
  const auto answer = painted(folder, write(folder / "line.csv", line_csv(1)));
  EXPECT_EQ(answer["samples"], 61);
  EXPECT_NEAR(answer["seconds"], 1, 1e-6);
  // 60 mm of a brush of at least 2 and at most 15 mm.
  EXPECT_GT(answer["painted_mm2"], 120);
  EXPECT_LT(answer["painted_mm2"], 900);
  EXPECT_LT(answer["ink_left"], 1);
  EXPECT_GT(answer["ink_left"], 0);
  EXPECT_GT(std::filesystem::file_size(folder / "p.png"), 1000U);
}

TEST(Paint, TheOutputIsStrokesOrAPageAsItsNameSays) {
  const TemporaryFolder folder;
  const std::string script = write(folder / "line.csv", line_csv(1));
  const auto bytes = [](const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const auto paint = [&](const std::string& output) {
    const Outcome run = nazori_cli({"paint", script, "--output", output, "--cells", "256", "--after", "0"});
    EXPECT_EQ(run.code, 0) << run.err;
  };
  paint(folder / "p.svg");
  const std::string svg = bytes(folder / "p.svg");
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 102.4 102.4\""));
  EXPECT_THAT(svg, HasSubstr("<path id=\"stroke-1\""));
  EXPECT_THAT(svg, testing::Not(HasSubstr("stroke-2")));
  paint(folder / "p.pdf");
  const std::string pdf = bytes(folder / "p.pdf");
  EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/Width 256 /Height 256"));
  const Outcome refused = nazori_cli({"paint", script, "--output", folder / "p.gif"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr(".png or .svg or .pdf"));
}

TEST(Paint, AFastStrokeLeavesLessInkThanASlowOne) {
  const TemporaryFolder folder;
  const auto slow = painted(folder, write(folder / "slow.csv", line_csv(2)), {"--load", "0.4"});
  const auto fast = painted(folder, write(folder / "fast.csv", line_csv(0.1)), {"--load", "0.4"});
  EXPECT_LT(fast["painted_mm2"].get<double>(), 0.9 * slow["painted_mm2"].get<double>());
  EXPECT_GT(fast["ink_left"], slow["ink_left"]);
}

TEST(Paint, AThickerBrushPaintsMoreUnderTheSamePressureAndALiftedOneNothing) {
  const TemporaryFolder folder;
  const std::string line =
      write(folder / "line.json", R"({"strokes":[[[0.1,0.5],[0.9,0.5]]],"pressures":[[0.6,0.6]]})");
  EXPECT_GT(painted(folder, line, {"--number", "1"})["painted_mm2"],
            painted(folder, line, {"--number", "6"})["painted_mm2"]);
  const auto above = painted(folder, write(folder / "above.csv", "t,x,y,z\n0,0,0,0.01\n1,0.02,0,0.01\n"));
  EXPECT_EQ(above["painted_mm2"], 0);
  EXPECT_EQ(above["ink_left"], 1);
}

TEST(Paint, MorePressureInHandwritingIsABroaderStroke) {
  const TemporaryFolder folder;
  const auto with = [&](const char* pressure) {
    return painted(folder, write(folder / "w.json", std::string(R"({"strokes":[[[0.1,0.5],[0.9,0.5]]],)") +
                                                        R"("pressures":[[)" + pressure + "," + pressure +
                                                        "]]}"))["painted_mm2"]
        .get<double>();
  };
  EXPECT_GT(with("0.8"), 1.3 * with("0.2"));
}

TEST(Paint, HandwritingWithTimesTakesThem) {
  const TemporaryFolder folder;
  const std::string text =
      R"({"strokes":[[[0.1,0.3],[0.9,0.3]],[[0.1,0.7],[0.9,0.7]]],"times":[[500,1500],[2500,3500]]})";
  // From the first touch to the lift after the last stroke.
  EXPECT_NEAR(painted(folder, write(folder / "w.json", text))["seconds"], 3.02, 1e-6);
}

TEST(Paint, TheModelIsWrittenFirst) {
  const TemporaryFolder folder;
  const std::string script = write(folder / "w.json", R"({"char":"一","strokes":[]})");
  const auto answer = painted(folder, script, {"--model"});
  EXPECT_GT(answer["painted_mm2"], 50);
  EXPECT_EQ(answer["samples"], 0);
}

TEST(Paint, TheModelIsThatOfAFontOrPrintedLinesWhereTheFontLacksIt) {
  const TemporaryFolder folder;
  const std::string bar = write(folder / "w.json", R"({"char":"一","strokes":[]})");
  const std::vector<std::string> font{"--model-font", "KouzanBrushFont"};
  EXPECT_EQ(painted(folder, bar, {"--model"})["model_font"], "");
  const auto printed = bytes_of(folder / "p.png");
  const auto answer = painted(folder, bar, font);
  EXPECT_EQ(answer["model_font"], "KouzanBrushFont");
  EXPECT_GT(answer["painted_mm2"], 50);
  EXPECT_NE(bytes_of(folder / "p.png"), printed);

  const std::string missing = write(folder / "m.json", R"({"char":"剝","strokes":[]})");
  const Outcome run = nazori_cli({"paint", missing, "--output", folder / "m.png", "--cells", "256", "--after",
                                  "0", "--model-font", "KouzanBrushFont", "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["model_font"], "");
  EXPECT_THAT(run.err, HasSubstr("KouzanBrushFont"));
  EXPECT_THAT(run.err, HasSubstr("printed lines"));

  const std::string nameless = write(folder / "n.json", R"({"strokes":[[[0.1,0.5],[0.9,0.5]]]})");
  const Outcome refused =
      nazori_cli({"paint", nameless, "--output", folder / "n.png", "--model-font", "KouzanBrushFont"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--model-font"));
}

TEST(Paint, ThirtyPicturesASecondGoToTheFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  const auto answer =
      painted(folder, write(folder / "line.csv", line_csv(1)), {"--frames", folder / "frames"});
  EXPECT_NEAR(answer["frames"].get<double>(), 30, 1);
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/00001.png"));
}

TEST(Paint, ForPeopleNamesPaperTimeAndArea) {
  const TemporaryFolder folder;
  const std::string script = write(folder / "line.csv", line_csv(1.5));
  const auto answer = painted(folder, script, {"--paper", "board"});
  EXPECT_EQ(answer["paper"], "board");
  EXPECT_EQ(answer["brush"], "mixed");
  EXPECT_EQ(answer["size"], 256);
  EXPECT_EQ(answer["frames"], 0);
  const Outcome run = nazori_cli(
      {"paint", script, "--output", folder / "p.png", "--cells", "256", "--after", "0", "--paper", "board"});
  const auto area = std::lround(answer["painted_mm2"].get<double>());
  EXPECT_EQ(run.out, folder / "p.png" + "  " + script + " on board, 1.5 s, " + std::to_string(area) +
                         " mm² painted\n");
}

TEST(Paint, TheModelIsNotAmongTheStrokesThatAreSaved) {
  const TemporaryFolder folder;
  const std::string script =
      write(folder / "w.json", R"({"char":"二","strokes":[[[0.1,0.3],[0.9,0.3]],[[0.1,0.7],[0.9,0.7]]]})");
  const auto strokes = [&](const std::string& file, const std::vector<std::string>& more) {
    std::vector<std::string> words{"paint",   file,  "--output", folder / "s.svg",
                                   "--cells", "256", "--after",  "0"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(nazori_cli(words).code, 0);
    const auto bytes = bytes_of(folder / "s.svg");
    return std::string(bytes.begin(), bytes.end());
  };
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--model"}}) {
    const std::string svg = strokes(script, more);
    EXPECT_THAT(svg, HasSubstr("id=\"stroke-2\""));
    EXPECT_THAT(svg, testing::Not(HasSubstr("id=\"stroke-3\"")));
  }
  // Where nothing is written, they are those of the model.
  const std::string model = strokes(write(folder / "m.json", R"({"char":"三","strokes":[]})"), {"--model"});
  EXPECT_THAT(model, HasSubstr("id=\"stroke-3\""));
  EXPECT_THAT(model, testing::Not(HasSubstr("id=\"stroke-4\"")));
}

TEST(Paint, AWritingOfTenMinutesIsTheLongest) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"paint", write(folder / "a.csv", "t,x,y,z\n1,0,0,0.01\n601,0,0,0.01\n"),
                                  "--output", folder / "p.png", "--cells", "128", "--after", "0"});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(Paint, TheSameScriptGivesTheSameBytes) {
  const TemporaryFolder folder;
  const std::string line = write(folder / "line.csv", line_csv(1));
  painted(folder, line);
  const auto first = bytes_of(folder / "p.png");
  painted(folder, line);
  EXPECT_EQ(bytes_of(folder / "p.png"), first);
}

TEST(Paint, WrongScriptsAreRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& script, std::vector<std::string> options = {}) {
    std::vector<std::string> arguments{"paint", script, "--output", folder / "p.png"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome run = nazori_cli(arguments);
    EXPECT_EQ(run.code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "p.png"));
    return run.err;
  };
  EXPECT_THAT(refused(folder / "none.csv"), HasSubstr("none.csv"));
  EXPECT_THAT(refused(write(folder / "a.txt", "")), HasSubstr("unsupported file type"));
  EXPECT_THAT(refused(write(folder / "a.json", "[]")), HasSubstr("is not an object"));
  EXPECT_THAT(refused(write(folder / "b.json", R"({"strokes":[]})")), HasSubstr("has no strokes"));
  EXPECT_THAT(refused(write(folder / "c.json", R"({"strokes":[[[0,0],[300,5]]]})")), HasSubstr("box"));
  EXPECT_THAT(refused(write(folder / "d.json", R"({"strokes":[[[0,0]]],"pressures":[[1.5]]})")),
              HasSubstr("a pressure is 0 to 1"));
  EXPECT_THAT(refused(write(folder / "e.json", R"({"strokes":[[[0,0]]],"char":"休日"})")),
              HasSubstr("must be one character"));
  EXPECT_THAT(refused(write(folder / "f.csv", "t,x,y,z\n0,0,0,0\n700,0,0,0\n")),
              HasSubstr("longer than 600"));
  const std::string good = write(folder / "g.json", R"({"strokes":[[[0,0],[1,1]]]})");
  EXPECT_THAT(refused(good, {"--model"}), HasSubstr("does not say which character it is"));
  EXPECT_THAT(refused(good, {"--paper", "silk"}), HasSubstr("gasenshi"));
  EXPECT_THAT(refused(good, {"--ink", "milk"}), HasSubstr("sumi"));
  EXPECT_THAT(refused(good, {"--frames", folder / "nowhere"}), HasSubstr("does not exist"));
}

}  // namespace
}  // namespace nazori::cli::test
