// SPDX-License-Identifier: Apache-2.0
// Which drawn stroke is which, on made-up characters of straight strokes.
#include "alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Shape line(std::vector<double> xs, std::vector<double> ys) { return make_shape(xs, ys); }

/// Seven strokes that are clearly different.
std::vector<Shape> seven() {
  return {line({10, 60}, {10, 10}), line({80, 80}, {8, 60}),  line({15, 55}, {25, 45}),
          line({55, 12}, {52, 85}), line({40, 70}, {60, 62}), line({70, 100}, {75, 100}),
          line({10, 50}, {100, 98})};
}
std::vector<Shape> pairs_of(const std::vector<Shape>& model) {
  std::vector<Shape> pairs;
  for (std::size_t k = 0; k + 1 < model.size(); ++k)
    pairs.push_back(joined(model[k].whole, model[k + 1].whole));
  return pairs;
}
const Shape kStray = line({95, 20, 105}, {20, 30, 40});
const Affine kBox{};

struct Model {
  std::vector<Shape> strokes = seven();
  std::vector<Shape> pairs = pairs_of(strokes);
  [[nodiscard]] Alignment align(const std::vector<Shape>& drawn, Extent extent = Extent::whole) const {
    return writing::align({drawn, strokes, pairs, kBox, extent});
  }
};

/// "0>1": drawn stroke 0 is the model's 1; "0>1+": two of the model; "0+>1": two drawn; "0<1": drawn
/// backwards.
std::vector<std::string> told(const Alignment& a) {
  std::vector<std::string> words;
  for (const auto& l : a.links)
    words.push_back(std::to_string(l.drawn) + (l.drawn_count == 2 ? "+" : "") +
                    (l.difference.reversed ? "<" : ">") + std::to_string(l.model) +
                    (l.model_count == 2 ? "+" : ""));
  return words;
}

TEST(Alignment, OfTheModelItselfCostsNothing) {
  const Model model;
  const auto a = model.align(model.strokes);
  EXPECT_THAT(told(a), ElementsAre("0>0", "1>1", "2>2", "3>3", "4>4", "5>5", "6>6"));
  EXPECT_THAT(a.missing, IsEmpty());
  EXPECT_THAT(a.extra, IsEmpty());
  EXPECT_NEAR(a.cost, 0, 0.01);
  EXPECT_NEAR(a.map.a, 1, 1e-3);
}

TEST(Alignment, FindsEachStrokeLeftOut) {
  const Model model;
  std::vector<float> costs;
  for (std::size_t gone = 0; gone < 7; ++gone) {
    auto drawn = model.strokes;
    drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(gone));
    const auto a = model.align(drawn);
    EXPECT_THAT(a.missing, ElementsAre(static_cast<int>(gone)));
    EXPECT_THAT(a.extra, IsEmpty());
    ASSERT_EQ(a.links.size(), 6U);
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(a.links[static_cast<std::size_t>(i)].drawn, i);
      EXPECT_EQ(a.links[static_cast<std::size_t>(i)].model, i < static_cast<int>(gone) ? i : i + 1);
    }
    costs.push_back(a.cost);
  }
  EXPECT_LT(*std::max_element(costs.begin(), costs.end()) - *std::min_element(costs.begin(), costs.end()),
            1.5F);
}

TEST(Alignment, FindsEachStrokeTooMany) {
  const Model model;
  for (std::size_t at = 0; at <= 7; ++at) {
    auto drawn = model.strokes;
    drawn.insert(drawn.begin() + static_cast<std::ptrdiff_t>(at), kStray);
    const auto a = model.align(drawn);
    EXPECT_THAT(a.extra, ElementsAre(static_cast<int>(at)));
    EXPECT_THAT(a.missing, IsEmpty());
    EXPECT_EQ(a.links.size(), 7U);
    for (const auto& l : a.links) EXPECT_EQ(l.model, l.drawn < static_cast<int>(at) ? l.drawn : l.drawn - 1);
  }
}

