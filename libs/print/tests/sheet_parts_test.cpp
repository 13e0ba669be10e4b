// SPDX-License-Identifier: Apache-2.0
// The parts of a page, in the operators of PDF and by hand: 1 mm is 72 / 25.4 points, y goes up from the
// lower edge.
#include "../src/sheet_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "../src/pdf_writer.h"

namespace nazori::print {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Fonts& fonts() {
  static Fonts all = *Fonts::installed();
  return all;
}

/// What is drawn on a page of 100 mm.
template <class Draw>
std::string drawn(const Draw& draw) {
  Canvas canvas(fonts(), 100);
  draw(canvas);
  return canvas.content();
}

/// Where the letters of a text begin, in points.
std::vector<std::pair<std::string, std::string>> starts(const std::string& content) {
  std::vector<std::pair<std::string, std::string>> all;
  static const std::regex text(R"(1 0 0 1 (\S+) (\S+) Tm)");
  for (auto at = std::sregex_iterator(content.begin(), content.end(), text); at != std::sregex_iterator();
       ++at)
    all.emplace_back((*at)[1], (*at)[2]);
  return all;
}
using Start = std::pair<std::string, std::string>;

TEST(PageNumbers, HaveTwoDecimalsAtMost) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(12), "12");
  EXPECT_EQ(number(12.3), "12.3");
  EXPECT_EQ(number(12.34), "12.34");
  EXPECT_EQ(number(0.06), "0.06");
  EXPECT_EQ(number(1234.567), "1234.57");
  EXPECT_EQ(number(-0.5), "-0.5");
  EXPECT_EQ(number(-12.03), "-12.03");
  EXPECT_EQ(number(0.004), "0");
  EXPECT_EQ(number(-0.004), "0");
}

TEST(Canvas, DrawsInPointsFromTheLowerEdge) {
  const Pen solid{0.5, 0.2, 0}, dashed{0, 1, 1};
  EXPECT_EQ(drawn([&](Canvas& c) { c.line(10, 20, 30, 40, solid); }),
            "0.5 G 0.57 w [] 0 d 28.35 226.77 m 85.04 170.08 l S\n");
  EXPECT_EQ(drawn([&](Canvas& c) { c.line(10, 20, 30, 40, dashed); }),
            "0 G 2.83 w [2.83 2.83] 0 d 28.35 226.77 m 85.04 170.08 l S\n");
  EXPECT_EQ(drawn([&](Canvas& c) {
              c.rectangle({10, 20, 30, 40}, solid);
            }),
            "0.5 G 0.57 w [] 0 d 28.35 113.39 85.04 113.39 re S\n");
  EXPECT_EQ(drawn([&](Canvas& c) { c.triangle(10, 20, 30, 40, 50, 60, 0.25); }),
            "0.25 g 28.35 226.77 m 85.04 170.08 l 141.73 113.39 l f\n");
  EXPECT_EQ(drawn([&](Canvas& c) {
              c.object("G1", {10, 20, 30, 40});
            }),
            "q 1 0 0 1 28.35 113.39 cm /G1 Do Q\n");
  // Glyph units go down from the upper left corner of a square of 109.
  EXPECT_EQ(square_matrix({10, 20, 109, 109}, 100), "2.8346 0 0 -2.8346 28.35 226.77 cm\n");
  EXPECT_EQ(drawn([&](Canvas& c) {
              c.character(3, {10, 20, 54.5, 54.5}, 0.5);
            }),
            "q [] 0 d 0.5 G 1.4173 0 0 -1.4173 28.35 226.77 cm\n/C3 Do\nQ\n");
}

