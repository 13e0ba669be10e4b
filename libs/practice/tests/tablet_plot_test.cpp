// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_plot.h"

#include <gtest/gtest.h>

namespace nazori::practice {
namespace {

base::Result<TabletPlot> drawn(const std::string& expression) {
  functions::PlotRequest request;
  request.plot = *functions::parse(expression);
  request.window = {-3, 3, -3, 3};
  request.plate.size = 128;
  base::Result<TabletPlot> last = base::fail(base::Errc::bad_argument, "nothing was drawn", expression);
  const auto done = functions::draw_plot(request, [&](functions::Drawing&& drawing) {
    last = on_tablet(std::move(drawing));
    return true;
  });
  EXPECT_TRUE(done);
  return last;
}

TEST(TabletPlots, HaveAStrokeForEachGrooveThatLiesInIt) {
  const auto plot = drawn("y = 1/x; y = 2");
  ASSERT_TRUE(plot);
  const auto& grooves = plot->drawing->grooves;
  ASSERT_EQ(grooves.size(), 3U);
  const auto& paths = plot->tablet->paths();
  ASSERT_EQ(paths.size(), grooves.size());
  for (std::size_t i = 0; i < grooves.size(); ++i) {
    EXPECT_NEAR(paths[i].points.front().x, grooves[i].points.front().x, 1e-9);
    EXPECT_NEAR(paths[i].points.front().y, grooves[i].points.front().y, 1e-9);
    EXPECT_NEAR(paths[i].points.back().x, grooves[i].points.back().x, 1e-9);
    EXPECT_NEAR(paths[i].points.back().y, grooves[i].points.back().y, 1e-9);
  }
  EXPECT_EQ(plot->tablet->height_map().size(), plot->drawing->picture.plate.heights.size());
}

TEST(TabletPlots, HaveTheFrictionOfTheDrawing) {
  const auto plot = drawn("z = sqrt(x)");
  ASSERT_TRUE(plot);
  const auto& zones = plot->tablet->friction();
  ASSERT_TRUE(zones);
  EXPECT_EQ(zones->size, plot->drawing->picture.plate.heights.size());
  EXPECT_EQ(zones->zone, plot->drawing->friction.zone);
  EXPECT_EQ(zones->added, plot->drawing->friction.added);
  EXPECT_EQ(plot->tablet->lines().size(), 0U) << "a surface has no grooves";
}

}  // namespace
}  // namespace nazori::practice
