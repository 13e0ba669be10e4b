// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "nazori/kanji/stroke_order.h"
#include "nazori/view/offscreen.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

view::Picture picture(const std::filesystem::path& path) {
  auto loaded = view::load_picture_png(path);
  EXPECT_TRUE(loaded) << base::to_line(loaded.error());
  return loaded ? std::move(*loaded) : view::Picture{};
}

/// Part of the pixels that differ visibly.
double difference(const view::Picture& a, const view::Picture& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  if (a.rgba.size() != b.rgba.size() || a.rgba.empty()) return 1;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      most = std::max(most, std::abs(int{a.rgba[i + channel]} - int{b.rgba[i + channel]}));
    }
    different += most > 24 ? 1 : 0;
  }
  return static_cast<double>(different) / (static_cast<double>(a.rgba.size()) / 4);
}

view::Picture rendered(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  const std::string path = folder / "picture.png";
  arguments.insert(arguments.begin(), "render");
  arguments.insert(arguments.end(), {"--output", path});
  const Outcome run = nazori_cli(arguments);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(path));
  return picture(path);
}

TEST(Render, ThePictureHasTheSizeAskedFor) {
  const view::Picture wide = rendered({"休", "--size", "320x200"});
  EXPECT_EQ(wide.width, 320);
  EXPECT_EQ(wide.height, 200);
  const view::Picture square = rendered({"休", "--size", "200"});
  EXPECT_EQ(square.width, 200);
  EXPECT_EQ(square.height, 200);
}

TEST(Render, ASideHasSixteenToEightThousandPixels) {
  EXPECT_EQ(rendered({"休", "--size", "16x17", "--map-size", "64"}).width, 16);
  EXPECT_EQ(rendered({"休", "--size", "17x16", "--map-size", "64"}).height, 16);
  const TemporaryFolder folder;
  for (const char* size : {"15", "16x15", "15x16", "8193", "16x8193", "16x", "x16", "-16"}) {
    const Outcome refused = nazori_cli({"render", "休", "--size", size, "--output", folder / "a.png"});
    EXPECT_EQ(refused.code, 2) << size;
    EXPECT_THAT(refused.err, HasSubstr("each 16..8192")) << size;
  }
}

TEST(Render, EveryOptionChangesThePicture) {
  const std::vector<std::string> plain{"休", "--size", "240", "--map-size", "256"};
  const view::Picture first = rendered(plain);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{"--style", "classic"},
                                                                                      {"--style", "slate"},
                                                                                      {"--theme", "dark"},
                                                                                      {"--stroke", "1"},
                                                                                      {"--no-strokes"},
                                                                                      {"--no-numbers"},
                                                                                      {"--no-arrows"},
                                                                                      {"--tilt", "50"},
                                                                                      {"--azimuth", "30"},
                                                                                      {"--zoom", "2"},
                                                                                      {"--width", "3"},
                                                                                      {"--depth", "0.2"}}) {
    std::vector<std::string> arguments = plain;
    arguments.insert(arguments.end(), option.begin(), option.end());
    EXPECT_GT(difference(first, rendered(arguments)), 0.0005) << option.front();
  }
  std::vector<std::string> wood = plain;
  wood.insert(wood.end(), {"--style", "default"});
  EXPECT_LT(difference(first, rendered(wood)), 0.001);
}

TEST(Render, TheClassicBackgroundIsTheBlueOf2005) {
  const view::Picture classic = rendered({"休", "--style", "classic", "--size", "600"});
  const std::vector<int> corner{classic.rgba[0], classic.rgba[1], classic.rgba[2]};
  EXPECT_THAT(corner, ElementsAre(0, 0, 255));
}

TEST(Render, ACarvedFileLooksLikeTheCharacterItWasCarvedFrom) {
  const TemporaryFolder folder;
  const std::string raw = folder / "a.raw";
  const std::string png = folder / "a.png";
  const std::string str = folder / "a.str";
  ASSERT_EQ(nazori_cli({"carve", "休", "--size", "512", "-o", png, "--strokes", str}).code, 0);
  ASSERT_EQ(nazori_cli({"carve", "休", "--size", "512", "-o", raw}).code, 0);
  const view::Picture own = rendered({"休", "--map-size", "512", "--size", "300", "--no-strokes"});
  const view::Picture from_png = rendered({"--height-map", png, "--size", "300"});
  EXPECT_LT(difference(own, from_png), 0.01);
  // 256 levels show as faint steps in the light.
  const view::Picture from_raw = rendered({"--height-map", raw, "--map-size", "512", "--size", "300"});
  EXPECT_LT(difference(own, from_raw), 0.05);
  const view::Picture with_strokes = rendered({"--height-map", raw, "--strokes", str, "--size", "300"});
  EXPECT_GT(difference(from_raw, with_strokes), 0.005);
  const view::Picture carved = rendered({"--strokes", str, "--map-size", "512", "--size", "300"});
  EXPECT_LT(difference(rendered({"休", "--size", "300"}), carved), 0.1);
}