TEST(Canvas, WritesTextWhereItBegins) {
  const std::string seen = drawn([](Canvas& c) { c.text(10, 20, U"休日", 3.6, 0.25); });
  EXPECT_TRUE(std::regex_match(
      seen, std::regex("BT 0\\.25 g 0 Tr 1 0 0 1 28\\.35 226\\.77 Tm /F0 10\\.2 Tf <[0-9A-F]{8}> Tj ET\n")))
      << seen;
  EXPECT_THAT(drawn([](Canvas& c) { c.text(10, 20, U"休", 3.6, 0, true); }), HasSubstr("0 g 3 Tr 1 0 0 1"));
  EXPECT_THAT(drawn([](Canvas& c) { c.turned_text(10, 20, U"on", 3.6, 0.2); }),
              HasSubstr("BT 0.2 g 0 Tr 0 -1 1 0 28.35 226.77 Tm"));
  EXPECT_EQ(drawn([](Canvas& c) { c.text(10, 20, U"", 3.6); }), "");
  EXPECT_EQ(drawn([](Canvas& c) { c.turned_text(10, 20, U"", 3.6); }), "");
  // A letter as wide as its em stands in its box, its baseline 0.88 em below the top.
  EXPECT_THAT(starts(drawn([](Canvas& c) { c.vertical_letter(10, 20, U'休', 10); })),
              ElementsAre(Start("28.35", "201.83")));
}

TEST(Flow, GoesRightAndDownOrDownAndLeft) {
  const Flow level({10, 20, 100, 50}, false), upright({10, 20, 100, 50}, true);
  const auto values = [](const Rect& r) { return std::vector{r.x, r.y, r.width, r.height}; };
  EXPECT_THAT(values(level.rect(1, 2, 3, 4)), ElementsAre(11, 22, 3, 4));
  EXPECT_THAT(values(upright.rect(1, 2, 3, 4)), ElementsAre(104, 21, 4, 3));
  EXPECT_EQ(level.length(), 100);
  EXPECT_EQ(level.depth(), 50);
  EXPECT_EQ(upright.length(), 50);
  EXPECT_EQ(upright.depth(), 100);
}

TEST(Flow, WritesALineOfText) {
  const Flow level({10, 20, 100, 50}, false), upright({10, 20, 100, 50}, true);
  EXPECT_EQ(drawn([&](Canvas& c) { level.text(c, 5, 6, U"休日", 4, 0.2); }),
            drawn([](Canvas& c) { c.text(15, 26 + 0.85 * 4, U"休日", 4, 0.2); }));
  EXPECT_EQ(drawn([&](Canvas& c) { upright.text(c, 5, 6, U"on ‘’", 4, 0.2); }),
            drawn([](Canvas& c) { c.turned_text(100 + 0.15 * 4, 25, U"on ‘’", 4, 0.2); }));
  // Below one another, a space half as long.
  EXPECT_EQ(drawn([&](Canvas& c) { upright.text(c, 5, 6, U"休 日", 4, 0.2); }), drawn([](Canvas& c) {
              c.vertical_letter(100, 25, U'休', 4, 0.2);
              c.vertical_letter(100, 31, U'日', 4, 0.2);
            }));
}

TEST(Cells, HaveTheGuidesOfTheirName) {
  const Rect cell{10, 20, 30, 30};
  const auto with = [&](Guide guide, double dash_mm, bool diagonals) {
    return drawn([&](Canvas& c) {
      const Pen pen{0.72, 0.15, dash_mm};
      if (guide != Guide::none) {
        c.line(25, 20, 25, 50, pen);
        c.line(10, 35, 40, 35, pen);
      }
      if (diagonals) {
        c.line(10, 20, 40, 50, pen);
        c.line(40, 20, 10, 50, pen);
      }
      c.rectangle(cell, {0.45, 0.25, 0});
    });
  };
  const auto made = [&](Guide guide) { return drawn([&](Canvas& c) { draw_cell(c, cell, guide); }); };
  EXPECT_EQ(made(Guide::none), with(Guide::none, 0, false));
  EXPECT_EQ(made(Guide::cross), with(Guide::cross, 1, false));
  EXPECT_EQ(made(Guide::field), with(Guide::field, 0, false));
  EXPECT_EQ(made(Guide::diagonals), with(Guide::diagonals, 1, true));
  // Dashes are shorter in cells below 16 mm.
  EXPECT_THAT(drawn([](Canvas& c) {
                draw_cell(c, {0, 0, 8, 8}, Guide::cross);
              }),
              HasSubstr("[1.42 1.42] 0 d"));
}

kanji::Stroke stroke(std::string path, std::vector<geometry::GlyphPoint> line) {
  kanji::Stroke made;
  made.path = std::move(path);
  made.line.points = std::move(line);
  return made;
}

