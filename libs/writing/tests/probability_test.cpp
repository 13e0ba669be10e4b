// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "drawing.h"
#include "nazori/writing/grade.h"
#include "probability.h"

namespace nazori::writing {
namespace {

Grade with(kanji::MistakeKind kind) {
  Grade grade;
  grade.mistakes.push_back({kind, 0, {}, {0}});
  return grade;
}

TEST(Probability, FallsAsTheStrangestStrokeDeviatesMore) {
  EXPECT_GT(probability_of({}, 0.1), 0.99);
  EXPECT_GT(probability_of({}, 0.5), probability_of({}, 0.9));
  EXPECT_GT(probability_of({}, 0.9), probability_of({}, 1.5));
  EXPECT_LT(probability_of({}, 3), 0.1);
  EXPECT_LE(probability_of({}, 0), 1);
}

TEST(Probability, IsAboutEvenAtTheLimitOfNormalStrictness) {
  EXPECT_NEAR(probability_of({}, 1), 0.5, 0.1);
  EXPECT_EQ(probability_of({}, 1), needed_probability(kNormal));
}

TEST(Probability, IsSmallForMistakesOfStructureHoweverWellTheStrokesAreShaped) {
  using kanji::MistakeKind;
  for (const auto kind : {MistakeKind::order, MistakeKind::reversed, MistakeKind::missing, MistakeKind::extra,
                          MistakeKind::joined, MistakeKind::split, MistakeKind::other})
    EXPECT_LT(probability_of(with(kind), 0.1), 0.05) << static_cast<int>(kind);
  EXPECT_LT(probability_of(with(MistakeKind::order), 9), 0.01);
}

TEST(Probability, DoesNotFallForEndings) {
  EXPECT_EQ(probability_of(with(kanji::MistakeKind::ending), 0.1), probability_of({}, 0.1));
}

TEST(Probability, AnOrderThatIsOnlyAdviceIsStillUnlikelyToBeAccepted) {
  Grade grade;
  grade.advice.push_back({kanji::MistakeKind::order, 0, 1, {1, 0}});
  EXPECT_LT(probability_of(grade, 0.1), 0.05);
}

TEST(Probability, TheStricterTheMoreOfItIsNeeded) {
  EXPECT_LT(needed_probability(kLenient), needed_probability(kNormal));
  EXPECT_LT(needed_probability(kNormal), needed_probability(kStrict));
}

TEST(Probability, StrictnessIsAThresholdOnIt) {
  const auto model = test::model_of(test::rest());
  int accepted = 0;
  int refused = 0;
  for (int turn = 0; turn < 12; ++turn)
    for (const double strictness : {0.0, 0.3, 0.5, 0.6, 0.8}) {
      auto ink = test::trace(test::rest());
      auto& stroke = ink.strokes[4];  // the left sweep of 木
      const auto from = stroke.front().at;
      for (auto& p : stroke) {
        const double angle = 0.08 * turn;
        const auto v = p.at - from;
        p.at = from + decltype(v){std::cos(angle) * v.x - std::sin(angle) * v.y,
                                  std::sin(angle) * v.x + std::cos(angle) * v.y};
      }
      const auto grade = test::graded(ink, model, strictness);
      (grade.accepted ? accepted : refused) += 1;
      EXPECT_EQ(grade.accepted, grade.probability >= needed_probability(strictness))
          << turn << " " << strictness;
    }
  EXPECT_GT(accepted, 5);
  EXPECT_GT(refused, 5);
}

}  // namespace
}  // namespace nazori::writing
