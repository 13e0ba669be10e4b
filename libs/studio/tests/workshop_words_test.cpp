// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/workshop_words.h"

#include <gtest/gtest.h>

#include "in_english.h"
#include "nazori/studio/workshop/part_words.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using author::EditKind;
using author::EditWay;
using author::FindingKind;

QString said(const char* text) { return QString::fromUtf8(text); }

class WordsOfTheWorkshop : public testing::Test {
 protected:
  WordsOfTheWorkshop() { test::speak_english(); }
};

TEST_F(WordsOfTheWorkshop, EachEditIsSaidAsDoneUndoneAndRedone) {
  const std::pair<EditKind, const char*> all[] = {{EditKind::draw_stroke, "stroke drawn"},
                                                  {EditKind::add_strokes, "strokes added"},
                                                  {EditKind::delete_stroke, "stroke deleted"},
                                                  {EditKind::insert_point, "point added"},
                                                  {EditKind::move_point, "point moved"},
                                                  {EditKind::delete_point, "point deleted"},
                                                  {EditKind::move_stroke, "stroke moved"},
                                                  {EditKind::split_stroke, "stroke split"},
                                                  {EditKind::join_strokes, "strokes joined"},
                                                  {EditKind::reverse_stroke, "stroke reversed"},
                                                  {EditKind::reorder_strokes, "order changed"},
                                                  {EditKind::set_ending, "ending changed"},
                                                  {EditKind::set_width, "width changed"},
                                                  {EditKind::set_depth, "depth changed"},
                                                  {EditKind::move_number, "number moved"},
                                                  {EditKind::set_facts, "details changed"},
                                                  {EditKind::groove, "groove cut"},
                                                  {EditKind::raise, "relief raised"},
                                                  {EditKind::smooth, "relief smoothed"},
                                                  {EditKind::erase, "relief erased"},
                                                  {EditKind::stamp, "stamp pressed"},
                                                  {EditKind::load_relief, "height map loaded"},
                                                  {EditKind::clear_relief, "relief cleared"}};
  for (const auto& [kind, done] : all) {
    const QString what = said(done);
    EXPECT_EQ(edit_words(kind, EditWay::made), what.left(1).toUpper() + what.mid(1) + said("."));
    EXPECT_EQ(edit_words(kind, EditWay::undone), said("Undone: %1.").arg(what));
    EXPECT_EQ(edit_words(kind, EditWay::redone), said("Redone: %1.").arg(what));
  }
  EXPECT_EQ(edit_words(EditKind::none, EditWay::made), QString());
  EXPECT_EQ(edit_words(EditKind::none, EditWay::undone), said("There is nothing to undo."));
  EXPECT_EQ(edit_words(EditKind::none, EditWay::redone), said("There is nothing to redo."));
}

TEST_F(WordsOfTheWorkshop, ToolsStampsAndEndingsHaveNames) {
  using author::StampShape;
  using author::Tool;
  using kanji::StrokeEnding;
  for (const auto& [tool, name] :
       {std::pair(Tool::draw, "Draw strokes"), std::pair(Tool::place, "Place points"),
        std::pair(Tool::edit, "Edit strokes"), std::pair(Tool::groove, "Groove"),
        std::pair(Tool::raise, "Raise"), std::pair(Tool::smooth, "Smooth"), std::pair(Tool::erase, "Erase"),
        std::pair(Tool::stamp, "Stamp")})
    EXPECT_EQ(tool_name(tool), said(name));
  for (const auto& [stamp, name] :
       {std::pair(StampShape::dot, "Dot"), std::pair(StampShape::ring, "Ring"),
        std::pair(StampShape::bar, "Bar"), std::pair(StampShape::cross, "Cross"),
        std::pair(StampShape::square, "Square"), std::pair(StampShape::triangle, "Triangle")})
    EXPECT_EQ(stamp_name(stamp), said(name));
  for (const auto& [ending, name] :
       {std::pair(StrokeEnding::stop, "stop"), std::pair(StrokeEnding::hook, "hook"),
        std::pair(StrokeEnding::taper, "sweep"), std::pair(StrokeEnding::either, "any ending")})
    EXPECT_EQ(ending_name(ending), said(name));
}

