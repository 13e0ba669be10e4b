// SPDX-License-Identifier: Apache-2.0
#include "study/writing_results.h"

#include <gtest/gtest.h>

namespace nazori::ui {
namespace {

TEST(WritingResults, InkGoesOnInTimeWhereTheClockBeginsAnew) {
  const std::vector<practice::HandStroke> strokes{{{{0, 0}, 5.0, 0.5}, {{0.01, 0}, 5.1, 0.5}},
                                                  {{{0, 0.01}, 0.02, 0.5}, {{0, 0.02}, 5.25, 0.5}}};
  const study::Ink ink = to_study_ink(strokes);
  std::vector<std::int32_t> times_ms;
  for (const auto& stroke : ink.strokes)
    for (const auto& point : stroke) times_ms.push_back(point.time_ms);
  EXPECT_EQ(times_ms, (std::vector<std::int32_t>{0, 100, 100, 250}));
  EXPECT_TRUE(study::pack(ink)) << "it can be kept";
}

TEST(WritingResults, EveryFaultIsKeptUnderItsName) {
  using writing::FaultKind;
  const std::pair<FaultKind, study::FaultKind> kinds[] = {
      {FaultKind::order, study::FaultKind::order},     {FaultKind::reversed, study::FaultKind::reversed},
      {FaultKind::missing, study::FaultKind::missing}, {FaultKind::extra, study::FaultKind::extra},
      {FaultKind::joined, study::FaultKind::joined},   {FaultKind::split, study::FaultKind::split},
      {FaultKind::wrong, study::FaultKind::wrong},     {FaultKind::other, study::FaultKind::other},
      {FaultKind::ending, study::FaultKind::ending}};
  writing::Grade grade;
  grade.accepted = true;
  grade.score = 63;
  for (const auto& [kind, kept] : kinds) {
    writing::Fault fault;
    fault.kind = kind;
    grade.faults.push_back(fault);
  }
  const auto result = to_result(grade);
  EXPECT_TRUE(result.accepted);
  EXPECT_EQ(result.score, 63);
  ASSERT_EQ(result.faults.size(), std::size(kinds));
  for (std::size_t i = 0; i < std::size(kinds); ++i) EXPECT_EQ(result.faults[i].kind, kinds[i].second) << i;
  grade.accepted = false;
  EXPECT_FALSE(to_result(grade).accepted);
}

TEST(WritingResults, AFaultIsKeptByTheStrokeOfTheModelWhereThatIsKnown) {
  writing::Grade grade;
  grade.strokes.resize(3);
  grade.strokes[1].matched = 4;
  const auto kept = [&grade](writing::FaultKind kind, int stroke, std::vector<int> model) {
    writing::Fault fault;
    fault.kind = kind;
    fault.stroke = stroke;
    fault.model = std::move(model);
    grade.faults = {fault};
    return to_result(grade).faults.front().stroke;
  };
  using writing::FaultKind;
  EXPECT_EQ(kept(FaultKind::missing, 1, {2}), 1) << "a missing stroke is one of the model";
  EXPECT_EQ(kept(FaultKind::wrong, 1, {2, 3}), 2) << "the first that it is about";
  EXPECT_EQ(kept(FaultKind::wrong, 1, {}), 4) << "what it matches";
  EXPECT_EQ(kept(FaultKind::extra, 2, {}), 2) << "as drawn";
  EXPECT_EQ(kept(FaultKind::extra, 3, {}), 3) << "without a verdict";
}

TEST(WritingResults, OfAdviceOnlyEndingsAreKept) {
  writing::Grade grade;
  writing::Fault advice;
  advice.kind = writing::FaultKind::order;
  grade.advice.push_back(advice);
  advice.kind = writing::FaultKind::ending;
  advice.stroke = 5;
  grade.advice.push_back(advice);
  const auto result = to_result(grade);
  EXPECT_EQ(result.faults, (std::vector<study::StrokeFault>{{study::FaultKind::ending, 5}}));
}

TEST(WritingResults, InkIsKeptInTheGlyphFrame) {
  const study::Ink ink = to_study_ink({{{{-0.05, 0.05}, 1, 0}, {{0, 0}, 1.5, 1}}});
  ASSERT_EQ(ink.strokes.size(), 1U);
  EXPECT_EQ(ink.strokes[0],
            (study::InkStroke{study::ink_point({0, 0}, 0, 0), study::ink_point({54.5, 54.5}, 500, 1)}));
  EXPECT_TRUE(to_study_ink({}).strokes.empty());
  EXPECT_TRUE(to_study_ink({{}, {{{0, 0}, 1, 0}}}).strokes.empty());
  EXPECT_EQ(to_study_ink({{{{0, 0}, 1, 0}}, {}}).strokes.size(), 1U);
}

TEST(WritingResults, NoMoreInkIsKeptThanMayBe) {
  const practice::HandStroke stroke(3, practice::HandPoint{{0, 0}, 1, 0});
  EXPECT_EQ(to_study_ink(std::vector(study::kMostInkStrokes + 1, stroke)).strokes.size(),
            study::kMostInkStrokes);
  const practice::HandStroke long_one(study::kMostInkPoints - 3, practice::HandPoint{{0, 0}, 1, 0});
  EXPECT_EQ(to_study_ink({long_one, stroke}).strokes.size(), 2U) << "as many as may be";
  EXPECT_EQ(to_study_ink({long_one, stroke, {{{0, 0}, 1, 0}}}).strokes.size(), 2U);
}

}  // namespace
}  // namespace nazori::ui
