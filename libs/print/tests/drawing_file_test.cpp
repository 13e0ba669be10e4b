// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/drawing_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace nazori::print {
namespace {

using Kind = PathStep::Kind;
using testing::HasSubstr;

/// The pages as poppler paints them at 254 dots an inch, 10 a millimetre: binary PGM.
struct Painted {
  int width = 0;
  int height = 0;
  std::string grey;
  [[nodiscard]] int at(double x_mm, double y_mm) const {
    const auto i = static_cast<std::size_t>(y_mm * 10) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x_mm * 10);
    return static_cast<unsigned char>(grey.at(i));
  }
};

Painted painted(const std::string& pdf, int page) {
  const std::string name = testing::TempDir() + "/drawing-" + std::to_string(page);
  std::ofstream(name + ".pdf", std::ios::binary) << pdf;
  const std::string command =
      "pdftoppm -gray -r 254 -f " + std::to_string(page) + " -singlefile '" + name + ".pdf' '" + name + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(name + ".pgm", std::ios::binary);
  Painted made;
  std::string magic;
  int most = 0;
  in >> magic >> made.width >> made.height >> most;
  in.get();
  made.grey = {std::istreambuf_iterator<char>(in), {}};
  return made;
}

TEST(DrawingFile, LinesAndAreasHaveTheirPlaceAndWidthOnPaper) {
  PageDrawing page{60, 40, {}, {}};
  PageMark line;
  line.path = {{Kind::move, {PaperPoint{10, 10}}}, {Kind::line, {PaperPoint{50, 10}}}};
  line.width_mm = 2;
  page.marks.push_back(line);
  line.round = true;
  line.path = {{Kind::move, {PaperPoint{20, 20}}}, {Kind::line, {PaperPoint{40, 20}}}};
  page.marks.push_back(line);
  PageMark area;
  area.filled = true;
  area.grey = 0.5;
  area.path = {{Kind::move, {PaperPoint{10, 25}}},
               {Kind::line, {PaperPoint{20, 25}}},
               {Kind::curve, {PaperPoint{20, 30}, PaperPoint{20, 35}, PaperPoint{10, 35}}},
               {Kind::close, {}}};
  page.marks.push_back(area);
  const Painted made = painted(drawing_pdf({&page, 1}, "a"), 1);
  EXPECT_NEAR(made.width, 600, 1);
  EXPECT_NEAR(made.height, 400, 1);
  EXPECT_EQ(made.at(30, 10), 0);
  EXPECT_EQ(made.at(30, 9.2), 0);
  EXPECT_EQ(made.at(30, 10.8), 0);
  EXPECT_EQ(made.at(30, 8.7), 255);
  EXPECT_EQ(made.at(30, 11.3), 255);
  EXPECT_EQ(made.at(9.6, 10), 255);  // a line ends where it is told to
  EXPECT_EQ(made.at(19.4, 20), 0);   // a round end goes beyond
  EXPECT_EQ(made.at(18.7, 20), 255);
  EXPECT_NEAR(made.at(15, 30), 128, 2);
  EXPECT_EQ(made.at(19.8, 34.5), 255);  // beyond the curve
}

TEST(DrawingFile, PagesKeepTheirOrderAndSize) {
  std::array<PageDrawing, 2> pages{PageDrawing{60, 40, {}, {}}, PageDrawing{30, 50, {}, {}}};
  PageMark dot;
  dot.filled = true;
  dot.path = {{Kind::move, {PaperPoint{5, 5}}},
              {Kind::line, {PaperPoint{9, 5}}},
              {Kind::line, {PaperPoint{9, 9}}},
              {Kind::line, {PaperPoint{5, 9}}},
              {Kind::close, {}}};
  pages[1].marks.push_back(dot);
  const std::string pdf = drawing_pdf(pages, "休");
  EXPECT_EQ(painted(pdf, 1).at(7, 7), 255);
  const Painted second = painted(pdf, 2);
  EXPECT_NEAR(second.width, 300, 1);
  EXPECT_NEAR(second.height, 500, 1);
  EXPECT_EQ(second.at(7, 7), 0);
  EXPECT_THAT(pdf, HasSubstr("/Title <FEFF4F11>"));
  EXPECT_EQ(pdf, drawing_pdf(pages, "休"));
}

}  // namespace
}  // namespace nazori::print
