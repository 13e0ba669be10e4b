// SPDX-License-Identifier: Apache-2.0
// Drawings for a laser cutter of plates with a few samples, by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nazori/geometry/polyline.h"
#include "nazori/model/laser.h"

namespace nazori::model {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// A plate of 4 x 4 mm whose samples are a millimetre apart, with one that is lower.
Plate pit(double depth_mm, double step_mm = 1) {
  Plate plate = Plate::create(4 * step_mm, 4 * step_mm, step_mm, 5).value();
  auto map = surface::HeightMap::create(5, 1.0F).value();
  map.set(2, 1, 0.0F);
  plate.sink(map, {0, 0}, 4 * step_mm, depth_mm);
  return plate;
}

TEST(LaserDrawing, OfAPitIsADiamondInEachLayer) {
  Plate plate = pit(2);
  // The contours of 0.5 and 1.5 mm are 0.75 and 0.25 mm around the sample, seen with y down.
  EXPECT_EQ(to_laser_svg(plate, 2, "a\tb \x1f<&>").value(),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" "
            "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"4.000mm\" "
            "height=\"4.000mm\" viewBox=\"0 0 4.000 4.000\">\n"
            "<title>ab &lt;&amp;></title>\n"
            "<desc>Depth 2.000 mm in 2 layers of 1.0000 mm, dark is deep. Red: cut through.</desc>\n"
            "<g id=\"layer-1\" inkscape:groupmode=\"layer\" inkscape:label=\"depth 1.000 mm\" "
            "fill=\"#808080\" fill-rule=\"evenodd\">\n"
            "<path d=\"M1.250 1.000L2.000 1.750L2.750 1.000L2.000 0.250Z\"/>\n</g>\n"
            "<g id=\"layer-2\" inkscape:groupmode=\"layer\" inkscape:label=\"depth 2.000 mm\" "
            "fill=\"#000000\" fill-rule=\"evenodd\">\n"
            "<path d=\"M1.750 1.000L2.000 1.250L2.250 1.000L2.000 0.750Z\"/>\n</g>\n"
            "<g id=\"cut\" inkscape:groupmode=\"layer\" inkscape:label=\"cut\" fill=\"none\" "
            "stroke=\"#ff0000\" stroke-width=\"0.1\">\n"
            "<rect x=\"0\" y=\"0\" width=\"4.000\" height=\"4.000\"/>\n</g>\n</svg>\n");
}

TEST(LaserDrawing, HasNoLoopThatIsSmallerThanAHundredthOfAMillimetre) {
  // In the last of 64 layers the diamond is two thousandths wide.
  const std::string svg = to_laser_svg(pit(2, 0.25), 64, "a").value();
  EXPECT_THAT(svg, HasSubstr("fill=\"#000000\" fill-rule=\"evenodd\">\n<path d=\"\"/>"));
  EXPECT_THAT(svg, HasSubstr("id=\"layer-58\""));
  EXPECT_THAT(svg.substr(svg.find("id=\"layer-58\""), 200), HasSubstr("<path d=\"M"));
}

TEST(LaserDrawing, NeedsAGrooveOfAHundredthOfAMillimetre) {
  EXPECT_FALSE(to_laser_svg(pit(0.0098), 1, "a"));
  EXPECT_TRUE(to_laser_svg(pit(0.0102), 1, "a"));
}

TEST(LaserDrawing, ANumberOfLayersOutOfRangeIsNamed) {
  for (const int wrong : {0, 65, -3}) {
    const auto made = to_laser_svg(pit(2), wrong, "a");
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().what, std::to_string(wrong) + " layers are not possible");
    EXPECT_EQ(made.error().remedy, "give 1 to 64");
  }
}

TEST(LaserDrawing, HolesAreCutWhereTheyAre) {
  Plate plate = Plate::create(20, 12, 0.25, 5).value();
  auto map = surface::HeightMap::create(5, 1.0F).value();
  map.set(2, 2, 0.0F);
  plate.sink(map, {0, 0}, 4, 1);
  ASSERT_TRUE(plate.add_hole({{14, 5}, 2.25}));
  ASSERT_TRUE(plate.add_hole({{7, 8}, 2}));
  EXPECT_THAT(to_laser_svg(plate, 1, "a").value(),
              HasSubstr("<circle cx=\"14.000\" cy=\"7.000\" r=\"2.250\"/>\n"
                        "<circle cx=\"7.000\" cy=\"4.000\" r=\"2.000\"/>\n</g>"));
}

TEST(LaserDrawing, ALineHasOnlyThePointsThatItNeeds) {
  // A level pool of 6 x 4 mm: its sides need their ends alone.
  Plate plate = Plate::create(12, 12, 0.5, 5).value();
  auto map = surface::HeightMap::create(25, 1.0F).value();
  for (int row = 8; row <= 16; ++row)
    for (int column = 6; column <= 18; ++column) map.set(column, row, 0.0F);
  plate.sink(map, {0, 0}, 12, 2);
  const std::string svg = to_laser_svg(plate, 1, "a").value();
  const auto path = svg.substr(svg.find("d=\"M"), svg.find("Z\"/>") - svg.find("d=\"M"));
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 7) << path << ": eight corners, two at each";
}

TEST(Contours, OfAPlateThatIsLowEverywhereAreItsRim) {
  const Plate plate = Plate::create(3, 2, 0.5, 5).value();
  const auto loops = contours(plate, 6);
  ASSERT_THAT(loops, SizeIs(1));
  double area = 0;
  for (std::size_t i = 0; i < loops[0].size(); ++i) {
    const PlatePoint a = loops[0][i];
    const PlatePoint b = loops[0][(i + 1) % loops[0].size()];
    area += (a.x * b.y - b.x * a.y) / 2;
    EXPECT_TRUE(a.x == 0 || a.x == 3 || a.y == 0 || a.y == 2);
  }
  EXPECT_NEAR(area, 6, 1e-12);
  EXPECT_THAT(contours(plate, 4), SizeIs(0));
  EXPECT_THAT(contours(plate, 5), SizeIs(0)) << "what is as high as the level is not low";
}

TEST(Contours, TwoPitsThatMeetAtACornerAreTwoLoopsOrOne) {
  // The middle of the cell between them lies half way between its corners.
  for (const bool rising : {false, true})
    for (const double level : {3.9, 4.1}) {
      Plate plate = Plate::create(5, 5, 1, 5).value();
      auto map = surface::HeightMap::create(6, 1.0F).value();
      map.set(2, rising ? 3 : 2, 0.0F);
      map.set(3, rising ? 2 : 3, 0.0F);
      plate.sink(map, {0, 0}, 5, 2);
      EXPECT_THAT(contours(plate, level), SizeIs(level < 4 ? 2 : 1)) << rising << level;
    }
}

}  // namespace
}  // namespace nazori::model
