// SPDX-License-Identifier: Apache-2.0
// Each script from its first to its last character, by the blocks of the Unicode Standard.
#include "nazori/writing/among.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace nazori::writing {
namespace {

using Blocks = std::vector<std::pair<char32_t, char32_t>>;

void has_exactly(Among among, const Blocks& blocks) {
  for (const auto& [first, last] : blocks) {
    SCOPED_TRACE(static_cast<std::uint32_t>(first));
    EXPECT_TRUE(is_among(first, among));
    EXPECT_TRUE(is_among(last, among));
    EXPECT_TRUE(is_among(first + (last - first) / 2, among));
    EXPECT_FALSE(is_among(first - 1, among));
    EXPECT_FALSE(is_among(last + 1, among));
  }
}

TEST(Among, KanaAreTheirTwoBlocksWithoutCombiningMarksAndTheDot) {
  has_exactly(Among::kana, {{0x3041, 0x3096}, {0x309B, 0x309F}, {0x30A1, 0x30FA}, {0x30FC, 0x30FF}});
}

TEST(Among, KanjiAreRadicalsIterationMarksAndIdeographsOfEveryPlane) {
  has_exactly(Among::kanji,
              {{0x2E80, 0x2FDF}, {0x3005, 0x3007}, {0x3400, 0x9FFF}, {0xF900, 0xFAFF}, {0x20000, 0x3FFFF}});
}

TEST(Among, LettersAreLatinOnesAndDigits) {
  has_exactly(Among::letters, {{U'A', U'Z'}, {U'a', U'z'}, {U'0', U'9'}});
}

TEST(Among, EverythingIsAmongAll) {
  for (const char32_t one : {U'a', U'カ', U'力', U'!', char32_t{0}}) EXPECT_TRUE(is_among(one, Among::all));
}

}  // namespace
}  // namespace nazori::writing