TEST(Alignment, FindsEachPairInAnyOrder) {
  const Model model;
  for (std::size_t i = 0; i < 7; ++i)
    for (std::size_t k = i + 1; k < 7; ++k) {
      auto drawn = model.strokes;
      std::swap(drawn[i], drawn[k]);
      const auto a = model.align(drawn);
      ASSERT_EQ(a.links.size(), 7U);
      for (const auto& l : a.links) {
        const auto d = static_cast<std::size_t>(l.drawn);
        EXPECT_EQ(l.model, static_cast<int>(d == i ? k : d == k ? i : d)) << i << " " << k;
      }
      EXPECT_GT(a.cost, 1) << "another order costs a little";
      EXPECT_LT(a.cost, 5);
    }
}

TEST(Alignment, FindsEachPairJoined) {
  const Model model;
  for (std::size_t at = 0; at + 1 < 7; ++at) {
    auto drawn = model.strokes;
    drawn[at] = joined(drawn[at].whole, drawn[at + 1].whole);
    drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    const auto a = model.align(drawn);
    ASSERT_EQ(a.links.size(), 6U) << at;
    for (const auto& l : a.links) {
      EXPECT_EQ(l.model_count, l.drawn == static_cast<int>(at) ? 2 : 1) << at;
      EXPECT_EQ(l.model, l.drawn <= static_cast<int>(at) ? l.drawn : l.drawn + 1);
    }
    EXPECT_THAT(a.missing, IsEmpty());
    EXPECT_THAT(a.extra, IsEmpty());
  }
}

TEST(Alignment, FindsEachStrokeInTwoPieces) {
  const Model model;
  for (std::size_t at = 0; at < 7; ++at) {
    auto drawn = model.strokes;
    const auto& whole = model.strokes[at].whole;
    const double mx = (whole.x.front() + whole.x.back()) / 2.0, my = (whole.y.front() + whole.y.back()) / 2.0;
    drawn[at] = line({whole.x.front(), mx}, {whole.y.front(), my});
    drawn.insert(drawn.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                 line({mx, whole.x.back()}, {my, whole.y.back()}));
    const auto a = model.align(drawn);
    ASSERT_EQ(a.links.size(), 7U) << at;
    for (const auto& l : a.links) EXPECT_EQ(l.drawn_count, l.model == static_cast<int>(at) ? 2 : 1) << at;
    EXPECT_THAT(a.missing, IsEmpty());
    EXPECT_THAT(a.extra, IsEmpty());
  }
}

TEST(Alignment, FindsEachStrokeDrawnBackwards) {
  const Model model;
  for (std::size_t at = 0; at < 7; ++at) {
    auto drawn = model.strokes;
    std::reverse(drawn[at].whole.x.begin(), drawn[at].whole.x.end());
    std::reverse(drawn[at].whole.y.begin(), drawn[at].whole.y.end());
    const auto a = model.align(drawn);
    ASSERT_EQ(a.links.size(), 7U);
    for (const auto& l : a.links) {
      EXPECT_EQ(l.model, l.drawn);
      EXPECT_EQ(l.difference.reversed, l.drawn == static_cast<int>(at)) << at;
    }
  }
}

TEST(Alignment, TheCostsOfMistakesAreInTheirOrder) {
  const Model model;
  const auto without = [&](std::vector<std::size_t> gone) {
    std::vector<Shape> drawn;
    for (std::size_t k = 0; k < 7; ++k)
      if (std::find(gone.begin(), gone.end(), k) == gone.end()) drawn.push_back(model.strokes[k]);
    return drawn;
  };
  const float missing = model.align(without({3})).cost;
  const float two_missing = model.align(without({1, 4})).cost;
  auto more = model.strokes;
  more.insert(more.begin() + 2, kStray);
  const float extra = model.align(more).cost;
  more.insert(more.begin() + 5, line({90, 108}, {50, 52}));
  const float two_extra = model.align(more).cost;
  auto strange = model.strokes;
  strange[3] = line({90, 105, 60}, {20, 100, 30});
  const auto wrong = model.align(strange);
  EXPECT_NEAR(missing, extra, 1.5) << "one too few is as likely as one too many";
  EXPECT_NEAR(two_missing, 2 * missing, 2.5);
  EXPECT_NEAR(two_extra, 2 * extra, 2.5);
  EXPECT_LT(wrong.cost, missing + extra) << "a strange stroke stands for the right one";
  EXPECT_GT(wrong.cost, missing + 5);
  EXPECT_THAT(told(wrong), ElementsAre("0>0", "1>1", "2>2", "3>3", "4>4", "5>5", "6>6"));
  auto in_one = model.strokes;
  in_one[4] = joined(in_one[4].whole, in_one[5].whole);
  in_one.erase(in_one.begin() + 5);
  const float together = model.align(in_one).cost;
  EXPECT_LT(together, missing - 2) << "else it were one of the two, and the other missing";
  EXPECT_GT(together, 10);
}

