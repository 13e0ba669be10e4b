// SPDX-License-Identifier: Apache-2.0
// The parts of the grader by closed forms and brute force.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>
#include <string>

#include "assignment.h"
#include "fit.h"
#include "shape.h"
#include "stroke_order_mistakes.h"
#include "stroke_picture.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;

TEST(Assignment, IsTheCheapestOfAllPermutations) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> cost(0, 10);
  for (int round = 0; round < 200; ++round) {
    constexpr std::size_t kSize = 5;
    std::vector<float> costs(kSize * kSize);
    for (auto& c : costs) c = cost(random);
    const auto total = [&costs](const std::vector<std::size_t>& columns) {
      float sum = 0;
      for (std::size_t i = 0; i < columns.size(); ++i) sum += costs[i * kSize + columns[i]];
      return sum;
    };
    std::vector<std::size_t> order(kSize);
    std::iota(order.begin(), order.end(), 0U);
    float best = 1e9F;
    do best = std::min(best, total(order));
    while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(total(assign(costs, kSize)), best, 1e-4F);
  }
}

Shape shape(std::vector<double> xs, std::vector<double> ys) { return make_shape(xs, ys); }

TEST(Fit, FindsSizeAndPlaceExactly) {
  const auto m1 = shape({10, 90}, {20, 25});
  const auto m2 = shape({50, 48}, {10, 100});
  const Affine truth{0.01, 0, 3, 0, 0.01, -2};
  const auto d1 = transformed(m1.whole, truth);
  const auto d2 = transformed(m2.whole, truth);
  const std::vector<FitPair> pairs{{&d1, &m1.whole, false, 1}, {&d2, &m2.whole, false, 1}};
  const auto map = fit(pairs, 100);
  EXPECT_NEAR(map.a, 100, 0.05);
  EXPECT_NEAR(map.d, 100, 0.05);
  EXPECT_NEAR(map.b, 0, 0.05);
  EXPECT_NEAR(map.a * 3 + map.b * -2 + map.tx, 0, 0.1);
}

TEST(Fit, DoesNotTurnASingleBarIntoAVertical) {
  const auto bar = shape({10, 90}, {50, 50});
  const auto vertical = shape({50, 50}, {10, 90});
  const std::vector<FitPair> pairs{{&vertical.whole, &bar.whole, false, 1}};
  const auto map = fit(pairs, 1);
  const auto mapped = transformed(vertical.whole, map);
  EXPECT_GT(std::abs(mapped.y.back() - mapped.y.front()), 2 * std::abs(mapped.x.back() - mapped.x.front()));
}

TEST(Shape, SamplesAreEvenAndKeepTheEnds) {
  const std::vector<double> xs{0, 10, 10};
  const std::vector<double> ys{0, 0, 13};
  const auto s = sample_line(xs, ys);
  EXPECT_FLOAT_EQ(s.length, 23);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const auto at = static_cast<float>(k);
    EXPECT_NEAR(s.x[k], std::min(at, 10.0F), 1e-4F);
    EXPECT_NEAR(s.y[k], std::max(at - 10.0F, 0.0F), 1e-4F);
  }
}

TEST(Shape, AKickIsFoundAndALongLegIsNone) {
  const auto kicked = shape({50, 50, 40}, {0, 80, 70});
  ASSERT_TRUE(kicked.body);
  EXPECT_NEAR(kicked.body->y.back(), 80, 4);
  EXPECT_NEAR(kicked.body->x.back(), 50, 1);
  EXPECT_FALSE(shape({0, 80, 80}, {0, 0, 60}).body);
  EXPECT_FALSE(shape({0, 80}, {0, 10}).body);
}

std::vector<Link> links(const std::vector<int>& order) {
  std::vector<Link> result;
  for (std::size_t i = 0; i < order.size(); ++i) result.push_back({static_cast<int>(i), 1, order[i], 1, {}});
  return result;
}

TEST(StrokesOutOfTurn, NamesTheFewest) {
  EXPECT_TRUE(strokes_out_of_turn(links({0, 1, 2, 3})).empty());
  EXPECT_TRUE(strokes_out_of_turn(links({0, 2, 3})).empty());
  const auto exchanged = strokes_out_of_turn(links({0, 3, 2, 1, 4}));
  ASSERT_EQ(exchanged.size(), 1U);
  EXPECT_THAT(exchanged[0].misplaced, ElementsAre(1, 3));
  const auto moved = strokes_out_of_turn(links({0, 2, 3, 4, 1}));
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_THAT(moved[0].misplaced, ElementsAre(4));
  EXPECT_EQ(moved[0].drawn, 1) << "the first that came before it";
  EXPECT_EQ(moved[0].before, 4);
  const auto early = strokes_out_of_turn(links({4, 0, 1, 2, 3}));
  ASSERT_EQ(early.size(), 1U);
  EXPECT_THAT(early[0].misplaced, ElementsAre(0));
  EXPECT_EQ(early[0].drawn, 0);
}

TEST(StrokesOutOfTurn, OfEquallyFewTheLaterDrawnAreNamed) {
  // Either of the first two may be out of order, besides the last: no single exchange corrects it.
  const auto mistakes = strokes_out_of_turn(links({1, 0, 2, 4, 5, 3}));
  ASSERT_EQ(mistakes.size(), 2U);
  EXPECT_THAT(mistakes[0].misplaced, ElementsAre(1));
  EXPECT_EQ(mistakes[0].drawn, 0);
  EXPECT_EQ(mistakes[0].before, 1);
  EXPECT_THAT(mistakes[1].misplaced, ElementsAre(5));
  EXPECT_EQ(mistakes[1].drawn, 3);
  EXPECT_EQ(mistakes[1].before, 5);
}