author::OwnCharacter two_strokes() {
  author::OwnCharacter character;
  character.strokes.resize(2);
  character.strokes[0].points = {{{10, 20}, 3, 1}, {{90, 20}, 3, 1}};
  character.strokes[1].points = {{{11.26, 50.04}, 2, 1}, {{50, 60}, 2.6, 1}, {{95.5, 70}, 1, 1}};
  character.strokes[1].ending = kanji::StrokeEnding::hook;
  return character;
}

TEST_F(WordsOfTheWorkshop, WhatIsChosenIsSaidWithItsPlaceInTenths) {
  auto character = two_strokes();
  EXPECT_EQ(selection_words(character, {}), QString());
  EXPECT_EQ(selection_words(character, {1, {}, false}), said("Stroke 2 of 2, hook, 3 points."));
  EXPECT_EQ(selection_words(character, {1, 0, false}),
            said("Stroke 2 of 2, hook, 3 points. Start: 11.3 from the left, 50.0 from the top, 4.0 wide."));
  EXPECT_EQ(selection_words(character, {1, 1, false}),
            said("Stroke 2 of 2, hook, 3 points. Point 2: 50.0 from the left, 60.0 from the top, 5.2 wide."));
  EXPECT_EQ(selection_words(character, {1, 2, false}),
            said("Stroke 2 of 2, hook, 3 points. End: 95.5 from the left, 70.0 from the top, 2.0 wide."));
  EXPECT_EQ(selection_words(character, {0, 1, false}),
            said("Stroke 1 of 2, stop, 2 points. End: 90.0 from the left, 20.0 from the top, 6.0 wide."));
  character.strokes[1].number_position = geometry::GlyphPoint{30.04, 40.06};
  EXPECT_EQ(
      selection_words(character, {1, {}, true}),
      said("Stroke 2 of 2, hook, 3 points. Its number: 30.0 from the left, 40.1 from the top, placed by "
           "hand."));
  EXPECT_TRUE(selection_words(character, {0, {}, true}).endsWith(said(", placed by the program.")));
}

TEST_F(WordsOfTheWorkshop, ACharacterIsSaidWithItsNameItsStrokesAndWhatIsSpecial) {
  author::OwnCharacter character;
  EXPECT_EQ(character_words(character), said("No name yet: no strokes."));
  character = two_strokes();
  character.facts.name = "our sign";
  EXPECT_EQ(character_words(character), said("our sign: 2 strokes."));
  character.hand = {2, {0, 0, 0, 0.5F}};
  EXPECT_EQ(character_words(character), said("our sign: 2 strokes. The relief was changed by hand."));
  character.facts.instead_of = U'休';
  EXPECT_EQ(character_words(character),
            said("our sign: 2 strokes. The relief was changed by hand. Used instead of the published 休."));
  EXPECT_EQ(stroke_words(2, character.strokes[1]), said("2  hook"));
}

TEST_F(WordsOfTheWorkshop, EachFindingOfACheckHasItsSentence) {
  const std::pair<FindingKind, const char*> all[] = {
      {FindingKind::no_strokes, "There are no strokes."},
      {FindingKind::no_name, "The character has no name."},
      {FindingKind::number_far, "Stroke 3: its number is far from its start."},
      {FindingKind::numbers_overlap, "The numbers of strokes 3 and 6 cover each other."},
      {FindingKind::number_hides_start, "The number of stroke 3 covers the start of stroke 6."},
      {FindingKind::part_empty, "The part 亻 has no strokes."},
      {FindingKind::stroke_in_no_part, "Stroke 3 belongs to no part."},
      {FindingKind::outside, "Stroke 3 leaves the tablet."},
      {FindingKind::no_length, "Stroke 3 has no length."},
      {FindingKind::doubled, "Strokes 3 and 6 lie on each other."},
      {FindingKind::ending_differs, "Stroke 3: its ending does not look as it is said to be."},
      {FindingKind::point_off_line, "Stroke 3: the line turns back sharply at a point."},
      {FindingKind::too_shallow, "Stroke 3 is too shallow to feel."},
      {FindingKind::too_narrow, "Stroke 3 is narrower than the tip of a stylus."},
      {FindingKind::thin_wall, "The wall between strokes 3 and 6 is too thin to feel (7.4 of 109)."},
      {FindingKind::count_differs, "The dictionary counts 7 strokes."},
      {FindingKind::licence_lost,
       "A copy of a character of KanjiVG must name KanjiVG's licence and authors."},
      {FindingKind::svg_view_box, "The SVG is not as KanjiVG's tools expect it."},
      {FindingKind::svg_number_order, "The SVG is not as KanjiVG's tools expect it."},
      {FindingKind::no_licence, "No licence is named. Others will not know what they may do with it."}};
  author::Finding finding;
  finding.stroke = 2;
  finding.second = 5;
  finding.amount = 7.36;
  finding.text = "亻";
  for (const auto& [kind, sentence] : all) {
    finding.kind = kind;
    EXPECT_EQ(finding_words(finding), said(sentence));
  }
  EXPECT_EQ(finding_words({.kind = FindingKind::outside}), said("Stroke 1 leaves the tablet."));
}