TEST(Alignment, StrangeStrokesStandForEachOtherInTheOrderOfTheirTurns) {
  const Model model;
  auto drawn = model.strokes;
  std::rotate(drawn.begin(), drawn.begin() + 1, drawn.end());  // in any order
  drawn[2] = line({90, 108, 60, 100}, {10, 100, 10, 20});
  drawn[4] = line({5, 108, 10, 100}, {108, 3, 3, 60});
  const auto a = model.align(drawn);
  ASSERT_EQ(a.links.size(), 7U);
  std::vector<int> strange;
  for (const auto& l : a.links) {
    if (l.drawn == 2 || l.drawn == 4)
      strange.push_back(l.model);
    else
      EXPECT_EQ(l.model, (l.drawn + 1) % 7);
  }
  EXPECT_THAT(strange, ElementsAre(3, 5));
}

TEST(Alignment, OfTheBeginningLaterStrokesAreNotMissing) {
  const Model model;
  for (std::size_t count = 1; count <= 7; ++count) {
    const std::vector<Shape> drawn(model.strokes.begin(),
                                   model.strokes.begin() + static_cast<std::ptrdiff_t>(count));
    const auto a = model.align(drawn, Extent::beginning);
    EXPECT_THAT(a.missing, IsEmpty()) << count;
    EXPECT_NEAR(a.cost, 0, 0.05) << count;
    for (const auto& l : a.links) EXPECT_EQ(l.model, l.drawn);
  }
}

TEST(Alignment, OfTheBeginningPassingOverIsOneSlipHoweverManyArePassedOver) {
  const Model model;
  std::vector<float> costs;
  for (std::size_t passed = 1; passed <= 5; ++passed) {
    const std::vector<Shape> drawn{model.strokes[0], model.strokes[1 + passed]};
    const auto a = model.align(drawn, Extent::beginning);
    ASSERT_EQ(a.links.size(), 2U);
    EXPECT_EQ(a.links[1].model, static_cast<int>(1 + passed));
    std::vector<int> between;
    for (int k = 1; k <= static_cast<int>(passed); ++k) between.push_back(k);
    EXPECT_EQ(a.missing, between);
    costs.push_back(a.cost);
  }
  for (std::size_t k = 1; k < costs.size(); ++k) {
    EXPECT_GE(costs[k], costs[k - 1] - 0.3F);
    EXPECT_LT(costs[k] - costs[k - 1], 2);
  }
  EXPECT_GT(costs[0], 5);
  EXPECT_LT(costs.back(), 18);
}

TEST(Alignment, OfTheBeginningAStrangeStrokeStandsForTheOneThatIsDue) {
  const Model model;
  std::vector<Shape> drawn{model.strokes[0], model.strokes[1], line({90, 108, 60, 100}, {10, 100, 10, 20})};
  const auto a = model.align(drawn, Extent::beginning);
  ASSERT_EQ(a.links.size(), 3U);
  EXPECT_EQ(a.links[2].model, 2);
  EXPECT_THAT(a.extra, IsEmpty());
}

