// SPDX-License-Identifier: Apache-2.0
#include "window/page_rail.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QToolButton>

namespace nazori::ui {
namespace {

TEST(PageRail, ShowsWordsOnlyInAWideWindow) {
  QAction one(QStringLiteral("One"));
  one.setObjectName(QStringLiteral("go_one"));
  one.setStatusTip(QStringLiteral("The first"));
  PageRail rail({&one}, nullptr);
  const auto* button = rail.findChild<QToolButton*>(QStringLiteral("rail_go_one"));
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->accessibleName(), QStringLiteral("One"));
  EXPECT_EQ(button->accessibleDescription(), QStringLiteral("The first"));
  EXPECT_TRUE(button->focusPolicy() & Qt::TabFocus);
  QFont font;
  font.setPixelSize(10);
  rail.setFont(font);
  rail.fit(720);
  EXPECT_EQ(rail.toolButtonStyle(), Qt::ToolButtonTextUnderIcon);
  rail.fit(719);
  EXPECT_EQ(rail.toolButtonStyle(), Qt::ToolButtonIconOnly);
  rail.fit(720);
  font.setPixelSize(11);
  rail.setFont(font);
  EXPECT_EQ(rail.toolButtonStyle(), Qt::ToolButtonIconOnly) << "larger letters need a wider window";
}

}  // namespace
}  // namespace nazori::ui
