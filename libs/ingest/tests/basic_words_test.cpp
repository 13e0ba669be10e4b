// SPDX-License-Identifier: Apache-2.0
#include "basic_words.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tables.h"

namespace nazori::ingest {
namespace {

EdictEntry word(const std::string& text, const std::string& reading) {
  EdictEntry entry;
  entry.text = text;
  entry.reading = reading;
  return entry;
}

TEST(BasicWords, AreKnownByTextAndReadingTogether) {
  EXPECT_TRUE(is_basic(word("木曜日", "もくようび")));
  EXPECT_TRUE(is_basic(word("人", "ひと")));
  EXPECT_FALSE(is_basic(word("人", "じん")));
  EXPECT_FALSE(is_basic(word("本木", "もとき")));
  EXPECT_FALSE(is_basic(word("", "")));
}

TEST(BasicWords, EachStandsInTheTableOnceWithItsReading) {
  std::set<std::string> seen;
  for (const auto& row : table_rows(basic_words_table())) {
    ASSERT_EQ(row.size(), 2U) << row[0];
    EXPECT_TRUE(seen.insert(std::string(row[0]) + " " + std::string(row[1])).second) << row[0];
    EXPECT_FALSE(row[1].empty()) << row[0];
  }
  EXPECT_GT(seen.size(), 2000U);
}

}  // namespace
}  // namespace nazori::ingest