/// The order mistakes by definition: the fewest strokes are moved.
TEST(StrokesOutOfTurn, AreTheFewestThatMendTheOrderWhateverItIs) {
  std::vector<int> order{0, 1, 2, 3, 4, 5};
  do {
    const auto mistakes = strokes_out_of_turn(links(order));
    std::vector<std::size_t> off;
    for (std::size_t i = 0; i < order.size(); ++i)
      if (order[i] != static_cast<int>(i)) off.push_back(i);
    if (off.empty()) {
      EXPECT_TRUE(mistakes.empty());
      continue;
    }
    const std::string name = testing::PrintToString(order);
    if (off.size() == 2) {
      const int first = static_cast<int>(off[0]), second = static_cast<int>(off[1]);
      ASSERT_EQ(mistakes.size(), 1U) << name;
      EXPECT_EQ(mistakes[0].drawn, first) << name;
      EXPECT_EQ(mistakes[0].before, second) << name;
      EXPECT_THAT(mistakes[0].misplaced, ElementsAre(first, second)) << name;
      continue;
    }
    // The longest ascending sequence by trying all of them; of those equally long the one whose strokes came
    // first.
    unsigned best = 0;
    const auto length = [](unsigned set) { return std::popcount(set); };
    for (unsigned set = 1; set < 64; ++set) {
      int last = -1;
      bool ascends = true;
      for (std::size_t i = 0; i < 6; ++i)
        if ((set >> i & 1U) != 0) {
          ascends = ascends && order[i] > last;
          last = order[i];
        }
      if (ascends && length(set) > length(best)) best = set;
    }
    ASSERT_EQ(mistakes.size(), 6U - static_cast<std::size_t>(length(best))) << name;
    unsigned kept = 63;
    for (const auto& f : mistakes) {
      ASSERT_EQ(f.misplaced.size(), 1U) << name;
      kept &= ~(1U << static_cast<unsigned>(f.misplaced[0]));
    }
    int last = -1;
    for (std::size_t i = 0; i < 6; ++i) {
      if ((kept >> i & 1U) == 0) continue;
      EXPECT_GT(order[i], last) << name << ": what is left is in order";
      last = order[i];
    }
    for (const auto& f : mistakes) {
      const auto moved = static_cast<std::size_t>(f.misplaced[0]);
      // Reported for the stroke that came too early: the first in order that should have come after the one
      // moved, or the one moved itself and the last that should have come before it.
      int drawn = -1, before = -1;
      for (std::size_t k = moved; k-- > 0;)
        if ((kept >> k & 1U) != 0 && order[k] > order[moved])
          drawn = static_cast<int>(k), before = f.misplaced[0];
      if (drawn < 0) {
        drawn = f.misplaced[0];
        for (std::size_t k = moved + 1; k < 6; ++k)
          if ((kept >> k & 1U) != 0 && order[k] < order[moved]) before = static_cast<int>(k);
      }
      EXPECT_EQ(f.drawn, drawn) << name;
      EXPECT_EQ(f.before, before) << name;
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(StrokesOutOfTurn, OfTwoThatMayHaveComeFirstTheOneDrawnFirstIsInItsTurn) {
  // Both 2 and 1 may come before 3 and 4; 2 was drawn first, so 1 is the one that is late.
  const auto mistakes = strokes_out_of_turn(links({2, 1, 3, 0, 4}));
  ASSERT_EQ(mistakes.size(), 2U);
  EXPECT_THAT(mistakes[0].misplaced, ElementsAre(1));
  EXPECT_THAT(mistakes[1].misplaced, ElementsAre(3));
}

TEST(StrokesOutOfTurn, AreNamedByTheirDrawnNumbersAfterASplitOrAnExtraStroke) {
  std::vector<Link> some{{0, 2, 1, 1, {}}, {2, 1, 2, 1, {}}, {5, 1, 0, 1, {}}};
  const auto mistakes = strokes_out_of_turn(some);
  ASSERT_EQ(mistakes.size(), 1U);
  EXPECT_EQ(mistakes[0].drawn, 0);
  EXPECT_EQ(mistakes[0].before, 5);
  EXPECT_THAT(mistakes[0].misplaced, ElementsAre(5));
  EXPECT_TRUE(strokes_out_of_turn({}).empty());
}

TEST(Picture, ForgetsOrderDirectionPlaceAndSize) {
  const std::vector<float> bar{10, 50, 90, 52};
  const std::vector<float> back{90, 52, 10, 50};
  const std::vector<float> fall{50, 10, 48, 95};
  const std::vector<float> small_bar{1, 5, 9, 5.2F};
  const std::vector<float> small_fall{5, 1, 4.8F, 9.5F};
  const auto cross = make_picture(std::vector<FlatLine>{bar, fall});
  EXPECT_NEAR(likeness(cross, cross), 1, 1e-5F);
  EXPECT_NEAR(likeness(cross, make_picture(std::vector<FlatLine>{fall, back})), 1, 1e-4F);
  EXPECT_NEAR(likeness(cross, make_picture(std::vector<FlatLine>{small_bar, small_fall})), 1, 1e-3F);
  EXPECT_LT(likeness(cross, make_picture(std::vector<FlatLine>{bar})), 0.8F);
}

}  // namespace
}  // namespace nazori::writing::test
