// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "../src/brush.h"
#include "../src/centre_line.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

constexpr int kSamples = 512;
constexpr double kWidth = 4;

/// A spiral that winds inward, tighter by `shrink` with each degree, until its radius is one glyph unit.
StrokeLine inward(double shrink, double begin_degree) {
  StrokeLine line;
  double radius = 25;
  for (double degree = begin_degree; radius > 1; degree += 4, radius *= 1 - 4 * shrink) {
    const double a = degree * std::numbers::pi / 180;
    line.points.push_back(GlyphPoint{54.5, 54.5} + GlyphPoint{std::cos(a), std::sin(a)} * radius);
  }
  return line;
}

double apart(const Joint& a, const Joint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(LongBend, IsNotCutNearWhereItIsTight) {
  // No nearer than 1.2 widths along the line, in samples.
  const double clear = 1.2 * kWidth * (kSamples - 1) / 109;
  Brush brush = plain_brush(kWidth);
  brush.endings = false;
  int cuts = 0, tight_lines = 0;
  for (int shape = 0; shape < 40; ++shape) {
    const auto pieces = trace(inward(0.003 + 0.0001 * shape, 9 * shape), brush, kSamples);
    bool is_tight = false;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      for (const Joint& joint : pieces[k].joints) is_tight = is_tight || joint.needs_disc;
      if (pieces[k].round_end) continue;
      ++cuts;
      // Back from the cut, and forward from it.
      double way = 0;
      const auto& before = pieces[k].joints;
      for (std::size_t i = before.size(); i-- > 1 && way < clear;) {
        EXPECT_FALSE(before[i].needs_disc) << shape << ", cut " << k;
        way += apart(before[i], before[i - 1]);
      }
      ASSERT_LT(k + 1, pieces.size());
      const auto& after = pieces[k + 1].joints;
      way = 0;
      for (std::size_t i = 0; i + 1 < after.size() && way < clear - 1e-6; ++i) {
        EXPECT_FALSE(after[i].needs_disc) << shape << ", cut " << k;
        way += apart(after[i], after[i + 1]);
      }
      EXPECT_GE(way, clear - 1e-6) << "nor near the end of the line";
    }
    tight_lines += is_tight ? 1 : 0;
  }
  EXPECT_GT(cuts, 40);
  EXPECT_EQ(tight_lines, 40);
}

TEST(PointMark, APointIsADimpleOfFullDepthWhateverItsEnding) {
  for (const StrokeEnding ending :
       {StrokeEnding::stop, StrokeEnding::hook, StrokeEnding::taper, StrokeEnding::either}) {
    const BrushMark mark = brush_at(plain_brush(kWidth), ending, 0, 0, 0);
    EXPECT_EQ(mark.depth, plain_brush(kWidth).depth) << static_cast<int>(ending);
    EXPECT_GE(mark.half_width, kWidth / 2) << static_cast<int>(ending);
  }
}

}  // namespace
}  // namespace nazori::carving
