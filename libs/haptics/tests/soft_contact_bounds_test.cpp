// SPDX-License-Identifier: Apache-2.0
// A soft tip at its bounds, in every direction and after it was lifted.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "nazori/haptics/soft_contact.h"
#include "soft_tip_under_test.h"

namespace nazori::haptics {
namespace {

TEST(SoftTipTable, EveryValueHasItsBounds) {
  const auto with = [](auto change) {
    SoftTip tip = brush();
    change(tip);
    return SoftTipTable(tip, 500, 3.3);
  };
  for (const auto& [given, kept] : {std::pair{-1.0, 0.0}, {5.0, 5.0}, {11.0, 10.0}, {kNan, 0.0}})
    EXPECT_EQ(with([v = given](SoftTip& t) { t.friction = v; }).friction(), kept);
  for (const auto& [given, kept] : {std::pair{-1.0, 0.0}, {0.7, 0.7}, {1.5, 1.0}, {kNan, 0.0}})
    EXPECT_EQ(with([v = given](SoftTip& t) { t.along_hair = v; }).along_hair(), kept);
  for (const auto& [given, kept] : {std::pair{0.0, 1e-3}, {30.0, 30.0}, {700.0, 500.0}, {kNan, 1e-3}})
    EXPECT_EQ(with([v = given](SoftTip& t) { t.sideways_n_m = v; }).sideways_n_m(), kept);
  EXPECT_EQ(SoftTipTable(brush(), 0, 3.3).sideways_n_m(), 1e-3) << "a device that renders no stiffness";
  for (const auto& [given, kept] : {std::pair{0.0, 1e-4}, {0.5, 0.5}, {3.0, 1.0}, {kNan, 1e-4}})
    EXPECT_EQ(with([v = given](SoftTip& t) { t.tow_m = v; }).tow_m(), kept);
  for (const auto& [given, exists] : {std::pair{9e-7, false}, {1.2e-6, true}, {0.99, true}, {1.1, false}})
    EXPECT_EQ(with([v = given](SoftTip& t) { t.step_m = v; }).exists(), exists) << given;
  for (const std::size_t values : {0U, 1U, 2U})
    EXPECT_EQ(with([values](SoftTip& t) { t.push_n.resize(values); }).exists(), values == 2);
}

TEST(SoftTipTable, WithoutStiffnessNothingPushes) {
  const SoftTipTable none(brush(), 0, 3.3);
  ASSERT_TRUE(none.exists());
  EXPECT_EQ(none.push_n(0.01), 0);
}

/// A path in many directions, up and down.
Vec3 wandering(int i) {
  return {0.012 * std::sin(0.021 * i), 0.009 * std::sin(0.034 * i + 1), -0.006 - 0.005 * std::sin(0.013 * i)};
}

TEST(SoftContact, FeelsTheSameInEveryDirection) {
  const SoftTipTable tip = table();
  for (const double turn : {std::numbers::pi / 2, 0.7}) {
    const double c = std::cos(turn), s = std::sin(turn);
    const auto turned = [&](const Vec3& v) { return Vec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z); };
    SoftContact one, other;
    for (int i = 0; i < 1500; ++i) {
      one.update(tip, wandering(i));
      other.update(tip, turned(wandering(i)));
      ASSERT_LT(glm::length(turned(one.force_n()) - other.force_n()), 1e-9) << i;
      ASSERT_NEAR(one.stored_j(), other.stored_j(), 1e-12);
    }
  }
}

TEST(SoftContact, StoresWhatTheTipAndItsStretchHold) {
  const SoftTipTable tip = table();
  SoftContact contact;
  for (int i = 0; i < 1500; ++i) {
    contact.update(tip, wandering(i));
    const double side = sideways(contact.force_n());
    const double depth = -wandering(i).z;
    ASSERT_NEAR(contact.stored_j(), tip.stored_j(depth) + 0.5 * side * side / tip.sideways_n_m(), 1e-12);
  }
}

TEST(SoftContact, AfterItIsForgottenOrLiftedItFeelsAsTheFirstTime) {
  const SoftTipTable tip = table();
  for (const bool lifted : {false, true}) {
    SoftContact used, fresh;
    for (int i = 0; i < 700; ++i) used.update(tip, wandering(i));
    if (lifted)
      used.update(tip, {0, 0, 0});
    else
      used.forget();
    EXPECT_EQ(used.force_n(), Vec3(0));
    EXPECT_EQ(used.stored_j(), 0);
    EXPECT_FALSE(used.touching());
    for (int i = 700; i < 900; ++i) {
      used.update(tip, wandering(i));
      fresh.update(tip, wandering(i));
      ASSERT_EQ(used.force_n(), fresh.force_n()) << i;
    }
  }
}

}  // namespace
}  // namespace nazori::haptics
