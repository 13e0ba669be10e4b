// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// What a binary STL holds.
struct Solid {
  std::uint32_t triangles = 0;
  std::array<float, 3> size{};
  double highest = 0;
};

Solid solid_of(const std::string& file) {
  const auto bytes = bytes_of(file);
  Solid solid;
  if (bytes.size() < 84) return solid;
  std::memcpy(&solid.triangles, bytes.data() + 80, 4);
  EXPECT_EQ(bytes.size(), 84 + 50U * solid.triangles);
  for (std::size_t t = 0; t < solid.triangles; ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), bytes.data() + 84 + 50 * t + 12 + 12 * corner, 12);
      for (std::size_t i = 0; i < 3; ++i) solid.size[i] = std::max(solid.size[i], p[i]);
    }
  }
  return solid;
}

TEST(Model, AGroovedTabletHasItsSizeInMillimetres) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"model", "休", "--output", folder / "休.stl"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("triangles"));
  const Solid solid = solid_of(folder / "休.stl");
  EXPECT_NEAR(solid.size[0], 112, 0.3);
  EXPECT_NEAR(solid.size[1], 120, 0.3);
  EXPECT_NEAR(solid.size[2], 6, 1e-4);
  EXPECT_LT(solid.triangles, 100'000U);
}

TEST(Model, ARaisedWordStandsOnOnePlate) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"model", "休日", "--raised", "--size-mm", "60", "--vertical", "--no-hole",
                                  "--json", "--output", folder / "a.stl"});
  EXPECT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["subject"], "休日");
  EXPECT_NEAR(json["width_mm"].get<double>(), 72, 0.3);
  EXPECT_NEAR(json["height_mm"].get<double>(), 132, 0.3);
  // The plate, a line and a starting dot.
  EXPECT_NEAR(json["thickness_mm"].get<double>(), 3 + 1 + 0.8, 0.02);
  EXPECT_EQ(json["triangles"].get<unsigned>(), solid_of(folder / "a.stl").triangles);
  EXPECT_LE(json["error_mm"].get<double>(), 0.02);
}

TEST(Model, NumbersAndDotsCanBeLeftOut) {
  const TemporaryFolder folder;
  const auto thickness = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"model", "一", "--raised", "--output", folder / "a.stl"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(nazori_cli(arguments).code, 0);
    return solid_of(folder / "a.stl").size[2];
  };
  EXPECT_NEAR(thickness({}), 4.8, 0.02);
  EXPECT_NEAR(thickness({"--no-start-dots"}), 4, 0.02);
  EXPECT_NEAR(thickness({"--no-start-dots", "--no-numbers", "--line-height-mm", "0.4"}), 3.4, 0.02);
}

TEST(Model, AMouldIsHigherThanItsTablet) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"model", "一", "--negative", "--size-mm", "50", "-o", folder / "a.stl"}).code, 0);
  // Thickness, a knob of the groove's depth at most, and the border.
  const Solid solid = solid_of(folder / "a.stl");
  EXPECT_NEAR(solid.size[2], 6 + 5, 1e-3);
  EXPECT_NEAR(solid.size[1], 62, 0.3);
}

TEST(Model, AThreeMfIsAnArchive) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"model", "木", "-o", folder / "a.3mf"}).code, 0);
  const auto bytes = bytes_of(folder / "a.3mf");
  ASSERT_GT(bytes.size(), 100U);
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 2), "PK");
}

TEST(Model, YourOwnTabletIsPrintedToo) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"carve", "木", "--output", folder / "a.raw", "--strokes", folder / "a.str"}).code, 0);
  EXPECT_EQ(nazori_cli({"model", "--height-map", folder / "a.raw", "-o", folder / "a.stl"}).code, 0);
  EXPECT_NEAR(solid_of(folder / "a.stl").size[0], 112, 0.3);
  EXPECT_EQ(nazori_cli({"model", "--strokes", folder / "a.str", "--raised", "-o", folder / "b.stl"}).code, 0);
  EXPECT_NEAR(solid_of(folder / "b.stl").size[2], 4.8, 0.02);
  expect_one_line(nazori_cli({"model", "--height-map", folder / "a.raw", "--raised", "-o", folder / "c.stl"}),
                  2, {"--raised", "--strokes"});
}

