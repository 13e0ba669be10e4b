// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/meanings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nazori::kanji {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Meanings, AreThoseOfOneLanguageInTheOrderOfTheDictionary) {
  DictionaryEntry entry;
  entry.meanings = {{"en", "rest"}, {"fr", "repos"}, {"en", "sleep"}};
  EXPECT_THAT(meanings_in("en", entry), ElementsAre("rest", "sleep"));
  EXPECT_THAT(meanings_in("fr", entry), ElementsAre("repos"));
  EXPECT_THAT(meanings_in("ja", entry), IsEmpty());
}

}  // namespace
}  // namespace nazori::kanji
