// SPDX-License-Identifier: Apache-2.0
// Every sample of a pen that writes what a request says.
#include "practised_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/executor.h"

namespace nazori::cli::test {
namespace {

using writing::WritingBox;
using writing::WrittenPoint;

// A tablet is 0.1 m wide. The tip is 5 mm above it or 5 mm in it, and full pressure is 15 mm more.
constexpr double kAbove_m = 0.005;
constexpr double kBetween_s = 0.008;

class PractisedHands : public testing::Test {
 protected:
  PractisedHands() {
    tablet_.sampled.connect([this](std::span<const haptics::ServoSample> samples) {
      samples_.insert(samples_.end(), samples.begin(), samples.end());
    });
  }
  void write(const std::vector<WrittenPoint>& stroke) { hand_.write(stroke, kBox); }
  void expect(std::size_t i, double time_s, double x_m, double y_m, double pressure) const {
    ASSERT_LT(i, samples_.size());
    const haptics::ServoSample& sample = samples_[i];
    EXPECT_NEAR(sample.time_s, time_s, 1e-12) << i;
    EXPECT_TRUE(sample.touching) << i;
    EXPECT_NEAR(sample.proxy_m.x, x_m, 1e-12) << i;
    EXPECT_NEAR(sample.proxy_m.y, y_m, 1e-12) << i;
    EXPECT_NEAR(sample.proxy_m.z, -kAbove_m, 1e-12) << i;
    EXPECT_NEAR(sample.device_m.x, x_m, 1e-12) << i;
    EXPECT_NEAR(sample.device_m.y, y_m, 1e-12) << i;
    EXPECT_NEAR(sample.device_m.z, -kAbove_m - 0.015 * pressure, 1e-12) << i;
  }
  void expect_lifted(std::size_t i, double time_s, double x_m, double y_m) const {
    ASSERT_LT(i, samples_.size());
    const haptics::ServoSample& sample = samples_[i];
    EXPECT_NEAR(sample.time_s, time_s, 1e-12) << i;
    EXPECT_FALSE(sample.touching) << i;
    EXPECT_NEAR(sample.proxy_m.x, x_m, 1e-12) << i;
    EXPECT_NEAR(sample.proxy_m.y, y_m, 1e-12) << i;
    EXPECT_EQ(sample.proxy_m.z, kAbove_m) << i;
    EXPECT_EQ(sample.device_m.z, kAbove_m) << i;
  }

  /// (11, 21) is the middle of the tablet, and 0.02 of this box are a millimetre.
  static constexpr WritingBox kBox{{10, 20}, 2};
  base::Inbox inbox_;
  base::SystemClock clock_;
  practice::TabletControl tablet_{inbox_, clock_, {}};
  PractisedHand hand_{tablet_};
  std::vector<haptics::ServoSample> samples_;
};

TEST_F(PractisedHands, WithoutTimesItGoesInStepsOfEightTenthsOfAMillimetreAndRestsAtTheEnd) {
  write({{{11, 21}}, {{11.04, 20.97}}});
  // 2.5 mm along the hypotenuse of 2 and 1.5: four steps.
  ASSERT_EQ(samples_.size(), 1U + 1 + 4 + 12 + 1);
  expect_lifted(0, kBetween_s, 0, 0);
  expect(1, 2 * kBetween_s, 0, 0, 0.4);
  for (std::size_t k = 1; k <= 4; ++k) {
    const auto step = static_cast<double>(k);
    expect(1 + k, (2 + step) * kBetween_s, 0.002 * step / 4, 0.0015 * step / 4, 0.4);
  }
  for (std::size_t k = 6; k < 18; ++k) expect(k, static_cast<double>(k + 1) * kBetween_s, 0.002, 0.0015, 0.4);
  expect_lifted(18, 19 * kBetween_s, 0.002, 0.0015);
}

TEST_F(PractisedHands, WithTimesAndPressuresItTakesThemAndIsLiftedAtOnce) {
  write({{{11, 21}, 5.0, 0.5}, {{11.03, 21}, 5.3, 1.0}, {{11.03, 21.01}, 5.4, 0.0}});
  // 1.5 mm in two steps of 0.15 s, then 0.5 mm in one of 0.1 s.
  ASSERT_EQ(samples_.size(), 6U);
  expect_lifted(0, kBetween_s, 0, 0);
  expect(1, 2 * kBetween_s, 0, 0, 0.5);
  expect(2, 2 * kBetween_s + 0.15, 0.00075, 0, 1);
  expect(3, 2 * kBetween_s + 0.30, 0.0015, 0, 1);
  expect(4, 2 * kBetween_s + 0.40, 0.0015, -0.0005, 0);
  expect_lifted(5, 3 * kBetween_s + 0.40, 0.0015, -0.0005);
}

TEST_F(PractisedHands, TimesThatDoNotAscendCountAsUnknownForThatStep) {
  write({{{11, 21}, 5.0}, {{11.01, 21}, 5.0}, {{11.02, 21}, 4.0}, {{11.03, 21}, 4.5}});
  ASSERT_EQ(samples_.size(), 6U);
  expect(2, 3 * kBetween_s, 0.0005, 0, 0.4);
  expect(3, 4 * kBetween_s, 0.001, 0, 0.4);
  expect(4, 4 * kBetween_s + 0.5, 0.0015, 0, 0.4);
}

TEST_F(PractisedHands, APointIsADotOfOneTouchAndItsRest) {
  write({{{11, 21}, {}, 1.0}});
  ASSERT_EQ(samples_.size(), 1U + 1 + 12 + 1);
  for (std::size_t k = 1; k < 14; ++k) expect(k, static_cast<double>(k + 1) * kBetween_s, 0, 0, 1);
  expect_lifted(14, 15 * kBetween_s, 0, 0);
}

TEST_F(PractisedHands, TheClockGoesOnFromStrokeToStrokeAndAnEmptyOneIsNone) {
  write({{{11, 21}, 0.0}});
  write({});
  write({{{10, 20}, 0.0}});
  ASSERT_EQ(samples_.size(), 6U);
  expect_lifted(2, 3 * kBetween_s, 0, 0);
  expect_lifted(3, 4 * kBetween_s, -0.05, 0.05);
  expect(4, 5 * kBetween_s, -0.05, 0.05, 0.4);
  expect_lifted(5, 6 * kBetween_s, -0.05, 0.05);
}

}  // namespace
}  // namespace nazori::cli::test
