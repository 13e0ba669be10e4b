// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/author/own_character.h"
#include "nazori/author/relief_tools.h"
#include "nazori/author/stroke_edits.h"
#include "nazori/base/result.h"
#include "nazori/surface/height_map.h"

namespace nazori::author {

/// What can be undone.
enum class EditKind : std::uint8_t {
  none,  ///< there is nothing to undo or redo
  draw_stroke,
  add_strokes,  ///< several at once: of a picture or of a file
  delete_stroke,
  insert_point,
  move_point,
  delete_point,
  move_stroke,
  split_stroke,
  join_strokes,
  reverse_stroke,
  reorder_strokes,
  set_ending,
  set_width,
  set_depth,
  move_number,
  set_facts,
  groove,
  raise,
  smooth,
  erase,
  stamp,
  load_relief,   ///< a height map took the place of the hand's layer
  clear_relief,  ///< the hand's layer was taken away
};

/// A character in the making, in numbers.
struct EditorState {
  EditKind undoes = EditKind::none;
  EditKind redoes = EditKind::none;
  bool is_saved = true;           ///< the file has this state, or it is new and nothing was done
  bool is_autosaved = false;      ///< a journal is written and holds all of it
  std::size_t history_bytes = 0;  ///< memory of undo and redo
  friend bool operator==(const EditorState&, const EditorState&) = default;
};

/// What was found beside a document that a program left without closing it.
struct Recovery {
  std::size_t edits = 0;       ///< edits, undos and redos that were brought back
  bool is_cut = false;         ///< the journal ends in a part of an edit or in damaged bytes, which are lost
  std::size_t lost_bytes = 0;  ///< how many
  bool file_differs = false;   ///< the document was changed after the journal was begun
};

/// One change of a character, which can be undone; see src/change.h.
struct Change;
/// The journal beside a document; see src/journal.h.
class Journal;

/// A state of a document on its way to the disk. Thread rules: one thread at a time.
struct SavePoint {
  OwnCharacter character;
  int map_size = 0;                         ///< samples per side
  std::uint64_t number = 0;                 ///< of the call of begin_save(); no two are alike
  std::filesystem::path journal_file = {};  ///< the journal that the document has; empty: none
  bool is_of_file = false;                  ///< a file has this state
  bool is_written = false;                  ///< the document was written
  std::shared_ptr<Journal> journal = {};    ///< that was begun; null: none
};

/// Makes and changes a character: every change can be undone without limit, is carved at once in the box that
/// it touches, and is written to a journal, so that a program that is killed loses at most the last one.
///
/// Every edit returns the samples of map() that may have changed. An edit that is refused changes nothing: an
/// index that is not there, a value out of range or a limit is Errc::bad_argument. A journal that cannot be
/// written does not stop an edit: see journal_error(). Indices are 0-based. Thread rules: one thread at a
/// time; no clock and no thread of its own.
class CharacterEditor {
 public:
  /// @param character  the start: an empty one, copy_of(), from_height_map(), from_strokes() or of a file.
  /// @param size  samples per side of map() and of a new hand's layer. A finer layer makes the map as fine; a
  /// coarser one keeps its size until a tool changes it.
  /// @return the errors of validate() and carve().
  [[nodiscard]] static base::Result<CharacterEditor> create(OwnCharacter character, int size = kMapSize);
  ~CharacterEditor();
  CharacterEditor(CharacterEditor&&) noexcept;
  CharacterEditor& operator=(CharacterEditor&&) noexcept;

  [[nodiscard]] const OwnCharacter& character() const { return character_; }
  /// The relief as it is now; always what carve() gives.
  [[nodiscard]] const surface::HeightMap& map() const { return map_; }
  [[nodiscard]] EditorState state() const;

  using Touched = base::Result<carving::GridBox>;

  // Strokes
  Touched draw_stroke(const geometry::WrittenStroke<geometry::GlyphFrame>& pen,
                      const PenSettings& settings = {});
  Touched add_strokes(const std::vector<OwnStroke>& strokes);
  Touched delete_stroke(std::size_t stroke);
  /// Adds a point on the line of a stroke, nearest to `at`. Its index is that of StrokePlace::segment + 1.
  Touched insert_point(std::size_t stroke, geometry::GlyphPoint at);
  /// @param goes_on  the same drag as the edit before: both are undone at once.
  Touched move_point(std::size_t stroke, std::size_t point, geometry::GlyphPoint to, bool goes_on = false);
  /// @return also Errc::bad_argument for the only point of a stroke.
  Touched delete_point(std::size_t stroke, std::size_t point);
  /// Moves a stroke with all its points. @param by  vector.
  Touched move_stroke(std::size_t stroke, geometry::GlyphPoint by, bool goes_on = false);
  /// The second half becomes the next stroke.
  Touched split_stroke(std::size_t stroke, std::size_t point);
  /// `second` is added to the end of `first` and goes from its place in the order.
  Touched join_strokes(std::size_t first, std::size_t second);
  Touched reverse_stroke(std::size_t stroke);
  /// Takes stroke `from` out of the order and puts it in as number `to`.
  Touched reorder(std::size_t from, std::size_t to);
  Touched set_ending(std::size_t stroke, kanji::StrokeEnding ending);
  /// Half width at one point [glyph units].
  Touched set_half_width(std::size_t stroke, std::size_t point, double half_width, bool goes_on = false);
  Touched set_depth(std::size_t stroke, std::size_t point, double depth, bool goes_on = false);
  Touched scale_width(std::size_t stroke, double factor, bool goes_on = false);
  Touched scale_depth(std::size_t stroke, double factor, bool goes_on = false);
  /// @param at  left end of the number's baseline; none: placed by the program.
  Touched set_number(std::size_t stroke, std::optional<geometry::GlyphPoint> at, bool goes_on = false);

