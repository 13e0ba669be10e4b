// SPDX-License-Identifier: Apache-2.0
// Where everything lies on a page: read from the content of the pages and compared with places worked out by
// hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "canvas.h"
#include "nazori/print/worksheet.h"
#include "page_parts.h"

namespace nazori::print {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

std::string inflated(const std::string& packed) {
  std::string content(1 << 20, '\0');
  auto length = static_cast<uLongf>(content.size());
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(content.data()), &length,
                       reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size())),
            Z_OK);
  content.resize(length);
  return content;
}

double mm(const std::string& points) { return std::stod(points) * 25.4 / 72; }

/// A page: its size, and what its content draws.
struct Page {
  double width_mm = 0;
  double height_mm = 0;
  std::string content;

  struct Mark {
    std::string name;
    double x = 0, y = 0;  ///< of the lower left corner, or of the upper left one for characters; y down
    double grey = 0;
  };
  [[nodiscard]] std::vector<Mark> all(const std::string& pattern) const {
    std::vector<Mark> marks;
    const std::regex one(pattern);
    for (auto at = std::sregex_iterator(content.begin(), content.end(), one); at != std::sregex_iterator();
         ++at)
      marks.push_back(
          {(*at)[3], mm((*at)[1]), height_mm - mm((*at)[2]), (*at).size() > 4 ? std::stod((*at)[4]) : 0});
    return marks;
  }
  [[nodiscard]] std::vector<Mark> cells() const { return all(R"(q 1 0 0 1 (\S+) (\S+) cm /(G\d+) Do Q)"); }
  [[nodiscard]] std::vector<Mark> characters() const {
    std::vector<Mark> marks;
    static const std::regex one(R"(q \[\] 0 d (\S+) G \S+ 0 0 \S+ (\S+) (\S+) cm\n/(C\d+) Do)");
    for (auto at = std::sregex_iterator(content.begin(), content.end(), one); at != std::sregex_iterator();
         ++at)
      marks.push_back({(*at)[4], mm((*at)[2]), height_mm - mm((*at)[3]), std::stod((*at)[1])});
    return marks;
  }
  [[nodiscard]] std::size_t count(const std::string& words) const {
    std::size_t found = 0;
    for (std::size_t at = content.find(words); at != std::string::npos; at = content.find(words, at + 1))
      ++found;
    return found;
  }
};

std::string object(const std::string& pdf, const std::string& number) {
  const std::size_t at = pdf.find("\n" + number + " 0 obj\n");
  EXPECT_NE(at, std::string::npos) << number;
  return pdf.substr(at + 1, pdf.find("\nendobj\n", at) - at);
}

std::vector<Page> pages_of(const base::Result<std::string>& made) {
  std::vector<Page> pages;
  EXPECT_TRUE(made);
  if (!made) return pages;
  const std::string& pdf = *made;
  static const std::regex page(
      R"(/Type /Page /Parent \d+ 0 R /MediaBox \[0 0 (\S+) (\S+)\] .*?/Contents (\d+) 0 R)");
  for (auto at = std::sregex_iterator(pdf.begin(), pdf.end(), page); at != std::sregex_iterator(); ++at) {
    const std::string stream = object(pdf, (*at)[3]);
    const std::size_t begin = stream.find("stream\n") + 7;
    pages.push_back(
        {mm((*at)[1]), mm((*at)[2]), inflated(stream.substr(begin, stream.rfind("\nendstream") - begin))});
  }
  return pages;
}

/// A character of so many level strokes.
SheetCharacter with_strokes(char32_t code_point, std::size_t strokes, std::vector<kanji::Word> words = {}) {
  SheetCharacter one;
  one.character.code_point = code_point;
  kanji::Stroke stroke;
  stroke.path = "M10,50c10,0,30,0,40,0";
  stroke.line.points = {{10, 50}, {50, 50}};
  one.character.strokes.assign(strokes, stroke);
  one.words = std::move(words);
  return one;
}

SheetSettings bare() {
  SheetSettings settings;
  settings.facts = settings.numbers = settings.arrows = false;
  return settings;
}

void expect_at(const Page::Mark& mark, double x, double y) {
  EXPECT_NEAR(mark.x, x, 0.01);
  EXPECT_NEAR(mark.y, y, 0.01);
}

