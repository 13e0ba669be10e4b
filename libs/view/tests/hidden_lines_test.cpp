// SPDX-License-Identifier: Apache-2.0
#include "../src/hidden_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nazori::view {
namespace {

const geometry::TabletShape kShape{};

/// So many pieces along one line, numbered from 1, and after them one elsewhere.
std::vector<LinePiece> bundle_and_one(int pieces, LinePiece elsewhere) {
  std::vector<LinePiece> lines;
  for (int i = 1; i <= pieces; ++i)
    lines.push_back({{-0.03F, 0.01F}, {0.03F, 0.012F}, static_cast<float>(i)});
  lines.push_back(elsewhere);
  return lines;
}

TEST(HiddenLines, OfVeryManyInOnePlaceAFewAreDrawnAndThoseElsewhereAll) {
  const LinePiece elsewhere{{-0.03F, -0.02F}, {0.04F, -0.03F}, 1e6F};
  auto lines = bundle_and_one(60'000, elsewhere);
  const std::size_t shown = put_hidden_last(lines, kShape);
  EXPECT_EQ(lines.size(), 60'001U) << "none is lost: one stroke may be shown alone";
  EXPECT_LT(shown, 20U);
  EXPECT_GT(shown, 1U);
  EXPECT_EQ(lines[shown - 1].stroke, elsewhere.stroke);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_TRUE(i == shown || lines[i - 1].stroke < lines[i].stroke) << i;
  }
}

TEST(HiddenLines, ALineThatLeavesTheCrowdIsDrawn) {
  const LinePiece leaves{{0.0F, 0.011F}, {0.0F, 0.03F}, 1e6F};
  auto lines = bundle_and_one(60'000, leaves);
  EXPECT_EQ(lines[put_hidden_last(lines, kShape) - 1].stroke, leaves.stroke);
}

TEST(HiddenLines, FourAreDrawnWhicheverWayTheyRun) {
  for (const glm::vec2 way : {glm::vec2(-1, 0), {0, 1}, {0, -1}}) {
    const glm::vec2 aside(-way.y, way.x);
    std::vector<LinePiece> lines(60'000, {-0.03F * way, 0.03F * way, 1});
    lines.push_back({-0.01F * way, 0.02F * way, 2});                   // covered in each cell
    lines.push_back({0.005F * way, 0.005F * way + 0.01F * aside, 3});  // leaves the crowd
    const std::size_t shown = put_hidden_last(lines, kShape);
    ASSERT_EQ(shown, 5U) << way.x << ' ' << way.y;
    EXPECT_EQ(lines[shown - 1].stroke, 3);
  }
}

TEST(HiddenLines, OfACharacterAllAreDrawn) {
  auto lines = bundle_and_one(40'000, {{0, 0}, {0, 0}, 1e6F});
  EXPECT_EQ(put_hidden_last(lines, kShape), lines.size());
  EXPECT_EQ(lines.front().stroke, 1);
}

TEST(HiddenLines, ThatLeaveTheTabletCountToItsRim) {
  std::vector<LinePiece> lines(60'000, {{-9, -9}, {9, 9}, 1});
  lines.push_back({{-9, 9}, {-9, 9}, 2});
  const std::size_t shown = put_hidden_last(lines, kShape);
  EXPECT_LT(shown, 20U);
  EXPECT_EQ(lines[shown - 1].stroke, 2);
}

TEST(HiddenLines, OfHeadsThatPointToOnePlaceAFewAreDrawn) {
  std::vector<ArrowHead> heads(60'000, {{0.01F, 0.01F}, {1, 0}, 1});
  heads.push_back({{-0.02F, 0.03F}, {0, 1}, 2});
  const std::size_t shown = put_hidden_last(heads, kShape);
  EXPECT_LT(shown, 20U);
  EXPECT_EQ(heads[shown - 1].stroke, 2);
}

}  // namespace
}  // namespace nazori::view
