// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/motion_remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

using testing::IsEmpty;

/// Share of the way by time, 0..1 each.
using Pace = std::function<double(double)>;

/// A hand that speeds up, slows down and rests before it lifts the pen.
double stops(double t) {
  const double u = std::min(t / 0.8, 1.0);
  return u * u * (3 - 2 * u);
}
/// A hand that goes faster and faster.
double sweeps(double t) { return t * t; }
/// Half of the way, a rest of half of the time, the other half.
double rests_half_way(double t) {
  if (t < 0.25) return stops(t / 0.25) / 2;
  return t < 0.7 ? 0.5 : 0.5 + stops((t - 0.7) / 0.3) / 2;
}

WrittenStroke timed(const WrittenStroke& stroke, double begin_s, double duration_s, const Pace& pace,
                    const Pace& pressure = {}) {
  const auto way = resampled(stroke, 400);
  WrittenStroke out;
  constexpr int kSteps = 200;
  for (int k = 0; k <= kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    out.push_back(way[static_cast<std::size_t>(std::lround(pace(t) * 399))]);
    out.back().time_s = begin_s + t * duration_s;
    if (pressure) out.back().pressure = pressure(t);
  }
  return out;
}

/// 休 as taught: sweep, stop, stop, stop, sweep, sweep.
kanji::Character rest_with_endings() {
  auto character = rest();
  using enum kanji::StrokeEnding;
  const kanji::StrokeEnding endings[] = {taper, stop, stop, stop, taper, taper};
  for (std::size_t k = 0; k < 6; ++k) character.strokes[k].line.ending = endings[k];
  return character;
}

struct Told {
  std::vector<PenMotion> motions;
  std::vector<MotionRemark> remarks;
};

Told told(const WrittenCharacter& ink) {
  const auto model = model_of(rest_with_endings());
  Told t;
  t.motions = pen_motion(ink);
  t.remarks = motion_remarks(t.motions, graded(ink, model), model);
  return t;
}

/// Each stroke takes 0.7 s, one begins every second.
WrittenCharacter written_with_endings() {
  auto ink = trace(rest());
  const auto character = rest_with_endings();
  for (std::size_t k = 0; k < ink.strokes.size(); ++k) {
    const bool sweep = character.strokes[k].line.ending == kanji::StrokeEnding::taper;
    ink.strokes[k] = timed(ink.strokes[k], static_cast<double>(k), 0.7, sweep ? Pace(sweeps) : Pace(stops));
  }
  return ink;
}

TEST(MotionRemarks, ThereIsNothingToSayOfAFluentHandThatEndsItsStrokesRight) {
  const auto t = told(written_with_endings());
  EXPECT_THAT(t.remarks, IsEmpty());
  EXPECT_EQ(explain_pace(t.motions, t.remarks, Language::english),
            "Written in 5.7 seconds. 6 of 6 strokes were smooth.");
  EXPECT_EQ(explain_pace(t.motions, t.remarks, Language::japanese),
            "5.7秒で書きました。6画のうち6画がなめらかでした。");
}

TEST(MotionRemarks, ARestWithinAStrokeIsAPauseThatIsNotOneAtItsEnd) {
  auto ink = written_with_endings();
  ink.strokes[2] = timed(trace(rest()).strokes[2], 2, 1.4, rests_half_way);
  const auto t = told(ink);
  ASSERT_EQ(t.remarks.size(), 1U);
  EXPECT_EQ(t.remarks[0].kind, MotionRemarkKind::paused);
  EXPECT_EQ(t.remarks[0].stroke, 2);
  EXPECT_NEAR(t.remarks[0].amount, 0.63, 0.15);
  EXPECT_THAT(explain(t.remarks, Language::english),
              testing::ElementsAre(testing::StartsWith("You paused in stroke 3 (up to 0.")));
  EXPECT_THAT(explain_pace(t.motions, t.remarks, Language::english),
              testing::EndsWith(" 5 of 6 strokes were smooth."));
}

TEST(MotionRemarks, ARestBeforeTheFirstMoveIsNoPause) {
  auto ink = written_with_endings();
  const auto rests_first = [](double t) { return t < 0.5 ? 0.0 : stops((t - 0.5) / 0.5); };
  ink.strokes[2] = timed(trace(rest()).strokes[2], 2, 1.4, rests_first);
  for (const MotionRemark& remark : told(ink).remarks) EXPECT_NE(remark.kind, MotionRemarkKind::paused);
}