TEST(Alignment, TheBoxTellsWhichOfEqualStrokesOneIs) {
  const std::vector<Shape> bars{line({20, 80}, {20, 20}), line({20, 80}, {55, 55}), line({20, 80}, {90, 90})};
  const auto pairs = pairs_of(bars);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Shape> drawn{bars[k]};
    const auto a = align({drawn, bars, pairs, kBox, Extent::whole});
    ASSERT_EQ(a.links.size(), 1U);
    EXPECT_EQ(a.links[0].model, static_cast<int>(k));
    // The same writing in a box of another place and size.
    const std::vector<Shape> far{transformed(bars[k], {0.01, 0, 7, 0, 0.01, -3})};
    const auto b = align({far, bars, pairs, Affine{100, 0, -700, 0, 100, 300}, Extent::whole});
    EXPECT_EQ(b.links.at(0).model, static_cast<int>(k));
    EXPECT_NEAR(b.cost, a.cost, 0.5);
  }
}

TEST(Alignment, TheBoxCostsLittleWhereTheStrokesThemselvesTell) {
  const Model model;
  std::vector<Shape> small;
  for (const auto& s : model.strokes) small.push_back(transformed(s, {0.4, 0, 60, 0, 0.4, 5}));
  const auto a = model.align(small);
  for (const auto& l : a.links) EXPECT_EQ(l.model, l.drawn);
  EXPECT_EQ(a.links.size(), 7U);
  EXPECT_GT(a.cost, 1) << "it was written small, in a corner";
  EXPECT_LT(a.cost, 21);
  const auto without = align({small, model.strokes, model.pairs, {}, Extent::whole});
  EXPECT_NEAR(without.cost, 0, 0.05);
}

TEST(Alignment, WithoutABoxPlaceAndSizeDoNotCount) {
  const Model model;
  std::vector<Shape> moved;
  for (const auto& s : model.strokes) moved.push_back(transformed(s, {0.003, 0, 9, 0, 0.003, -4}));
  moved.erase(moved.begin() + 2);
  const auto a = align({moved, model.strokes, model.pairs, {}, Extent::whole});
  EXPECT_THAT(a.missing, ElementsAre(2));
  EXPECT_NEAR(a.cost,
              model.align({seven()[0], seven()[1], seven()[3], seven()[4], seven()[5], seven()[6]}).cost, 2);
}

TEST(RoughAlignment, TellsTheRightModelFromAnother) {
  const Model model;
  auto other = model.strokes;
  std::reverse(other.begin(), other.end());
  for (auto& s : other) s = transformed(s, {0, 1, 0, 1, 0, 0});
  const auto right = align_roughly({model.strokes, model.strokes, {}, {}, Extent::whole}, 1000);
  const auto wrong = align_roughly({model.strokes, other, {}, {}, Extent::whole}, 1000);
  EXPECT_NEAR(right.cost, 0, 0.05);
  EXPECT_GT(wrong.cost, 60);
  EXPECT_EQ(right.links.size(), 7U);
  EXPECT_NEAR(right.map.a, 1, 0.01);
}

TEST(RoughAlignment, FindsWhatTheWholeOneFinds) {
  const Model model;
  auto shuffled = model.strokes;
  std::rotate(shuffled.begin(), shuffled.begin() + 3, shuffled.end());
  const auto a = align_roughly({shuffled, model.strokes, model.pairs, {}, Extent::whole}, 1000);
  for (const auto& l : a.links) EXPECT_EQ(l.model, (l.drawn + 3) % 7);
  EXPECT_LT(a.cost, 6);
  auto fewer = model.strokes;
  fewer.erase(fewer.begin() + 4);
  EXPECT_THAT(align_roughly({fewer, model.strokes, model.pairs, {}, Extent::whole}, 1000).missing,
              ElementsAre(4));
  const std::vector<Shape> beginning(model.strokes.begin(), model.strokes.begin() + 3);
  const auto begun = align_roughly({beginning, model.strokes, model.pairs, {}, Extent::beginning}, 1000);
  EXPECT_NEAR(begun.cost, 0, 0.1);
  EXPECT_THAT(begun.missing, IsEmpty());
}

}  // namespace
}  // namespace nazori::writing::test
