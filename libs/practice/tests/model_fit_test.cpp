// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/model_fit.h"

#include <gtest/gtest.h>

namespace {

using nazori::haptics::StrokePath;
using nazori::practice::HandStroke;
using nazori::view::Verdict;
namespace kanji = nazori::kanji;
namespace writing = nazori::writing;

writing::Grade matched(std::vector<std::optional<int>> to, std::vector<bool> reversed) {
  writing::Grade grade;
  for (std::size_t i = 0; i < to.size(); ++i) {
    writing::StrokeVerdict v;
    v.matched = to[i];
    v.ok = to[i].has_value() && !reversed[i];
    v.reversed = reversed[i];
    grade.strokes.push_back(v);
  }
  return grade;
}

const std::vector<StrokePath> kCross{{{{-0.03, 0, 0}, {0.03, 0, 0}}}, {{{0, 0.03, 0}, {0, -0.03, 0}}}};

/// A stroke of the cross half as large, moved to (0.01, -0.02).
HandStroke small(std::size_t stroke, bool backwards) {
  HandStroke hand;
  for (const auto& p : kCross[stroke].points) hand.push_back({{p.x / 2 + 0.01, p.y / 2 - 0.02}, 0, 0.5});
  if (backwards) std::swap(hand.front(), hand.back());
  return hand;
}

TEST(ModelFit, TheModelIsLaidOverWritingOfAnotherSizeAndPlaceWhateverItsDirection) {
  const auto fit =
      nazori::practice::fit_model({small(1, true), small(0, false)}, matched({1, 0}, {true, false}), kCross);
  EXPECT_NEAR(fit.scale, 0.5, 1e-9);
  EXPECT_NEAR(fit.x_m, 0.01, 1e-9);
  EXPECT_NEAR(fit.y_m, -0.02, 1e-9);
}

TEST(ModelFit, WithoutAMatchTheModelStaysWhereItIs) {
  const auto fit = nazori::practice::fit_model({small(0, false)}, matched({std::nullopt}, {false}), kCross);
  EXPECT_EQ(fit.scale, 1);
  EXPECT_EQ(fit.x_m, 0);
}

TEST(ModelFit, TheModelIsNeverLaidOverSmallerThanAFifthOrLargerThanTwice) {
  const auto scaled = [](double by) {
    HandStroke hand;
    for (const auto& p : kCross[0].points) hand.push_back({{p.x * by + 0.01, p.y * by}, 0, 0.5});
    return nazori::practice::fit_model({hand}, matched({0}, {false}), kCross);
  };
  EXPECT_NEAR(scaled(0.21).scale, 0.21, 1e-9);
  EXPECT_NEAR(scaled(0.1).scale, 0.2, 1e-9);
  EXPECT_NEAR(scaled(1.95).scale, 1.95, 1e-9);
  EXPECT_NEAR(scaled(3).scale, 2, 1e-9);
  EXPECT_NEAR(scaled(3).x_m, 0.01, 1e-9) << "the middles lie over each other";
}

TEST(ModelFit, StrokesThatDoNotMatchAreLeftOut) {
  HandStroke far;
  for (int i = 0; i < 5; ++i) far.push_back({{0.04, 0.01 * i}, 0, 0.5});
  // Unmatched, matched to a stroke that the model does not have, without points, and beyond the verdicts.
  const auto fit =
      nazori::practice::fit_model({far, far, {}, small(0, false), far},
                                  matched({std::nullopt, 2, 1, 0}, {false, false, false, false}), kCross);
  EXPECT_NEAR(fit.scale, 0.5, 1e-9);
  EXPECT_NEAR(fit.x_m, 0.01, 1e-9);
  EXPECT_NEAR(fit.y_m, -0.02, 1e-9);
}

TEST(ModelFit, APointIsLaidOnItsPlaceWithoutBeingSized) {
  const std::vector<StrokePath> dot{{{{0.01, 0.02, 0}, {0.01, 0.02, 0}}}};
  const auto fit = nazori::practice::fit_model({{{{0.03, 0.01}, 0, 0.5}}}, matched({0}, {false}), dot);
  EXPECT_EQ(fit.scale, 1);
  EXPECT_NEAR(fit.x_m, 0.02, 1e-12);
  EXPECT_NEAR(fit.y_m, -0.01, 1e-12);
}

TEST(ModelFit, TheLineOfTheModelHasItsPlaceAndIsToldFromWriting) {
  const auto line = nazori::practice::model_line(kCross[0], {0.5, 0.01, 0.02}, 0.75);
  EXPECT_EQ(line.verdict, Verdict::shown);
  EXPECT_EQ(line.opacity, 0.75);
  ASSERT_EQ(line.points.size(), 2U);
  EXPECT_NEAR(line.points[0].at.x, -0.005, 1e-12);
  EXPECT_NEAR(line.points[1].at.x, 0.025, 1e-12);
  EXPECT_NEAR(line.points[1].at.y, 0.02, 1e-12);
  EXPECT_GT(line.half_width_m.value_or(0), 0);
}

TEST(Verdicts, OfAStrokeThatIsNotThereNothingIsMarked) {
  auto grade = matched({std::nullopt, 1}, {false, false});
  writing::Mistake before;
  before.kind = kanji::MistakeKind::extra;
  before.stroke = -1;
  writing::Mistake beyond = before;
  beyond.stroke = 2;
  grade.mistakes = {before, beyond};
  EXPECT_EQ(nazori::practice::verdicts(grade, 2), (std::vector{Verdict::wrong, Verdict::right}));
  EXPECT_EQ(nazori::practice::verdicts(grade, 1), std::vector{Verdict::wrong});
  writing::Mistake both;
  both.kind = kanji::MistakeKind::wrong;
  both.stroke = 1;
  grade.mistakes = {both};
  grade.advice = {both};
  EXPECT_EQ(nazori::practice::verdicts(grade, 2)[1], Verdict::wrong) << "a fault outweighs advice";
}

TEST(Verdicts, MistakesAreWrongAdviceIsNearlyAndTheRestRight) {
  auto grade = matched({0, 1, 2}, {false, false, false});
  const auto mistake = [](kanji::MistakeKind kind, int stroke) {
    writing::Mistake made;
    made.kind = kind;
    made.stroke = stroke;
    return made;
  };
  grade.mistakes = {mistake(kanji::MistakeKind::wrong, 1), mistake(kanji::MistakeKind::missing, 0)};
  grade.advice = {mistake(kanji::MistakeKind::ending, 2)};
  EXPECT_EQ(nazori::practice::verdicts(grade, 4),
            (std::vector{Verdict::right, Verdict::wrong, Verdict::nearly, Verdict::none}));
}

TEST(Verdicts, MissingStrokesAreThoseThatNothingMatches) {
  EXPECT_EQ(nazori::practice::missing_strokes(matched({2, std::nullopt}, {false, false}), 4),
            (std::vector{0, 1, 3}));
}

}  // namespace
