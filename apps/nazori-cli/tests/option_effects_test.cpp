// SPDX-License-Identifier: Apache-2.0
// Every option that says how something is made changes what is made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;

using Words = std::vector<std::string>;

class OptionEffects : public testing::Test {
 protected:
  /// What a command writes to a file of this name.
  std::vector<std::uint8_t> made(Words command, const Words& options, const std::string& name) {
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), {"--output", folder_ / name});
    const Outcome run = nazori_cli(command);
    EXPECT_EQ(run.code, 0) << run.err;
    return bytes_of(folder_ / name);
  }
  void expect_each_changes(const Words& command, const std::string& name, const std::vector<Words>& options) {
    const auto plain = made(command, {}, name);
    EXPECT_GT(plain.size(), 100U);
    for (const Words& option : options)
      EXPECT_TRUE(made(command, option, name) != plain)
          << command.front() << " " << option.front() << " " << option.back();
  }
  TemporaryFolder folder_;
};

TEST_F(OptionEffects, OfWorksheets) {
  expect_each_changes(
      {"worksheet", "休永"}, "a.pdf",
      {{"--guide", "田"},    {"--guide", "none"},   {"--paper", "b5"},    {"--paper", "letter"},
       {"--cell-mm", "20"},  {"--rows", "3"},       {"--copies", "1"},    {"--whole-page"},
       {"--vertical"},       {"--no-steps"},        {"--no-numbers"},     {"--no-arrows"},
       {"--no-facts"},       {"--no-name-line"},    {"--booklet"},        {"--title", "Week 3"},
       {"--language", "ja"}, {"--layout", "cards"}, {"--layout", "quiz"}, {"--layout", "brush"}});
  expect_each_changes({"worksheet", "休永", "--layout", "quiz"}, "a.pdf", {{"--answers"}});
}

TEST_F(OptionEffects, OfWhatIsFelt) {
  // Down into the groove of 一 and along it.
  std::string hand = "t,x,y,z\n";
  for (int i = 0; i <= 600; ++i)
    hand += std::to_string(i * 0.001) + "," + std::to_string(-0.03 + i * 1e-4) + ",0.001," +
            std::to_string(i < 100 ? 0.005 - i * 1.5e-4 : -0.01) + "\n";
  write(folder_ / "hand.csv", hand);
  expect_each_changes({"feel", "一", "--input", folder_ / "hand.csv"}, "a.csv",
                      {{"--stiffness", "0.4"},   {"--damping", "0.5"},       {"--friction", "0.5,0.3"},
                       {"--texture", "paper"},   {"--texture", "wood"},      {"--texture", "stone"},
                       {"--mode", "snap"},       {"--mode", "lesson"},       {"--mode", "lead"},
                       {"--rate", "500"},        {"--device", "touch-x"},    {"--device", "falcon"},
                       {"--device", "omega3"},   {"--device", "inverse3"},   {"--tip-radius-mm", "1"},
                       {"--map-size", "64"},     {"--width", "3"},           {"--depth", "0.5"},
                       {"--cross-section", "v"}, {"--cross-section", "flat"}});
  expect_each_changes({"feel", "一", "--input", folder_ / "hand.csv", "--texture", "wood"}, "a.csv",
                      {{"--roughness", "0.1"}});
  expect_each_changes({"feel", "二", "--input", folder_ / "hand.csv", "--mode", "lead"}, "a.csv",
                      {{"--stroke", "2"}});
}

TEST_F(OptionEffects, OfPaintedSheets) {
  std::string line = "t,x,y,z\n";
  for (int i = 0; i <= 60; ++i)
    line += std::to_string(i / 60.0) + "," + std::to_string(-0.03 + i * 1e-3) + ",0,-0.008\n";
  write(folder_ / "line.csv", line);
  const Words paint{"paint", folder_ / "line.csv", "--cells", "128"};
  const Words at_once{"paint", folder_ / "line.csv", "--cells", "128", "--after", "0"};
  expect_each_changes(paint, "a.png", {{"--after", "0"}});
  expect_each_changes(at_once, "a.png",
                      {{"--brush", "goat"},
                       {"--brush", "weasel"},
                       {"--number", "2"},
                       {"--ink", "vermilion"},
                       {"--load", "0.1"},
                       {"--strength", "0.3"},
                       {"--lean", "40"},
                       {"--paper", "water"},
                       {"--paper", "gasenshi"}});
  write(folder_ / "w.json", R"({"strokes":[[[0.1,0.5],[0.9,0.5]]]})");
  expect_each_changes({"paint", folder_ / "w.json", "--cells", "128", "--after", "0"}, "a.png",
                      {{"--size-mm", "40"}});
}

