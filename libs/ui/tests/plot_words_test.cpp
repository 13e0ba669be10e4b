// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "functions/plot_export.h"

namespace nazori::ui {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(PlotWords, ASlopeIsSaidInFourDigitsAndWithItsSign) {
  EXPECT_EQ(slope_words(2), QStringLiteral("slope 2"));
  EXPECT_EQ(slope_words(-0.123456), QStringLiteral("slope minus 0.1235"));
  EXPECT_EQ(slope_words(1e-13), QStringLiteral("slope 0")) << "rounding, not a slope";
  EXPECT_EQ(slope_words(-1e-13), QStringLiteral("slope 0"));
  EXPECT_EQ(slope_words(1e-11), QStringLiteral("slope 1e-11"));
  EXPECT_EQ(slope_words(kInfinite), QStringLiteral("The curve is upright here."));
  EXPECT_EQ(slope_words(-kInfinite), QStringLiteral("The curve is upright here."));
}

TEST(PlotWords, AWindowIsSaidWithTheTicksOfEachAxis) {
  EXPECT_EQ(window_words({-6, 6, -40, 45}),
            QStringLiteral("x from minus 6 to 6, one tick is %1; y from minus 40 to 45, one tick is %2")
                .arg(functions::tick_step(-6, 6))
                .arg(functions::tick_step(-40, 45)));
  EXPECT_NE(functions::tick_step(-6, 6), functions::tick_step(-40, 45));
}

TEST(PlotWords, ACoordinateIsItsNameWithItsNumberWhereItHasOne) {
  EXPECT_EQ(coordinate_text(1.570796, "pi/2"), QStringLiteral("π/2 ≈ 1.571"));
  EXPECT_EQ(coordinate_text(1.414214, "sqrt(2)"), QStringLiteral("√(2) ≈ 1.414"));
  EXPECT_EQ(coordinate_text(6.283185, "2*pi"), QStringLiteral("2·π ≈ 6.283"));
  EXPECT_EQ(coordinate_text(-3, "-3"), QStringLiteral("-3")) << "nothing to approach";
  EXPECT_EQ(coordinate_text(0.5, "1/2"), QStringLiteral("1/2 ≈ 0.5"));
  EXPECT_EQ(coordinate_text(0.123456, ""), QStringLiteral("≈ 0.1235"));
  EXPECT_EQ(coordinate_text(-1e-13, ""), QStringLiteral("≈ 0"));
  EXPECT_EQ(coordinate_text(1e-11, ""), QStringLiteral("≈ 1e-11"));
  EXPECT_EQ(coordinate_text(std::nan(""), "pi"), no_coordinate());
}

TEST(PlotWords, ANumberHasAsManyDigitsAsAskedFor) {
  EXPECT_EQ(number_text(1.23456789), QStringLiteral("1.23457"));
  EXPECT_EQ(number_text(1.23456789, 3), QStringLiteral("1.23"));
  EXPECT_EQ(number_text(-2), QStringLiteral("-2"));
}

TEST(PlotWords, EachKindOfFileHasItsEndingAndItsFilter) {
  const std::pair<PlotFile, std::pair<const char*, const char*>> all[] = {
      {PlotFile::document, {"json", "Plots (*.json)"}},
      {PlotFile::raw, {"raw", "Height maps (*.raw)"}},
      {PlotFile::png, {"png", "Pictures (*.png)"}},
      {PlotFile::print, {"png", "Pictures (*.png)"}},
      {PlotFile::sound, {"wav", "Sounds (*.wav)"}}};
  for (const auto& [kind, words] : all) {
    EXPECT_EQ(PlotExport::suffix(kind), QString::fromLatin1(words.first));
    EXPECT_EQ(PlotExport::filter(kind), QString::fromLatin1(words.second));
  }
}

}  // namespace
}  // namespace nazori::ui