TEST(Render, SeveralCharactersGetAPictureEach) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"render", "休木", "--size", "100", "-o", folder / "{}-small.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("休-small.png", "木-small.png"));
}

TEST(Render, AnyMistakeIsOneLineAndLeavesNoPicture) {
  const TemporaryFolder folder;
  const TemporaryFolder files;
  write(files / "1000.raw", std::string(1000, 'x'));
  write(files / "16384.raw", std::string(16384, 'x'));
  write(files / "empty.raw", "");
  write(files / "cut.str", std::string("\x06\0\0\0\x02\0\0", 7));
  write(files / "minus.str", "\xFF\xFF\xFF\xFF");
  write(files / "bad.png", "\x89PNG\r\n\x1A\nthis is none");
  const std::string out = folder / "a.png";
  const auto bad = [&](std::vector<std::string> arguments, const std::vector<std::string>& words) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--output", out});
    expect_one_line(nazori_cli(arguments), 2, words);
  };
  bad({}, {"nothing to draw"});
  bad({"休", "--size", "0x0"}, {"--size", "1280x800"});
  bad({"休", "--size", "100000x100"}, {"--size"});
  bad({"休", "--size", "axb"}, {"--size", "axb"});
  bad({"休", "--stroke", "7"}, {"--stroke 7", "6 strokes"});
  bad({"休", "--stroke", "-1"}, {"--stroke"});
  bad({"休", "--style", "marble"}, {"--style", "classic"});
  bad({"休", "--tilt", "95"}, {"--tilt"});
  bad({"休", "--zoom", "0"}, {"--zoom"});
  bad({"休", "--height-map", files / "16384.raw"}, {"--height-map", "not both"});
  bad({"--height-map", files / "1000.raw"}, {"1000.raw", "1000"});
  bad({"--height-map", files / "16384.raw", "--map-size", "100"}, {"16384.raw", "10000"});
  bad({"--height-map", files / "16384.raw", "--map-size", "0"}, {"--map-size", "2..8192"});
  bad({"--height-map", files / "empty.raw"}, {"empty.raw"});
  bad({"--height-map", files / "none.raw"}, {"none.raw"});
  bad({"--height-map", files.path().string()}, {"folder"});
  bad({"--height-map", files / "bad.png"}, {"bad.png"});
  bad({"--strokes", files / "cut.str"}, {"cut.str"});
  bad({"--strokes", files / "minus.str"}, {"minus.str"});
  bad({"--height-map", files / "16384.raw", "--strokes", files / "cut.str"}, {"cut.str"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

TEST(Render, AFileOfAsManyStrokesAsAreAllowedIsDrawn) {
  // When every stroke was compared with every other one, this took a quarter of an hour.
  constexpr int kGrid = 8192;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> anywhere(0, kGrid - 1);
  std::uniform_real_distribution<double> turn(-0.3, 0.3);
  kanji::StrokeOrder order;
  for (int stroke = 0; stroke < kanji::StrokeOrder::kMaxStrokes; ++stroke) {
    double x = anywhere(random);
    double y = anywhere(random);
    double way = anywhere(random);
    kanji::StrokeOrder::Points points;
    for (int i = 0; i < 1'000; ++i) {
      points.push_back({static_cast<int>(std::clamp(x, 0.0, kGrid - 1.0)),
                        static_cast<int>(std::clamp(y, 0.0, kGrid - 1.0))});
      way += turn(random);
      x += 9 * std::cos(way);
      y += 9 * std::sin(way);
    }
    order.add_stroke(std::move(points));
  }
  const TemporaryFolder folder;
  ASSERT_TRUE(order.save(folder / "many.str"));
  const Outcome run = nazori_cli(
      {"render", "--strokes", folder / "many.str", "--map-size", "8192", "--output", folder / "many.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(picture(folder / "many.png").width, 800);
}

TEST(Render, PlacesThatCannotBeWrittenAreNamedBeforeTheWork) {
  const TemporaryFolder folder;
  expect_one_line(nazori_cli({"render", "休", "-o", folder / "none/a.png"}), 2, {"the folder"});
  expect_one_line(nazori_cli({"render", "休", "-o", folder / "a.raw"}), 2, {"a.raw", ".png"});
  expect_one_line(nazori_cli({"render", "休木", "-o", folder / "a.png"}), 2, {"{}"});
  expect_one_line(nazori_cli({"render", "☃", "-o", folder / "a.png"}), 1, {"☃"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

}  // namespace
}  // namespace nazori::cli::test
