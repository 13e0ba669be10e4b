// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "change.h"
#include "journal.h"
#include "nazori/author/character_editor.h"
#include "nazori/author/character_file.h"
#include "nazori/base/file.h"
#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Pen = geometry::WrittenStroke<geometry::GlyphFrame>;

constexpr int kMap = 64;

class Autosave : public testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::path(testing::TempDir()) / "sign.nazori";
    fs::remove(path_);
    fs::remove(journal_path(path_));
    ASSERT_TRUE(save_character(cross(), path_));
  }

  CharacterEditor open() {
    recovery_.reset();
    auto editor = CharacterEditor::open(path_, recovery_, kMap);
    EXPECT_TRUE(editor) << base::to_line(editor.error());
    return *std::move(editor);
  }
  /// Some edits of all sorts; the states after each of them.
  static std::vector<OwnCharacter> work(CharacterEditor& editor) {
    const Pen pen{{.at = {20, 20}, .pressure = 1.0}, {.at = {80, 30}, .pressure = 0.5}};
    std::vector<OwnCharacter> states{editor.character()};
    const auto keep = [&](const CharacterEditor::Touched& touched) {
      EXPECT_TRUE(touched);
      states.push_back(editor.character());
    };
    keep(editor.draw_stroke(pen));
    keep(editor.use_tool(ReliefTool::groove, {}, pen));
    keep(editor.set_number(0, GlyphPoint{5, 7}));
    keep(editor.undo());
    keep(editor.redo());
    keep(editor.move_point(0, 0, {11, 12}));
    keep(editor.move_point(0, 0, {12, 12}, true));
    Facts facts = editor.character().facts;
    facts.name = "own";
    keep(editor.set_facts(facts));
    keep(editor.load_relief(*surface::HeightMap::create(16, 0.75F)));
    keep(editor.press_stamp(stamp_of(StampShape::dot), {}, {50, 50}));
    keep(editor.delete_stroke(1));
    return states;
  }
  std::vector<std::uint8_t> journal_bytes() const { return *base::read_file(journal_path(path_), 1U << 30U); }

  fs::path path_;
  std::optional<Recovery> recovery_;
};

TEST_F(Autosave, ADocumentThatIsBeingEditedIsNotOpenedAgain) {
  CharacterEditor editor = open();
  EXPECT_FALSE(is_being_edited(journal_path(path_)));
  ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
  work(editor);
  EXPECT_TRUE(is_being_edited(journal_path(path_)));
  const auto journal = journal_bytes();
  std::optional<Recovery> recovery;
  const auto second = CharacterEditor::open(path_, recovery, kMap);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, base::Errc::in_use);
  Recovery found;
  EXPECT_EQ(CharacterEditor::recover(journal_path(path_), found, kMap).error().code, base::Errc::in_use);
  EXPECT_EQ(Journal::go_on(journal_path(path_), 10).error().code, base::Errc::in_use);
  EXPECT_EQ(journal_bytes(), journal) << "nothing is cut off";
  EXPECT_TRUE(editor.save(path_)) << "it is its own journal";
  editor.close_journal();
  EXPECT_FALSE(is_being_edited(journal_path(path_)));
  open();
}

TEST_F(Autosave, AnotherDocumentDoesNotTakeThePlaceOfOneThatIsBeingEdited) {
  CharacterEditor editor = open();
  ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
  work(editor);
  const auto document = *base::read_file(path_, 1U << 30U);
  const auto journal = journal_bytes();
  CharacterEditor other = CharacterEditor::create(cross(), kMap).value();
  EXPECT_EQ(other.save(path_).error().code, base::Errc::in_use);
  EXPECT_EQ(other.autosave_to(journal_path(path_)).error().code, base::Errc::in_use);
  EXPECT_FALSE(other.state().is_autosaved);
  EXPECT_EQ(*base::read_file(path_, 1U << 30U), document);
  EXPECT_EQ(journal_bytes(), journal);
}

TEST_F(Autosave, WithoutAJournalNothingIsRecovered) {
  const CharacterEditor editor = open();
  EXPECT_FALSE(recovery_);
  EXPECT_FALSE(editor.state().is_autosaved);
  EXPECT_FALSE(fs::exists(journal_path(path_)));
}

