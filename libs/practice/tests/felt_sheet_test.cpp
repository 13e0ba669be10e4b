// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/felt_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "nazori/devices/device_catalogue.h"
#include "running_tablet.h"
#include "scripted_device.h"

namespace nazori::practice {
namespace {

using geometry::PaperPoint;

brush::TuftForm form() { return brush::tuft_form(6).value(); }

class Sheet : public testing::Test {
 protected:
  Sheet() {
    sheet_.pen_moved.connect([this](const brush::PenSample& sample) { pens_.push_back(sample); });
    sheet_.pen_lost.connect([this] { ++lost_; });
    sheet_.button_pressed.connect([this] { ++buttons_; });
    sheet_.led.connect([this] { ++led_; });
    sheet_.pointed.connect([this](PaperPoint at) { pointed_ = at; });
  }

  template <class Wish>
  [[nodiscard]] bool wait_for(Wish wish) {
    return tablet_.wait_for([&] {
      while (inbox_.run_one()) {
      }
      return wish();
    });
  }
  /// Opens the scripted arm and lets it feel the sheet.
  void feel() {
    tablet_.device().set_devices(devices::test::only(script_), {}, {});
    ASSERT_TRUE(tablet_.start());
    tablet_.device().choose("scripted:arm");
    sheet_.set_brush(form());
    sheet_.enter();
    ASSERT_TRUE(wait_for([this] { return sheet_.is_felt() && !sheet_.is_preparing(); }));
  }
  /// Moves the arm and waits until the servo has seen it.
  void hold(double x_m, double y_m, double z_m) {
    script_->x_m = x_m;
    script_->y_m = y_m;
    script_->z_m = z_m;
    const std::uint64_t from = script_->ticks;
    ASSERT_TRUE(wait_for([&] { return script_->ticks > from + 2 * FeltSheet::kEvery; }));
  }
  /// The force once it does not change any more.
  double force_n() {
    constexpr std::uint64_t kCalmTicks = 60;
    double calm_n = -1;
    std::uint64_t since = 0;
    EXPECT_TRUE(wait_for([&] {
      const double now = script_->force_n;
      const std::uint64_t ticks = script_->ticks;
      if (std::abs(now - calm_n) > 1e-6) since = ticks;
      calm_n = now;
      return ticks > since + kCalmTicks;
    }));
    return calm_n;
  }
  static double push_n(double depth_m, brush::Feel feel) {
    const brush::ForceTable table(form());
    const auto tip = brush::soft_tip(table, 0, 1, feel);
    const double place = depth_m / tip.step_m;
    const auto i = static_cast<std::size_t>(place);
    return tip.push_n[i] + (place - static_cast<double>(i)) * (tip.push_n[i + 1] - tip.push_n[i]);
  }