TEST_F(WordsOfTheWorkshop, APartIsItsNameWithItsStrokes) {
  EXPECT_EQ(part_words({"亻", {0, 1}}), said("亻: strokes 1, 2"));
  EXPECT_EQ(part_words({"木", {2, 3, 4, 6}}), said("木: strokes 3-5, 7"));
  EXPECT_EQ(part_words({"亻", {}}), said("亻: no strokes"));
  EXPECT_EQ(part_words({"", {0, 1}}), said("No name yet: strokes 1, 2"));
}

TEST_F(WordsOfTheWorkshop, StrokesAreReadAsTheyAreTypedInEitherLanguage) {
  using Numbers = std::vector<int>;
  for (const char* typed :
       {"1-3, 7", "1 - 3 7", "１、２、３、７", "１〜３、７", "1~3,7", "1–3,7", " 7 3 2 1 "})
    EXPECT_EQ(read_strokes(said(typed), 7).value_or(Numbers{-1}), (Numbers{0, 1, 2, 6})) << typed;
  EXPECT_EQ(read_strokes(QString(), 7).value_or(Numbers{-1}), Numbers{});
  for (const char* wrong : {"8", "0", "a", "3-1"}) EXPECT_FALSE(read_strokes(said(wrong), 7)) << wrong;
}

/// The radicals of the dictionary: 1 is 一, 9 is 人, 85 is 水 and 214, the last, is 龠.
TEST_F(WordsOfTheWorkshop, ARadicalIsItsNumberWithItsForm) {
  EXPECT_EQ(radical_form(1), said("一"));
  EXPECT_EQ(radical_form(9), said("人"));
  EXPECT_EQ(radical_form(85), said("水"));
  EXPECT_EQ(radical_form(214), said("龠"));
  EXPECT_EQ(radical_words(9), said("9 人"));
  EXPECT_EQ(radical_words({}), QString());
}

TEST_F(WordsOfTheWorkshop, ARadicalIsReadByNumberOrFormAndWhatIsNoneIsRefused) {
  const RadicalOfForm knows = [](const QString& form) -> std::optional<int> {
    if (form == QStringLiteral("亻")) return 9;
    if (form == QStringLiteral("氵")) return 85;
    return {};
  };
  const auto read = [&](const char* typed) -> int {
    std::optional<int> radical = 7;
    if (!read_radical(said(typed), radical, knows)) {
      EXPECT_EQ(radical, 7) << "untouched";
      return -1;
    }
    return radical.value_or(0);
  };
  EXPECT_EQ(read(""), 0);
  EXPECT_EQ(read("  "), 0);
  for (const char* typed : {"9", "９", " 9 人", "9人", "人", "亻", "9 亻"})
    EXPECT_EQ(read(typed), 9) << typed;
  EXPECT_EQ(read("1"), 1);
  EXPECT_EQ(read("214"), 214);
  EXPECT_EQ(read("龠"), 214);
  for (const char* typed : {"0", "215", "1000", "9 水", "85 人", "漢", "9 漢", "人 9", "-1"})
    EXPECT_EQ(read(typed), -1) << typed;
  std::optional<int> radical;
  EXPECT_FALSE(read_radical(said("亻"), radical)) << "nobody knows other forms";
  EXPECT_TRUE(read_radical(said("人"), radical));
  EXPECT_EQ(radical, 9);
}

}  // namespace
}  // namespace nazori::ui
