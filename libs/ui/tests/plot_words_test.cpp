// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace nazori::ui {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(PlotWords, ASlopeIsSaidInFourDigitsAndWithItsSign) {
  EXPECT_EQ(slope_words(2), QStringLiteral("slope 2"));
  EXPECT_EQ(slope_words(-0.123456), QStringLiteral("slope minus 0.1235"));
  EXPECT_EQ(slope_words(1e-13), QStringLiteral("slope 0")) << "rounding, not a slope";
  EXPECT_EQ(slope_words(-1e-13), QStringLiteral("slope 0"));
  EXPECT_EQ(slope_words(1e-11), QStringLiteral("slope 1e-11"));
  EXPECT_EQ(slope_words(kInfinite), QStringLiteral("The curve is vertical here."));
  EXPECT_EQ(slope_words(-kInfinite), QStringLiteral("The curve is vertical here."));
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

TEST(PlotWords, EachKindOfFileHasItsFilter) {
  const std::pair<functions::PlotFile, const char*> all[] = {
      {functions::PlotFile::document, "Plots (*.json)"},
      {functions::PlotFile::raw, "Height maps (*.raw)"},
      {functions::PlotFile::png, "Pictures (*.png)"},
      {functions::PlotFile::print, "Pictures (*.png)"},
      {functions::PlotFile::sound, "Sounds (*.wav)"}};
  for (const auto& [kind, words] : all) {
    EXPECT_EQ(file_filter(kind), QString::fromLatin1(words));
    const auto extension = functions::extension_of(kind);
    EXPECT_TRUE(file_filter(kind).contains(QStringLiteral("*.%1)").arg(
        QString::fromLatin1(extension.data(), static_cast<qsizetype>(extension.size())))));
  }
}

TEST(PlotWords, EveryEventHasASentence) {
  using Kind = functions::PlotEventKind;
  const functions::Plot plot = *functions::parse("y = x; y = 2");
  functions::PlotEvent event;
  event.location = functions::PlotLocation{{0.5, 0.5}, 1, -2, 0, {}};
  event.statement = 1;
  event.number = 3;
  event.count = 7;
  event.slope = 0.5;
  event.window = {-6, 6, -4, 4};
  const auto words = [&](Kind kind) {
    event.kind = kind;
    return event_words(event, plot);
  };
  EXPECT_EQ(words(Kind::here), QStringLiteral("x = 1; y = minus 2."));
  EXPECT_EQ(words(Kind::next_branch), QStringLiteral("Next branch: x = 1; y = minus 2."));
  EXPECT_EQ(words(Kind::end_of_branch), QStringLiteral("End: x = 1; y = minus 2."));
  EXPECT_EQ(words(Kind::other_branch), QStringLiteral("y equals 2: x = 1; y = minus 2."));
  EXPECT_EQ(words(Kind::beacon_reached), QStringLiteral("Marker 3: x = 1; y = minus 2."));
  EXPECT_EQ(words(Kind::beacon_dropped), QStringLiteral("Marker 3 set: x = 1; y = minus 2."));
  EXPECT_EQ(words(Kind::slope), QStringLiteral("slope 0.5"));
  EXPECT_EQ(words(Kind::curve_alone), QStringLiteral("Only curve 2: y equals 2."));
  EXPECT_EQ(words(Kind::groove), QStringLiteral("Branch 3 of 7: y equals 2"));
  EXPECT_EQ(words(Kind::speed), QStringLiteral("Speed 3 of 7"));
  EXPECT_TRUE(words(Kind::window_changed).startsWith(QStringLiteral("x from minus 6 to 6, one tick is")));
  for (auto kind = static_cast<int>(Kind::here); kind <= static_cast<int>(Kind::window_limit); ++kind)
    EXPECT_FALSE(words(static_cast<Kind>(kind)).isEmpty()) << kind;
  functions::PointOfInterest zero;
  zero.x = 1;
  zero.x_name = "1";
  zero.y_name = "0";
  event.point = zero;
  EXPECT_EQ(words(Kind::point_reached), point_words(*event.point) + QLatin1Char('.'));
}

}  // namespace
}  // namespace nazori::ui
