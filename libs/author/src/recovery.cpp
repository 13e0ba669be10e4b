// SPDX-License-Identifier: Apache-2.0
// Opening, saving and the journal of a document.
#include <system_error>
#include <utility>

#include "change.h"
#include "journal.h"
#include "nazori/author/character_editor.h"
#include "nazori/author/character_file.h"
#include "nazori/base/file.h"

namespace nazori::author {
namespace {

using base::Errc;

/// Whether a change that was read from a file can be done.
bool fits(const Change& change, const OwnCharacter& character) {
  if (change.strokes) {
    const std::size_t strokes = character.strokes.size();
    if (change.strokes->first > strokes || change.strokes->count > strokes - change.strokes->first)
      return false;
  }
  if (change.patch) {
    const Change::Patch& patch = *change.patch;
    const int size = character.hand.is_untouched() ? patch.size : character.hand.size;
    if (size < surface::HeightMap::kMinSize || size > surface::HeightMap::kMaxSize || patch.size != size ||
        patch.box.is_empty() || !(carving::common(patch.box, carving::whole_map(size)) == patch.box))
      return false;
    const auto width = static_cast<std::size_t>(patch.box.right - patch.box.left);
    if (patch.heights.size() != width * static_cast<std::size_t>(patch.box.bottom - patch.box.top))
      return false;
  }
  return true;
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& document) {
  std::filesystem::path path = document;
  path += ".journal";
  return path;
}

/// Brings back what a journal holds.
class JournalReplay {
 public:
  static base::Result<CharacterEditor> run(const std::filesystem::path& path, Recovery& recovery, int size,
                                           const std::vector<std::uint8_t>* file) {
    if (is_being_edited(path)) return Journal::refuse(path);
    constexpr std::size_t kLargest = std::size_t{1} << 30;
    const auto bytes = base::read_file(path, kLargest);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto records = read_journal(*bytes);
    const auto start = records ? parse_base(records->front().content) : std::nullopt;
    if (!start) return base::fail(Errc::parse, "is not a journal", path.string());
    auto character = parse_character(start->document);
    if (!character) return tl::unexpected(std::move(character).error());
    const bool size_fits =
        start->map_size >= surface::HeightMap::kMinSize && start->map_size <= surface::HeightMap::kMaxSize;
    auto editor = CharacterEditor::create(*std::move(character), size_fits ? start->map_size : size);
    if (!editor) return editor;
    std::size_t end = records->front().end;
    for (std::size_t i = 1; i < records->size() && replay((*records)[i], *editor); ++i) {
      end = (*records)[i].end;
      ++recovery.edits;
    }
    recovery.lost_bytes = bytes->size() - end;
    recovery.is_cut = recovery.lost_bytes > 0;
    if (file != nullptr) {
      const bool is_same = start->is_of_file && *file == start->document;
      const auto now = to_bytes(editor->character_);
      const bool is_saved = now && *now == *file;
      recovery.file_differs = !is_same && !is_saved;
      if (is_saved) editor->saved_at_ = editor->past_.size();
      if (!is_saved && !is_same) editor->saved_at_.reset();
    } else if (!start->is_of_file) {
      editor->saved_at_ = recovery.edits == 0 ? editor->saved_at_ : std::nullopt;
    }
    auto journal = Journal::go_on(path, end);
    if (!journal) return tl::unexpected(std::move(journal).error());
    editor->journal_ = *std::move(journal);
    editor->journal_->reach = {0, editor->future_.size()};
    return editor;
  }

 private:
  /// @return false for a record that does not fit what is there.
  static bool replay(const JournalRecord& record, CharacterEditor& editor) {
    switch (record.kind) {
      case RecordKind::base:
        return false;
      case RecordKind::undo:
        if (editor.past_.empty()) return false;
        (void)editor.undo();
        return true;
      case RecordKind::redo:
        if (editor.future_.empty()) return false;
        (void)editor.redo();
        return true;
      case RecordKind::edit:
      case RecordKind::drag:
        break;
    }
    auto change = parse_change(record.content);
    if (!change || !fits(*change, editor.character_)) return false;
    if (change->patch || change->layer) {
      OwnCharacter trial;
      trial.hand = editor.character_.hand;
      Change copy{.kind = change->kind, .patch = change->patch, .layer = change->layer};
      (void)exchange(copy, trial, editor.map_.size());
      if (trial.hand.size > editor.map_.size() || !validate(trial)) return false;
    }
    return editor.apply(*std::move(change), record.kind == RecordKind::drag).has_value();
  }
};

base::Result<CharacterEditor> CharacterEditor::open(const std::filesystem::path& path,
                                                    std::optional<Recovery>& recovery, int size) {
  const auto bytes = base::read_file(path, kLargestFile);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::filesystem::path beside = journal_path(path);
  std::error_code ignored;
  if (std::filesystem::exists(beside, ignored)) {
    Recovery found;
    auto editor = JournalReplay::run(beside, found, size, &*bytes);
    if (editor) {
      recovery = found;
      return editor;
    }
    if (editor.error().code == Errc::parse || editor.error().code == Errc::schema) {
      found.is_cut = true;
      found.lost_bytes = static_cast<std::size_t>(std::filesystem::file_size(beside, ignored));
      recovery = found;
    } else {
      return editor;
    }
  }
  auto character = load_character(path);
  if (!character) return tl::unexpected(std::move(character).error());
  return create(*std::move(character), size);
}

base::Result<CharacterEditor> CharacterEditor::recover(const std::filesystem::path& journal,
                                                       Recovery& recovery, int size) {
  return JournalReplay::run(journal, recovery, size, nullptr);
}

namespace {

/// The journal of another editor must not be replaced.
base::Result<void> check_free(const SavePoint& point, const std::filesystem::path& journal) {
  if (journal == point.journal_file || !is_being_edited(journal)) return {};
  return Journal::refuse(journal);
}

}  // namespace

base::Result<void> CharacterEditor::write_journal(SavePoint& point, const std::filesystem::path& journal) {
  if (auto is_free = check_free(point, journal); !is_free) return is_free;
  auto document = to_bytes(point.character);
  if (!document) return tl::unexpected(std::move(document).error());
  auto begun = Journal::begin(journal, {point.map_size, point.is_of_file, *std::move(document)});
  if (!begun) return tl::unexpected(std::move(begun).error());
  point.journal = *std::move(begun);
  return {};
}

base::Result<void> CharacterEditor::write_document(SavePoint& point, const std::filesystem::path& path) {
  if (auto is_free = check_free(point, journal_path(path)); !is_free) return is_free;
  if (auto saved = save_character(point.character, path); !saved) return saved;
  point.is_written = true;
  point.is_of_file = true;
  return !point.journal_file.empty() ? write_journal(point, journal_path(path)) : base::Result<void>();
}

base::Result<void> CharacterEditor::autosave_to(const std::filesystem::path& path) {
  SavePoint point = begin_save();
  auto begun = write_journal(point, path);
  end_save(std::move(point));
  return begun;
}

std::optional<base::Error> CharacterEditor::journal_error() const {
  return journal_ ? journal_->error() : std::nullopt;
}

base::Result<void> CharacterEditor::save(const std::filesystem::path& path) {
  SavePoint point = begin_save();
  auto saved = write_document(point, path);
  end_save(std::move(point));
  return saved;
}

void CharacterEditor::close_journal() {
  if (!journal_) return;
  std::error_code ignored;
  std::filesystem::remove(journal_->path(), ignored);
  journal_.reset();
}

}  // namespace nazori::author