TEST(Strokes, ArePathsAsPublishedOrTheirLines) {
  kanji::Character character;
  character.strokes = {stroke("M10,20c1,2,3,4,5,6", {{10, 20}, {15, 26}}),
                       stroke("no path", {{10, 20}, {30, 40.5}, {50, 60}}),
                       stroke("M1,2c1,1,2,2,3,3C5,6,7,8,9,10", {{1, 2}, {9, 10}})};
  const std::string begin = "3.6 w 1 J 1 j\n";
  EXPECT_EQ(strokes_content(character, 0, 1), begin + "10 20 m 11 22 13 24 15 26 c S\n");
  EXPECT_EQ(strokes_content(character, 1, 2), begin + "10 20 m 30 40.5 l 50 60 l S\n");
  EXPECT_EQ(strokes_content(character, 2, 3), begin + "1 2 m 2 3 3 4 4 5 c 5 6 7 8 9 10 c S\n");
  EXPECT_EQ(strokes_content(character, 1, 3),
            begin + "10 20 m 30 40.5 l 50 60 l S\n" + "1 2 m 2 3 3 4 4 5 c 5 6 7 8 9 10 c S\n");
  EXPECT_EQ(strokes_content(character, 1, 1), begin);
}

TEST(Strokes, HaveTheirNumbersWhereTheSourcePutsThemInsideTheBox) {
  kanji::Character character;
  for (int i = 0; i < 11; ++i) character.strokes.push_back(stroke("", {{50, 60}}));
  character.strokes[0].line.number_position = {{40, 30}};
  character.strokes[1].line.number_position = {{-5, 2}};
  character.strokes[2].line.number_position = {{200, 200}};
  character.strokes[8].line.number_position = {{200, 200}};
  character.strokes[9].line.number_position = {{200, 200}};
  character.strokes[10].line.points.clear();  // nowhere: not numbered
  const auto at = starts(drawn([&](Canvas& c) { draw_numbers(c, character, {10, 0, 54.5, 54.5}); }));
  ASSERT_EQ(at.size(), 10U);
  const auto place = [](double x, double y) {  // half a millimetre is a unit
    return Start(number((10 + x / 2) * 72 / 25.4), number((100 - y / 2) * 72 / 25.4));
  };
  EXPECT_EQ(at[0], place(40, 30));
  EXPECT_EQ(at[1], place(0, 8));
  EXPECT_EQ(at[2], place(104, 108));
  EXPECT_EQ(at[3], place(42, 58)) << "beside the start where the source says nothing";
  EXPECT_EQ(at[8], place(104, 108));
  EXPECT_EQ(at[9], place(99, 108)) << "two digits need more room";
}

TEST(Strokes, HaveAnArrowNearTheirStart) {
  const auto arrow = [](std::vector<geometry::GlyphPoint> line) {
    kanji::Character character;
    character.strokes = {stroke("", std::move(line))};
    return drawn([&](Canvas& c) { draw_arrows(c, character, {0, 0, 109, 109}); });
  };
  // From 12 units on, 7 long and 14 / 2.6 wide; not beyond the end.
  constexpr double kHalf = 7 / 2.6;
  const auto triangle = [&](double back, double tip) {
    return drawn([&](Canvas& c) { c.triangle(tip, 50, back, 50 + kHalf, back, 50 - kHalf, 0.55); });
  };
  EXPECT_EQ(arrow({{10, 50}, {60, 50}}), triangle(22, 29));
  EXPECT_EQ(arrow({{10, 50}, {30, 50}}), triangle(18, 25)) << "two fifths of a short stroke";
  EXPECT_EQ(arrow({{10, 50}, {15, 50}}), triangle(12, 15));
  EXPECT_EQ(arrow({{10, 50}, {11.1, 50}}), triangle(10.44, 11.1));
  EXPECT_EQ(arrow({{10, 50}, {10.9, 50}}), "") << "a dot has none";
  const std::string down = arrow({{50, 10}, {50, 60}});
  EXPECT_EQ(down, drawn([&](Canvas& c) { c.triangle(50, 29, 50 - kHalf, 22, 50 + kHalf, 22, 0.55); }));
}

