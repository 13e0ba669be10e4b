// SPDX-License-Identifier: Apache-2.0
// The figures of a grade: what is said of each stroke, and the parts of the score.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "drawing.h"
#include "nazori/writing/grade.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;

TEST(ScoreParts, AreSharesOfAllStrokes) {
  const auto model = model_of(rest());
  struct Case {
    std::string what;
    WrittenCharacter ink;
    double strokes, order, direction;
  };
  std::vector<Case> cases;
  const auto all = trace(rest());
  cases.push_back({"all", all, 1, 1, 1});
  auto missing = all;
  missing.strokes.erase(missing.strokes.begin() + 2);
  cases.push_back({"missing", missing, 5 / 6.0, 5 / 6.0, 5 / 6.0});
  auto exchanged = all;
  std::swap(exchanged.strokes[2], exchanged.strokes[3]);
  cases.push_back({"exchanged", exchanged, 1, 4 / 6.0, 1});
  auto moved = all;
  std::rotate(moved.strokes.begin() + 1, moved.strokes.begin() + 2, moved.strokes.end());
  cases.push_back({"moved", moved, 1, 5 / 6.0, 1});
  auto backwards = all;
  backwards.strokes[3] = reversed(backwards.strokes[3]);
  cases.push_back({"backwards", backwards, 1, 1, 5 / 6.0});
  auto extra = all;
  extra.strokes.insert(extra.strokes.begin() + 2, along({{70, 90}, {100, 95}}));
  cases.push_back({"extra", extra, 6 / 7.0, 6 / 7.0, 6 / 7.0});
  auto together = all;
  together.strokes[4] = joined(together.strokes[4], together.strokes[5]);
  together.strokes.pop_back();
  cases.push_back({"joined", together, 5 / 6.0, 5 / 6.0, 5 / 6.0});
  auto strange = all;
  strange.strokes[2] = along({{60, 20}, {62, 50}, {58, 70}});
  cases.push_back({"wrong", strange, 5 / 6.0, 1, 1});
  for (const auto& c : cases) {
    const auto g = graded(c.ink, model);
    EXPECT_NEAR(g.parts.strokes, c.strokes, 1e-9) << c.what;
    EXPECT_NEAR(g.parts.order, c.order, 1e-9) << c.what;
    EXPECT_NEAR(g.parts.direction, c.direction, 1e-9) << c.what;
    EXPECT_EQ(g.score, std::lround(30 * g.parts.strokes + 15 * g.parts.order + 15 * g.parts.direction +
                                   25 * g.parts.shape + 15 * g.parts.place))
        << c.what;
    for (const double part : {g.parts.shape, g.parts.place}) {
      EXPECT_GE(part, 0) << c.what;
      EXPECT_LE(part, 1) << c.what;
    }
  }
  const auto without = graded(missing, model);
  EXPECT_NEAR(without.parts.shape, 5 / 6.0, 0.01) << "what is missing has neither shape";
  EXPECT_NEAR(without.parts.place, 5 / 6.0, 0.01) << "nor place";
}

TEST(ScoreParts, OfUnfinishedWritingAreSharesOfWhatIsThere) {
  auto ink = trace(rest());
  ink.strokes.resize(3);
  const auto g = grade(ink, model_of(rest()), {kNormal, true});
  ASSERT_TRUE(g);
  EXPECT_EQ(g->score, 100);
  EXPECT_TRUE(g->accepted);
}

TEST(ScoreParts, ShapeAndPlaceFallWithTheirDeviations) {
  const auto model = model_of(rest());
  double before = 2;
  for (const double shift : {0.0, 5.0, 10.0, 20.0}) {
    auto ink = trace(rest());
    for (auto& p : ink.strokes[2]) p.at.y += shift;
    const auto g = graded(ink, model);
    EXPECT_LT(g.parts.place, before) << shift;
    EXPECT_GT(g.parts.shape, 0.85) << shift;
    before = g.parts.place;
  }
  auto bent = trace(rest());
  bent.strokes[2] = along({{37, 39}, {50, 25}, {65, 50}, {91, 35}});
  const auto g = graded(bent, model);
  EXPECT_LT(g.parts.shape, 0.95);
  EXPECT_GT(g.parts.place, g.parts.shape);
}

