// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/store_filling.h"

#include <optional>
#include <unordered_set>

#include "learner_store_inside.h"
#include "store_days.h"

namespace nazori::study {
namespace {

using base::Errc;

/// Checks that entries form a valid log: numbered in order, each with the data its kind needs.
class LogCheck {
 public:
  /// @param has_ink  the entry has ink; @param ink  the part of it that could be read.
  base::Result<void> next(const LogEntry& entry, bool has_ink, const base::Result<Handwriting>& ink) {
    const auto refuse = [&id = entry.id](const char* what) -> base::Result<void> {
      return base::fail(Errc::bad_argument, what, "entry " + std::to_string(id));
    };
    if (entry.id != last_id_ + 1) return refuse("is out of order: entries are numbered 1, 2, 3, ...");
    if (entry.action != entry.id && entry.action != last_action_) return refuse("belongs to no action");
    if ((entry.character != 0) != names_a_character(entry.kind)) {
      return refuse(entry.character == 0 ? "is not the name of a character"
                                         : "names a character where none belongs");
    }
    if (entry.kind == EntryKind::writing) {
      if (auto fine = check_writing(entry.character, entry.strokes, entry.writing); !fine) {
        return refuse(fine.error().what.c_str());
      }
      if (!ink) return refuse("has ink that cannot be read");
    } else if (has_ink) {
      return refuse("has ink but is not a writing");
    }
    if ((entry.kind == EntryKind::undo) != entry.undoes.has_value() ||
        (entry.undoes && !actions_.contains(*entry.undoes))) {
      return refuse("undoes no action");
    }
    if (entry.kind == EntryKind::postpone ? !entry.until
                                          : entry.until.has_value() && entry.kind != EntryKind::known)
      return refuse("has no day it postpones to");
    if (has_settings(entry.kind) && !parse_settings(entry.settings)) {
      return refuse("has settings that cannot be read");
    }
    if (names_a_character(entry.kind) || entry.kind == EntryKind::choices) actions_.insert(entry.action);
    last_id_ = entry.id;
    last_action_ = entry.action;
    return {};
  }

 private:
  std::int64_t last_id_ = 0;
  std::int64_t last_action_ = 0;
  std::unordered_set<std::int64_t> actions_;
};

}  // namespace

struct LearnerStore::Filling::Parts {
  LogCheck check;
  SQLite::Database* db = nullptr;
  std::optional<LogWriter> log;
};

LearnerStore::Filling::Filling() : parts_(std::make_unique<Parts>()) {}
LearnerStore::Filling::Filling(SQLite::Database& db) : Filling() {
  parts_->db = &db;
  parts_->log.emplace(db);
}
LearnerStore::Filling::~Filling() = default;

base::Result<void> LearnerStore::Filling::add(const LogEntry& entry,
                                              std::span<const std::uint8_t> packed_ink) {
  const auto ink = unpack_handwriting(packed_ink);
  if (auto fine = parts_->check.next(entry, !packed_ink.empty(), ink); !fine) return fine;
  if (parts_->log) parts_->log->add(entry, motion_of(*ink), packed_ink);
  return {};
}

base::Result<void> LearnerStore::Filling::add_list(const CustomList& list) {
  if (!can_be_name(list.name)) return base::fail(Errc::bad_argument, "is not a valid list name", list.name);
  if (parts_->db != nullptr) put_list(*parts_->db, list);
  return {};
}

base::Result<void> LearnerStore::Filling::add_tag(const std::string& tag,
                                                  std::span<const char32_t> characters) {
  if (!can_be_name(tag)) return base::fail(Errc::bad_argument, "is not a valid tag", tag);
  if (parts_->db == nullptr) return {};
  for (const char32_t character : characters) put_tag(*parts_->db, character, tag);
  return {};
}

base::Result<void> LearnerStore::check_contents(const Source& source) {
  Filling only_checked;
  return source(only_checked);
}

base::Result<void> LearnerStore::fill(const Source& source, const base::Progress& progress) {
  Inside& in = *inside_;
  const auto own_lists = lists();
  if (!own_lists) return tl::unexpected(own_lists.error());
  const auto own_tags = tags();
  if (!own_tags) return tl::unexpected(own_tags.error());
  if (in.last_id > 0 || !own_lists->empty() || !own_tags->empty()) {
    return base::fail(Errc::bad_argument, "is not empty", in.name, "import into a new profile");
  }
  auto filled = in.guarded([&]() -> base::Result<void> {
    // One transaction, so that an import is either complete or not there at all.
    SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
    {
      Filling filling(in.db);
      if (auto fine = source(filling); !fine) return fine;
    }
    if (auto loaded = in.load(); !loaded) return loaded;
    auto followed = follow_log(progress);
    if (!followed) return tl::unexpected(std::move(followed.error()));
    for (const auto& [character, card] : followed->cards) put_card(in.db, card);
    rebuild_days(in.db);
    transaction.commit();
    in.cards = std::move(followed->cards);
    return {};
  });
  if (!filled) {
    if (auto loaded = in.guarded([&] { return in.load(); }); !loaded) return loaded;
  }
  return filled;
}

}  // namespace nazori::study
