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

/// One of the learner's own lists of characters.
struct CustomList {
  std::string name;  ///< 1..100 bytes of UTF-8 without control characters
  std::vector<char32_t> characters;

  friend bool operator==(const CustomList&, const CustomList&) = default;
};

/// Cards by character.
using Cards = std::map<char32_t, Card>;

/// What rebuilding found.
struct RebuildReport {
  int entries = 0;      ///< in the log
  int cards = 0;        ///< cards of all characters with an action that was not undone
  int studied = 0;      ///< of these: written or watched, and not reset since
  int differences = 0;  ///< stored cards that differed from those computed from the log
};

/// The undone action.
struct Undone {
  EntryKind kind = EntryKind::writing;
  std::vector<char32_t> characters;  ///< it was about, ascending
};

/// A character that the learner knows without having written it here.
struct KnownCharacter {
  char32_t character = 0;
  std::optional<Day> due;  ///< of its first review; nullopt: as after a review rated Easy

  friend bool operator==(const KnownCharacter&, const KnownCharacter&) = default;
};

/// What a learner chose to learn, and what is known already.
struct StudyChoices {
  Settings settings;               ///< from now on
  std::optional<CustomList> list;  ///< a list made for it, whose name is not taken yet
  std::vector<KnownCharacter> known;
};

/// Whether the file may be written.
enum class Access : std::uint8_t {
  read,
  write,
  backup,   ///< as read, for a file that nothing writes: creates no other files
  rebuild,  ///< as write, but unreadable cards are ignored: rebuild() computes them again
};

/// When to check the whole file and make today's backup. Both read the whole file.
enum class Upkeep : std::uint8_t {
  now,    ///< before the store opens
  later,  ///< by keep_up() (backups.h), on another thread
};

/// One learner's store learner.db: an append-only log of everything the learner did, and data computed from
/// it. SQLite in WAL mode with synchronous=FULL: when add_writing() returns, the writing is on disk, whatever
/// happens next. One store writes at a time; others may read. docs/study.md, docs/file-formats.md.
///
/// Thread-safe: no. Every function that writes takes a few milliseconds (it waits for the disk). Errors of
/// all functions: Errc::io where the disk is full or the folder read-only; Errc::in_use; Errc::parse where
/// the file is damaged.
class LearnerStore {
 public:
  /// Opens the learner's file.
  ///
  /// For writing: makes the file and the folder if needed; locks the lock file in the same folder until the
  /// store is destroyed, however the program ends; upgrades an older file after a backup; makes one backup
  /// per day (backups.h). For reading: the file is not changed; a learner without a file is empty, and an
  /// older file is read through an upgraded temporary copy.
  /// @return Errc::schema for a file that is not a learner.db or was written by a newer Nazori; Errc::parse
  /// for a damaged one; Errc::io as above. On an error nothing is changed.
  [[nodiscard]] static base::Result<LearnerStore> open(const std::filesystem::path& path, Access access,
                                                       Clock clock = system_now, Upkeep upkeep = Upkeep::now);
  /// A store in memory.
  [[nodiscard]] static base::Result<LearnerStore> in_memory(Clock clock = system_now);
  /// Whether a store has the file open for writing. For the message after open() failed.
  [[nodiscard]] static bool in_use(const std::filesystem::path& path);

  LearnerStore(LearnerStore&&) noexcept;
  LearnerStore& operator=(LearnerStore&&) noexcept;
  ~LearnerStore();

  // Present
  [[nodiscard]] Time now() const;
  [[nodiscard]] Day today() const;
  [[nodiscard]] const Calendar& calendar() const;
  [[nodiscard]] const Settings& settings() const;
  /// The cards of all characters that were ever studied.
  [[nodiscard]] const Cards& cards() const;
  /// The card of a character; a new one if it was never studied.
  [[nodiscard]] Card card(char32_t character) const;
  /// Why today's backup could not be made, if it failed; the store works nevertheless.
  [[nodiscard]] const std::optional<base::Error>& backup_trouble() const;

  // The learner's actions. Each one is durable when it returns, and undo() undoes it completely.
  /// A character was written, or watched. In the stages `memory` and `brush` it is a review and schedules the
  /// character, each by itself.
  /// @param strokes  of the character, >= 1.
  /// @return the card as it is now.
  [[nodiscard]] base::Result<Card> add_writing(char32_t character, int strokes, const Writing& writing,
                                               const Handwriting& ink = {});
  /// The card as it would be after a review with `rating` now, including fuzz and load balance; for "Good: in
  /// 4 days" on a button. @param stage  `memory` or `brush`.
  [[nodiscard]] base::Result<Card> preview(char32_t character, Rating rating,
                                           Stage stage = Stage::memory) const;
  /// Undoes the last action that is not undone yet and is not a change of settings alone. nullopt: there is
  /// none.
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
  /// Difficult characters were relearned.
  [[nodiscard]] base::Result<void> leech_met(std::span<const char32_t> characters) {
    return act(characters, EntryKind::leech_met);
  }
  /// Characters are known: each is reviewed from memory later, resumed if it was suspended, and no longer
  /// difficult. That does not count as a writing of this day.
  [[nodiscard]] base::Result<void> know(std::span<const KnownCharacter> known);
  /// All of it as one action, or nothing. undo() also brings back the settings of before and removes the list
  /// unless it was changed or is chosen meanwhile.
  /// @return Errc::bad_argument as check(), for a list whose name is taken or invalid, and for settings that
  /// change intervals or days.
  [[nodiscard]] base::Result<void> choose(const StudyChoices& choices);
  /// @return Errc::bad_argument as check(); Errc::cancelled, then the settings are unchanged.
  [[nodiscard]] base::Result<void> change_settings(const Settings& settings,
                                                   const base::Progress& progress = {});

