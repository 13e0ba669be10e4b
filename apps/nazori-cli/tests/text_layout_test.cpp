// SPDX-License-Identifier: Apache-2.0
#include "text_layout.h"

#include <gtest/gtest.h>

#include <vector>

namespace nazori::cli {
namespace {

TEST(TextLayout, KanjiAndKanaTakeTwoColumnsLettersOneMarksNone) {
  EXPECT_EQ(display_width("休"), 2);
  EXPECT_EQ(display_width("やすむ"), 6);
  EXPECT_EQ(display_width("rest"), 4);
  EXPECT_EQ(display_width("e\u0301"), 1);
  EXPECT_EQ(display_width("\U0002000B"), 2);
  EXPECT_EQ(display_width(""), 0);
}

TEST(TextLayout, PaddingCountsColumnsNotBytes) {
  EXPECT_EQ(pad("休", 4), "休  ");
  EXPECT_EQ(pad("on", 4), "on  ");
  EXPECT_EQ(pad("キュウ", 4), "キュウ");
}

TEST(TextLayout, ALongListFlowsInLinesThatFitWithoutBreakingItems) {
  const std::vector<std::string> items{"rest", "day off", "retire", "sleep"};
  EXPECT_EQ(flow(items, ", ", 4, 20), "rest, day off,\n    retire, sleep");
  EXPECT_EQ(flow(items, ", ", 0, 80), "rest, day off, retire, sleep");
  const std::vector<std::string> wide{"休休休休", "休休休休"};
  EXPECT_EQ(flow(wide, "  ", 2, 12), "休休休休\n  休休休休");
}

TEST(TextLayout, CutsAtACharacterNeverInsideOne) {
  EXPECT_EQ(cut("休日", 3), "休");
  EXPECT_EQ(cut("休日", 4), "休日");
  EXPECT_EQ(cut("休日", 0), "");
}

TEST(TextLayout, WhatCannotBeShownIsSpelledOut) {
  EXPECT_EQ(printable("休\xFF!"), "休\\xFF!");
  EXPECT_EQ(printable("a\nb"), "a\\x0Ab");
  EXPECT_EQ(printable("\xE4\xBC"), "\\xE4\\xBC");
}

TEST(TextLayout, OkuriganaIsSetApartByAMiddleDot) {
  EXPECT_EQ(with_middle_dot("やす.む"), "やす・む");
  EXPECT_EQ(with_middle_dot("キュウ"), "キュウ");
}

TEST(TextLayout, TextThatIsNotUtf8IsAsWideAsItsBytes) {
  EXPECT_EQ(display_width("\xE4\xBC"), 2);
  EXPECT_EQ(pad("\xFF", 3), "\xFF  ");
  EXPECT_EQ(cut("\xFF\xFE"
                "ab",
                3),
            "\xFF\xFE"
            "a");
}

TEST(TextLayout, WhatFillsALineExactlyStaysOnIt) {
  const std::vector<std::string> items{"ab", "cd", "ef"};
  EXPECT_EQ(flow(items, " ", 0, 8), "ab cd ef");
  EXPECT_EQ(flow(items, " ", 0, 7), "ab cd\nef");
  EXPECT_EQ(flow(items, " ", 3, 8), "ab cd\n   ef");
  EXPECT_EQ(flow(items, ", ", 1, 4), "ab,\n cd,\n ef");
  EXPECT_EQ(flow({}, " ", 3, 8), "");
  EXPECT_EQ(pad("休日", 4), "休日");
  EXPECT_EQ(pad("休日", 5), "休日 ");
}

TEST(TextLayout, LongTextKeepsItsBeginningAndAThirdOfItsEnd) {
  EXPECT_EQ(shortened("abcdefghijklmnop", 16), "abcdefghijklmnop");
  EXPECT_EQ(shortened("abcdefghijklmnop", 15), "abcdefghi…lmnop");
  EXPECT_EQ(shortened("abcdefghijklmnop", 10), "abcdef…nop");
  EXPECT_EQ(shortened("abcdefghijklmnop", 1), "…");
  EXPECT_EQ(shortened("休休休休休休", 12), "休休休休休休") << "18 bytes, 12 columns";
  EXPECT_EQ(shortened("休日休日休日", 7), "休日…日");
  EXPECT_EQ(shortened("休日休日休日", 11), "休日休…日") << "half a character does not fit";
  EXPECT_EQ(shortened("", 0), "");
}

TEST(TextLayout, OnlyControlCharactersAndWrongBytesAreSpelledOut) {
  EXPECT_EQ(printable("\x1F \x7F~"), "\\x1F \\x7F~");
  EXPECT_EQ(printable("é休\U0001F600"), "é休\U0001F600");
  EXPECT_EQ(printable("\xE4\xBC\x91\xE4"), "休\\xE4");
  EXPECT_EQ(printable(""), "");
}

TEST(TextLayout, OnlyTheFirstDotBecomesAMiddleDot) { EXPECT_EQ(with_middle_dot("a.b.c"), "a・b.c"); }

}  // namespace
}  // namespace nazori::cli
