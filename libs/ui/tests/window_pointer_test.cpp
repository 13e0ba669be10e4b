// SPDX-License-Identifier: Apache-2.0
// What a double click makes in the workshop, by the tool that is chosen.
#include "workshop_window.h"

namespace nazori::ui {
namespace {

TEST_F(WorkshopWindow, ADoubleClickEndsAStrokeOfPlacedPointsAndAddsAPointToOneThatIsThere) {
  const auto double_click = [this](geometry::GlyphPoint at) {
    send(QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton);
  };
  press(Qt::Key_2);  // place points
  click({20, 40});
  click({80, 40});
  EXPECT_TRUE(character().strokes.empty());
  double_click({80, 40});
  ASSERT_EQ(character().strokes.size(), 1U);
  const auto points = character().strokes[0].points.size();
  double_click({50, 40});
  EXPECT_EQ(character().strokes[0].points.size(), points) << "there is nothing to end";
  press(Qt::Key_1);  // draw
  double_click({50, 40});
  EXPECT_EQ(character().strokes[0].points.size(), points);
  press(Qt::Key_3);  // edit
  double_click({50, 40});
  EXPECT_EQ(character().strokes[0].points.size(), points + 1);
}

}  // namespace
}  // namespace nazori::ui
