// SPDX-License-Identifier: Apache-2.0
// How a drawn stroke differs from one of the model, by definitions and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "judgement.h"
#include "placement.h"
#include "residue.h"
#include "stroke_difference.h"

namespace nazori::writing::test {
namespace {

Shape line(std::vector<double> xs, std::vector<double> ys) { return make_shape(xs, ys); }
Shape bar(double x, double y, double length) { return line({x - length / 2, x + length / 2}, {y, y}); }
Shape post(double x, double y, double length) { return line({x, x}, {y - length / 2, y + length / 2}); }

constexpr float kFar = 1e9F;

/// Root mean square distance of the samples of a straight line of length 1 from its middle.
double spread_of_a_line() { return std::sqrt((24.0 * 24 - 1) / 12) / 23; }

TEST(Difference, OfAStrokeFromItselfIsNone) {
  const auto m = line({10, 40, 60}, {20, 60, 90});
  const auto d = compare(m, m, kFar);
  EXPECT_EQ(d.offset_x, 0);
  EXPECT_EQ(d.offset_y, 0);
  EXPECT_NEAR(d.shape, 0, 0.05);
  EXPECT_NEAR(d.proportion, 0, 1e-3);
  EXPECT_NEAR(d.length_log, 0, 1e-6);
  EXPECT_EQ(d.steeper, 0);
  EXPECT_NEAR(d.cost, 0, 1e-3);
  EXPECT_FALSE(d.reversed);
  EXPECT_FLOAT_EQ(d.model_length, m.whole.length);
}

TEST(Difference, OfAStrokeMovedIsItsOffset) {
  const auto d = compare(bar(53, 44, 40), bar(50, 50, 40), kFar);
  EXPECT_NEAR(d.offset_x, 3, 1e-4);
  EXPECT_NEAR(d.offset_y, -6, 1e-4);
  EXPECT_NEAR(d.shape, 0, 0.05);
  EXPECT_NEAR(d.proportion, 0, 1e-3);
  // Squared deviations: four times as much for twice as far, and the same in any direction.
  const auto cost = [](double x, double y) {
    return compare(bar(50 + x, 50 + y, 40), bar(50, 50, 40), kFar).cost;
  };
  EXPECT_NEAR(cost(8, 0), 4 * cost(4, 0), 1e-3);
  EXPECT_NEAR(cost(0, 4), cost(4, 0), 1e-3);
  EXPECT_NEAR(cost(3, 4), cost(5, 0), 1e-3);
  EXPECT_NEAR(cost(-4, 0), cost(4, 0), 1e-3);
}

TEST(Difference, LongStrokesMayBeFartherOff) {
  const auto cost = [](double length) {
    return compare(bar(56, 50, length), bar(50, 50, length), kFar).cost;
  };
  EXPECT_GT(cost(10), cost(40));
  EXPECT_GT(cost(40), cost(80));
  // The distance that is natural grows evenly with the length: 1 / sqrt(cost) is linear in it.
  const auto natural = [&](double length) { return 1 / std::sqrt(cost(length)); };
  EXPECT_NEAR(natural(60) - natural(40), natural(40) - natural(20), 1e-3);
  EXPECT_GT(natural(0.001), 0.2);
}

TEST(Difference, OfALongerStrokeIsItsLengthAndSize) {
  const auto d = compare(bar(50, 50, 80), bar(50, 50, 40), kFar);
  EXPECT_NEAR(d.length_log, std::log(2), 0.01);
  EXPECT_NEAR(compare(bar(50, 50, 40), bar(50, 50, 80), kFar).length_log, -std::log(2), 0.01);
  EXPECT_NEAR(d.proportion, 0, 1e-3) << "brought to one length they are the same";
  EXPECT_NEAR(d.shape, 40 * spread_of_a_line(), 0.01);
  EXPECT_GT(d.cost, 0);
}

TEST(Difference, OfATurnedStrokeIsTheDistanceOfItsSamples) {
  // A bar and a post of one length about one centre: their samples are sqrt 2 times their distance from it
  // apart.
  const auto d = compare(post(50, 50, 40), bar(50, 50, 40), kFar);
  EXPECT_NEAR(d.proportion, std::sqrt(2) * spread_of_a_line(), 1e-3);
  EXPECT_NEAR(d.shape, 40 * std::sqrt(2) * spread_of_a_line(), 0.02);
  EXPECT_NEAR(d.steeper, 1, 1e-4);
  EXPECT_NEAR(compare(bar(50, 50, 40), post(50, 50, 40), kFar).steeper, -1, 1e-4);
  const auto slanting = line({30, 70}, {50, 50 + 40 * std::tan(std::numbers::pi / 6)});
  EXPECT_NEAR(compare(slanting, bar(50, 61, 40), kFar).steeper, 0.5, 1e-4) << "the sine of 30 degrees";
}

TEST(Difference, AStrokeDrawnBackwardsIsThatStrokeBackwards) {
  const auto model = line({20, 60, 80}, {20, 30, 80});
  const auto back = line({80, 60, 20}, {80, 30, 20});
  const auto d = compare(back, model, kFar);
  EXPECT_TRUE(d.reversed);
  EXPECT_NEAR(d.shape, 0, 0.05);
  EXPECT_NEAR(d.proportion, 0, 1e-3);
  const auto forward = compare(model, model, kFar);
  EXPECT_GT(d.cost, forward.cost + 1) << "but not for nothing";
  EXPECT_LT(d.cost, kAcceptCost);
  EXPECT_FALSE(forward.reversed);
  // The place costs the same in both directions.
  const auto moved = line({83, 63, 23}, {84, 34, 24});
  EXPECT_NEAR(compare(moved, model, kFar).cost - d.cost,
              compare(line({23, 63, 83}, {24, 34, 84}), model, kFar).cost, 1e-2);
}

TEST(Difference, AKickMayBeSmallLongOrMissing) {
  const auto kick = [](double by) { return line({50, 50, 50 - by}, {10, 90, 90 - by / 2}); };
  const auto without = post(50, 50, 80);
  for (const double drawn : {4.0, 8.0, 20.0})
    for (const double model : {4.0, 8.0, 20.0}) {
      const auto d = compare(kick(drawn), kick(model), kFar);
      EXPECT_LT(d.cost, 0.2) << drawn << " " << model;
    }
  EXPECT_LT(compare(without, kick(12), kFar).cost, 0.1);
  EXPECT_LT(compare(kick(12), without, kFar).cost, 0.1);
  // The bodies lie on each other: so do their lengths.
  EXPECT_NEAR(compare(without, kick(12), kFar).length_log, 0, 0.01);
  EXPECT_NEAR(compare(kick(12), without, kFar).length_log, 0, 0.01);
}

TEST(Difference, OfTwoPlacesFarApartOnlyTheRoughShapeIsTold) {
  const auto model = bar(50, 50, 40);
  const auto drawn = bar(50, 90, 20);
  const float place = compare(bar(50, 90, 40), model, kFar).cost;
  const auto away = compare(drawn, model, place * 0.99F);
  EXPECT_EQ(away.proportion, 1);
  EXPECT_NEAR(away.shape, 20 * spread_of_a_line(), 0.02) << "the difference of both spreads";
  EXPECT_NEAR(away.cost, place, 0.02);
  EXPECT_NEAR(away.offset_y, 40, 1e-4);
  const auto looked_at = compare(drawn, model, place * 1.01F);
  EXPECT_NEAR(looked_at.proportion, 0, 1e-3);
  EXPECT_GT(looked_at.cost, place);
}

TEST(Difference, AFreerModelMayVaryMoreInItsShapeOnly) {
  auto free = bar(50, 50, 40);
  free.freedom = 2;
  const auto drawn = line({30, 50, 70}, {50, 58, 50});
  const auto held = compare(drawn, bar(50, 50, 40), kFar);
  const auto freed = compare(drawn, free, kFar);
  EXPECT_EQ(freed.freedom, 2);
  EXPECT_LT(freed.cost, held.cost);
  EXPECT_NEAR(compare(bar(55, 50, 40), free, kFar).cost, compare(bar(55, 50, 40), bar(50, 50, 40), kFar).cost,
              1e-3);
}

// The difference that remains after removing position and length.

using Complex = std::complex<double>;
std::vector<Complex> normal(const Samples& s, bool backwards) {
  std::vector<Complex> z;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t j = backwards ? kSamples - 1 - k : k;
    z.emplace_back((s.x[j] - s.centre_x) / s.length, (s.y[j] - s.centre_y) / s.length);
  }
  return z;
}

Shape random_line(std::mt19937& random) {
  std::uniform_real_distribution<double> step(-20, 30);
  std::vector<double> xs{50}, ys{50};
  for (int i = 0; i < 4; ++i) {
    xs.push_back(xs.back() + step(random));
    ys.push_back(ys.back() + step(random));
  }
  return line(xs, ys);
}

TEST(Residue, IsTheTurnAndTheBendOfKendallsDefinition) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    const auto drawn = random_line(random), model = random_line(random);
    StrokeDifference difference;
    difference.reversed = round % 2 == 1;
    const auto r = residue(drawn, model, difference, {});
    const auto d = normal(drawn.whole, difference.reversed), m = normal(model.whole, false);
    Complex product = 0;
    double own = 0;
    for (std::size_t k = 0; k < kSamples; ++k) {
      product += d[k] * std::conj(m[k]);
      own += std::norm(d[k]) + std::norm(m[k]);
    }
    EXPECT_NEAR(r.turn_rad, std::arg(product), 1e-4);
    EXPECT_NEAR(r.bend, std::sqrt(std::max(0.0, own - 2 * std::abs(product)) / 24), 2e-3);
  }
}

