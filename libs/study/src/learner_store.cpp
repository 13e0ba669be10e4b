// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/learner_store.h"

#include <fmt/format.h>

#include <algorithm>

#include "learner_store_inside.h"
#include "times_as_numbers.h"

namespace nazori::study {
namespace {

constexpr int kUsualOf = 10;

tl::unexpected<base::Error> damaged_entry(std::int64_t id, const std::string& file) {
  return base::fail(base::Errc::parse, fmt::format("is damaged: entry {} cannot be", id), file,
                    "take a backup: nazori-cli study restore");
}

std::vector<LearnerStore::LoggedEntry> only_writings(std::vector<LearnerStore::LoggedEntry> entries) {
  std::erase_if(entries,
                [](const LearnerStore::LoggedEntry& one) { return one.entry.kind != EntryKind::writing; });
  return entries;
}

/// The days are counted already, so a search can end with their last writing. @param count  takes the days as
/// its first two values.
std::int64_t writings_counted(SQLite::Statement& count, Day first, Day last) {
  count.bind(1, number_of(first));
  count.bind(2, number_of(last));
  return count.executeStep() ? count.getColumn(0).getInt64() : 0;
}

std::span<const std::uint8_t> bytes_of(const SQLite::Column& column) {
  return {static_cast<const std::uint8_t*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

}  // namespace

LearnerStore::LearnerStore(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
LearnerStore::LearnerStore(LearnerStore&&) noexcept = default;
LearnerStore& LearnerStore::operator=(LearnerStore&&) noexcept = default;
LearnerStore::~LearnerStore() = default;

Time LearnerStore::now() const { return inside_->clock(); }
Day LearnerStore::today() const { return inside_->calendar.day_of(now()); }
const Calendar& LearnerStore::calendar() const { return inside_->calendar; }
const Settings& LearnerStore::settings() const { return inside_->settings(); }
const Cards& LearnerStore::cards() const { return inside_->cards; }
std::int64_t LearnerStore::last_entry() const { return inside_->last_id; }
const std::optional<base::Error>& LearnerStore::backup_trouble() const { return inside_->backup_trouble; }

Card LearnerStore::card(char32_t character) const {
  const auto found = inside_->cards.find(character);
  if (found != inside_->cards.end()) return found->second;
  Card card;
  card.character = character;
  return card;
}

base::Result<std::vector<LearnerStore::LoggedEntry>> LearnerStore::writings_of(char32_t character) const {
  return writings_of(character, kFirstDay, kLastDay);
}

base::Result<std::vector<LearnerStore::LoggedEntry>> LearnerStore::writings_of(char32_t character, Day first,
                                                                               Day last) const {
  return inside_->guarded([&]() -> base::Result<std::vector<LoggedEntry>> {
    // The newest come first: most questions are about the last days of a long history.
    SQLite::Statement count(
        inside_->db,
        "SELECT coalesce(sum(writings), 0) FROM character_day WHERE day BETWEEN ? AND ? AND character = ?");
    count.bind(3, static_cast<std::int64_t>(character));
    return only_writings(inside_->entries_of(character, first, last, writings_counted(count, first, last)));
  });
}

base::Result<std::vector<LearnerStore::LoggedEntry>> LearnerStore::writings_on(Day first, Day last) const {
  return inside_->guarded([&]() -> base::Result<std::vector<LoggedEntry>> {
    SQLite::Statement count(inside_->db,
                            "SELECT coalesce(sum(writings), 0) FROM study_day WHERE day BETWEEN ? AND ?");
    return only_writings(inside_->entries_of({}, first, last, writings_counted(count, first, last)));
  });
}

base::Result<Handwriting> LearnerStore::ink_of(std::int64_t entry) const {
  return inside_->guarded([&]() -> base::Result<Handwriting> {
    SQLite::Statement row(inside_->db, "SELECT packed FROM ink WHERE entry = ?");
    row.bind(1, entry);
    if (!row.executeStep()) return Handwriting{};
    return unpack_handwriting(bytes_of(row.getColumn(0)));
  });
}

base::Result<UsualWriting> LearnerStore::usual_writing(char32_t character) const {
  const auto writings = writings_of(character);
  if (!writings) return tl::unexpected(writings.error());
  std::vector<std::chrono::milliseconds> durations;
  for (auto one = writings->rbegin(); one != writings->rend() && durations.size() < kUsualOf; ++one) {
    const Writing& writing = one->entry.writing;
    if (writing.stage == Stage::memory && writing.result.accepted && writing.result.duration.count() > 0) {
      durations.push_back(writing.result.duration);
    }
  }
  if (durations.empty()) return UsualWriting{};
  const auto middle = durations.begin() + static_cast<std::ptrdiff_t>(durations.size() / 2);
  std::nth_element(durations.begin(), middle, durations.end());
  return UsualWriting{*middle, static_cast<int>(durations.size())};
}

base::Result<void> LearnerStore::for_each_entry(bool in_force_only,
                                                const std::function<bool(const LoggedEntry&)>& take) const {
  return inside_->guarded([&]() -> base::Result<void> {
    SQLite::Statement rows(inside_->db, fmt::format("SELECT {} FROM log ORDER BY id", log_columns));
    while (rows.executeStep()) {
      const auto entry = read_entry(rows);
      if (!entry) return damaged_entry(rows.getColumn(0).getInt64(), inside_->name);
      if (in_force_only && inside_->undone.contains(entry->entry.action)) continue;
      if (!take(*entry)) break;
    }
    return {};
  });
}

base::Result<void> LearnerStore::for_each_with_ink(
    const std::function<bool(const LoggedEntry&, std::span<const std::uint8_t> ink)>& take) const {
  return inside_->guarded([&]() -> base::Result<void> {
    SQLite::Statement rows(
        inside_->db,
        fmt::format("SELECT {}, (SELECT packed FROM ink WHERE entry = log.id) FROM log ORDER BY id",
                    log_columns));
    const int ink = rows.getColumnCount() - 1;
    while (rows.executeStep()) {
      const auto entry = read_entry(rows);
      if (!entry) return damaged_entry(rows.getColumn(0).getInt64(), inside_->name);
      if (!take(*entry, bytes_of(rows.getColumn(ink)))) break;
    }
    return {};
  });
}

}  // namespace nazori::study
