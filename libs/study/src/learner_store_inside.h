// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <limits>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "nazori/base/file_lock.h"
#include "nazori/study/learner_store.h"
#include "store_schema.h"

namespace nazori::study {

/// Settings, each with the entry from which on they apply, oldest first.
using SettingsTimeline = std::vector<std::pair<std::int64_t, Settings>>;

/// Walks through a timeline in parallel with the entries of the log.
class SettingsInForce {
 public:
  explicit SettingsInForce(const SettingsTimeline& timeline) : timeline_(timeline) {}

  /// Settings of the entry `id`, which must not be before that of the previous call. Settings passed on the
  /// way that lead to other numbers are applied to `history`.
  template <class History>
  const Settings& at(std::int64_t id, History& history) {
    for (; place_ + 1 < timeline_.size() && timeline_[place_ + 1].first < id; ++place_) {
      const Settings& next = timeline_[place_ + 1].second;
      if (changes_memory(timeline_[place_].second, next)) history.change_settings(next);
    }
    return timeline_[place_].second;
  }
  /// The rest of the timeline.
  template <class History>
  void finish(History& history) {
    (void)at(std::numeric_limits<std::int64_t>::max(), history);
  }

 private:
  const SettingsTimeline& timeline_;
  std::size_t place_ = 0;
};

struct LearnerStore::Inside {
  Inside(SQLite::Database opened, std::string file_name, Clock the_clock);

  base::FileLock lock;  // given back last
  SQLite::Database db;
  std::string name;
  Clock clock;
  Calendar calendar;
  SettingsTimeline timeline;  ///< never empty: the defaults come first
  std::unordered_set<std::int64_t> undone;
  Cards cards;
  std::int64_t last_id = 0;
  bool rebuilds = false;  ///< opened to be rebuilt
  std::optional<base::Error> backup_trouble;

  /// Reads timeline, undone actions, cards. @return Errc::parse for impossible data.
  [[nodiscard]] base::Result<void> load();
  [[nodiscard]] const Settings& settings() const { return timeline.back().second; }
  void load_calendar();

  /// Writings and other entries of one character, or of every one, that were not undone. Throws
  /// SQLite::Exception, also for an invalid row, because a card must not be computed without it. Of the days
  /// from `first` to `last`. @param writings  so many of them are writings: it ends with the last one.
  [[nodiscard]] std::vector<LoggedEntry> entries_of(std::optional<char32_t> character, Day first = kFirstDay,
                                                    Day last = kLastDay,
                                                    std::optional<std::int64_t> writings = std::nullopt);
  /// Computes the history of one character from its entries that were not undone.
  [[nodiscard]] CardHistory history_of(char32_t character, std::span<const LoggedEntry> entries) const;
  /// A new entry for an action at the present time.
  [[nodiscard]] LogEntry next_entry(EntryKind kind) const;
  /// The result of a review; where intervals may vary, with the varied interval.
  struct Outlook {
    Card card;
    std::optional<int> interval_days;  ///< for the log: set if it is moved within its range
  };
  [[nodiscard]] Outlook outlook(char32_t character, Rating rating, Stage stage);
  /// Computes the card and the study days of one character again and stores them in their tables; updating
  /// the map is up to the caller.
  [[nodiscard]] std::optional<Card> refresh_row(char32_t character);
  /// Adds entries that mark characters as known, from `next` on, which then is the one after them.
  void add_known(std::span<const KnownCharacter> known, LogEntry& next, Cards& changed);
  /// Removes the list that was made with choices, if it is as it was made and not chosen otherwise.
  /// @return the entries of the action whose settings apply no more.
  [[nodiscard]] std::vector<std::int64_t> undo_choices(std::int64_t action);
  /// Runs `work`, which throws SQLite::Exception, and converts the exception to an error.
  template <class Work>
  auto guarded(Work work) const -> decltype(work()) {
    try {
      return work();
    } catch (const SQLite::Exception& trouble) {
      return tl::unexpected(error_of(trouble, name));
    }
  }
  /// Adds one entry for each character as one action and refreshes their cards.
  [[nodiscard]] base::Result<void> act(std::span<const char32_t> characters, LogEntry entry,
                                       const Handwriting* ink);
};

// Rows. All throw SQLite::Exception.
/// The columns of the log as read_entry() expects them: SELECT log_columns FROM log.
extern const char* const log_columns;
/// @return nullopt for a row that this version never writes.
[[nodiscard]] std::optional<LearnerStore::LoggedEntry> read_entry(SQLite::Statement& row);
/// Adds entries to the log; its statements are prepared once for all of them.
class LogWriter {
 public:
  explicit LogWriter(SQLite::Database& db);
  void add(const LogEntry& entry, const std::optional<PenMotion>& motion = std::nullopt,
           std::span<const std::uint8_t> packed_ink = {});

 private:
  SQLite::Statement entry_;
  SQLite::Statement ink_;
};
[[nodiscard]] std::optional<Cards> read_cards(SQLite::Database& db);
void put_list(SQLite::Database& db, const CustomList& list);
void delete_list(SQLite::Database& db, const std::string& name);
void put_tag(SQLite::Database& db, char32_t character, const std::string& tag);
void put_card(SQLite::Database& db, const Card& card);
void delete_card(SQLite::Database& db, char32_t character);
/// Whether entries of a kind are about a character.
[[nodiscard]] bool names_a_character(EntryKind kind);
/// Whether entries of a kind hold settings that apply from there on.
[[nodiscard]] bool has_settings(EntryKind kind);
/// Errc::bad_argument for a writing that must not be logged.
[[nodiscard]] base::Result<void> check_writing(char32_t character, int strokes, const Writing& writing);

}  // namespace nazori::study
