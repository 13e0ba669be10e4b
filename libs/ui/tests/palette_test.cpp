// SPDX-License-Identifier: Apache-2.0
#include "palette.h"

#include <gtest/gtest.h>

#include "style_sheet.h"

namespace {

using namespace nazori::ui;

class PaletteColours : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] const Colours& colours() const { return GetParam() ? dark_colours() : light_colours(); }
};

INSTANTIATE_TEST_SUITE_P(LightAndDark, PaletteColours, testing::Values(false, true),
                         [](const auto& which) { return which.param ? "Dark" : "Light"; });

TEST_P(PaletteColours, EveryColourOfTextIsLegibleOnPaperAndOnSurface) {
  const Colours& c = colours();
  for (const auto& text : {c.ink, c.muted, c.vermilion, c.indigo, c.moss, c.amber}) {
    EXPECT_GE(contrast_ratio(text, c.paper), 4.5) << text.name().toStdString();
    EXPECT_GE(contrast_ratio(text, c.surface), 4.5) << text.name().toStdString();
  }
}

TEST_P(PaletteColours, ThePaletteIsRecognisedAsLightOrDark) {
  EXPECT_EQ(is_dark(make_palette(colours())), GetParam());
}

TEST_P(PaletteColours, TheStyleSheetNamesNoColourThatIsMissing) {
  EXPECT_FALSE(style_sheet(colours()).contains(QLatin1Char('@')));
}

TEST(ContrastRatio, BlackOnWhiteIs21AndAColourOnItselfIs1) {
  EXPECT_NEAR(contrast_ratio(Qt::black, Qt::white), 21.0, 1e-6);
  EXPECT_NEAR(contrast_ratio(Qt::red, Qt::red), 1.0, 1e-12);
  // A grey of 0x76 is the darkest-known borderline of 4.54 on white.
  EXPECT_NEAR(contrast_ratio(QColor(0x767676), Qt::white), 4.54, 0.01);
}

}  // namespace