  std::shared_ptr<devices::test::Script> script_ = std::make_shared<devices::test::Script>();
  base::Inbox inbox_;
  test::RunningTablet tablet_;
  double now_s_ = 500;
  FeltSheet sheet_{inbox_, tablet_, [this] { return now_s_; }};
  std::vector<brush::PenSample> pens_;
  int lost_ = 0, buttons_ = 0, led_ = 0;
  std::optional<PaperPoint> pointed_;
};

TEST_F(Sheet, PushesAsTheBrushDoesAndFourTimesAsHard) {
  feel();
  hold(0, 0, -0.004);
  EXPECT_NEAR(force_n(), push_n(0.004, brush::Feel::strengthened), 1e-3);
  EXPECT_NEAR(push_n(0.004, brush::Feel::strengthened), 4 * push_n(0.004, brush::Feel::true_force), 1e-9);
  sheet_.set_feel(brush::Feel::true_force);
  EXPECT_NEAR(force_n(), push_n(0.004, brush::Feel::true_force), 1e-3);
  hold(0, 0, 0.001);
  EXPECT_EQ(force_n(), 0) << "above the paper";
}

TEST_F(Sheet, ALeaningHolderIsPushedLess) {
  feel();
  hold(0, 0, -0.004);
  const double upright_n = force_n();
  sheet_.set_tilt(0.8, 0);
  EXPECT_LT(force_n(), 0.95 * upright_n);
  EXPECT_GT(force_n(), 0);
}

TEST_F(Sheet, ADryBrushIsHarderToDraw) {
  const brush::ForceTable table(form());
  const auto friction = [&](double wetness) {
    return brush::soft_tip(table, 0, wetness, brush::Feel::strengthened).friction;
  };
  ASSERT_GT(friction(0), 1.1 * friction(1));
  feel();
  const auto drawn_n = [this](double wetness) {
    hold(0, 0, 0.004);
    sheet_.set_wetness(wetness);
    hold(0, 0, -0.004);
    hold(0.04, 0, -0.004);
    return force_n();
  };
  const double wet_n = drawn_n(1);
  const double dry_n = drawn_n(0);
  EXPECT_GT(dry_n, 1.002 * wet_n);
  EXPECT_NEAR(drawn_n(-1), dry_n, 1e-3) << "no drier than dry";
  EXPECT_NEAR(drawn_n(7), wet_n, 1e-3);
}

TEST_F(Sheet, TheMovementOnThePaperIsThatOfAPen) {
  feel();
  hold(0.01, 0.02, 0.03);
  EXPECT_TRUE(pens_.empty()) << "nothing is written above the paper";
  EXPECT_EQ(pointed_->x, 0.01);
  EXPECT_EQ(pointed_->y, 0.02);
  sheet_.set_tilt(0.2, -0.7);
  hold(0.01, 0.02, -0.003);
  ASSERT_FALSE(pens_.empty());
  EXPECT_TRUE(pens_.front().is_down());
  hold(0.02, 0.02, -0.005);
  EXPECT_EQ(pens_.back().at.x, 0.02);
  EXPECT_EQ(pens_.back().at.y, 0.02);
  EXPECT_EQ(pens_.back().height_m, -0.005);
  EXPECT_FALSE(pens_.back().pressure.has_value());
  EXPECT_EQ(pens_.back().lean_rad, 0.2);
  EXPECT_EQ(pens_.back().lean_to_rad, -0.7);
  hold(0.02, 0.02, 0.004);
  EXPECT_FALSE(pens_.back().is_down());
  const std::size_t count = pens_.size();
  hold(0.03, 0.02, 0.004);
  EXPECT_EQ(pens_.size(), count);
  EXPECT_EQ(pointed_->x, 0.03);
  hold(0.04, 0.02, 0.05);
  EXPECT_EQ(pointed_->x, 0.03) << "too far away to be a brush over the paper";
}

TEST_F(Sheet, TimesAreThoseOfThePenAndRunEvenlyWhileAStrokeIsWritten) {
  feel();
  hold(0, 0, -0.003);
  ASSERT_FALSE(pens_.empty());
  EXPECT_NEAR(pens_.front().time_s, 500, 5) << "a busy machine may be late";
  // A clock that is put on must not stretch the stroke that is under way.
  now_s_ = 9000;
  hold(0.001, 0, -0.003);
  for (std::size_t i = 1; i < pens_.size(); ++i) {
    EXPECT_GT(pens_[i].time_s, pens_[i - 1].time_s);
    EXPECT_LT(pens_[i].time_s, 600);
  }
  hold(0, 0, 0.01);
  hold(0, 0, -0.003);
  EXPECT_GT(pens_.back().time_s, 8990);
}

TEST_F(Sheet, EachFourthTickOnThePaperIsWritten) {
  feel();
  hold(0, 0, -0.003);
  pens_.clear();
  const std::uint64_t from = script_->ticks;
  ASSERT_TRUE(wait_for([&] { return script_->ticks > from + 400; }));
  // What the servo has and the sheet has not yet read is less than a few dozen.
  EXPECT_NEAR(static_cast<double>(pens_.size()), 100, 20);
}

TEST_F(Sheet, TicksThatCannotBeTrustedWriteNothing) {
  feel();
  hold(0, 0, -0.003);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  hold(nothing, 0, -0.003);
  hold(0, 0, -0.003);
  for (const auto& pen : pens_) {
    EXPECT_TRUE(std::isfinite(pen.at.x));
    EXPECT_TRUE(pen.is_down());
  }
}

TEST_F(Sheet, LeavingEndsTheStrokeAndGivesTheTabletBack) {
  feel();
  std::vector<kanji::StrokeLine> lines(1);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  tablet_.set_tablet(*tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128));
  hold(0, 0, -0.003);
  EXPECT_NEAR(force_n(), push_n(0.003, brush::Feel::strengthened), 1e-3) << "the tablet is not felt";
  EXPECT_EQ(lost_, 0);
  sheet_.leave();
  EXPECT_EQ(lost_, 1);
  EXPECT_FALSE(sheet_.is_felt());
  pens_.clear();
  hold(0, 0, -0.003);
  EXPECT_EQ(force_n(), 0) << "in the groove";
  hold(0.03, 0.03, -0.003);
  EXPECT_GT(force_n(), 2 * push_n(0.003, brush::Feel::strengthened)) << "on the plateau, which is hard";
  EXPECT_TRUE(pens_.empty());
  sheet_.leave();
  EXPECT_EQ(lost_, 1);
}

TEST_F(Sheet, OnASheetNothingIsTracedAndAButtonDoesWhatTheSheetWants) {
  feel();
  std::vector<kanji::StrokeLine> lines(2);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  lines[1].points = {{20, 80}, {89, 80}};
  tablet_.set_tablet(*tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128));
  int events = 0;
  tablet_.stroke_event.connect([&](TraceEvent, int) { ++events; });
  for (int step = 0; step <= 10; ++step) hold(-0.03 + 0.006 * step, 0, -0.003);
  EXPECT_EQ(events, 0);
  script_->buttons = 1;
  hold(0, 0, 0.01);
  EXPECT_EQ(buttons_, 1);
  tablet_.press_button(devices::ButtonDoes::next_stroke);
  EXPECT_EQ(tablet_.current_stroke(), 0);
  sheet_.leave();
  script_->buttons = 0;
  hold(0, 0, 0.01);
  script_->buttons = 1;
  hold(0, 0, 0.01);
  EXPECT_EQ(buttons_, 1) << "the tablet's own again";
  tablet_.press_button(devices::ButtonDoes::next_stroke);
  EXPECT_EQ(tablet_.current_stroke(), 1);
}

