// SPDX-License-Identifier: Apache-2.0
#include "standing_out.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"
#include "nazori/writing/explanation.h"

namespace nazori::writing::test {
namespace {

struct Centre {
  double x = 0;
  double y = 0;
};

Centre centre_of(const WrittenStroke& stroke) {
  Centre c;
  for (const auto& p : stroke) {
    c.x += p.at.x / static_cast<double>(stroke.size());
    c.y += p.at.y / static_cast<double>(stroke.size());
  }
  return c;
}

/// The stroke about its centre: size, then turned clockwise, then moved.
WrittenStroke spoiled(WrittenStroke stroke, double size, double turn_rad = 0, double right = 0,
                      double down = 0) {
  const auto c = centre_of(stroke);
  for (auto& p : stroke) {
    const double x = size * (p.at.x - c.x);
    const double y = size * (p.at.y - c.y);
    p.at.x = c.x + x * std::cos(turn_rad) - y * std::sin(turn_rad) + right;
    p.at.y = c.y + x * std::sin(turn_rad) + y * std::cos(turn_rad) + down;
  }
  return stroke;
}

/// 休 with one stroke spoiled.
Grade rest_with(std::size_t stroke, double size, double turn_rad = 0, double right = 0, double down = 0,
                double strictness = kNormal) {
  auto ink = trace(rest());
  ink.strokes[stroke] = spoiled(ink.strokes[stroke], size, turn_rad, right, down);
  return graded(ink, model_of(rest()), strictness);
}

std::vector<std::pair<int, Deviation>> told(const Grade& grade) {
  std::vector<std::pair<int, Deviation>> found;
  for (const auto& a : grade.advice)
    if (a.kind == kanji::MistakeKind::wrong) found.emplace_back(a.stroke, a.deviation);
  return found;
}

using Told = std::vector<std::pair<int, Deviation>>;

TEST(StandingOut, TheModelItselfHasNothingToTell) {
  for (const auto& c : {rest(), soil(), three(), eye()})
    EXPECT_EQ(told(graded(trace(c), model_of(c))), Told{}) << static_cast<int>(c.code_point);
}

TEST(StandingOut, ABarThatIsMuchTooLongIsToldAndLowersTheForm) {
  const auto g = rest_with(2, 1.75);
  EXPECT_TRUE(g.accepted);
  ASSERT_EQ(told(g), (Told{{2, Deviation::length}}));
  ASSERT_TRUE(g.form);
  EXPECT_LT(*g.form, kBestForm);
  EXPECT_GT(g.strokes[2].size, 1.6) << "the figure is the one that the sentence is about";
  EXPECT_EQ(explain(g.advice.front(), g, Language::english), "Stroke 3 is too long.");
}

TEST(StandingOut, ABarHalfAsLongIsToldAsTooShort) {
  const auto g = rest_with(2, 0.44);
  ASSERT_EQ(told(g), (Told{{2, Deviation::length}}));
  EXPECT_EQ(explain(g.advice.front(), g, Language::english), "Stroke 3 is too short.");
}

TEST(StandingOut, AStrokeOfAThirdOfItsLengthIsRefused) {
  for (std::size_t k = 0; k < 6; ++k) {
    const auto g = rest_with(k, 1.0 / 3);
    EXPECT_FALSE(g.accepted) << "stroke " << k + 1;
    EXPECT_FALSE(g.strokes[k].ok) << "stroke " << k + 1;
    EXPECT_FALSE(g.form) << "stroke " << k + 1;
  }
}

TEST(StandingOut, ATurnedStrokeIsToldByItsSlant) {
  for (const double turn : {0.65, -0.65}) {
    const auto g = rest_with(3, 1, turn);
    if (g.accepted) {
      EXPECT_EQ(told(g), (Told{{3, Deviation::direction}})) << turn;
    } else {
      EXPECT_FALSE(g.strokes[3].ok);
    }
  }
}

TEST(StandingOut, AMovedStrokeIsToldByItsPlace) {
  auto ink = trace(three());
  ink.strokes[0] = spoiled(ink.strokes[0], 1, 0, 0, -20);
  const auto g = graded(ink, model_of(three()));
  ASSERT_TRUE(g.accepted);
  ASSERT_EQ(told(g), (Told{{0, Deviation::place}}));
  EXPECT_EQ(explain(g.advice.front(), g, Language::english), "Stroke 1 is too high.");
}

TEST(StandingOut, NothingIsToldOfAStrokeThatOnlyLeansOnTheNaturalLimits) {
  EXPECT_EQ(told(rest_with(2, 1.3)), Told{});
  EXPECT_EQ(told(rest_with(2, 0.7)), Told{});
  EXPECT_EQ(told(rest_with(3, 1, 0.3)), Told{});
  EXPECT_EQ(told(rest_with(2, 1, 0, 0, -9)), Told{});
}

TEST(StandingOut, ASlantedNarrowAndLargerHandIsNotToldOfAnyStroke) {
  const auto ink = mapped(shaken(trace(rest()), 1, 3), 2.1, -0.5, 0.3, 3, 40, -10);
  EXPECT_EQ(told(graded(ink, model_of(rest()))), Told{});
}

TEST(StandingOut, APartThatIsWrittenLargerIsNotToldStrokeByStroke) {
  // The tree of 休 a quarter larger than the person.
  auto ink = trace(rest());
  for (std::size_t k = 2; k < 6; ++k)
    for (auto& p : ink.strokes[k]) {
      p.at.x = 63 + 1.25 * (p.at.x - 63);
      p.at.y = 54 + 1.25 * (p.at.y - 54);
    }
  EXPECT_EQ(told(graded(ink, model_of(rest()))), Told{});
}

TEST(StandingOut, AStrictJudgeTellsWhatALenientOneLets) {
  EXPECT_EQ(told(rest_with(2, 1.6, 0, 0, 0, kStrict)), (Told{{2, Deviation::length}}));
  EXPECT_EQ(told(rest_with(2, 1.6, 0, 0, 0, kLenient)), Told{});
}

TEST(StandingOut, ADotMayHaveAnyLengthAndSlant) {
  // 六: its first stroke is a dot here, of 10 units.
  const auto six = character(U'六', {"㇔|M54,12c3,2.5,5,5,6,7.5", "㇐|M15,38c20,-1,50,-3,78,-3",
                                     "㇒|M42,52c-4,14,-12,28,-26,40", "㇔|M66,52c9,9,20,24,25,36"});
  auto ink = trace(six);
  ink.strokes[0] = spoiled(ink.strokes[0], 1.9);
  EXPECT_EQ(told(graded(ink, model_of(six))), Told{});
}

TEST(StandingOut, ASingleStrokeHasNothingToStandOutFrom) {
  const auto one = character(U'一', {"㇐|M11,54c10,-1,60,-3,88,-3"});
  auto ink = trace(one);
  ink.strokes[0] = spoiled(ink.strokes[0], 2);
  const auto g = graded(ink, model_of(one));
  EXPECT_TRUE(g.accepted);
  EXPECT_EQ(told(g), Told{});
}

TEST(StandingOut, AForgottenHookIsToldAsAnEndingNotAsALength) {
  const auto hooked =
      character(U'丁', {"㇐|M15,24c20,-1,60,-3,80,-3", "㇚|M55,24c2,10,2,50,1,66c0,8,-6,6,-15,-2"});
  auto ink = trace(hooked);
  ink.strokes[1] = shortened(ink.strokes[1], 0.78);
  const auto g = graded(ink, model_of(hooked));
  EXPECT_EQ(told(g), Told{});
}

TEST(StandingOut, IsNotToldWhileTheCharacterIsBeingWritten) {
  auto ink = trace(rest());
  ink.strokes[2] = spoiled(ink.strokes[2], 2);
  const auto g = grade(ink, model_of(rest()), {.unfinished = true});
  ASSERT_TRUE(g);
  EXPECT_EQ(told(*g), Told{}) << "only the whole shows how long a stroke should be";
}

TEST(StandingOut, OfTwoStrokesOneThatIsAThirdAsLongIsRefused) {
  // Laying over would stretch the whole until both strokes are nearly right.
  const auto cliff = character(U'厂', {"|M25,22L94,22", "|M28,22C28,60 24,80 12,96"});
  const auto model = model_of(cliff);
  for (const std::size_t k : {0U, 1U}) {
    auto ink = trace(cliff);
    ink.strokes[k] = shortened(ink.strokes[k], 1.0 / 3);
    const auto g = graded(ink, model);
    ASSERT_EQ(mistake_names(g), std::vector<std::string>{"wrong@" + std::to_string(k)});
    EXPECT_EQ(g.mistakes.front().deviation, Deviation::length);
    EXPECT_EQ(explain(g, Language::english).front(), "Stroke " + std::to_string(k + 1) + " is too short.");
    ink = trace(cliff);
    ink.strokes[k] = shortened(ink.strokes[k], 0.6);
    EXPECT_TRUE(graded(ink, model).accepted) << "proportions are free within limits";
  }
}

TEST(StandingOut, BesideAStrangeStrokeTheOtherOfTwoIsNotBlamed) {
  const auto cliff = character(U'厂', {"|M25,22L94,22", "|M28,22C28,60 24,80 12,96"});
  auto ink = trace(cliff);
  ink.strokes[1] = along({{10, 40}, {100, 40}, {10, 60}, {100, 60}, {10, 80}, {100, 80}});
  EXPECT_EQ(mistake_names(graded(ink, model_of(cliff))), std::vector<std::string>{"wrong@1"});
}

TEST(StandingOut, LiveJudgingTellsItAtTheEnd) {
  auto ink = trace(rest());
  ink.strokes[2] = spoiled(ink.strokes[2], 1.75);
  const auto g = grade_live(ink, model_of(rest()));
  ASSERT_TRUE(g);
  EXPECT_EQ(told(*g), (Told{{2, Deviation::length}}));
}

TEST(StandingOut, OnlyTheSpoiledStrokeIsTold) {
  for (std::size_t k = 2; k < 6; ++k) {
    const auto g = rest_with(k, 2);
    for (const auto& [stroke, deviation] : told(g)) EXPECT_EQ(stroke, static_cast<int>(k));
    for (std::size_t other = 0; other < 6; ++other)
      EXPECT_TRUE(other == k || g.strokes[other].ok) << "stroke " << other + 1 << " beside " << k + 1;
  }
}

}  // namespace
}  // namespace nazori::writing::test
