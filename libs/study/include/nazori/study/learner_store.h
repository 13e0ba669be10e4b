// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/study/calendar.h"
#include "nazori/study/card.h"
#include "nazori/study/handwriting.h"
#include "nazori/study/settings.h"
#include "nazori/study/study_days.h"

namespace nazori::study {

/// A list of characters of the learner's own.
struct CustomList {
  std::string name;  ///< 1..100 bytes of UTF-8 without control characters
  std::vector<char32_t> characters;

  friend bool operator==(const CustomList&, const CustomList&) = default;
};

/// A card by its character.
using Cards = std::map<char32_t, Card>;

/// What rebuilding found.
struct RebuildReport {
  int entries = 0;      ///< in the log
  int cards = 0;        ///< that follow from it: every character an action was about and was not undone
  int studied = 0;      ///< of these: written or watched, and not made new again since
  int differences = 0;  ///< cards that were kept otherwise than they follow from the log
};

/// What was taken back.
struct Undone {
  EntryKind kind = EntryKind::writing;
  std::vector<char32_t> characters;  ///< it was about, ascending
};

/// Whether the file may be written.
enum class Access : std::uint8_t {
  read,
  write,
  backup,   ///< as read, of a file that nobody writes: nothing is left beside it
  rebuild,  ///< as write, but cards that cannot be read are taken for none: rebuild() makes them anew
};

/// When the whole file is checked and today's backup is made. Both read the whole file.
enum class Upkeep : std::uint8_t {
  now,    ///< before the store is open
  later,  ///< by keep_up() (backups.h), on another thread
};

/// One learner's store learner.db: an append-only log of everything the learner did, and what follows from
/// it. SQLite in WAL mode with synchronous=FULL: what add_writing() has acknowledged is on disk, whatever
/// happens next. One store writes at a time; others may read. docs/study.md, docs/file-formats.md.
///
/// Thread-safe: no. Every function that writes takes a few milliseconds (it waits for the disk).
/// Errors of all functions: Errc::io where the disk is full or the folder read-only; Errc::in_use;
/// Errc::parse where the file is damaged.
class LearnerStore {
 public:
  /// Opens the learner's file.
  ///
  /// To write: makes file and folder where there are none; takes the lock beside it, which holds until the
  /// store is gone, however the program ends; brings a file of an older version to this one, after a backup;
  /// keeps one backup a day (backups.h).
  /// To read: the file is not changed; a learner who has no file yet is an empty one, and an older file is
  /// read through a temporary copy of this version.
  /// @return Errc::schema for a file that is no learner.db or was written by a newer Nazori; Errc::parse for
  /// a damaged one; Errc::io as above. Nothing is changed then.
  [[nodiscard]] static base::Result<LearnerStore> open(const std::filesystem::path& path, Access access,
                                                       Clock clock = system_now, Upkeep upkeep = Upkeep::now);
  /// A store that is gone with the object.
  [[nodiscard]] static base::Result<LearnerStore> in_memory(Clock clock = system_now);
  /// Whether a store that writes holds the file now. For the message after open() failed.
  [[nodiscard]] static bool in_use(const std::filesystem::path& path);

  LearnerStore(LearnerStore&&) noexcept;
  LearnerStore& operator=(LearnerStore&&) noexcept;
  ~LearnerStore();

  // Present
  [[nodiscard]] Time now() const;
  [[nodiscard]] Day today() const;
  [[nodiscard]] const Calendar& calendar() const;
  [[nodiscard]] const Settings& settings() const;
  /// Every character that was ever met.
  [[nodiscard]] const Cards& cards() const;
  /// The card of a character; a new one where it was never met.
  [[nodiscard]] Card card(char32_t character) const;
  /// Why today's backup could not be made, if it could not; the store works all the same.
  [[nodiscard]] const std::optional<base::Error>& backup_trouble() const;

  // What the learner does. Each is one action: durable when it returns, taken back whole by undo().
  /// A character was written, or watched. In the stage `memory` it is a review and schedules the character.
  /// @param strokes  of the character, >= 1.
  /// @return the card as it is now.
  [[nodiscard]] base::Result<Card> add_writing(char32_t character, int strokes, const Writing& writing,
                                               const Handwriting& ink = {});
  /// The card as it would be after a review with `rating` now, fuzz and load balance included; for
  /// "good: in 4 days" on a button.
  [[nodiscard]] base::Result<Card> preview(char32_t character, Rating rating) const;
  /// Takes back the last action that is still in force, but no change of settings. nullopt: there is none.
  [[nodiscard]] base::Result<std::optional<Undone>> undo();
  [[nodiscard]] base::Result<void> postpone(std::span<const char32_t> characters, Day until) {
    return act(characters, EntryKind::postpone, until);
  }
  [[nodiscard]] base::Result<void> pause(std::span<const char32_t> characters) {
    return act(characters, EntryKind::pause);
  }
  [[nodiscard]] base::Result<void> resume(std::span<const char32_t> characters) {
    return act(characters, EntryKind::resume);
  }
  [[nodiscard]] base::Result<void> reset(std::span<const char32_t> characters) {
    return act(characters, EntryKind::reset);
  }
  /// The special lesson of characters that were set apart is done.
  [[nodiscard]] base::Result<void> leech_met(std::span<const char32_t> characters) {
    return act(characters, EntryKind::leech_met);
  }
  /// @return Errc::bad_argument as check() says; Errc::cancelled, then they are as they were.
  [[nodiscard]] base::Result<void> change_settings(const Settings& settings,
                                                   const base::Progress& progress = {});