TEST(PageLayout, PapersHaveTheirSizes) {
  for (const auto& [paper, width, height] : {std::tuple{Paper::a4, 210.0, 297.0},
                                             {Paper::b5, 182.0, 257.0},
                                             {Paper::letter, 215.9, 279.4},
                                             {Paper::hanshi, 243.0, 334.0}}) {
    SheetSettings settings = bare();
    settings.paper = paper;
    Page page = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0);
    EXPECT_NEAR(page.width_mm, width, 0.01);
    EXPECT_NEAR(page.height_mm, height, 0.01);
    settings.layout = Layout::manuscript;
    page = pages_of(worksheet_pdf({}, settings)).at(0);
    EXPECT_NEAR(page.width_mm, height, 0.01) << "across";
    EXPECT_NEAR(page.height_mm, width, 0.01);
    settings = bare();
    settings.paper = paper;
    settings.booklet = true;
    settings.rows = 0;
    page = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0);
    EXPECT_NEAR(page.width_mm, height, 0.02) << "two half pages";
    EXPECT_NEAR(page.height_mm, width, 0.01);
  }
}

// Margins of 12 mm, a header of 9 mm: the model begins at (12, 21) and is 24 mm wide; then 1.5 mm, a step of
// 12 mm, 1.5 mm and rows of twelve cells of 15 mm.
TEST(PageLayout, ACharacterHasItsModelItsStepsAndItsCells) {
  const auto pages = pages_of(worksheet_pdf({with_strokes(U'一', 1), with_strokes(U'二', 16)}, bare()));
  ASSERT_THAT(pages, SizeIs(1));
  const auto cells = pages[0].cells();
  // The second has sixteen steps in two rows, because fifteen fit.
  ASSERT_THAT(cells, SizeIs(1 + 1 + 24 + 1 + 16 + 24));
  expect_at(cells[0], 12, 45);
  expect_at(cells[1], 12, 46.5 + 12);
  for (std::size_t k = 0; k < 24; ++k)
    expect_at(cells[2 + k], 12 + 15 * static_cast<double>(k % 12),
              60 + 15 * static_cast<double>(k / 12) + 15);
  // 69 mm and a gap of 3 mm later.
  expect_at(cells[26], 12, 45 + 72);
  for (std::size_t k = 0; k < 16; ++k)
    expect_at(cells[27 + k], 12 + 12 * static_cast<double>(k % 15),
              118.5 + 12 * static_cast<double>(k / 15) + 12);
  expect_at(cells[43], 12, 118.5 + 24 + 1.5 + 15);
  EXPECT_EQ(cells[0].name, cells[26].name);
  EXPECT_NE(cells[0].name, cells[1].name);
  EXPECT_NE(cells[1].name, cells[2].name);

  const auto drawn = pages[0].characters();
  ASSERT_THAT(drawn, SizeIs(10));
  expect_at(drawn[0], 12, 21);
  EXPECT_EQ(drawn[0].name, "C0");
  EXPECT_EQ(drawn[0].grey, 0);
  const double greys[] = {0.5, 0.63, 0.75, 0.88};
  for (std::size_t k = 0; k < 4; ++k) {
    expect_at(drawn[1 + k], 12 + 15 * static_cast<double>(k), 60);
    EXPECT_EQ(drawn[1 + k].grey, greys[k]) << "fainter and fainter";
    EXPECT_EQ(drawn[6 + k].name, "C1");
  }
  // Each step shows what is there already, fainter, and the new stroke.
  EXPECT_EQ(pages[0].count("0.62 G"), 15U);
  EXPECT_EQ(pages[0].count("m 20 50 40 50 50 50 c S"), 1 + 120 + 16U);
}

TEST(PageLayout, AsManyCharactersAsFitStandOnAPage) {
  // 260 mm hold three of 72 mm, and with one row less four of 57 mm.
  const std::vector<SheetCharacter> four(4, with_strokes(U'一', 1));
  SheetSettings settings = bare();
  EXPECT_THAT(pages_of(worksheet_pdf(four, settings)), SizeIs(2));
  settings.rows = 1;
  EXPECT_THAT(pages_of(worksheet_pdf(four, settings)), SizeIs(1));
  settings.rows = 0;
  settings.copies = 0;
  const auto page = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0);
  EXPECT_THAT(page.cells(), SizeIs(2)) << "no cells to write in";
  EXPECT_THAT(page.characters(), SizeIs(1));
  settings.steps = false;
  EXPECT_THAT(pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0).cells(), SizeIs(1));
}

