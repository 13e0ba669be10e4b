// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/touch_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "nazori/functions/plot.h"

namespace nazori::practice {
namespace {

using testing::HasSubstr;
using testing::Not;

struct PlotForFingers {
  functions::Plot plot;
  functions::Picture picture;
};

PlotForFingers plot_for_fingers(const std::string& expression,
                                const functions::Window& window = {-4, 4, -4, 4}) {
  functions::Plot plot = functions::parse(expression, {}).value();
  functions::PlateSettings settings;
  settings.size = 256;
  functions::Picture picture = functions::draw(plot, window, settings).value();
  return {std::move(plot), std::move(picture)};
}

base::Result<TouchFile> paper_file(const PlotForFingers& of, TouchKind kind, const PlotPaper& paper = {}) {
  return plot_touch_file(kind, of.plot, of.picture, paper);
}

std::vector<std::string> brf_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

// In ASCII braille -#D is -4, #J is 0, #D is 4.
TEST(PlotForAnEmbosser, HasTheNumbersOfTheAxesAndTheExpressionBelow) {
  const auto made = paper_file(plot_for_fingers("y = x"), TouchKind::embosser);
  ASSERT_TRUE(made) << base::to_line(made.error());
  EXPECT_EQ(made->kind, TouchKind::embosser);
  EXPECT_EQ(made->width_mm, 236.5);
  EXPECT_EQ(made->height_mm, 245);
  const auto lines = brf_lines(made->content);
  ASSERT_EQ(lines.size(), 26U);  // 25 and what follows the form feed
  EXPECT_THAT(lines[0], HasSubstr("Y"));
  EXPECT_THAT(lines[22], HasSubstr("-#D"));
  EXPECT_THAT(lines[22], HasSubstr("#J"));
  EXPECT_EQ(lines[23], "");
  // @source Unified English Braille, Guidelines for Technical Material, 2014: = is dots 5, 2 3 5 6; a
  // grade 1 passage is between dots 5 6 three times, and dots 5 6, 3.
  EXPECT_EQ(lines[24], ";;;Y \"7 X;'");
  EXPECT_EQ(lines[25], "\f");
}

TEST(PlotForAnEmbosser, ALineGoesFromCornerToCorner) {
  const auto made = paper_file(plot_for_fingers("y = x"), TouchKind::embosser);
  ASSERT_TRUE(made);
  const auto lines = brf_lines(made->content);
  // Left of the square are four cells for -#D and an empty one; the lowest dot of y = -4 is dot 3, dot 1 2 3
  // and dot 6 of the first cell tell its edge.
  EXPECT_TRUE(lines[21].starts_with("-#D ")) << lines[21];
  EXPECT_NE(lines[21][4], ' ');
  const std::size_t right = lines[1].find_last_not_of(' ');
  EXPECT_GE(right, 36U) << lines[1];
}

TEST(PlotForAnEmbosser, TakesTheCodeAndThePaperThatWereChosen) {
  PlotPaper paper;
  paper.code = functions::BrailleCode::nemeth;
  paper.embosser = {30, 20};
  const auto made = paper_file(plot_for_fingers("y = x/2"), TouchKind::embosser, paper);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->width_mm, model::dot_x_mm(59));
  EXPECT_EQ(made->height_mm, model::dot_y_mm(59));
  const auto lines = brf_lines(made->content);
  ASSERT_EQ(lines.size(), 21U);
  // @source The Nemeth Braille Code, 1972: = is dots 4 6, 1 3.
  EXPECT_THAT(lines[19], HasSubstr(".K"));
}

TEST(PlotOnSwellPaper, IsAPageOfThePaper) {
  PlotPaper paper;
  paper.paper = print::Paper::letter;
  const auto made = paper_file(plot_for_fingers("y = x"), TouchKind::swell_paper, paper);
  ASSERT_TRUE(made) << base::to_line(made.error());
  EXPECT_EQ(made->kind, TouchKind::swell_paper);
  EXPECT_TRUE(made->content.starts_with("%PDF-1.5"));
  EXPECT_NEAR(made->width_mm, 215.9, 0.01);
  EXPECT_NEAR(made->height_mm, 279.4, 0.01);
  EXPECT_EQ(made->pages, 1);
  EXPECT_EQ(made->closest_mm, 0);  // one curve has no neighbour
}

TEST(PlotOnSwellPaper, SaysHowCloseCurvesAre) {
  // One unit is 15 mm; parallels one unit apart in y are 15 / sqrt(2) mm apart.
  const auto made = paper_file(plot_for_fingers("y = x; y = x + 1"), TouchKind::swell_paper);
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->closest_mm, 15 / std::sqrt(2.0), 0.1);
}

