// SPDX-License-Identifier: Apache-2.0
#include "../src/roots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nazori::functions {
namespace {

constexpr double kPi = std::numbers::pi;

Expression sine_of(double times) {
  return call(Function::sin, {binary(NodeKind::multiply, number(times), variable(Variable::x))});
}

TEST(Roots, TwelveThousandZerosOfASineAreAllFound) {
  constexpr int kEachSide = 6000;
  const double times = (kEachSide + 0.25) * kPi / 5;
  const Roots found = find_roots(sine_of(times), Variable::x, -5, 5);
  EXPECT_EQ(found.undecided, 0);
  ASSERT_EQ(found.roots.size(), static_cast<std::size_t>(2 * kEachSide + 1));
  for (int n = -kEachSide; n <= kEachSide; ++n) {
    const Root& root = found.roots[static_cast<std::size_t>(n + kEachSide)];
    ASSERT_NEAR(root.at, n * kPi / times, 1e-12) << n;
    ASSERT_TRUE(root.crosses) << n;
  }
}

TEST(Roots, WhereThereAreTooManyToFindThemAllThatIsSaid) {
  const Roots found = find_roots(sine_of(1e5), Variable::x, -5, 5);
  EXPECT_EQ(found.undecided, 1);
  ASSERT_FALSE(found.roots.empty());
  EXPECT_LT(found.roots.size(), 318'309U);
  // Those found are correct.
  for (const Root& root : found.roots) {
    const double n = std::round(root.at * 1e5 / kPi);
    ASSERT_NEAR(root.at, n * kPi / 1e5, 1e-12);
  }
}

}  // namespace
}  // namespace nazori::functions
