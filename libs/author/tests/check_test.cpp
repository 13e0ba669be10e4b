// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/author/character_file.h"
#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;
using Kind = FindingKind;

std::vector<Kind> kinds_of(const std::vector<Finding>& findings) {
  std::vector<Kind> kinds;
  for (const Finding& finding : findings) kinds.push_back(finding.kind);
  return kinds;
}

std::vector<Kind> kinds(const OwnCharacter& character, const CheckSettings& settings = {}) {
  return kinds_of(check(character, settings));
}

/// The only finding.
Finding only(const OwnCharacter& character, const CheckSettings& settings = {}) {
  const auto findings = check(character, settings);
  EXPECT_EQ(findings.size(), 1U) << testing::PrintToString(kinds(character, settings).size());
  return findings.empty() ? Finding{} : findings.front();
}

TEST(Check, AWholeCharacterHasNoFindings) { EXPECT_EQ(kinds(cross()), std::vector<Kind>{}); }

TEST(Check, AnEmptyTabletHasNothingToWrite) {
  OwnCharacter character;
  character.facts.name = "a";
  character.facts.rights.licence = "CC0-1.0";
  EXPECT_EQ(only(character).kind, Kind::no_strokes);
  EXPECT_EQ(only(character).severity, Severity::error);
  character.hand = layer_with(8, {0, 0, 4, 4}, -0.5F);
  EXPECT_EQ(only(character).severity, Severity::note);
}

TEST(Check, NameAndLicenceAreMissed) {
  OwnCharacter character = cross();
  character.facts.name.clear();
  character.facts.rights = {};
  EXPECT_EQ(kinds(character), (std::vector{Kind::no_name, Kind::no_licence}));
}

TEST(Check, TheLicenceOfKanjiVgMustStay) {
  OwnCharacter character = cross();
  character.facts.rights = kanjivg_rights();
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  character.facts.rights.licence = "CC-BY-SA-4.0";
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  character.facts.rights.licence = "CC0-1.0";
  EXPECT_EQ(only(character).kind, Kind::licence_lost);
  EXPECT_EQ(only(character).severity, Severity::error);
  character.facts.rights = kanjivg_rights();
  character.facts.rights.author.clear();
  EXPECT_EQ(only(character).kind, Kind::licence_lost);
}

TEST(Check, PartsAndStrokesBelongTogether) {
  OwnCharacter character = cross();
  character.facts.parts = {{"x", {}}, {"y", {0}}};
  const auto findings = check(character);
  ASSERT_EQ(kinds_of(findings), (std::vector{Kind::part_empty, Kind::stroke_in_no_part}));
  EXPECT_EQ(findings[0].text, "x");
  EXPECT_EQ(findings[1].stroke, 1U);
  character.facts.parts.clear();
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, TheDictionarysCountIsCompared) {
  kanji::DictionaryEntry entry;
  entry.stroke_counts = {3, 4};
  EXPECT_EQ(only(cross(), {.dictionary = &entry}).kind, Kind::count_differs);
  EXPECT_EQ(only(cross(), {.dictionary = &entry}).amount, 3);
  entry.stroke_counts = {3, 2};
  EXPECT_EQ(kinds(cross(), {.dictionary = &entry}), std::vector<Kind>{});
  entry.stroke_counts.clear();
  EXPECT_EQ(kinds(cross(), {.dictionary = &entry}), std::vector<Kind>{});
}

TEST(Check, NumbersAreNearTheirStartsAndApart) {
  OwnCharacter character = cross();
  character.strokes[0].number_position = GlyphPoint{15, 36};
  EXPECT_EQ(only(character).kind, Kind::number_far);
  EXPECT_EQ(only(character).amount, 14);
  character.strokes[0].number_position = GlyphPoint{15, 38};
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  // Both numbers at the start of the second stroke, which both cover.
  character.strokes[0].points[0].at = {50, 12};
  character.strokes[0].number_position = GlyphPoint{54, 14};
  character.strokes[1].number_position = GlyphPoint{54, 15};
  const auto findings = check(character);
  EXPECT_EQ(kinds_of(findings),
            (std::vector{Kind::numbers_overlap, Kind::number_hides_start, Kind::number_hides_start}));
  EXPECT_EQ(findings[0].stroke, 0U);
  EXPECT_EQ(findings[0].second, 1U);
  EXPECT_EQ(findings[1].stroke, 0U);
  EXPECT_EQ(findings[1].second, 1U);
  EXPECT_EQ(findings[2].stroke, 1U);
}