  // The rest
  /// @return also Errc::bad_argument where the strokes come from KanjiVG and `facts` has other rights.
  Touched set_facts(Facts facts);
  Touched use_tool(ReliefTool tool, const ToolSettings& settings,
                   const geometry::WrittenStroke<geometry::GlyphFrame>& pen);
  Touched press_stamp(const surface::HeightMap& stamp, const StampSettings& settings,
                      geometry::GlyphPoint at);
  /// A height map takes the place of the hand's layer: together with the strokes the relief then is `map`.
  Touched load_relief(const surface::HeightMap& map);
  Touched clear_relief();

  /// Undoes the last edit. @return the samples that may have changed; empty where there was nothing to undo.
  carving::GridBox undo();
  carving::GridBox redo();

  /// Opens a document, with what its journal holds where a program was killed. The journal goes on.
  /// @param recovery  what was brought back; untouched where there was no journal.
  /// @return the errors of load_character(); Errc::in_use where it is being edited already, here or in
  /// another program; Errc::io for a journal that cannot be read or continued. One that is damaged from its
  /// beginning is left out and counted.
  [[nodiscard]] static base::Result<CharacterEditor> open(const std::filesystem::path& path,
                                                          std::optional<Recovery>& recovery,
                                                          int size = kMapSize);
  /// Brings back a document that was never saved from its journal alone. @return as open().
  [[nodiscard]] static base::Result<CharacterEditor> recover(const std::filesystem::path& journal,
                                                             Recovery& recovery, int size = kMapSize);

  /// Begins a journal; every edit is then written to it and flushed. Without this call nothing is autosaved.
  /// @param path  journal_path() of the document, or any file for one that has no name yet.
  /// @return Errc::in_use where that document is being edited elsewhere; Errc::io.
  [[nodiscard]] base::Result<void> autosave_to(const std::filesystem::path& path);
  /// The error at which the journal stopped; nothing while all is well.
  [[nodiscard]] std::optional<base::Error> journal_error() const;
  /// Writes the document; the journal, if there is one, then belongs to this path and starts again.
  /// @return Errc::in_use where another document of this path is being edited elsewhere; Errc::io.
  [[nodiscard]] base::Result<void> save(const std::filesystem::path& path);

  /// The same for another thread: takes the present state, which write_document() or write_journal() writes
  /// there while edits go on here, and end_save() brings the result back. Of several only the newest counts.
  [[nodiscard]] SavePoint begin_save();
  /// Writes the document and, if there was a journal, begins the one beside it. Thread: any.
  [[nodiscard]] static base::Result<void> write_document(SavePoint& point, const std::filesystem::path& path);
  /// Begins a journal alone, as autosave_to(). Thread: any.
  [[nodiscard]] static base::Result<void> write_journal(SavePoint& point,
                                                        const std::filesystem::path& journal);
  /// The document counts as saved, if it was written, and what was edited meanwhile is in the journal that
  /// was begun. Nothing happens where the point is not of this document or not its newest.
  void end_save(SavePoint point);
  /// Removes the journal: the document was saved or the learner gave up the changes.
  void close_journal();

 private:
  struct Saving;
  CharacterEditor();
  void note(std::uint8_t kind, const std::vector<std::uint8_t>& record, bool flush);
  friend class JournalReplay;
  Touched apply(Change change, bool goes_on = false);
  carving::GridBox swap(Change& change);

  OwnCharacter character_;
  surface::HeightMap map_;
  std::vector<Change> past_;
  std::vector<Change> future_;
  std::optional<std::size_t> saved_at_ = 0;  // length of past_ in the state that a file has
  std::shared_ptr<Journal> journal_;
  std::unique_ptr<Saving> saving_;  // null: nothing is being written
};

/// The journal of a document: its path with ".journal" at the end.
[[nodiscard]] std::filesystem::path journal_path(const std::filesystem::path& document);

/// Whether an editor, of this program or of another one, is writing a journal. The system forgets it when the
/// program ends, in whatever way. Where a file system knows no locks the answer is no.
[[nodiscard]] bool is_being_edited(const std::filesystem::path& journal);

}  // namespace nazori::author
