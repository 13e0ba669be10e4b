// SPDX-License-Identifier: Apache-2.0
#include "store_days.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "learner_store_inside.h"
#include "times_as_numbers.h"

namespace nazori::study {
namespace {

using std::chrono::milliseconds;

/// Writes rows of character_day.
class RowWriter {
 public:
  explicit RowWriter(SQLite::Database& db)
      : put_(db, "INSERT OR REPLACE INTO character_day VALUES(?, ?, ?, ?, ?, ?, ?)") {}

  void put(char32_t character, std::size_t number, const CharacterDay& day) {
    put_.reset();
    put_.clearBindings();
    put_.bind(1, static_cast<std::int64_t>(character));
    put_.bind(2, static_cast<std::int64_t>(number));
    put_.bind(3, number_of(day.day));
    if (day.outcome) put_.bind(4, static_cast<int>(*day.outcome));
    put_.bind(5, static_cast<std::int64_t>(day.time.count()));
    put_.bind(6, day.writings);
    put_.bind(7, day.reviews);
    put_.exec();
  }

 private:
  SQLite::Statement put_;
};

std::vector<CharacterDay> read_character_days(SQLite::Database& db, char32_t character) {
  SQLite::Statement rows(db,
                         "SELECT day, outcome, time_ms, writings, reviews FROM character_day WHERE character "
                         "= ? ORDER BY number");
  rows.bind(1, static_cast<std::int64_t>(character));
  std::vector<CharacterDay> days;
  while (rows.executeStep()) {
    CharacterDay day;
    day.day = day_of(rows.getColumn(0).getInt64());
    if (!rows.getColumn(1).isNull()) day.outcome = static_cast<DayOutcome>(rows.getColumn(1).getInt());
    day.time = milliseconds(rows.getColumn(2).getInt64());
    day.writings = rows.getColumn(3).getInt();
    day.reviews = rows.getColumn(4).getInt();
    days.push_back(day);
  }
  return days;
}

/// The values of one row of study_day, from the rows of character_day.
constexpr const char* kSums =
    "day, sum(writings), sum(reviews), sum(outcome IS 0 AND time_ms > 0), sum(outcome IS 1 AND time_ms > 0), "
    "sum(outcome IS 2 AND time_ms > 0)";

void add_up(SQLite::Database& db, const std::set<Day>& days) {
  SQLite::Statement remove(db, "DELETE FROM study_day WHERE day = ?");
  SQLite::Statement add(
      db,
      fmt::format("INSERT INTO study_day SELECT {} FROM character_day WHERE day = ? GROUP BY day", kSums));
  for (const Day day : days) {
    for (SQLite::Statement* statement : {&remove, &add}) {
      statement->reset();
      statement->bind(1, number_of(day));
      statement->exec();
    }
  }
}

}  // namespace

void put_character_days(SQLite::Database& db, char32_t character, std::span<const CharacterDay> days) {
  const std::vector<CharacterDay> kept = read_character_days(db, character);
  std::set<Day> changed;
  RowWriter rows(db);
  for (std::size_t i = 0; i < days.size(); ++i) {
    if (i < kept.size() && kept[i] == days[i]) continue;
    rows.put(character, i, days[i]);
    changed.insert(days[i].day);
    if (i < kept.size()) changed.insert(kept[i].day);
  }
  if (kept.size() > days.size()) {
    SQLite::Statement remove(db, "DELETE FROM character_day WHERE character = ? AND number >= ?");
    remove.bind(1, static_cast<std::int64_t>(character));
    remove.bind(2, static_cast<std::int64_t>(days.size()));
    remove.exec();
    for (std::size_t i = days.size(); i < kept.size(); ++i) changed.insert(kept[i].day);
  }
  add_up(db, changed);
}

void rebuild_days(SQLite::Database& db) {
  db.exec("DELETE FROM character_day; DELETE FROM study_day");
  std::map<char32_t, CharacterDays> all;
  SQLite::Statement log(db,
                        "SELECT character, kind, day, coalesce(stage, 0), coalesce(rating, 1), "
                        "coalesce(duration_ms, 0) FROM log "
                        "WHERE kind IN (?, ?, ?) AND character IS NOT NULL "
                        "AND action NOT IN (SELECT undoes FROM log WHERE undoes IS NOT NULL) ORDER BY id");
  log.bind(1, static_cast<int>(EntryKind::writing));
  log.bind(2, static_cast<int>(EntryKind::reset));
  log.bind(3, static_cast<int>(EntryKind::known));
  while (log.executeStep()) {
    LogEntry entry;
    entry.character = static_cast<char32_t>(log.getColumn(0).getInt64());
    entry.kind = static_cast<EntryKind>(log.getColumn(1).getInt());
    entry.day = day_of(log.getColumn(2).getInt64());
    entry.writing.stage = static_cast<Stage>(log.getColumn(3).getInt());
    entry.writing.rating = static_cast<Rating>(log.getColumn(4).getInt());
    entry.writing.result.duration = milliseconds(log.getColumn(5).getInt64());
    all[entry.character].take(entry);
  }
  RowWriter rows(db);
  for (const auto& [character, history] : all) {
    for (std::size_t i = 0; i < history.days().size(); ++i) rows.put(character, i, history.days()[i]);
  }
  db.exec(fmt::format("INSERT INTO study_day SELECT {} FROM character_day GROUP BY day", kSums));
}

base::Result<std::vector<StudyDay>> LearnerStore::study_days() const {
  return inside_->guarded([&]() -> base::Result<std::vector<StudyDay>> {
    SQLite::Statement rows(inside_->db,
                           "SELECT day, writings, reviews, introduced FROM study_day ORDER BY day");
    std::vector<StudyDay> days;
    while (rows.executeStep()) {
      days.push_back({day_of(rows.getColumn(0).getInt64()), rows.getColumn(1).getInt(),
                      rows.getColumn(2).getInt(), rows.getColumn(3).getInt()});
    }
    return days;
  });
}

base::Result<milliseconds> LearnerStore::time_on(Day day) const {
  return inside_->guarded([&]() -> base::Result<milliseconds> {
    SQLite::Statement sum(inside_->db, "SELECT coalesce(sum(time_ms), 0) FROM character_day WHERE day = ?");
    sum.bind(1, number_of(day));
    return milliseconds(sum.executeStep() ? sum.getColumn(0).getInt64() : 0);
  });
}

base::Result<std::vector<char32_t>> LearnerStore::reviewed_on(Day day) const {
  return inside_->guarded([&]() -> base::Result<std::vector<char32_t>> {
    SQLite::Statement rows(inside_->db,
                           "SELECT DISTINCT character FROM character_day WHERE day = ? AND reviews > 0 "
                           "ORDER BY character");
    rows.bind(1, number_of(day));
    std::vector<char32_t> characters;
    while (rows.executeStep()) characters.push_back(static_cast<char32_t>(rows.getColumn(0).getInt64()));
    return characters;
  });
}

base::Result<std::map<char32_t, int>> LearnerStore::failed_days(Day first) const {
  return inside_->guarded([&]() -> base::Result<std::map<char32_t, int>> {
    // The plus keeps SQLite from reading all days in the order of the characters.
    SQLite::Statement rows(inside_->db,
                           "SELECT character, count(DISTINCT day) FROM character_day WHERE day >= ? AND "
                           "outcome = ? GROUP BY +character");
    rows.bind(1, number_of(first));
    rows.bind(2, static_cast<int>(DayOutcome::failed));
    std::map<char32_t, int> days;
    while (rows.executeStep())
      days.emplace(static_cast<char32_t>(rows.getColumn(0).getInt64()), rows.getColumn(1).getInt());
    return days;
  });
}

base::Result<std::vector<char32_t>> LearnerStore::introduced_on(Day day) const {
  return inside_->guarded([&]() -> base::Result<std::vector<char32_t>> {
    SQLite::Statement rows(inside_->db,
                           "SELECT DISTINCT character FROM character_day WHERE day = ? AND outcome = ? "
                           "ORDER BY character");
    rows.bind(1, number_of(day));
    rows.bind(2, static_cast<int>(DayOutcome::introduced));
    std::vector<char32_t> characters;
    while (rows.executeStep()) characters.push_back(static_cast<char32_t>(rows.getColumn(0).getInt64()));
    return characters;
  });
}

base::Result<OutcomeTimes> LearnerStore::newest_times(DayOutcome outcome, int most) const {
  return inside_->guarded([&]() -> base::Result<OutcomeTimes> {
    OutcomeTimes times;
    SQLite::Statement rows(inside_->db,
                           "SELECT time_ms FROM character_day WHERE outcome = ? AND time_ms > 0 "
                           "ORDER BY day DESC, character, number LIMIT ?");
    rows.bind(1, static_cast<int>(outcome));
    rows.bind(2, most);
    while (rows.executeStep()) times.newest.emplace_back(rows.getColumn(0).getInt64());
    SQLite::Statement count(
        inside_->db,
        "SELECT coalesce(sum(CASE ? WHEN 0 THEN recalled WHEN 1 THEN failed ELSE introduced "
        "END), 0) FROM study_day");
    count.bind(1, static_cast<int>(outcome));
    if (count.executeStep()) times.days = count.getColumn(0).getInt();
    return times;
  });
}

}  // namespace nazori::study
