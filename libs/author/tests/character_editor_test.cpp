// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_editor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;
using Pen = geometry::WrittenStroke<geometry::GlyphFrame>;

constexpr int kSide = 128;

CharacterEditor editor_of(OwnCharacter character, int size = kSide) {
  auto editor = CharacterEditor::create(std::move(character), size);
  EXPECT_TRUE(editor) << base::to_line(editor.error());
  return *std::move(editor);
}

/// 十 with a third stroke and all three in parts.
OwnCharacter three_strokes() {
  OwnCharacter character = cross();
  character.strokes.push_back(even_stroke({{20, 80}, {50, 90}, {90, 80}}, 2));
  character.facts.parts = {{"a", {0, 2}}, {"b", {1}}, {"c", {1, 2}}};
  return character;
}

const Pen kPen{{.at = {20, 20}, .pressure = 1.0}, {.at = {80, 30}, .pressure = 0.5}};

/// All kinds of edits, one after another.
std::vector<std::pair<EditKind, std::function<CharacterEditor::Touched(CharacterEditor&)>>> all_edits() {
  using E = CharacterEditor;
  using K = EditKind;
  return {
      {K::draw_stroke, [](E& e) { return e.draw_stroke(kPen); }},
      {K::add_strokes,
       [](E& e) {
         return e.add_strokes({even_stroke({{5, 5}, {9, 90}, {40, 95}}), even_stroke({{7, 7}})});
       }},
      {K::insert_point,
       [](E& e) {
         return e.insert_point(1, {60, 40});
       }},
      {K::move_point,
       [](E& e) {
         return e.move_point(1, 1, {62, 44});
       }},
      {K::move_stroke,
       [](E& e) {
         return e.move_stroke(0, {3, -4});
       }},
      {K::split_stroke, [](E& e) { return e.split_stroke(1, 1); }},
      {K::reorder_strokes, [](E& e) { return e.reorder(0, 3); }},
      {K::reorder_strokes, [](E& e) { return e.reorder(2, 0); }},
      {K::join_strokes, [](E& e) { return e.join_strokes(2, 0); }},
      {K::reverse_stroke, [](E& e) { return e.reverse_stroke(1); }},
      {K::delete_point, [](E& e) { return e.delete_point(1, 1); }},
      {K::set_ending, [](E& e) { return e.set_ending(0, StrokeEnding::either); }},
      {K::set_width, [](E& e) { return e.set_half_width(0, 1, 5); }},
      {K::set_depth, [](E& e) { return e.set_depth(0, 1, 0.4); }},
      {K::set_width, [](E& e) { return e.scale_width(1, 1.25); }},
      {K::set_depth, [](E& e) { return e.scale_depth(1, 0.75); }},
      {K::move_number,
       [](E& e) {
         return e.set_number(0, GlyphPoint{3, 9});
       }},
      {K::set_facts,
       [](E& e) {
         Facts facts = e.character().facts;
         facts.name = "our sign";
         return e.set_facts(facts);
       }},
      {K::groove, [](E& e) { return e.use_tool(ReliefTool::groove, {}, kPen); }},
      {K::raise, [](E& e) { return e.use_tool(ReliefTool::raise, {.mirrored = true}, kPen); }},
      {K::smooth, [](E& e) { return e.use_tool(ReliefTool::smooth, {.width = 12}, kPen); }},
      {K::erase, [](E& e) { return e.use_tool(ReliefTool::erase, {.depth = 1}, kPen); }},
      {K::stamp,
       [](E& e) {
         return e.press_stamp(stamp_of(StampShape::ring), {}, {70, 70});
       }},
      {K::load_relief, [](E& e) { return e.load_relief(*surface::HeightMap::create(32, 0.75F)); }},
      {K::stamp,
       [](E& e) {
         return e.press_stamp(stamp_of(StampShape::dot), {}, {30, 70});
       }},
      {K::clear_relief, [](E& e) { return e.clear_relief(); }},
      {K::groove, [](E& e) { return e.use_tool(ReliefTool::groove, {}, kPen); }},
      {K::delete_stroke, [](E& e) { return e.delete_stroke(1); }},
  };
}

