// SPDX-License-Identifier: Apache-2.0
#include "strangeness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing.h"
#include "grade_shapes.h"
#include "model_inside.h"
#include "probability.h"

namespace nazori::writing::test {
namespace {

/// Where features lie in the row; training/train_stroke_trees.py counts the same way.
constexpr std::size_t kDeviation = 0;
constexpr std::size_t kOffsetX = 2;
constexpr std::size_t kTurn = 14;
constexpr std::size_t kRoughness = 18;
constexpr std::size_t kOfAllowance = 19;
constexpr std::size_t kCount = 20;
constexpr std::size_t kTurnOfOthers = 21;
constexpr std::size_t kSignedTurnOfOthers = 24;
constexpr std::size_t kAway = 25;
constexpr std::size_t kAwayOfOthers = 26;
constexpr std::size_t kStart = 27;
constexpr std::size_t kEnd = 28;
constexpr std::size_t kModelAcross = 29;
constexpr std::size_t kQuarters = 32;
constexpr std::size_t kModelPoints = 36;
constexpr std::size_t kShapes = kModelPoints + 16;
constexpr std::size_t kPlaces = kShapes + 16;
constexpr std::size_t kOfModel = kPlaces + 16;
constexpr std::size_t kEndsBeside = kOfModel + 1;
constexpr std::size_t kTurnsBeside = kEndsBeside + 5;
constexpr std::size_t kMap = kTurnsBeside + 6;
constexpr std::size_t kDistances = kMap + 3;

/// A straight stroke beside a straight model.
JudgedStroke straight(std::array<double, 4> drawn, std::array<double, 4> model) {
  const auto line = [](const std::array<double, 4>& p) {
    return make_shape(std::array{p[0], p[2]}, std::array{p[1], p[3]}).whole;
  };
  JudgedStroke s;
  s.drawn = line(drawn);
  s.model = line(model);
  return s;
}

std::vector<double> strangeness_of(const WrittenCharacter& ink, const Model& model) {
  const auto prepared = prepare(ink, {});
  const auto& form = model.inside().main;
  const auto alignment = align({prepared->drawn, form.shapes, form.pairs, prepared->box, Extent::whole});
  const auto strokes = judged_strokes(alignment, prepared->drawn, form);
  const auto features = stroke_features(strokes, form.shapes.size(), alignment.map);
  std::vector<double> result;
  for (std::size_t k = 0; k < strokes.size(); ++k)
    result.push_back(strangeness(features[k], strokes[k].used_freedom));
  return result;
}

TEST(StrokeFeatures, FillTheRowFromItsFirstNumberToItsLast) {
  auto s = straight({10, 10, 50, 10}, {10, 10, 50, 10});
  s.judgement.deviation = 0.7;
  const auto row = stroke_features(std::array{s}, 9).at(0);
  EXPECT_FLOAT_EQ(row[kDeviation], 0.7F);
  EXPECT_EQ(row[kOfModel], 9);
  EXPECT_EQ(row.size(), kDistances + 4);
}

TEST(StrokeFeatures, TellWhatWasMeasuredOfTheStrokeItself) {
  auto s = straight({10, 10, 50, 10}, {10, 10, 50, 10});
  s.judgement.place = 0.25;
  s.difference.offset_x = 3;
  s.difference.offset_y = 4;
  s.placement = {5, 6, 0.5F};
  s.difference.proportion = 7;
  s.difference.shape = 8;
  s.difference.steeper = 9;
  s.difference.model_length = 10;
  s.difference.freedom = 11;
  s.course = {12, 13};
  s.residue = {14, 15, 16};
  s.difference.length_log = 17;
  const auto row = stroke_features(std::array{s}, 1).at(0);
  const std::array expected{0.0F, 0.25F, 3.0F,  4.0F,  5.0F,  6.0F,  0.5F,  7.0F,  8.0F,
                            9.0F, 10.0F, 11.0F, 12.0F, 13.0F, 14.0F, 15.0F, 16.0F, 17.0F};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), row.begin()));
}