// A journal begins again when the document is saved. What was changed before is still undone after it.
TEST_F(Autosave, UndoReachesBehindTheLastSave) {
  OwnCharacter last;
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    ASSERT_TRUE(editor.set_ending(0, StrokeEnding::hook));
    ASSERT_TRUE(editor.reverse_stroke(1));
    ASSERT_TRUE(editor.move_point(0, 0, {11, 12}));
    ASSERT_TRUE(editor.save(path_));
    (void)editor.undo();
    (void)editor.undo();
    (void)editor.redo();
    (void)editor.undo();
    ASSERT_TRUE(editor.delete_stroke(1));
    (void)editor.undo();
    (void)editor.redo();
    last = editor.character();
  }
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(recovery_);
    EXPECT_FALSE(recovery_->is_cut);
    EXPECT_EQ(editor.character(), last);
    // The journal goes on.
    (void)editor.undo();
    EXPECT_EQ(editor.character().strokes.size(), 2U);
    (void)editor.redo();
    (void)editor.undo();
    ASSERT_TRUE(editor.set_ending(1, StrokeEnding::hook));
    last = editor.character();
  }
  CharacterEditor editor = open();
  EXPECT_FALSE(recovery_->is_cut);
  EXPECT_EQ(editor.character(), last);
}

TEST_F(Autosave, AllEditsComeBackWithTheirUndo) {
  std::vector<OwnCharacter> states;
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    EXPECT_TRUE(editor.state().is_autosaved);
    states = work(editor);
  }
  CharacterEditor editor = open();
  ASSERT_TRUE(recovery_);
  EXPECT_EQ(recovery_->edits, 11U);
  EXPECT_FALSE(recovery_->is_cut);
  EXPECT_FALSE(recovery_->file_differs);
  EXPECT_EQ(editor.character(), states.back());
  EXPECT_EQ(editor.map(), carved(editor.character(), kMap));
  EXPECT_FALSE(editor.state().is_saved);
  // Two steps of the drag are one, and undo and redo cancel.
  for (int i = 0; i < 8; ++i) (void)editor.undo();
  EXPECT_EQ(editor.character(), cross());
  EXPECT_TRUE(editor.state().is_saved);
  EXPECT_TRUE(editor.undo().is_empty());
}

TEST_F(Autosave, TheJournalGoesOnAfterARecovery) {
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    (void)work(editor);
  }
  OwnCharacter last;
  {
    CharacterEditor editor = open();
    EXPECT_TRUE(editor.state().is_autosaved);
    ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
    last = editor.character();
  }
  EXPECT_EQ(open().character(), last);
  EXPECT_EQ(recovery_->edits, 12U);
}

TEST_F(Autosave, AJournalThatIsCutAnywhereLosesOnlyWhatIsBehindTheCut) {
  std::vector<OwnCharacter> states;
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    states = work(editor);
  }
  const auto bytes = journal_bytes();
  const auto records = read_journal(bytes);
  ASSERT_TRUE(records);
  ASSERT_EQ(records->size(), states.size());
  for (std::size_t i = 0; i + 1 < records->size(); ++i) {
    const std::size_t begin = (*records)[i].end;
    const std::size_t end = (*records)[i + 1].end;
    for (const std::size_t cut : {begin, begin + 1, (begin + end) / 2, end - 1}) {
      ASSERT_TRUE(base::write_file(journal_path(path_), std::span(bytes).first(cut)));
      EXPECT_EQ(open().character(), states[i]) << cut;
      EXPECT_EQ(recovery_->edits, i);
      EXPECT_EQ(recovery_->is_cut, cut != begin);
      EXPECT_EQ(recovery_->lost_bytes, cut - begin);
      // The damaged rest is gone, so that what follows can be read.
      EXPECT_EQ(journal_bytes().size(), begin);
    }
  }
}

TEST_F(Autosave, ADamagedByteLosesOnlyWhatIsBehindIt) {
  std::vector<OwnCharacter> states;
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    states = work(editor);
  }
  const auto bytes = journal_bytes();
  const auto records = read_journal(bytes);
  for (std::size_t i = 0; i + 1 < records->size(); ++i) {
    const std::size_t begin = (*records)[i].end;
    for (const std::size_t at : {begin, begin + 1, (*records)[i + 1].end - 1}) {
      auto damaged = bytes;
      damaged[at] ^= 0x01U;
      ASSERT_TRUE(base::write_file(journal_path(path_), damaged));
      EXPECT_EQ(open().character(), states[i]) << at;
      EXPECT_TRUE(recovery_->is_cut);
    }
  }
}