TEST(Model, WhatCannotBeMadeIsRefusedInOneLine) {
  const TemporaryFolder folder;
  expect_one_line(nazori_cli({"model", "-o", folder / "a.stl"}), 2, {"either characters or your own"});
  expect_one_line(nazori_cli({"model", "休", "--strokes", "a.str", "-o", folder / "a.stl"}), 2,
                  {"either characters or your own"});
  expect_one_line(nazori_cli({"model", "休", "-o", folder / "a.obj"}), 2, {"a.obj", ".svg or .nc"});
  expect_one_line(nazori_cli({"model", "休", "--depth-mm", "6", "-o", folder / "a.stl"}), 2, {"weaken"});
  expect_one_line(nazori_cli({"model", "休", "--size-mm", "9", "-o", folder / "a.stl"}), 2,
                  {"--size-mm", "10..500"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

std::string text_in(const std::string& file) {
  const auto bytes = bytes_of(file);
  return {bytes.begin(), bytes.end()};
}

TEST(Model, TheNameOfTheFileChoosesTheMachine) {
  const TemporaryFolder folder;
  const auto made = [&](const std::string& name, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"model", "休", "--json", "--output", folder / name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = nazori_cli(arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    return nlohmann::json::parse(run.out);
  };
  const auto mill = made("a.nc", {"--size-mm", "60", "--cutter-mm", "2", "--feed", "600"});
  EXPECT_EQ(mill["kind"], "mill");
  EXPECT_GT(mill["deepest_mm"].get<double>(), 1);
  EXPECT_LE(mill["deepest_mm"].get<double>(), 3);
  const std::string program = text_in(folder / "a.nc");
  EXPECT_TRUE(program.starts_with("(Nazori U+4F11)\n"));
  EXPECT_THAT(program, HasSubstr(" F600\n"));
  EXPECT_EQ(made("a.svg", {"--layers", "4"})["kind"], "laser");
  EXPECT_THAT(text_in(folder / "a.svg"), HasSubstr("id=\"layer-4\""));
  EXPECT_EQ(made("a.pdf", {"--paper", "letter"})["kind"], "swell-paper");
  EXPECT_TRUE(text_in(folder / "a.pdf").starts_with("%PDF"));
  EXPECT_EQ(made("a.brf")["kind"], "embosser");
  const std::string pages = text_in(folder / "a.brf");
  EXPECT_THAT(pages, HasSubstr("#F*%\r\n"));  // 6かく
  made("b.brf", {"--no-label"});
  EXPECT_THAT(text_in(folder / "b.brf"), testing::Not(HasSubstr("#F*%")));
}

TEST(Model, BrailleIsContractedWhereAskedFor) {
  const TemporaryFolder folder;
  const auto embossed = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"model", "休", "--output", folder / "a.brf"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = nazori_cli(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return text_in(folder / "a.brf");
  };
  // The first meaning of 休 is "rest". Contracted, st is one cell: / in ASCII braille.
  EXPECT_THAT(embossed({}), HasSubstr("\r\nREST  "));
  EXPECT_THAT(embossed({"--braille", "uncontracted"}), HasSubstr("\r\nREST  "));
  EXPECT_THAT(embossed({"--braille", "contracted"}), HasSubstr("\r\nRE/  "));
  expect_one_line(nazori_cli({"model", "休", "-o", folder / "b.brf", "--braille", "nemeth"}), 2,
                  {"--braille", "contracted"});
  // A full cell (=) stands where each of the six strokes starts.
  const std::string dots = embossed({"--no-label"});
  EXPECT_EQ(std::count(dots.begin(), dots.end(), '='), 6);
  const std::string bare = embossed({"--no-label", "--no-start-dots"});
  EXPECT_EQ(std::count(bare.begin(), bare.end(), '='), 0);
}

TEST(Model, AStandIsMadeForThePlate) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli(
      {"model", "一", "--size-mm", "60", "--output", folder / "a.stl", "--stand", folder / "feet.stl"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("two feet"));
  EXPECT_NEAR(solid_of(folder / "feet.stl").size[2], 10, 1e-4);
  // A stand changes nothing of the plate.
  EXPECT_EQ(nazori_cli({"model", "一", "--size-mm", "60", "--output", folder / "alone.stl"}).code, 0);
  EXPECT_EQ(text_in(folder / "alone.stl"), text_in(folder / "a.stl"));
  // The feet are for a plate of 6 mm, and a thicker one has wider feet.
  EXPECT_EQ(nazori_cli({"model", "一", "--size-mm", "60", "--thickness-mm", "12", "--output",
                        folder / "b.stl", "--stand", folder / "wide.stl", "--json"})
                .code,
            0);
  EXPECT_GT(solid_of(folder / "wide.stl").size[0], solid_of(folder / "feet.stl").size[0] + 5);
  expect_one_line(nazori_cli({"model", "一", "-o", folder / "a.pdf", "--stand", folder / "b.stl"}), 2,
                  {"--stand", ".stl or .3mf"});
}

TEST(Model, ForPeopleHasTheMeasuresOfTheJson) {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words{"model", "一", "--size-mm", "30", "--output", folder / name};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = nazori_cli(words);
    EXPECT_EQ(run.code, 0) << run.err;
    words.emplace_back("--json");
    return std::pair(run.out, nlohmann::json::parse(nazori_cli(words).out));
  };
  const auto number = [](const nlohmann::json& value, const char* form) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), form, value.get<double>());
    return std::string(text.data());
  };
  const auto size = [&](const nlohmann::json& made) {
    return number(made["width_mm"], "%.4g") + " x " + number(made["height_mm"], "%.4g");
  };
  const auto [solid, measures] = told("a.stl", {});
  EXPECT_EQ(solid, "一  " + (folder / "a.stl") + "  " + size(measures) + " x 6 mm, " +
                       measures["triangles"].dump() + " triangles within " +
                       number(measures["error_mm"], "%.3f") + " mm\n");
  EXPECT_NEAR(measures["width_mm"].get<double>(), 42, 0.1);
  const auto [mill, milling] = told("a.nc", {});
  EXPECT_EQ(mill.find("一  " + (folder / "a.nc") + "  " + size(milling) + " mm, " + milling["passes"].dump() +
                      " passes down to " + number(milling["deepest_mm"], "%.2f") + " mm, "),
            0U)
      << mill;
  EXPECT_THAT(mill, testing::ContainsRegex(" mm, [0-9]+\\.[0-9] m in about [0-9]+ min\n$"));
  const auto [laser, cut] = told("a.svg", {});
  EXPECT_EQ(laser, "一  " + (folder / "a.svg") + "  " + size(cut) + " mm\n");
  EXPECT_EQ(told("a.brf", {}).second["kind"], "embosser");
  EXPECT_EQ(told("a.pdf", {}).first, "一  " + (folder / "a.pdf") + "  210 x 297 mm\n");
}

