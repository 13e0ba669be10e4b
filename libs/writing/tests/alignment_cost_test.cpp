// SPDX-License-Identifier: Apache-2.0
// What each mistake costs, on strokes that are otherwise those of the model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "alignment.h"

namespace nazori::writing::test {
namespace {

using Strokes = std::vector<Shape>;

Shape line(std::vector<double> xs, std::vector<double> ys) { return make_shape(xs, ys); }

/// Eight strokes that are clearly different.
Strokes eight() {
  return {line({10, 60}, {10, 10}),  line({80, 80}, {8, 60}),           line({15, 55}, {25, 45}),
          line({55, 12}, {52, 85}),  line({40, 70}, {60, 62}),          line({70, 100}, {75, 100}),
          line({10, 50}, {100, 98}), line({60, 104, 62}, {95, 90, 107})};
}

Alignment align_to(const Strokes& model, const Strokes& drawn, Extent extent = Extent::whole,
                   std::optional<Affine> box = {}) {
  Strokes pairs;
  for (std::size_t k = 0; k + 1 < model.size(); ++k)
    pairs.push_back(joined(model[k].whole, model[k + 1].whole));
  return align({drawn, model, pairs, box, extent});
}

Strokes without(Strokes strokes, std::vector<std::size_t> gone) {
  std::sort(gone.rbegin(), gone.rend());
  for (const std::size_t k : gone) strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(k));
  return strokes;
}

constexpr double kNearly = 0.15;

TEST(AlignmentCost, OfStrokesTooFewOrTooManyIsTwentyFourEach) {
  const Strokes model = eight();
  for (std::size_t k = 0; k < model.size(); ++k)
    EXPECT_NEAR(align_to(model, without(model, {k})).cost, 24, kNearly) << k;
  EXPECT_NEAR(align_to(model, without(model, {1, 4})).cost, 48, kNearly);
  EXPECT_NEAR(align_to(model, without(model, {0, 4, 7})).cost, 72, kNearly);
  for (std::size_t k = 0; k <= model.size(); ++k) {
    Strokes more = model;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(k), line({95, 20, 105}, {20, 30, 40}));
    EXPECT_NEAR(align_to(model, more).cost, 24, kNearly) << k;
  }
}

TEST(AlignmentCost, OfAnotherOrderIsThreeAndAHalfHoweverManyAreOutOfIt) {
  const Strokes model = eight();
  Strokes two = model, turned = model;
  std::swap(two[2], two[6]);
  std::rotate(turned.begin(), turned.begin() + 3, turned.end());
  EXPECT_NEAR(align_to(model, two).cost, 3.5, kNearly);
  EXPECT_NEAR(align_to(model, turned).cost, 3.5, kNearly);
}

TEST(AlignmentCost, OfTwoStrokesInOneIsNineteenAndOfOneInTwoSixteen) {
  const Strokes model = eight();
  for (std::size_t k = 0; k + 1 < model.size(); ++k) {
    Strokes fewer = without(model, {k + 1});
    fewer[k] = joined(model[k].whole, model[k + 1].whole);
    EXPECT_NEAR(align_to(model, fewer).cost, 19, kNearly) << k;
  }
  // The last one is not straight.
  for (std::size_t k = 0; k + 1 < model.size(); ++k) {
    const auto& whole = model[k].whole;
    const double x = (whole.x.front() + whole.x.back()) / 2.0, y = (whole.y.front() + whole.y.back()) / 2.0;
    Strokes more = model;
    more[k] = line({whole.x.front(), x}, {whole.y.front(), y});
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                line({x, whole.x.back()}, {y, whole.y.back()}));
    EXPECT_NEAR(align_to(model, more).cost, 16, kNearly) << k;
  }
}

TEST(AlignmentCost, OfAStrangeStrokeIsThirtyFourAtMostThoughItDiffersByMore) {
  const Strokes model = eight();
  Strokes strange = model;
  strange[3] = line({108, 1, 108, 1}, {1, 108, 108, 1});
  const Alignment a = align_to(model, strange, Extent::whole, Affine{});
  EXPECT_NEAR(a.cost, 34, 1);
  ASSERT_EQ(a.links.size(), 8U);
  EXPECT_GT(a.links[3].difference.cost, 34);
}

TEST(AlignmentCost, OfPassingOverAtTheBeginningIsTwelveAndOneMoreForEachUpToSixteen) {
  const Strokes model = eight();
  for (std::size_t passed = 1; passed <= 6; ++passed) {
    const Alignment a = align_to(model, {model[0], model[1 + passed]}, Extent::beginning, Affine{});
    EXPECT_NEAR(a.cost, std::min(12.0 + static_cast<double>(passed - 1), 16.0), 0.3) << passed;
    EXPECT_EQ(a.missing.size(), passed);
  }
}

TEST(AlignmentCost, OfAStrokeAfterAllIsThirtySixWhileTheCharacterIsBeingWritten) {
  const Strokes model = eight();
  Strokes more = model;
  more.push_back(line({95, 20, 105}, {20, 30, 40}));
  const Alignment a = align_to(model, more, Extent::beginning, Affine{});
  EXPECT_THAT(a.extra, testing::ElementsAre(8));
  EXPECT_NEAR(a.cost, 36, 0.5);
}

TEST(AlignmentCost, OfAPlaceOrSizeThatTheBoxDoesNotSuggestIsASquare) {
  const Strokes model = eight();
  const auto cost = [&](const Affine& written, Extent extent) {
    Strokes drawn;
    for (const Shape& s : model) drawn.push_back(transformed(s, written));
    return align_to(model, drawn, extent, Affine{}).cost;
  };
  const auto moved = [](double x, double y) { return Affine{1, 0, x, 0, 1, y}; };
  // Twelve units count as one, and seven while the character is being written.
  EXPECT_NEAR(cost(moved(12, 0), Extent::whole), 1, 0.05);
  EXPECT_NEAR(cost(moved(0, -24), Extent::whole), 4, 0.1);
  EXPECT_NEAR(cost(moved(6, 6), Extent::whole), 0.5, 0.05);
  EXPECT_NEAR(cost(moved(0, 7), Extent::beginning), 1, 0.05);
  EXPECT_NEAR(cost(moved(-14, 0), Extent::beginning), 4, 0.1);
  EXPECT_NEAR(cost(moved(100, 0), Extent::whole), 20, 0.1) << "twenty at most";
  // Larger or smaller about the middle of the box, by the logarithm over a quarter.
  const auto sized = [](double scale) {
    const double stays = 109 / 2.0 * (1 - scale);
    return Affine{scale, 0, stays, 0, scale, stays};
  };
  for (const double scale : {std::exp(0.25), std::exp(-0.25)})
    EXPECT_NEAR(cost(sized(scale), Extent::whole), 1, 0.05) << scale;
  EXPECT_NEAR(cost(sized(std::exp(0.5)), Extent::whole), 4, 0.1);
}

}  // namespace
}  // namespace nazori::writing::test