TEST(PlotOnSwellPaper, CurvesThatCrossAreNotCalledTooClose) {
  const auto made = paper_file(plot_for_fingers("y = x; y = 0.9 x"), TouchKind::swell_paper);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->closest_mm, 0);
}

TEST(PlotOnSwellPaper, CurvesAndAxesHaveTheirWidthAndAxesStandClearOfCurves) {
  const auto made = paper_file(plot_for_fingers("y = x"), TouchKind::swell_paper);
  ASSERT_TRUE(made);
  // As poppler paints it, 10 dots a millimetre.
  const std::string name = testing::TempDir() + "/swell-plot";
  std::ofstream(name + ".pdf", std::ios::binary) << made->content;
  ASSERT_EQ(std::system(("pdftoppm -gray -r 254 -singlefile '" + name + ".pdf' '" + name + "'").c_str()), 0);
  std::ifstream in(name + ".pgm", std::ios::binary);
  std::string magic;
  std::size_t width = 0;
  std::size_t height = 0;
  int most = 0;
  in >> magic >> width >> height >> most;
  in.get();
  const std::string grey{std::istreambuf_iterator<char>(in), {}};
  ASSERT_EQ(grey.size(), width * height);
  // The page is 210 mm wide. From the left the plot has numbers (27.75 mm), 6.4 mm, the square (120 mm), 6.4
  // mm and a letter (6.25 mm); from the top, below the margin of 12 mm, a letter, 6.4 mm and the square.
  const double middle_x = 105 + (27.75 - 6.25) / 2;
  const double middle_y = 12 + 6.25 + 6.4 + 60;
  const auto is_black = [&](double right, double up) {
    const auto x = static_cast<std::size_t>((middle_x + right) * 10);
    const auto y = static_cast<std::size_t>((middle_y - up) * 10);
    return static_cast<unsigned char>(grey.at(y * width + x)) < 128;
  };
  const double across = std::sqrt(0.5);  // of a step at right angles to the curve
  EXPECT_TRUE(is_black(25, 25));
  EXPECT_TRUE(is_black(25 - 0.7 * across, 25 + 0.7 * across));
  EXPECT_FALSE(is_black(25 - 0.95 * across, 25 + 0.95 * across));
  EXPECT_TRUE(is_black(25, 0));
  EXPECT_TRUE(is_black(25, 0.4));
  EXPECT_FALSE(is_black(25, 0.65));
  // An axis ends where it would be nearer than 2 mm to the curve, 0.8 + 2 mm from its middle.
  EXPECT_FALSE(is_black(1.8, 0));
  EXPECT_FALSE(is_black(3.7, 0));
  EXPECT_TRUE(is_black(4.2, 0));
  EXPECT_TRUE(is_black(0, 0));
}

TEST(PlotOnSwellPaper, ASquareThatDoesNotFitIsRefused) {
  const PlotForFingers line = plot_for_fingers("y = x");
  PlotPaper paper;
  // On A4: 210 mm less two margins of 12 mm, less the numbers (27.75 mm) and the letter (6.25 mm), each 6.4
  // mm clear.
  paper.side_mm = 139;
  EXPECT_TRUE(paper_file(line, TouchKind::swell_paper, paper));
  paper.side_mm = 140;
  const auto refused = paper_file(line, TouchKind::swell_paper, paper);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().remedy, HasSubstr("40 to 139 mm"));
  paper.side_mm = 39;
  EXPECT_FALSE(paper_file(line, TouchKind::swell_paper, paper));
}

TEST(PlotsOnPaper, AreOfCurvesAndNotCut) {
  const PlotForFingers surface = plot_for_fingers("z = x y");
  EXPECT_FALSE(paper_file(surface, TouchKind::swell_paper));
  EXPECT_FALSE(paper_file(surface, TouchKind::embosser));
  const PlotForFingers line = plot_for_fingers("y = x");
  EXPECT_FALSE(paper_file(line, TouchKind::mill));
  EXPECT_FALSE(paper_file(line, TouchKind::laser));
}

}  // namespace
}  // namespace nazori::practice