TEST(StrokeFeatures, TellHowTheOtherStrokesAre) {
  auto one = straight({10, 10, 50, 10}, {10, 10, 50, 10});
  auto two = one;
  auto three = one;
  one.judgement.deviation = 0.16;
  two.judgement.deviation = 0.36;
  three.judgement.deviation = 4;  // no rougher than 1
  one.residue.turn_rad = 0.3F;
  two.residue = {-0.1F, 0.04F, 0};
  three.residue = {0.5F, 0.02F, 0};
  two.course.along = 0.2F;
  two.placement = {3, 4, 0};
  three.placement = {0, -1, 0};
  const auto rows = stroke_features(std::array{one, two, three}, 3);
  // Nine strokes and a bit are taken to have the usual roughness.
  const double of_one = (0.6 + 1 + 9.3 * 0.095) / (2 + 9.3);
  EXPECT_NEAR(rows[0][kRoughness], of_one, 1e-6);
  EXPECT_NEAR(rows[0][kOfAllowance], 0.16 / (0.525 + 2.4 * of_one), 1e-6);
  EXPECT_NEAR(rows[2][kRoughness], (0.4 + 0.6 + 9.3 * 0.095) / (2 + 9.3), 1e-6);
  EXPECT_EQ(rows[0][kCount], 3);
  EXPECT_NEAR(rows[0][kTurnOfOthers], 0.3, 1e-6);
  EXPECT_NEAR(rows[0][kTurnOfOthers + 1], 0.03, 1e-6);
  EXPECT_NEAR(rows[0][kTurnOfOthers + 2], 0.1, 1e-6);
  EXPECT_NEAR(rows[0][kSignedTurnOfOthers], 0.2, 1e-6);
  EXPECT_NEAR(rows[1][kAway], 5, 1e-6);
  EXPECT_NEAR(rows[0][kAwayOfOthers], 3, 1e-6);
  EXPECT_NEAR(rows[1][kAwayOfOthers], 0.5, 1e-6);
}

TEST(StrokeFeatures, OfAnOnlyStrokeTellNothingOfOthers) {
  auto s = straight({10, 10, 50, 10}, {10, 10, 50, 10});
  s.judgement.deviation = 2;
  s.residue.turn_rad = 1;
  const auto row = stroke_features(std::array{s}, 1).at(0);
  EXPECT_NEAR(row[kRoughness], 0.095, 1e-6);
  EXPECT_NEAR(row[kTurnOfOthers], 0, 1e-6);
}

TEST(StrokeFeatures, MeasureTheEndsFromWhereTheNeighboursPutThem) {
  auto s = straight({13, 14, 50, 22}, {10, 10, 50, 10});
  auto row = stroke_features(std::array{s}, 1).at(0);
  EXPECT_NEAR(row[kStart], 5, 1e-5);
  EXPECT_NEAR(row[kEnd], 12, 1e-5);
  // All strokes around are 3 to the right and 4 lower.
  s.difference.offset_x = 4;
  s.difference.offset_y = 6;
  s.placement = {1, 2, 0};
  row = stroke_features(std::array{s}, 1).at(0);
  EXPECT_NEAR(row[kStart], 0, 1e-5);
  EXPECT_NEAR(row[kEnd], std::hypot(3, 8), 1e-5);
}

TEST(StrokeFeatures, TellTheDirectionOfTheModelAndTheTurnOfEachQuarter) {
  const auto s = straight({0, 0, 0, 40}, {0, 0, 30, 40});
  const auto row = stroke_features(std::array{s}, 1).at(0);
  EXPECT_NEAR(row[kModelAcross], 0.6, 1e-5);
  EXPECT_NEAR(row[kModelAcross + 1], 0.8, 1e-5);
  EXPECT_NEAR(row[kModelAcross + 2], 50, 1e-4);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(row[kQuarters + k], std::atan2(3, 4), 1e-5);
}

