// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/paper.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>

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

TEST(Paper, EveryPropertyTakesBothEndsOfItsRangeAndNothingBeyond) {
  // The ranges of the header.
  struct Range {
    const char* name;
    double least, most;
  };
  const std::array<Range, 13> ranges{
      Range{"spread_m2_s", 0, 4e-6},     Range{"spread_variation", 0, 1}, Range{"pinning", 0, 0.9},
      Range{"pinning_height", 0, 0.9},   Range{"pinning_fibre", 0, 0.9},  Range{"absorption_s", 0, 100},
      Range{"rim_drying", 0, 10},        Range{"granulation", 0, 1},      Range{"kasure_s", 0, 10},
      Range{"kasure_exponent", 0.25, 4}, Range{"film", 0.05, 4},          Range{"grain_m", 0.0001, 0.005},
      Range{"wet_darkening", 0, 0.95}};
  const auto reads = [](const std::string& name, double value) {
    return parse_paper(name + " = " + std::to_string(value * 1e9) + "e-9").has_value();
  };
  for (const auto& [name, least, most] : ranges) {
    EXPECT_TRUE(reads(name, least)) << name;
    EXPECT_TRUE(reads(name, most)) << name;
    EXPECT_FALSE(reads(name, least - 0.01 * most)) << name;
    EXPECT_FALSE(reads(name, 1.01 * most)) << name;
  }
  EXPECT_TRUE(reads("drying_s", 0));
  EXPECT_TRUE(reads("drying_s", 0.5));
  EXPECT_FALSE(reads("drying_s", 0.49));
  EXPECT_FALSE(reads("drying_s", -1));
  EXPECT_TRUE(parse_paper("colour = 0.05 1 0.05"));
  for (const char* colour : {"0.049 1 1", "1 0.049 1", "1 1 0.049", "1.001 1 1", "1 1.001 1", "1 1 1.001"})
    EXPECT_FALSE(parse_paper(std::string("colour = ") + colour)) << colour;
}

TEST(Paper, ANameHasOneToAHundredPrintableBytes) {
  EXPECT_EQ(parse_paper("name = " + std::string(100, 'a')).value().name, std::string(100, 'a'));
  EXPECT_FALSE(parse_paper("name = " + std::string(101, 'a')));
  EXPECT_EQ(parse_paper("name = 和紙 ~").value().name, "和紙 ~");
  EXPECT_FALSE(
      parse_paper("name = a\x1F"
                  "b"));
  EXPECT_FALSE(
      parse_paper("name = a\x7F"
                  "b"));
  Paper paper;
  for (const char* name : {"", "a#b", "a\nb"}) {
    paper.name = name;
    EXPECT_FALSE(check(paper)) << name;
  }
}

TEST(Paper, TheFirstOneIsPracticePaperWithTheValuesOfTheHeader) {
  EXPECT_EQ(find_paper("hanshi").value(), Paper{});
  const Paper p;
  EXPECT_EQ((std::array{p.spread_m2_s, p.spread_variation, p.pinning, p.pinning_height, p.pinning_fibre}),
            (std::array{1e-8, 0.5, 0.02, 0.1, 0.1}));
  EXPECT_EQ((std::array{p.absorption_s, p.drying_s, p.rim_drying, p.fixing_s, p.granulation}),
            (std::array{0.05, 40.0, 1.5, 30.0, 0.4}));
  EXPECT_EQ((std::array{p.kasure_s, p.kasure_exponent, p.film, p.grain_m, p.wet_darkening}),
            (std::array{0.03, 1.0, 0.9, 0.00025, 0.06}));
  EXPECT_EQ(p.colour, (std::array{0.93, 0.92, 0.88}));
  EXPECT_EQ(p.seed, 1U);
}

TEST(Paper, TheOthersDifferFromItAsTheirNamesPromise) {
  const Paper hanshi = find_paper("hanshi").value(), fast = find_paper("gasenshi").value(),
              slow = find_paper("gasenshi-slow").value(), board = find_paper("board").value(),
              water = find_paper("water").value();
  EXPECT_EQ(fast.spread_m2_s, 5 * hanshi.spread_m2_s) << "it bleeds";
  EXPECT_LT(fast.absorption_s, hanshi.absorption_s);
  EXPECT_LT(fast.fixing_s, hanshi.fixing_s);
  Paper changed = slow;
  changed.name = fast.name;
  changed.spread_m2_s = fast.spread_m2_s;
  changed.absorption_s = fast.absorption_s;
  changed.drying_s = fast.drying_s;
  changed.fixing_s = fast.fixing_s;
  EXPECT_EQ(changed, fast) << "the same sheet, slower";
  EXPECT_LT(slow.spread_m2_s, fast.spread_m2_s);
  EXPECT_EQ(slow.absorption_s, 15 * fast.absorption_s);
  EXPECT_EQ(slow.fixing_s, 5 * fast.fixing_s) << "so it bleeds far";
  EXPECT_EQ(board.spread_m2_s, hanshi.spread_m2_s / 10) << "it hardly drinks";
  EXPECT_EQ(board.absorption_s, 40 * hanshi.absorption_s);
  EXPECT_EQ(board.fixing_s, 0) << "paint settles only by drying";
  EXPECT_GT(board.film, 3 * hanshi.film) << "thick paint";
  EXPECT_EQ(water.wet_darkening, 0.85) << "what is wet is dark";
  EXPECT_LT(water.colour[0], hanshi.colour[0]);
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

TEST(Paper, EachKindHasItsValues) {
  const auto paper = [](const char* text) { return parse_paper(text).value(); };
  EXPECT_EQ(
      find_paper("gasenshi").value(),
      paper("name = gasenshi\nspread_m2_s = 5e-8\nspread_variation = 0.8\npinning = 0.01\n"
            "pinning_height = 0.08\npinning_fibre = 0.16\nabsorption_s = 0.02\ndrying_s = 60\n"
            "fixing_s = 12\ngranulation = 0.3\nfilm = 1.6\ngrain_m = 0.0002\ncolour = 0.94 0.93 0.9\n"));
  EXPECT_EQ(find_paper("gasenshi-slow").value(),
            paper("paper = gasenshi\nname = gasenshi-slow\nspread_m2_s = 1.5e-8\nabsorption_s = 0.3\n"
                  "drying_s = 150\nfixing_s = 60\n"));
  EXPECT_EQ(find_paper("board").value(),
            paper("name = board\nspread_m2_s = 1e-9\npinning = 0.5\nabsorption_s = 2\ndrying_s = 30\n"
                  "rim_drying = 3\nfixing_s = 0\ngranulation = 0.2\nfilm = 3\ngrain_m = 0.0004\n"
                  "wet_darkening = 0.02\ncolour = 0.95 0.95 0.93\n"));
  EXPECT_EQ(find_paper("water").value(),
            paper("name = water\nspread_m2_s = 4e-9\ndrying_s = 90\nrim_drying = 1\nwet_darkening = 0.85\n"
                  "colour = 0.72 0.7 0.66\n"));
}

}  // namespace
}  // namespace nazori::paint