TEST(Check, PointsAreInThePicture) {
  OwnCharacter character = cross();
  character.strokes[1].points[1].at = {55, 109};
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  character.strokes[1].points[1].at = {55, 109.5};
  EXPECT_EQ(only(character).kind, Kind::outside);
  EXPECT_EQ(only(character).stroke, 1U);
  EXPECT_EQ(only(character).point, 1U);
}

TEST(Check, AStrokeHasALength) {
  OwnCharacter character = cross();
  character.strokes[0] = even_stroke({{15, 50}, {15.9, 50}});
  EXPECT_EQ(only(character).kind, Kind::no_length);
  EXPECT_NEAR(only(character).amount, 0.9, 1e-9);
  character.strokes[0] = even_stroke({{15, 50}});
  EXPECT_EQ(only(character).kind, Kind::no_length);
  character.strokes[0] = even_stroke({{15, 50}, {16.1, 50}});
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, AStrokeThatLiesOnAnotherIsDoubled) {
  OwnCharacter character = cross();
  character.facts.parts.clear();
  character.strokes.push_back(even_stroke({{94.5, 50.5}, {15.5, 50.5}}));
  const Finding finding = only(character);
  EXPECT_EQ(finding.kind, Kind::doubled);
  EXPECT_EQ(finding.stroke, 0U);
  EXPECT_EQ(finding.second, 2U);
  // One that goes on or is shorter is not.
  character.strokes[2] = even_stroke({{15, 50}, {60, 50}});
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, TheEndingAgreesWithTheLastPart) {
  OwnCharacter character = cross();
  for (const StrokeEnding ending : {StrokeEnding::hook, StrokeEnding::taper}) {
    character.strokes[0].ending = ending;
    EXPECT_EQ(only(character).kind, Kind::ending_differs);
  }
  character.strokes[0].ending = StrokeEnding::either;
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  // 12 units are the last 15 % of 80: half of the width there.
  character.strokes[0].points = {{{15, 50}, 3, 1}, {{83, 50}, 3, 1}, {{95, 50}, 1.7, 1}};
  character.strokes[0].ending = StrokeEnding::taper;
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  character.strokes[0].ending = StrokeEnding::stop;
  EXPECT_EQ(only(character).kind, Kind::ending_differs);
  character.strokes[0].points[2].half_width = 1.9;
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, APointWhereTheLineTurnsBackIsASpike) {
  OwnCharacter character = cross();
  character.strokes[0] = even_stroke({{15, 50}, {90, 50}, {30, 60}});
  EXPECT_EQ(only(character).kind, Kind::point_off_line);
  EXPECT_EQ(only(character).point, 1U);
  EXPECT_NEAR(only(character).amount, 180 - 9.4623, 1e-3);
  character.strokes[0] = even_stroke({{15, 50}, {90, 50}, {65, 60}});
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, AGrooveIsDeepAndBroadEnoughToBeFelt) {
  OwnCharacter character = cross();
  for (GroovePoint& p : character.strokes[0].points) p.depth = 0.09;
  EXPECT_EQ(only(character).kind, Kind::too_shallow);
  EXPECT_NEAR(only(character).amount, 0.09, 0.005);
  for (GroovePoint& p : character.strokes[0].points) p.depth = 0.11;
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  // What the hand filled counts, too.
  for (GroovePoint& p : character.strokes[0].points) p.depth = 1;
  character.hand = layer_with(110, {30, 45, 40, 55}, 0.95F);
  EXPECT_EQ(only(character).kind, Kind::too_shallow);
  character.hand = {};
  for (GroovePoint& p : character.strokes[0].points) p.half_width = 0.54;
  EXPECT_EQ(only(character).kind, Kind::too_narrow);
  EXPECT_NEAR(only(character).amount, 1.08, 1e-9);
  EXPECT_EQ(kinds(character, {.tip = 1}), std::vector<Kind>{});
}

