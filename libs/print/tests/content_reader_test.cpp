// SPDX-License-Identifier: Apache-2.0
// What the operators of PDF paint, worked out by hand. @source ISO 32000-1, 8.3 to 8.5 and 9.4.
#include "../src/content_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace nazori::print {
namespace {

constexpr double kInch_mm = 25.4;  // 72 points

Fonts& fonts() {
  static Fonts all = *Fonts::installed();
  return all;
}

/// A page of 100 mm; `objects` by their names.
PageDrawing read(const std::string& content, const std::map<std::string, std::string>& objects = {}) {
  PageDrawing page;
  read_content(
      content, 100, fonts(),
      [&](std::string_view name) {
        const auto found = objects.find(std::string(name));
        return found != objects.end() ? found->second : std::string();
      },
      page);
  return page;
}

void expect_at(const PathStep& step, PathStep::Kind kind, std::vector<std::pair<double, double>> inches) {
  EXPECT_EQ(step.kind, kind);
  for (std::size_t i = 0; i < inches.size(); ++i) {
    EXPECT_NEAR(step.points.at(i).x, inches[i].first * kInch_mm, 1e-9) << i;
    EXPECT_NEAR(step.points.at(i).y, 100 - inches[i].second * kInch_mm, 1e-9) << i;
  }
}

TEST(ContentReader, ALineHasItsGreyItsWidthAndItsDashes) {
  const PageDrawing page =
      read("0.5 G 7.2 w [3.6 3.6] 0 d 72 144 m 36 -18 l S\n[] 0 d 1 J 1 j 0 0 m 72 0 l S\n");
  ASSERT_EQ(page.marks.size(), 2U);
  const PageMark& dashed = page.marks[0];
  ASSERT_EQ(dashed.path.size(), 2U);
  expect_at(dashed.path[0], PathStep::Kind::move, {{1, 2}});
  expect_at(dashed.path[1], PathStep::Kind::line, {{0.5, -0.25}});
  EXPECT_FALSE(dashed.filled);
  EXPECT_EQ(dashed.grey, 0.5);
  EXPECT_NEAR(dashed.width_mm, 2.54, 1e-9);
  EXPECT_NEAR(dashed.dash_mm, 1.27, 1e-9);
  EXPECT_FALSE(dashed.round);
  EXPECT_EQ(page.marks[1].dash_mm, 0);
  EXPECT_TRUE(page.marks[1].round);
  EXPECT_EQ(page.marks[1].path.size(), 2U) << "each path starts empty";
}

TEST(ContentReader, ARectangleGoesAroundAndIsClosed) {
  const PageDrawing page = read("72 36 144 18 re S");
  ASSERT_EQ(page.marks.size(), 1U);
  const auto& path = page.marks[0].path;
  ASSERT_EQ(path.size(), 5U);
  expect_at(path[0], PathStep::Kind::move, {{1, 0.5}});
  expect_at(path[1], PathStep::Kind::line, {{3, 0.5}});
  expect_at(path[2], PathStep::Kind::line, {{3, 0.75}});
  expect_at(path[3], PathStep::Kind::line, {{1, 0.75}});
  EXPECT_EQ(path[4].kind, PathStep::Kind::close);
  EXPECT_NEAR(page.marks[0].width_mm, kInch_mm / 72, 1e-9) << "a line is one point wide until it is told";
  EXPECT_EQ(page.marks[0].grey, 0) << "and black";
}

TEST(ContentReader, ACurveHasItsControlPointsAndAFillItsOwnGrey) {
  const PageDrawing page = read("0.5 G 0.25 g 7 w 0 0 m 72 0 144 72 216 36 c f");
  ASSERT_EQ(page.marks.size(), 1U);
  const PageMark& mark = page.marks[0];
  ASSERT_EQ(mark.path.size(), 2U);
  expect_at(mark.path[1], PathStep::Kind::curve, {{1, 0}, {2, 1}, {3, 0.5}});
  EXPECT_TRUE(mark.filled);
  EXPECT_EQ(mark.grey, 0.25);
  EXPECT_EQ(mark.width_mm, 0) << "a shape that is filled has no outline";
  EXPECT_EQ(mark.dash_mm, 0);
}

TEST(ContentReader, ATransformationActsBeforeTheOnesAroundIt) {
  // Twice as large, then moved by an inch; a quarter of a turn, to the left.
  const PageDrawing page = read("1 0 0 1 72 0 cm 2 0 0 2 0 0 cm 0 1 -1 0 0 0 cm 3 w 36 18 m 0 36 l S");
  ASSERT_EQ(page.marks.size(), 1U);
  // (36, 18) turns to (-18, 36), is (-36, 72) and then (36, 72).
  expect_at(page.marks[0].path[0], PathStep::Kind::move, {{0.5, 1}});
  // (0, 36) turns to (-36, 0), is (-72, 0) and then (0, 0).
  expect_at(page.marks[0].path[1], PathStep::Kind::line, {{0, 0}});
  EXPECT_NEAR(page.marks[0].width_mm, 6 * kInch_mm / 72, 1e-9) << "lines grow with what they draw";
}

TEST(ContentReader, AMatrixThatMirrorsKeepsLinesAsWideAsTheyAre) {
  const PageDrawing page = read("3 0 0 -3 0 144 cm 2 w [4 4] 0 d 0 0 m 24 24 l S");
  ASSERT_EQ(page.marks.size(), 1U);
  expect_at(page.marks[0].path[0], PathStep::Kind::move, {{0, 2}});
  expect_at(page.marks[0].path[1], PathStep::Kind::line, {{1, 1}});
  EXPECT_NEAR(page.marks[0].width_mm, 6 * kInch_mm / 72, 1e-9);
  EXPECT_NEAR(page.marks[0].dash_mm, 12 * kInch_mm / 72, 1e-9);
}

TEST(ContentReader, WhatWasSavedComesBack) {
  const PageDrawing page = read(
      "0.3 G 2 w q 0.6 G 4 w [1 1] 0 d 1 J 1 0 0 1 72 72 cm 0 0 m 1 1 l S Q 0 0 m 1 1 l S Q Q 0 0 m 1 1 l S");
  ASSERT_EQ(page.marks.size(), 3U);
  EXPECT_EQ(page.marks[0].grey, 0.6);
  expect_at(page.marks[0].path[0], PathStep::Kind::move, {{1, 1}});
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    EXPECT_EQ(page.marks[i].grey, 0.3) << "also where nothing is saved any more";
    EXPECT_NEAR(page.marks[i].width_mm, 2 * kInch_mm / 72, 1e-9);
    EXPECT_EQ(page.marks[i].dash_mm, 0);
    EXPECT_FALSE(page.marks[i].round);
    expect_at(page.marks[i].path[0], PathStep::Kind::move, {{0, 0}});
  }
}