TEST(Residue, ATurnedStrokeIsTurnedClockwiseAndNotBent) {
  const auto model = line({20, 60, 80}, {20, 30, 70});
  for (const double turn : {0.3, -0.5, 2.0}) {
    const auto drawn = transformed(
        model, {2 * std::cos(turn), -2 * std::sin(turn), 9, 2 * std::sin(turn), 2 * std::cos(turn), 5});
    const auto r = residue(drawn, model, {}, {});
    EXPECT_NEAR(r.turn_rad, turn, 1e-4);
    EXPECT_NEAR(r.bend, 0, 1e-3);
  }
}

TEST(Residue, TheNearerEndIsMeasuredFromWhereTheNeighboursPutIt) {
  const auto model = bar(50, 50, 40);
  const auto drawn = line({33, 74}, {54, 49});  // ends 3, 4 and 4, -1 off
  StrokeDifference difference;
  EXPECT_NEAR(residue(drawn, model, difference, {}).nearer_end, std::sqrt(17), 1e-3);
  // The neighbours share half of the offset.
  difference.offset_x = 3;
  difference.offset_y = 2;
  EXPECT_NEAR(residue(drawn, model, difference, {1, -1, 0}).nearer_end, std::sqrt(1 + 1), 1e-3);
  const auto back = line({74, 33}, {49, 54});
  StrokeDifference reversed;
  reversed.reversed = true;
  EXPECT_NEAR(residue(back, model, reversed, {}).nearer_end, std::sqrt(17), 1e-3);
  EXPECT_NEAR(residue(back, model, {}, {}).nearer_end, std::hypot(37, 4), 1e-3);
  const auto first = line({31, 90}, {50, 50});
  EXPECT_NEAR(residue(first, model, {}, {}).nearer_end, 1, 1e-3);
  const auto first_back = line({90, 31}, {50, 50});
  EXPECT_NEAR(residue(first_back, model, reversed, {}).nearer_end, 1, 1e-3);
}