TEST(Check, AWallIsThickerThanTheTip) {
  OwnCharacter character = cross();
  character.facts.parts.clear();
  // Half as deep at 0.5412 half widths: the wall is 4 - 2 * 0.5412 * 3.
  character.strokes.push_back(even_stroke({{20, 54}, {90, 54}}));
  EXPECT_EQ(only(character).kind, Kind::thin_wall);
  EXPECT_EQ(only(character).stroke, 0U);
  EXPECT_EQ(only(character).second, 2U);
  EXPECT_NEAR(only(character).amount, 4 - 6 * 0.5412, 0.02);
  EXPECT_NEAR(only(character).at->y, 52, 0.1);
  EXPECT_GT(only(character).at->x, 19);
  EXPECT_EQ(kinds(character, {.tip = 0.7}), std::vector<Kind>{});
  for (GroovePoint& p : character.strokes[2].points) p.at.y = 54.5;
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, FindingsHaveNames) {
  EXPECT_EQ(name_of(Kind::no_strokes), "no_strokes");
  EXPECT_EQ(name_of(Kind::thin_wall), "thin_wall");
  EXPECT_EQ(name_of(Kind::svg_number_order), "svg_number_order");
  EXPECT_EQ(name_of(Severity::warning), "warning");
}

std::string with(std::string svg, const std::string& from, const std::string& to) {
  const auto at = svg.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? svg : svg.replace(at, from.size(), to);
}

TEST(CheckSvg, OurOwnFilesAreInOrder) {
  EXPECT_EQ(kinds_of(check_svg(to_strokes_svg(cross()))), std::vector<Kind>{});
}

TEST(CheckSvg, FindsWhatKanjiVgsToolsFind) {
  const std::string svg = to_strokes_svg(cross());
  const auto found = [&svg](const std::string& from, const std::string& to) {
    return kinds_of(check_svg(with(svg, from, to)));
  };
  using V = std::vector<Kind>;
  EXPECT_EQ(found("0 0 109 109", "0 0 108 109"), V{Kind::svg_view_box});
  EXPECT_EQ(found("width=\"109\"", "width=\"110\""), V{Kind::svg_size});
  EXPECT_EQ(found("height=\"109\"", "height=\"110\""), V{Kind::svg_size});
  EXPECT_EQ(found("StrokeNumbers_05341", "StrokeNumbers_05342"), V{Kind::svg_root_id});
  EXPECT_EQ(found("id=\"kvg:05341\"", "id=\"kvg:05342\""), V{Kind::svg_root_id});
  EXPECT_EQ(found("style=\"font-size:8;fill:#808080\"", ""), V{Kind::svg_style});
  EXPECT_EQ(found("kvg:05341-g1", "kvg:05341-g3"), V{Kind::svg_group_id});
  EXPECT_EQ(found("kvg:05341-s2", "kvg:05341-s3"), V{Kind::svg_stroke_id});
  EXPECT_EQ(found(">2</text>", ">3</text>"), V{Kind::svg_number_order});
  EXPECT_EQ(found("</text>\n</g>", "</text>\n<text>3</text></g>"), V{Kind::svg_number_count});
  EXPECT_EQ(check_svg("nonsense"), std::vector<Finding>{});
}