TEST(Verdict, SaysWhereAndHowLargeAStrokeIs) {
  const auto model = model_of(eye());
  auto ink = trace(eye());
  for (auto& p : ink.strokes[3]) p.at = {p.at.x + 6, p.at.y - 4};
  const auto g = graded(ink, model);
  // In shares of the box; the fit removes a part of it.
  EXPECT_NEAR(g.strokes[3].offset_x, 6 / 109.0, 0.02);
  EXPECT_NEAR(g.strokes[3].offset_y, -4 / 109.0, 0.015);
  EXPECT_NEAR(g.strokes[3].size, 1, 0.05);
  auto half = trace(eye());
  half.strokes[3] = shortened(half.strokes[3], 0.5);
  EXPECT_NEAR(graded(half, model).strokes[3].size, 0.5, 0.06);
  EXPECT_GT(graded(half, model).strokes[3].deviation, graded(half, model).strokes[1].deviation);
  for (const auto& s : graded(trace(eye()), model).strokes) {
    EXPECT_NEAR(s.deviation, 0, 1e-3);
    EXPECT_NEAR(s.shape, 0, 1e-2);
    EXPECT_NEAR(s.angle_rad, 0, 1e-2);
    EXPECT_FALSE(s.reversed);
  }
}

/// The third stroke of 休 turned about its middle, clockwise.
WrittenCharacter turned(double angle) {
  auto ink = trace(rest());
  for (auto& p : ink.strokes[2]) {
    const double x = p.at.x - 64, y = p.at.y - 37;
    p.at = {64 + x * std::cos(angle) - y * std::sin(angle), 37 + x * std::sin(angle) + y * std::cos(angle)};
  }
  return ink;
}

TEST(Verdict, SaysByHowMuchAStrokeIsTurned) {
  const auto model = model_of(rest());
  for (const double angle : {-0.5, -0.2, 0.2, 0.5, 0.9})
    EXPECT_NEAR(graded(turned(angle), model).strokes[2].angle_rad, angle, 0.2) << angle;
  auto back = turned(0.15);
  back.strokes[2] = reversed(back.strokes[2]);
  EXPECT_NEAR(graded(back, model).strokes[2].angle_rad, 0.15, 0.15) << "of the stroke as it should run";
  const auto far = graded(turned(1.0), model);
  ASSERT_THAT(mistake_names(far), ElementsAre("wrong@2"));
  EXPECT_EQ(far.mistakes[0].deviation, Deviation::direction);
  // A loop has no direction.
  auto loop = trace(rest());
  loop.strokes[2] = along({{45, 40}, {80, 30}, {85, 42}, {60, 48}, {46, 41}});
  EXPECT_EQ(graded(loop, model).strokes[2].angle_rad, 0);
}

TEST(Verdict, AStrokeDrawnBackwardsStartsAtTheOtherSide) {
  // Right to left, left to right, up, down; the two in each direction are of different lengths.
  const auto c =
      character(U'井', {"㇐|M95,20L10,20", "㇐|M20,60L100,60", "㇑|M30,100L30,30", "㇑|M75,5L75,95"});
  const Side sides[] = {Side::right, Side::left, Side::bottom, Side::top};
  for (std::size_t k = 0; k < 4; ++k) {
    auto ink = trace(c);
    ink.strokes[k] = reversed(ink.strokes[k]);
    const auto g = graded(ink, model_of(c));
    ASSERT_THAT(mistake_names(g), ElementsAre("reversed@" + std::to_string(k)));
    EXPECT_EQ(g.mistakes[0].start, sides[k]) << k;
  }
}

TEST(Verdict, OfASplitStrokeIsThatOfBothPieces) {
  auto ink = trace(rest());
  const auto whole = resampled(ink.strokes[2], 21);
  ink.strokes[2].assign(whole.begin(), whole.begin() + 11);
  ink.strokes.insert(ink.strokes.begin() + 3, WrittenStroke(whole.begin() + 11, whole.end()));
  const auto g = graded(ink, model_of(rest()));
  ASSERT_THAT(mistake_names(g), ElementsAre("split@2"));
  EXPECT_EQ(g.mistakes[0].second, 3);
  EXPECT_THAT(g.mistakes[0].model, ElementsAre(2));
  EXPECT_EQ(g.strokes[2].matched, 2);
  EXPECT_EQ(g.strokes[3].matched, 2);
  EXPECT_FALSE(g.strokes[2].ok);
  EXPECT_FALSE(g.strokes[3].ok);
  EXPECT_EQ(g.strokes[4].matched, 3);
  EXPECT_NEAR(g.parts.strokes, 6 / 7.0, 1e-9);
}

