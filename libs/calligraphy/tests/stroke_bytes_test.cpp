// SPDX-License-Identifier: Apache-2.0
#include "../src/stroke_bytes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "nazori/paint/sheet_file.h"

namespace nazori::calligraphy {
namespace {

using Bytes = std::vector<std::uint8_t>;

BrushPoint point_at(double time_s) {
  return {.time_s = time_s,
          .pen = {0.01, -0.02},
          .at = {0.011, -0.019},
          .half_width_m = 0.003,
          .pressure = 0.7,
          .lean_rad = 0.2,
          .lean_to_rad = -2.5,
          .width_from = WidthFrom::speed};
}

/// Two strokes, one of them with a point without pressure.
std::vector<BrushStroke> two_strokes() {
  std::vector<BrushStroke> strokes{{point_at(1), point_at(1.5)}, {point_at(0.25)}};
  strokes[1][0].pressure.reset();
  strokes[1][0].width_from = WidthFrom::nothing;
  return strokes;
}

void expect_same(const BrushPoint& a, const BrushPoint& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.pen.x, b.pen.x);
  EXPECT_EQ(a.pen.y, b.pen.y);
  EXPECT_EQ(a.at.x, b.at.x);
  EXPECT_EQ(a.at.y, b.at.y);
  EXPECT_EQ(a.half_width_m, b.half_width_m);
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(a.lean_rad, b.lean_rad);
  EXPECT_EQ(a.lean_to_rad, b.lean_to_rad);
  EXPECT_EQ(a.width_from, b.width_from);
}

TEST(StrokeBytes, EveryNumberOfEveryPointComesBack) {
  const auto strokes = two_strokes();
  const auto again = parse_strokes(to_bytes(strokes));
  ASSERT_TRUE(again) << base::to_line(again.error());
  ASSERT_EQ(again->size(), 2U);
  ASSERT_EQ((*again)[0].size(), 2U);
  ASSERT_EQ((*again)[1].size(), 1U);
  expect_same((*again)[0][0], strokes[0][0]);
  expect_same((*again)[0][1], strokes[0][1]);
  expect_same((*again)[1][0], strokes[1][0]);
}

TEST(StrokeBytes, NoStrokesAreNoBytes) {
  EXPECT_TRUE(to_bytes(std::vector<BrushStroke>{}).empty());
  EXPECT_TRUE(parse_strokes({}).value().empty());
}

TEST(StrokeBytes, StrokesThatNoFileCanHoldAreLeftOut) {
  const BrushStroke hour(paint::kMostAttached / 74 + 1, point_at(1));
  EXPECT_TRUE(to_bytes({hour}).empty());
  EXPECT_FALSE(to_bytes({BrushStroke(1000, point_at(1))}).empty());
}

TEST(StrokeBytes, WhatEndsTooEarlyOrTooLateIsRefused) {
  const Bytes good = to_bytes(two_strokes());
  for (std::size_t length = 1; length < good.size(); ++length)
    EXPECT_FALSE(parse_strokes(std::span(good).first(length))) << length;
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_FALSE(parse_strokes(longer));
}

TEST(StrokeBytes, ValuesThatNoBrushHasAreRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto is_refused = [](auto&& change) {
    auto strokes = two_strokes();
    change(strokes[0][1]);
    const auto parsed = parse_strokes(to_bytes(strokes));
    return !parsed && parsed.error().what == "has strokes that no brush writes";
  };
  for (const double wrong : {kNan, kInfinity, -kInfinity}) {
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.time_s = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.pen.x = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.pen.y = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.at.x = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.at.y = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.half_width_m = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.pressure = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.lean_rad = wrong; }));
    EXPECT_TRUE(is_refused([&](BrushPoint& p) { p.lean_to_rad = wrong; }));
  }
  EXPECT_TRUE(is_refused([](BrushPoint& p) { p.half_width_m = -1e-9; }));
  EXPECT_TRUE(is_refused([](BrushPoint& p) { p.half_width_m = 10.5; }));
  EXPECT_TRUE(is_refused([](BrushPoint& p) { p.pen.x = -10.5; }));
  EXPECT_TRUE(is_refused([](BrushPoint& p) { p.pressure = 1.01; }));
  EXPECT_TRUE(is_refused([](BrushPoint& p) { p.pressure = -0.01; }));
  // Time goes on within a stroke.
  EXPECT_TRUE(is_refused([](BrushPoint& p) { p.time_s = 0.999; }));
  EXPECT_FALSE(is_refused([](BrushPoint& p) { p.time_s = 1; }));
  EXPECT_FALSE(is_refused([](BrushPoint& p) { p.pressure = 1; }));
  EXPECT_FALSE(is_refused([](BrushPoint& p) { p.half_width_m = 0; }));
}

TEST(StrokeBytes, MarksAndVersionsThatAreUnknownAreRefused) {
  const Bytes good = to_bytes(two_strokes());
  const auto with = [&](std::size_t at, std::uint8_t value) {
    Bytes bytes = good;
    bytes[at] = value;
    return parse_strokes(bytes);
  };
  EXPECT_EQ(with(0, 2).error().code, base::Errc::schema);
  EXPECT_EQ(with(0, 0).error().code, base::Errc::schema);
  // After version, number of strokes and of points: eight numbers, then what decided the width, and pressure.
  constexpr std::size_t kMarks = 12 + 8 * 8;
  EXPECT_FALSE(with(kMarks, 3));
  EXPECT_TRUE(with(kMarks, 2));
  EXPECT_FALSE(with(kMarks + 1, 2));
}

}  // namespace
}  // namespace nazori::calligraphy