TEST_F(Sheet, AMouseFeelsNothingAndWritesNothingHere) {
  ASSERT_TRUE(tablet_.start());
  sheet_.set_brush(form());
  sheet_.enter();
  ASSERT_TRUE(wait_for([this] { return !sheet_.is_preparing(); }));
  EXPECT_FALSE(sheet_.is_felt());
  EXPECT_FALSE(sheet_.has_no_hand());
  tablet_.move_stylus({0, 0}, true);
  tablet_.let_ticks_pass(20);
  EXPECT_TRUE(pens_.empty());
}

TEST_F(Sheet, ADeviceThatIsLostLosesItsStroke) {
  feel();
  hold(0, 0, -0.003);
  tablet_.device().choose("pointer");
  ASSERT_TRUE(wait_for([this] { return tablet_.device().is_pointer(); }));
  EXPECT_EQ(lost_, 1);
  EXPECT_FALSE(sheet_.is_felt());
}

TEST_F(Sheet, ASimulatedDeviceHasTheHandOfTheMouse) {
  std::vector<std::unique_ptr<devices::BackEnd>> all;
  all.push_back(devices::simulated_back_end());
  tablet_.device().set_devices(std::move(all), {}, {});
  ASSERT_TRUE(tablet_.start());
  tablet_.device().choose("simulated:touch");
  sheet_.set_brush(form());
  sheet_.enter();
  ASSERT_TRUE(wait_for([this] { return sheet_.has_no_hand() && !sheet_.is_preparing(); }));
  sheet_.move_hand({0.01, 0.01}, true, 0.6);
  ASSERT_TRUE(wait_for([this] { return !pens_.empty() && pens_.back().at.x > 0.0095; }));
  EXPECT_TRUE(pens_.back().is_down());
  EXPECT_GT(tablet_.latest().force_n.z, 0.02) << "the bent brush";
  sheet_.move_hand({0.01, 0.01}, false, {});
  ASSERT_TRUE(wait_for([this] { return !pens_.back().is_down(); }));
}

TEST_F(Sheet, ATeacherLeadsTheHandAlongItsStrokes) {
  feel();
  EXPECT_FALSE(sheet_.is_leading());
  std::vector<brush::PenSample> hand;
  const auto add = [&hand](double x, double y, bool down) {
    brush::PenSample sample;
    sample.at = {x, y};
    sample.down = down;
    sample.pressure = 0.5;
    hand.push_back(sample);
  };
  for (const double y : {0.01, -0.01}) {
    add(-0.02, y, false);
    for (int i = 0; i <= 20; ++i) add(-0.02 + 0.002 * i, y, true);
    add(0.02, y, false);
  }
  // At the start of the first stroke, but beside it: the teacher pulls there, and gives up as the arm
  // resists.
  hold(-0.02, 0.012, 0.002);
  double pulled_n = 0;
  const auto watching = tablet_.sampled.connect([&](std::span<const haptics::ServoSample> samples) {
    for (const auto& one : samples) pulled_n = std::min(pulled_n, one.force_n.y);
  });
  EXPECT_TRUE(sheet_.lead(hand));
  EXPECT_TRUE(sheet_.is_leading());
  ASSERT_TRUE(wait_for([&] { return pulled_n < -0.02; }));
  const double depth_m = 0.5 * brush::Handling{}.full_depth * form().hair_m;
  for (const double y : {0.01, -0.01}) {
    hold(-0.02, y, 0.01);
    for (int i = 0; i <= 40; ++i) hold(-0.02 + 0.001 * i, y, -depth_m);
    if (y > 0) {
      EXPECT_EQ(led_, 0);
      EXPECT_TRUE(sheet_.is_leading());
    }
    hold(0.02, y, 0.01);
  }
  ASSERT_TRUE(wait_for([this] { return led_ == 1; }));
  EXPECT_FALSE(sheet_.is_leading());
  hold(-0.02, 0.012, 0.002);
  EXPECT_EQ(force_n(), 0) << "nobody leads any more";
}

TEST_F(Sheet, LeadingCanBeStoppedAndEndsOnLeaving) {
  feel();
  std::vector<brush::PenSample> hand(3);
  hand[1].at.x = 0.02;
  hand[2].at.x = 0.03;
  EXPECT_TRUE(sheet_.lead(hand));
  sheet_.stop_leading();
  EXPECT_FALSE(sheet_.is_leading());
  EXPECT_TRUE(sheet_.lead(hand));
  sheet_.leave();
  EXPECT_FALSE(sheet_.is_leading());
  EXPECT_FALSE(sheet_.lead(hand)) << "nothing is felt";
  sheet_.enter();
  EXPECT_FALSE(sheet_.lead(std::span(hand).first(1))) << "one point is no stroke";
}

}  // namespace
}  // namespace nazori::practice
