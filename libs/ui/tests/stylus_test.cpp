// SPDX-License-Identifier: Apache-2.0
#include "stylus.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <array>

#include "scripted_device.h"

namespace nazori::ui {
namespace {

TEST(Stylus, ADeviceThatIsFoundInTheMiddleOfAStrokeWaitsForItsEnd) {
  const auto script = std::make_shared<test::Script>();
  Stylus stylus;
  stylus.set_devices(test::only(script), {}, {});
  ASSERT_TRUE(stylus.start());
  bool is_pressed = false;
  QObject::connect(&stylus, &Stylus::sampled, &stylus, [&](std::span<const haptics::ServoSample> taken) {
    is_pressed = taken.back().buttons != 0;
  });
  const auto comes = [&](const auto& truth) {
    return QTest::qWaitFor(
        [&] {
          std::array<haptics::ServoSample, 256> samples;
          (void)stylus.take_samples(samples);
          return truth();
        },
        20'000);
  };
  stylus.move({0, 0, 0.01, true, true});
  ASSERT_TRUE(comes([&] { return is_pressed; }));
  const QSignalSpy searched(&stylus, &Stylus::searched);
  stylus.choose("scripted:arm");
  ASSERT_TRUE(comes([&] { return searched.count() == 1; }));
  ASSERT_EQ(script->opened, 1);
  EXPECT_TRUE(stylus.is_pointer());
  // Long enough for it to have been asked a second time whether the stroke is over.
  const auto ticks = stylus.timing().ticks;
  ASSERT_TRUE(comes([&] { return !stylus.is_pointer() || stylus.timing().ticks > ticks + 500; }));
  EXPECT_TRUE(stylus.is_pointer());
  stylus.move({0, 0, 0, false, true});
  EXPECT_TRUE(comes([&] { return !stylus.is_pointer(); }));
  EXPECT_EQ(script->opened, 1) << "it was open already";
}

}  // namespace
}  // namespace nazori::ui