  // The log
  struct LoggedEntry {
    LogEntry entry;
    std::optional<PenMotion> motion;  ///< of the ink
    bool has_ink = false;
  };
  /// Hands every entry to `take`, in order; those that were undone too unless `in_force_only`. `take` returns
  /// false to stop.
  [[nodiscard]] base::Result<void> for_each_entry(bool in_force_only,
                                                  const std::function<bool(const LoggedEntry&)>& take) const;
  /// As for_each_entry() of all entries, each with its packed ink; empty where none was kept. The bytes are
  /// gone after the call.
  [[nodiscard]] base::Result<void> for_each_with_ink(
      const std::function<bool(const LoggedEntry&, std::span<const std::uint8_t> ink)>& take) const;
  // Sums of the log, kept with every entry: they cost the same with a short and a long history.
  /// Days with a writing in force, oldest first.
  [[nodiscard]] base::Result<std::vector<StudyDay>> study_days() const;
  /// Characters that were written from memory on a day, ascending.
  [[nodiscard]] base::Result<std::vector<char32_t>> reviewed_on(Day day) const;
  /// What the newest character days of an outcome took. @param most  of them; days counts all.
  [[nodiscard]] base::Result<OutcomeTimes> newest_times(DayOutcome outcome, int most) const;
  /// The writings of one character that are in force, oldest first.
  [[nodiscard]] base::Result<std::vector<LoggedEntry>> writings_of(char32_t character) const;
  /// The ink of an entry; empty where none was kept.
  [[nodiscard]] base::Result<Handwriting> ink_of(std::int64_t entry) const;
  /// Duration of the last ten accepted writings from memory.
  [[nodiscard]] base::Result<UsualWriting> usual_writing(char32_t character) const;
  [[nodiscard]] std::int64_t last_entry() const;  ///< id of the last entry, 0 for an empty log

  // Lists and tags. These are notes, not study: they are not in the log.
  [[nodiscard]] base::Result<std::vector<CustomList>> lists() const;  ///< by name
  /// Adds a list, or replaces the one of this name. @return Errc::bad_argument for a name that cannot be one.
  [[nodiscard]] base::Result<void> save_list(const CustomList& list);
  /// @return Errc::not_found
  [[nodiscard]] base::Result<void> remove_list(std::string_view name);
  [[nodiscard]] base::Result<std::vector<std::string>> tags_of(char32_t character) const;  ///< sorted
  /// All of them, each with its characters, sorted.
  [[nodiscard]] base::Result<std::map<std::string, std::vector<char32_t>>> tags() const;
  /// Replaces a character's tags. @return Errc::bad_argument for a text that can be no tag (as names of
  /// lists).
  [[nodiscard]] base::Result<void> set_tags(char32_t character, std::span<const std::string> tags);

  // The whole
  /// Works out every card anew from the log and puts it in the place of what was kept.
  [[nodiscard]] base::Result<RebuildReport> rebuild(const base::Progress& progress = {});
  /// Copies the whole store into a file, beside which it is written first.
  [[nodiscard]] base::Result<void> copy_to(const std::filesystem::path& file,
                                           const base::Progress& progress = {}) const;

  /// Takes everything of a learner, piece by piece; made by fill() and check_contents() only.
  class Filling;
  /// Hands everything of a learner to a Filling; what it fails with ends the filling.
  using Source = std::function<base::Result<void>(Filling& filling)>;
  /// Whether what `source` brings can fill an empty store. @return Errc::bad_argument where it does not fit
  /// together, or what `source` fails with.
  [[nodiscard]] static base::Result<void> check_contents(const Source& source);
  /// Fills an empty store. @param progress  of what follows after `source`. @return Errc::bad_argument where
  /// it is not empty, or as check_contents() says; Errc::cancelled. Nothing is changed then.
  [[nodiscard]] base::Result<void> fill(const Source& source, const base::Progress& progress = {});

 private:
  struct Inside;
  explicit LearnerStore(std::unique_ptr<Inside> inside);
  [[nodiscard]] base::Result<void> act(std::span<const char32_t> characters, EntryKind kind,
                                       std::optional<Day> until = std::nullopt);
  /// Every card as it follows from the log. `entries` counts them.
  struct Followed {
    Cards cards;
    int entries = 0;
  };
  [[nodiscard]] base::Result<Followed> follow_log(const base::Progress& progress) const;
  std::unique_ptr<Inside> inside_;
};

/// Whether a text can be the name of a list or a tag: 1..100 bytes of UTF-8 without control characters, not
/// beginning or ending with a space.
[[nodiscard]] bool can_be_name(std::string_view text);

}  // namespace nazori::study
