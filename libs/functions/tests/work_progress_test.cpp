// SPDX-License-Identifier: Apache-2.0
#include "../src/work_progress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../src/simplest_between.h"

namespace nazori::functions {
namespace {

TEST(WorkProgress, PartsFillTheWholeAndNeverGoBack) {
  std::vector<double> reported;
  std::string step;
  const base::Progress caller = [&](double done, std::string_view name) {
    reported.push_back(done);
    step = name;
    return true;
  };
  WorkProgress work(caller);
  work.begin_part(0.2, 0.6, "first");
  EXPECT_EQ(step, "first");
  EXPECT_TRUE(work.report(0.5));
  EXPECT_TRUE(work.report(0.25));
  EXPECT_TRUE(work.report(7));
  work.begin_part(0.6, 1, "second");
  EXPECT_EQ(step, "second");
  EXPECT_TRUE(work.report(1));
  const std::vector<double> wanted{0.2, 0.4, 0.4, 0.6, 0.6, 1};
  ASSERT_EQ(reported.size(), wanted.size());
  for (std::size_t i = 0; i < reported.size(); ++i) EXPECT_NEAR(reported[i], wanted[i], 1e-12) << i;
  EXPECT_FALSE(work.is_stopped());
  EXPECT_FALSE(work.is_late());
}

TEST(WorkProgress, WhoeverWasStoppedIsNotAskedAgain) {
  int asked = 0;
  const base::Progress caller = [&](double, std::string_view) { return ++asked < 2; };
  WorkProgress work(caller);
  EXPECT_TRUE(work.report(0.1));
  EXPECT_FALSE(work.report(0.2));
  EXPECT_FALSE(work.report(0.3));
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(work.is_stopped());
  EXPECT_FALSE(work.is_late());
  EXPECT_TRUE(work.is_in_time());
}

TEST(WorkProgress, WithoutAnyoneToAskItGoesOn) {
  const base::Progress nobody;
  WorkProgress work(nobody);
  work.begin_part(0, 1, "all");
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(work.report(0.5) && work.is_in_time());
  EXPECT_FALSE(work.is_stopped());
}

TEST(WorkProgress, WhenTheTimeIsOutItStaysOut) {
  const base::Progress nobody;
  WorkProgress work(nobody, 1e-9);
  int before = 0;
  while (work.is_in_time() && before < 1'000) ++before;
  EXPECT_EQ(before, 15) << "the clock is looked at every sixteenth time";
  EXPECT_FALSE(work.report(0.5));
  EXPECT_TRUE(work.is_stopped());
  EXPECT_TRUE(work.is_late());
  WorkProgress patient(nobody, 1e9);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(patient.is_in_time());
}

TEST(SimplestBetween, IsTheNumberWithTheFewestDecimals) {
  EXPECT_EQ(simplest_between(0.9, 1.2), 1);
  EXPECT_EQ(simplest_between(-0.4, 0.3), 0);
  EXPECT_FALSE(std::signbit(simplest_between(-0.4, 0.3)));
  EXPECT_EQ(simplest_between(0.31, 0.34), 0.33) << "0.3 lies outside, 0.325 is rounded up";
  EXPECT_EQ(simplest_between(0.28, 0.31), 0.3);
  EXPECT_EQ(simplest_between(-12.4, -12.36), -12.4);
  EXPECT_EQ(simplest_between(2, 2), 2);
  EXPECT_EQ(simplest_between(0.1 + 1e-14, 0.1 + 2e-14) > 0.1, true);
  const double tiny = simplest_between(1e-20, 3e-20);
  EXPECT_NEAR(tiny, 2e-20, 1e-33);
  EXPECT_EQ(simplest_between(1e308, 1.7e308) >= 1e308, true);
}

}  // namespace
}  // namespace nazori::functions