TEST(CharacterEditor, EveryEditIsUndoneAndRedoneToTheLastBitAndCarvedAtOnce) {
  CharacterEditor editor = editor_of(three_strokes());
  std::vector<OwnCharacter> states{editor.character()};
  std::vector<EditKind> kinds{EditKind::none};
  for (const auto& [kind, edit] : all_edits()) {
    const surface::HeightMap before = editor.map();
    const auto box = edit(editor);
    ASSERT_TRUE(box) << states.size() << ": " << base::to_line(box.error());
    EXPECT_EQ(editor.state().undoes, kind);
    EXPECT_NE(editor.character(), states.back()) << states.size();
    EXPECT_EQ(editor.map(), carved(editor.character(), kSide)) << states.size();
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column)
        if (column < box->left || column >= box->right || row < box->top || row >= box->bottom) {
          ASSERT_EQ(editor.map().at(column, row), before.at(column, row)) << states.size();
        }
    states.push_back(editor.character());
    kinds.push_back(kind);
  }
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    EXPECT_EQ(editor.character(), states[i]);
    EXPECT_EQ(editor.state().undoes, kinds[i]);
    (void)editor.undo();
    EXPECT_EQ(editor.state().redoes, kinds[i]);
    EXPECT_EQ(editor.map(), carved(editor.character(), kSide)) << i;
  }
  EXPECT_EQ(editor.character(), states[0]);
  EXPECT_EQ(editor.state().undoes, EditKind::none);
  EXPECT_TRUE(editor.undo().is_empty());
  for (std::size_t i = 1; i < states.size(); ++i) {
    (void)editor.redo();
    EXPECT_EQ(editor.character(), states[i]) << i;
    EXPECT_EQ(editor.map(), carved(editor.character(), kSide)) << i;
  }
  EXPECT_TRUE(editor.redo().is_empty());
}

TEST(CharacterEditor, PartsFollowTheirStrokes) {
  using Parts = std::vector<OwnPart>;
  const auto after = [](auto edit) {
    CharacterEditor editor = editor_of(three_strokes());
    const auto done = edit(editor);
    EXPECT_TRUE(done) << base::to_line(done.error());
    const Parts parts = editor.character().facts.parts;
    (void)editor.undo();
    EXPECT_EQ(editor.character(), three_strokes());
    return parts;
  };
  using E = CharacterEditor;
  EXPECT_EQ(after([](E& e) { return e.delete_stroke(1); }), (Parts{{"a", {0, 1}}, {"b", {}}, {"c", {1}}}));
  EXPECT_EQ(after([](E& e) { return e.reorder(0, 2); }), (Parts{{"a", {1, 2}}, {"b", {0}}, {"c", {0, 1}}}));
  EXPECT_EQ(after([](E& e) { return e.reorder(2, 0); }), (Parts{{"a", {0, 1}}, {"b", {2}}, {"c", {0, 2}}}));
  EXPECT_EQ(after([](E& e) { return e.split_stroke(2, 1); }),
            (Parts{{"a", {0, 2, 3}}, {"b", {1}}, {"c", {1, 2, 3}}}));
  EXPECT_EQ(after([](E& e) { return e.join_strokes(2, 0); }), (Parts{{"a", {1}}, {"b", {0}}, {"c", {0, 1}}}));
  EXPECT_EQ(after([](E& e) { return e.join_strokes(0, 1); }), (Parts{{"a", {0, 1}}, {"b", {}}, {"c", {1}}}));
  EXPECT_EQ(after([](E& e) { return e.move_stroke(1, {1, 1}); }), three_strokes().facts.parts);
}

TEST(CharacterEditor, ReorderingPutsAStrokeAtItsNewPlace) {
  const OwnCharacter start = three_strokes();
  CharacterEditor editor = editor_of(start);
  EXPECT_TRUE(editor.reorder(0, 2)->is_empty());
  EXPECT_EQ(editor.character().strokes, (std::vector{start.strokes[1], start.strokes[2], start.strokes[0]}));
  EXPECT_TRUE(editor.reorder(2, 1));
  EXPECT_EQ(editor.character().strokes, (std::vector{start.strokes[1], start.strokes[0], start.strokes[2]}));
  EXPECT_TRUE(editor.reorder(1, 1));
  EXPECT_EQ(editor.state().undoes, EditKind::reorder_strokes);
}

