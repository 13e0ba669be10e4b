// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_results.h"

#include <gtest/gtest.h>

namespace nazori::practice {
namespace {

TEST(WritingResults, HandwritingGoesOnInTimeWhereTheClockBeginsAgain) {
  const std::vector<HandStroke> strokes{{{{0, 0}, 5.0, 0.5}, {{0.01, 0}, 5.1, 0.5}},
                                        {{{0, 0.01}, 0.02, 0.5}, {{0, 0.02}, 5.25, 0.5}}};
  const study::Handwriting ink = to_handwriting(strokes);
  std::vector<double> times_s;
  for (const auto& stroke : ink)
    for (const auto& point : stroke) times_s.push_back(point.time_s.value_or(-1));
  EXPECT_EQ(times_s, (std::vector<double>{0, 0.1, 0.1, 0.25}));
  EXPECT_TRUE(study::pack(ink)) << "it can be kept";
}

TEST(WritingResults, EveryMistakeIsKeptUnderItsName) {
  using kanji::MistakeKind;
  const MistakeKind kinds[] = {MistakeKind::order, MistakeKind::reversed, MistakeKind::missing,
                               MistakeKind::extra, MistakeKind::joined,   MistakeKind::split,
                               MistakeKind::wrong, MistakeKind::other,    MistakeKind::ending};
  writing::Grade grade;
  grade.accepted = true;
  grade.score = 63;
  for (const MistakeKind kind : kinds) {
    writing::Mistake mistake;
    mistake.kind = kind;
    grade.mistakes.push_back(mistake);
  }
  const auto result = to_result(grade);
  EXPECT_TRUE(result.accepted);
  EXPECT_EQ(result.score, 63);
  ASSERT_EQ(result.mistakes.size(), std::size(kinds));
  for (std::size_t i = 0; i < std::size(kinds); ++i) EXPECT_EQ(result.mistakes[i].kind, kinds[i]) << i;
  grade.accepted = false;
  EXPECT_FALSE(to_result(grade).accepted);
}

TEST(WritingResults, AMistakeIsKeptByTheStrokeOfTheModelWhereThatIsKnown) {
  writing::Grade grade;
  grade.strokes.resize(3);
  grade.strokes[1].matched = 4;
  const auto kept = [&grade](kanji::MistakeKind kind, int stroke, std::vector<int> model) {
    writing::Mistake mistake;
    mistake.kind = kind;
    mistake.stroke = stroke;
    mistake.model = std::move(model);
    grade.mistakes = {mistake};
    return to_result(grade).mistakes.front().stroke;
  };
  using kanji::MistakeKind;
  EXPECT_EQ(kept(MistakeKind::missing, 1, {2}), 1) << "a missing stroke is one of the model";
  EXPECT_EQ(kept(MistakeKind::wrong, 1, {2, 3}), 2) << "the first that it is about";
  EXPECT_EQ(kept(MistakeKind::wrong, 1, {}), 4) << "what it matches";
  EXPECT_EQ(kept(MistakeKind::extra, 2, {}), 2) << "as drawn";
  EXPECT_EQ(kept(MistakeKind::extra, 3, {}), 3) << "without a verdict";
}

TEST(WritingResults, OfAdviceOnlyEndingsAreKept) {
  writing::Grade grade;
  writing::Mistake advice;
  advice.kind = kanji::MistakeKind::order;
  grade.advice.push_back(advice);
  advice.kind = kanji::MistakeKind::ending;
  advice.stroke = 5;
  grade.advice.push_back(advice);
  const auto result = to_result(grade);
  EXPECT_EQ(result.mistakes, (std::vector<study::StrokeMistake>{{kanji::MistakeKind::ending, 5}}));
}

TEST(WritingResults, HandwritingIsSavedInTheGlyphFrameInItsSteps) {
  const study::Handwriting ink = to_handwriting({{{{-0.05, 0.05}, 1, 0}, {{0, 0}, 1.5, 1}}});
  ASSERT_EQ(ink.size(), 1U);
  EXPECT_EQ(ink[0], (study::HandwritingStroke{{{0, 0}, 0, 0}, {{54.5, 54.5}, 0.5, 1}}));
  EXPECT_TRUE(to_handwriting({}).empty());
  EXPECT_TRUE(to_handwriting({{}, {{{0, 0}, 1, 0}}}).empty());
  EXPECT_EQ(to_handwriting({{{{0, 0}, 1, 0}}, {}}).size(), 1U);
}

TEST(WritingResults, NoMoreHandwritingIsSavedThanMayBe) {
  const HandStroke stroke(3, HandPoint{{0, 0}, 1, 0});
  EXPECT_EQ(to_handwriting(std::vector(study::kMostSavedStrokes + 1, stroke)).size(),
            study::kMostSavedStrokes);
  const HandStroke long_one(study::kMostSavedPoints - 3, HandPoint{{0, 0}, 1, 0});
  EXPECT_EQ(to_handwriting({long_one, stroke}).size(), 2U) << "as many as may be";
  EXPECT_EQ(to_handwriting({long_one, stroke, {{{0, 0}, 1, 0}}}).size(), 2U);
}

}  // namespace
}  // namespace nazori::practice