TEST(Model, NumbersThatFindNoRoomAreNamed) {
  const TemporaryFolder folder;
  const Outcome run =
      nazori_cli({"model", "鬱", "--raised", "--size-mm", "40", "--output", folder / "a.stl"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out,
              testing::ContainsRegex("\nno room for the numbers of strokes [0-9]+(, [0-9]+)*: a larger "
                                     "--size-mm has more\n$"));
  EXPECT_THAT(nazori_cli({"model", "一", "--raised", "--output", folder / "b.stl"}).out,
              testing::Not(HasSubstr("no room")));
}

TEST(Model, AStandStaysOutOfJsonAndOfStandardOutput) {
  const TemporaryFolder folder;
  const std::vector<std::string> model{"model",          "一",     "--size-mm", "60", "--output",
                                       folder / "a.stl", "--stand"};
  const auto run = [&](const std::string& stand, const std::vector<std::string>& more) {
    auto words = model;
    words.push_back(stand);
    words.insert(words.end(), more.begin(), more.end());
    return nazori_cli(words);
  };
  EXPECT_TRUE(nlohmann::json::parse(run(folder / "f.stl", {"--json"}).out).is_object());
  EXPECT_THAT(run(folder / "f.stl", {}).out,
              testing::ContainsRegex("\nstand  .*/f.stl  two feet, leaning [0-9.]+ degrees\n$"));
  expect_one_line(run("-", {}), 2, {"--stand", "a stand does not go to standard output"});
  expect_one_line(run(folder / "a.stl", {}), 2, {"is the same file as"});
  expect_one_line(run(folder / "f.pdf", {}), 2, {"--stand", ".stl or .3mf"});
}

TEST(Model, TabletsStandInRows) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"model", "一", "二", "三", "--size-mm", "30", "--columns", "2", "--gap-mm", "10",
                        "--no-hole", "-o", folder / "a.stl"})
                .code,
            0);
  const Solid solid = solid_of(folder / "a.stl");
  EXPECT_NEAR(solid.size[0], 82, 0.3);
  EXPECT_NEAR(solid.size[1], 82, 0.3);
  expect_one_line(nazori_cli({"model", "一", "二", "--vertical", "--columns", "2", "-o", folder / "b.stl"}),
                  2, {"--columns"});
}

