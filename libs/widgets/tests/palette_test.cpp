// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/palette.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <cmath>

#include "nazori/widgets/look/resources.h"
#include "nazori/widgets/look/style_sheet.h"

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

TEST_P(PaletteColours, TheArrowsOfTheStyleSheetAreInTheColourOfSecondRank) {
  // A style sheet cannot give its pictures a colour.
  for (const char* arrow : {"down", "up"}) {
    const auto file =
        QStringLiteral("%1-%2.svg")
            .arg(QLatin1String(arrow), GetParam() ? QStringLiteral("dark") : QStringLiteral("light"));
    EXPECT_TRUE(style_sheet(colours()).contains(QStringLiteral(":/nazori/") + file)) << arrow;
    EXPECT_TRUE(read_resource(file).contains(colours().muted.name().toLatin1())) << arrow;
  }
}

TEST_P(PaletteColours, EachRoleOfTheWindowHasItsColour) {
  const Colours& c = colours();
  const QPalette p = make_palette(c);
  const std::pair<QPalette::ColorRole, QColor> roles[] = {
      {QPalette::Window, c.paper},
      {QPalette::WindowText, c.ink},
      {QPalette::Base, c.surface},
      {QPalette::AlternateBase, c.paper},
      {QPalette::Text, c.ink},
      {QPalette::PlaceholderText, c.muted},
      {QPalette::Button, c.surface},
      {QPalette::ButtonText, c.ink},
      {QPalette::BrightText, c.vermilion},
      {QPalette::Highlight, c.indigo},
      {QPalette::HighlightedText, c.surface},
      {QPalette::Link, c.indigo},
      {QPalette::LinkVisited, c.indigo},
      {QPalette::ToolTipBase, c.surface},
      {QPalette::ToolTipText, c.ink},
      {QPalette::Light, c.surface},
      {QPalette::Mid, c.line},
  };
  for (const auto& [role, colour] : roles)
    EXPECT_EQ(p.color(QPalette::Active, role).name(), colour.name()) << role;
  // What can be chosen is read, and what cannot is paler than the text but still there.
  EXPECT_GE(contrast_ratio(p.color(QPalette::HighlightedText), p.color(QPalette::Highlight)), 4.5);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    const QColor off = p.color(QPalette::Disabled, role);
    EXPECT_LT(contrast_ratio(off, c.paper), contrast_ratio(c.muted, c.paper)) << role;
    EXPECT_GT(contrast_ratio(off, c.paper), 2) << role;
  }
  // Edges between the surface and muted widgets, one darker than the other.
  double before = contrast_ratio(c.surface, c.surface);
  for (const auto role : {QPalette::Midlight, QPalette::Mid, QPalette::Dark, QPalette::Shadow}) {
    const double now = contrast_ratio(p.color(role), c.surface);
    EXPECT_GT(now, before) << role;
    before = now;
  }
  EXPECT_LT(before, contrast_ratio(c.muted, c.surface));
}

TEST_P(PaletteColours, EdgesAndWhatIsOffAreMixedOfTwoColours) {
  const Colours& c = colours();
  const QPalette p = make_palette(c);
  /// To one of the 255 steps of a channel.
  const auto expect_between = [](const QColor& seen, const QColor& back, const QColor& front, double share) {
    for (const auto channel : {&QColor::red, &QColor::green, &QColor::blue})
      EXPECT_NEAR((seen.*channel)(), (1 - share) * (back.*channel)() + share * (front.*channel)(), 1);
  };
  expect_between(p.color(QPalette::Midlight), c.surface, c.line, 0.5);
  expect_between(p.color(QPalette::Dark), c.line, c.muted, 0.5);
  expect_between(p.color(QPalette::Shadow), c.line, c.muted, 0.8);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    expect_between(p.color(QPalette::Disabled, role), c.muted, c.paper, 0.35);
}

TEST(ColoursOfTheProgram, AreThoseOfTheApplicationsPalette) {
  const QPalette before = QGuiApplication::palette();
  for (const Colours* c : {&light_colours(), &dark_colours()}) {
    QGuiApplication::setPalette(make_palette(*c));
    EXPECT_EQ(&current_colours(), c);
  }
  QGuiApplication::setPalette(before);
  QPalette grey;
  grey.setColor(QPalette::WindowText, Qt::gray);
  grey.setColor(QPalette::Window, Qt::gray);
  EXPECT_FALSE(is_dark(grey)) << "neither: light";
}

TEST(BlendOfColours, GoesFromTheBackToTheFront) {
  const QColor back(10, 200, 90);
  const QColor front(110, 100, 190);
  EXPECT_EQ(blend(back, front, 0).name(), back.name());
  EXPECT_EQ(blend(back, front, 1).name(), front.name());
  EXPECT_EQ(blend(back, front, 0.25).name(), QColor(35, 175, 115).name());
}

TEST(ContrastRatio, KnowsTheWeightOfEachColour) {
  // WCAG: 1.05 / (weight + 0.05) against white, weights 0.2126, 0.7152 and 0.0722.
  EXPECT_NEAR(contrast_ratio(QColor(255, 0, 0), Qt::white), 1.05 / 0.2626, 1e-4);
  EXPECT_NEAR(contrast_ratio(QColor(0, 255, 0), Qt::white), 1.05 / 0.7652, 1e-4);
  EXPECT_NEAR(contrast_ratio(QColor(0, 0, 255), Qt::white), 1.05 / 0.1222, 1e-4);
  // A channel of 10 of 255 lies below the bend of the curve, where it is a straight line.
  EXPECT_NEAR(contrast_ratio(QColor(10, 10, 10), Qt::black), (10 / 255.0 / 12.92 + 0.05) / 0.05, 1e-4);
  // 11 of 255 lies just above it.
  for (const int channel : {11, 13, 14, 100, 200})
    EXPECT_NEAR(contrast_ratio(QColor(channel, channel, channel), Qt::black),
                (std::pow((channel / 255.0 + 0.055) / 1.055, 2.4) + 0.05) / 0.05, 1e-4)
        << channel;
}

TEST(ContrastRatio, BlackOnWhiteIs21AndAColourOnItselfIs1) {
  EXPECT_NEAR(contrast_ratio(Qt::black, Qt::white), 21.0, 1e-6);
  EXPECT_NEAR(contrast_ratio(Qt::red, Qt::red), 1.0, 1e-12);
  // A grey of 0x76 is the darkest-known borderline of 4.54 on white.
  EXPECT_NEAR(contrast_ratio(QColor(0x767676), Qt::white), 4.54, 0.01);
}

}  // namespace
