// SPDX-License-Identifier: Apache-2.0
// Bounds of what is read from KanjiVG, and how strokes end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "alternative_orders.h"
#include "nazori/base/utf8.h"
#include "nazori/ingest/kanjivg.h"
#include "stroke_endings.h"
#include "tables.h"

namespace nazori::ingest {
namespace {

using testing::ElementsAre;

std::string svg(const std::string& inside, const std::string& numbers = "") {
  return R"(<svg><g id="kvg:StrokePaths_1"><g kvg:element="a">)" + inside + "</g></g>" +
         R"(<g id="kvg:StrokeNumbers_1">)" + numbers + "</g></svg>";
}
std::string trouble(const std::string& inside) {
  const auto form = parse_kanjivg_svg({U'a', {}}, svg(inside));
  return form ? "" : form.error().what;
}
std::string path(const std::string& data) { return "<path d=\"" + data + "\"/>"; }
std::string times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(FormName, IsFiveFiguresAndASuffixOfLettersAndFigures) {
  EXPECT_TRUE(parse_form_name("0d7ff.svg"));
  EXPECT_FALSE(parse_form_name("0dfff.svg"));
  EXPECT_TRUE(parse_form_name("0e000.svg"));
  EXPECT_EQ(parse_form_name("00001.svg"), (FormName{U'\x01', ""}));
  EXPECT_EQ(parse_form_name("fffff.svg"), (FormName{U'\U000FFFFF', ""}));
  EXPECT_EQ(parse_form_name("04F11-azAZ09.svg"), (FormName{U'休', "azAZ09"}));
  EXPECT_EQ(parse_form_name("04f11-K.svg"), (FormName{U'休', "K"}));
  for (const char c : std::string("/:@[`{-_"))
    EXPECT_FALSE(parse_form_name(std::string("04f11-a") + c + "b.svg")) << c;
  EXPECT_FALSE(parse_form_name("04f11K.svg"));
  EXPECT_FALSE(parse_form_name("04f1.svg"));
  EXPECT_FALSE(parse_form_name("+4f11.svg"));
}

TEST(KanjiVgFile, HasAtMostTwoHundredStrokesAndFiftyGroupsInOneAnother) {
  EXPECT_EQ(trouble(times(200, path("M1,2L3,4"))), "");
  EXPECT_EQ(trouble(times(201, path("M1,2L3,4"))), "more than 200 strokes");
  EXPECT_EQ(trouble(times(50, "<g>") + path("M1,2L3,4") + times(50, "</g>")), "");
  EXPECT_EQ(trouble(times(51, "<g>") + path("M1,2L3,4") + times(51, "</g>")), "groups are nested too deep");
}

TEST(KanjiVgFile, StrokesStayWithinASideOfTheBox) {
  EXPECT_EQ(trouble(path("M-109,-109L218,218")), "");
  EXPECT_EQ(trouble(path("M1,2C-109,5,218,5,3,4")), "");
  for (const char* data : {"M-109.1,0L3,4", "M0,-109.1L3,4", "M218.1,0L3,4", "M0,218.1L3,4", "M1,2L218.1,4",
                           "M1,2L3,-109.1", "M1,2C-110,5,6,5,3,4", "M1,2C5,5,6,219,3,4"})
    EXPECT_EQ(trouble(path("M1,2L3,4") + path(data)), "stroke 2 leaves the box") << data;
  EXPECT_THAT(trouble(path("M1,2L3,4") + path("no path")), testing::StartsWith("stroke 2: "));
}

TEST(KanjiVgFile, GroupsHaveAllTheirAttributes) {
  const auto form = parse_kanjivg_svg(
      {U'a', "V"},
      svg(R"(<g kvg:element="e" kvg:original="o" kvg:position="left" kvg:radical="general" kvg:phon="p")"
          R"( kvg:part="3" kvg:number="4" kvg:variant="true">)" +
          path("M1,2L3,4") +
          R"(</g><g kvg:partial="true" kvg:part="x"/><g kvg:tradForm="true"/><g kvg:radicalForm="true" kvg:variant="false"/>)"));
  ASSERT_TRUE(form);
  EXPECT_EQ(form->code_point, U'a');
  EXPECT_EQ(form->variant, "V");
  kanji::Component first;
  first.element = "e";
  first.original = "o";
  first.position = "left";
  first.radical = "general";
  first.phon = "p";
  first.part = 3;
  first.number = 4;
  first.variant = true;
  first.strokes = {0};
  kanji::Component partial, trad, radical;
  partial.partial = trad.trad_form = radical.radical_form = true;
  partial.first_stroke = trad.first_stroke = radical.first_stroke = 1;
  EXPECT_THAT(form->components.children, ElementsAre(first, partial, trad, radical));
  EXPECT_THAT(form->components.strokes, ElementsAre(0));
}

TEST(KanjiVgFile, NumbersStandWhereTheirMatrixMovesThem) {
  const auto place = [](const std::string& transform, const std::string& number = "1") {
    const auto form =
        parse_kanjivg_svg({U'a', {}}, svg(path("M1,2L3,4") + path("M1,2L3,4"),
                                          "<text transform=\"" + transform + "\">" + number + "</text>"));
    return form->strokes[number == "2" ? 1 : 0].line.number_position;
  };
  EXPECT_EQ(place("matrix(1 0 0 1 25.5 15.25)"), (geometry::GlyphPoint{25.5, 15.25}));
  EXPECT_EQ(place("matrix(1,0,0,1, 25.5,-3)", "2"), (geometry::GlyphPoint{25.5, -3}));
  for (const char* none : {"matrix(1 0 0 1 25.5)", "matrix(1 0 0 1 25.5 15 3)", "matrix(1 0 0 1 x 15)",
                           "matrix(1 0 0 1 2 3", "", "translate(1 0 0 1 2 3)", "matrix(1 0 0 1 inf 3)"})
    EXPECT_EQ(place(none), std::nullopt) << none;
  EXPECT_EQ(place("matrix(1 0 0 1 2 3)", "0"), std::nullopt);
  EXPECT_EQ(place("matrix(1 0 0 1 2 3)", "3"), std::nullopt);
}

/// A post of 80 and a last part of this length, turned by so many degrees.
geometry::Polyline<geometry::GlyphFrame> turned(double length, double degrees, double post = 80) {
  const double angle = (90 - degrees) * std::numbers::pi / 180;
  return {{50, 10}, {50, 10 + post}, {50 + length * std::cos(angle), 10 + post + length * std::sin(angle)}};
}

TEST(Hooks, TurnByMoreThanSixtyDegreesInTheLastTwentyUnitsOrTheSecondHalf) {
  for (const double side : {1, -1}) {
    EXPECT_FALSE(ends_in_a_hook(turned(10, side * 59)));
    EXPECT_TRUE(ends_in_a_hook(turned(10, side * 61)));
    EXPECT_TRUE(ends_in_a_hook(turned(10, side * 150)));
  }
  EXPECT_TRUE(ends_in_a_hook(turned(18.9, 90)));
  EXPECT_FALSE(ends_in_a_hook(turned(21, 90)));
  EXPECT_TRUE(ends_in_a_hook(turned(13.5, 90, 16.5))) << "the second half of 30 begins at 15";
  EXPECT_FALSE(ends_in_a_hook(turned(16, 90, 14)));
  EXPECT_TRUE(ends_in_a_hook(turned(2, 90)));
  EXPECT_FALSE(ends_in_a_hook({{50, 10}, {50, 90}}));
}

/// A line to the left that ends at the origin: parts by their lengths from the end on, each with its
/// direction in degrees.
geometry::Polyline<geometry::GlyphFrame> ending_with(const std::vector<std::pair<double, double>>& parts) {
  geometry::Polyline<geometry::GlyphFrame> line{{0, 0}};
  for (const auto& [length, degrees] : parts) {
    const double angle = degrees * std::numbers::pi / 180;
    line.push_back(line.back() + geometry::GlyphPoint{length * std::cos(angle), length * std::sin(angle)});
  }
  return {line.rbegin(), line.rend()};
}

TEST(Hooks, HaveATipOfOneAndAHalfUnits) {
  // The direction of the tip is that over 1.5 units.
  EXPECT_TRUE(ends_in_a_hook(ending_with({{1.6, 65}, {60, 0}})));
  EXPECT_TRUE(ends_in_a_hook(ending_with({{1.5, 62}, {60, 0}})));
  EXPECT_FALSE(ends_in_a_hook(ending_with({{1.2, 65}, {60, 0}})));
  // In a short line over a quarter of it; one of three units or less has none.
  EXPECT_TRUE(ends_in_a_hook(ending_with({{1, 65}, {3, 0}})));
  EXPECT_FALSE(ends_in_a_hook(ending_with({{0.7, 90}, {2.2, 0}})));
}

TEST(Hooks, AreLookedForInEachHalfUnit) {
  // A single unit of another direction counts where it begins on a half unit.
  for (const double at : {2.0, 2.5, 3.0, 3.5, 4.0, 6.5, 11.0, 18.5})
    EXPECT_TRUE(ends_in_a_hook(ending_with({{at, 0}, {1, 70}, {60, 0}}))) << at;
  EXPECT_FALSE(ends_in_a_hook(ending_with({{19.5, 0}, {0.4, 70}, {60, 0}})));
  EXPECT_FALSE(ends_in_a_hook(ending_with({{20.5, 0}, {1, 70}, {60, 0}})));
}

kanji::Stroke from_to(double x, double y, double to_x, double to_y) {
  kanji::Stroke s;
  s.line.points = {{x, y}, {to_x, to_y}};
  return s;
}

TEST(AlternativeOrders, AStrokeWithAnEndMoreThanTwentyUnitsAwayIsAnother) {
  const DrawnForm main{U'a', "", {from_to(0, 0, 50, 0), from_to(0, 80, 50, 80)}, {}};
  const auto with = [&](double off, bool end) {
    DrawnForm variant = main;
    std::swap(variant.strokes[0], variant.strokes[1]);
    auto& p = end ? variant.strokes[1].line.points.back() : variant.strokes[1].line.points.front();
    p.y += off;
    return order_of_variant(main, variant);
  };
  EXPECT_THAT(with(20, true), testing::Optional(ElementsAre(2, 1)));
  EXPECT_THAT(with(20, false), testing::Optional(ElementsAre(2, 1)));
  EXPECT_EQ(with(20.1, true), std::nullopt);
  EXPECT_EQ(with(20.1, false), std::nullopt);
  EXPECT_EQ(order_of_variant({}, {}), std::nullopt);
  EXPECT_EQ(order_of_variant(main, {U'a', "", {main.strokes[0]}, {}}), std::nullopt);
}

TEST(AlternativeOrders, ListedOnesHaveTheirFiguresAndSource) {
  const auto listed = listed_orders();
  for (const auto& [c, orders] : listed)
    for (const auto& order : orders) {
      EXPECT_FALSE(order.source.empty());
      EXPECT_GE(order.order.size(), 2U);
      for (const int number : order.order) EXPECT_GE(number, 1);
    }
  EXPECT_THAT(listed.at(U'正'),
              testing::Contains(kanji::AlternativeOrder{{1, 3, 2, 4, 5}, "KanjiVG variant HzFst"}));
}

/// The endings of a character of so many strokes that nothing else is known of.
std::string endings_of(char32_t c, std::size_t strokes) {
  DrawnForm form{c, "", std::vector<kanji::Stroke>(strokes, from_to(30, 30, 20, 45)), {}};
  for (auto& s : form.strokes) s.type = "㇒";
  StrokeEndings().assign(form);
  std::string out;
  for (const auto& s : form.strokes) out += "shte"[static_cast<int>(s.line.ending)];
  return out;
}

TEST(StrokeEndings, OfKanaWithMarksAndSmallOnesAreThoseOfTheirPlainForm) {
  struct Derived {
    std::u32string kana, plain;
    std::size_t marks;
  };
  const Derived all[] = {
      {U"がぎぐげござじずぜぞだぢづでどばびぶべぼゔ", U"かきくけこさしすせそたちつてとはひふへほう", 2},
      {U"ガギグゲゴザジズゼゾダヂヅデドバビブベボヴヷヸヹヺ",
       U"カキクケコサシスセソタチツテトハヒフヘホウワヰヱヲ", 2},
      {U"ぱぴぷぺぽパピプペポ", U"はひふへほハヒフヘホ", 1},
      {U"ぁぃぅぇぉっゃゅょゎゕゖァィゥェォッャュョヮヵヶ",
       U"あいうえおつやゆよわかけアイウエオツヤユヨワカケ", 0}};
  std::map<char32_t, std::string> table;
  for (const auto& row : table_rows(kana_endings_table())) table[base::decode_utf8(row[0])->front()] = row[1];
  for (const auto& [kana, plain, marks] : all) {
    ASSERT_EQ(kana.size(), plain.size());
    for (std::size_t i = 0; i < kana.size(); ++i) {
      const std::string name = base::encode_utf8(kana[i]);
      ASSERT_TRUE(table.contains(plain[i])) << name;
      const std::string& endings = table.at(plain[i]);
      EXPECT_EQ(endings_of(plain[i], endings.size()), endings) << name;
      EXPECT_EQ(endings_of(kana[i], endings.size() + marks), endings + std::string(marks, 's')) << name;
    }
  }
  EXPECT_EQ(endings_of(U'か', 1), "t") << "of another number of strokes: by their types";
  EXPECT_EQ(endings_of(U'休', 2), "tt");
}

TEST(Tables, AreCutAtTabsAndLinesWithoutRemarks) {
  EXPECT_THAT(split("a b  c", ' '), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split("", ' '), ElementsAre(""));
  EXPECT_THAT(split("a ", ' '), ElementsAre("a", ""));
  const auto rows = table_rows("# remark\na\tb\n\n\tc\n#x\ty\nd#");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0], ElementsAre("a", "b"));
  EXPECT_THAT(rows[1], ElementsAre("", "c"));
  EXPECT_THAT(rows[2], ElementsAre("d#"));
}

}  // namespace
}  // namespace nazori::ingest
