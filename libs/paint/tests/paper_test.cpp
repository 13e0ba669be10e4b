// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/paper.h"

#include <gtest/gtest.h>

#include <fstream>

#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

TEST(Paper, EveryPaperIsWithinItsRangesAndHasItsName) {
  for (const std::string_view name : paper_names()) {
    const auto paper = find_paper(name);
    ASSERT_TRUE(paper);
    EXPECT_EQ(paper->name, name);
    EXPECT_TRUE(check(*paper)) << name;
    EXPECT_TRUE(Sheet::create(1024, *paper, test::palette())) << name;
  }
  EXPECT_EQ(find_paper("vellum").error().code, base::Errc::not_found);
}

TEST(Paper, ItsTextGivesTheSamePaperAgain) {
  for (const std::string_view name : paper_names()) {
    Paper paper = find_paper(name).value();
    paper.film = 1.0 / 3;
    paper.colour[1] = 0.123456789012345678;
    paper.seed = 4294967295U;
    EXPECT_EQ(parse_paper(to_text(paper)).value(), paper);
  }
}

TEST(Paper, AFileStartsFromAKnownPaperAndNamesWhatDiffers) {
  const auto paper = parse_paper(
      "# thin\n\npaper = gasenshi\r\nname=mine # not the shop's\n film =  0.5\ncolour = 0.5 0.25\t1\nseed = "
      "9");
  ASSERT_TRUE(paper) << base::to_line(paper.error());
  Paper wanted = find_paper("gasenshi").value();
  wanted.name = "mine";
  wanted.film = 0.5;
  wanted.colour = {0.5, 0.25, 1};
  wanted.seed = 9;
  EXPECT_EQ(*paper, wanted);
  EXPECT_EQ(parse_paper("").value(), Paper{});
}

TEST(Paper, WhatIsWrongIsNamedWithItsLine) {
  const auto line = [](std::string_view text) {
    const auto paper = parse_paper(text);
    EXPECT_FALSE(paper) << text;
    EXPECT_EQ(paper.error().code, base::Errc::parse);
    return base::to_line(paper.error());
  };
  EXPECT_EQ(line("film = 1\nfilm"), "line 2: has no = (write name = value)");
  EXPECT_EQ(line("film = thick"), "line 1, film: is no number (give 0.05 to 4)");
  EXPECT_EQ(line("film = 1e"), "line 1, film: is no number (give 0.05 to 4)");
  EXPECT_EQ(line("film = 9"), "film: 9 is outside its range (give 0.05 to 4)");
  EXPECT_EQ(line("film = nan"), "film: nan is outside its range (give 0.05 to 4)");
  EXPECT_EQ(line("drying_s = 0.4"), "drying_s: 0.4 is too short (give 0.5 or longer, or 0 for never)");
  EXPECT_EQ(line("colour = 1 1"), "line 1, colour: is no colour (give three numbers, as in 0.9 0.9 0.85)");
  EXPECT_EQ(line("colour = 1 1 1 1"),
            "line 1, colour: is no colour (give three numbers, as in 0.9 0.9 0.85)");
  EXPECT_EQ(line("colour = 1 1 0.04"), "colour: 0.04 is outside its range (give 0.05 to 1)");
  EXPECT_EQ(line("seed = -1"), "line 1, seed: is no seed (give 0 to 4294967295)");
  EXPECT_EQ(line("name = "), "line 1, name: is no name (give 1 to 100 letters)");
  EXPECT_EQ(line("gloss = 1").substr(0, 33), "line 1, gloss: there is no gloss ");
  EXPECT_NE(line("paper = vellum").find("gasenshi-slow"), std::string::npos);
  EXPECT_EQ(line(std::string(65537, ' ')), "is too long (give at most 65536 bytes)");
  EXPECT_EQ(load_paper("no-such-file").error().code, base::Errc::not_found);
}

TEST(Paper, HeightsAreEquallyFrequentOverTheWholeSheet) {
  const Sheet sheet = test::sheet_of(256);
  std::array<int, 16> counts{};
  double side_by_side = 0, far_apart = 0;
  for (int row = 0; row < 256; ++row) {
    for (int column = 0; column < 256; ++column) {
      const double height = sheet.at(column, row).height;
      ++counts[static_cast<std::size_t>(std::min(height * 16, 15.0))];
      side_by_side += std::abs(height - sheet.at((column + 1) % 256, row).height);
      far_apart += std::abs(height - sheet.at((column + 97) % 256, row).height);
    }
  }
  for (const int count : counts) EXPECT_NEAR(count, 4096, 2);
  // Two independent heights differ by a third in the mean.
  EXPECT_NEAR(far_apart / 65536, 1.0 / 3, 0.02);
  EXPECT_LT(side_by_side / 65536, 0.33);
}

TEST(Paper, AnotherSeedIsAnotherSheetAndTheSameSeedTheSame) {
  Paper paper;
  const Sheet one = test::sheet_of(128, paper), same = test::sheet_of(128, paper);
  paper.seed = 2;
  const Sheet other = test::sheet_of(128, paper);
  int equal = 0;
  for (int i = 0; i < 128; ++i) {
    EXPECT_EQ(one.at(i, 50).height, same.at(i, 50).height);
    equal += one.at(i, 50).height == other.at(i, 50).height ? 1 : 0;
  }
  EXPECT_LT(equal, 10);
}

}  // namespace
}  // namespace nazori::paint