TEST(StrokeFeatures, DrawBothLines) {
  const auto s = straight({4, 0, 4, 20}, {0, 0, 40, 0});
  const auto row = stroke_features(std::array{s}, 1).at(0);
  const std::array ends{kModelPoints, kModelPoints + 14};
  EXPECT_NEAR(row[ends[0]], -0.5, 1e-5);
  EXPECT_NEAR(row[ends[0] + 1], 0, 1e-5);
  EXPECT_NEAR(row[ends[1]], 0.5, 1e-5);
  EXPECT_NEAR(row[kShapes], 0.5, 1e-5) << "both scaled to length 1 and centred";
  EXPECT_NEAR(row[kShapes + 1], -0.5, 1e-5);
  EXPECT_NEAR(row[kShapes + 14], -0.5, 1e-5);
  EXPECT_NEAR(row[kShapes + 15], 0.5, 1e-5);
  const double near = 10 + 0.2 * 40;
  EXPECT_NEAR(row[kPlaces], 4 / near, 1e-5);
  EXPECT_NEAR(row[kPlaces + 14], (4 - 40) / near, 1e-5);
  EXPECT_NEAR(row[kPlaces + 15], 20 / near, 1e-5);
}

TEST(StrokeFeatures, MeasureTheEndsFromTheStrokesThatTheyTouchInTheModel) {
  // Both are 4 to the right and 3 lower; the upright one ends 6 further to the right and 8 lower.
  const auto bar = straight({14, 53, 83, 53}, {10, 50, 79, 50});
  const auto upright = straight({53, 53, 59, 101}, {49, 50, 49, 90});
  const auto row = stroke_features(std::array{bar, upright}, 2).at(1);
  EXPECT_NEAR(row[kEndsBeside], 0, 1e-4);
  EXPECT_NEAR(row[kEndsBeside + 1], 10, 1e-4);
  EXPECT_NEAR(row[kEndsBeside + 2], 0, 1e-4) << "the better one";
  EXPECT_NEAR(row[kEndsBeside + 3], 0, 1e-4) << "in the model it starts on the bar";
  EXPECT_NEAR(row[kEndsBeside + 4], 40, 1e-4);
}

TEST(StrokeFeatures, MeasureTheEndsOfAnOnlyStrokeFromTheModels) {
  const auto row = stroke_features(std::array{straight({13, 14, 50, 22}, {10, 10, 50, 10})}, 1).at(0);
  EXPECT_NEAR(row[kEndsBeside], 5, 1e-5);
  EXPECT_NEAR(row[kEndsBeside + 1], 12, 1e-5);
  EXPECT_NEAR(row[kEndsBeside + 2], 5, 1e-5);
  EXPECT_EQ(row[kEndsBeside + 3], 100) << "far from any other";
  EXPECT_EQ(row[kEndsBeside + 4], 100);
}

TEST(StrokeFeatures, CompareTheTurnWithStrokesInTheSameDirectionAndWithNearOnes) {
  const double rise = 40 * std::tan(0.2);
  auto bar = straight({10, 10, 50, 10 - rise}, {10, 10, 50, 10});
  auto other = straight({10, 34, 50, 34 - rise}, {10, 34, 50, 34});
  auto upright = straight({200, 10, 200, 50}, {200, 10, 200, 50});
  bar.residue.turn_rad = -0.2F;
  other.residue.turn_rad = -0.1F;
  bar.judgement.deviation = 0.3;
  other.judgement.deviation = 9;
  upright.judgement.deviation = 0.1;
  const auto row = stroke_features(std::array{bar, other, upright}, 3).at(0);
  // The other bar has a weight of 1, no turn one of 0.3.
  EXPECT_NEAR(row[kTurnsBeside], -0.2 / 1.3, 1e-5);
  EXPECT_NEAR(row[kTurnsBeside + 1], 0.2 - 0.2 / 1.3, 1e-5);
  // 24 units away; the upright one is too far.
  const double near = std::exp(-0.5);
  EXPECT_NEAR(row[kTurnsBeside + 2], -0.1 * near / (near + 0.3), 1e-5);
  EXPECT_NEAR(row[kTurnsBeside + 3], 0.2 - 0.1 * near / (near + 0.3), 1e-5);
  EXPECT_EQ(row[kTurnsBeside + 4], 4) << "no rougher than 4";
  EXPECT_EQ(row[kTurnsBeside + 5], 0.5) << "one of two is rougher";
}

