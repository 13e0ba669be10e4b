// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/axis_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace nazori::functions {
namespace {

/// The texts on one side of the axes, in the order of the labels.
std::string texts(const std::vector<geometry::Label>& labels, double right, double up) {
  std::string all;
  for (const auto& label : labels)
    if (label.right == right && label.up == up) all += (all.empty() ? "" : " ") + label.text;
  return all;
}

TEST(AxisLabels, AreTheNumbersOfTheTicksBelowTheOneAxisAndLeftOfTheOther) {
  const auto labels = axis_labels({-5, 5, -4, 4}, {});
  EXPECT_EQ(texts(labels, 0, -1), "-4 -3 -2 -1 1 2 3 4");  // 5 would stand on the frame
  EXPECT_EQ(texts(labels, -1, 0), "-3 -2 -1 1 2 3");
}

TEST(AxisLabels, StandBesideTheirTicks) {
  for (const auto& label : axis_labels({-5, 5, -4, 4}, {})) {
    const double value = std::stod(label.text);
    EXPECT_NEAR(label.at.x, label.up == -1 ? value / 10 * 0.1 : 0, 1e-12) << label.text;
    EXPECT_NEAR(label.at.y, label.right == -1 ? value / 8 * 0.1 : 0, 1e-12) << label.text;
  }
}

TEST(AxisLabels, ZeroStandsOnceWhereTheAxesCross) {
  const auto labels = axis_labels({-5, 5, -4, 4}, {});
  const auto is_zero = [](const geometry::Label& label) { return label.text == "0"; };
  ASSERT_EQ(std::count_if(labels.begin(), labels.end(), is_zero), 1);
  const auto& zero = *std::find_if(labels.begin(), labels.end(), is_zero);
  EXPECT_NEAR(zero.at.x, 0, 1e-12);
  EXPECT_NEAR(zero.at.y, 0, 1e-12);
  EXPECT_LT(zero.right, 0);
  EXPECT_LT(zero.up, 0);
  EXPECT_NEAR(zero.right * zero.right + zero.up * zero.up, 1, 1e-12);
}

TEST(AxisLabels, OfAnAxisOutsideOfTheWindowStandAtTheNearestSideTowardsTheMiddle) {
  const auto labels = axis_labels({2, 12, 3, 13}, {});
  EXPECT_EQ(texts(labels, 0, 1), "3 4 5 6 7 8 9 10 11");
  EXPECT_EQ(texts(labels, 1, 0), "4 5 6 7 8 9 10 11 12");
  for (const auto& label : labels) EXPECT_NEAR(label.up == 1 ? label.at.y : label.at.x, -0.05, 1e-12);
  const auto far = axis_labels({-12, -2, -13, -3}, {});
  EXPECT_EQ(texts(far, 0, -1), "-11 -10 -9 -8 -7 -6 -5 -4 -3");
  EXPECT_EQ(texts(far, -1, 0), "-12 -11 -10 -9 -8 -7 -6 -5 -4");
  for (const auto& label : far) EXPECT_NEAR(label.up == -1 ? label.at.y : label.at.x, 0.05, 1e-12);
}

TEST(AxisLabels, AnAxisNearTheEdgeHasItsNumbersOnTheOtherSide) {
  EXPECT_EQ(texts(axis_labels({-0.5, 9.5, -5, 5}, {}), 1, 0), "-4 -3 -2 -1 1 2 3 4");
  EXPECT_EQ(texts(axis_labels({-2, 8, -5, 5}, {}), -1, 0), "-4 -3 -2 -1 1 2 3 4");
  EXPECT_EQ(texts(axis_labels({-5, 5, -0.5, 9.5}, {}), 0, 1), "-4 -3 -2 -1 1 2 3 4");
}

TEST(AxisLabels, WithoutTicksThereAreNone) {
  Layers layers;
  layers.ticks = false;
  EXPECT_TRUE(axis_labels({-5, 5, -4, 4}, layers).empty());
}

TEST(AxisLabels, GrowWithTheTablet) {
  const geometry::TabletShape shape{0.2, 0.01};
  const auto labels = axis_labels({-5, 5, -5, 5}, {}, shape);
  const auto four = std::find_if(labels.begin(), labels.end(), [](const geometry::Label& label) {
    return label.text == "4" && label.up == -1;
  });
  ASSERT_NE(four, labels.end());
  EXPECT_NEAR(four->at.x, 0.08, 1e-12);
}

TEST(AxisLabels, AreWrittenWithTheDigitsOfTheStepAndWithAPowerWhereThatIsShorter) {
  EXPECT_EQ(tick_text(-1.5, 0.5), "-1.5");
  EXPECT_EQ(tick_text(1, 0.5), "1.0");
  EXPECT_EQ(tick_text(3 * 0.1, 0.1), "0.3");
  EXPECT_EQ(tick_text(-3 * 0.1 + 0.3, 0.1), "0");
  EXPECT_EQ(tick_text(2000, 500), "2000");
  EXPECT_EQ(tick_text(20000, 5000), "20000");
  EXPECT_EQ(tick_text(3e7, 1e7), "3e7");
  EXPECT_EQ(tick_text(-2.5e7, 5e6), "-2.5e7");
  EXPECT_EQ(tick_text(2e-5, 1e-5), "2e-5");
  EXPECT_EQ(tick_text(123456, 1), "123456");
  EXPECT_EQ(tick_text(0, 1e7), "0");
}

}  // namespace
}  // namespace nazori::functions
