// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "daily_backup.h"
#include "learner_store_inside.h"
#include "store_days.h"

namespace nazori::study {
namespace {

using base::Errc;

constexpr int kEntriesBetweenProgress = 256;

/// Follows every character through the log at once.
class WholeHistory {
 public:
  void apply(const LogEntry& entry, const Settings& settings) {
    histories_.try_emplace(entry.character, CardHistory(entry.character))
        .first->second.apply(entry, settings);
  }
  void change_settings(const Settings& settings) {
    for (auto& [character, history] : histories_) history.change_settings(settings);
  }
  [[nodiscard]] Cards cards() const {
    Cards cards;
    for (const auto& [character, history] : histories_) cards.emplace(character, history.card());
    return cards;
  }

 private:
  std::map<char32_t, CardHistory> histories_;
};

bool names_a_character(EntryKind kind) { return kind != EntryKind::undo && kind != EntryKind::settings; }

/// Whether entries make a log: numbered in order, each with what its kind needs.
class LogCheck {
 public:
  /// @param ink  of the entry, where it could be read.
  base::Result<void> next(const LearnerStore::Contents::Entry& one, const base::Result<Ink>& ink) {
    const LogEntry& entry = one.entry;
    const auto refuse = [&id = entry.id](const char* what) -> base::Result<void> {
      return base::fail(Errc::bad_argument, what, fmt::format("entry {}", id));
    };
    if (entry.id != last_id_ + 1) return refuse("is out of order: entries are numbered 1, 2, 3, ...");
    if (entry.action != entry.id && entry.action != last_action_) return refuse("belongs to no action");
    if ((entry.character != 0) != names_a_character(entry.kind)) {
      return refuse(entry.character == 0 ? "names no character" : "names a character where none belongs");
    }
    if (entry.kind == EntryKind::writing) {
      if (auto fine = check_writing(entry.character, entry.strokes, entry.writing); !fine) {
        return refuse(fine.error().what.c_str());
      }
      if (!ink) return refuse("has ink that cannot be read");
    } else if (!one.ink.empty()) {
      return refuse("has ink but is no writing");
    }
    if ((entry.kind == EntryKind::undo) != entry.undoes.has_value() ||
        (entry.undoes && !actions_.contains(*entry.undoes))) {
      return refuse("undoes no action");
    }
    if ((entry.kind == EntryKind::postpone) != entry.until.has_value())
      return refuse("has no day it postpones to");
    if (entry.kind == EntryKind::settings && !parse_settings(entry.settings)) {
      return refuse("has settings that cannot be read");
    }
    if (names_a_character(entry.kind)) actions_.insert(entry.action);
    last_id_ = entry.id;
    last_action_ = entry.action;
    return {};
  }