TEST(Verdict, MistakesComeInTheOrderOfTheStrokes) {
  auto ink = trace(rest());
  ink.strokes[4] = reversed(ink.strokes[4]);
  ink.strokes.erase(ink.strokes.begin() + 1);
  ink.strokes.push_back(along({{70, 90}, {100, 95}}));
  const auto g = graded(ink, model_of(rest()));
  EXPECT_TRUE(std::is_sorted(g.mistakes.begin(), g.mistakes.end(),
                             [](const Mistake& a, const Mistake& b) { return a.stroke < b.stroke; }));
}

TEST(Verdict, TheBoxOfTheWritingMayLieAnywhere) {
  // Which bar of three is missing shows only in the box.
  for (std::size_t gone = 0; gone < 3; ++gone) {
    auto ink = trace(three());
    ink.strokes.erase(ink.strokes.begin() + static_cast<std::ptrdiff_t>(gone));
    const auto expected = mistake_names(graded(ink, model_of(three())));
    auto far = mapped(ink, 0.05, 0, 0, 0.05, 30, -7);
    far.box = WritingBox{{30, -7}, 0.05 * 109};
    EXPECT_EQ(mistake_names(graded(far, model_of(three()))), expected);
    EXPECT_THAT(expected, ElementsAre("missing@" + std::to_string(gone)));
  }
}

TEST(Verdict, InHastyWritingMoreIsForgiven) {
  const auto model = model_of(rest());
  const auto limit = [&](double shake) {
    // How far a bar may be too low where the others are off by so much.
    double shift = 0;
    for (; shift < 40; shift += 0.5) {
      auto ink = trace(rest());
      for (std::size_t k = 0; k < 6; ++k)
        if (k != 2)
          for (auto& p : ink.strokes[k]) p.at = {p.at.x + (k % 2 == 0 ? shake : -shake), p.at.y};
      for (auto& p : ink.strokes[2]) p.at.y += shift;
      const auto g = graded(ink, model);
      if (!g.strokes[2].ok) break;
    }
    return shift;
  };
  EXPECT_GT(limit(4), limit(0));
  EXPECT_GT(limit(0), 4);
  EXPECT_LT(limit(4), 30);
}

TEST(Verdict, WritingOfAnotherCharacterLosesThePointsOfItsStrokes) {
  const std::vector<Model> lookalikes{model_of(samurai())};
  // Between the two: still accepted as soil where nothing looks like it.
  for (double part = 0; part <= 1; part += 0.05) {
    WrittenCharacter ink = trace(soil());
    const auto other = trace(samurai());
    for (std::size_t k = 0; k < 3; ++k) {
      ink.strokes[k] = resampled(ink.strokes[k], 12);
      const auto towards = resampled(other.strokes[k], 12);
      for (std::size_t i = 0; i < 12; ++i) {
        auto& p = ink.strokes[k][i].at;
        p = p + (towards[i].at - p) * part;
      }
    }
    const auto alone = grade(ink, model_of(soil()));
    const auto beside = grade(ink, model_of(soil()), {}, lookalikes);
    ASSERT_TRUE(alone && beside);
    const bool is_other = std::any_of(beside->mistakes.begin(), beside->mistakes.end(),
                                      [](const Mistake& f) { return f.kind == kanji::MistakeKind::other; });
    if (!is_other) {
      EXPECT_EQ(beside->accepted, alone->accepted) << part;
      EXPECT_LT(part, 0.8);
      continue;
    }
    EXPECT_TRUE(alone->accepted) << part;
    EXPECT_FALSE(beside->accepted) << part;
    EXPECT_EQ(beside->mistakes.size(), 1U);
    EXPECT_EQ(beside->mistakes[0].character, U'士');
    EXPECT_FALSE(beside->strokes[static_cast<std::size_t>(beside->mistakes[0].stroke)].ok);
    EXPECT_EQ(beside->parts.strokes, 0);
    EXPECT_EQ(beside->score, alone->score - 30);
    EXPECT_GT(part, 0.5) << "on the other's side of the middle";
    // While it is still being written it may become either.
    EXPECT_TRUE(grade(ink, model_of(soil()), {kNormal, true}, lookalikes)->accepted);
  }
}

}  // namespace
}  // namespace nazori::writing::test
