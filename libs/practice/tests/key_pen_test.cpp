// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/key_pen.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nazori/practice/blank_tablet.h"
#include "running_tablet.h"

namespace {

using namespace nazori::practice;
using nazori::geometry::TabletPoint;
using RunningTablet = nazori::practice::test::RunningTablet;

/// In glyph units, of which 1.09 are a millimetre: a level stroke through the middle, one straight down that
/// starts where the first one ends.
std::shared_ptr<const nazori::tablet::CarvedTablet> two() {
  std::vector<nazori::kanji::StrokeLine> lines(2);
  lines[0].points = {{21.8, 54.5}, {87.2, 54.5}};
  lines[1].points = {{87.2, 54.5}, {87.2, 98.1}};
  return *nazori::tablet::CarvedTablet::from_lines(nazori::tablet::tablet_lines(lines), 128);
}

class KeyPenOnATablet : public testing::Test {
 protected:
  KeyPenOnATablet() {
    tablet.set_tablet(two());
    (void)pen.begin();
  }
  KeyPenEvent walk(int right, int up, int steps, bool fine = false) {
    KeyPenEvent last;
    for (int i = 0; i < steps; ++i) last = pen.step(right, up, fine);
    return last;
  }

  RunningTablet tablet;
  TabletGround ground{tablet};
  KeyPen pen{ground};
};

TEST_F(KeyPenOnATablet, BeginsInTheMiddleAboveTheTablet) {
  const auto place = pen.where();
  EXPECT_EQ(place.at, (TabletPoint{0, 0}));
  EXPECT_FALSE(place.is_down);
  EXPECT_DOUBLE_EQ(place.from_left, 0.5);
  EXPECT_DOUBLE_EQ(place.from_top, 0.5);
  EXPECT_EQ(place.stroke, 1);
  EXPECT_NEAR(place.along, 0.5, 1e-9);
}

TEST_F(KeyPenOnATablet, AStepIsTwoMillimetresAndAFineOneHalfOfOne) {
  EXPECT_NEAR(pen.step(1, 0).place.at.x, 2e-3, 1e-12);
  EXPECT_NEAR(pen.step(0, 1, true).place.at.y, 0.5e-3, 1e-12);
  const auto diagonal = pen.step(-1, -1).place.at;
  EXPECT_NEAR(diagonal.x, 0, 1e-12);
  EXPECT_NEAR(diagonal.y, -1.5e-3, 1e-12);
}

TEST_F(KeyPenOnATablet, TheBorderStopsItAndIsAnnounced) {
  EXPECT_NE(walk(0, 1, 25).did, KeyPenDid::at_border);
  EXPECT_NEAR(pen.where().from_top, 0, 1e-12);
  EXPECT_EQ(pen.step(0, 1).did, KeyPenDid::at_border);
  EXPECT_EQ(pen.step(1, 1).did, KeyPenDid::moved);  // along the border it goes on
  EXPECT_NEAR(pen.where().at.x, 2e-3, 1e-12);
  walk(-1, -1, 60);
  EXPECT_NEAR(pen.where().from_left, 0, 1e-12);
  EXPECT_NEAR(pen.where().from_top, 1, 1e-12);
}

TEST_F(KeyPenOnATablet, LeavingAStrokeAndMeetingItAgainAreAnnouncedOnce) {
  EXPECT_EQ(pen.step(0, 1).did, KeyPenDid::moved);  // 2 mm: still within reach
  const auto left = pen.step(0, 1);
  EXPECT_EQ(left.did, KeyPenDid::left_stroke);
  EXPECT_EQ(left.left, 1);
  EXPECT_EQ(left.place.stroke, 0);
  EXPECT_EQ(pen.step(0, 1).did, KeyPenDid::moved);
  const auto met = walk(0, -1, 2);
  EXPECT_EQ(met.did, KeyPenDid::met_stroke);
  EXPECT_EQ(met.place.stroke, 1);
  EXPECT_EQ(pen.step(0, -1).did, KeyPenDid::moved);
}

TEST_F(KeyPenOnATablet, StartAndEndOfAStrokeAreAnnouncedWhenThePenReachesThem) {
  // The start lies 30 mm to the left of the middle.
  EXPECT_EQ(walk(-1, 0, 14).did, KeyPenDid::moved);
  const auto start = pen.step(-1, 0);
  EXPECT_EQ(start.did, KeyPenDid::at_start);
  EXPECT_EQ(start.place.stroke, 1);
  EXPECT_EQ(start.place.along, 0);
  EXPECT_EQ(pen.step(-1, 0, true).did, KeyPenDid::moved);
  EXPECT_EQ(walk(1, 0, 3).did, KeyPenDid::moved);
  EXPECT_NEAR(pen.where().along, 5.5 / 60, 1e-9);
  // Where the first stroke ends the second one starts: the first is as near, so it is named first.
  (void)pen.go_to_next_start();
  const auto end = walk(1, 0, 30);
  EXPECT_EQ(end.did, KeyPenDid::at_end);
  EXPECT_EQ(end.place.stroke, 1);
  EXPECT_EQ(end.place.along, 1);
}

TEST_F(KeyPenOnATablet, OnlyTheStrokeThatIsShownAloneIsNamed) {
  tablet.set_current_stroke(2);
  EXPECT_EQ(pen.where().stroke, 0);
  EXPECT_EQ(pen.go_to_next_start().place.stroke, 2);
  const auto end = walk(0, -1, 20);
  EXPECT_EQ(end.did, KeyPenDid::at_end);
  EXPECT_EQ(end.place.stroke, 2);
}

TEST_F(KeyPenOnATablet, GoesFromStartToStartAndBeginsAgain) {
  std::vector<int> seen;
  for (int i = 0; i < 3; ++i) {
    const auto event = pen.go_to_next_start();
    EXPECT_EQ(event.did, KeyPenDid::at_start);
    EXPECT_EQ(event.place.along, 0);
    seen.push_back(event.place.stroke);
  }
  EXPECT_EQ(seen, (std::vector{1, 2, 1}));
  EXPECT_NEAR(pen.where().at.x, -0.030, 1e-9);
  EXPECT_NEAR(pen.where().at.y, 0, 1e-9);
}

TEST_F(KeyPenOnATablet, ABlankTabletTellsNothing) {
  tablet.set_tablet(blank_tablet());
  EXPECT_EQ(pen.where().stroke, 0);
  EXPECT_EQ(pen.where().depth, 0);
  EXPECT_EQ(pen.go_to_next_start().did, KeyPenDid::no_strokes);
  EXPECT_EQ(pen.where().at, (TabletPoint{0, 0}));
  EXPECT_EQ(walk(-1, 0, 15).did, KeyPenDid::moved);
}

TEST_F(KeyPenOnATablet, TheDepthIsThatOfTheGroove) {
  const double bottom = pen.where().depth;
  EXPECT_GT(bottom, 0.5);
  EXPECT_EQ(walk(0, 1, 10).place.depth, 0);
}

TEST_F(KeyPenOnATablet, ThePenIsPutDownLiftedAndFollowedByTheStylus) {
  ASSERT_TRUE(tablet.start());
  EXPECT_EQ(pen.press().did, KeyPenDid::put_down);
  EXPECT_TRUE(tablet.is_pressed());
  ASSERT_TRUE(tablet.wait_for([&] { return tablet.latest().touching; }));
  (void)walk(1, 0, 3);
  ASSERT_TRUE(tablet.wait_for([&] { return std::abs(tablet.latest().device_m.x - 6e-3) < 1e-4; }));
  EXPECT_TRUE(tablet.latest().touching);
  EXPECT_EQ(pen.press().did, KeyPenDid::lifted);
  EXPECT_FALSE(tablet.is_pressed());
  ASSERT_TRUE(tablet.wait_for([&] { return !tablet.latest().touching; }));
  // It goes to a start only in the air.
  (void)pen.press();
  EXPECT_FALSE(pen.go_to_next_start().place.is_down);
  EXPECT_FALSE(tablet.is_pressed());
}

TEST_F(KeyPenOnATablet, EndsWithThePenLifted) {
  (void)pen.press();
  pen.end();
  EXPECT_FALSE(pen.is_in_use());
  EXPECT_FALSE(tablet.is_pressed());
  (void)pen.begin();
  EXPECT_FALSE(pen.where().is_down);
  EXPECT_EQ(pen.go_to_next_start().place.stroke, 1);
}

TEST_F(KeyPenOnATablet, WhatIsWrittenFillsTheStroke) {
  ASSERT_TRUE(tablet.start());
  TabletGuides guides;
  guides.strokes = guides.traced = true;
  tablet.set_guides(guides);
  (void)pen.go_to_next_start();
  (void)pen.press();
  for (int i = 0; i < 30; ++i) {
    (void)pen.step(1, 0);
    const double x = pen.where().at.x;
    ASSERT_TRUE(tablet.wait_for([&] { return std::abs(tablet.latest().device_m.x - x) < 2e-4; })) << i;
  }
  ASSERT_TRUE(
      tablet.wait_for([&] { return !tablet.ink().progress().empty() && tablet.ink().progress()[0] > 0.95; }));
}

struct Written {
  double x, y;
  bool is_down;
  double pressure;
  friend bool operator==(const Written&, const Written&) = default;
};

class KeyPenOnASheet : public testing::Test {
 protected:
  std::vector<Written> written;
  int taken_away = 0;
  SheetGround ground{0.1,
                     [this](TabletPoint at, bool down, double pressure) {
                       written.push_back({at.x, at.y, down, pressure});
                     },
                     [this] { ++taken_away; }};
  KeyPen pen{ground};
};

TEST_F(KeyPenOnASheet, WritesWithTheBrushUntilItIsLifted) {
  (void)pen.begin();
  EXPECT_EQ(written.back(), (Written{0, 0, false, 0}));
  EXPECT_EQ(pen.press().did, KeyPenDid::put_down);
  EXPECT_EQ(written.back(), (Written{0, 0, true, 0.5}));
  (void)pen.step(1, 0);
  EXPECT_EQ(written.back(), (Written{2e-3, 0, true, 0.5}));
  pen.end();
  EXPECT_EQ(written.back(), (Written{2e-3, 0, false, 0}));
  EXPECT_EQ(taken_away, 1);
  EXPECT_EQ(pen.where().depth, 0);
}

TEST_F(KeyPenOnASheet, PressesHarderAndSofterInStepsUpToItsLimits) {
  (void)pen.begin();
  EXPECT_TRUE(ground.press_harder(1));
  EXPECT_NEAR(ground.pressure(), 0.6, 1e-12);
  EXPECT_EQ(written.size(), 1U) << "above the paper nothing is written";
  (void)pen.press();
  EXPECT_TRUE(ground.press_harder(-2));
  EXPECT_NEAR(written.back().pressure, 0.4, 1e-12);
  EXPECT_TRUE(written.back().is_down);
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(ground.press_harder(1)) << i;
  EXPECT_EQ(ground.pressure(), 1);
  EXPECT_FALSE(ground.press_harder(1));
  for (int i = 0; i < 9; ++i) EXPECT_TRUE(ground.press_harder(-1)) << i;
  EXPECT_NEAR(ground.pressure(), 0.1, 1e-12);
  EXPECT_FALSE(ground.press_harder(-1));
}

TEST_F(KeyPenOnASheet, GoesFromStartToStartOfTheModelsThatAreShown) {
  EXPECT_EQ(pen.begin().place.stroke, 0);
  EXPECT_EQ(pen.go_to_next_start().did, KeyPenDid::no_strokes);
  ground.set_strokes({{{-0.03, 0.02}, {0.03, 0.02}}, {{0.01, 0.04}, {0.01, -0.04}}});
  EXPECT_EQ(pen.go_to_next_start().place.at, (TabletPoint{-0.03, 0.02}));
  const auto second = pen.go_to_next_start();
  EXPECT_EQ(second.did, KeyPenDid::at_start);
  EXPECT_EQ(second.place.stroke, 2);
  EXPECT_EQ(second.place.at, (TabletPoint{0.01, 0.04}));
  EXPECT_NEAR(second.place.from_left, 0.6, 1e-12);
  EXPECT_NEAR(second.place.from_top, 0.1, 1e-12);
  KeyPenEvent last;
  for (int i = 0; i < 40; ++i) last = pen.step(0, -1);
  EXPECT_EQ(last.did, KeyPenDid::at_end);
  EXPECT_EQ(last.place.stroke, 2);
}

TEST(CueOfAKeyPen, PitchIsTheHeightAndPanTheSide) {
  KeyPenPlace place;
  place.from_left = 0;
  place.from_top = 1;
  EXPECT_DOUBLE_EQ(cue_of(place).hertz, 200);
  EXPECT_DOUBLE_EQ(cue_of(place).pan, -1);
  place.from_left = 1;
  place.from_top = 0;
  EXPECT_NEAR(cue_of(place).hertz, 1000, 1e-9);
  EXPECT_DOUBLE_EQ(cue_of(place).pan, 1);
  // Equal steps up are equal intervals.
  place.from_top = 0.5;
  EXPECT_NEAR(cue_of(place).hertz, std::sqrt(200.0 * 1000.0), 1e-9);
}

TEST(CueOfAKeyPen, TheEdgeOfAGrooveIsRoughAndItsBottomLoudAndClear) {
  KeyPenPlace place;
  EXPECT_EQ(cue_of(place).noise, 0);
  EXPECT_DOUBLE_EQ(cue_of(place).loudness, 0.15);
  place.depth = 0.5;
  EXPECT_DOUBLE_EQ(cue_of(place).noise, 1);
  EXPECT_DOUBLE_EQ(cue_of(place).loudness, 0.575);
  place.depth = 1;
  EXPECT_EQ(cue_of(place).noise, 0);
  EXPECT_DOUBLE_EQ(cue_of(place).loudness, 1);
}

}  // namespace
