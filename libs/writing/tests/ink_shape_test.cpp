// SPDX-License-Identifier: Apache-2.0
// Ink without order compared with a model, by what was done to the model's own lines.
#include "nazori/writing/ink_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Gt;
using testing::SizeIs;

InkShape compared(const WrittenCharacter& ink, const kanji::Character& with) {
  const auto shape = compare_ink(ink, model_of(with));
  EXPECT_TRUE(shape) << (shape ? "" : base::to_line(shape.error()));
  return shape.value_or(InkShape{});
}

/// The ink in the box of the model, around whose middle it was changed.
WrittenCharacter changed(const kanji::Character& character, double scale, double turn_rad, double dx,
                         double dy) {
  WrittenCharacter ink = trace(character);
  const WritingBox box = *ink.box;
  const double x = box.corner.x + box.side / 2;
  const double y = box.corner.y + box.side / 2;
  const double c = scale * std::cos(turn_rad);
  const double s = scale * std::sin(turn_rad);
  ink = mapped(ink, c, -s, s, c, x - c * x + s * y + dx * box.side, y - s * x - c * y + dy * box.side);
  ink.box = box;
  return ink;
}

TEST(InkShape, TheModelCoversItself) {
  for (const kanji::Character& character : {rest(), three(), eye(), soil()}) {
    const InkShape shape = compared(trace(character), character);
    EXPECT_THAT(shape.covered, SizeIs(character.strokes.size()));
    EXPECT_THAT(shape.covered, Each(1));
    EXPECT_EQ(shape.missing, 0);
    EXPECT_EQ(shape.extra, 0);
    EXPECT_NEAR(shape.size, 1, 0.02);
    EXPECT_NEAR(shape.offset_x, 0, 0.01);
    EXPECT_NEAR(shape.offset_y, 0, 0.01);
    EXPECT_NEAR(shape.lean_rad, 0, 0.01);
  }
}

TEST(InkShape, OrderDirectionAndJoiningDoNotCount) {
  WrittenCharacter ink = trace(rest());
  const InkShape before = compared(ink, rest());
  std::reverse(ink.strokes.begin(), ink.strokes.end());
  for (auto& stroke : ink.strokes) stroke = reversed(stroke);
  const InkShape after = compared(ink, rest());
  EXPECT_EQ(after.covered, before.covered);
  EXPECT_NEAR(after.size, before.size, 1e-9);
}

TEST(InkShape, SizePlaceAndLeanAreThoseInTheBox) {
  const InkShape shape = compared(changed(rest(), 0.7, 0.2, 0.05, -0.1), rest());
  EXPECT_NEAR(shape.size, 0.7, 0.08) << "a turned box is a little larger";
  EXPECT_NEAR(shape.lean_rad, 0.2, 0.04);
  EXPECT_NEAR(shape.offset_x, 0.05, 0.03);
  EXPECT_NEAR(shape.offset_y, -0.1, 0.03);
  EXPECT_LT(shape.missing + shape.extra, 0.02) << "they do not make ink missing";
  EXPECT_LT(compared(changed(rest(), 0.7, -0.2, 0, 0), rest()).lean_rad, -0.16);
}

TEST(InkShape, AMissingStrokeIsNotCoveredAndTheOthersAre) {
  for (std::size_t gone = 0; gone < rest().strokes.size(); ++gone) {
    WrittenCharacter ink = trace(rest());
    ink.strokes.erase(ink.strokes.begin() + static_cast<std::ptrdiff_t>(gone));
    const InkShape shape = compared(ink, rest());
    EXPECT_LT(shape.covered[gone], 0.4) << gone;
    for (std::size_t i = 0; i < shape.covered.size(); ++i) {
      if (i == gone) continue;
      EXPECT_GT(shape.covered[i], 0.8) << gone << " " << i;
    }
    EXPECT_GT(shape.missing, 0.05) << gone;
    EXPECT_LT(shape.extra, 0.05) << gone;
  }
}

TEST(InkShape, InkOfAnotherCharacterIsExtra) {
  EXPECT_GT(compared(trace(rest()), three()).extra, 0.4);
  EXPECT_GT(compared(trace(three()), rest()).missing, 0.4);
}

TEST(InkShape, WithoutABoxItIsRefused) {
  WrittenCharacter ink = trace(rest());
  ink.box.reset();
  EXPECT_EQ(compare_ink(ink, model_of(rest())).error().code, base::Errc::bad_argument);
  EXPECT_EQ(compare_ink({}, model_of(rest())).error().code, base::Errc::bad_argument);
}

}  // namespace
}  // namespace nazori::writing::test
