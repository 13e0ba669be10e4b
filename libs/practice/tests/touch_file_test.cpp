// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/touch_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace nazori::practice {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

kanji::StrokeLine line(geometry::Polyline<geometry::GlyphFrame> points,
                       kanji::StrokeEnding ending = kanji::StrokeEnding::stop) {
  kanji::StrokeLine made;
  made.points = std::move(points);
  made.ending = ending;
  return made;
}

/// As 二: two strokes from left to right, 44 units apart.
SolidTablet two_bars() { return {{line({{20, 30}, {90, 30}}), line({{10, 74}, {100, 74}})}, {}}; }

SolidSettings grooved(double side_mm) {
  SolidSettings settings;
  settings.raised = false;
  settings.plate.side_mm = side_mm;
  return settings;
}

std::u32string patterns(const std::vector<model::BrailleCell>& cells) {
  std::u32string out;
  for (const model::BrailleCell cell : cells) out += static_cast<char32_t>(0x2800 + cell);
  return out;
}

kanji::Character rest() {
  kanji::Character character;
  character.code_point = U'休';
  for (int i = 0; i < 6; ++i) character.strokes.push_back({"", "", line({{20, 20}, {80, 80}})});
  character.entry.on_readings = {"キュウ"};
  character.entry.kun_readings = {"やす.む", "やす.まる", "やす.む"};
  character.entry.meanings = {{"en", "rest"}, {"fr", "repos"}, {"en", "day off"}, {"en", "retire (from)"}};
  return character;
}

std::vector<std::u32string> cells_of_label(
    const kanji::Character& character, model::EnglishBraille english = model::EnglishBraille::uncontracted) {
  std::vector<std::u32string> lines;
  const auto label = braille_lines(touch_label(character), english).value();
  for (const auto& cells : label) lines.push_back(patterns(cells));
  return lines;
}

std::vector<std::u32string> cells_of_name(const std::string& name, std::size_t strokes) {
  std::vector<std::u32string> lines;
  const auto label = braille_lines(touch_label(name, strokes)).value();
  for (const auto& cells : label) lines.push_back(patterns(cells));
  return lines;
}

TEST(TouchFile, ATabletOfAFileIsCalledByItsName) {
  EXPECT_THAT(cells_of_name("hill", 0), ElementsAre(U"⠓⠊⠇⠇"));
  // に and 2 かく, each in Japanese braille.
  EXPECT_THAT(cells_of_name("に", 2), ElementsAre(U"⠇", U"⠼⠃⠡⠩"));
  EXPECT_THAT(cells_of_name("二", 1), ElementsAre(U"⠼⠁⠡⠩")) << "kanji have no cells";
}

TEST(TouchFile, AMillCutsWhereTheStrokesAre) {
  const SolidTablet tablet = two_bars();
  const auto made = mill_file({&tablet, 1}, grooved(60), {}, "二 x二");
  ASSERT_TRUE(made) << base::to_line(made.error());
  EXPECT_THAT(made->content, HasSubstr("(Nazori U+4E8C x U+4E8C)"));
  EXPECT_NEAR(made->width_mm, 72, 0.3);
  EXPECT_GE(made->path.passes, 2);
  // What is cut more than half as deep as the deepest place lies on the middle lines, y up from the lower
  // edge of the plate.
  std::istringstream lines(made->content);
  std::string word;
  double x = 0;
  double y = 0;
  double z = 0;
  double low_x = 1e9;
  double high_x = 0;
  while (lines >> word) {
    if (word[0] == 'X') x = std::stod(word.substr(1));
    if (word[0] == 'Y') y = std::stod(word.substr(1));
    if (word[0] != 'Z') continue;
    z = std::stod(word.substr(1));
    if (z > -0.5 * made->path.deepest_mm) continue;
    const double upper = 6 + (1 - 30.0 / 109) * 60;
    const double lower = 6 + (1 - 74.0 / 109) * 60;
    EXPECT_LE(std::min(std::abs(y - upper), std::abs(y - lower)), 1.5);
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
  }
  EXPECT_NEAR(low_x, 6 + 10.0 / 109 * 60, 3);
  EXPECT_NEAR(high_x, 6 + 100.0 / 109 * 60, 3);
}

TEST(TouchFile, AReliefWithoutLinesIsMilledToo) {
  SolidTablet relief{{}, surface::HeightMap::create(65).value()};
  for (int column = 20; column < 45; ++column)
    for (int row = 28; row < 37; ++row) relief.relief->set(column, row, 0.0F);
  const auto made = mill_file({&relief, 1}, grooved(40), {}, "relief");
  ASSERT_TRUE(made) << base::to_line(made.error());
  EXPECT_NEAR(made->path.deepest_mm, 3, 0.05);
}