// Where the neighbours put a stroke.

Alignment all_in_order(std::size_t count) {
  Alignment a;
  for (std::size_t k = 0; k < count; ++k)
    a.links.push_back({static_cast<int>(k), 1, static_cast<int>(k), 1, {}});
  return a;
}

TEST(Placement, OfAStrokeAloneIsItsOffset) {
  auto a = all_in_order(1);
  a.links[0].difference.offset_x = 3;
  a.links[0].difference.offset_y = -2;
  a.links[0].difference.length_log = 0.5F;
  const std::vector<Shape> model{bar(50, 50, 60)};
  const auto p = placements(a, model);
  ASSERT_EQ(p.size(), 1U);
  EXPECT_FLOAT_EQ(p[0].x, 3);
  EXPECT_FLOAT_EQ(p[0].y, -2);
  EXPECT_FLOAT_EQ(p[0].length_log, 0.5F);
}

/// Placement of the first of `count` strokes at one place that are all off alike.
Placement shared(std::size_t count, float others_cost = 0) {
  auto a = all_in_order(count);
  std::vector<Shape> model;
  for (auto& l : a.links) {
    l.difference.offset_x = 2;
    l.difference.offset_y = -4;
    l.difference.length_log = 1;
    if (&l != &a.links.front()) l.difference.cost = others_cost;
    model.push_back(bar(50, 50, 60));
  }
  return placements(a, model).front();
}

