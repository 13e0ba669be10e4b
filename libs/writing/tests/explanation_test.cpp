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
  EXPECT_THAT(explain(g, Language::english), ElementsAre("Stroke 2 comes before stroke 3."));
  EXPECT_THAT(explain(g, Language::japanese), ElementsAre("2画目は3画目より先に書きます。"));
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
  for (auto& p : ink.strokes[2]) p.at.y += 30;
  EXPECT_THAT(explain(graded(ink, model_of(rest())), Language::english), ElementsAre("Stroke 3 is too low."));
}

TEST(Explanation, PraisesInBothLanguages) {
  const auto g = graded(trace(rest()), model_of(rest()));
  EXPECT_THAT(explain(g, Language::english), ElementsAre("Correct."));
  EXPECT_THAT(explain(g, Language::japanese), ElementsAre("正解です。"));
}

TEST(Explanation, NamesTheOrderThatIsAlsoUsed) {
  Grade g;
  g.accepted = true;
  g.alternative = kanji::AlternativeOrder{{2, 1, 3}, "Tebiki 1958 list; the older order, short bar first"};
  EXPECT_THAT(explain(g, Language::english),
              ElementsAre("Correct. This stroke order is also accepted: 2 1 3 (Tebiki 1958 list)."));
  EXPECT_THAT(explain(g, Language::japanese),
              ElementsAre("正解です。この書き順も使われます：2 1 3 (Tebiki 1958 list)。"));
}

TEST(Explanation, ThePartsOfTheScoreAddUpToIt) {
  auto ink = trace(rest());
  std::swap(ink.strokes[1], ink.strokes[2]);
  ink.strokes.pop_back();
  for (auto& p : ink.strokes[3]) p.at.x += 7;
  for (const auto& g : {graded(ink, model_of(rest())), graded(trace(rest()), model_of(rest()))}) {
    const auto sentences = explain_score(g, Language::english);
    ASSERT_EQ(sentences.size(), 5U);
    int points = 0;
    int most = 0;
    for (const auto& sentence : sentences) {
      const auto colon = sentence.find(": ");
      ASSERT_NE(colon, std::string::npos) << sentence;
      points += std::stoi(sentence.substr(colon + 2));
      most += std::stoi(sentence.substr(sentence.find('/') + 1));
    }
    EXPECT_EQ(points, g.score);
    EXPECT_EQ(most, 100);
  }
  EXPECT_EQ(explain_score(graded(trace(rest()), model_of(rest())), Language::japanese)[1],
            "書き順：15点中15点");
}

TEST(Explanation, SaysOfAWrongStrokeWhatDeviatesMost) {
  Grade g;
  g.strokes.resize(1);
  const auto said = [&g](Deviation deviation) {
    return explain(Mistake{kanji::MistakeKind::wrong, 0, {}, {1}, deviation}, g, Language::english);
  };
  auto& v = g.strokes[0];
  v.offset_x = 0.2, v.offset_y = 0.1;
  EXPECT_EQ(said(Deviation::place), "Stroke 2 is too far to the right.");
  v.offset_x = -0.2;
  EXPECT_EQ(said(Deviation::place), "Stroke 2 is too far to the left.");
  v.offset_y = 0.3;
  EXPECT_EQ(said(Deviation::place), "Stroke 2 is too low.");
  v.offset_y = -0.3;
  EXPECT_EQ(said(Deviation::place), "Stroke 2 is too high.");
  v.size = 1.2;
  EXPECT_EQ(said(Deviation::length), "Stroke 2 is too long.");
  v.size = 0.9;
  EXPECT_EQ(said(Deviation::length), "Stroke 2 is too short.");
  EXPECT_EQ(said(Deviation::direction), "Stroke 2 slants the wrong way.");
  EXPECT_EQ(said(Deviation::shape), "Stroke 2 has the wrong shape.");
  EXPECT_EQ(said(Deviation::none), "Stroke 2 has the wrong shape.");
  EXPECT_EQ(explain(Mistake{kanji::MistakeKind::wrong, 1, {}, {1}, Deviation::length}, g, Language::english),
            "Stroke 2 has the wrong shape.")
      << "a stroke that nobody looked at";
}