TEST_F(Autosave, AJournalThatIsNoneIsLeftOutAndCounted) {
  ASSERT_TRUE(base::write_file(journal_path(path_), std::string_view("something else")));
  EXPECT_EQ(open().character(), cross());
  ASSERT_TRUE(recovery_);
  EXPECT_TRUE(recovery_->is_cut);
  EXPECT_EQ(recovery_->lost_bytes, 14U);
  EXPECT_EQ(recovery_->edits, 0U);
}

TEST_F(Autosave, SavingBeginsTheJournalAgain) {
  CharacterEditor editor = open();
  ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
  (void)work(editor);
  const auto before = journal_bytes().size();
  const auto other = fs::path(testing::TempDir()) / "other.nazori";
  ASSERT_TRUE(editor.save(other));
  EXPECT_FALSE(fs::exists(journal_path(path_)));
  EXPECT_LT(fs::file_size(journal_path(other)), before);
  const OwnCharacter saved = editor.character();
  ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
  editor.close_journal();
  EXPECT_FALSE(fs::exists(journal_path(other)));
  EXPECT_EQ(*load_character(other), saved);
  editor.close_journal();
}

TEST_F(Autosave, ADocumentThatWasChangedMeanwhileIsNoticed) {
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
  }
  OwnCharacter other = cross();
  other.facts.name = "other";
  ASSERT_TRUE(save_character(other, path_));
  CharacterEditor editor = open();
  EXPECT_TRUE(recovery_->file_differs);
  EXPECT_EQ(editor.character().facts.name, "十");
  EXPECT_FALSE(editor.state().is_saved);
  (void)editor.undo();
  EXPECT_FALSE(editor.state().is_saved);
}

TEST_F(Autosave, AProgramThatDiesWhileItSavesHasSaved) {
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
    ASSERT_TRUE(save_character(editor.character(), path_));
  }
  const CharacterEditor editor = open();
  EXPECT_FALSE(recovery_->file_differs);
  EXPECT_TRUE(editor.state().is_saved);
  EXPECT_EQ(editor.character().strokes[0].points[0].depth, 0.5);
}

TEST_F(Autosave, ADocumentWithoutANameIsRecoveredFromItsJournal) {
  const auto journal = fs::path(testing::TempDir()) / "new.journal";
  OwnCharacter last;
  {
    auto editor = CharacterEditor::create({}, kMap);
    ASSERT_TRUE(editor->autosave_to(journal));
    ASSERT_TRUE(editor->draw_stroke({{.at = {10, 10}}, {.at = {90, 90}}}));
    last = editor->character();
  }
  Recovery recovery;
  auto editor = CharacterEditor::recover(journal, recovery, 32);
  ASSERT_TRUE(editor) << base::to_line(editor.error());
  EXPECT_EQ(editor->character(), last);
  EXPECT_EQ(editor->map().size(), kMap);
  EXPECT_EQ(recovery.edits, 1U);
  EXPECT_FALSE(editor->state().is_saved);
  EXPECT_EQ(CharacterEditor::recover(fs::path(testing::TempDir()) / "none", recovery).error().code,
            base::Errc::not_found);
}

TEST_F(Autosave, AJournalThatCannotBeWrittenStopsNoEdit) {
  CharacterEditor editor = open();
  EXPECT_EQ(editor.autosave_to("/dev/full/nothing").error().code, base::Errc::io);
  EXPECT_FALSE(editor.state().is_autosaved);
  ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
  EXPECT_FALSE(editor.journal_error());
}

