// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/felt_tablet.h"

#include <gtest/gtest.h>

#include <limits>

#include "nazori/surface/ball_surface.h"
#include "running_tablet.h"

namespace nazori::practice {
namespace {

FeltTablet::Tablet one_groove(double width_m = 0.1) {
  std::vector<kanji::StrokeLine> lines(1);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  return *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128, {}, {width_m, 0.01});
}

class Felt : public testing::Test {
 protected:
  /// Acts as an event loop until the surface is ready.
  void wait() {
    inbox_.run_until([this] { return !felt_.is_preparing(); });
  }
  base::Inbox inbox_;
  FeltTablet felt_{inbox_};
  int changes_ = 0;
  base::Connection counting_ = felt_.changed.connect([this] { ++changes_; });
};

TEST_F(Felt, WithAPointItIsTheTabletItself) {
  EXPECT_EQ(felt_.felt(), nullptr);
  EXPECT_EQ(felt_.radius_m(), 0);
  const FeltTablet::Tablet tablet = one_groove();
  felt_.set_tablet(tablet);
  EXPECT_EQ(felt_.felt(), tablet);
  EXPECT_FALSE(felt_.is_preparing());
  felt_.set_tablet(nullptr);
  EXPECT_EQ(felt_.felt(), nullptr);
  EXPECT_EQ(changes_, 0);
}

TEST_F(Felt, ABallIsFeltAsSoonAsItsSurfaceIsReadyAndAPointAtOnce) {
  const FeltTablet::Tablet tablet = one_groove();
  felt_.set_tablet(tablet);
  felt_.set_radius(0.002);
  EXPECT_TRUE(felt_.is_preparing());
  EXPECT_EQ(felt_.felt(), tablet) << "until then as before";
  wait();
  EXPECT_EQ(changes_, 1);
  EXPECT_EQ(felt_.felt()->tip_radius_m(), 0.002);
  EXPECT_EQ(felt_.felt()->surface(), tablet->surface()) << "what is drawn is the same";
  const double ball = felt_.felt()->scene({}, {})->surface->at(63.5, 63.5).height;
  const double point = tablet->scene({}, {})->surface->at(63.5, 63.5).height;
  EXPECT_GT(ball, point + 0.02) << "the ball is broader than the bottom of the groove";
  felt_.set_radius(0);
  EXPECT_FALSE(felt_.is_preparing());
  EXPECT_EQ(felt_.felt(), tablet);
  EXPECT_EQ(changes_, 2);
}

TEST_F(Felt, WhileAnotherRadiusIsPreparedTheOneBeforeIsFelt) {
  felt_.set_tablet(one_groove());
  felt_.set_radius(0.001);
  wait();
  felt_.set_radius(0.003);
  EXPECT_EQ(felt_.felt()->tip_radius_m(), 0.001);
  wait();
  EXPECT_EQ(felt_.felt()->tip_radius_m(), 0.003);
  EXPECT_EQ(changes_, 2);
  felt_.set_radius(0.003);
  EXPECT_FALSE(felt_.is_preparing()) << "nothing else was asked for";
}

TEST_F(Felt, OnlyTheLastOfManyRadiusesIsFelt) {
  felt_.set_tablet(one_groove());
  for (int tenths = 1; tenths <= 30; ++tenths) felt_.set_radius(1e-4 * tenths);
  wait();
  EXPECT_EQ(felt_.felt()->tip_radius_m(), 0.003);
  EXPECT_EQ(changes_, 1);
}

TEST_F(Felt, APointIsNotReplacedByABallThatIsReadyTooLate) {
  const FeltTablet::Tablet tablet = one_groove();
  felt_.set_tablet(tablet);
  felt_.set_radius(0.003);
  felt_.set_radius(0);
  bool is_idle = false;
  base::Background later("later", inbox_);
  later.post([&] { later.answer([&is_idle] { is_idle = true; }); });
  inbox_.run_until([&is_idle] { return is_idle; });
  EXPECT_EQ(felt_.felt(), tablet);
}

TEST_F(Felt, EachNewTabletIsFeltWithTheBallToo) {
  felt_.set_radius(0.002);
  EXPECT_FALSE(felt_.is_preparing()) << "there is no tablet yet";
  felt_.set_tablet(one_groove());
  wait();
  const FeltTablet::Tablet other = one_groove();
  felt_.set_tablet(other);
  EXPECT_EQ(felt_.felt(), other) << "never the tablet before";
  wait();
  EXPECT_EQ(felt_.felt()->tip_radius_m(), 0.002);
  EXPECT_EQ(felt_.felt()->surface(), other->surface());
  felt_.set_tablet(nullptr);
  EXPECT_FALSE(felt_.is_preparing());
  EXPECT_EQ(felt_.felt(), nullptr);
}

TEST_F(Felt, ARadiusOutOfRangeIsMovedIntoIt) {
  felt_.set_tablet(one_groove());
  felt_.set_radius(1);
  EXPECT_EQ(felt_.radius_m(), surface::kLargestBall_m);
  felt_.set_radius(-1);
  EXPECT_EQ(felt_.radius_m(), 0);
  felt_.set_radius(0.001);
  felt_.set_radius(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(felt_.radius_m(), 0);
}

TEST_F(Felt, ATabletTooSmallForTheBallIsFeltWithAPoint) {
  const FeltTablet::Tablet tiny = one_groove(0.008);
  felt_.set_radius(0.003);
  felt_.set_tablet(tiny);
  wait();
  EXPECT_EQ(felt_.felt(), tiny);
}

TEST(TabletControl, WithABallThePressedStylusRestsHigherInTheGroove) {
  test::RunningTablet controller;
  controller.set_tablet(one_groove());
  ASSERT_TRUE(controller.start());
  controller.move_stylus({0, 0}, true);
  double low_m = 0;
  ASSERT_TRUE(controller.wait_for([&] {
    low_m = controller.latest().proxy_m.z;
    return controller.latest().touching && low_m < -0.001;
  }));
  controller.set_tip(0.003);
  EXPECT_EQ(controller.tip_radius_m(), 0.003);
  EXPECT_EQ(controller.tablet()->tip_radius_m(), 0) << "what is drawn stays the same";
  EXPECT_TRUE(controller.wait_for([&] { return controller.latest().proxy_m.z > low_m + 0.0005; }));
  controller.set_tip(0);
  EXPECT_TRUE(controller.wait_for([&] { return controller.latest().proxy_m.z < low_m + 0.0002; }));
}

}  // namespace
}  // namespace nazori::practice