  // The log
  struct LoggedEntry {
    LogEntry entry;
    std::optional<PenMotion> motion;  ///< of the ink
    bool has_ink = false;
  };
  /// Passes every entry to `take`, in order; also undone ones unless `in_force_only`. `take` returns false to
  /// stop.
  [[nodiscard]] base::Result<void> for_each_entry(bool in_force_only,
                                                  const std::function<bool(const LoggedEntry&)>& take) const;
  /// As for_each_entry() of all entries, each with its packed ink; empty where none was saved. The bytes are
  /// valid only during the call.
  [[nodiscard]] base::Result<void> for_each_with_ink(
      const std::function<bool(const LoggedEntry&, std::span<const std::uint8_t> ink)>& take) const;
  // Sums of the log, updated with every entry, so that their cost does not depend on the length of the
  // history.
  /// Days with a writing that was not undone, oldest first.
  [[nodiscard]] base::Result<std::vector<StudyDay>> study_days() const;
  /// How long the writings of a day took, in every stage but `brush`.
  [[nodiscard]] base::Result<std::chrono::milliseconds> time_on(Day day) const;
  /// Characters that were written from memory on a day, ascending.
  [[nodiscard]] base::Result<std::vector<char32_t>> reviewed_on(Day day) const;
  /// Characters whose first review of a day failed, with the number of such days from `first` on.
  [[nodiscard]] base::Result<std::map<char32_t, int>> failed_days(Day first) const;
  /// Characters that were written for the first time on a day, ascending.
  [[nodiscard]] base::Result<std::vector<char32_t>> introduced_on(Day day) const;
  /// Durations of the newest character days with an outcome. @param most  maximum number of durations; `days`
  /// counts all.
  [[nodiscard]] base::Result<OutcomeTimes> newest_times(DayOutcome outcome, int most) const;
  /// The writings of one character that were not undone, oldest first.
  [[nodiscard]] base::Result<std::vector<LoggedEntry>> writings_of(char32_t character) const;
  /// Those of the days from `first` to `last`.
  [[nodiscard]] base::Result<std::vector<LoggedEntry>> writings_of(char32_t character, Day first,
                                                                   Day last) const;
  /// The writings of every character on the days from `first` to `last` that were not undone, oldest first.
  /// The cost grows with the entries since `first`, not with the history before it.
  [[nodiscard]] base::Result<std::vector<LoggedEntry>> writings_on(Day first, Day last) const;
  /// The ink of an entry; empty where none was saved.
  [[nodiscard]] base::Result<Handwriting> ink_of(std::int64_t entry) const;
  /// Duration of the last ten accepted writings from memory.
  [[nodiscard]] base::Result<UsualWriting> usual_writing(char32_t character) const;
  [[nodiscard]] std::int64_t last_entry() const;  ///< id of the last entry, 0 for an empty log

  // Lists and tags. These are notes, not study: they are not in the log.
  [[nodiscard]] base::Result<std::vector<CustomList>> lists() const;  ///< by name
  /// Adds a list, or replaces the one of this name. @return Errc::bad_argument for an invalid name.
  [[nodiscard]] base::Result<void> save_list(const CustomList& list);
  /// @return Errc::not_found
  [[nodiscard]] base::Result<void> remove_list(std::string_view name);
  [[nodiscard]] base::Result<std::vector<std::string>> tags_of(char32_t character) const;  ///< sorted
  /// All of them, each with its characters, sorted.
  [[nodiscard]] base::Result<std::map<std::string, std::vector<char32_t>>> tags() const;
  /// Replaces a character's tags. @return Errc::bad_argument for an invalid tag (the rules are those of list
  /// names).
  [[nodiscard]] base::Result<void> set_tags(char32_t character, std::span<const std::string> tags);

  // The whole
  /// Computes every card again from the log and replaces the stored ones.
  [[nodiscard]] base::Result<RebuildReport> rebuild(const base::Progress& progress = {});
  /// Copies the whole store into a file, which is first written under a temporary name.
  [[nodiscard]] base::Result<void> copy_to(const std::filesystem::path& file,
                                           const base::Progress& progress = {}) const;

  /// Receives all data of a learner, piece by piece; made by fill() and check_contents() only.
  class Filling;
  /// Passes all data of a learner to a Filling; an error ends the filling.
  using Source = std::function<base::Result<void>(Filling& filling)>;
  /// Checks whether the data of `source` can fill an empty store. @return Errc::bad_argument where the data
  /// are inconsistent; the errors of `source`.
  [[nodiscard]] static base::Result<void> check_contents(const Source& source);
  /// Fills an empty store. @param progress  of the work after `source`. @return Errc::bad_argument where the
  /// store is not empty, or as check_contents(); Errc::cancelled. On an error nothing is changed.
  [[nodiscard]] base::Result<void> fill(const Source& source, const base::Progress& progress = {});

 private:
  struct Inside;
  explicit LearnerStore(std::unique_ptr<Inside> inside);
  [[nodiscard]] base::Result<void> act(std::span<const char32_t> characters, EntryKind kind,
                                       std::optional<Day> until = std::nullopt);
  /// Every card as computed from the log. `entries` counts the entries.
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
