// SPDX-License-Identifier: Apache-2.0
#include "form.h"

#include <gtest/gtest.h>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

Grade of_deviations(const std::vector<double>& deviations) {
  Grade grade;
  for (const double d : deviations) {
    StrokeVerdict verdict;
    verdict.ok = true;
    verdict.deviation = d;
    grade.strokes.push_back(verdict);
  }
  return grade;
}

Mistake advice(kanji::MistakeKind kind) {
  Mistake mistake;
  mistake.kind = kind;
  return mistake;
}

TEST(Form, IsBestForTheModelItself) { EXPECT_EQ(graded(trace(rest()), model_of(rest())).form, kBestForm); }

TEST(Form, FallsStarByStarAsTheStrokesDeviate) {
  EXPECT_EQ(form_stars(of_deviations({0.06, 0.06})), 5);
  EXPECT_EQ(form_stars(of_deviations({0.09, 0.09})), 4);
  EXPECT_EQ(form_stars(of_deviations({0.15, 0.15})), 3);
  EXPECT_EQ(form_stars(of_deviations({0.22, 0.22})), 2);
  EXPECT_EQ(form_stars(of_deviations({0.5, 0.9})), 1);
}

TEST(Form, LosesAStarForEachStrokeThatStandsOut) {
  auto grade = of_deviations({0, 0, 0, 0});
  grade.advice = {advice(kanji::MistakeKind::wrong)};
  EXPECT_EQ(form_stars(grade), 4);
  grade.advice.push_back(advice(kanji::MistakeKind::wrong));
  EXPECT_EQ(form_stars(grade), 3);
}

TEST(Form, LosesOneStarForEndingsHoweverMany) {
  auto grade = of_deviations({0, 0, 0, 0});
  grade.advice = {advice(kanji::MistakeKind::ending), advice(kanji::MistakeKind::ending)};
  EXPECT_EQ(form_stars(grade), 4);
}

TEST(Form, IsNeverBelowOne) {
  auto grade = of_deviations({0.9});
  grade.advice = {advice(kanji::MistakeKind::wrong), advice(kanji::MistakeKind::ending)};
  EXPECT_EQ(form_stars(grade), 1);
}

TEST(Form, IsNotToldOfARefusedWriting) {
  auto ink = trace(rest());
  ink.strokes.pop_back();
  const auto g = graded(ink, model_of(rest()));
  EXPECT_FALSE(g.accepted);
  EXPECT_FALSE(g.form);
}

TEST(Form, IsNotToldWhileTheCharacterIsBeingWritten) {
  auto ink = trace(rest());
  ink.strokes.pop_back();
  const auto g = grade(ink, model_of(rest()), {.unfinished = true});
  ASSERT_TRUE(g);
  EXPECT_TRUE(g->accepted);
  EXPECT_FALSE(g->form);
}

TEST(Form, IsNotToldOfAnotherCharacter) {
  const std::vector<Model> lookalikes{model_of(samurai())};
  const auto g = grade(trace(samurai()), model_of(soil()), {}, lookalikes);
  ASSERT_TRUE(g);
  EXPECT_FALSE(g->accepted);
  EXPECT_FALSE(g->form);
}

TEST(Form, OfACarelessHandIsTwoStarsBelowACarefulOne) {
  const auto model = model_of(rest());
  const auto careful = graded(shaken(trace(rest()), 0.3, 1), model);
  auto ink = trace(rest());
  for (auto& s : ink.strokes) s = resampled(s, 5);
  const auto careless = graded(shaken(std::move(ink), 4.5, 7), model, kLenient);
  ASSERT_TRUE(careful.form);
  ASSERT_TRUE(careless.form);
  EXPECT_GE(*careful.form, *careless.form + 2);
}

}  // namespace
}  // namespace nazori::writing::test