TEST(Placement, WhatNeighboursShareIsNoFaultTheLessTheMoreTheyAre) {
  // Of n others each counts as much as the next, "no offset" counts some constant: 1 + n / c.
  for (const auto of : {&Placement::x, &Placement::y, &Placement::length_log}) {
    const double alone = shared(1).*of;
    const double one = alone / shared(2).*of, two = alone / shared(3).*of, three = alone / shared(4).*of;
    EXPECT_GT(one, 1.2);
    EXPECT_NEAR(two - one, one - 1, 1e-3);
    EXPECT_NEAR(three - two, one - 1, 1e-3);
  }
  EXPECT_NEAR(shared(3).y / shared(3).x, -2, 1e-4);
}

TEST(Placement, AStrangeNeighbourSaysLess) {
  EXPECT_GT(shared(2, 13).x, 1.5F * shared(2).x);
  EXPECT_GT(shared(2, 13).length_log, 1.5F * shared(2).length_log);
  EXPECT_NEAR(shared(2, 1e6F).x, 2, 1e-3);
  EXPECT_NEAR(shared(2, 1e6F).length_log, 1, 1e-3);
}

TEST(Placement, AFarNeighbourSaysNothingOfThePlaceAndAShortOneLittleOfTheSize) {
  auto a = all_in_order(2);
  a.links[0].difference.offset_x = 2;
  a.links[1].difference.offset_x = 2;
  a.links[0].difference.length_log = a.links[1].difference.length_log = 1;
  const auto of = [&](const Shape& other) {
    return placements(a, std::vector<Shape>{bar(50, 50, 60), other}).front();
  };
  EXPECT_NEAR(of(bar(50, 250, 60)).x, 2, 1e-3);
  EXPECT_NEAR(of(bar(250, 50, 60)).x, 2, 1e-3);
  EXPECT_LT(of(bar(50, 250, 60)).length_log, 0.9F) << "of the size it speaks from anywhere";
  EXPECT_LT(of(bar(50, 60, 60)).x, of(bar(50, 80, 60)).x);
  EXPECT_NEAR(of(bar(50, 60, 60)).x, of(bar(60, 50, 60)).x, 1e-3) << "near in any direction";
  EXPECT_GT(of(bar(50, 250, 10)).length_log, of(bar(50, 250, 30)).length_log);
  EXPECT_NEAR(of(bar(50, 250, 40)).length_log, of(bar(50, 250, 80)).length_log, 1e-4) << "long is long";
}

