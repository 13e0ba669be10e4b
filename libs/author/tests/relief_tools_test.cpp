// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/relief_tools.h"

#include <gtest/gtest.h>

#include <cmath>

#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;
using Pen = geometry::WrittenStroke<geometry::GlyphFrame>;

constexpr int kSide = 219;  // two samples a glyph unit, and one at the middle of the mirror

class ReliefTools : public testing::Test {
 protected:
  /// The relief after a tool was used on `character_`.
  surface::HeightMap after(ReliefTool tool, const ToolSettings& settings, const Pen& pen) {
    const auto box = use_tool(tool, settings, pen, carved(character_, kSide), character_.hand);
    EXPECT_TRUE(box) << base::to_line(box.error());
    box_ = box.value_or(carving::GridBox{});
    return carved(character_, kSide);
  }
  static Pen line(GlyphPoint from, GlyphPoint to, double pressure = 1) {
    return {{.at = from, .pressure = pressure}, {.at = to, .pressure = pressure}};
  }
  OwnCharacter character_;
  carving::GridBox box_;
};

TEST_F(ReliefTools, AGrooveIsAsDeepAndBroadAsThePressure) {
  const ToolSettings settings{.width = 8, .depth = 0.8};
  const auto full = after(ReliefTool::groove, settings, line({20, 30}, {90, 30}));
  EXPECT_NEAR(full.at(110, 60), 0.2F, 1e-5);
  EXPECT_LT(full.at(110, 67), 1.0F);
  EXPECT_EQ(full.at(110, 68), 1.0F);
  const auto half = after(ReliefTool::groove, settings, line({20, 80}, {90, 80}, 0.5));
  EXPECT_NEAR(half.at(110, 160), 0.6F, 1e-5);
  EXPECT_LT(half.at(110, 165), 1.0F);
  EXPECT_EQ(half.at(110, 166), 1.0F);
}

TEST_F(ReliefTools, APenWithoutPressurePressesFully) {
  const Pen pen{{.at = {20, 30}}, {.at = {90, 30}}};
  EXPECT_NEAR(after(ReliefTool::groove, {.depth = 0.8}, pen).at(110, 60), 0.2F, 1e-5);
}

TEST_F(ReliefTools, GroovesJoinAsThoseOfStrokes) {
  // Squares of depths join as a + b - a b.
  character_.strokes = {even_stroke({{20, 30}, {90, 30}}, 4, 0.6)};
  const auto map = after(ReliefTool::groove, {.width = 8, .depth = 0.5}, line({55, 10}, {55, 60}));
  EXPECT_NEAR(map.at(110, 60), 1 - std::sqrt(0.36 + 0.25 - 0.36 * 0.25), 1e-5);
}

TEST_F(ReliefTools, RaisingFillsAGrooveUpToThePlateau) {
  character_.strokes = {even_stroke({{20, 30}, {90, 30}}, 4, 0.6)};
  const ToolSettings settings{.width = 8, .depth = 0.25};
  EXPECT_NEAR(after(ReliefTool::raise, settings, line({55, 10}, {55, 60})).at(110, 60), 0.65F, 1e-5);
  EXPECT_NEAR(after(ReliefTool::raise, settings, line({55, 10}, {55, 60})).at(110, 60), 0.9F, 1e-5);
  EXPECT_EQ(after(ReliefTool::raise, settings, line({55, 10}, {55, 60})).at(110, 60), 1.0F);
  // No more than that is remembered: a groove cut now is felt at once.
  EXPECT_NEAR(after(ReliefTool::groove, settings, line({55, 10}, {55, 60})).at(110, 60), 0.75F, 1e-5);
}

