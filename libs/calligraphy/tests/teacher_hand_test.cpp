// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/teacher_hand.h"

#include <gtest/gtest.h>

#include "nazori/calligraphy/sheet_editor.h"
#include "writing_under_test.h"

namespace nazori::calligraphy::test {
namespace {

const BrushWidths& widths() {
  static const BrushWidths medium(form_of({}));
  return medium;
}

std::vector<brush::PenSample> hand_of(const kanji::Character& character) {
  return teacher_hand(strokes_of({character, only_square()}), widths());
}

/// The advice on what the hand writes on a sheet.
std::vector<std::string> advice_on_hand(const kanji::Character& character) {
  auto e = std::make_unique<SheetEditor>(std::move(SheetEditor::create("hanshi", 512).value()));
  bool was_down = false;
  for (const brush::PenSample& sample : hand_of(character)) {
    e->move_pen(sample);
    if (was_down && !sample.down) e->dip_in_ink();
    was_down = sample.down;
  }
  EXPECT_EQ(e->written().size(), character.strokes.size());
  const SheetModel model{character, only_square()};
  const auto advice = advise(e->written(), ink_on(e->sheet()), std::vector{model}).front();
  EXPECT_TRUE(advice.is_comparable);
  return names(advice);
}

TEST(TeacherHand, WhatItWritesNeedsNoAdvice) {
  for (const auto& character : {three(), rest()}) {
    EXPECT_EQ(advice_on_hand(character), std::vector<std::string>{})
        << static_cast<unsigned>(character.code_point);
  }
  // Ink gathers in the turn of 亅, so all of it is a little low; its one stroke is right.
  for (const std::string& name : advice_on_hand(hook())) EXPECT_EQ(name, "too_low");
}

TEST(TeacherHand, TimeAscendsFromZeroAndThePenEndsOffThePaper) {
  const auto samples = hand_of(rest());
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.front().time_s, 0);
  EXPECT_FALSE(samples.front().down);
  EXPECT_FALSE(samples.back().down);
  int strokes = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_GT(samples[i].time_s, samples[i - 1].time_s) << i;
    EXPECT_LT(samples[i].time_s - samples[i - 1].time_s, 0.05) << "a picture every 1/20 s at least";
    strokes += samples[i].down && !samples[i - 1].down ? 1 : 0;
  }
  EXPECT_EQ(strokes, 6);
  EXPECT_TRUE(teacher_hand({}, widths()).empty());
}

/// A bar of 40 mm that thins out over its second half or not, then nothing or a corner upwards.
ModelStroke bar(bool sweeps, bool turns) {
  ModelStroke stroke;
  for (int i = 0; i <= 80; ++i) {
    stroke.points.push_back({-0.02 + 0.0005 * i, 0});
    stroke.half_width_m.push_back(sweeps && i > 40 ? 0.0024 * (1 - (i - 40) / 42.0) : 0.0024);
  }
  for (int i = 1; turns && i <= 20; ++i) {
    stroke.points.push_back({0.02, 0.0005 * i});
    stroke.half_width_m.push_back(0.0024);
  }
  return stroke;
}

/// Speed of the pen on the paper at a place, and how long it rests at the first and last place.
struct Movement {
  double start_m_s = 0, body_m_s = 0, turn_m_s = 0, end_m_s = 0, starts_s = 0, stops_s = 0;
};
Movement movement_of(const ModelStroke& stroke, const HandPace& pace = {}) {
  const auto samples = teacher_hand(std::vector{stroke}, widths(), pace);
  Movement found;
  PaperPoint last_down = stroke.points.back();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!samples[i].down) continue;
    const double way = geometry::distance(samples[i].at, samples[i - 1].at);
    const double seconds = samples[i].time_s - samples[i - 1].time_s;
    if (way == 0) {
      (samples[i].at == stroke.points.front() ? found.starts_s : found.stops_s) += seconds;
      continue;
    }
    if (std::abs(samples[i].at.x + 0.018) < 0.0002) found.start_m_s = way / seconds;
    if (std::abs(samples[i].at.x + 0.01) < 0.0002) found.body_m_s = way / seconds;
    if (geometry::distance(samples[i].at, {0.02, 0}) < 0.0002) found.turn_m_s = way / seconds;
    found.end_m_s = way / seconds;
    last_down = samples[i].at;
  }
  EXPECT_EQ(last_down, stroke.points.back());
  return found;
}

TEST(TeacherHand, IsSlowAtAStartRestsAtAStopAndSweepsWithoutOne) {
  const HandPace pace;
  const Movement stops = movement_of(bar(false, false));
  EXPECT_NEAR(stops.starts_s, 0.016, 1e-9) << "the brush is only set down";
  EXPECT_NEAR(stops.start_m_s, pace.bend_m_s, 1e-9);
  EXPECT_NEAR(stops.stops_s, pace.rest_s, 1e-9);
  EXPECT_NEAR(stops.body_m_s, pace.body_m_s, 1e-9);
  EXPECT_NEAR(stops.end_m_s, pace.body_m_s, 1e-9);
  const Movement sweeps = movement_of(bar(true, false));
  EXPECT_EQ(sweeps.stops_s, 0);
  EXPECT_NEAR(sweeps.body_m_s, pace.body_m_s, 1e-9);
  EXPECT_NEAR(sweeps.end_m_s, pace.sweep_m_s, 1e-9);
}

TEST(TeacherHand, IsSlowInASharpTurn) {
  const HandPace pace;
  const Movement turns = movement_of(bar(false, true));
  EXPECT_NEAR(turns.turn_m_s, pace.bend_m_s, 1e-9);
  EXPECT_NEAR(turns.body_m_s, pace.body_m_s, 1e-9);
}

TEST(TeacherHand, IsCarriedToTheNextStrokeAtItsOwnSpeed) {
  HandPace pace;
  pace.least_air_s = 0.1;
  ModelStroke second = bar(false, false);
  for (auto& point : second.points) point.y = -0.03;
  const auto samples = teacher_hand(std::vector{bar(false, false), second}, widths(), pace);
  double lifted_s = 0;
  double lowered_s = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i - 1].down && !samples[i].down && lifted_s == 0) lifted_s = samples[i].time_s;
    if (!samples[i - 1].down && samples[i].down && lifted_s > 0) lowered_s = samples[i - 1].time_s;
    if (lifted_s > 0 && lowered_s == 0) {
      EXPECT_FALSE(samples[i].down);
    }
  }
  // From (20, 0) to (-20, -30) mm: 50 mm at 0.12 m/s.
  EXPECT_NEAR(lowered_s - lifted_s, 0.05 / 0.12, 1e-9);
}

TEST(TeacherHand, PressesAsHardAsTheWidthNeedsOnceTheHairLies) {
  const ModelStroke stroke = bar(true, false);
  for (const auto& sample : teacher_hand(std::vector{stroke}, widths())) {
    if (!sample.down) continue;
    const auto at = std::find(stroke.points.begin(), stroke.points.end(), sample.at);
    ASSERT_NE(at, stroke.points.end());
    const double whole =
        widths().pressure_for(stroke.half_width_m[static_cast<std::size_t>(at - stroke.points.begin())]);
    const double way = geometry::distance(sample.at, stroke.points.front());
    EXPECT_NEAR(*sample.pressure, whole * std::min(1.0, 0.75 + 0.25 * way / 0.004), 1e-9) << way;
  }
}

}  // namespace
}  // namespace nazori::calligraphy::test