 private:
  std::int64_t last_id_ = 0;
  std::int64_t last_action_ = 0;
  std::unordered_set<std::int64_t> actions_;
};

base::Result<void> check_names(const LearnerStore::Contents& contents) {
  for (const CustomList& list : contents.lists) {
    if (!can_be_name(list.name)) return base::fail(Errc::bad_argument, "is no name of a list", list.name);
  }
  for (const auto& [tag, characters] : contents.tags) {
    if (!can_be_name(tag)) return base::fail(Errc::bad_argument, "is no tag", tag);
  }
  return {};
}

}  // namespace

base::Result<RebuildReport> LearnerStore::rebuild(const base::Progress& progress) {
  Inside& in = *inside_;
  RebuildReport report;
  WholeHistory whole;
  SettingsInForce in_force(in.timeline);
  bool cancelled = false;
  auto read = for_each_entry(false, [&](const LoggedEntry& logged) {
    const LogEntry& entry = logged.entry;
    if (++report.entries % kEntriesBetweenProgress == 0 && progress) {
      cancelled = !progress(static_cast<double>(entry.id) / static_cast<double>(in.last_id + 1), "rebuild");
      if (cancelled) return false;
    }
    if (!names_a_character(entry.kind) || in.undone.contains(entry.action)) return true;
    whole.apply(entry, in_force.at(entry.id, whole));
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  if (cancelled) return base::fail(Errc::cancelled, "stopped", in.name);
  in_force.finish(whole);

  Cards cards = whole.cards();
  for (const auto& [character, card] : cards) {
    if (card.introduced) ++report.studied;
    const auto kept = in.cards.find(character);
    if (kept == in.cards.end() || !(kept->second == card)) ++report.differences;
  }
  for (const auto& [character, card] : in.cards) {
    if (!cards.contains(character)) ++report.differences;
  }
  report.cards = static_cast<int>(cards.size());
  return in.guarded([&]() -> base::Result<RebuildReport> {
    SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
    in.db.exec("DELETE FROM card");
    for (const auto& [character, card] : cards) put_card(in.db, card);
    rebuild_days(in.db);
    transaction.commit();
    in.cards = std::move(cards);
    return report;
  });
}

base::Result<void> LearnerStore::copy_to(const std::filesystem::path& file,
                                         const base::Progress& progress) const {
  return copy_database(inside_->db, file, progress);
}

base::Result<LearnerStore::Contents> LearnerStore::contents() const {
  Contents contents;
  auto read = for_each_entry(false, [&](const LoggedEntry& logged) {
    contents.entries.push_back({logged.entry, {}});
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  return inside_->guarded([&]() -> base::Result<Contents> {
    SQLite::Statement rows(inside_->db, "SELECT entry, packed FROM ink ORDER BY entry");
    while (rows.executeStep()) {
      const std::int64_t id = rows.getColumn(0).getInt64();
      if (id < 1 || id > static_cast<std::int64_t>(contents.entries.size())) continue;
      const auto column = rows.getColumn(1);
      const auto* begin = static_cast<const std::uint8_t*>(column.getBlob());
      contents.entries[static_cast<std::size_t>(id - 1)].ink.assign(begin, begin + column.getBytes());
    }
    contents.lists = lists();
    contents.tags = tags();
    return std::move(contents);
  });
}

base::Result<void> LearnerStore::check_contents(const Contents& contents) {
  LogCheck check;
  for (const Contents::Entry& one : contents.entries) {
    if (auto fine = check.next(one, unpack_ink(one.ink)); !fine) return fine;
  }
  return check_names(contents);
}

base::Result<void> LearnerStore::fill(const Contents& contents, const base::Progress& progress) {
  Inside& in = *inside_;
  if (in.last_id > 0 || !lists().empty() || !tags().empty()) {
    return base::fail(Errc::bad_argument, "is not empty", in.name, "take a new profile for what is imported");
  }
  if (auto fine = check_names(contents); !fine) return fine;
  auto inserted = in.guarded([&]() -> base::Result<void> {
    SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
    LogWriter log(in.db);
    LogCheck check;
    for (const Contents::Entry& one : contents.entries) {
      if (one.entry.id % kEntriesBetweenProgress == 0 && progress &&
          !progress(0.9 * static_cast<double>(one.entry.id) / static_cast<double>(contents.entries.size()),
                    "import")) {
        return base::fail(Errc::cancelled, "stopped", in.name);
      }
      const auto ink = unpack_ink(one.ink);
      if (auto fine = check.next(one, ink); !fine) return fine;
      log.add(one.entry, motion_of(*ink), one.ink);
    }
    for (const CustomList& list : contents.lists) put_list(in.db, list);
    for (const auto& [tag, characters] : contents.tags) {
      for (const char32_t character : characters) put_tag(in.db, character, tag);
    }
    // Inside the same transaction, so that an import is there whole or not at all.
    if (auto loaded = in.load(); !loaded) return loaded;
    WholeHistory whole;
    SettingsInForce in_force(in.timeline);
    for (const auto& [entry, ink] : contents.entries) {
      if (!names_a_character(entry.kind) || in.undone.contains(entry.action)) continue;
      whole.apply(entry, in_force.at(entry.id, whole));
    }
    in_force.finish(whole);
    in.cards = whole.cards();
    for (const auto& [character, card] : in.cards) put_card(in.db, card);
    rebuild_days(in.db);
    transaction.commit();
    return {};
  });
  if (!inserted) {
    if (auto loaded = in.guarded([&] { return in.load(); }); !loaded) return loaded;
  }
  return inserted;
}

}  // namespace nazori::study