TEST(StrokeFeatures, BelieveAStrangeStrokeLess) {
  const double rise = 40 * std::tan(0.2);
  const auto bar = straight({10, 10, 50, 10}, {10, 10, 50, 10});
  auto other = straight({10, 34, 50, 34 - rise}, {10, 34, 50, 34});
  other.difference.cost = 13;
  const auto row = stroke_features(std::array{bar, other}, 2).at(0);
  EXPECT_NEAR(row[kTurnsBeside], -0.2 * 0.25 / (0.25 + 0.3), 1e-5);
}

TEST(StrokeFeatures, TellWhatTheMapDoes) {
  const auto s = straight({10, 10, 50, 10}, {10, 10, 50, 10});
  const auto row = stroke_features(std::array{s}, 1, {2, 0.1, 7, 0.4, 1, 9}).at(0);
  EXPECT_NEAR(row[kMap], std::log(2), 1e-6);
  EXPECT_NEAR(row[kMap + 1], 0.3 / 3, 1e-6);
  EXPECT_NEAR(row[kMap + 2], 0.5 / 3, 1e-6);
}

TEST(StrokeFeatures, MeasureHowFarTheLinesAreApart) {
  auto s = straight({13, 14, 53, 14}, {10, 10, 50, 10});
  s.as_drawn = straight({0, 0, 0, 3}, {0, 0, 1, 0}).drawn;  // upright, and smaller
  s.difference.offset_x = 3;
  s.difference.offset_y = 4;
  s.placement = {0, 1, 0};
  const auto row = stroke_features(std::array{s}, 1).at(0);
  // A quarter of the length is the mean distance from the centre; 24 points are a little farther out.
  const double from_centre = 0.25 * 24 / 23;
  EXPECT_NEAR(row[kDistances], std::sqrt(2) * from_centre, 1e-5);
  EXPECT_NEAR(row[kDistances + 1], 0, 1e-5);
  EXPECT_NEAR(row[kDistances + 2], 5, 1e-5);
  EXPECT_NEAR(row[kDistances + 3], 1, 1e-5) << "beside the neighbours";
}

TEST(Strangeness, OfTheModelsOwnStrokesIsFarBelowTheLimit) {
  for (const auto& c : {rest(), soil(), three(), eye()})
    for (const double s : strangeness_of(trace(c), model_of(c))) EXPECT_LT(s, 0.6);
}

TEST(Strangeness, OfAnUprightBarIsFarAboveTheLimitAndTheOthersStayBelow) {
  auto ink = trace(rest());
  ink.strokes[2] = along({{60, 30}, {60, 75}});  // the bar of 木
  const auto strange = strangeness_of(ink, model_of(rest()));
  ASSERT_EQ(strange.size(), 6U);
  EXPECT_GT(strange[2], 1.3);
  for (const std::size_t k : {0U, 1U, 3U, 4U, 5U}) EXPECT_LT(strange[k], 1) << k;
}