TEST(CharacterEditor, JoiningPutsTheSecondStrokeAtTheEndOfTheFirst) {
  const OwnCharacter start = three_strokes();
  CharacterEditor editor = editor_of(start);
  ASSERT_TRUE(editor.join_strokes(0, 2));
  EXPECT_EQ(editor.character().strokes,
            (std::vector{joined(start.strokes[0], start.strokes[2]), start.strokes[1]}));
  (void)editor.undo();
  ASSERT_TRUE(editor.join_strokes(2, 0));
  EXPECT_EQ(editor.character().strokes,
            (std::vector{start.strokes[1], joined(start.strokes[2], start.strokes[0])}));
}

TEST(CharacterEditor, ADragIsOneEdit) {
  CharacterEditor editor = editor_of(cross());
  ASSERT_TRUE(editor.move_point(0, 0, {20, 50}));
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(editor.move_point(0, 0, {20, 51.0 + i}, true));
  EXPECT_EQ(editor.character().strokes[0].points[0].at, (GlyphPoint{20, 60}));
  (void)editor.undo();
  EXPECT_EQ(editor.character(), cross());
  (void)editor.redo();
  EXPECT_EQ(editor.character().strokes[0].points[0].at, (GlyphPoint{20, 60}));
  // Another point, another kind, or another drag is another edit.
  ASSERT_TRUE(editor.move_point(0, 1, {80, 50}, true));
  ASSERT_TRUE(editor.move_point(1, 1, {50, 90}, true));
  ASSERT_TRUE(editor.move_stroke(1, {1, 0}, true));
  ASSERT_TRUE(editor.move_stroke(1, {1, 0}));
  for (int i = 0; i < 5; ++i) (void)editor.undo();
  EXPECT_EQ(editor.character(), cross());
}

TEST(CharacterEditor, AnEditTakesWhatWasUndoneAway) {
  CharacterEditor editor = editor_of(cross());
  ASSERT_TRUE(editor.move_point(0, 0, {20, 50}));
  (void)editor.undo();
  ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
  EXPECT_EQ(editor.state().redoes, EditKind::none);
  EXPECT_TRUE(editor.redo().is_empty());
}

TEST(CharacterEditor, KnowsWhetherAFileHasItsState) {
  const auto path = std::filesystem::path(testing::TempDir()) / "saved.nazori";
  CharacterEditor editor = editor_of(cross());
  EXPECT_TRUE(editor.state().is_saved);
  ASSERT_TRUE(editor.move_point(0, 0, {20, 50}));
  EXPECT_FALSE(editor.state().is_saved);
  (void)editor.undo();
  EXPECT_TRUE(editor.state().is_saved);
  (void)editor.redo();
  ASSERT_TRUE(editor.save(path));
  EXPECT_TRUE(editor.state().is_saved);
  // A drag that goes on after saving is an edit of its own.
  ASSERT_TRUE(editor.move_point(0, 0, {21, 50}, true));
  EXPECT_FALSE(editor.state().is_saved);
  (void)editor.undo();
  EXPECT_TRUE(editor.state().is_saved);
  (void)editor.undo();
  EXPECT_FALSE(editor.state().is_saved);
  // The saved state can no longer be reached.
  ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
  EXPECT_FALSE(editor.state().is_saved);
}