TEST(Explanation, EachMistakeHasItsOwnWords) {
  Grade g;
  const auto said = [&g](const Mistake& mistake) { return explain(mistake, g, Language::english); };
  EXPECT_EQ(said({kanji::MistakeKind::order, 0, 1, {4, 2}}), "Stroke 3 comes before stroke 5.");
  EXPECT_EQ(said({kanji::MistakeKind::order, 0, {}, {4, 2}}), "Stroke 3 comes first.");
  EXPECT_EQ(said({kanji::MistakeKind::order, 0, 1, {4}}), "Stroke 5 has the wrong shape.");
  EXPECT_EQ(said({kanji::MistakeKind::joined, 0, {}, {4, 5}}),
            "Write strokes 5 and 6 separately: lift the pen between them.");
  EXPECT_EQ(said({kanji::MistakeKind::joined, 0, {}, {4}}), "Stroke 5 has the wrong shape.");
  EXPECT_EQ(said({kanji::MistakeKind::extra, 3, {}, {}}), "Your stroke 4 isn't part of this character.");
  EXPECT_EQ(said({kanji::MistakeKind::missing, 3, {}, {}}), "Stroke 4 is missing.")
      << "by its own number where none is named";
  EXPECT_EQ(said({kanji::MistakeKind::missing, 4, {}, {4, 3}}), "Stroke 5 or 4 is missing.")
      << "the likelier first";
  Mistake mistake{kanji::MistakeKind::reversed, 0, {}, {1}};
  const std::pair<Side, std::string> sides[] = {
      {Side::top, "top"}, {Side::bottom, "bottom"}, {Side::left, "left"}, {Side::right, "right"}};
  for (const auto& [side, word] : sides) {
    mistake.start = side;
    EXPECT_EQ(said(mistake), "Stroke 2 starts at the " + word + ".");
  }
  Mistake ending{kanji::MistakeKind::ending, 0, {}, {1}};
  ending.expected = kanji::StrokeEnding::hook;
  EXPECT_EQ(said(ending), "Stroke 2 ends with a hook.");
  ending.expected = kanji::StrokeEnding::stop;
  EXPECT_EQ(said(ending), "Stroke 2 ends with a stop, not a hook.");
  Mistake other{kanji::MistakeKind::other, 0, {}, {1}};
  other.character = U'士';
  EXPECT_EQ(said(other), "This looks like 士. Check stroke 2.");
}

TEST(Explanation, SaysMistakesBeforeAdviceAndWhichFormWasRight) {
  Grade g;
  g.mistakes = {{kanji::MistakeKind::missing, 0, {}, {0}}, {kanji::MistakeKind::missing, 1, {}, {1}}};
  g.advice = {{kanji::MistakeKind::missing, 2, {}, {2}}};
  EXPECT_THAT(explain(g, Language::english),
              ElementsAre("Stroke 1 is missing.", "Stroke 2 is missing.", "Stroke 3 is missing."));
  Grade other;
  other.accepted = true;
  other.variant = "Kaisho";
  EXPECT_THAT(explain(other, Language::english), ElementsAre("Correct. This form is also accepted."));
}

TEST(Explanation, ThePointsThatRoundingCutGoToThePartsThatLostMost) {
  Grade g;
  // 15, 13.5, 13.5, 19.75 and 7.2 points.
  g.parts = {0.5, 0.9, 0.9, 0.79, 0.48};
  g.score = 69;
  EXPECT_THAT(
      explain_score(g, Language::english),
      ElementsAre(testing::StartsWith("Strokes: 15/30"), testing::StartsWith("Order: 14/15"),
                  testing::StartsWith("Direction: 13/15"), testing::StartsWith("Shape and size: 20/25"),
                  testing::StartsWith("Balance: 7/15")));
}

TEST(Explanation, EveryKindOfMistakeIsASentenceInEveryLanguage) {
  Grade g;
  g.strokes.resize(3);
  for (int kind = 0; kind <= static_cast<int>(kanji::MistakeKind::ending); ++kind) {
    for (int deviation = 0; deviation <= static_cast<int>(Deviation::length); ++deviation) {
      Mistake mistake{static_cast<kanji::MistakeKind>(kind), 1, 2, {1, 2}, static_cast<Deviation>(deviation)};
      mistake.character = U'士';
      const auto english = explain(mistake, g, Language::english);
      const auto japanese = explain(mistake, g, Language::japanese);
      EXPECT_TRUE(english.ends_with('.')) << english;
      EXPECT_TRUE(japanese.ends_with("。")) << japanese;
      EXPECT_EQ(english.find('{'), std::string::npos) << english;
      EXPECT_EQ(japanese.find('{'), std::string::npos) << japanese;
    }
  }
}

}  // namespace
}  // namespace nazori::writing::test
