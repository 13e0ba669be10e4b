// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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
  expect_one_line(nazori_cli({"model", "休", "-o", folder / "a.obj"}), 2, {"a.obj", ".stl or .3mf"});
  expect_one_line(nazori_cli({"model", "休", "--depth-mm", "6", "-o", folder / "a.stl"}), 2, {"weaken"});
  expect_one_line(nazori_cli({"model", "休", "--size-mm", "9", "-o", folder / "a.stl"}), 2,
                  {"--size-mm", "10..500"});
  EXPECT_THAT(folder.names(), ElementsAre());
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