TEST(TouchFile, ALaserDrawingHasTheSizeOfThePlate) {
  const SolidTablet tablet = two_bars();
  const auto made = laser_file({&tablet, 1}, grooved(60), 5, "二");
  ASSERT_TRUE(made);
  EXPECT_THAT(made->content, HasSubstr("<title>二</title>"));
  EXPECT_THAT(made->content, HasSubstr("id=\"layer-5\""));
  EXPECT_THAT(made->content, testing::Not(HasSubstr("id=\"layer-6\"")));
  EXPECT_THAT(made->content, HasSubstr("<circle"));  // the hole to hang it up
}

TEST(TouchFile, RaisedLinesAndMouldsAreNotCut) {
  const SolidTablet tablet = two_bars();
  SolidSettings settings = grooved(60);
  settings.raised = true;
  EXPECT_FALSE(mill_file({&tablet, 1}, settings, {}, "a"));
  EXPECT_FALSE(laser_file({&tablet, 1}, settings, 5, "a"));
  settings = grooved(60);
  settings.mould = true;
  EXPECT_FALSE(mill_file({&tablet, 1}, settings, {}, "a"));
}

TEST(BrailleLabel, SaysMeaningsStrokesAndReadings) {
  EXPECT_THAT(cells_of_label(rest()),
              ElementsAre(U"⠗⠑⠎⠞⠀⠀⠙⠁⠽⠀⠕⠋⠋",    // a meaning with brackets has no cells here
                          U"⠼⠋⠡⠩",             // 6かく
                          U"⠊⠴⠀⠀⠈⠩⠒",          // おん きゅー
                          U"⠩⠴⠀⠀⠌⠹⠽⠀⠀⠌⠹⠵⠙"));  // くん やすむ やすまる, each once
}

TEST(BrailleLabel, OfAKanaIsTheKana) {
  kanji::Character character;
  character.code_point = U'か';
  character.strokes.resize(3);
  EXPECT_THAT(cells_of_label(character), ElementsAre(U"⠡", U"⠼⠉⠡⠩"));
  EXPECT_THAT(cells_of_label(character, model::EnglishBraille::contracted), ElementsAre(U"⠡", U"⠼⠉⠡⠩"));
}

/// @source The Rules of Unified English Braille, 2013: st is dots 3 4, day is dots 5, 1 4 5, of is dots 1 2 3
/// 5 6, round brackets are dots 5, 1 2 6 and 5, 3 4 5.
TEST(BrailleLabel, ContractedHasFewerCellsAndBrackets) {
  const auto lines = cells_of_label(rest(), model::EnglishBraille::contracted);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], U"⠗⠑⠌⠀⠀⠐⠙⠀⠷⠋⠀⠀⠗⠑⠞⠊⠗⠑⠀⠐⠣⠋⠐⠜");
  EXPECT_EQ(lines[2], U"⠊⠴⠀⠀⠈⠩⠒");  // kana have no contractions
}

TEST(BrailleLabel, ThatIsTooLongIsAnError) {
  TouchLabel label;
  label.meanings = {"rest", std::string(model::kLongestBrailleText + 1, 'a')};
  EXPECT_FALSE(braille_lines(label));
  const LabelledTablet tablet{two_bars(), label};
  EXPECT_FALSE(swell_file({&tablet, 1}, {}, "a"));
  EXPECT_FALSE(embosser_file({&tablet, 1}));
  SwellSettings bare;
  bare.label = false;
  EXPECT_TRUE(swell_file({&tablet, 1}, bare, "a"));
}

TEST(SwellPaper, HasAPageForEachTabletAndSaysHowCloseLinesAre) {
  const std::vector<LabelledTablet> tablets{{two_bars(), touch_label(rest())}, {two_bars(), {}}};
  SwellSettings settings;
  settings.side_mm = 109;
  const auto made = swell_file(tablets, settings, "二");
  ASSERT_TRUE(made) << base::to_line(made.error());
  EXPECT_EQ(made->pages, 2);
  EXPECT_THAT(made->content, HasSubstr("/Count 2"));
  EXPECT_TRUE(made->content.starts_with("%PDF-1.5"));
  EXPECT_NEAR(made->closest_mm, 44, 0.1);
  EXPECT_THAT(made->without_number, IsEmpty());
  EXPECT_EQ(made->width_mm, 210);
  settings.paper = print::Paper::letter;
  EXPECT_NEAR(swell_file(tablets, settings, "二")->height_mm, 279.4, 0.01);
}

TEST(SwellPaper, WhatDoesNotFitOnThePaperIsRefused) {
  const LabelledTablet tablet{two_bars(), {}};
  SwellSettings settings;
  settings.side_mm = 186;
  EXPECT_TRUE(swell_file({&tablet, 1}, settings, "a"));
  settings.side_mm = 187;
  EXPECT_FALSE(swell_file({&tablet, 1}, settings, "a"));
  settings.side_mm = 170;
  settings.paper = print::Paper::b5;
  EXPECT_FALSE(swell_file({&tablet, 1}, settings, "a"));
  EXPECT_FALSE(swell_file({}, {}, "a"));
  const LabelledTablet empty{};
  EXPECT_FALSE(swell_file({&empty, 1}, {}, "a"));
}

