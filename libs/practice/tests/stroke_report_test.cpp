// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stroke_report.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace nazori::practice {
namespace {

using kanji::MistakeKind;

writing::StrokeVerdict verdict(std::optional<int> matched, bool ok = true) {
  writing::StrokeVerdict made;
  made.ok = ok;
  made.matched = matched;
  return made;
}

writing::Mistake mistake(MistakeKind kind, int stroke, std::optional<int> second = {}) {
  writing::Mistake made;
  made.kind = kind;
  made.stroke = stroke;
  made.second = second;
  return made;
}

writing::Grade grade_of(std::vector<writing::StrokeVerdict> strokes,
                        std::vector<writing::Mistake> mistakes = {},
                        std::vector<writing::Mistake> advice = {}) {
  writing::Grade grade;
  grade.strokes = std::move(strokes);
  grade.mistakes = std::move(mistakes);
  grade.advice = std::move(advice);
  return grade;
}

TEST(StrokeReport, ARightStrokeIsNamedWithWhatIsLeft) {
  const StrokeReport report = report_on_last_stroke(grade_of({verdict(0), verdict(1)}), 2, 4);
  EXPECT_EQ(report.feedback.event, StageEvent::stroke_right);
  EXPECT_EQ(report.feedback.tone, Tone::good);
  EXPECT_EQ(report.feedback.stroke, 2);
  EXPECT_EQ(report.feedback.count, 2);
  EXPECT_EQ(report.feedback.other, 0);
  EXPECT_FALSE(report.is_mistake);
  EXPECT_FALSE(report.can_be_tried_again);
}

TEST(StrokeReport, WhatWasPassedOverIsNamedAsLongAsItIsMissing) {
  const StrokeReport passed = report_on_last_stroke(grade_of({verdict(0), verdict(2)}), 2, 4);
  EXPECT_EQ(passed.feedback.event, StageEvent::stroke_right_other_missing);
  EXPECT_EQ(passed.feedback.tone, Tone::advice);
  EXPECT_EQ(passed.feedback.stroke, 3);
  EXPECT_EQ(passed.feedback.other, 2);
  EXPECT_FALSE(passed.is_mistake);
  // What comes later is not missing yet.
  EXPECT_EQ(report_on_last_stroke(grade_of({verdict(0)}), 1, 4).feedback.event, StageEvent::stroke_right);
  EXPECT_EQ(report_on_last_stroke(grade_of({verdict(1), verdict(0)}), 2, 2).feedback.event,
            StageEvent::stroke_right);
}

TEST(StrokeReport, AMistakeOfTheLastStrokeIsToldAndMayBeTriedAgain) {
  for (const MistakeKind kind : {MistakeKind::reversed, MistakeKind::order, MistakeKind::wrong}) {
    const StrokeReport report =
        report_on_last_stroke(grade_of({verdict(0), verdict(1, false)}, {mistake(kind, 1)}), 2, 3);
    EXPECT_EQ(report.feedback.event, StageEvent::mistake);
    EXPECT_EQ(report.feedback.tone, Tone::wrong);
    ASSERT_TRUE(report.feedback.mistake);
    EXPECT_EQ(report.feedback.mistake->kind, kind);
    EXPECT_TRUE(report.is_mistake);
    EXPECT_EQ(report.can_be_tried_again, kind != MistakeKind::order) << "an order is not of one stroke";
  }
}

TEST(StrokeReport, MistakesOfOtherStrokesAndMissingOnesAreNotOfTheLast) {
  const auto event = [](const writing::Mistake& one) {
    return report_on_last_stroke(grade_of({verdict(0), verdict(1)}, {one}), 2, 3).feedback.event;
  };
  EXPECT_EQ(event(mistake(MistakeKind::reversed, 0)), StageEvent::stroke_right);
  EXPECT_EQ(event(mistake(MistakeKind::missing, 1)), StageEvent::stroke_right)
      << "the number is that of a stroke of the model";
  EXPECT_EQ(event(mistake(MistakeKind::order, 0, 1)), StageEvent::stroke_right) << "the last one is right";
}

TEST(StrokeReport, AnExchangeMayShowOnlyWithItsSecondStroke) {
  const StrokeReport report = report_on_last_stroke(
      grade_of({verdict(1), verdict(0, false)}, {mistake(MistakeKind::order, 0, 1)}), 2, 3);
  EXPECT_EQ(report.feedback.event, StageEvent::mistake);
  EXPECT_FALSE(report.can_be_tried_again);
}

TEST(StrokeReport, AWrongStrokeWithoutAMistakeIsNotOfTheCharacter) {
  const StrokeReport none = report_on_last_stroke(grade_of({verdict(std::nullopt, false)}), 1, 3);
  EXPECT_EQ(none.feedback.event, StageEvent::not_of_character);
  EXPECT_EQ(none.feedback.tone, Tone::wrong);
  EXPECT_TRUE(none.is_mistake);
  EXPECT_TRUE(none.can_be_tried_again);
  const StrokeReport matched = report_on_last_stroke(grade_of({verdict(2, false)}), 1, 3);
  EXPECT_EQ(matched.feedback.event, StageEvent::not_of_character);
  EXPECT_FALSE(matched.can_be_tried_again) << "it is one of the character";
}

TEST(StrokeReport, AdviceIsThatOfTheLastStroke) {
  const auto advice = [](int stroke) {
    return report_on_last_stroke(
        grade_of({verdict(0), verdict(1)}, {}, {mistake(MistakeKind::ending, stroke)}), 2, 2);
  };
  EXPECT_EQ(advice(1).feedback.event, StageEvent::stroke_advice);
  EXPECT_EQ(advice(1).feedback.tone, Tone::advice);
  EXPECT_EQ(advice(1).feedback.mistake->kind, MistakeKind::ending);
  EXPECT_FALSE(advice(1).is_mistake);
  EXPECT_EQ(advice(0).feedback.event, StageEvent::stroke_right);
}

TEST(StrokeReport, AStrokeThatIsNotGradedYetCountsByItsNumber) {
  const StrokeReport report = report_on_last_stroke(grade_of({verdict(0)}), 2, 3);
  EXPECT_EQ(report.feedback.event, StageEvent::stroke_right);
  EXPECT_EQ(report.feedback.stroke, 2);
  EXPECT_EQ(report.feedback.count, 2);
}

TEST(ExpectedStroke, IsTheFirstThatWasMissingBeforeTheLast) {
  EXPECT_EQ(expected_stroke(grade_of({verdict(0), verdict(2)}), 2, 3), 1);
  EXPECT_EQ(expected_stroke(grade_of({verdict(0), verdict(1)}), 2, 3), 1) << "which was written";
  EXPECT_EQ(expected_stroke(grade_of({verdict(0)}), 2, 3), 1) << "the last is not graded yet";
  EXPECT_EQ(expected_stroke(grade_of({verdict(0), verdict(std::nullopt, false)}), 2, 1), 0) << "none";
}

}  // namespace
}  // namespace nazori::practice