TEST_F(ReliefTools, ErasingTakesTheHandsLayerAwayAndLeavesTheStrokes) {
  character_.strokes = {even_stroke({{20, 30}, {90, 30}}, 4, 0.6)};
  const auto strokes = carved(character_, kSide);
  (void)after(ReliefTool::groove, {.width = 6, .depth = 1}, line({55, 10}, {55, 60}));
  const auto map = after(ReliefTool::erase, {.width = 40, .depth = 1}, line({55, 0}, {55, 70}));
  for (int row = 20; row < 120; ++row) EXPECT_EQ(map.at(110, row), strokes.at(110, row)) << row;
  (void)after(ReliefTool::erase, {.width = 40, .depth = 0.5}, line({55, 0}, {55, 70}));
}

TEST_F(ReliefTools, ErasingHalfwayHalvesWhatTheHandDid) {
  character_.hand = layer_with(kSide, {0, 0, kSide, kSide}, -0.4F);
  const auto map = after(ReliefTool::erase, {.width = 10, .depth = 0.5}, line({20, 30}, {90, 30}));
  EXPECT_NEAR(map.at(110, 60), 0.8F, 1e-6);
  EXPECT_FLOAT_EQ(map.at(110, 100), 0.6F);
}

TEST_F(ReliefTools, SmoothingTakesTheMeanAroundASample) {
  // A step: 0.5 deep on the right of column 110.
  character_.hand = layer_with(kSide, {110, 0, kSide, kSide}, -0.5F);
  const auto map = after(ReliefTool::smooth, {.width = 16, .depth = 1}, line({55, 20}, {55, 90}));
  // Squares of 2 * 4 + 1 samples: width / 8 is 2 glyph units.
  EXPECT_NEAR(map.at(110, 110), 1 - 0.5 * 5 / 9, 1e-5);
  // A sample away from the middle, the tool works with (1 - x^2)^2 at x = 1/16 half widths.
  const double share = std::pow(1 - 1.0 / 256, 2);
  EXPECT_NEAR(map.at(109, 110), 1 - share * 0.5 * 4 / 9, 1e-4);
  EXPECT_FLOAT_EQ(map.at(130, 110), 0.5F);
}

TEST_F(ReliefTools, SmoothingTakesRowsAsItTakesColumns) {
  character_.hand = layer_with(kSide, {0, 110, kSide, kSide}, -0.5F);
  const auto map = after(ReliefTool::smooth, {.width = 16, .depth = 1}, line({20, 55}, {90, 55}));
  EXPECT_NEAR(map.at(110, 110), 1 - 0.5 * 5 / 9, 1e-5);
}

TEST_F(ReliefTools, SmoothingALevelTabletChangesNothing) {
  character_.hand = layer_with(kSide, {0, 0, kSide, kSide}, -0.5F);
  const auto hand = character_.hand;
  (void)after(ReliefTool::smooth, {.width = 16, .depth = 1}, line({0, 0}, {109, 109}));
  EXPECT_EQ(character_.hand, hand);
  EXPECT_TRUE(box_.is_empty());
}

TEST_F(ReliefTools, OnlyTheTouchedBoxChanges) {
  const auto before = carved(character_, kSide);
  const auto map = after(ReliefTool::groove, {.width = 8, .depth = 1}, line({40, 30}, {60, 30}));
  // From 36 to 64 and from 26 to 34 glyph units; the rim itself stays.
  EXPECT_EQ(box_, (carving::GridBox{73, 53, 128, 68}));
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      if (column < 73 || column >= 128 || row < 53 || row >= 68) {
        ASSERT_EQ(map.at(column, row), 1.0F) << column << ", " << row;
      }
}

TEST_F(ReliefTools, AStraightLineGoesFromTheFirstToTheLastPoint) {
  Pen bent{{.at = {20, 30}}, {.at = {50, 90}}, {.at = {80, 30}}};
  const auto straight = after(ReliefTool::groove, {.straight = true}, bent);
  EXPECT_LT(straight.at(100, 60), 0.6F);
  EXPECT_EQ(straight.at(100, 180), 1.0F);
  const OwnCharacter one = std::exchange(character_, {});
  (void)after(ReliefTool::groove, {}, {bent[0], bent[2]});
  EXPECT_EQ(character_, one);
}