TEST(Placement, EachStrokeIsComparedWithTheOthersOnly) {
  auto a = all_in_order(3);
  a.links[1].difference.offset_x = 6;
  a.links[1].difference.length_log = 1;
  const std::vector<Shape> model{bar(50, 50, 60), bar(50, 50, 60), bar(50, 50, 60)};
  const auto p = placements(a, model);
  EXPECT_FLOAT_EQ(p[1].x, 6);
  EXPECT_FLOAT_EQ(p[1].length_log, 1);
  EXPECT_LT(p[0].x, 0);
  EXPECT_LT(p[0].length_log, 0);
  EXPECT_FLOAT_EQ(p[0].x, p[2].x);
}

// All of it in one figure.

StrokeDifference of_length(float length) {
  StrokeDifference d;
  d.model_length = length;
  return d;
}

TEST(Judgement, TheModelDeviatesByNothing) {
  for (const float length : {5.0F, 20.0F, 80.0F}) {
    const auto j = judge(of_length(length), {}, {}, {}, 14);
    EXPECT_EQ(j.deviation, 0);
    EXPECT_EQ(j.place, 0);
  }
}

TEST(Judgement, SumsSquares) {
  const auto place = [](float x, float y, float beside_x, float beside_y) {
    auto d = of_length(60);
    d.offset_x = x;
    d.offset_y = y;
    const auto j = judge(d, {beside_x, beside_y, 0}, {}, {}, 14);
    EXPECT_DOUBLE_EQ(j.place, j.deviation);
    return j.deviation;
  };
  EXPECT_NEAR(place(3, 4, 0, 0), place(5, 0, 0, 0), 1e-9);
  EXPECT_NEAR(place(0, 10, 0, 0), 4 * place(5, 0, 0, 0), 1e-9);
  EXPECT_NEAR(place(0, 0, 3, 4), place(0, 0, 5, 0), 1e-9);
  EXPECT_NEAR(place(0, 0, 0, 10), 4 * place(0, 0, 5, 0), 1e-9);
  EXPECT_NEAR(place(3, 4, 5, 0), place(5, 0, 0, 0) + place(0, 0, 0, 5), 1e-9);
  EXPECT_NEAR(place(0, 0, 5, 0) / place(5, 0, 0, 0), 1, 0.2) << "the neighbours say as much as the whole";

  auto proportion = of_length(60);
  proportion.proportion = 0.05F;
  const double once = judge(proportion, {}, {}, {}, 14).deviation;
  proportion.proportion = 0.1F;
  EXPECT_NEAR(judge(proportion, {}, {}, {}, 14).deviation, 4 * once, 1e-6);
  const auto with = [](Residue r) { return judge(of_length(60), {}, r, {}, 14).deviation; };
  const double trembling = 0.8 / 63;  // 0.8 glyph units of 60, and a little
  EXPECT_EQ(with({0, static_cast<float>(0.99 * trembling), 0}), 0);
  const auto beyond = [trembling](double bend) { return bend * bend - trembling * trembling; };
  EXPECT_NEAR(with({0, 0.1F, 0}) / with({0, 0.05F, 0}), beyond(0.1) / beyond(0.05), 1e-4);
  EXPECT_NEAR(with({0, 0, 8}), 4 * with({0, 0, 4}), 1e-6);
  EXPECT_NEAR(with({0, 0.1F, 8}), with({0, 0.1F, 0}) + with({0, 0, 8}), 1e-6);
  EXPECT_EQ(with({0.4F, 0, 0}), 0) << "the turn is in the course";
  const auto going = [](Course c) { return judge(of_length(60), {}, {}, c, 14).deviation; };
  EXPECT_NEAR(going({0.4F, 0}), 4 * going({0.2F, 0}), 1e-6);
  EXPECT_NEAR(going({0, 0.2F}), 2 * going({0, 0.1F}), 1e-6) << "1 - cos grows like the square of an angle";
  EXPECT_NEAR(going({0.2F, 0.1F}), going({0.2F, 0}) + going({0, 0.1F}), 1e-6);
}