TEST_F(OptionEffects, OfPlots) {
  expect_each_changes({"plot", "y = x^2", "--size", "64"}, "a.png",
                      {{"--grid"}, {"--axes", "off"}, {"--half-width", "0.05"}, {"--window=-2,2,-2,2"}});
  expect_each_changes({"plot", "z = x*y", "--size", "64"}, "a.png", {{"--z=-20,20"}});
}

TEST_F(OptionEffects, OfSolids) {
  expect_each_changes({"model", "一", "--size-mm", "30"}, "a.stl",
                      {{"--margin-mm", "10"},
                       {"--depth-mm", "2"},
                       {"--thickness-mm", "8"},
                       {"--negative"},
                       {"--no-hole"},
                       {"--raised"},
                       {"--width", "3"},
                       {"--depth", "0.5"},
                       {"--cross-section", "v"}});
  expect_each_changes({"model", "一", "--size-mm", "60", "--raised"}, "a.stl",
                      {{"--line-height-mm", "2"},
                       {"--line-width-mm", "2"},
                       {"--no-numbers"},
                       {"--no-start-dots"},
                       {"--no-hole"}});
  expect_each_changes({"model", "一", "二", "--size-mm", "30"}, "a.stl",
                      {{"--gap-mm", "9"}, {"--vertical"}, {"--columns", "1"}});
}

TEST_F(OptionEffects, OfFilesForMachines) {
  expect_each_changes({"model", "一", "--size-mm", "30"}, "a.nc",
                      {{"--cutter-mm", "1"},
                       {"--step-over-mm", "0.5"},
                       {"--pass-depth-mm", "0.2"},
                       {"--safe-mm", "9"},
                       {"--feed", "555"},
                       {"--plunge", "111"},
                       {"--spindle-rpm", "7777"},
                       {"--depth-mm", "2"}});
  expect_each_changes({"model", "休", "--size-mm", "30"}, "a.svg", {{"--layers", "4"}, {"--width", "3"}});
  expect_each_changes({"model", "休", "--size-mm", "60"}, "a.pdf",
                      {{"--paper", "b5"},
                       {"--paper", "letter"},
                       {"--no-label"},
                       {"--no-numbers"},
                       {"--no-start-dots"},
                       {"--braille", "contracted"}});
  expect_each_changes({"model", "休"}, "a.brf",
                      {{"--columns-braille", "30"},
                       {"--lines-braille", "20"},
                       {"--no-label"},
                       {"--no-numbers"},
                       {"--no-start-dots"},
                       {"--braille", "contracted"}});
}

/// The only line that a command answers a request with.
nlohmann::json answered(const std::string& command, const std::string& request) {
  const Outcome run = shell("echo '" + request + "' | \"$NAZORI\" " + command);
  EXPECT_EQ(run.code, 0) << run.err << run.out;
  return nlohmann::json::parse(run.out);
}

TEST_F(OptionEffects, OfRecognition) {
  const std::string bar = R"({"strokes":[[[0.1,0.5],[0.9,0.5]]]})";
  const auto found = [&](const std::string& options) {
    return answered("recognise " + options, bar)["candidates"].get<Words>();
  };
  EXPECT_EQ(found("").size(), 10U);
  EXPECT_EQ(found("--among kanji").front(), "一");
  EXPECT_EQ(found("--among kana").front(), "ー");
  for (const std::string& letter : found("--among letters")) EXPECT_EQ(letter.size(), 1U) << letter;
  EXPECT_NE(found("--unfinished --top 100"), found("--top 100"));
}

TEST_F(OptionEffects, OfStrictness) {
  // The first stroke of 二 is drawn too low.
  const std::string crooked = R"({"char":"二","strokes":[[[0.3,0.52],[0.7,0.52]],[[0.1,0.8],[0.9,0.8]]]})";
  const auto deviation = [&](const std::string& strictness) {
    return answered("grade --strictness " + strictness, crooked)["strokes"][0]["deviation"].get<double>();
  };
  EXPECT_EQ(deviation("normal"), deviation("0.5"));
  const auto score = [&](const std::string& strictness) {
    return answered("grade --strictness " + strictness, crooked)["accepted"].get<bool>();
  };
  (void)score("0");
  (void)score("1");
  for (const char* bad : {"-0.01", "1.01", "nan", "", "1x", "harder"})
    EXPECT_NE(nazori_cli({"grade", std::string("--strictness=") + bad}).code, 0) << bad;
}

}  // namespace
}  // namespace nazori::cli::test