TEST_F(ReliefTools, AMirroredToolWorksOnBothSidesAlike) {
  const auto map =
      after(ReliefTool::groove, {.mirrored = true}, {{.at = {20, 30}}, {.at = {30, 60}}, {.at = {50, 70}}});
  EXPECT_LT(map.at(40, 60), 0.6F);
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      ASSERT_NEAR(map.at(column, row), map.at(kSide - 1 - column, row), 1e-5) << column << ", " << row;
}

TEST_F(ReliefTools, TheSameCallsGiveTheSameBytes) {
  const auto run = [this] {
    character_ = cross();
    (void)after(ReliefTool::groove, {.mirrored = true}, line({20, 30}, {40, 80}, 0.7));
    (void)after(ReliefTool::smooth, {.width = 20}, line({10, 50}, {90, 50}, 0.4));
    (void)after(ReliefTool::raise, {.width = 9}, line({50, 10}, {50, 50}, 0.4));
    return character_.hand;
  };
  EXPECT_EQ(run(), run());
}

TEST_F(ReliefTools, ALayerIsMadeOnlyWhereSomethingChanges) {
  (void)after(ReliefTool::raise, {}, line({20, 30}, {90, 30}));
  EXPECT_TRUE(character_.hand.is_untouched());
  (void)after(ReliefTool::groove, {}, {});
  (void)after(ReliefTool::groove, {}, line({20, 30}, {90, 30}, 0));
  (void)after(ReliefTool::groove, {}, line({180, 30}, {190, 30}));
  EXPECT_TRUE(character_.hand.is_untouched());
  (void)after(ReliefTool::groove, {}, line({20, 30}, {90, 30}));
  EXPECT_EQ(character_.hand.size, kSide);
}

