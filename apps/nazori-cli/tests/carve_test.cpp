// SPDX-License-Identifier: Apache-2.0
#include "nazori/carving/carve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/kanji/centre_lines.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<kanji::StrokeLine> lines_of_rest() {
  const auto database = kanji::KanjiDatabase::open(data_folder() / "kanji.db");
  EXPECT_TRUE(database);
  return database->find(U'休')->lines();
}

TEST(Carve, ARawIsWhatTheLibraryCarves) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"carve", "休", "--size", "128", "--output", folder / "休.raw"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("休.raw"));
  const auto map = carving::carve(lines_of_rest(), 128);
  ASSERT_TRUE(map);
  EXPECT_EQ(bytes_of(folder / "休.raw"), surface::to_raw(*map));
  EXPECT_EQ(bytes_of(folder / "休.raw").size(), 128U * 128U);
}

TEST(Carve, APngHasSixteenBitsUnlessEightAreAskedFor) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"carve", "休", "-o", folder / "16.png"}).code, 0);
  EXPECT_EQ(nazori_cli({"carve", "休", "-o", folder / "8.PNG", "--bits", "8"}).code, 0);
  const auto map = carving::carve(lines_of_rest(), 128);
  ASSERT_TRUE(map);
  EXPECT_EQ(bytes_of(folder / "16.png"), surface::to_png(*map, surface::PngDepth::bits_16));
  EXPECT_EQ(bytes_of(folder / "8.PNG"), surface::to_png(*map, surface::PngDepth::bits_8));
}

TEST(Carve, TheBrushIsTheOneAskedFor) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"carve", "休", "-o", folder / "a.raw", "--size", "200", "--width", "9", "--depth",
                        "0.5", "--cross-section", "v", "--no-endings"})
                .code,
            0);
  carving::Brush brush;
  brush.width = 9;
  brush.depth = 0.5;
  brush.cross_section = carving::CrossSection::v_shaped;
  brush.endings = false;
  brush.fit = false;
  const auto map = carving::carve(lines_of_rest(), 200, brush);
  ASSERT_TRUE(map);
  EXPECT_EQ(bytes_of(folder / "a.raw"), surface::to_raw(*map));
}

TEST(Carve, TheStrokeFileLiesOnTheSameGrid) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      nazori_cli({"carve", "休", "--size", "300", "-o", folder / "a.raw", "--strokes", folder / "a.str"})
          .code,
      0);
  const auto order = kanji::StrokeOrder::load(folder / "a.str", 300);
  ASSERT_TRUE(order) << base::to_line(order.error());
  EXPECT_EQ(*order, kanji::StrokeOrder::from_lines(kanji::centre_lines(lines_of_rest()), 300));
  EXPECT_EQ(order->count(), 6U);
}

TEST(Carve, SeveralCharactersGoToAFolderOrToNamesWithThemIn) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"carve", "休木", "正-HzFst", "-o", folder.path().string()}).code, 0);
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("休.png", "木.png", "正-HzFst.png"));
  const TemporaryFolder named;
  EXPECT_EQ(nazori_cli({"carve", "休", "木", "-o", named / "x{}.raw", "--strokes", named / "{}.str"}).code,
            0);
  EXPECT_THAT(named.names(), testing::UnorderedElementsAre("x休.raw", "x木.raw", "休.str", "木.str"));
}

TEST(Carve, ADotDoesNotMakeAHiddenFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(nazori_cli({"carve", ".", "-o", folder.path().string()}).code, 0);
  EXPECT_THAT(folder.names(), ElementsAre("U+002E.png"));
}

TEST(Carve, AnyMistakeIsOneLineAndLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string png = folder / "a.png";
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--size", "0"}), 2, {"--size", "2..8192"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--size", "1000000"}), 2, {"--size", "2..8192"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--size", "-5"}), 2, {"--size"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--size", "12.5"}), 2, {"--size", "12.5"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--size", "big"}), 2, {"--size", "big"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--width", "0"}), 2, {"--width", "0.5..40"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--width", "nan"}), 2, {"--width"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--depth", "2"}), 2, {"--depth"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--cross-section", "square"}), 2,
                  {"--cross-section", "flat"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--bits", "12"}), 2, {"--bits", "12"});
  expect_one_line(nazori_cli({"carve", "休", "-o", folder / "a.raw", "--bits", "16"}), 2,
                  {"--bits 16", ".png"});
  expect_one_line(nazori_cli({"carve", "休", "-o", folder / "a.jpg"}), 2, {"a.jpg", ".png or .raw"});
  expect_one_line(nazori_cli({"carve", "休", "-o", folder / "none/a.png"}), 2, {"the folder", "none"});
  expect_one_line(nazori_cli({"carve", "休", "-o", folder / "none/"}), 2, {"the folder", "none"});
  expect_one_line(nazori_cli({"carve", "休木", "-o", png}), 2, {"2 characters", "{}"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--strokes", folder / "a.txt"}), 2,
                  {"a.txt", ".str"});
  expect_one_line(nazori_cli({"carve", "休", "-o", png, "--strokes", folder / "none/a.str"}), 2,
                  {"the folder"});
  expect_one_line(nazori_cli({"carve", "休", "-o", "/dev/null/a.png"}), 2, {"/dev/null"});
  expect_one_line(nazori_cli({"carve", "\xC0\x80", "-o", png}), 2, {"UTF-8"});
  expect_one_line(nazori_cli({"carve", "☃", "-o", png}), 1, {"☃", "not in the database"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

TEST(Carve, ACharacterThatOnlyTheDictionaryKnowsHasNothingToCarve) {
  const auto database = kanji::KanjiDatabase::open(data_folder() / "kanji.db");
  ASSERT_TRUE(database);
  // 亜's neighbour in JIS X 0212, 丂: in KANJIDIC2, not in KanjiVG.
  const auto character = database->find(U'丂');
  ASSERT_TRUE(character);
  ASSERT_TRUE(character->strokes.empty());
  const TemporaryFolder folder;
  expect_one_line(nazori_cli({"carve", "丂", "-o", folder / "a.png"}), 1, {"丂", "no strokes"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

TEST(Carve, OneUnknownAmongSeveralStopsBeforeTheFirstIsWritten) {
  const TemporaryFolder folder;
  expect_one_line(nazori_cli({"carve", "休☃木", "-o", folder.path().string()}), 1, {"☃"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

TEST(Carve, AnOldFileStandsUntilTheNewOneIsWhole) {
  const TemporaryFolder folder;
  write(folder / "a.raw", "old");
  EXPECT_EQ(nazori_cli({"carve", "☃", "-o", folder / "a.raw"}).code, 1);
  EXPECT_EQ(bytes_of(folder / "a.raw").size(), 3U);
  EXPECT_EQ(nazori_cli({"carve", "休", "-o", folder / "a.raw"}).code, 0);
  EXPECT_EQ(bytes_of(folder / "a.raw").size(), 128U * 128U);
  EXPECT_THAT(folder.names(), ElementsAre("a.raw"));
}

}  // namespace
}  // namespace nazori::cli::test