TEST(Embossing, HasAPageForEachTablet) {
  const std::vector<LabelledTablet> tablets{{two_bars(), touch_label(rest())}, {two_bars(), {}}};
  const auto made = embosser_file(tablets);
  ASSERT_TRUE(made);
  EXPECT_EQ(std::count(made->content.begin(), made->content.end(), '\f'), 2);
  EXPECT_THAT(made->content, HasSubstr("\r\nREST  DAY OFF\r\n#F*%\r\n"));
  EXPECT_THAT(embosser_file(tablets, {{}, {}, true, model::EnglishBraille::contracted})->content,
              HasSubstr("\r\nRE/  \"D (F  RETIRE \"<F\">\r\n#F*%\r\n"));
  EXPECT_THAT(embosser_file(tablets, {{}, {}, false})->content, testing::Not(HasSubstr("#F*%")));
  EXPECT_EQ(made->width_mm, 236.5);
  EXPECT_EQ(made->height_mm, 245);
  EXPECT_FALSE(embosser_file({}));
  const LabelledTablet empty{};
  EXPECT_FALSE(embosser_file({&empty, 1}));
}

TEST(TouchFiles, AreOfTheKindThatTheirNameTells) {
  EXPECT_EQ(touch_kind_of("a/休.nc"), TouchKind::mill);
  EXPECT_EQ(touch_kind_of("休.SVG"), TouchKind::laser);
  EXPECT_EQ(touch_kind_of("pdf.Pdf"), TouchKind::swell_paper);
  EXPECT_EQ(touch_kind_of("x.stl.brf"), TouchKind::embosser);
  for (const char* name : {"休", "a.stl", "a.3mf", ".nc", "a.ncx", "nc"})
    EXPECT_EQ(touch_kind_of(name), std::nullopt) << name;
}

TEST(TouchFiles, OfEveryKindHaveTheSizeAndTheMarksOfTheSettings) {
  const LabelledTablet one{two_bars(), {{"rest"}, {{1, 2}}}};
  SolidSettings settings;  // raised: machines that cut make grooves all the same
  settings.mould = true;
  settings.plate.side_mm = 60;
  TouchMachines machines;
  const auto made = [&](TouchKind kind) {
    const auto file = touch_file(kind, {&one, 1}, settings, machines, "二");
    EXPECT_TRUE(file) << base::to_line(file.error());
    return file.value_or(TouchFile{});
  };
  const auto same = [](const TouchFile& a, const base::Result<TouchFile>& b) {
    ASSERT_TRUE(b);
    EXPECT_EQ(a.kind, b->kind);
    EXPECT_EQ(a.content, b->content);
  };
  const SolidTablet bare = two_bars();
  same(made(TouchKind::mill), mill_file({&bare, 1}, grooved(60), {}, "二"));
  same(made(TouchKind::laser), laser_file({&bare, 1}, grooved(60), 10, "二"));
  same(made(TouchKind::swell_paper), swell_file({&one, 1}, {60, print::Paper::a4, true, true, true}, "二"));
  same(made(TouchKind::embosser), embosser_file({&one, 1}));
  settings.plate.strokes.numbers = settings.plate.strokes.start_dots = false;
  same(made(TouchKind::swell_paper), swell_file({&one, 1}, {60, print::Paper::a4, false, false, true}, "二"));
  same(made(TouchKind::embosser), embosser_file({&one, 1}, {{}, {false, false}}));
  settings.plate.strokes.numbers = true;
  same(made(TouchKind::embosser), embosser_file({&one, 1}, {{}, {true, false}}));
  // Machines as they were chosen.
  machines.mill.cutter_mm = 2;
  machines.layers = 4;
  machines.paper = print::Paper::letter;
  machines.embosser = {30, 20};
  machines.english = model::EnglishBraille::contracted;
  model::MillSettings fine;
  fine.cutter_mm = 2;
  constexpr auto kContracted = model::EnglishBraille::contracted;
  same(made(TouchKind::mill), mill_file({&bare, 1}, grooved(60), fine, "二"));
  same(made(TouchKind::laser), laser_file({&bare, 1}, grooved(60), 4, "二"));
  same(made(TouchKind::swell_paper),
       swell_file({&one, 1}, {60, print::Paper::letter, false, true, true, kContracted}, "二"));
  same(made(TouchKind::embosser), embosser_file({&one, 1}, {{30, 20}, {true, false}, true, kContracted}));
}

}  // namespace
}  // namespace nazori::practice