TEST_F(ReliefTools, WhatIsOutOfRangeIsRefused) {
  const auto map = carved(character_, 32);
  const auto why = [&](const ToolSettings& settings, const Pen& pen) {
    return place_of_error(use_tool(ReliefTool::groove, settings, pen, map, character_.hand));
  };
  const Pen pen = line({20, 30}, {90, 30});
  EXPECT_EQ(why({.width = 0.4}, pen), "width");
  EXPECT_EQ(why({.width = 40.1}, pen), "width");
  EXPECT_EQ(why({.width = NAN}, pen), "width");
  EXPECT_EQ(why({.depth = 0}, pen), "depth");
  EXPECT_EQ(why({.depth = 1.1}, pen), "depth");
  EXPECT_EQ(why({}, line({NAN, 1}, {2, 2})), "pen");
  EXPECT_EQ(why({}, line({1, 1}, {2, 219})), "pen");
  EXPECT_EQ(why({}, Pen(10'001, {.at = {1, 1}})), "pen");
  EXPECT_TRUE(character_.hand.is_untouched());
  EXPECT_EQ(why({.width = 0.5}, Pen(10'000, {.at = {1, 1}})), "");
  EXPECT_EQ(why({.width = 40, .depth = 1}, line({1, 1}, {2, 218})), "");
  EXPECT_EQ(character_.hand.size, 32);
  EXPECT_EQ(place_of_error(use_tool(ReliefTool::groove, {}, pen, {}, character_.hand)), "map");
  EXPECT_EQ(place_of_error(use_tool(ReliefTool::groove, {}, pen, carved({}, 33), character_.hand)), "hand");
}

TEST_F(ReliefTools, AStampIsPressedWhereItIsAsked) {
  auto patch = surface::HeightMap::create(2);
  for (float& h : patch->samples()) h = 0.5F;
  const auto box =
      press_stamp(*patch, {.size = 10, .depth = 0.8}, {40, 60}, carved(character_, kSide), character_.hand);
  ASSERT_TRUE(box);
  EXPECT_EQ(*box, (carving::GridBox{70, 110, 91, 131}));
  const auto map = carved(character_, kSide);
  for (int row = 110; row < 131; ++row)
    for (int column = 70; column < 91; ++column) ASSERT_NEAR(map.at(column, row), 0.6F, 1e-6);
  EXPECT_EQ(map.at(69, 120), 1.0F);
  EXPECT_EQ(map.at(91, 120), 1.0F);
}

TEST_F(ReliefTools, AStampIsNotTurnedOrMirrored) {
  auto patch = surface::HeightMap::create(3);
  patch->set(2, 0, 0.0F);  // only its upper right corner is deep
  ASSERT_TRUE(press_stamp(*patch, {.size = 20, .depth = 1, .mirrored = true}, {30, 30},
                          carved(character_, kSide), character_.hand));
  const auto map = carved(character_, kSide);
  EXPECT_EQ(map.at(80, 40), 0.0F);
  EXPECT_EQ(map.at(40, 40), 1.0F);
  EXPECT_EQ(map.at(80, 80), 1.0F);
  EXPECT_NEAR(map.at(70, 50), 0.75F, 1e-6);  // halfway to the middle of the edge in both directions
  EXPECT_EQ(map.at(218 - 80, 40), 0.0F);
  EXPECT_EQ(map.at(218 - 40, 40), 1.0F);
}

TEST_F(ReliefTools, ARaisedStampFillsGrooves) {
  character_.hand = layer_with(kSide, {0, 0, kSide, kSide}, -0.5F);
  auto patch = surface::HeightMap::create(2, 0.0F);
  const StampSettings settings{.size = 10, .depth = 0.3, .raised = true};
  ASSERT_TRUE(press_stamp(*patch, settings, {40, 60}, carved(character_, kSide), character_.hand));
  EXPECT_NEAR(carved(character_, kSide).at(80, 120), 0.8F, 1e-6);
  ASSERT_TRUE(press_stamp(*patch, settings, {40, 60}, carved(character_, kSide), character_.hand));
  EXPECT_EQ(carved(character_, kSide).at(80, 120), 1.0F);
}

TEST_F(ReliefTools, StampsOutOfRangeAreRefused) {
  const auto map = carved(character_, 32);
  const auto& dot = stamp_of(StampShape::dot);
  const auto why = [&](const StampSettings& settings, GlyphPoint at) {
    return place_of_error(press_stamp(dot, settings, at, map, character_.hand));
  };
  EXPECT_EQ(why({.size = 0.9}, {50, 50}), "size");
  EXPECT_EQ(why({.size = 109.1}, {50, 50}), "size");
  EXPECT_EQ(why({.depth = 0}, {50, 50}), "depth");
  EXPECT_EQ(why({.depth = 1.1}, {50, 50}), "depth");
  EXPECT_EQ(why({}, {NAN, 50}), "place");
  EXPECT_EQ(why({}, {50, 219}), "place");
  EXPECT_EQ(place_of_error(press_stamp({}, {}, {50, 50}, map, character_.hand)), "stamp");
  EXPECT_TRUE(character_.hand.is_untouched());
  EXPECT_EQ(why({.size = 109, .depth = 1}, {218, 50}), "");
}

TEST(StampShapes, AreDifferentSymmetricAndInsideTheirSquare) {
  for (const StampShape shape : kStampShapes) {
    const surface::HeightMap& stamp = stamp_of(shape);
    ASSERT_EQ(stamp.size(), 65);
    float lowest = 1;
    for (int row = 0; row < 65; ++row) {
      for (int column = 0; column < 65; ++column) {
        lowest = std::min(lowest, stamp.at(column, row));
        ASSERT_NEAR(stamp.at(column, row), stamp.at(64 - column, row), 1e-5);
        if (row == 0 || column == 0 || row == 64 || column == 64) {
          ASSERT_EQ(stamp.at(column, row), 1.0F);
        }
      }
    }
    EXPECT_LT(lowest, 0.001F);
    for (const StampShape other : kStampShapes) EXPECT_EQ(stamp_of(other) == stamp, other == shape);
  }
  for (const StampShape shape :
       {StampShape::dot, StampShape::ring, StampShape::bar, StampShape::cross, StampShape::square})
    for (int i = 0; i < 65; ++i) EXPECT_NEAR(stamp_of(shape).at(32, i), stamp_of(shape).at(32, 64 - i), 1e-5);
  // What tells them apart: the middle, above it, and the corner of the square.
  const auto deep = [](StampShape shape, int column, int row) {
    return stamp_of(shape).at(column, row) < 0.5F;
  };
  EXPECT_TRUE(deep(StampShape::dot, 32, 32) && !deep(StampShape::dot, 32, 12));
  EXPECT_TRUE(!deep(StampShape::ring, 32, 32) && deep(StampShape::ring, 32, 10) &&
              !deep(StampShape::ring, 11, 11));
  EXPECT_TRUE(deep(StampShape::bar, 12, 32) && !deep(StampShape::bar, 32, 12));
  EXPECT_TRUE(deep(StampShape::cross, 12, 32) && deep(StampShape::cross, 32, 12));
  EXPECT_TRUE(!deep(StampShape::square, 32, 32) && deep(StampShape::square, 11, 11) &&
              deep(StampShape::square, 11, 53));
  EXPECT_TRUE(!deep(StampShape::triangle, 11, 11) && deep(StampShape::triangle, 11, 53) &&
              deep(StampShape::triangle, 32, 12));
}

TEST(StampShapes, AreAsHighAsBelowAndHaveTheirCornersWhereTheyAreDrawn) {
  for (const StampShape shape :
       {StampShape::dot, StampShape::ring, StampShape::bar, StampShape::cross, StampShape::square})
    for (int row = 0; row < 65; ++row)
      for (int column = 0; column < 65; ++column)
        ASSERT_NEAR(stamp_of(shape).at(column, row), stamp_of(shape).at(column, 64 - row), 1e-5)
            << column << ", " << row;
  for (const StampShape shape : {StampShape::dot, StampShape::cross})
    for (int row = 0; row < 65; ++row)
      for (int column = 0; column < 65; ++column)
        ASSERT_NEAR(stamp_of(shape).at(column, row), stamp_of(shape).at(row, column), 1e-5);
  // Samples are 1.7 units apart. A line is 14 units wide on each side: full in its middle, nothing beside it.
  const auto height = [](StampShape shape, double x, double y) {
    return stamp_of(shape).at(static_cast<int>(std::lround(x * 64 / 109)),
                              static_cast<int>(std::lround(y * 64 / 109)));
  };
  EXPECT_LT(height(StampShape::square, 91, 91), 0.05F);
  EXPECT_LT(height(StampShape::square, 18, 54.5), 0.05F);
  EXPECT_LT(height(StampShape::triangle, 91, 89), 0.05F);
  EXPECT_LT(height(StampShape::triangle, 54.5, 89), 0.05F);
  EXPECT_EQ(height(StampShape::triangle, 54.5, 106), 1.0F);
  EXPECT_LT(height(StampShape::bar, 16, 54.5), 0.05F);
  EXPECT_EQ(height(StampShape::bar, 54.5, 72), 1.0F);
  EXPECT_LT(height(StampShape::ring, 92.5, 54.5), 0.05F);
  EXPECT_LT(height(StampShape::ring, 54.5 + 38 * std::sqrt(0.5), 54.5 + 38 * std::sqrt(0.5)), 0.05F);
  EXPECT_EQ(height(StampShape::ring, 54.5, 73), 1.0F);
  EXPECT_EQ(height(StampShape::dot, 54.5, 77), 1.0F);
}

}  // namespace
}  // namespace nazori::author