TEST(Model, APlotIsMadeForPaperThatFingersRead) {
  const TemporaryFolder folder;
  const auto plot = [&](const std::string& name, std::vector<std::string> more = {},
                        const std::string& expression = "y = sin(x)") {
    std::vector<std::string> words{"plot", expression, "--window=-4,4,-4,4", "--model", folder / name};
    words.insert(words.end(), more.begin(), more.end());
    return nazori_cli(words);
  };
  EXPECT_EQ(plot("a.brf", {"--columns-braille", "30", "--lines-braille", "20"}).code, 0);
  const std::string page = text_in(folder / "a.brf");
  EXPECT_EQ(std::count(page.begin(), page.end(), '\n'), 20);
  EXPECT_THAT(page, HasSubstr("-#D"));
  EXPECT_TRUE(page.ends_with("\r\n\f"));
  EXPECT_EQ(plot("n.brf", {"--braille", "nemeth"}, "y = x").code, 0);
  EXPECT_EQ(plot("u.brf", {"--braille", "ueb"}, "y = x").code, 0);
  EXPECT_EQ(plot("d.brf", {}, "y = x").code, 0);
  EXPECT_EQ(text_in(folder / "d.brf"), text_in(folder / "u.brf"));
  EXPECT_NE(text_in(folder / "n.brf"), text_in(folder / "u.brf"));

  EXPECT_EQ(plot("a.pdf", {"--paper", "b5", "--model-size-mm", "90"}).code, 0);
  EXPECT_TRUE(text_in(folder / "a.pdf").starts_with("%PDF"));
  // Parallels a third of a unit apart: one unit is 15 mm.
  const Outcome close = plot("c.pdf", {}, "y = 1; y = 4/3");
  EXPECT_EQ(close.code, 0);
  EXPECT_THAT(close.out, HasSubstr("lines run 5.0 mm apart"));
  EXPECT_THAT(close.out, HasSubstr("1.28 times"));
  expect_one_line(plot("a.pdf", {"--model-size-mm", "200"}), 2, {"200 mm", "40 to 139 mm"});
  expect_one_line(plot("s.pdf", {}, "z = x y"), 2, {"--model", "surface", ".stl"});
  expect_one_line(plot("a.nc"), 2, {"--model", ".brf"});
}

TEST(Model, APlotIsRaisedWithItsAxes) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli(
      {"plot", "y = sin(x)", "--window=-4,4,-2,2", "--model", folder / "a.stl", "--model-size-mm", "80"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Solid solid = solid_of(folder / "a.stl");
  EXPECT_NEAR(solid.size[2], 4, 0.02);
  EXPECT_GT(solid.size[0], 80 + 30);
  EXPECT_LT(solid.triangles, 100'000U);
  EXPECT_EQ(nazori_cli({"plot", "z = x*y", "--model", folder / "b.stl"}).code, 0);
  EXPECT_NEAR(solid_of(folder / "b.stl").size[2], 23, 0.5);
}

}  // namespace
}  // namespace nazori::cli::test
