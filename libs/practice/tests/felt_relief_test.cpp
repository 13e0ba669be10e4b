// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/felt_relief.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "nazori/author/character_editor.h"

namespace nazori::practice {
namespace {

using Pen = geometry::WrittenStroke<geometry::GlyphFrame>;

Pen line(geometry::GlyphPoint from, geometry::GlyphPoint to) {
  return {{.at = from, .pressure = 1.0}, {.at = to, .pressure = 1.0}};
}

class FeltReliefTest : public testing::Test {
 protected:
  FeltReliefTest() { begin(); }
  void begin() { relief_.begin(editor_.map(), editor_.character().strokes); }
  void edit(const author::CharacterEditor::Touched& touched) {
    ASSERT_TRUE(touched);
    relief_.update(editor_.map(), *touched, editor_.character().strokes);
  }
  void finish() {
    inbox_.run_until([this] { return !relief_.is_busy(); });
  }
  author::CharacterEditor editor_ = *author::CharacterEditor::create({}, 64);
  base::Inbox inbox_;
  std::vector<Tablet> put_;
  FeltRelief relief_{inbox_, [this](const Tablet& tablet) { put_.push_back(tablet); }};
};

TEST_F(FeltReliefTest, IsFeltAfterEachEditAsItIsDrawn) {
  EXPECT_TRUE(relief_.is_busy());
  finish();
  ASSERT_EQ(put_.size(), 1U);
  EXPECT_EQ(put_.back()->height_map(), editor_.map());
  edit(editor_.draw_stroke(line({20, 30}, {90, 35})));
  finish();
  ASSERT_EQ(put_.size(), 2U);
  EXPECT_EQ(put_.back()->height_map(), editor_.map());
  ASSERT_EQ(put_.back()->lines().size(), 1U);
  EXPECT_EQ(put_.back()->paths().size(), 1U);
  edit(editor_.use_tool(author::ReliefTool::groove, {}, line({30, 80}, {80, 90})));
  finish();
  EXPECT_EQ(put_.back()->height_map(), editor_.map());
  relief_.update(editor_.map(), editor_.undo(), editor_.character().strokes);
  finish();
  EXPECT_EQ(put_.back()->height_map(), editor_.map());
  EXPECT_EQ(put_.size(), 4U);
}

TEST_F(FeltReliefTest, TakesOnlyTheTouchedSamples) {
  finish();
  surface::HeightMap other = editor_.map();
  for (float& height : other.samples()) height = 0.25F;
  relief_.update(other, {10, 20, 12, 23}, {});
  finish();
  surface::HeightMap expected = editor_.map();
  for (int row = 20; row < 23; ++row)
    for (int column = 10; column < 12; ++column) expected.set(column, row, 0.25F);
  EXPECT_EQ(put_.back()->height_map(), expected);
}

TEST_F(FeltReliefTest, HasAllOfManyFastEditsAtTheirEnd) {
  for (int i = 0; i < 20; ++i) edit(editor_.draw_stroke(line({10, 5.0 + 5 * i}, {100, 8.0 + 5 * i})));
  finish();
  EXPECT_LE(put_.size(), 21U);
  EXPECT_EQ(put_.back()->height_map(), editor_.map());
  EXPECT_EQ(put_.back()->lines().size(), 20U);
}

TEST_F(FeltReliefTest, PutsNothingAfterItsEnd) {
  relief_.end();
  EXPECT_FALSE(relief_.is_busy());
  edit(editor_.draw_stroke(line({20, 30}, {90, 35})));
  begin();
  finish();
  ASSERT_EQ(put_.size(), 1U);
  EXPECT_EQ(put_.back()->lines().size(), 1U);
}

TEST_F(FeltReliefTest, TakesAnotherDocumentOfAnotherSize) {
  finish();
  editor_ = *author::CharacterEditor::create({}, 128);
  ASSERT_TRUE(editor_.draw_stroke(line({20, 30}, {90, 35})));
  relief_.update(editor_.map(), {1, 1, 2, 2}, editor_.character().strokes);
  finish();
  EXPECT_EQ(put_.back()->height_map().size(), 128);
  EXPECT_EQ(put_.back()->height_map(), editor_.map());
}

}  // namespace
}  // namespace nazori::practice