TEST(PageLayout, OneCopyIsMediumGreyAndCellsLargerThanModelsMakeThemLarger) {
  SheetSettings settings = bare();
  settings.copies = 1;
  const auto drawn = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0).characters();
  ASSERT_THAT(drawn, SizeIs(2));
  EXPECT_EQ(drawn[1].grey, 0.5);
  // A model is 1.6 cells, 24 to 60 mm; a step is a cell, 12 mm at most.
  for (const auto& [cell, model, step] :
       {std::tuple{8.0, 24.0, 8.0}, {20.0, 32.0, 12.0}, {40.0, 60.0, 12.0}}) {
    settings.cell_mm = cell;
    const auto cells = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0).cells();
    expect_at(cells.at(0), 12, 21 + model);
    expect_at(cells.at(1), 12, 21 + model + 1.5 + step);
    expect_at(cells.at(2), 12, 21 + model + 1.5 + step + 1.5 + cell);
  }
}

TEST(PageLayout, AWholePageHasAllTheRowsThatFit) {
  SheetSettings settings = bare();
  settings.whole_page = true;
  const auto pages = pages_of(worksheet_pdf({with_strokes(U'一', 1), with_strokes(U'二', 2)}, settings));
  ASSERT_THAT(pages, SizeIs(2));
  // 254 - 24 - 13.5 - 1.5 = 215 mm: fourteen rows.
  EXPECT_THAT(pages[0].cells(), SizeIs(1 + 1 + 14 * 12));
  EXPECT_THAT(pages[1].cells(), SizeIs(1 + 2 + 14 * 12));
}

TEST(PageLayout, VerticalPagesGoDownAndToTheLeft) {
  SheetSettings settings = bare();
  settings.vertical = true;
  const auto pages = pages_of(worksheet_pdf({with_strokes(U'一', 1), with_strokes(U'二', 1)}, settings));
  const auto cells = pages.at(0).cells();
  // Sixteen cells in a column of 254 mm.
  ASSERT_THAT(cells, SizeIs(2 * (2 + 32)));
  expect_at(cells[0], 198 - 24, 45);
  expect_at(cells[1], 198 - 25.5 - 12, 21 + 12);
  expect_at(cells[2], 198 - 39 - 15, 36);
  expect_at(cells[17], 198 - 39 - 15, 36 + 225);
  expect_at(cells[18], 198 - 39 - 30, 36);
  expect_at(cells[34], 198 - 72 - 24, 45);
}

TEST(PageLayout, MoreStepsThanReckonedWithTakeThePlaceOfRows) {
  SheetSettings settings = bare();
  settings.rows = 11;  // 24 + 3 + 165 + 48 = 240 of 260 mm
  const auto cells = pages_of(worksheet_pdf({with_strokes(U'一', 80)}, settings)).at(0).cells();
  // Six rows of steps leave 260 - 24 - 1.5 - 72 - 1.5 = 161 mm: ten rows.
  EXPECT_THAT(cells, SizeIs(1 + 80 + 120));
}

TEST(PageLayout, NumbersAndArrowsAreThereWhereTheyAreAskedFor) {
  const std::vector<SheetCharacter> one{with_strokes(U'一', 3)};
  SheetSettings settings = bare();
  const auto content = [&] { return pages_of(worksheet_pdf(one, settings)).at(0).content; };
  EXPECT_THAT(content(), Not(HasSubstr(" l f\n")));
  EXPECT_THAT(content(), Not(HasSubstr("BT 0.35 g")));
  settings.arrows = settings.numbers = true;
  const Page page{0, 0, content()};
  EXPECT_EQ(page.count(" l f\n"), 3U);
  EXPECT_EQ(page.count("BT 0.35 g"), 3U);
}

TEST(PageLayout, AQuizHasACellForEachLetterAndPrintsWhatIsNotAsked) {
  SheetSettings settings = bare();
  settings.layout = Layout::quiz;
  settings.answers = true;
  const std::vector<SheetCharacter> asked{
      with_strokes(U'休', 6,
                   {word("一二三四五六七八", "long", "too long"), word("休日", "きゅうじつ", "holiday")}),
      with_strokes(U'木', 4, {word("休日", "きゅうじつ", "holiday"), word("木", "き", "tree")})};
  const auto pages = pages_of(worksheet_pdf(asked, settings));
  ASSERT_THAT(pages, SizeIs(2));
  for (const Page& page : pages) {
    const auto cells = page.cells();
    ASSERT_THAT(cells, SizeIs(3)) << "each word once";
    expect_at(cells[0], 12, 36);
    expect_at(cells[1], 27, 36);
    expect_at(cells[2], 12, 54);
  }
  EXPECT_THAT(pages[0].characters(), SizeIs(0));
  const auto answers = pages[1].characters();
  ASSERT_THAT(answers, SizeIs(2));
  expect_at(answers[0], 12, 21);
  expect_at(answers[1], 12, 39);
  // 日 in a tenth of its cell from the edges.
  EXPECT_EQ(pages[0].count("BT 0.35 g 0 Tr"), 1U);
}