TEST(Strangeness, GrowsAsAStrokeIsTurned) {
  double before = 0;
  for (const double degrees : {0.0, 20.0, 40.0, 60.0, 90.0}) {
    auto ink = trace(three());
    const double angle = degrees / 180 * 3.14159265358979;
    for (auto& p : ink.strokes[1]) {
      const auto v = p.at - WritingPoint{54, 54};
      p.at = WritingPoint{54, 54} + decltype(v){std::cos(angle) * v.x - std::sin(angle) * v.y,
                                                std::sin(angle) * v.x + std::cos(angle) * v.y};
    }
    constexpr double kFarBeyond = 3;
    const double now = std::min(strangeness_of(ink, model_of(three())).at(1), kFarBeyond);
    EXPECT_GE(now, before) << degrees;
    before = now;
  }
  EXPECT_GT(before, 1.3);
}

/// The features of a stroke drawn like the model, but for its share of the allowance.
StrokeFeatures with_share(float of_allowance) {
  auto row = stroke_features(std::array{straight({10, 10, 50, 10}, {10, 10, 50, 10})}, 1).at(0);
  row[kOfAllowance] = of_allowance;
  return row;
}

TEST(Strangeness, OfWhatHardlyDeviatesIsAtMostFourTimesItsShareOfTheAllowance) {
  EXPECT_EQ(strangeness(with_share(0), 0), 0);
  EXPECT_LE(strangeness(with_share(0.05F), 0), 0.2 + 1e-6);
}

TEST(Strangeness, OfWhatDeviatesFourTimesTheAllowanceIsThatShare) {
  EXPECT_EQ(strangeness(with_share(4), 0), 4);
  EXPECT_EQ(strangeness(with_share(50), 0.5), 50);
  const float below = 3.99F;
  EXPECT_GT(std::abs(strangeness(with_share(below), 0) - static_cast<double>(below)), 0.05)
      << "below it the trees decide";
}

TEST(Strangeness, CountsAFreedomThatWasUsed) { EXPECT_NEAR(strangeness(with_share(0), 0.5), 0.5, 1e-9); }

TEST(Strangeness, IsOneWhereTheLogOddsAreThoseOfTheLimit) {
  const double p = needed_probability(kNormal);
  EXPECT_NEAR(deviation_of(std::log((1 - p) / p)), 1, 1e-12);
  const double lenient = needed_probability(kLenient);
  EXPECT_NEAR(deviation_of(std::log((1 - lenient) / lenient)), 1.7, 1e-12);
}

TEST(JudgedStroke, WithAFreeSlantIsComparedAsIfItHadTheModelsSlant) {
  auto dot = make_shape(std::array{40.0, 54.0}, std::array{10.0, 24.0});
  const auto upright = make_shape(std::array{47.0, 47.0}, std::array{8.0, 26.0});
  dot.free_slant = true;
  constexpr float kFar = 1e9F;
  const auto judged = judge_stroke(upright, dot, {}, compare(upright, dot, kFar), {});
  const float dx = judged.drawn.x.back() - judged.drawn.x.front();
  const float dy = judged.drawn.y.back() - judged.drawn.y.front();
  EXPECT_NEAR(std::atan2(dy, dx), std::atan2(14, 14), 1e-4);
  EXPECT_NEAR(std::hypot(dx, dy), 18, 1e-3);
  EXPECT_NEAR((judged.drawn.y.back() + judged.drawn.y.front()) / 2, 17, 1e-3) << "turned about its centre";
  EXPECT_EQ(judged.residue.turn_rad, 0);
}

TEST(JudgedStroke, DrawnBackwardsIsKeptInTheModelsDirection) {
  const auto model = make_shape(std::array{10.0, 50.0}, std::array{20.0, 30.0});
  const auto drawn = make_shape(std::array{50.0, 10.0}, std::array{30.0, 20.0});
  auto d = compare(drawn, model, 1e9F);
  ASSERT_TRUE(d.reversed);
  const auto judged = judge_stroke(drawn, model, {}, d, {});
  EXPECT_NEAR(judged.drawn.x.front(), 10, 1e-4);
  EXPECT_NEAR(judged.drawn.x.back(), 50, 1e-4);
  EXPECT_NEAR(judged.drawn.y.front(), 20, 1e-4);
}

}  // namespace
}  // namespace nazori::writing::test
