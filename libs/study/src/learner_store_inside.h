// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <limits>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "file_lock.h"
#include "nazori/study/learner_store.h"
#include "store_schema.h"

namespace nazori::study {

/// Settings and the entry from which on they are in force, oldest first.
using SettingsTimeline = std::vector<std::pair<std::int64_t, Settings>>;

/// Goes through a timeline beside the entries of the log.
class SettingsInForce {
 public:
  explicit SettingsInForce(const SettingsTimeline& timeline) : timeline_(timeline) {}

  /// Settings of the entry `id`, which must not be before the last one asked for. Those on the way that lead
  /// to other numbers are handed to `history`.
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

  FileLock lock;  // given back last
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

  /// Reads timeline, undone actions, cards. @return Errc::parse for what cannot be.
  [[nodiscard]] base::Result<void> load();
  [[nodiscard]] const Settings& settings() const { return timeline.back().second; }
  void take_calendar();

  /// Writings and other entries of one character that are in force. Throws SQLite::Exception, also for a row
  /// that cannot be: a card must not be worked out without it.
  [[nodiscard]] std::vector<LoggedEntry> entries_of(char32_t character);
  /// Follows one character through its entries in force.
  [[nodiscard]] CardHistory history_of(char32_t character, std::span<const LoggedEntry> entries) const;
  /// The entry of an action that is about to happen, with the time of now.
  [[nodiscard]] LogEntry next_entry(EntryKind kind) const;
  /// What a review would lead to, where intervals may vary with the interval that it would be given.
  struct Outlook {
    Card card;
    std::optional<int> interval_days;  ///< for the log: where it is moved within its range
  };
  [[nodiscard]] Outlook outlook(char32_t character, Rating rating);
  /// Works out the card and the study days of one character again and keeps them in their tables; the map is
  /// the caller's.
  [[nodiscard]] std::optional<Card> refresh_row(char32_t character);
  /// Runs `work`, which throws SQLite::Exception, and turns that into an error.
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
/// The columns of the log as read_entry() wants them: SELECT log_columns FROM log.
extern const char* const log_columns;
/// @return nullopt for a row that no program of this version writes.
[[nodiscard]] std::optional<LearnerStore::LoggedEntry> read_entry(SQLite::Statement& row);
/// Adds entries to the log; its statements are made once for all of them.
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
void put_tag(SQLite::Database& db, char32_t character, const std::string& tag);
void put_card(SQLite::Database& db, const Card& card);
/// Whether entries of a kind are about a character.
[[nodiscard]] bool names_a_character(EntryKind kind);
/// Errc::bad_argument where a writing is not one that may be logged.
[[nodiscard]] base::Result<void> check_writing(char32_t character, int strokes, const Writing& writing);

}  // namespace nazori::study