TEST(MotionRemarks, AStrokeOfManyShortMovesIsHesitant) {
  auto ink = written_with_endings();
  ink.strokes[3] = timed(trace(rest()).strokes[3], 3, 4, [](double t) {
    return std::clamp(t + 0.015 * std::sin(9 * 2 * 3.14159265 * t), 0.0, 1.0);
  });
  const auto t = told(ink);
  ASSERT_FALSE(t.remarks.empty());
  EXPECT_EQ(t.remarks[0].kind, MotionRemarkKind::hesitant);
  EXPECT_NEAR(t.remarks[0].amount, 9, 1);
}

TEST(MotionRemarks, EachEndingIsAskedForInItsOwnWay) {
  auto ink = written_with_endings();
  ink.strokes[0] = timed(trace(rest()).strokes[0], 0, 0.7, stops);
  ink.strokes[1] = timed(trace(rest()).strokes[1], 1, 0.7, sweeps);
  const auto t = told(ink);
  ASSERT_EQ(t.remarks.size(), 2U);
  EXPECT_THAT(explain(t.remarks, Language::english),
              testing::ElementsAre("Let stroke 1 trail off: lift the pen while it is still moving.",
                                   "End stroke 2 with a stop: hold the pen still before you lift it."));
  EXPECT_EQ(explain(t.remarks, Language::japanese).back(),
            "2画目は、とめます。ペンを止めてから離しましょう。");
}

TEST(MotionRemarks, PressureThatDoesNotFadeInASweepIsTold) {
  auto ink = written_with_endings();
  ink.strokes[5] = timed(trace(rest()).strokes[5], 5, 0.7, sweeps, [](double t) { return 0.3 + 0.4 * t; });
  const auto t = told(ink);
  ASSERT_EQ(t.remarks.size(), 1U);
  EXPECT_EQ(t.remarks[0].kind, MotionRemarkKind::heavy_end);
  EXPECT_EQ(t.remarks[0].model, 5);
}

TEST(MotionRemarks, TheSamePressureThroughoutIsAMouseAndSaysNothing) {
  auto ink = written_with_endings();
  ink.strokes[5] = timed(trace(rest()).strokes[5], 5, 0.7, sweeps, [](double) { return 0.5; });
  EXPECT_THAT(told(ink).remarks, IsEmpty());
}

TEST(MotionRemarks, WhatIsNotTimedIsNotSpokenOf) {
  const auto t = told(trace(rest()));
  EXPECT_THAT(t.remarks, IsEmpty());
  EXPECT_EQ(explain_pace(t.motions, t.remarks, Language::english), "");
}

TEST(MotionRemarks, TheSameRemarkOnSeveralStrokesIsOneSentence) {
  auto ink = written_with_endings();
  for (const std::size_t k : {0U, 4U, 5U})
    ink.strokes[k] = timed(trace(rest()).strokes[k], static_cast<double>(k), 0.7, stops);
  const auto t = told(ink);
  EXPECT_EQ(t.remarks.size(), 3U);
  EXPECT_THAT(
      explain(t.remarks, Language::english),
      testing::ElementsAre("Let strokes 1, 5 and 6 trail off: lift the pen while it is still moving."));
  EXPECT_THAT(explain(t.remarks, Language::japanese),
              testing::ElementsAre("1・5・6画目は、はらいます。動かしながらペンを離しましょう。"));
}

TEST(MotionRemarks, EveryRemarkIsASentenceInEveryLanguage) {
  for (int kind = 0; kind <= static_cast<int>(MotionRemarkKind::light_end); ++kind) {
    const std::vector remarks{MotionRemark{static_cast<MotionRemarkKind>(kind), 1, 2, 0.8}};
    const auto english = explain(remarks, Language::english).front();
    const auto japanese = explain(remarks, Language::japanese).front();
    EXPECT_THAT(english, testing::AllOf(testing::EndsWith("."), testing::HasSubstr("3"))) << english;
    EXPECT_THAT(japanese, testing::AllOf(testing::EndsWith("。"), testing::HasSubstr("3"))) << japanese;
    EXPECT_EQ((english + japanese).find('{'), std::string::npos) << english;
  }
}

}  // namespace
}  // namespace nazori::writing::test
