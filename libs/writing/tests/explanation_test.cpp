// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;

TEST(Explanation, SaysWhichStrokeWasDrawnBeforeWhich) {
  auto ink = trace(rest());
  std::swap(ink.strokes[1], ink.strokes[2]);
  const auto g = graded(ink, model_of(rest()));
  EXPECT_THAT(explain(g, Language::english), ElementsAre("Stroke 3 was drawn before stroke 2."));
  EXPECT_THAT(explain(g, Language::japanese), ElementsAre("2画目より先に3画目を書きました。"));
}

TEST(Explanation, NamesTheStrokeToComeFirstByTheNumberOfTheModel) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin() + 1, ink.strokes.begin() + 3);
  ink.strokes.resize(2);
  const auto live = grade_live(ink, model_of(rest()), {kNormal, true});
  ASSERT_TRUE(live);
  EXPECT_THAT(explain(*live, Language::english), ElementsAre("Stroke 2 comes first."));
  EXPECT_THAT(explain(*live, Language::japanese), ElementsAre("先に2画目を書きます。"));
}

TEST(Explanation, SaysWhereAStrokeStarts) {
  auto ink = trace(rest());
  ink.strokes[3] = reversed(ink.strokes[3]);
  EXPECT_THAT(explain(graded(ink, model_of(rest())), Language::english),
              ElementsAre("Stroke 4 starts at the top."));
  auto bar = trace(rest());
  bar.strokes[2] = reversed(bar.strokes[2]);
  EXPECT_THAT(explain(graded(bar, model_of(rest())), Language::japanese),
              ElementsAre("3画目は左から書き始めます。"));
}

TEST(Explanation, NumbersAreTheModelsEvenAfterAMissingStroke) {
  auto ink = trace(rest());
  ink.strokes.erase(ink.strokes.begin());
  ink.strokes[2] = reversed(ink.strokes[2]);
  EXPECT_THAT(explain(graded(ink, model_of(rest())), Language::english),
              ElementsAre("Stroke 1 is missing.", "Stroke 4 starts at the top."));
}

TEST(Explanation, SaysInWhichDirectionAStrokeIsOff) {
  auto ink = trace(rest());
  for (auto& p : ink.strokes[2].points) p.y += 30;
  EXPECT_THAT(explain(graded(ink, model_of(rest())), Language::english), ElementsAre("Stroke 3 is too low."));
}

TEST(Explanation, PraisesInBothLanguages) {
  const auto g = graded(trace(rest()), model_of(rest()));
  EXPECT_THAT(explain(g, Language::english), ElementsAre("Right."));
  EXPECT_THAT(explain(g, Language::japanese), ElementsAre("正しく書けました。"));
}

TEST(Explanation, NamesTheOrderThatIsAlsoUsed) {
  Grade g;
  g.accepted = true;
  g.alternative = kanji::AlternativeOrder{{2, 1, 3}, "Tebiki 1958 list; the older order, short bar first"};
  EXPECT_THAT(explain(g, Language::english),
              ElementsAre("Right; this stroke order is also used: 2 1 3 (Tebiki 1958 list)."));
  EXPECT_THAT(explain(g, Language::japanese),
              ElementsAre("正しく書けました。この書き順も使われます：2 1 3 (Tebiki 1958 list)。"));
}

TEST(Explanation, ThePartsOfTheScoreAddUpToIt) {
  auto ink = trace(rest());
  std::swap(ink.strokes[1], ink.strokes[2]);
  ink.strokes.pop_back();
  for (auto& p : ink.strokes[3].points) p.x += 7;
  for (const auto& g : {graded(ink, model_of(rest())), graded(trace(rest()), model_of(rest()))}) {
    const auto sentences = explain_score(g, Language::english);
    ASSERT_EQ(sentences.size(), 5U);
    int points = 0;
    int most = 0;
    for (const auto& sentence : sentences) {
      const auto colon = sentence.find(": ");
      ASSERT_NE(colon, std::string::npos) << sentence;
      points += std::stoi(sentence.substr(colon + 2));
      most += std::stoi(sentence.substr(sentence.find(" of ") + 4));
    }
    EXPECT_EQ(points, g.score);
    EXPECT_EQ(most, 100);
  }
  EXPECT_EQ(explain_score(graded(trace(rest()), model_of(rest())), Language::japanese)[1],
            "書き順：15点中15点（順番どおりか）。");
}

TEST(Explanation, EveryKindOfFaultIsASentenceInEveryLanguage) {
  Grade g;
  g.strokes.resize(3);
  for (int kind = 0; kind <= static_cast<int>(FaultKind::ending); ++kind) {
    for (int deviation = 0; deviation <= static_cast<int>(Deviation::length); ++deviation) {
      Fault fault{static_cast<FaultKind>(kind), 1, 2, {1, 2}, static_cast<Deviation>(deviation)};
      fault.character = U'士';
      const auto english = explain(fault, g, Language::english);
      const auto japanese = explain(fault, g, Language::japanese);
      EXPECT_TRUE(english.ends_with('.')) << english;
      EXPECT_TRUE(japanese.ends_with("。")) << japanese;
      EXPECT_EQ(english.find('{'), std::string::npos) << english;
      EXPECT_EQ(japanese.find('{'), std::string::npos) << japanese;
    }
  }
}

}  // namespace
}  // namespace nazori::writing::test
