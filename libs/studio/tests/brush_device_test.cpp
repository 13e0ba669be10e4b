// SPDX-License-Identifier: Apache-2.0
// The page for the brush with a force-feedback device.
#include "brush_page_under_test.h"
#include "nazori/devices/device_catalogue.h"
#include "scripted_device.h"

namespace nazori::ui::test {
namespace {

class BrushDeviceTest : public BrushPageTest {
 protected:
  void open_device() {
    auto& tablet = parts_.tablet();
    tablet.device().set_devices(devices::test::only(script_), {}, {});
    ASSERT_TRUE(tablet.start());
    tablet.device().choose("scripted:arm");
    wait_until([&] { return !tablet.device().is_pointer(); });
  }
  /// Moves the stylus and waits until the servo has seen it.
  void hold(double x_m, double y_m, double z_m) {
    script_->x_m = x_m;
    script_->y_m = y_m;
    script_->z_m = z_m;
    const std::uint64_t from = script_->ticks;
    wait_until([&] { return script_->ticks > from + 20; });
  }
  void write_with_device() {
    hold(-0.02, 0, 0.01);
    for (int i = 0; i <= 20; ++i) hold(-0.02 + 0.002 * i, 0, -0.005);
    hold(0.02, 0, 0.01);
  }

  std::shared_ptr<devices::test::Script> script_ = std::make_shared<devices::test::Script>();
};

TEST_F(BrushDeviceTest, WritesAndIsFelt) {
  open_device();
  write_with_device();
  wait_until([this] { return state().strokes == 1 && !state().is_writing; });
  EXPECT_GT(script_->most_force_n, 0.02);
  EXPECT_LE(script_->most_force_n, 1.5);
  hold(0, 0, -0.005);
  wait_until([this] { return state().is_writing; });
  page_->leave();
  wait_until([this] { return !state().is_writing; });
  hold(0.01, 0, -0.005);
  EXPECT_EQ(state().strokes, 2) << "another page has the device";
}

TEST_F(BrushDeviceTest, TellsHowToWriteWithIt) {
  page_->leave();
  open_device();
  said_.clear();
  page_->enter();
  EXPECT_EQ(
      all_said(),
      "Lower the stylus onto the sheet: you feel the brush. A button of the stylus, or I: ink. S: what is on "
      "the sheet.");
}

TEST_F(BrushDeviceTest, AButtonOfTheStylusDipsTheBrush) {
  open_device();
  by(actions().wipe);
  ASSERT_LT(state().fullness, 0.6);
  script_->buttons = 1;
  wait_until([this] { return state().fullness > 0.99; });
  EXPECT_TRUE(all_said().contains("Dipped in ink."));
}

TEST_F(BrushDeviceTest, TheForceIsStrengthenedUntilItIsSwitchedOffAndThisIsKept) {
  EXPECT_TRUE(actions().strengthen->isChecked());
  open_device();
  hold(0, 0, -0.005);
  wait_until([this] { return script_->force_n > 0.05; });
  const double strong_n = script_->force_n;
  EXPECT_EQ(by(actions().strengthen), "The device pushes as hard as the brush.");
  wait_until([&] { return script_->force_n < 0.5 * strong_n; });
  keep_settings(*page_);
  open_page();
  EXPECT_FALSE(actions().strengthen->isChecked());
  EXPECT_EQ(by(actions().strengthen), "The device pushes four times as hard as the brush.");
}

TEST_F(BrushDeviceTest, ATeacherLeadsTheHandThroughTheModel) {
  take_model("一", 1);
  open_device();
  actions().watch->trigger();
  wait_until([this] { return !said_.isEmpty(); });
  EXPECT_EQ(all_said(), "Hold the stylus loosely: it leads your hand through 1 strokes. V: stop.");
  EXPECT_EQ(by(actions().watch), "Stopped.");
  actions().watch->trigger();
  wait_until([this] { return all_said().contains("Hold the stylus"); });
  const auto& line = paper().model()[0].points;
  hold(line.front().x, line.front().y, 0.01);
  // As a hand that follows: along the line, a little deeper than the paper.
  for (const auto& at : line) hold(at.x, at.y, -0.006);
  wait_until([this] { return all_said().contains("That is how it is written."); });
  hold(line.back().x, line.back().y, 0.01);
  wait_until([this] { return state().strokes == 1 && !state().is_writing; });
}

TEST_F(BrushDeviceTest, TheMouseIsTheHandOfASimulatedDevice) {
  std::vector<std::unique_ptr<devices::BackEnd>> all;
  all.push_back(devices::simulated_back_end());
  auto& tablet = parts_.tablet();
  tablet.device().set_devices(std::move(all), {}, {});
  ASSERT_TRUE(tablet.start());
  tablet.device().choose("simulated:touch");
  wait_until([&] { return !tablet.device().is_pointer(); });
  const auto move = [this](double x, bool down) {
    brush::PenSample sample;
    sample.time_s = time_s_ += 0.02;
    sample.at = {x, 0};
    sample.down = down;
    emit paper().pen_moved(sample);
  };
  for (int i = 0; i <= 20; ++i) {
    move(-0.02 + 0.002 * i, true);
    QTest::qWait(10);
  }
  wait_until([&] { return tablet.latest().device_m.x > 0.018 && tablet.latest().device_m.z < 0; });
  EXPECT_GT(tablet.latest().force_n.z, 0);
  move(0.02, false);
  wait_until([this] { return state().strokes == 1 && !state().is_writing; });
}

}  // namespace
}  // namespace nazori::ui::test