TEST(PageLayout, AQuizPageHoldsFourteenLines) {
  SheetSettings settings = bare();
  settings.layout = Layout::quiz;
  std::vector<SheetCharacter> asked;
  for (int i = 0; i < 15; ++i) {
    const auto c = static_cast<char32_t>(0x4E00 + i);
    asked.push_back(with_strokes(c, 1, {word("あ" + std::to_string(i), "a", "b")}));
  }
  EXPECT_THAT(pages_of(worksheet_pdf(asked, settings)), SizeIs(2));
  asked.pop_back();
  EXPECT_THAT(pages_of(worksheet_pdf(asked, settings)), SizeIs(1));
  settings.answers = true;
  EXPECT_THAT(pages_of(worksheet_pdf(asked, settings)), SizeIs(2));
  EXPECT_EQ(worksheet_pdf({with_strokes(U'一', 1)}, settings).error().what,
            "none of the characters has a word to ask");
}

// Two columns of 85 mm and five rows of 50 mm, 20 mm from the left and 16 mm from the top.
TEST(PageLayout, CardsLieBackToBackBetweenCutMarks) {
  SheetSettings settings = bare();
  settings.layout = Layout::cards;
  const std::vector<SheetCharacter> eleven(11, with_strokes(U'一', 1));
  const auto pages = pages_of(worksheet_pdf(eleven, settings));
  ASSERT_THAT(pages, SizeIs(4));
  const auto front = pages[0].characters();
  ASSERT_THAT(front, SizeIs(10));
  for (std::size_t i = 0; i < 10; ++i)
    expect_at(front[i], 20 + 85 * static_cast<double>(i % 2) + 21.5, 20 + 50 * static_cast<double>(i / 2));
  EXPECT_THAT(pages[1].characters(), SizeIs(0));
  EXPECT_THAT(pages[2].characters(), SizeIs(1));
  const auto marks = pages[0].all(R"((\S+) (\S+) (m) \S+ \S+ l S)");
  ASSERT_THAT(marks, SizeIs(2 * 3 + 2 * 6));
  expect_at(marks[0], 20, 12);
  expect_at(marks[1], 20, 16 + 250 + 1);
  expect_at(marks[4], 190, 12);
  expect_at(marks[6], 16, 16);
  expect_at(marks[7], 191, 16);
  expect_at(marks[16], 16, 266);
}

// 20 columns of 20 cells of 9.1 mm, 1.4 cells apart, and one free column in the middle.
TEST(PageLayout, ManuscriptPaperIsFilledFromTheRight) {
  SheetSettings settings;
  settings.layout = Layout::manuscript;
  const auto page = pages_of(worksheet_pdf({}, settings)).at(0);
  const auto cells = page.all(R"((\S+) (\S+) \S+ (\S+) re S)");
  ASSERT_THAT(cells, SizeIs(400));
  const double right = 12 + (273 - 29.4 * 9.1) / 2 + 29.4 * 9.1;
  expect_at(cells[0], right - 12.74, 12 + 9.1);
  expect_at(cells[19], right - 12.74, 12 + 182);
  expect_at(cells[20], right - 2 * 12.74, 12 + 9.1);
  expect_at(cells[199], right - 10 * 12.74, 12 + 182);
  expect_at(cells[200], right - 12 * 12.74, 12 + 9.1);
  const auto places = [&](const std::string& text) {
    settings.text = text;
    return pages_of(worksheet_pdf({}, settings)).at(0).all(R"(BT 0\.5 g 0 Tr 1 0 0 1 (\S+) (\S+) (Tm))");
  };
  const auto letters = places("\r休\n日");
  // The text of the footer is as grey, but not vertical: the letters come after it.
  ASSERT_GE(letters.size(), 2U);
  const auto& second = letters.back();
  const auto& first = letters[letters.size() - 2];
  EXPECT_NEAR(first.x - second.x, 12.74, 0.02) << "a new line is a new column";
  EXPECT_NEAR(first.y, second.y, 0.02);
  EXPECT_NEAR(first.x, right - 12.74 + 0.08 * 9.1, 0.02);
}

