// SPDX-License-Identifier: Apache-2.0
// What stands beside the model of a character, which language it is in, and the order of a vertical booklet.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/print/page_drawing.h"
#include "nazori/print/worksheet.h"
#include "page_parts.h"

namespace nazori::print {
namespace {

using testing::HasSubstr;
using testing::Not;

SheetCharacter described(std::vector<kanji::Word> words) {
  SheetCharacter one;
  one.character.code_point = U'休';
  kanji::Stroke stroke;
  stroke.path = "M10,50c10,0,30,0,40,0";
  stroke.line.points = {{10, 50}, {50, 50}};
  one.character.strokes = {stroke};
  one.words = std::move(words);
  return one;
}

SheetSettings plain() {
  SheetSettings settings;
  settings.numbers = settings.arrows = settings.steps = settings.name_line = false;
  settings.rows = settings.copies = 0;
  return settings;
}

PageDrawing page_of(const SheetCharacter& one, const SheetSettings& settings) {
  auto made = Worksheet::lay_out({one}, settings);
  EXPECT_TRUE(made) << (made ? "" : base::to_line(made.error()));
  return made->page(0);
}

// The model is a square of 24 mm at (12, 21); beside it, after 3 mm, are the facts.
constexpr double kLeft_mm = 12 + 24 + 3, kTop_mm = 21, kBottom_mm = 45;

/// The texts beside the model in one grey, from the top.
std::vector<Box> texts(const PageDrawing& page, double grey) {
  std::vector<Box> found;
  for (const PageMark& mark : page.marks) {
    const Box box = box_of(mark);
    if (mark.filled && std::abs(mark.grey - grey) < 1e-9 && box.left > kLeft_mm - 0.5 &&
        box.top > kTop_mm - 1 && box.bottom < 60)
      found.push_back(box);
  }
  std::sort(found.begin(), found.end(), [](const Box& a, const Box& b) { return a.top < b.top; });
  return found;
}

TEST(FactsLayout, AReadingStandsAboveItsWordAndTheMeaningBesideIt) {
  const PageDrawing page = page_of(described({word("休", "やすみ", "rest")}), plain());
  const auto ruby = texts(page, 0.2), words = texts(page, 0), meaning = texts(page, 0.25);
  ASSERT_EQ(ruby.size(), 1U);
  ASSERT_EQ(words.size(), 1U);
  ASSERT_EQ(meaning.size(), 1U);
  EXPECT_LE(ruby[0].bottom, words[0].top + 0.3);
  EXPECT_GT(ruby[0].bottom, words[0].top - 1.5);
  EXPECT_GE(ruby[0].top, kTop_mm - 0.2);
  EXPECT_NEAR(ruby[0].left, kLeft_mm, 0.6);
  EXPECT_NEAR(words[0].left, kLeft_mm, 0.6);
  // A letter is 3.6 mm, and so small a word gives its reading less than its own 1.9 mm: 1.4 times the word
  // together.
  EXPECT_NEAR(words[0].right - words[0].left, 3.6, 0.8);
  EXPECT_LE(ruby[0].right - ruby[0].left, 1.4 * 3.6);
  EXPECT_GT(ruby[0].right - ruby[0].left, 1.1 * 3.6);
  // 2 mm behind the longer of both, on the line of the word.
  EXPECT_NEAR(meaning[0].left, kLeft_mm + 1.4 * 3.6 + 2, 0.6);
  EXPECT_GT(meaning[0].top, words[0].top - 0.5);
  EXPECT_LT(meaning[0].bottom, words[0].bottom + 0.5);
}

TEST(FactsLayout, AReadingOfALongWordHasItsOwnSize) {
  const PageDrawing page = page_of(described({word("休日出勤", "きゅうじつ", "")}), plain());
  const auto ruby = texts(page, 0.2);
  ASSERT_EQ(ruby.size(), 1U);
  EXPECT_NEAR(ruby[0].right - ruby[0].left, 5 * 1.9, 0.8);
  EXPECT_TRUE(texts(page, 0.25).empty()) << "no meaning, no text";
}

TEST(FactsLayout, AWordThatIsItsReadingHasNoneAboveIt) {
  const PageDrawing page = page_of(described({word("やすみ", "やすみ", "rest")}), plain());
  EXPECT_TRUE(texts(page, 0.2).empty());
  EXPECT_EQ(texts(page, 0).size(), 1U);
}

TEST(FactsLayout, WordsFollowOneAnotherAsLongAsThereIsRoomBesideTheModel) {
  std::vector<kanji::Word> words;
  for (int i = 0; i < 9; ++i) words.push_back(word("語", "ご", "word"));
  const PageDrawing page = page_of(described(words), plain());
  // Each takes 2.09 + 4.5 mm and needs 2.09 + 3.6 of them: three and a fourth would end at 25.5 of 24 mm.
  const auto lines = texts(page, 0);
  ASSERT_EQ(lines.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(lines[i].bottom, kBottom_mm);
  EXPECT_NEAR(lines[1].top - lines[0].top, 6.59, 0.02);
  EXPECT_NEAR(lines[2].top - lines[1].top, 6.59, 0.02);
}

TEST(FactsLayout, ReadingsAndMeaningsStandOnLinesOfTheirOwnAboveTheWords) {
  SheetCharacter one = described({word("休日", "きゅうじつ", "holiday"), word("休む", "やすむ", "to rest")});
  one.character.entry.on_readings = {"キュウ"};
  one.character.entry.kun_readings = {"やす.む"};
  one.character.entry.meanings = {{"en", "rest"}};
  const std::string text = page_of(one, plain()).text;
  EXPECT_LT(text.find("キュウ"), text.find("やす(む)"));
  EXPECT_LT(text.find("やす(む)"), text.find("rest"));
  EXPECT_LT(text.find("rest"), text.find("休日"));
  // Three lines of 4.86 mm and one word leave no room for a second one.
  EXPECT_THAT(text, HasSubstr("holiday"));
  EXPECT_THAT(text, Not(HasSubstr("休む")));
  // Without readings there is no empty line: both words fit.
  one.character.entry.on_readings.clear();
  one.character.entry.kun_readings.clear();
  const std::string fewer = page_of(one, plain()).text;
  EXPECT_THAT(fewer, Not(HasSubstr("kun")));
  EXPECT_THAT(fewer, Not(HasSubstr("on ")));
  EXPECT_THAT(fewer, HasSubstr("休む"));
}

TEST(FactsLayout, TextsThatAreTooLongEndAtTheMargin) {
  SheetCharacter one = described({word("休日", "きゅうじつ", std::string(300, 'm'))});
  one.character.entry.meanings = {{"en", std::string(300, 'w')}};
  const PageDrawing page = page_of(one, plain());
  double right = 0;
  for (const PageMark& mark : page.marks)
    if (const Box box = box_of(mark); mark.filled && box.bottom < 60) right = std::max(right, box.right);
  EXPECT_LE(right, 210 - kMargin_mm + 0.1);
  EXPECT_GT(right, 210 - kMargin_mm - 5) << "and uses the room";
}

// The first card lies back to back with the left one of the front: from 105 to 190 mm across and from 16 to
// 66 mm down.
TEST(FactsLayout, TheBackOfACardKeepsFiveMillimetresFromItsEdges) {
  SheetSettings settings = plain();
  settings.layout = Layout::cards;
  const std::vector<kanji::Word> words(12, word("語", "ご", std::string(300, 'm')));
  auto made = Worksheet::lay_out({described(words)}, settings);
  ASSERT_TRUE(made);
  ASSERT_EQ(made->page_count(), 2U);
  const PageDrawing page = made->page(1);
  Box inside;
  int lines = 0;
  for (const PageMark& mark : page.marks) {
    const Box box = box_of(mark);
    if (!mark.filled || box.top > 280) continue;
    inside.left = std::min(inside.left, box.left);
    inside.right = std::max(inside.right, box.right);
    inside.top = std::min(inside.top, box.top);
    inside.bottom = std::max(inside.bottom, box.bottom);
    if (mark.grey == 0) ++lines;
  }
  // Each takes 2.09 + 4.5 mm and needs 2.09 + 3.6 of them: six end at 38.64 of 40 mm.
  EXPECT_EQ(lines, 6);
  EXPECT_NEAR(inside.left, 110, 0.6);
  EXPECT_LE(inside.right, 185.1);
  EXPECT_GT(inside.right, 180) << "and uses the room";
  EXPECT_NEAR(inside.top, 21, 0.8);
  EXPECT_LE(inside.bottom, 61);
}

TEST(SheetLanguage, LabelsAndHeaderAreInTheLanguageOfTheSheet) {
  SheetCharacter one = described({});
  one.character.entry.on_readings = {"キュウ"};
  one.character.entry.kun_readings = {"やす.む"};
  SheetSettings settings;
  const auto text_in = [&](Language language) {
    settings.language = language;
    return page_of(one, settings).text;
  };
  const std::string english = text_in(Language::english), japanese = text_in(Language::japanese);
  for (const char* label : {"Name", "Class", "Date", "on キュウ", "kun やす"}) {
    EXPECT_THAT(english, HasSubstr(label));
    EXPECT_THAT(japanese, Not(HasSubstr(label)));
  }
  for (const char* label : {"名前", "組", "日付", "音 キュウ", "訓 やす"}) {
    EXPECT_THAT(japanese, HasSubstr(label));
    EXPECT_THAT(english, Not(HasSubstr(label)));
  }
  settings.layout = Layout::quiz;
  settings.answers = true;
  one.words = {word("休日", "きゅうじつ", "holiday")};
  for (const auto& [language, title] :
       {std::pair{Language::english, "Answers"}, {Language::japanese, "答え"}}) {
    settings.language = language;
    auto made = Worksheet::lay_out({one}, settings);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->page_count(), 2U);
    EXPECT_THAT(made->page(1).text, HasSubstr(title));
    EXPECT_THAT(made->page(0).text, Not(HasSubstr(title)));
  }
}

// No dictionary has words with a character that somebody made.
TEST(Quiz, AsksForAnOwnCharacterByItsOwnReadingAndMeaning) {
  SheetCharacter own = described({});
  own.character.code_point = 0xF1234;
  own.character.entry.kun_readings = {"まなびや"};
  own.character.entry.meanings = {{"en", "school sign"}};
  SheetCharacter second = own;
  second.character.code_point = 0xF0007;
  second.character.entry.kun_readings.clear();
  second.character.entry.meanings = {{"en", "club sign"}};
  SheetSettings settings;
  settings.layout = Layout::quiz;
  settings.answers = true;
  auto made = Worksheet::lay_out({own, second}, settings);
  ASSERT_TRUE(made) << base::to_line(made.error());
  ASSERT_EQ(made->page_count(), 2U);
  EXPECT_THAT(made->page(0).text, HasSubstr("まなびや"));
  EXPECT_THAT(made->page(0).text, HasSubstr("school sign"));
  EXPECT_THAT(made->page(0).text, HasSubstr("club sign"));
  own.words = {word("学校", "がっこう", "school")};
  made = Worksheet::lay_out({own}, settings);
  ASSERT_TRUE(made);
  EXPECT_THAT(made->page(0).text, HasSubstr("がっこう"));
  EXPECT_THAT(made->page(0).text, Not(HasSubstr("まなびや")));
}

TEST(SheetFile, SaysItsLanguageAndItsTitle) {
  SheetSettings settings;
  settings.title = "漢字";
  for (const auto& [language, name] :
       {std::pair{Language::english, "/Lang (en)"}, {Language::japanese, "/Lang (ja)"}}) {
    settings.language = language;
    const auto pdf = worksheet_pdf({described({})}, settings);
    ASSERT_TRUE(pdf);
    EXPECT_THAT(*pdf, HasSubstr(name));
    EXPECT_THAT(*pdf, HasSubstr("/Title <FEFF6F225B57>"));
  }
}

TEST(Booklet, AVerticalOneOpensAtItsOtherSide) {
  SheetSettings settings;
  settings.booklet = settings.whole_page = settings.vertical = true;
  settings.facts = settings.steps = false;
  std::vector<SheetCharacter> five;
  for (const char32_t c : std::u32string_view(U"一二三四五")) {
    five.push_back(described({}));
    five.back().character.code_point = c;
  }
  auto made = Worksheet::lay_out(five, settings);
  ASSERT_TRUE(made);
  ASSERT_EQ(made->page_count(), 4U) << "two sheets of paper";
  const auto halves = [&](std::size_t side) {
    const PageDrawing page = made->page(side);
    const double fold = page.width_mm / 2;
    int left = 0, right = 0;
    for (const PageMark& mark : page.marks)
      if (mark.round) ++(box_of(mark).right < fold ? left : right);
    return std::pair(left > 0, right > 0);
  };
  const auto text = [&](std::size_t side) { return made->page(side).text; };
  // Bound at the right: the first page is the left half of the first side, and beside it the eighth is empty.
  EXPECT_THAT(text(0), HasSubstr("一"));
  EXPECT_EQ(halves(0), std::pair(true, false));
  EXPECT_THAT(text(1), HasSubstr("二"));
  EXPECT_EQ(halves(1), std::pair(false, true));
  EXPECT_THAT(text(2), HasSubstr("三"));
  EXPECT_EQ(halves(2), std::pair(true, false));
  EXPECT_THAT(text(3), HasSubstr("四"));
  EXPECT_THAT(text(3), HasSubstr("五"));
  EXPECT_EQ(halves(3), std::pair(true, true));
}

TEST(WorksheetLimits, AreTakenAndWhatLiesBeyondIsRefused) {
  const auto takes = [](auto change) {
    SheetSettings settings = plain();
    change(settings);
    return Worksheet::lay_out({described({})}, settings).has_value();
  };
  EXPECT_TRUE(takes([](SheetSettings& s) { s.cell_mm = 8; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.cell_mm = 7.99; }));
  EXPECT_TRUE(takes([](SheetSettings& s) { s.cell_mm = 60; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.cell_mm = 60.01; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.rows = -1; }));
  EXPECT_TRUE(takes([](SheetSettings& s) { s.copies = 40; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.copies = 41; }));
  EXPECT_TRUE(takes([](SheetSettings& s) { s.rows = 40, s.whole_page = true; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.rows = 41, s.whole_page = true; }));
  // Of 254 mm above the mark the model takes 24, a gap 3, and without steps 227 mm are left for rows of 15
  // mm.
  EXPECT_TRUE(takes([](SheetSettings& s) { s.rows = 15; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.rows = 16; }));
  // Steps are reckoned with four rows of 12 mm.
  EXPECT_TRUE(takes([](SheetSettings& s) { s.rows = 11, s.steps = true; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.rows = 12, s.steps = true; }));
  // A vertical page is 186 mm deep.
  EXPECT_TRUE(takes([](SheetSettings& s) { s.rows = 10, s.vertical = true; }));
  EXPECT_FALSE(takes([](SheetSettings& s) { s.rows = 11, s.vertical = true; }));
}

}  // namespace
}  // namespace nazori::print