TEST(FactsOfACharacter, AreFourOfEachWithOkuriganaInBrackets) {
  kanji::Character character;
  character.entry.on_readings = {"キュウ"};
  character.entry.kun_readings = {"やす.む", "やす.まる", "や", "む", "五"};
  character.entry.meanings = {{"fr", "repos"},  {"en", "rest"},  {"en", "day off"}, {"es", "descanso"},
                              {"en", "retire"}, {"en", "sleep"}, {"en", "fifth"}};
  const Facts facts = facts_of(character);
  EXPECT_EQ(facts.on, U"キュウ");
  EXPECT_EQ(facts.kun, U"やす(む)、やす(まる)、や、む");
  EXPECT_EQ(facts.meanings, U"rest, day off, retire, sleep");
  EXPECT_EQ(facts_of({}).meanings, U"");
}

TEST(CutText, EndsWithDotsAndIsAsLongAsFits) {
  const std::u32string text = U"休日の朝に歩く";
  const double whole = fonts().width(text);
  EXPECT_EQ(cut(fonts(), text, whole), text);
  EXPECT_EQ(cut(fonts(), text, whole + 1), text);
  for (const double most : {whole - 0.01, 5.0, 3.5, 2.0}) {
    const std::u32string shorter = cut(fonts(), text, most);
    ASSERT_EQ(shorter.back(), U'…');
    const std::size_t kept = shorter.size() - 1;
    EXPECT_EQ(shorter.substr(0, kept), text.substr(0, kept));
    EXPECT_LE(fonts().width(shorter), most);
    EXPECT_GT(fonts().width(text.substr(0, kept + 1) + U"…"), most) << "one more would not fit";
  }
  EXPECT_EQ(cut(fonts(), text, 0.5), U"");
  EXPECT_EQ(wide("休a"), U"休a");
  EXPECT_EQ(wide("\xFF"), U"");
}

TEST(PdfText, IsUtf16InHexadecimal) {
  EXPECT_EQ(pdf_text(""), "<FEFF>");
  EXPECT_EQ(pdf_text("A休"), "<FEFF00414F11>");
  EXPECT_EQ(pdf_text("\U0000FFFD\U00010000𠮷"), "<FEFFFFFDD800DC00D842DFB7>");
  EXPECT_EQ(pdf_text("\xFF"), "<FEFF>");
}

TEST(PdfWriter, NamesThePlaceOfEachObject) {
  PdfWriter pdf;
  const int first = pdf.reserve(), second = pdf.reserve(), third = pdf.reserve();
  EXPECT_EQ(first, 1);
  pdf.write(second, "<< /Two 2 >>");
  pdf.write_stream(third, "/Three 3", "content content content content");
  pdf.write(first, "<< /One 1 >>");
  const std::string file = pdf.finish(first, second);
  EXPECT_EQ(file.substr(0, 9), "%PDF-1.5\n");
  const std::size_t table = file.find("xref\n0 4\n0000000000 65535 f \n");
  ASSERT_NE(table, std::string::npos);
  for (int number = 1; number <= 3; ++number) {
    const std::string entry = file.substr(table + 29 + 20 * static_cast<std::size_t>(number - 1), 20);
    EXPECT_EQ(entry.substr(10), " 00000 n \n");
    const std::string begin = std::to_string(number) + " 0 obj\n";
    EXPECT_EQ(file.substr(std::stoul(entry.substr(0, 10)), begin.size()), begin);
  }
  EXPECT_EQ(file.substr(table + 89), "trailer\n<< /Size 4 /Root 1 0 R /Info 2 0 R >>\nstartxref\n" +
                                         std::to_string(table) + "\n%%EOF\n");
  EXPECT_THAT(file, HasSubstr("2 0 obj\n<< /Two 2 >>\nendobj\n"));
  std::smatch length;
  ASSERT_TRUE(std::regex_search(file, length,
                                std::regex("<< /Three 3 /Filter /FlateDecode /Length (\\d+) >>\nstream\n")));
  const auto begin = static_cast<std::size_t>(length.position() + length.length());
  EXPECT_EQ(file.substr(begin + std::stoul(length[1]), 18), "\nendstream\nendobj\n");
}

}  // namespace
}  // namespace nazori::print