TEST(PageLayout, ACloseAtTheTopOfAColumnSharesTheCellBefore) {
  SheetSettings settings;
  settings.layout = Layout::manuscript;
  const auto last = [&](const std::string& text) {
    settings.text = text;
    return pages_of(worksheet_pdf({}, settings))
        .at(0)
        .all(R"(BT 0\.5 g 0 Tr 1 0 0 1 (\S+) (\S+) (Tm))")
        .back();
  };
  std::string twenty;
  for (int i = 0; i < 20; ++i) twenty += "休";
  const auto kanji = last(twenty);
  for (const char* sign : {"、", "。", "」", "』"}) {
    const auto close = last(twenty + sign);
    EXPECT_NEAR(close.y - kanji.y, 0.12 * 9.1, 0.02) << sign;
    EXPECT_NEAR(close.x, kanji.x, 0.02) << sign;
    EXPECT_LT(last(twenty + "休" + sign).x, kanji.x - 10) << "in a column it has its own cell";
  }
  EXPECT_LT(last(twenty + "「").x, kanji.x - 10) << "what opens begins a column";
}

TEST(PageLayout, TheLinesOfTheHeaderAreShorterOnNarrowPaperAndNotLongerOnWide) {
  // Between the margins A4 has 186 mm, B5 158 and hanshi 219.
  for (const auto& [paper, scale] :
       {std::pair{Paper::a4, 1.0}, {Paper::b5, 158 / 186.0}, {Paper::hanshi, 1.0}}) {
    SheetSettings settings = bare();
    settings.paper = paper;
    const Page page = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings)).at(0);
    std::vector<double> lengths;
    static const std::regex one(R"(0\.4 G 0\.57 w \[\] 0 d (\S+) \S+ m (\S+) \S+ l S)");
    for (auto at = std::sregex_iterator(page.content.begin(), page.content.end(), one);
         at != std::sregex_iterator(); ++at)
      lengths.push_back(mm((*at)[2]) - mm((*at)[1]));
    ASSERT_THAT(lengths, SizeIs(3));
    EXPECT_NEAR(lengths[0], 24 * scale - 2, 0.01);
    EXPECT_NEAR(lengths[1], 20 * scale - 2, 0.01);
    EXPECT_NEAR(lengths[2], 46 * scale - 2, 0.01);
  }
}

TEST(PageLayout, AHeaderHasThreeLinesToFillInAndATitle) {
  SheetSettings settings = bare();
  settings.title = "Week 3";
  const auto pages = pages_of(worksheet_pdf({with_strokes(U'一', 1)}, settings));
  const auto lines = pages.at(0).all(R"(0\.4 G 0\.57 w \[\] 0 d (\S+) (\S+) (m) \S+ \S+ l S)");
  ASSERT_THAT(lines, SizeIs(3));
  for (const auto& line : lines) EXPECT_NEAR(line.y, 17.3, 0.01);
  // Both leave room for a disc of the mark.
  EXPECT_NEAR(lines[0].x, 198 - 6 - 24, 0.01);
  EXPECT_GT(lines[0].x, lines[1].x + 20);
  EXPECT_GT(lines[1].x, lines[2].x + 46);
  // Before each line stands its name, in letters of 3.2 mm.
  Fonts fonts = *Fonts::installed();
  const auto names = pages[0].all(R"(BT 0\.2 g 0 Tr 1 0 0 1 (\S+) (\S+) (Tm) /F\d 9\.07 Tf)");
  ASSERT_THAT(names, SizeIs(3));
  const char32_t* const words[] = {U"Date", U"Class", U"Name"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(names[i].x, lines[i].x - fonts.width(words[i]) * 3.2 - 1, 0.01) << i;
    EXPECT_NEAR(names[i].y, 16.5, 0.01) << i;
  }
  // The number of the page stands at the lower right, in letters of 2.6 mm.
  const auto number = pages[0].all(R"(BT 0\.3 g 0 Tr 1 0 0 1 (\S+) (\S+) (Tm) /F\d 7\.37 Tf)");
  ASSERT_THAT(number, SizeIs(1));
  expect_at(number[0], 198 - fonts.width(U"1") * 2.6, 297 - 12.6);
  const auto title = pages[0].all(R"(BT 0 g 0 Tr 1 0 0 1 (\S+) (\S+) (Tm) /F0 11\.34 Tf)");
  ASSERT_THAT(title, SizeIs(1));
  expect_at(title[0], 12 + 6, 16.5);
}

}  // namespace
}  // namespace nazori::print
