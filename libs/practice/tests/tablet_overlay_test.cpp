// SPDX-License-Identifier: Apache-2.0
// What the controller says is to be drawn, and where it lets a pointer be.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nazori/practice/tablet_control.h"
#include "running_tablet.h"
#include "scripted_device.h"

namespace nazori::practice {
namespace {

using test::RunningTablet;

using geometry::TabletPoint;

std::shared_ptr<const tablet::CarvedTablet> two_level_strokes() {
  std::vector<kanji::StrokeLine> lines(2);
  for (int i = 0; i < 2; ++i)
    lines[static_cast<std::size_t>(i)].points = {{20, 34.5 + 40 * i}, {89, 34.5 + 40 * i}};
  return *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128);
}

class Drawn : public testing::Test {
 protected:
  Drawn() { controller_.set_tablet(two_level_strokes()); }
  RunningTablet controller_;
};

TEST_F(Drawn, AreTheSwitchesOfTheLearner) {
  auto overlay = controller_.overlay();
  EXPECT_TRUE(overlay.strokes_visible);
  EXPECT_TRUE(overlay.arrows_visible);
  EXPECT_TRUE(overlay.numbers_visible);
  EXPECT_EQ(overlay.lines_opacity, 1);
  EXPECT_EQ(overlay.current_stroke, 0);
  EXPECT_FALSE(overlay.cursor);
  controller_.set_arrows_visible(false);
  EXPECT_FALSE(controller_.overlay().arrows_visible);
  EXPECT_TRUE(controller_.overlay().numbers_visible);
  controller_.set_numbers_visible(false);
  EXPECT_FALSE(controller_.overlay().numbers_visible);
  EXPECT_TRUE(controller_.overlay().strokes_visible);
  controller_.set_strokes_visible(false);
  EXPECT_FALSE(controller_.overlay().strokes_visible);
  controller_.set_current_stroke(2);
  EXPECT_EQ(controller_.overlay().current_stroke, 2);
  controller_.set_current_stroke(7);
  EXPECT_EQ(controller_.current_stroke(), 2) << "there are two";
  controller_.set_current_stroke(-1);
  EXPECT_EQ(controller_.current_stroke(), 0);
}

TEST_F(Drawn, IsTheWritingCrossWhereThereIsATablet) {
  EXPECT_EQ(controller_.overlay().cross, view::WritingCross::none);
  int changes = 0;
  const auto changed = controller_.picture_changed.connect([&] { ++changes; });
  controller_.set_cross(view::WritingCross::quarters);
  EXPECT_EQ(controller_.overlay().cross, view::WritingCross::quarters);
  EXPECT_EQ(changes, 1) << "a new picture is asked for";
  controller_.set_tablet(nullptr);
  EXPECT_EQ(controller_.overlay().cross, view::WritingCross::none);
}

TEST_F(Drawn, AreTheGuidesOfAStageInPlaceOfTheSwitches) {
  TabletGuides guides;
  guides.lines_opacity = 0.4;
  guides.numbers = true;
  controller_.set_guides(guides);
  EXPECT_FALSE(controller_.overlay().strokes_visible);
  EXPECT_FALSE(controller_.overlay().arrows_visible);
  EXPECT_TRUE(controller_.overlay().numbers_visible);
  EXPECT_EQ(controller_.overlay().lines_opacity, 0.4);
  EXPECT_FALSE(controller_.snapping_in_effect());
  guides.strokes = guides.arrows = guides.snapping = true;
  guides.numbers = false;
  controller_.set_guides(guides);
  EXPECT_TRUE(controller_.overlay().strokes_visible);
  EXPECT_TRUE(controller_.overlay().arrows_visible);
  EXPECT_FALSE(controller_.overlay().numbers_visible);
  EXPECT_TRUE(controller_.snapping_in_effect());
  controller_.set_guides({});
  EXPECT_TRUE(controller_.overlay().numbers_visible);
  EXPECT_FALSE(controller_.snapping_in_effect());
}

TEST_F(Drawn, EveryChangeAsksForAPicture) {
  int pictures = 0;
  controller_.picture_changed.connect([&] { ++pictures; });
  int states = 0;
  controller_.state_changed.connect([&] { ++states; });
  auto asks = [&, before = int(0), seen_states = int(0)](bool state) mutable {
    const bool asked = pictures > before && (states > seen_states) == state;
    before = pictures;
    seen_states = states;
    return asked;
  };
  controller_.set_arrows_visible(false);
  EXPECT_TRUE(asks(true));
  controller_.set_style(view::Style::slate);
  EXPECT_TRUE(asks(true));
  controller_.set_snapping(true);
  EXPECT_TRUE(asks(true));
  controller_.set_guides(TabletGuides{});
  EXPECT_TRUE(asks(false));
  controller_.set_writing({});
  EXPECT_TRUE(asks(false));
  controller_.set_demonstration({});
  EXPECT_TRUE(asks(false));
  controller_.clear_ink();
  EXPECT_TRUE(asks(false));
  controller_.set_tablet(two_level_strokes());
  EXPECT_TRUE(asks(true));
  controller_.undo_ink();
  EXPECT_FALSE(asks(false)) << "there is nothing to take back";
}

TEST_F(Drawn, AreTheStrokesThatWereWrittenAndTheInkOfADemonstration) {
  view::InkedStroke stroke;
  stroke.opacity = 0.5;
  controller_.set_writing({stroke, stroke});
  EXPECT_EQ(controller_.overlay().writing.size(), 2U);
  EXPECT_EQ(controller_.overlay().groove_ink.size(), 2U);
  Demonstration demonstration;
  demonstration.ink = {1, 0.25};
  controller_.set_demonstration(demonstration);
  const auto overlay = controller_.overlay();
  ASSERT_EQ(overlay.groove_ink.size(), 2U);
  EXPECT_EQ(overlay.groove_ink[1], 0.25);
  EXPECT_TRUE(overlay.cursor);
  controller_.set_demonstration({});
  EXPECT_EQ(controller_.overlay().groove_ink[1], 0);
}

TEST_F(Drawn, AStrokeThatIsLeftBeforeItsEndShowsWhatIsMissingUntilItIsTakenBack) {
  const auto script = std::make_shared<devices::test::Script>();
  const auto tablet = controller_.tablet();
  controller_.device().set_devices(devices::test::only(script), tablet->shape(), {});
  ASSERT_TRUE(controller_.start());
  controller_.device().choose("scripted:arm");
  ASSERT_TRUE(controller_.wait_for([&] { return !controller_.device().is_pointer(); }, 20'000));
  const auto hold = [&](const haptics::Vec3& at) {
    script->x_m = at.x;
    script->y_m = at.y;
    script->z_m = at.z;
    const std::uint64_t from = script->ticks;
    return controller_.wait_for([&] { return script->ticks > from + 2; }, 20'000);
  };
  const auto& path = tablet->paths().front().points;
  const haptics::Vec3 below(0, 0, -0.001);
  constexpr int kSteps = 60;
  for (int step = 0; step <= kSteps * 2 / 3; ++step)
    ASSERT_TRUE(
        hold(path.front() + (path.back() - path.front()) * (static_cast<double>(step) / kSteps) + below));
  script->z_m = 0.02;
  ASSERT_TRUE(controller_.wait_for(
      [&] {
        controller_.pump();
        return !controller_.ink().left_open().empty();
      },
      20'000));
  ASSERT_EQ(controller_.overlay().writing.size(), 1U);
  const auto bit = controller_.overlay().writing[0];
  EXPECT_EQ(bit.verdict, view::Verdict::shown);
  EXPECT_FALSE(bit.points.empty());
  EXPECT_NEAR(controller_.ink().progress()[0], 2.0 / 3, 0.05);
  TabletGuides untraced;
  controller_.set_guides(untraced);
  EXPECT_TRUE(controller_.overlay().writing.empty()) << "nobody traces";
  untraced.traced = true;
  controller_.set_guides(untraced);
  EXPECT_EQ(controller_.overlay().writing.size(), 1U);
  controller_.undo_ink();
  EXPECT_TRUE(controller_.overlay().writing.empty());
  EXPECT_EQ(controller_.ink().progress()[0], 0);
}

class PointerOnTheTablet : public testing::Test {
 protected:
  PointerOnTheTablet() {
    controller_.set_tablet(two_level_strokes());
    controller_.pressed.connect([this](const TabletPoint& at) { pressed_.push_back(at); });
    controller_.depth_changed.connect([this](double depth_m) { told_m_ = depth_m; });
  }
  RunningTablet controller_;
  std::vector<TabletPoint> pressed_;
  double told_m_ = -1;
  const geometry::TabletShape shape_;
};

TEST_F(PointerOnTheTablet, MayGoALittleBeyondTheEdge) {
  // An eighth of half the width: strokes may end near the edge.
  const double edge_m = 0.56 * shape_.width_m;
  for (const double sign : {-1.0, 1.0}) {
    controller_.move_stylus({sign * (edge_m - 1e-6), 0}, false);
    EXPECT_TRUE(controller_.stylus_in_range());
    controller_.move_stylus({sign * (edge_m + 1e-6), 0}, false);
    EXPECT_FALSE(controller_.stylus_in_range());
    controller_.move_stylus({0, sign * (edge_m - 1e-6)}, false);
    EXPECT_TRUE(controller_.stylus_in_range());
    controller_.move_stylus({0, sign * (edge_m + 1e-6)}, false);
    EXPECT_FALSE(controller_.stylus_in_range());
  }
}

TEST_F(PointerOnTheTablet, ThatWasPressedStaysPressedBeyondTheEdgeAndIsHeldThere) {
  ASSERT_TRUE(controller_.start());
  controller_.move_stylus({0, 0}, true);
  controller_.move_stylus({0.2, -0.2}, true);
  EXPECT_TRUE(controller_.is_pressed());
  EXPECT_TRUE(controller_.stylus_in_range());
  const double edge_m = 0.56 * shape_.width_m;
  EXPECT_TRUE(controller_.wait_for(
      [&] {
        const auto& at = controller_.latest().device_m;
        return std::hypot(at.x - edge_m, at.y + edge_m) < 1e-4;
      },
      20'000));
  controller_.move_stylus({0.2, 0}, false);
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_FALSE(controller_.stylus_in_range());
}

TEST_F(PointerOnTheTablet, TellsEachPressOnceAndWhere) {
  controller_.move_stylus({0.01, 0.02}, false);
  EXPECT_TRUE(pressed_.empty());
  controller_.move_stylus({0.01, 0.02}, true);
  controller_.move_stylus({0.02, 0.02}, true);
  ASSERT_EQ(pressed_.size(), 1U);
  EXPECT_EQ(pressed_[0].x, 0.01);
  EXPECT_EQ(pressed_[0].y, 0.02);
  controller_.move_stylus({0.2, 0}, false);
  controller_.move_stylus({0.2, 0}, true);
  EXPECT_EQ(pressed_.size(), 1U) << "beside the tablet";
}

TEST_F(PointerOnTheTablet, AClickTouchesTheBottomAndTheWheelGoesFromANotchToOneAndAHalfDepths) {
  controller_.move_stylus({0, 0}, true);
  EXPECT_GT(controller_.depth_m(), shape_.depth_m);
  EXPECT_LT(controller_.depth_m(), 1.3 * shape_.depth_m);
  EXPECT_EQ(told_m_, controller_.depth_m());
  const double first_m = controller_.depth_m();
  controller_.push_stylus(2);
  EXPECT_NEAR(controller_.depth_m() - first_m, 0.1 * shape_.depth_m, 1e-12) << "a twentieth a notch";
  controller_.push_stylus(1000);
  EXPECT_NEAR(controller_.depth_m(), 1.5 * shape_.depth_m, 1e-12);
  controller_.push_stylus(-1000);
  EXPECT_NEAR(controller_.depth_m(), 0.05 * shape_.depth_m, 1e-12);
  controller_.move_stylus({0.01, 0}, true);
  EXPECT_NEAR(controller_.depth_m(), 0.05 * shape_.depth_m, 1e-12) << "kept while it is pressed";
  controller_.move_stylus({0.01, 0}, false);
  EXPECT_EQ(controller_.depth_m(), 0);
  EXPECT_EQ(told_m_, 0);
  controller_.move_stylus({0.01, 0}, true);
  EXPECT_NEAR(controller_.depth_m(), first_m, 1e-12) << "and then as usual";
}

TEST_F(PointerOnTheTablet, PressureFromNothingToAllGoesToOneAndAHalfDepths) {
  controller_.move_stylus({0, 0}, true, 1.0);
  EXPECT_NEAR(controller_.depth_m(), 1.5 * shape_.depth_m, 1e-12);
  controller_.move_stylus({0, 0}, true, 7.0);
  EXPECT_NEAR(controller_.depth_m(), 1.5 * shape_.depth_m, 1e-12);
  controller_.move_stylus({0, 0}, true, -1.0);
  EXPECT_EQ(controller_.depth_m(), 0);
}

TEST_F(PointerOnTheTablet, ThatIsLiftedIsGone) {
  controller_.move_stylus({0, 0}, true);
  controller_.lift_stylus();
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_FALSE(controller_.stylus_in_range());
  EXPECT_EQ(controller_.depth_m(), 0);
  EXPECT_EQ(told_m_, 0);
}

TEST_F(PointerOnTheTablet, LeansAsFarAsPensDoAndNoFurther) {
  controller_.lean_stylus(PenTilt{75, 0});
  EXPECT_NEAR(controller_.lean_rad(), 75 * std::numbers::pi / 180, 1e-12);
  controller_.lean_stylus(PenTilt{89, 0});
  EXPECT_NEAR(controller_.lean_rad(), 75 * std::numbers::pi / 180, 1e-12);
  controller_.lean_stylus(PenTilt{-89, 0});
  EXPECT_NEAR(controller_.lean_rad(), 75 * std::numbers::pi / 180, 1e-12);
  controller_.lean_stylus(PenTilt{0, std::nan("")});
  EXPECT_NEAR(controller_.lean_rad(), 0, 1e-12);
  controller_.lean_stylus(PenTilt{0, 0});
  EXPECT_NEAR(controller_.lean_rad(), 0, 1e-12) << "upright, by a pen that has tilt";
  // 45 degrees in both directions: its axis goes one unit right and one down per unit up.
  controller_.lean_stylus(PenTilt{45, 45});
  EXPECT_NEAR(controller_.lean_rad(), std::acos(1 / std::sqrt(3.0)), 1e-12);
  controller_.lean_stylus({});
  EXPECT_EQ(controller_.lean_rad(), 0);
}

}  // namespace
}  // namespace nazori::practice
