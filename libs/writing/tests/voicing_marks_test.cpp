// SPDX-License-Identifier: Apache-2.0
// A kana with one of its two voicing marks.
#include "voicing_marks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "drawing.h"
#include "nazori/writing/explanation.h"

namespace nazori::writing::test {
namespace {

using testing::ElementsAre;

// KanjiVG 20220427 (Ulrich Apel, CC BY-SA 3.0).
kanji::Character ga() {
  return character(U'が',
                   {"|M24.62,38.62c1.88,1.62,4.65,2.33,8.62,1c25.5-8.5,29.5-4.13,29.5,7.62c0,9.38-1.24,17.46-"
                    "4.25,25.25c-7.62,19.76-10.87,17.39-16.12,10.89",
                    "|M48.5,17.5c1,1.38,1.29,4.7,0.5,7.12c-5,15.25-18.02,40.93-19.62,43.88c-3.12,5.75-6.38,"
                    "11.88-9.38,16.25",
                    "|M77.37,31.62c7.5,6.88,13.25,15.75,15,24.88", "|M80.5,18.25c2.75,1.75,6,5.38,7.75,8.5",
                    "|M86.87,13.38c3.06,1.57,6.68,4.82,8.62,7.62"});
}

/// With one stroke less.
WrittenCharacter without(std::size_t stroke) {
  auto ink = trace(ga());
  ink.strokes.erase(ink.strokes.begin() + static_cast<std::ptrdiff_t>(stroke));
  return ink;
}

TEST(VoicingMarks, AreTheLastTwoStrokesOfAVoicedKana) {
  EXPECT_EQ(first_voicing_mark(ga()), 3U);
  for (const char32_t plain : {U'か', U'ぱ', U'ヽ', U'休'}) {
    auto other = ga();
    other.code_point = plain;
    EXPECT_EQ(first_voicing_mark(other), std::nullopt);
  }
  auto cut = ga();
  cut.strokes.resize(2);
  EXPECT_EQ(first_voicing_mark(cut), std::nullopt) << "a character of nothing but marks";
}

TEST(VoicingMarks, OneMissingIsNamedTheLikelierFirst) {
  for (const int gone : {3, 4}) {
    const int there = gone == 3 ? 4 : 3;
    const auto g = graded(without(static_cast<std::size_t>(gone)), model_of(ga()));
    EXPECT_THAT(mistake_names(g), ElementsAre("missing@" + std::to_string(gone)));
    EXPECT_THAT(g.mistakes.front().model, ElementsAre(gone, there));
    EXPECT_EQ(g.strokes.back().matched, there);
    for (const auto& s : g.strokes) EXPECT_TRUE(s.ok);
  }
  EXPECT_THAT(explain(graded(without(4), model_of(ga())), Language::english),
              ElementsAre("Stroke 5 or 4 is missing."));
}

/// The strokes of か stretched about the middle and moved to the right; the marks stay where they are.
WrittenCharacter beside_marks(std::size_t gone, double wide, double right) {
  auto ink = without(gone);
  for (std::size_t k = 0; k < 3; ++k)
    for (auto& p : ink.strokes[k]) p.at.x = 54 + wide * (p.at.x - 54) + right;
  return ink;
}

TEST(VoicingMarks, AreToldApartByTheirPlaceInTheBoxWhereTheOtherStrokesAreOff) {
  for (const auto& [gone, right] : {std::pair(3, 6.0), std::pair(4, -6.0)})
    EXPECT_THAT(mistake_names(graded(beside_marks(static_cast<std::size_t>(gone), 1, right), model_of(ga()))),
                ElementsAre("missing@" + std::to_string(gone)));
}

TEST(VoicingMarks, AreToldApartBesideANarrowCharacter) {
  for (const int gone : {3, 4})
    EXPECT_THAT(mistake_names(graded(beside_marks(static_cast<std::size_t>(gone), 0.85, 0), model_of(ga()))),
                ElementsAre("missing@" + std::to_string(gone)));
}

TEST(VoicingMarks, BothThereOrAnotherStrokeMissingNeedNoDecision) {
  EXPECT_TRUE(graded(trace(ga()), model_of(ga())).accepted);
  for (const std::size_t gone : {0U, 1U, 2U}) {
    const auto g = graded(without(gone), model_of(ga()));
    EXPECT_THAT(mistake_names(g), ElementsAre("missing@" + std::to_string(gone)));
    EXPECT_THAT(g.mistakes.front().model, ElementsAre(static_cast<int>(gone)));
  }
}

TEST(VoicingMarks, BothMissingAreBothNamed) {
  auto ink = trace(ga());
  ink.strokes.resize(3);
  EXPECT_THAT(mistake_names(graded(ink, model_of(ga()))), ElementsAre("missing@3", "missing@4"));
}

}  // namespace
}  // namespace nazori::writing::test
