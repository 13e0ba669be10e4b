// SPDX-License-Identifier: Apache-2.0
// From where on a remark is made about a character, and how much of it ink must have.
#include "../src/remarks.h"

#include <gtest/gtest.h>

#include <numbers>

namespace nazori::scan {
namespace {

/// The flaws of a shape that has these numbers, as their names.
std::string flaws(const writing::InkShape& shape) {
  std::string all;
  for (const CellRemark& remark : remarks_on(shape)) {
    all += all.empty() ? "" : " ";
    all += kCellFlaws[static_cast<std::size_t>(remark.flaw)];
    if (remark.stroke != 0) all += " " + std::to_string(remark.stroke);
  }
  return all;
}

writing::InkShape with(double writing::InkShape::*number, double value) {
  writing::InkShape shape;
  shape.*number = value;
  return shape;
}

TEST(Remarks, AreMadeFromTheirLimitsOn) {
  using writing::InkShape;
  constexpr double kDegree = std::numbers::pi / 180;
  EXPECT_EQ(flaws({}), "");
  struct Limit {
    double InkShape::*number;
    double inside, beyond;
    const char* flaw;
  };
  const Limit all[] = {{&InkShape::size, 0.705, 0.695, "small"},
                       {&InkShape::size, 1.245, 1.255, "large"},
                       {&InkShape::offset_y, -0.109, -0.111, "high"},
                       {&InkShape::offset_y, 0.109, 0.111, "low"},
                       {&InkShape::offset_x, -0.109, -0.111, "left"},
                       {&InkShape::offset_x, 0.109, 0.111, "right"},
                       {&InkShape::lean_rad, -7.9 * kDegree, -8.1 * kDegree, "leans_left"},
                       {&InkShape::lean_rad, 7.9 * kDegree, 8.1 * kDegree, "leans_right"},
                       {&InkShape::extra, 0.119, 0.121, "extra_ink"}};
  for (const Limit& limit : all) {
    EXPECT_EQ(flaws(with(limit.number, limit.inside)), "") << limit.flaw;
    EXPECT_EQ(flaws(with(limit.number, limit.beyond)), limit.flaw);
  }
}

TEST(Remarks, AStrokeIsMissingOrShortByHowMuchOfItIsThere) {
  writing::InkShape shape;
  shape.covered = {0.71, 0.69, 0.3, 0.29, 0, 1};
  EXPECT_EQ(flaws(shape), "short_stroke 2 short_stroke 3 missing_stroke 4 missing_stroke 5");
  shape.size = 0.5;
  shape.offset_x = shape.offset_y = 0.2;
  shape.extra = 0.2;
  shape.covered = {0};
  EXPECT_EQ(flaws(shape), "small low right missing_stroke 1 extra_ink") << "in the order of their kinds";
}

TEST(Ink, IsLikeACharacterWhereLittleOfEitherIsWithoutTheOther) {
  const auto alike = [](double missing, double extra) {
    writing::InkShape shape;
    shape.missing = missing;
    shape.extra = extra;
    return is_alike(shape);
  };
  EXPECT_TRUE(alike(0, 0));
  EXPECT_TRUE(alike(0.3, 0));
  EXPECT_FALSE(alike(0.31, 0));
  EXPECT_TRUE(alike(0, 0.3));
  EXPECT_FALSE(alike(0, 0.31));
  EXPECT_TRUE(alike(0.22, 0.22));
  EXPECT_FALSE(alike(0.23, 0.23)) << "both together";
}

TEST(Remarks, AreExplained) {
  const std::pair<CellRemark, const char*> all[] = {
      {{CellFlaw::small}, "too small"},
      {{CellFlaw::large}, "too large"},
      {{CellFlaw::high}, "too high"},
      {{CellFlaw::low}, "too low"},
      {{CellFlaw::left}, "too far left"},
      {{CellFlaw::right}, "too far right"},
      {{CellFlaw::leans_left}, "leans to the left"},
      {{CellFlaw::leans_right}, "leans to the right"},
      {{CellFlaw::missing_stroke, 4}, "stroke 4 is missing"},
      {{CellFlaw::short_stroke, 2}, "stroke 2 is too short"},
      {{CellFlaw::extra_ink}, "has ink that belongs to no stroke"}};
  for (const auto& [remark, sentence] : all) EXPECT_EQ(explain(remark), sentence);
}

}  // namespace
}  // namespace nazori::scan