TEST(Judgement, LengthCountsByItsRatioAndADotMayBeATouch) {
  const auto with = [](float length, float log, float beside, float touch) {
    auto d = of_length(length);
    d.length_log = log;
    Placement p;
    p.length_log = beside;
    const auto j = judge(d, p, {}, {}, touch);
    EXPECT_EQ(j.place, 0);
    return j.deviation;
  };
  EXPECT_NEAR(with(80, 0.4F, 0, 14), 4 * with(80, 0.2F, 0, 14), 1e-6);
  EXPECT_NEAR(with(80, -0.4F, 0, 14), with(80, 0.4F, 0, 14), 1e-9);
  EXPECT_NEAR(with(80, 2, 0, 14), with(80, 1.3F, 0, 14), 1e-9);
  EXPECT_LT(with(5, -1, 0, 14), 0.1 * with(80, -1, 0, 14));
  EXPECT_LT(with(20, -1, 0, 24), 0.6 * with(20, -1, 0, 14)) << "where the touch is longer";
  // Half the expected length is natural, less is not; more than expected does not matter.
  EXPECT_EQ(with(80, 0, std::log(0.51F), 14), 0);
  EXPECT_EQ(with(80, 0, 1, 14), 0);
  EXPECT_GT(with(80, 0, std::log(0.4F), 14), 0.15);
  EXPECT_NEAR(with(80, 0, -1.3F, 14), with(80, 0, -3, 14), 1e-9);
  EXPECT_NEAR(with(80, 0, -1.1F, 14), 4 * with(80, 0, -0.9F, 14), 1e-3);
}

TEST(Judgement, NamesWhatDeviatesMost) {
  const auto most = [](float offset, float log, float bend) {
    auto d = of_length(60);
    d.offset_x = offset;
    d.length_log = log;
    return judge(d, {}, {0, bend, 0}, {}, 14).most;
  };
  EXPECT_EQ(most(30, 0, 0), Deviation::place);
  EXPECT_EQ(most(0, 1, 0), Deviation::length);
  EXPECT_EQ(most(0, 0, 0.3F), Deviation::shape);
  EXPECT_EQ(most(30, 0.1F, 0.01F), Deviation::place);
  EXPECT_EQ(most(1, 1, 0.01F), Deviation::length);
  EXPECT_EQ(most(1, 0.1F, 0.5F), Deviation::shape);
}

TEST(Judgement, DotsVaryMoreInPlaceAndSlant) {
  const auto beside = [](float length) { return judge(of_length(length), {8, 0, 0}, {}, {}, 14).deviation; };
  EXPECT_LT(beside(4), beside(17));
  EXPECT_LT(beside(17), beside(60));
  EXPECT_GT(beside(60), 5 * beside(1));
  const auto turned = [](float length, float steeper) {
    auto d = of_length(length);
    d.steeper = steeper;
    return judge(d, {}, {}, {0.5F, 0.05F}, 14).deviation;
  };
  EXPECT_LT(turned(8, 0), turned(60, 0));
  EXPECT_LT(turned(8, 0.4F), turned(8, 0)) << "quick dots fall steeper";
  EXPECT_GT(turned(8, -0.4F), turned(8, 0));
  EXPECT_NEAR(turned(8, 0.9F), turned(8, 0.5F), 1e-9);
  EXPECT_NEAR(turned(8, -0.9F), turned(8, -0.5F), 1e-9);
  EXPECT_NEAR(turned(100, 0.4F), turned(100, 0), 1e-6) << "of long strokes the slant is known";
  auto free = of_length(60);
  free.freedom = 2;
  EXPECT_NEAR(judge(free, {}, {}, {0.5F, 0.05F}, 14).deviation, turned(60, 0) / 4, 1e-6);
}

TEST(Judgement, TheLimitIsScaledByTheStrictness) {
  // docs/writing.md: by 1.7 to the power of 1 - 2 s.
  for (const double s : {0.0, 0.25, 0.5, 0.85, 1.0})
    EXPECT_NEAR(deviation_limit(s), std::pow(1.7, 1 - 2 * s), 1e-12);
}

}  // namespace
}  // namespace nazori::writing::test
