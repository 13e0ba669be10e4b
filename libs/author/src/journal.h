// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "change.h"
#include "nazori/base/result.h"

namespace nazori::author {

/// What a record of a journal says.
enum class RecordKind : std::uint8_t {
  base = 1,  ///< the document at the beginning
  edit,      ///< a change
  drag,      ///< a change that goes on with the one before
  undo,
  redo,
};

/// A record, and where it ends in the file.
struct JournalRecord {
  RecordKind kind = RecordKind::base;
  std::vector<std::uint8_t> content;
  std::size_t end = 0;
};

/// The records of a journal up to the first that is damaged or not complete.
/// @param records  the first is RecordKind::base. @return nothing where even that is not there.
[[nodiscard]] std::optional<std::vector<JournalRecord>> read_journal(std::span<const std::uint8_t> bytes);

/// A record that is not yet written.
struct PendingRecord {
  RecordKind kind = RecordKind::edit;
  std::vector<std::uint8_t> content;
  bool flush = false;
};

/// A change as the content of a record: what is to be in the character.
[[nodiscard]] std::vector<std::uint8_t> to_record(const Change& change);
/// @return nothing for bytes that are no change. Whether it fits a character is not checked.
[[nodiscard]] std::optional<Change> parse_change(std::span<const std::uint8_t> content);

/// The document of a record RecordKind::base.
struct JournalBase {
  int map_size = 0;
  bool is_of_file = false;             ///< the document's file had these bytes
  std::vector<std::uint8_t> document;  ///< .nazori
};
[[nodiscard]] std::vector<std::uint8_t> to_record(const JournalBase& base);
[[nodiscard]] std::optional<JournalBase> parse_base(std::span<const std::uint8_t> content);

/// What of the undo of a document its journal brings back, too. What was changed before the journal began is
/// undone and redone by changes of its own there.
struct JournalReach {
  std::size_t floor = 0;     ///< changes that can be undone, but not in the journal
  std::size_t redoable = 0;  ///< changes that can be redone in the journal
};

/// The journal of an open document. Every record is on its way to the disk when append() returns, so it
/// outlives the program; what is flushed outlives the machine, too. After the first error nothing more is
/// written. The file is locked as long as this lives. Thread rules: one thread.
class Journal {
 public:
  /// The error for a journal that another editor writes.
  [[nodiscard]] static tl::unexpected<base::Error> refuse(const std::filesystem::path& path);
  /// Begins a journal; an old one is replaced.
  [[nodiscard]] static base::Result<std::unique_ptr<Journal>> begin(const std::filesystem::path& path,
                                                                    const JournalBase& base);
  /// Goes on with one that was read. @param length  of its good part; what follows is cut off.
  /// @return Errc::in_use, with nothing cut off, where another editor writes it; Errc::io.
  [[nodiscard]] static base::Result<std::unique_ptr<Journal>> go_on(const std::filesystem::path& path,
                                                                    std::size_t length);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  void append(RecordKind kind, std::span<const std::uint8_t> content, bool flush);
  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  JournalReach reach;

 private:
  Journal(std::filesystem::path path, int fd) : path_(std::move(path)), fd_(fd) {}
  void fail(int error_number);

  std::filesystem::path path_;
  int fd_;
  std::optional<base::Error> error_;
};

}  // namespace nazori::author