TEST_F(Autosave, AnEditOfAnotherDocumentEndsTheReplay) {
  {
    CharacterEditor editor = open();
    ASSERT_TRUE(editor.autosave_to(journal_path(path_)));
    ASSERT_TRUE(editor.set_depth(0, 0, 0.5));
  }
  const auto kept = journal_bytes().size();
  const auto tail = [&](const Change& change) {
    // What follows the good part is cut off, and the lock ends with the block.
    if (auto journal = Journal::go_on(journal_path(path_), kept))
      (*journal)->append(RecordKind::edit, to_record(change), false);
    (void)open();
    return recovery_->edits;
  };
  using S = Change::Strokes;
  using P = Change::Patch;
  const std::vector<float> nine(9, -0.5F);
  EXPECT_EQ(tail({.kind = EditKind::set_depth, .strokes = S{0, 1, {even_stroke({{1, 1}})}}}), 2U);
  EXPECT_EQ(tail({.kind = EditKind::set_depth, .strokes = S{2, 1, {even_stroke({{1, 1}})}}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::set_depth, .strokes = S{3, 0, {even_stroke({{1, 1}})}}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::set_depth, .strokes = S{1, 0xFFFFFFFF, {even_stroke({{1, 1}})}}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::set_depth, .strokes = S{0, 1, {even_stroke({{1e9, 1}})}}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::delete_stroke, .strokes = S{0, 2, {}}}),
            1U);  // parts would have no strokes
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{1, 1, 4, 4}, kMap, nine}}), 2U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{1, 1, 4, 5}, kMap, nine}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{kMap - 2, 1, kMap + 1, 4}, kMap, nine}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{-1, 1, 2, 4}, kMap, nine}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{1, 1, 4, 4}, kMap + 1, nine}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{1, 1, 4, 4}, 0, nine}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{1, 1, 4, 4}, kMap, std::vector<float>(9, 2.0F)}}),
            1U);
  EXPECT_EQ(tail({.kind = EditKind::groove, .patch = P{{4, 4, 4, 4}, kMap, {}}}), 1U);
  EXPECT_EQ(tail({.kind = EditKind::load_relief, .layer = HandLayer{3, nine}}), 2U);
  EXPECT_EQ(tail({.kind = EditKind::load_relief, .layer = HandLayer{4, nine}}), 1U);
}

TEST_F(Autosave, WhatIsKilledLosesNothingThatWasDone) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::optional<Recovery> recovery;
    auto editor = CharacterEditor::open(path_, recovery, kMap);
    if (!editor || !editor->autosave_to(journal_path(path_))) ::_exit(1);
    if (!editor->set_depth(0, 0, 0.25) || !editor->draw_stroke({{.at = {1, 1}}, {.at = {50, 9}}})) ::_exit(2);
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const CharacterEditor editor = open();
  EXPECT_EQ(recovery_->edits, 2U);
  EXPECT_EQ(editor.character().strokes.size(), 3U);
  EXPECT_EQ(editor.character().strokes[0].points[0].depth, 0.25);
}

TEST(Journal, ChangesAreReadBack) {
  OwnStroke stroke = even_stroke({{1.5, -2}, {1e-17, 4}}, 0.1, 0.3);
  stroke.ending = StrokeEnding::hook;
  stroke.number_position = GlyphPoint{7, 8.25};
  const Change change{.kind = EditKind::stamp,
                      .stroke = 3,
                      .point = 0xFFFFFFFF,
                      .strokes = Change::Strokes{1, 2, {stroke, even_stroke({{3, 3}})}},
                      .facts = cross().facts,
                      .patch = Change::Patch{{1, 2, 3, 4}, 9, {0.5F, -0.25F, 0, 1}},
                      .layer = HandLayer{2, {1, 2, 3, 4}}};
  const auto bytes = to_record(change);
  EXPECT_EQ(parse_change(bytes), change);
  for (std::size_t i = 0; i < bytes.size(); ++i) EXPECT_FALSE(parse_change(std::span(bytes).first(i))) << i;
  auto longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(parse_change(longer));
  EXPECT_EQ(parse_change(to_record(Change{.kind = EditKind::clear_relief})),
            Change{.kind = EditKind::clear_relief});
  auto unknown = to_record(Change{});
  unknown[0] = static_cast<std::uint8_t>(EditKind::clear_relief) + 1;
  EXPECT_FALSE(parse_change(unknown));
  unknown = to_record(Change{});
  unknown[9] = 16;
  EXPECT_FALSE(parse_change(unknown));
}

}  // namespace
}  // namespace nazori::author
