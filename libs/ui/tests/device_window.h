// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "characters/characters.h"
#include "device/device_page.h"
#include "nazori/widgets/page/window_parts.h"
#include "scripted_device.h"
#include "window_under_test.h"

namespace nazori::ui::test {

inline WindowParts* parts_under_test = nullptr;

template <class T>
std::unique_ptr<Page> make_page(WindowParts& parts) {
  parts_under_test = &parts;
  return std::make_unique<T>(parts);
}

/// The real window with a scripted device that the test moves.
class Device : public WindowTest {
 protected:
  Device() {
    pages_ = {make_page<Characters>, make_page<DevicePage>};
    back_ends_ = [script = script_] {
      std::vector<std::unique_ptr<devices::BackEnd>> all;
      all.push_back(std::make_unique<devices::test::ScriptedBackEnd>(script));
      all.push_back(devices::pointer_back_end());
      return all;
    };
  }
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(QTest::qWaitFor([&] { return text("device") == QStringLiteral("Scripted arm"); }));
  }
  void open_window_with_simulations() {
    back_ends_ = [] {
      std::vector<std::unique_ptr<devices::BackEnd>> all;
      all.push_back(devices::pointer_back_end());
      all.push_back(devices::simulated_back_end());
      return all;
    };
    open_window();
  }
  practice::TabletControl& controller() { return parts_under_test->tablet(); }
  devices::TabletDevice& stylus() { return controller().device(); }
  bool says(const QString& part) {
    return QTest::qWaitFor([&] { return feedback().contains(part); }, 5000);
  }
  /// Presses the tip this deep below the plateau, away from the grooves of 休, and waits until it is there.
  void press_to(double z_m) {
    script_->x_m = script_->y_m = 0.049;
    script_->z_m = 0.002;
    ASSERT_TRUE(ticks_pass(400));  // more than the ramp
    script_->z_m = z_m;
    ASSERT_TRUE(ticks_pass(600));
  }
  /// The force once 200 ticks change it no more, in newtons: on a busy machine it takes longer to fade in.
  double settled_force_n() {
    double before_n = script_->force_n;
    while (ticks_pass(200) && std::abs(script_->force_n - before_n) > 1e-6) before_n = script_->force_n;
    return before_n;
  }
  /// Waits for this many ticks of the servo (milliseconds), even on a busy machine.
  bool ticks_pass(std::uint64_t count) {
    const std::uint64_t from = script_->ticks;
    return QTest::qWaitFor([&] { return script_->ticks >= from + count; }, 60'000);
  }

  std::shared_ptr<devices::test::Script> script_ = std::make_shared<devices::test::Script>();
};

}  // namespace nazori::ui::test
