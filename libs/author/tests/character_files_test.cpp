// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "nazori/base/file.h"
#include "own_forms.h"
#include "temporary_folder.h"

namespace nazori::author {
namespace {

using namespace test;
namespace fs = std::filesystem;

class FilesOnAnotherThread : public testing::Test {
 protected:
  [[nodiscard]] fs::path path() const { return folder_ / "sign.nazori"; }
  [[nodiscard]] Collection collection() const { return Collection(folder_ / "characters"); }
  [[nodiscard]] static CharacterEditor editor(OwnCharacter character = cross()) {
    auto made = CharacterEditor::create(std::move(character), kSize);
    EXPECT_TRUE(made);
    return *std::move(made);
  }
  void finish() {
    inbox_.run_until([this] { return !files_.is_busy(); });
  }
  void save(CharacterEditor& editor) {
    files_.save(editor.begin_save(), path(), [&editor](SavePoint point, const base::Result<void>& saved) {
      EXPECT_TRUE(saved);
      editor.end_save(std::move(point));
    });
  }
  /// The document as the next program opens it: what is on the disk now, without the lock of this one.
  CharacterEditor opened_again(std::optional<Recovery>& recovery) const {
    const fs::path left = folder_ / "left.nazori";
    const auto copies = fs::copy_options::overwrite_existing;
    fs::copy_file(path(), left, copies);
    fs::remove(journal_path(left));
    if (fs::exists(journal_path(path()))) fs::copy_file(journal_path(path()), journal_path(left), copies);
    auto opened = CharacterEditor::open(left, recovery, kSize);
    EXPECT_TRUE(opened);
    return *std::move(opened);
  }
  static constexpr int kSize = 64;
  nazori::test::TemporaryFolder folder_;
  base::Inbox inbox_;
  CharacterFiles files_{inbox_};
};

TEST_F(FilesOnAnotherThread, AnswerEachCallByItsNumber) {
  EXPECT_EQ(files_.last_call(), 0U);
  EXPECT_FALSE(files_.is_busy());
  EXPECT_TRUE(files_.is_waiting_for(1)) << "of the call itself";
  CharacterEditor saved = editor();
  save(saved);
  save(saved);
  EXPECT_EQ(files_.last_call(), 2U);
  inbox_.run_until([this] { return !files_.is_waiting_for(1); });
  finish();
  EXPECT_FALSE(files_.is_waiting_for(2));
  EXPECT_TRUE(files_.is_waiting_for(3));
}

TEST_F(FilesOnAnotherThread, AreOpenedAsTheyWereSaved) {
  CharacterEditor saved = editor();
  ASSERT_TRUE(saved.move_point(0, 0, {20, 48}));
  EXPECT_FALSE(saved.state().is_saved);
  save(saved);
  EXPECT_TRUE(files_.is_busy());
  EXPECT_FALSE(saved.state().is_saved) << "until the answer has come";
  finish();
  EXPECT_TRUE(saved.state().is_saved);
  EXPECT_FALSE(fs::exists(journal_path(path()))) << "there was no journal";
  std::optional<OwnCharacter> read;
  files_.open(path(), [&read](base::Result<OpenedCharacter> opened) {
    ASSERT_TRUE(opened);
    EXPECT_TRUE(opened->is_document);
    EXPECT_FALSE(opened->recovery);
    read = opened->editor.character();
  });
  finish();
  EXPECT_EQ(read, saved.character());
}

TEST_F(FilesOnAnotherThread, CallACharacterWithoutANameAsItsFile) {
  OwnCharacter nameless = cross();
  nameless.facts.name.clear();
  bool is_written = false;
  files_.write_copy(nameless, folder_ / "our bar.str", CharacterFormat::strokes, 128,
                    [&is_written](const base::Result<void>& written) { is_written = written.has_value(); });
  std::string name;
  files_.open(folder_ / "our bar.str", [&name](base::Result<OpenedCharacter> opened) {
    ASSERT_TRUE(opened);
    EXPECT_FALSE(opened->is_document);
    name = opened->editor.character().facts.name;
  });
  finish();
  EXPECT_TRUE(is_written);
  EXPECT_EQ(name, "our bar");
}

TEST_F(FilesOnAnotherThread, SayWhatCannotBeReadOrWritten) {
  ASSERT_TRUE(base::write_file(folder_ / "a.txt", std::string_view("text")));
  std::vector<base::Errc> errors;
  const auto opened = [&errors](const base::Result<OpenedCharacter>& result) {
    errors.push_back(result.error().code);
  };
  files_.open(folder_ / "none.nazori", opened);
  files_.open(folder_ / "none.svg", opened);
  files_.open(folder_ / "a.txt", opened);
  CharacterEditor unsaved = editor();
  ASSERT_TRUE(unsaved.reverse_stroke(0));
  files_.save(unsaved.begin_save(), folder_ / "none" / "a.nazori",
              [&](SavePoint point, const base::Result<void>& saved) {
                errors.push_back(saved.error().code);
                unsaved.end_save(std::move(point));
              });
  files_.write_copy({}, folder_ / "a.str", CharacterFormat::strokes, 128,
                    [&errors](const base::Result<void>& written) { errors.push_back(written.error().code); });
  finish();
  using base::Errc;
  EXPECT_THAT(errors, testing::ElementsAre(Errc::not_found, Errc::not_found, Errc::bad_argument, Errc::io,
                                           Errc::bad_argument));
  EXPECT_FALSE(unsaved.state().is_saved);
}

TEST_F(FilesOnAnotherThread, HaveTheStateOfTheCallAndEditsGoOnMeanwhile) {
  CharacterEditor edited = editor();
  ASSERT_TRUE(edited.autosave_to(journal_path(path())));
  ASSERT_TRUE(edited.set_ending(0, StrokeEnding::hook));
  const OwnCharacter at_the_call = edited.character();
  save(edited);
  ASSERT_TRUE(edited.reverse_stroke(1));
  ASSERT_TRUE(edited.move_point(1, 0, {55, 20}));
  ASSERT_TRUE(edited.move_point(1, 0, {55, 21}, true));
  edited.undo();
  finish();
  EXPECT_EQ(load_character(path()).value(), at_the_call);
  EXPECT_FALSE(edited.state().is_saved);
  edited.undo();
  EXPECT_TRUE(edited.state().is_saved) << "back in the state of the file";
  edited.redo();
  // As if the program had been killed.
  std::optional<Recovery> recovery;
  const CharacterEditor again = opened_again(recovery);
  ASSERT_TRUE(recovery);
  EXPECT_FALSE(recovery->is_cut);
  EXPECT_FALSE(recovery->file_differs);
  EXPECT_EQ(again.character(), edited.character());
  EXPECT_FALSE(again.state().is_saved);
}

TEST_F(FilesOnAnotherThread, BeginAJournalThatUndoesWhatWasDoneBefore) {
  CharacterEditor edited = editor();
  ASSERT_TRUE(edited.autosave_to(journal_path(path())));
  ASSERT_TRUE(edited.set_ending(0, StrokeEnding::hook));
  ASSERT_TRUE(edited.reverse_stroke(1));
  save(edited);
  (void)edited.undo();
  (void)edited.undo();
  (void)edited.redo();
  finish();
  (void)edited.undo();
  (void)edited.redo();
  (void)edited.redo();
  (void)edited.undo();
  std::optional<Recovery> recovery;
  const CharacterEditor again = opened_again(recovery);
  ASSERT_TRUE(recovery);
  EXPECT_FALSE(recovery->is_cut);
  EXPECT_EQ(again.character(), edited.character());
}

TEST_F(FilesOnAnotherThread, DoNotCountAsSavedOnceTheirStateIsGone) {
  CharacterEditor edited = editor();
  ASSERT_TRUE(edited.set_ending(0, StrokeEnding::hook));
  save(edited);
  edited.undo();
  ASSERT_TRUE(edited.reverse_stroke(1));
  finish();
  EXPECT_FALSE(edited.state().is_saved) << "another edit, though as many";
}

// A drag that goes on while its first state is written is undone to that state.
TEST_F(FilesOnAnotherThread, SplitADragThatTheyWereCalledIn) {
  CharacterEditor edited = editor();
  ASSERT_TRUE(edited.move_point(0, 0, {20, 40}));
  save(edited);
  ASSERT_TRUE(edited.move_point(0, 0, {20, 30}, true));
  finish();
  edited.undo();
  EXPECT_EQ(edited.character().strokes[0].points[0].at, (GlyphPoint{20, 40}));
  EXPECT_TRUE(edited.state().is_saved);
}

TEST_F(FilesOnAnotherThread, MoveTheJournalToTheNewDocument) {
  CharacterEditor edited = editor();
  const fs::path unnamed = folder_ / "unnamed.journal";
  files_.begin_journal(edited.begin_save(), unnamed, [&edited](SavePoint point, const auto& begun) {
    EXPECT_TRUE(begun);
    edited.end_save(std::move(point));
  });
  ASSERT_TRUE(edited.reverse_stroke(0));
  finish();
  EXPECT_TRUE(edited.state().is_autosaved);
  EXPECT_FALSE(edited.state().is_saved) << "only a journal was written";
  Recovery recovery;
  const fs::path left = folder_ / "left.journal";
  fs::copy_file(unnamed, left);
  EXPECT_EQ(CharacterEditor::recover(left, recovery, kSize)->character(), edited.character());
  EXPECT_EQ(recovery.edits, 1U);
  save(edited);
  finish();
  EXPECT_FALSE(fs::exists(unnamed));
  EXPECT_TRUE(fs::exists(journal_path(path())));
}

TEST_F(FilesOnAnotherThread, AreOfNoUseToAnotherDocument) {
  CharacterEditor first = editor();
  ASSERT_TRUE(first.reverse_stroke(0));
  SavePoint point = first.begin_save();
  ASSERT_TRUE(CharacterEditor::write_document(point, path()));
  CharacterEditor second = editor();
  ASSERT_TRUE(second.reverse_stroke(0));
  (void)second.begin_save();
  second.end_save(std::move(point));
  EXPECT_FALSE(second.state().is_saved);
}

TEST_F(FilesOnAnotherThread, AreKeptInACollectionAsTheDocumentOrBesideIt) {
  CharacterEditor edited = editor();
  ASSERT_TRUE(edited.autosave_to(folder_ / "unnamed.journal"));
  ASSERT_TRUE(edited.reverse_stroke(0));
  std::optional<char32_t> place;
  const auto keep = [&](SameName same, bool becomes_document, std::optional<char32_t> as = {}) {
    base::Result<char32_t> answer = 0;
    files_.keep(edited.begin_save(), collection(), as, same, becomes_document,
                [&](SavePoint point, const base::Result<char32_t>& kept) {
                  answer = kept;
                  edited.end_save(std::move(point));
                });
    finish();
    return answer;
  };
  place = keep(SameName::refuse, false).value();
  EXPECT_FALSE(edited.state().is_saved);
  EXPECT_TRUE(fs::exists(folder_ / "unnamed.journal"));
  const auto refused = keep(SameName::refuse, true);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::Errc::in_use);
  EXPECT_EQ(refused.error().where, "十");
  EXPECT_FALSE(edited.state().is_saved);
  EXPECT_EQ(keep(SameName::refuse, true, place).value(), place);
  EXPECT_TRUE(edited.state().is_saved);
  EXPECT_FALSE(fs::exists(folder_ / "unnamed.journal"));
  EXPECT_TRUE(fs::exists(journal_path(collection().file_of(*place))));
  EXPECT_EQ(collection().find(*place).value(), edited.character());
  bool is_removed = false;
  files_.remove(collection(), *place,
                [&is_removed](const base::Result<void>& removed) { is_removed = removed.has_value(); });
  finish();
  EXPECT_TRUE(is_removed);
  EXPECT_FALSE(collection().find(*place));
}

}  // namespace
}  // namespace nazori::author
