// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/strengths.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace nazori::practice {
namespace {

using study::Strength;

TEST(Strengths, EachHasASignOfItsOwn) {
  std::set<char32_t> signs;
  for (const auto strength : {Strength::unseen, Strength::learning, Strength::young, Strength::mature,
                              Strength::leech, Strength::paused})
    EXPECT_TRUE(signs.insert(look_of(strength).sign).second);
  EXPECT_EQ(look_of(Strength::unseen).sign, 0U);
}

TEST(Strengths, WhatIsNotStudiedOrSuspendedHasADashedEdge) {
  EXPECT_TRUE(look_of(Strength::unseen).dashed);
  EXPECT_TRUE(look_of(Strength::paused).dashed);
  for (const auto strength : {Strength::learning, Strength::young, Strength::mature, Strength::leech})
    EXPECT_FALSE(look_of(strength).dashed);
}

TEST(Strengths, TheBetterKnownTheMoreAccentHasTheFill) {
  const auto share = [](Strength strength) {
    const Colour fill = look_of(strength).fill;
    return fill.role == ColourRole::accent ? 1 : fill.over == ColourRole::accent ? fill.share : 0;
  };
  EXPECT_EQ(share(Strength::unseen), 0);
  EXPECT_LT(share(Strength::unseen), share(Strength::learning));
  EXPECT_LT(share(Strength::learning), share(Strength::young));
  EXPECT_LT(share(Strength::young), share(Strength::mature));
}

TEST(Strengths, EachHasItsLook) {
  const auto plain = [](ColourRole role) { return Colour{role, role, 0}; };
  const auto over = [](ColourRole role, double share) { return Colour{ColourRole::surface, role, share}; };
  struct Look {
    Strength strength;
    Colour fill;
    ColourRole text;
    char32_t sign;
    double bar;
  };
  for (const Look& look :
       {Look{Strength::unseen, plain(ColourRole::surface), ColourRole::muted, 0, 0},
        Look{Strength::learning, over(ColourRole::accent, 0.10), ColourRole::text, U'◔', 0.3},
        Look{Strength::young, over(ColourRole::accent, 0.30), ColourRole::text, U'◑', 0.6},
        Look{Strength::mature, plain(ColourRole::accent), ColourRole::surface, U'●', 1},
        Look{Strength::leech, over(ColourRole::warning, 0.22), ColourRole::text, U'!', 0.3},
        Look{Strength::paused, plain(ColourRole::paper), ColourRole::muted, U'‖', 0}}) {
    const StrengthLook found = look_of(look.strength);
    EXPECT_EQ(found.fill, look.fill);
    EXPECT_EQ(found.text, plain(look.text));
    EXPECT_EQ(found.sign, look.sign);
    EXPECT_EQ(bar_of(look.strength), look.bar);
  }
}

TEST(Strengths, OfAListAlsoWhatIsNotStudiedHasAState) {
  study::Statistics s;
  s.characters = {{U'一', Strength::mature, 0.95}, {U'二', Strength::young, 0.9}};
  const auto states = states_of(std::u32string_view(U"二三"), s);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0], (study::CharacterState{U'二', Strength::young, 0.9}));
  EXPECT_EQ(states[1], (study::CharacterState{U'三', Strength::unseen, 0}));
}

TEST(Strengths, AreCountedTheFirmestFirst) {
  const std::array states{study::CharacterState{U'一', Strength::mature, 0.9},
                          study::CharacterState{U'二', Strength::young, 0.9},
                          study::CharacterState{U'三', Strength::learning, 0.8},
                          study::CharacterState{U'四', Strength::young, 0.7},
                          study::CharacterState{U'五', Strength::paused, 0.5},
                          study::CharacterState{U'六', Strength::leech, 0.5}};
  EXPECT_EQ(count_by_strength(states), (std::vector<std::pair<Strength, int>>{{Strength::mature, 1},
                                                                              {Strength::young, 2},
                                                                              {Strength::learning, 1},
                                                                              {Strength::leech, 1},
                                                                              {Strength::paused, 1}}));
  EXPECT_TRUE(count_by_strength({}).empty());
}

TEST(Strengths, TheBarIsLongerTheBetterACharacterIsKnown) {
  using study::Strength;
  EXPECT_EQ(bar_of(Strength::unseen), 0);
  EXPECT_EQ(bar_of(Strength::paused), 0);
  EXPECT_GT(bar_of(Strength::learning), 0);
  EXPECT_EQ(bar_of(Strength::leech), bar_of(Strength::learning));
  EXPECT_GT(bar_of(Strength::young), bar_of(Strength::learning));
  EXPECT_GT(bar_of(Strength::mature), bar_of(Strength::young));
  EXPECT_EQ(bar_of(Strength::mature), 1);
}

}  // namespace
}  // namespace nazori::practice
