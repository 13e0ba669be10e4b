// SPDX-License-Identifier: Apache-2.0
// The glosses are lines of EDICT (EDRDG, CC BY-SA 4.0).
#include "nazori/kanji/gloss.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/kanji/meaning_text.h"

namespace nazori::kanji {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Gloss, LosesTheMarksOfTheEditors) {
  EXPECT_EQ(plain_gloss("(uk) to bear fruit"), "to bear fruit");
  EXPECT_EQ(plain_gloss("(abbr) regular holiday"), "regular holiday");
  EXPECT_EQ(plain_gloss("(ksb:) university undergraduate"), "university undergraduate");
  EXPECT_EQ(plain_gloss("(kyu:) (rare) hello"), "hello");
  EXPECT_EQ(plain_gloss("(uk,abbr)(2) convenience store"), "convenience store");
  EXPECT_EQ(plain_gloss(" (P)"), "");
  EXPECT_EQ(plain_gloss(""), "");
}

TEST(Gloss, KeepsBracketsThatAreEnglish) {
  EXPECT_EQ(plain_gloss("(someone's) family"), "(someone's) family");
  EXPECT_EQ(plain_gloss("(human) life (i.e. conception to death)"),
            "(human) life (i.e. conception to death)");
  EXPECT_EQ(plain_gloss("(in) public"), "(in) public");
  EXPECT_EQ(plain_gloss("(uk"), "(uk");
  EXPECT_EQ(plain_gloss("Jupiter (planet)"), "Jupiter (planet)");
  EXPECT_EQ(plain_gloss("() nothing"), "() nothing");
}

TEST(Gloss, TellsWhatIsUnusualAndWhatIsWrittenInKana) {
  EXPECT_TRUE(is_unusual_gloss("(arch) you"));
  EXPECT_TRUE(is_unusual_gloss("(uk) (obsc) thing"));
  EXPECT_FALSE(is_unusual_gloss("(uk) thing"));
  EXPECT_FALSE(is_unusual_gloss("arch of a bridge"));
  EXPECT_TRUE(is_usually_kana("(col) (uk) thing"));
  EXPECT_FALSE(is_usually_kana("(col) thing"));
}

TEST(Gloss, OfAWordTheFirstPlainOnesAreGiven) {
  Word word;
  word.glosses = {"(arch) you", "thou", "he/she", "(abbr) he/she", "that person", "that one"};
  word.senses = {1, 1, 2, 3, 3, 3};
  EXPECT_THAT(plain_glosses(word, 3), ElementsAre("he/she", "that person", "that one"))
      << "the whole first sense is archaic";
  EXPECT_THAT(plain_glosses(word, 1), ElementsAre("he/she"));
  word.glosses = {"(arch) you", "thou"};
  word.senses = {1, 1};
  EXPECT_THAT(plain_glosses(word, 3), ElementsAre("you", "thou")) << "it has no other sense";
  EXPECT_THAT(plain_glosses(Word{}, 3), IsEmpty());
}

TEST(Gloss, IsFoldedForSearching) {
  EXPECT_EQ(fold_gloss("(uk) to rest (a while)"), "rest");
  EXPECT_EQ(fold_gloss("A day off"), "day off");
  EXPECT_EQ(fold_gloss("the people's livelihood"), "people's livelihood");
  EXPECT_EQ(fold_gloss("to a degree"), "a degree");
  EXPECT_EQ(fold_gloss("total"), "total");
  EXPECT_EQ(fold_gloss("Jupiter (planet)"), "jupiter");
  EXPECT_EQ(fold_gloss("odd) bracket ((nested) kept out) end"), "odd bracket end");
}

}  // namespace
}  // namespace nazori::kanji
