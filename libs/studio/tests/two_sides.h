// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QDialog>
#include <QFontInfo>
#include <QScrollArea>
#include <QScrollBar>

namespace nazori::ui::test {

/// The preview of a dialog that is shown stands beside its options, and above them where there is less room.
inline void expect_preview_beside_options(QDialog& dialog) {
  auto& sides = *static_cast<QBoxLayout*>(dialog.layout()->itemAt(0)->layout());
  const int em = QFontInfo(dialog.font()).pixelSize();
  EXPECT_EQ(sides.spacing(), 12);
  EXPECT_EQ(sides.direction(), QBoxLayout::LeftToRight);
  dialog.resize(30 * em, 700);
  EXPECT_EQ(sides.direction(), QBoxLayout::LeftToRight);
  EXPECT_EQ(sides.stretch(0), 2);
  EXPECT_EQ(sides.stretch(1), 3);
  const auto& area = *dialog.findChild<QScrollArea*>();
  EXPECT_EQ(area.minimumWidth(),
            area.widget()->minimumSizeHint().width() + area.verticalScrollBar()->sizeHint().width());
  if (dialog.minimumSizeHint().width() >= 30 * em) return;
  dialog.resize(30 * em - 1, 700);
  EXPECT_EQ(sides.direction(), QBoxLayout::BottomToTop);
  EXPECT_EQ(sides.stretch(0), 3);
  EXPECT_EQ(sides.stretch(1), 2);
}

}  // namespace nazori::ui::test