TEST(ContentReader, AnObjectIsDrawnWhereItIsPlacedAndChangesNothingAfterIt) {
  const PageDrawing page =
      read("0.5 G q 1 0 0 1 72 72 cm /G0 Do Q q 1 0 0 1 144 0 cm /G0 Do Q /G0 Do 0 0 m 72 0 l S",
           {{"G0", "0 0 m 72 0 l S 0.9 G 1 0 0 1 7 7 cm"}});
  ASSERT_EQ(page.marks.size(), 4U);
  expect_at(page.marks[0].path[0], PathStep::Kind::move, {{1, 1}});
  expect_at(page.marks[1].path[0], PathStep::Kind::move, {{2, 0}});
  expect_at(page.marks[2].path[0], PathStep::Kind::move, {{0, 0}});
  expect_at(page.marks[3].path[0], PathStep::Kind::move, {{0, 0}});
  for (const PageMark& mark : page.marks) EXPECT_EQ(mark.grey, 0.5);
}

TEST(ContentReader, AnObjectThatDrawsItselfEnds) {
  const PageDrawing page = read("/G0 Do", {{"G0", "0 0 m 72 0 l S /G0 Do"}});
  EXPECT_EQ(page.marks.size(), 4U) << "as deep as a character on a page of a booklet, and no deeper";
}

TEST(ContentReader, OperatorsThatItDoesNotKnowArePassedOverWithTheirOperands) {
  const PageDrawing page = read("  5 5 unknown 72\n 72 m 0 0 l S ");
  ASSERT_EQ(page.marks.size(), 1U);
  expect_at(page.marks[0].path[0], PathStep::Kind::move, {{1, 1}});
  EXPECT_TRUE(read("").marks.empty());
  EXPECT_TRUE(read(" \n ").marks.empty());
}

struct Box {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
};

Box box_of(const PageDrawing& page, std::size_t index) {
  Box box;
  for (const PathStep& step : page.marks.at(index).path) {
    const std::size_t count = step.kind == PathStep::Kind::close   ? 0
                              : step.kind == PathStep::Kind::curve ? 3
                                                                   : 1;
    for (std::size_t i = 0; i < count; ++i) {
      box.left = std::min(box.left, step.points.at(i).x);
      box.right = std::max(box.right, step.points.at(i).x);
      box.top = std::min(box.top, step.points.at(i).y);
      box.bottom = std::max(box.bottom, step.points.at(i).y);
    }
  }
  return box;
}