TEST(CharacterEditor, ARefusedEditChangesNothing) {
  CharacterEditor editor = editor_of(three_strokes());
  const auto why = [&editor](const CharacterEditor::Touched& touched) {
    EXPECT_EQ(editor.character(), three_strokes());
    EXPECT_EQ(editor.state(), EditorState{.history_bytes = editor.state().history_bytes});
    EXPECT_EQ(editor.state().history_bytes, 0U);
    return place_of_error(touched);
  };
  EXPECT_EQ(why(editor.draw_stroke({})), "pen");
  EXPECT_EQ(why(editor.delete_stroke(3)), "stroke 4");
  EXPECT_EQ(why(editor.insert_point(3, {1, 1})), "stroke 4");
  EXPECT_EQ(why(editor.insert_point(0, {15, 50})), "stroke 1");
  EXPECT_EQ(why(editor.insert_point(0, {2000, 50})), "stroke 1");
  EXPECT_EQ(why(editor.move_point(3, 0, {1, 1})), "stroke 4");
  EXPECT_EQ(why(editor.move_point(0, 2, {1, 1})), "stroke 1, point 3");
  EXPECT_EQ(why(editor.move_point(0, 1, {NAN, 1})), "stroke 1, point 2");
  EXPECT_EQ(why(editor.delete_point(3, 0)), "stroke 4");
  EXPECT_EQ(why(editor.delete_point(0, 2)), "stroke 1, point 3");
  EXPECT_EQ(why(editor.move_stroke(3, {1, 1})), "stroke 4");
  EXPECT_EQ(why(editor.move_stroke(0, {1e6, 1})), "stroke 1, point 1");
  EXPECT_EQ(why(editor.split_stroke(3, 0)), "stroke 4");
  EXPECT_EQ(why(editor.split_stroke(2, 0)), "stroke 3");
  EXPECT_EQ(why(editor.split_stroke(2, 2)), "stroke 3");
  EXPECT_EQ(why(editor.split_stroke(2, 3)), "stroke 3, point 4");
  EXPECT_EQ(why(editor.join_strokes(0, 3)), "stroke 4");
  EXPECT_EQ(why(editor.join_strokes(3, 0)), "stroke 4");
  EXPECT_EQ(why(editor.join_strokes(1, 1)), "stroke 2");
  EXPECT_EQ(why(editor.reverse_stroke(3)), "stroke 4");
  EXPECT_EQ(why(editor.reorder(3, 0)), "stroke 4");
  EXPECT_EQ(why(editor.reorder(0, 3)), "stroke 4");
  EXPECT_EQ(why(editor.set_ending(3, StrokeEnding::stop)), "stroke 4");
  EXPECT_EQ(why(editor.set_half_width(0, 2, 1)), "stroke 1, point 3");
  EXPECT_EQ(why(editor.set_half_width(0, 1, 21)), "stroke 1, point 2");
  EXPECT_EQ(why(editor.set_half_width(3, 1, 2)), "stroke 4");
  EXPECT_EQ(why(editor.set_depth(0, 2, 1)), "stroke 1, point 3");
  EXPECT_EQ(why(editor.set_depth(0, 1, 1.1)), "stroke 1, point 2");
  EXPECT_EQ(why(editor.set_depth(3, 1, 1)), "stroke 4");
  EXPECT_EQ(why(editor.scale_width(3, 1)), "stroke 4");
  EXPECT_EQ(why(editor.scale_width(0, 0)), "factor");
  EXPECT_EQ(why(editor.scale_depth(3, 1)), "stroke 4");
  EXPECT_EQ(why(editor.scale_depth(0, 101)), "factor");
  EXPECT_EQ(why(editor.set_number(3, {})), "stroke 4");
  EXPECT_EQ(why(editor.set_number(0, GlyphPoint{NAN, 0})), "stroke 1");
  Facts facts = three_strokes().facts;
  facts.radical = 300;
  EXPECT_EQ(why(editor.set_facts(facts)), "radical");
  EXPECT_EQ(why(editor.add_strokes(std::vector(198, even_stroke({{1, 1}})))), "strokes");
  EXPECT_EQ(why(editor.add_strokes(std::vector(20, even_stroke(std::vector<GlyphPoint>(1000, {1, 1}))))),
            "strokes");
  EXPECT_EQ(why(editor.use_tool(ReliefTool::groove, {.width = 0}, kPen)), "width");
  EXPECT_EQ(why(editor.press_stamp({}, {}, {1, 1})), "stamp");
  EXPECT_EQ(why(editor.load_relief({})), "map");
  EXPECT_EQ(why(editor.load_relief(*surface::HeightMap::create(kSide + 1))), "map");
  // What does nothing is no edit.
  EXPECT_EQ(why(editor.add_strokes({})), "");
  EXPECT_EQ(why(editor.reorder(1, 1)), "");
  EXPECT_EQ(why(editor.set_facts(three_strokes().facts)), "");
  EXPECT_EQ(why(editor.use_tool(ReliefTool::raise, {}, {})), "");
  EXPECT_EQ(why(editor.clear_relief()), "");
  EXPECT_TRUE(editor.add_strokes(std::vector(197, even_stroke({{1, 1}}))));
}