TEST(Check, EachFindingHasItsName) {
  const std::pair<Kind, std::string_view> names[] = {{Kind::no_strokes, "no_strokes"},
                                                     {Kind::no_name, "no_name"},
                                                     {Kind::number_far, "number_far"},
                                                     {Kind::numbers_overlap, "numbers_overlap"},
                                                     {Kind::number_hides_start, "number_hides_start"},
                                                     {Kind::part_empty, "part_empty"},
                                                     {Kind::stroke_in_no_part, "stroke_in_no_part"},
                                                     {Kind::outside, "outside"},
                                                     {Kind::no_length, "no_length"},
                                                     {Kind::doubled, "doubled"},
                                                     {Kind::ending_differs, "ending_differs"},
                                                     {Kind::point_off_line, "point_off_line"},
                                                     {Kind::too_shallow, "too_shallow"},
                                                     {Kind::too_narrow, "too_narrow"},
                                                     {Kind::thin_wall, "thin_wall"},
                                                     {Kind::count_differs, "count_differs"},
                                                     {Kind::licence_lost, "licence_lost"},
                                                     {Kind::no_licence, "no_licence"},
                                                     {Kind::svg_view_box, "svg_view_box"},
                                                     {Kind::svg_size, "svg_size"},
                                                     {Kind::svg_root_id, "svg_root_id"},
                                                     {Kind::svg_style, "svg_style"},
                                                     {Kind::svg_group_id, "svg_group_id"},
                                                     {Kind::svg_stroke_id, "svg_stroke_id"},
                                                     {Kind::svg_number_count, "svg_number_count"},
                                                     {Kind::svg_number_order, "svg_number_order"}};
  for (const auto& [kind, name] : names) EXPECT_EQ(name_of(kind), name);
  EXPECT_EQ(name_of(Severity::note), "note");
  EXPECT_EQ(name_of(Severity::error), "error");
}

TEST(Check, FindingsComeInTheOrderOfTheirKindsAndStrokes) {
  OwnCharacter character = cross();
  character.facts.parts.clear();
  character.facts.name.clear();
  character.strokes[0].ending = StrokeEnding::hook;
  character.strokes[1].ending = StrokeEnding::taper;
  character.strokes[1].points[0].at = {55, -1};
  const auto findings = check(character);
  EXPECT_EQ(kinds_of(findings),
            (std::vector{Kind::no_name, Kind::outside, Kind::ending_differs, Kind::ending_differs}));
  EXPECT_EQ(findings[2].stroke, 0U);
  EXPECT_EQ(findings[3].stroke, 1U);
}

TEST(Check, ANumberIsFarFromItsStartInEitherDirection) {
  OwnCharacter character = cross();
  // The first stroke starts at (15, 50); a digit is 4.6 wide and 6 high.
  for (const GlyphPoint near :
       {GlyphPoint{26.9, 53}, GlyphPoint{15, 67.9}, GlyphPoint{0, 52}, GlyphPoint{15, 38.1}}) {
    character.strokes[0].number_position = near;
    EXPECT_EQ(kinds(character), std::vector<Kind>{}) << near.x << ", " << near.y;
  }
  for (const GlyphPoint far :
       {GlyphPoint{27.1, 53}, GlyphPoint{15, 68.1}, GlyphPoint{15, 37.9}, GlyphPoint{24, 65}}) {
    character.strokes[0].number_position = far;
    EXPECT_EQ(only(character).kind, Kind::number_far) << far.x << ", " << far.y;
  }
  character.strokes[0].number_position = GlyphPoint{28, 70};
  EXPECT_NEAR(only(character).amount, std::hypot(13, 14), 1e-9);
  EXPECT_EQ(only(character).at, (GlyphPoint{28, 70}));
}

TEST(Check, NumbersThatTouchDoNotOverlap) {
  OwnCharacter character = cross();
  character.strokes[0].points[0].at = {45, 20};
  character.strokes[0].number_position = GlyphPoint{40, 18};
  character.strokes[1].number_position = GlyphPoint{44.7, 14};
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  character.strokes[1].number_position = GlyphPoint{44.5, 14};
  EXPECT_EQ(only(character).kind, Kind::numbers_overlap);
  character.strokes[1].number_position = GlyphPoint{44.5, 11.9};
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
  character.strokes[1].number_position = GlyphPoint{44.5, 12.1};
  EXPECT_EQ(only(character).kind, Kind::numbers_overlap);
}

