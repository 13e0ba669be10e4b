// SPDX-License-Identifier: Apache-2.0
// From where on something is said of the pen: the table of docs/writing.md, on both sides of each figure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "drawing.h"
#include "nazori/writing/motion_remarks.h"
#include "nazori/writing/pen_motion.h"

namespace nazori::writing::test {
namespace {

using Kind = MotionRemarkKind;
using testing::ElementsAre;
using testing::IsEmpty;

/// Speeds that each hold for some time, along x, at 200 Hz.
struct Pace {
  double speed, seconds;
};
WrittenStroke paced(const std::vector<Pace>& paces, double begin_s = 0) {
  WrittenStroke s = along({{0, 0}}, {begin_s});
  double x = 0;
  double time_s = begin_s;
  for (const auto& [speed, seconds] : paces) {
    const int steps = static_cast<int>(std::lround(seconds * 200));
    for (int k = 0; k < steps; ++k) {
      x += speed / 200;
      time_s += 0.005;
      s.push_back({{x, 0}, time_s});
    }
  }
  return s;
}
PenMotion motion_of(const std::vector<Pace>& paces) { return pen_motion({{paced(paces)}, {}}).front(); }

TEST(Pauses, AreRestsOfMoreThanAFifthOfASecondBlurredByTheSmoothing) {
  // Smoothed over 60 ms, 30 ms on either side of a move do not belong to the rest.
  const auto rest = [](double seconds) { return motion_of({{100, 0.5}, {0, seconds}, {100, 0.5}}).pauses; };
  EXPECT_THAT(rest(0.2), IsEmpty());
  const auto pauses = rest(0.22);
  ASSERT_EQ(pauses.size(), 1U);
  EXPECT_NEAR(pauses[0].start_s, 0.53, 0.011);
  EXPECT_NEAR(pauses[0].duration_s, 0.16, 0.021);
  EXPECT_NEAR(rest(1).at(0).duration_s, 0.94, 0.021);
}

TEST(Pauses, AtEitherEndTouchOneMoveOnly) {
  const auto pauses = motion_of({{0, 0.4}, {100, 0.5}, {0, 0.3}}).pauses;
  ASSERT_EQ(pauses.size(), 2U);
  EXPECT_EQ(pauses[0].start_s, 0);
  EXPECT_NEAR(pauses[0].duration_s, 0.37, 0.011);
  EXPECT_NEAR(pauses[1].start_s, 0.93, 0.011);
  EXPECT_NEAR(pauses[1].duration_s, 0.27, 0.011);
}

TEST(Pauses, AreWhereThePenHardlyMoves) {
  const auto slow = [](double speed) {
    return motion_of({{100, 0.5}, {speed, 0.5}, {100, 0.5}}).pauses.size();
  };
  EXPECT_EQ(slow(4), 1U);
  EXPECT_EQ(slow(6), 0U);
}

TEST(SpeedPeaks, RiseATenthOfTheGreatestSpeedAboveTheValleysBesideThem) {
  const auto peaks = [](std::vector<double> speeds) {
    std::vector<Pace> paces;
    for (const double speed : speeds) paces.push_back({speed, 0.3});
    return motion_of(paces).speed_peaks;
  };
  EXPECT_EQ(peaks({100}), 1);
  EXPECT_EQ(peaks({0}), 0) << "it did not move";
  EXPECT_EQ(peaks({20, 100}), 1) << "swept off on its peak";
  EXPECT_EQ(peaks({100, 20}), 1);
  EXPECT_EQ(peaks({100, 88, 100}), 2);
  EXPECT_EQ(peaks({100, 92, 100}), 1);
  EXPECT_EQ(peaks({100, 80, 88}), 1) << "too little of a rise";
  EXPECT_EQ(peaks({100, 80, 92}), 2);
  EXPECT_EQ(peaks({100, 80, 92, 84, 100}), 2) << "a dip of less than a tenth";
  EXPECT_EQ(peaks({50, 100, 50, 100, 50, 100, 50}), 3);
}

TEST(SpeedPeaks, NeedThreeHundredthsOfASecond) {
  WrittenStroke s = along({{0, 0}, {5, 0}}, {1, 1.029});
  EXPECT_EQ(pen_motion({{s}, {}}).front().speed_peaks, 0);
  s[1].time_s = 1.031;
  EXPECT_EQ(pen_motion({{s}, {}}).front().speed_peaks, 1);
}

TEST(EndSpeed, IsTheLastByTheMean) {
  EXPECT_NEAR(motion_of({{100, 0.5}}).speed_at_end, 1, 1e-6);
  EXPECT_NEAR(motion_of({{100, 0.5}, {200, 0.5}}).speed_at_end, 200 / 150.0, 0.01);
  EXPECT_NEAR(motion_of({{100, 0.9}, {0, 0.1}}).speed_at_end, 0, 1e-6);
  EXPECT_EQ(motion_of({{0, 0.5}}).speed_at_end, 0);
  // Points at uneven times: 500 a second for a fifth of the time, then 100.
  const WrittenStroke uneven = along({{0, 0}, {100, 0}, {180, 0}}, {3, 3.2, 4});
  const auto m = pen_motion({{uneven}, {}}).front();
  EXPECT_NEAR(m.speed_at_end, 100 / 180.0, 0.01);
  EXPECT_NEAR(m.mean_speed, 180, 1e-6);
  EXPECT_NEAR(m.duration_s, 1, 1e-12);
  const WrittenStroke standing = along({{0, 0}, {50, 0}, {50, 0}, {100, 0}}, {0, 0.5, 0.5, 1});
  EXPECT_NEAR(pen_motion({{standing}, {}}).front().speed_at_end, 1, 1e-3) << "two points of one time";
}

TEST(PenLifts, AreSweptWhereThePenMovesFasterThanTwoFifthsOfTheMean) {
  const auto lift = [](double speed) { return motion_of({{100, 0.8}, {speed, 0.2}}).lift; };
  EXPECT_EQ(lift(50), PenLift::swept);
  EXPECT_EQ(lift(30), PenLift::stopped);
}

TEST(PenLifts, AreSweptWhereThePressureFadesToHalfTheMean) {
  const auto motion = [](double at_end) {
    WrittenStroke s;
    for (int k = 0; k <= 100; ++k) {
      s.push_back({{static_cast<double>(k), 0}, {}, k < 90 ? 0.8 : at_end});
    }
    return pen_motion({{s}, {}}).front();
  };
  EXPECT_EQ(motion(0.36).lift, PenLift::swept) << "0.48 of the mean";
  EXPECT_EQ(motion(0.4).lift, PenLift::stopped) << "0.53 of it";
  EXPECT_NEAR(*motion(0.4).pressure_at_end, 0.4, 1e-12) << "over the last tenth";
  EXPECT_NEAR(*motion(0.4).pressure, (90 * 0.8 + 11 * 0.4) / 101, 1e-12);
  EXPECT_NEAR(motion(0.4).pressure_range, 0.4, 1e-12);
  EXPECT_NEAR(motion(0.9).pressure_range, 0.1, 1e-12);
  EXPECT_FALSE(motion_of({{100, 1}}).pressure);
  EXPECT_EQ(motion_of({{100, 1}}).pressure_range, 0);
}

TEST(PausesBefore, AreBetweenTimedStrokes) {
  const std::vector<WrittenStroke> strokes{paced({{100, 1}}, 2), along({{0, 0}, {1, 1}}),
                                           paced({{100, 1}}, 3.5)};
  const auto m = pen_motion({strokes, {}});
  EXPECT_EQ(m[0].pause_before_s, 0);
  EXPECT_EQ(m[1].pause_before_s, 0);
  EXPECT_EQ(m[1].duration_s, 0);
  EXPECT_EQ(m[1].lift, PenLift::unknown);
  EXPECT_NEAR(m[2].pause_before_s, 0.5, 1e-9);
  EXPECT_NEAR(m[2].duration_s, 1, 1e-9);
}

// The remarks.

/// 目, of which the second stroke turns by a quarter, all with this ending.
kanji::Character with_ending(kanji::StrokeEnding ending) {
  auto c = eye();
  for (auto& s : c.strokes) s.line.ending = ending;
  return c;
}

/// The remarks about one stroke of 目.
std::vector<Kind> said(const PenMotion& motion, kanji::StrokeEnding ending, int stroke = 0, bool ok = true) {
  Grade grade;
  grade.strokes.resize(1);
  grade.strokes[0].matched = stroke;
  grade.strokes[0].ok = ok;
  const auto remarks = motion_remarks(std::vector<PenMotion>{motion}, grade, model_of(with_ending(ending)));
  std::vector<Kind> kinds;
  for (const auto& r : remarks) {
    kinds.push_back(r.kind);
    EXPECT_EQ(r.stroke, 0);
    EXPECT_EQ(r.model, stroke);
  }
  return kinds;
}

PenMotion calm() {
  PenMotion m;
  m.duration_s = 2;
  m.speed_peaks = 1;
  m.speed_at_end = 0.5;
  return m;
}

constexpr auto kStop = kanji::StrokeEnding::stop;
constexpr auto kTaper = kanji::StrokeEnding::taper;
constexpr auto kHook = kanji::StrokeEnding::hook;
constexpr auto kEither = kanji::StrokeEnding::either;

TEST(PauseRemark, IsMadeFromTwoFifthsOfASecondOnAwayFromTheEnds) {
  const auto with = [](std::vector<Pause> pauses) {
    auto m = calm();
    m.pauses = std::move(pauses);
    return said(m, kStop);
  };
  EXPECT_THAT(with({{1, 0.39}}), IsEmpty());
  EXPECT_THAT(with({{1, 0.4}}), ElementsAre(Kind::paused));
  EXPECT_THAT(with({{0.04, 0.5}}), IsEmpty()) << "the pen came down";
  EXPECT_THAT(with({{0.06, 0.5}}), ElementsAre(Kind::paused));
  EXPECT_THAT(with({{1.4, 0.56}}), IsEmpty()) << "the pen stopped";
  EXPECT_THAT(with({{1.4, 0.54}}), ElementsAre(Kind::paused));
  EXPECT_THAT(with({{0, 0.9}, {1, 0.3}}), IsEmpty());
  EXPECT_THAT(with({{0.2, 0.45}, {1, 0.3}}), ElementsAre(Kind::paused));
}

TEST(PauseRemark, TellsTheLongestRestAndNotTheShortMovesBesideIt) {
  auto m = calm();
  m.speed_peaks = 30;
  m.pauses = {{0.2, 0.45}, {0.8, 0.6}, {1.5, 0.41}, {0, 1.9}};
  Grade grade;
  grade.strokes.resize(2);
  grade.strokes[1].matched = 3;
  const auto remarks = motion_remarks(std::vector<PenMotion>{calm(), m}, grade, model_of(with_ending(kStop)));
  EXPECT_THAT(remarks, ElementsAre(MotionRemark{Kind::paused, 1, 3, 0.6}));
}

TEST(ShortMoves, AreMoreThanFourPeaksAndThreeMoreForEachQuarterTurn) {
  const auto with = [](int peaks, int stroke) {
    auto m = calm();
    m.speed_peaks = peaks;
    return said(m, kStop, stroke);
  };
  EXPECT_THAT(with(4, 2), IsEmpty());
  EXPECT_THAT(with(5, 2), ElementsAre(Kind::hesitant));
  EXPECT_THAT(with(7, 1), IsEmpty()) << "one corner";
  EXPECT_THAT(with(8, 1), ElementsAre(Kind::hesitant));
}

/// With a pressure at the end of so much of the mean.
PenMotion pressed(PenMotion m, double left, double range = 0.2) {
  m.pressure = 0.4;
  m.pressure_at_end = 0.4 * left;
  m.pressure_range = range;
  return m;
}
PenMotion ending_at(double speed) {
  auto m = calm();
  m.speed_at_end = speed;
  return m;
}
PenMotion untimed() {
  auto m = calm();
  m.speed_peaks = 0;
  m.speed_at_end = 0;
  return m;
}

TEST(StopRemark, IsMadeAboveTheMeanSpeedOrWhereThePressureHadFaded) {
  EXPECT_THAT(said(ending_at(0.98), kStop), IsEmpty());
  EXPECT_THAT(said(ending_at(1.02), kStop), ElementsAre(Kind::not_stopped));
  EXPECT_THAT(said(pressed(ending_at(0), 0.36), kStop), IsEmpty());
  EXPECT_THAT(said(pressed(ending_at(0), 0.34), kStop), ElementsAre(Kind::light_end));
  EXPECT_THAT(said(pressed(ending_at(2), 0.1), kStop), ElementsAre(Kind::not_stopped))
      << "one remark on an ending";
  EXPECT_THAT(said(pressed(untimed(), 0.34), kStop), ElementsAre(Kind::light_end));
  EXPECT_THAT(said(untimed(), kStop), IsEmpty());
}

TEST(SweepRemark, IsMadeWhereThePenCameToRestOrThePressureStayed) {
  EXPECT_THAT(said(ending_at(0.16), kTaper), IsEmpty());
  EXPECT_THAT(said(ending_at(0.14), kTaper), ElementsAre(Kind::not_swept));
  EXPECT_THAT(said(pressed(ending_at(0.14), 0.34), kTaper), IsEmpty()) << "the pressure faded";
  EXPECT_THAT(said(pressed(ending_at(0.14), 0.36), kTaper), ElementsAre(Kind::not_swept));
  EXPECT_THAT(said(pressed(ending_at(1), 0.84), kTaper), IsEmpty());
  EXPECT_THAT(said(pressed(ending_at(1), 0.86), kTaper), ElementsAre(Kind::heavy_end));
  EXPECT_THAT(said(pressed(untimed(), 0.86), kTaper), ElementsAre(Kind::heavy_end));
  EXPECT_THAT(said(untimed(), kTaper), IsEmpty());
}

TEST(PressureRemarks, AreMadeOnlyWhereThePressureVaries) {
  EXPECT_THAT(said(pressed(ending_at(1), 0.95, 0.081), kTaper), ElementsAre(Kind::heavy_end));
  EXPECT_THAT(said(pressed(ending_at(1), 0.95, 0.079), kTaper), IsEmpty());
  auto m = pressed(ending_at(1), 0.95);
  m.pressure_at_end.reset();
  EXPECT_THAT(said(m, kTaper), IsEmpty());
}

TEST(KickRemark, IsMadeWhereThePenRestedAfterAKickOfTheModel) {
  auto character = with_ending(kHook);
  auto& hooked = character.strokes[2].line.points;
  hooked.push_back({hooked.back().x - 6, hooked.back().y - 8});
  const auto remark = [&](const PenMotion& motion, int stroke) {
    Grade grade;
    grade.strokes.resize(1);
    grade.strokes[0].matched = stroke;
    grade.strokes[0].ok = true;
    return motion_remarks(std::vector<PenMotion>{motion}, grade, model_of(character));
  };
  EXPECT_THAT(remark(ending_at(0.14), 2), ElementsAre(MotionRemark{Kind::kick_held, 0, 2, 0}));
  EXPECT_THAT(remark(ending_at(0.16), 2), IsEmpty());
  EXPECT_THAT(remark(pressed(ending_at(0.14), 0.34), 2), IsEmpty());
  EXPECT_THAT(remark(untimed(), 2), IsEmpty());
  EXPECT_THAT(remark(ending_at(0.14), 3), IsEmpty()) << "the model's own line has no kick";
}

TEST(EndingRemarks, AreMadeOfRightStrokesWhoseEndingIsNotFree) {
  EXPECT_THAT(said(ending_at(2), kStop, 0, false), IsEmpty());
  EXPECT_THAT(said(ending_at(2), kEither), IsEmpty());
  auto paused = ending_at(2);
  paused.pauses = {{1, 0.5}};
  EXPECT_THAT(said(paused, kStop), ElementsAre(Kind::paused, Kind::not_stopped))
      << "one on the flow, one on the ending";
  EXPECT_THAT(said(paused, kStop, 0, false), ElementsAre(Kind::paused));
  auto free = with_ending(kStop);
  free.strokes[0].type = "㇑/㇚";
  Grade grade;
  grade.strokes.resize(1);
  grade.strokes[0].matched = 0;
  grade.strokes[0].ok = true;
  EXPECT_THAT(motion_remarks(std::vector<PenMotion>{ending_at(2)}, grade, model_of(free)), IsEmpty());
}

TEST(MotionRemarksOf, StrokesThatAreNoneOfTheModelSayNothing) {
  Grade grade;
  grade.strokes.resize(2);
  for (auto& s : grade.strokes) s.ok = true;
  grade.strokes[1].matched = 5;
  const std::vector<PenMotion> motions(3, ending_at(2));
  EXPECT_THAT(motion_remarks(motions, grade, model_of(with_ending(kStop))), IsEmpty());
  grade.strokes[1].matched = 4;
  EXPECT_THAT(motion_remarks(motions, grade, model_of(with_ending(kStop))),
              ElementsAre(MotionRemark{Kind::not_stopped, 1, 4, 0}));
}

TEST(MotionRemarksOf, AVariantFollowItsOwnForm) {
  auto variant = with_ending(kTaper);
  variant.variant = "Other";
  const auto model = Model::make(with_ending(kStop), std::vector{variant});
  ASSERT_TRUE(model);
  Grade grade;
  grade.strokes.resize(1);
  grade.strokes[0].matched = 0;
  grade.strokes[0].ok = true;
  const std::vector<PenMotion> motions{ending_at(2)};
  EXPECT_EQ(motion_remarks(motions, grade, *model).size(), 1U);
  grade.variant = "Other";
  EXPECT_THAT(motion_remarks(motions, grade, *model), IsEmpty());
  grade.variant = "Unknown";
  EXPECT_EQ(motion_remarks(motions, grade, *model).size(), 1U);
}

TEST(PaceSentence, CountsTheStrokesThatFlowedAndAllTheTime) {
  std::vector<PenMotion> motions(3, calm());
  motions[1].pause_before_s = 0.75;
  const std::vector<MotionRemark> remarks{
      {Kind::paused, 0, 0, 1}, {Kind::not_swept, 1, 1, 0}, {Kind::hesitant, 2, 2, 9}};
  EXPECT_EQ(explain_pace(motions, remarks, Language::english),
            "Written in 6.8 seconds. 1 of 3 strokes were smooth.");
}

TEST(RemarkSentences, TellTheLongestOfAllRestsAndEachKindOnce) {
  const std::vector<MotionRemark> remarks{{Kind::paused, 0, 1, 0.5},
                                          {Kind::not_swept, 1, 2, 0},
                                          {Kind::paused, 2, 4, 1.24},
                                          {Kind::paused, 3, 6, 0.7}};
  EXPECT_THAT(
      explain(remarks, Language::english),
      ElementsAre("You paused in strokes 2, 5 and 7 (up to 1.2 seconds). Try to write without stopping.",
                  "Let stroke 3 trail off: lift the pen while it is still moving."));
  EXPECT_THAT(explain(std::vector<MotionRemark>{}, Language::english), IsEmpty());
}

}  // namespace
}  // namespace nazori::writing::test