TEST(CharacterEditor, TheLastPointOfAStrokeStays) {
  OwnCharacter character;
  character.strokes = {even_stroke({{1, 1}})};
  CharacterEditor editor = editor_of(character);
  EXPECT_EQ(place_of_error(editor.delete_point(0, 0)), "stroke 1");
  EXPECT_EQ(place_of_error(editor.insert_point(0, {5, 5})), "stroke 1");
}

TEST(CharacterEditor, TheRightsOfKanjiVgStayWithItsStrokes) {
  OwnCharacter character = cross();
  character.facts.rights = kanjivg_rights();
  CharacterEditor editor = editor_of(character);
  Facts facts = character.facts;
  facts.rights.licence = "CC0-1.0";
  EXPECT_EQ(place_of_error(editor.set_facts(facts)), "licence");
  facts.rights = {};
  EXPECT_EQ(place_of_error(editor.set_facts(facts)), "licence");
  facts.rights = kanjivg_rights();
  facts.name = "another";
  EXPECT_TRUE(editor.set_facts(facts));
  ASSERT_TRUE(editor.delete_stroke(0));
  ASSERT_TRUE(editor.delete_stroke(0));
  facts = editor.character().facts;
  facts.rights = {};
  EXPECT_TRUE(editor.set_facts(facts));
}

TEST(CharacterEditor, TheMapIsAtLeastAsFineAsTheHandsLayer) {
  OwnCharacter character;
  character.hand = layer_with(64, {0, 0, 64, 64}, -0.5F);
  EXPECT_EQ(editor_of(character, 32).map().size(), 64);
  CharacterEditor editor = editor_of(character, 128);
  EXPECT_EQ(editor.map().size(), 128);
  EXPECT_EQ(editor.character().hand.size, 64);
  ASSERT_TRUE(editor.use_tool(ReliefTool::groove, {}, kPen));
  EXPECT_EQ(editor.character().hand.size, 128);
  (void)editor.undo();
  EXPECT_EQ(editor.character(), character);
}

TEST(CharacterEditor, ALoadedReliefIsWhatIsFelt) {
  CharacterEditor editor = editor_of(cross());
  auto map = surface::HeightMap::create(kSide, 0.75F);
  map->set(5, 7, 0.25F);
  ASSERT_TRUE(editor.load_relief(*map));
  for (std::size_t i = 0; i < map->samples().size(); ++i)
    ASSERT_NEAR(editor.map().samples()[i], map->samples()[i], 1e-7);
}

TEST(CharacterEditor, HistoryKeepsOnlyWhatChanged) {
  CharacterEditor editor = editor_of(cross(), 1024);
  ASSERT_TRUE(editor.use_tool(ReliefTool::groove, {.width = 4}, {{.at = {50, 50}}, {.at = {54, 50}}}));
  (void)editor.undo();
  // 8 by 4 glyph units are 75 by 38 samples.
  EXPECT_LT(editor.state().history_bytes, 20'000U);
  EXPECT_GT(editor.state().history_bytes, 8'000U);
}

TEST(CharacterEditor, WhatIsOutOfItsLimitsIsNotTaken) {
  OwnCharacter character = cross();
  character.facts.radical = 999;
  EXPECT_EQ(place_of_error(CharacterEditor::create(character)), "radical");
  EXPECT_FALSE(CharacterEditor::create(cross(), 1));
}

TEST(CharacterEditor, ThePointsOfEveryStrokeCountTowardsTheirLimit) {
  OwnCharacter character = cross();
  character.facts.parts.clear();
  character.strokes.clear();
  for (std::size_t k = 0; k < kMostPointsInAll / kMostPoints; ++k) {
    OwnStroke stroke;
    for (std::size_t i = 0; i < kMostPoints; ++i)
      stroke.points.push_back(
          {{10 + 0.08 * static_cast<double>(i), 10 + 4 * static_cast<double>(k)}, 2, 0.5});
    character.strokes.push_back(stroke);
  }
  CharacterEditor editor = editor_of(character);
  // Both parts have the point at which a stroke is split.
  EXPECT_EQ(place_of_error(editor.split_stroke(1, 500)), "strokes");
  ASSERT_TRUE(editor.delete_point(0, 500));
  EXPECT_TRUE(editor.split_stroke(1, 500));
}

}  // namespace
}  // namespace nazori::author
