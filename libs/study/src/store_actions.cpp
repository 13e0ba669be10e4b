// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>

#include "interval_choice.h"
#include "learner_store_inside.h"
#include "store_days.h"
#include "times_as_numbers.h"

namespace nazori::study {

std::vector<LearnerStore::LoggedEntry> LearnerStore::Inside::entries_of(
    std::optional<char32_t> character, Day first, Day last, std::optional<std::int64_t> writings) {
  SQLite::Statement rows(db, fmt::format("SELECT {} FROM log WHERE day BETWEEN ? AND ? {} ORDER BY id DESC",
                                         log_columns, character ? "AND character = ?" : ""));
  rows.bind(1, number_of(first));
  rows.bind(2, number_of(last));
  if (character) rows.bind(3, static_cast<std::int64_t>(*character));
  std::vector<LoggedEntry> entries;
  while (writings != 0 && rows.executeStep()) {
    auto entry = read_entry(rows);
    if (!entry) {
      throw SQLite::Exception(fmt::format("entry {} cannot be", rows.getColumn(0).getInt64()),
                              SQLITE_CORRUPT);
    }
    if (undone.contains(entry->entry.action)) continue;
    if (writings && entry->entry.kind == EntryKind::writing) --*writings;
    entries.push_back(*std::move(entry));
  }
  std::reverse(entries.begin(), entries.end());
  return entries;
}

CardHistory LearnerStore::Inside::history_of(char32_t character, std::span<const LoggedEntry> entries) const {
  CardHistory history(character);
  SettingsInForce in_force(timeline);
  for (const LoggedEntry& logged : entries) {
    const Settings& settings_then = in_force.at(logged.entry.id, history);
    history.apply(logged.entry, settings_then);
  }
  in_force.finish(history);
  return history;
}

LearnerStore::Inside::Outlook LearnerStore::Inside::outlook(char32_t character, Rating rating, Stage stage) {
  const CardHistory before = history_of(character, entries_of(character));
  LogEntry entry;
  entry.at = clock();
  entry.day = calendar.day_of(entry.at);
  entry.character = character;
  entry.writing.stage = stage;
  entry.writing.rating = rating;
  entry.writing.result.accepted = rating != Rating::again;
  CardHistory as_scheduled = before;
  as_scheduled.apply(entry, settings());
  if (stage != Stage::memory) return {as_scheduled.card(), std::nullopt};
  const std::optional<Day>& last = before.card().last_day;
  const int elapsed = last ? std::max(0, static_cast<int>((entry.day - *last).count())) : 0;
  if (const auto fsrs = Fsrs::create(settings().fsrs)) {
    entry.interval_days =
        choose_interval(*fsrs, settings(), cards, character, as_scheduled.card().memory, elapsed, entry.day);
  }
  if (!entry.interval_days) return {as_scheduled.card(), std::nullopt};
  CardHistory as_moved = before;
  as_moved.apply(entry, settings());
  return {as_moved.card(), entry.interval_days};
}

LogEntry LearnerStore::Inside::next_entry(EntryKind kind) const {
  LogEntry entry;
  entry.id = last_id + 1;
  entry.action = entry.id;
  entry.at = clock();
  entry.day = calendar.day_of(entry.at);
  entry.kind = kind;
  return entry;
}

std::optional<Card> LearnerStore::Inside::refresh_row(char32_t character) {
  const std::vector<LoggedEntry> entries = entries_of(character);
  CharacterDays days;
  for (const LoggedEntry& logged : entries) days.take(logged.entry);
  put_character_days(db, character, days.days());
  const CardHistory history = history_of(character, entries);
  if (history.met()) {
    put_card(db, history.card());
    return history.card();
  }
  delete_card(db, character);
  return std::nullopt;
}

base::Result<void> LearnerStore::Inside::act(std::span<const char32_t> characters, LogEntry entry,
                                             const Handwriting* ink) {
  std::vector<std::uint8_t> packed;
  std::optional<PenMotion> motion;
  if (ink != nullptr) {
    auto bytes = pack(*ink);
    if (!bytes) return tl::unexpected(std::move(bytes.error()));
    packed = *std::move(bytes);
    motion = motion_of(*ink);
  }
  entry.at = clock();
  entry.day = calendar.day_of(entry.at);
  entry.action = last_id + 1;
  return guarded([&]() -> base::Result<void> {
    std::vector<Card> changed;
    SQLite::Transaction transaction(db, SQLite::TransactionBehavior::IMMEDIATE);
    LogWriter log(db);
    std::int64_t id = last_id;
    for (const char32_t character : characters) {
      entry.id = ++id;
      entry.character = character;
      log.add(entry, motion, packed);
      if (auto card = refresh_row(character)) changed.push_back(*card);
    }
    transaction.commit();
    last_id = id;
    for (const Card& card : changed) cards[card.character] = card;
    return {};
  });
}

base::Result<Card> LearnerStore::add_writing(char32_t character, int strokes, const Writing& writing,
                                             const Handwriting& ink) {
  if (auto fine = check_writing(character, strokes, writing); !fine) {
    return tl::unexpected(std::move(fine.error()));
  }
  LogEntry entry;
  entry.kind = EntryKind::writing;
  entry.writing = writing;
  entry.strokes = strokes;
  if (writing.stage == Stage::memory) {
    auto interval = inside_->guarded([&]() -> base::Result<std::optional<int>> {
      return inside_->outlook(character, writing.rating, Stage::memory).interval_days;
    });
    if (!interval) return tl::unexpected(std::move(interval.error()));
    entry.interval_days = *interval;
  }
  if (auto done = inside_->act(std::span(&character, 1), entry, &ink); !done) {
    return tl::unexpected(std::move(done.error()));
  }
  return card(character);
}

base::Result<void> LearnerStore::act(std::span<const char32_t> characters, EntryKind kind,
                                     std::optional<Day> until) {
  LogEntry entry;
  entry.kind = kind;
  entry.until = until;
  return inside_->act(characters, entry, nullptr);
}

base::Result<Card> LearnerStore::preview(char32_t character, Rating rating, Stage stage) const {
  return inside_->guarded(
      [&]() -> base::Result<Card> { return inside_->outlook(character, rating, stage).card; });
}

base::Result<std::optional<Undone>> LearnerStore::undo() {
  return inside_->guarded([&]() -> base::Result<std::optional<Undone>> {
    Inside& in = *inside_;
    SQLite::Statement last(in.db, "SELECT action, kind FROM log ORDER BY id DESC");
    std::int64_t action = 0;
    Undone undone;
    while (action == 0 && last.executeStep()) {
      undone.kind = static_cast<EntryKind>(last.getColumn(1).getInt());
      const bool may_be_undone = undone.kind != EntryKind::undo && undone.kind != EntryKind::settings;
      const std::int64_t candidate = last.getColumn(0).getInt64();
      if (may_be_undone && !in.undone.contains(candidate)) action = candidate;
    }
    if (action == 0) return std::optional<Undone>();
    last.reset();
    SQLite::Statement about(
        in.db,
        "SELECT DISTINCT character FROM log WHERE action = ? AND character IS NOT NULL ORDER BY character");
    about.bind(1, action);
    while (about.executeStep())
      undone.characters.push_back(static_cast<char32_t>(about.getColumn(0).getInt64()));
    about.reset();

    LogEntry entry = in.next_entry(EntryKind::undo);
    entry.undoes = action;
    Cards changed = in.cards;
    std::vector<std::int64_t> choices;
    in.undone.insert(action);
    try {
      SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
      LogWriter(in.db).add(entry);
      choices = in.undo_choices(action);
      for (const char32_t character : undone.characters) {
        if (const auto card = in.refresh_row(character)) {
          changed[character] = *card;
        } else {
          changed.erase(character);
        }
      }
      transaction.commit();
    } catch (const SQLite::Exception&) {
      in.undone.erase(action);
      throw;
    }
    in.last_id = entry.id;
    in.cards = std::move(changed);
    std::erase_if(in.timeline, [&choices](const auto& one) {
      return std::find(choices.begin(), choices.end(), one.first) != choices.end();
    });
    return std::optional(std::move(undone));
  });
}

base::Result<void> LearnerStore::change_settings(const Settings& settings, const base::Progress& progress) {
  if (auto fine = check(settings); !fine) return fine;
  if (settings == this->settings()) return {};
  return inside_->guarded([&]() -> base::Result<void> {
    Inside& in = *inside_;
    LogEntry entry = in.next_entry(EntryKind::settings);
    entry.settings = to_json(settings);
    Cards changed = in.cards;
    const bool all_change = changes_memory(in.settings(), settings);
    in.timeline.emplace_back(entry.id, settings);
    try {
      SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
      LogWriter(in.db).add(entry);
      if (all_change) {
        double done = 0;
        for (auto& [character, card] : changed) {
          if (const auto anew = in.refresh_row(character)) card = *anew;
          done += 1;
          if (progress && !progress(done / static_cast<double>(changed.size()), "cards")) {
            in.timeline.pop_back();
            return base::fail(base::Errc::cancelled, "stopped", in.name);
          }
        }
      }
      transaction.commit();
    } catch (const SQLite::Exception&) {
      in.timeline.pop_back();
      throw;
    }
    in.last_id = entry.id;
    in.cards = std::move(changed);
    in.load_calendar();
    return {};
  });
}

}  // namespace nazori::study
