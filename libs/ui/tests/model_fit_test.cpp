// SPDX-License-Identifier: Apache-2.0
#include "characters/model_fit.h"

#include <gtest/gtest.h>

namespace {

using nazori::haptics::StrokePath;
using nazori::ui::HandStroke;
using nazori::view::Verdict;
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
      nazori::ui::fit_model({small(1, true), small(0, false)}, matched({1, 0}, {true, false}), kCross);
  EXPECT_NEAR(fit.scale, 0.5, 1e-9);
  EXPECT_NEAR(fit.x_m, 0.01, 1e-9);
  EXPECT_NEAR(fit.y_m, -0.02, 1e-9);
}

TEST(ModelFit, WithoutAMatchTheModelStaysWhereItIs) {
  const auto fit = nazori::ui::fit_model({small(0, false)}, matched({std::nullopt}, {false}), kCross);
  EXPECT_EQ(fit.scale, 1);
  EXPECT_EQ(fit.x_m, 0);
}

TEST(Verdicts, FaultsAreWrongAdviceIsNearlyAndTheRestRight) {
  auto grade = matched({0, 1, 2}, {false, false, false});
  const auto fault = [](writing::FaultKind kind, int stroke) {
    writing::Fault made;
    made.kind = kind;
    made.stroke = stroke;
    return made;
  };
  grade.faults = {fault(writing::FaultKind::wrong, 1), fault(writing::FaultKind::missing, 0)};
  grade.advice = {fault(writing::FaultKind::ending, 2)};
  EXPECT_EQ(nazori::ui::verdicts(grade, 4),
            (std::vector{Verdict::right, Verdict::wrong, Verdict::nearly, Verdict::none}));
}

TEST(Verdicts, MissingStrokesAreThoseThatNothingMatches) {
  EXPECT_EQ(nazori::ui::missing_strokes(matched({2, std::nullopt}, {false, false}), 4),
            (std::vector{0, 1, 3}));
}

}  // namespace