TEST(Check, PointsAreOutsideOnEachSide) {
  for (const GlyphPoint wrong :
       {GlyphPoint{-0.1, 50}, GlyphPoint{109.1, 50}, GlyphPoint{15, -0.1}, GlyphPoint{15, 109.1}}) {
    OwnCharacter character = cross();
    character.strokes[0].points[0].at = wrong;
    const auto found = kinds(character);
    EXPECT_TRUE(std::ranges::find(found, Kind::outside) != found.end()) << wrong.x << ", " << wrong.y;
  }
  OwnCharacter character = cross();
  character.strokes[0].points[0].at = {0, 50};
  EXPECT_EQ(kinds(character), std::vector<Kind>{});
}

TEST(Check, DoubledLinesAreAtMostAUnitApart) {
  const auto beside = [](double apart) {
    OwnCharacter character = cross();
    character.facts.parts.clear();
    character.strokes.push_back(even_stroke({{15, 50 + apart}, {95, 50 + apart}}));
    return kinds(character);
  };
  EXPECT_EQ(beside(0.99), std::vector<Kind>{Kind::doubled});
  // Lines less than two units apart are one groove.
  EXPECT_EQ(beside(1.01), std::vector<Kind>{});
  EXPECT_EQ(beside(1.9), std::vector<Kind>{});
  EXPECT_EQ(beside(2.01), std::vector<Kind>{Kind::thin_wall});
}

TEST(Check, ALineTurnsBackByMoreThanAHundredAndSixtyDegrees) {
  const auto turned = [](double degrees) {
    OwnCharacter character = cross();
    const double a = degrees * 3.14159265358979323846 / 180;
    character.strokes[0] = even_stroke({{15, 50}, {60, 50}, {60 + 30 * std::cos(a), 50 + 30 * std::sin(a)}});
    return kinds(character);
  };
  EXPECT_EQ(turned(159), std::vector<Kind>{});
  EXPECT_EQ(turned(161), std::vector<Kind>{Kind::point_off_line});
}

TEST(Check, TheBodyIsBetweenATenthAndThreeQuartersOfTheLine) {
  // Hardly carved between two places; what is carved deep reaches three units into it.
  const auto shallow = [](double from, double to) {
    OwnCharacter character = cross();
    auto& points = character.strokes[0].points;
    points = {{{15, 30}, 3, 1},    {{from - 0.1, 30}, 3, 1}, {{from, 30}, 3, 0.05},
              {{to, 30}, 3, 0.05}, {{to + 0.1, 30}, 3, 1},   {{95, 30}, 3, 1}};
    return kinds(character);
  };
  EXPECT_EQ(shallow(15.3, 20), std::vector<Kind>{}) << "the first tenth is to 23";
  EXPECT_EQ(shallow(15.3, 26.5), std::vector<Kind>{Kind::too_shallow});
  EXPECT_EQ(shallow(78, 94), std::vector<Kind>{}) << "the last quarter is from 75";
  EXPECT_EQ(shallow(71.5, 94), std::vector<Kind>{Kind::too_shallow});
}

TEST(Check, AWallIsBetweenLinesThatRunSideBySide) {
  const auto with = [](const std::vector<GlyphPoint>& line) {
    OwnCharacter character = cross();
    character.facts.parts.clear();
    character.strokes.push_back(even_stroke(line));
    return kinds(character);
  };
  // 19.9 degrees have a cosine of 0.94.
  const auto slanted = [](double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180;
    return std::vector<GlyphPoint>{{30, 54}, {30 + 22 * std::cos(a), 54 + 22 * std::sin(a)}};
  };
  EXPECT_EQ(with(slanted(19)), std::vector<Kind>{Kind::thin_wall});
  EXPECT_EQ(with(slanted(21)), std::vector<Kind>{});
  EXPECT_EQ(with({{20, 54}, {45, 54}}), std::vector<Kind>{Kind::thin_wall});
  // In the other direction, too.
  EXPECT_EQ(with({{45, 54}, {20, 54}}), std::vector<Kind>{Kind::thin_wall});
  // What goes on ahead is not beside it.
  EXPECT_EQ(with({{98.5, 50.9}, {105, 50.9}}), std::vector<Kind>{});
}

}  // namespace
}  // namespace nazori::author
