// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/plot_hand.h"

#include <gtest/gtest.h>

#include "nazori/practice/tablet_plot.h"
#include "running_tablet.h"

namespace nazori::practice {
namespace {

using geometry::TabletPoint;
using Way = functions::PlotExplorer::Way;

/// A parabola on a running tablet.
class PlotHandTest : public testing::Test {
 protected:
  void SetUp() override {
    functions::PlotRequest request;
    request.plot = *functions::parse("y = x^2 - 1");
    request.window = {-3, 3, -3, 3};
    request.plate.size = 128;
    const auto done = functions::draw_plot(request, [this](functions::Drawing&& drawing) {
      plot_ = *on_tablet(std::move(drawing));
      return true;
    });
    ASSERT_TRUE(done);
    ASSERT_TRUE(tablet_.start());
    tablet_.set_tablet(plot_.tablet);
    explorer_.show(plot_.drawing);
  }
  /// Whether the pressed stylus has arrived at a place.
  [[nodiscard]] bool arrives(TabletPoint at) {
    return tablet_.wait_for([&] {
      const auto& sample = tablet_.latest();
      return sample.touching &&
             geometry::distance(TabletPoint{sample.proxy_m.x, sample.proxy_m.y}, at) < 0.5e-3;
    });
  }
  /// Puts the stylus on the curve, as keys do.
  TabletPoint put_by_key() {
    explorer_.go_to_end(Way::back);
    const auto at = hand_.put();
    EXPECT_TRUE(at);
    hand_.press(*at);
    EXPECT_TRUE(arrives(*at));
    return *at;
  }

  TabletPlot plot_;
  test::RunningTablet tablet_;
  functions::PlotExplorer explorer_;
  PlotHand hand_{tablet_, explorer_};
};

TEST_F(PlotHandTest, TheStylusIsLiftedOnALongWayAndPressedDuringAStep) {
  EXPECT_FALSE(hand_.is_put());
  explorer_.go_to_end(Way::back);
  const auto first = hand_.put();
  ASSERT_TRUE(first);
  EXPECT_TRUE(hand_.is_put());
  EXPECT_FALSE(tablet_.is_pressed());
  hand_.press(*first);
  EXPECT_TRUE(tablet_.is_pressed());
  explorer_.step(Way::on);
  EXPECT_FALSE(hand_.put()) << "a step of one millimetre";
  EXPECT_TRUE(tablet_.is_pressed());
  explorer_.go_to_end(Way::on);
  const auto far = hand_.put();
  ASSERT_TRUE(far);
  EXPECT_FALSE(tablet_.is_pressed());
  EXPECT_GT(far->x, first->x);
}

TEST_F(PlotHandTest, AStylusThatWasPutElsewhereMeanwhileIsNotPressedWhereItWas) {
  explorer_.go_to_end(Way::back);
  const auto first = hand_.put();
  explorer_.go_to_end(Way::on);
  const auto second = hand_.put();
  ASSERT_TRUE(first && second);
  hand_.press(*first);
  EXPECT_FALSE(tablet_.is_pressed());
  hand_.press(*second);
  EXPECT_TRUE(tablet_.is_pressed());
}

TEST_F(PlotHandTest, WhereAKeyPutTheStylusNothingNewIsFelt) {
  put_by_key();
  EXPECT_FALSE(hand_.follow());
  EXPECT_TRUE(hand_.is_put());
}

TEST_F(PlotHandTest, AHandThatMovesTheStylusFeelsTheCurveItTouches) {
  const TabletPoint put = put_by_key();
  // The vertex of the parabola, (0, -1).
  const auto size = plot_.drawing->picture.plate.heights.size();
  const TabletPoint vertex = functions::tablet_place({0.5, 1.0 / 3}, size, plot_.tablet->shape());
  ASSERT_GT(geometry::distance(put, vertex), 0.01);
  tablet_.move_stylus(vertex, true);
  ASSERT_TRUE(arrives(vertex));
  const auto felt = hand_.follow();
  ASSERT_TRUE(felt);
  EXPECT_FALSE(hand_.is_put());
  EXPECT_NEAR(felt->at.u, 0.5, 0.01);
  EXPECT_NEAR(felt->at.v, 1.0 / 3, 0.01);
  ASSERT_NE(felt->touch.reached, nullptr);
  EXPECT_EQ(felt->touch.reached->kind, functions::PointKind::minimum);
  EXPECT_GT(felt->touch.cue.loudness, 0);
  tablet_.lift_stylus();
  ASSERT_TRUE(tablet_.wait_for([this] { return !tablet_.latest().touching; }));
  const auto lifted = hand_.follow();
  ASSERT_TRUE(lifted) << "the sound of the touch must end";
  EXPECT_EQ(lifted->touch.cue.loudness, 0);
  EXPECT_EQ(lifted->touch.reached, nullptr);
}

TEST_F(PlotHandTest, ACoarsePictureIsSilent) {
  auto coarse = std::make_shared<functions::Drawing>(*plot_.drawing);
  coarse->final = false;
  explorer_.show(coarse);
  tablet_.move_stylus({0, 0}, true);
  ASSERT_TRUE(tablet_.wait_for([this] { return tablet_.latest().touching; }));
  const auto felt = hand_.follow();
  ASSERT_TRUE(felt);
  EXPECT_EQ(felt->touch.cue.loudness, 0);
}

}  // namespace
}  // namespace nazori::practice