template <class Draw>
PageDrawing drawn(const Draw& draw) {
  Canvas canvas(fonts(), 100);
  draw(canvas);
  return read(canvas.content());
}

TEST(ContentReader, LettersStandOnTheirLineOneAfterTheOther) {
  const auto one = drawn([](Canvas& c) { c.text(10, 30, U"国", 20, 0.25); });
  const auto two = drawn([](Canvas& c) { c.text(10, 30, U"国国", 20, 0.25); });
  ASSERT_EQ(one.marks.size(), 1U);
  ASSERT_EQ(two.marks.size(), 1U);
  EXPECT_EQ(one.text, "国\n");
  EXPECT_EQ(two.text, "国国\n");
  EXPECT_TRUE(one.marks[0].filled);
  EXPECT_EQ(one.marks[0].grey, 0.25);
  const Box a = box_of(one, 0), b = box_of(two, 0);
  // The letter fills most of its em: 0.88 above its line, 0.12 below it.
  EXPECT_GT(a.left, 10);
  EXPECT_LT(a.right, 30);
  EXPECT_GT(a.top, 30 - 0.88 * 20);
  EXPECT_LT(a.bottom, 30 + 0.12 * 20);
  EXPECT_GT(a.right - a.left, 0.65 * 20);
  EXPECT_GT(a.bottom - a.top, 0.65 * 20);
  EXPECT_NEAR(b.left, a.left, 1e-9);
  EXPECT_NEAR(b.right, a.right + 20, 0.1) << "one em farther";
  EXPECT_EQ(two.marks[0].path.size(), 2 * one.marks[0].path.size());
  EXPECT_EQ(one.marks[0].path.front().kind, PathStep::Kind::move);
  EXPECT_EQ(one.marks[0].path.back().kind, PathStep::Kind::close);
}

TEST(ContentReader, ATextBeginsAtItsOwnPlaceWhateverWasWrittenBefore) {
  const auto both = drawn([](Canvas& c) {
    c.text(10, 30, U"国国国", 20);
    c.text(50, 90, U"国", 10);
  });
  const auto alone = drawn([](Canvas& c) { c.text(50, 90, U"国", 10); });
  ASSERT_EQ(both.marks.size(), 2U);
  EXPECT_NEAR(box_of(both, 1).left, box_of(alone, 0).left, 1e-9);
  EXPECT_NEAR(box_of(both, 1).bottom, box_of(alone, 0).bottom, 1e-9);
  EXPECT_EQ(both.text, "国国国\n国\n");
}

TEST(ContentReader, ATurnedTextGoesDown) {
  const auto level = drawn([](Canvas& c) { c.text(10, 30, U"国国", 20); });
  const auto turned = drawn([](Canvas& c) { c.turned_text(10, 30, U"国国", 20); });
  const Box a = box_of(level, 0), b = box_of(turned, 0);
  // What was to the right of the start is below it, what was above its line is to the right.
  EXPECT_NEAR(b.top - 30, a.left - 10, 0.02);
  EXPECT_NEAR(b.bottom - 30, a.right - 10, 0.02);
  EXPECT_NEAR(b.left - 10, 30 - a.bottom, 0.02);
  EXPECT_NEAR(b.right - 10, 30 - a.top, 0.02);
}

TEST(ContentReader, AnInvisibleTextIsOnlyFound) {
  const auto page = drawn([](Canvas& c) {
    c.text(10, 30, U"休", 20, 0, true);
    c.text(10, 60, U"国", 20);
  });
  EXPECT_EQ(page.marks.size(), 1U);
  EXPECT_EQ(page.text, "休\n国\n");
  EXPECT_GT(box_of(page, 0).top, 40);
}

TEST(ContentReader, LettersOfTwoFontsFollowOneAnother) {
  // What the first font lacks comes from the second one.
  char32_t other = 0;
  for (char32_t c = 0x2500; c < 0x2600 && other == 0; ++c)
    if (fonts().at(0).glyph(c, false) == 0 && fonts().at(1).glyph(c, false) != 0) other = c;
  if (other == 0) GTEST_SKIP() << "the first font has all of them";
  const std::u32string text{U'国', other, U'国'};
  const auto page = drawn([&](Canvas& c) { c.text(10, 30, text, 20); });
  const auto first = drawn([](Canvas& c) { c.text(10, 30, U"国", 20); });
  ASSERT_EQ(page.marks.size(), 3U) << "a mark for each change of the font";
  const double between = fonts().at(1).advance(fonts().at(1).glyph(other, false));
  EXPECT_NEAR(box_of(page, 2).left, box_of(first, 0).left + 20 * (1 + between), 0.05);
}

}  // namespace
}  // namespace nazori::print
