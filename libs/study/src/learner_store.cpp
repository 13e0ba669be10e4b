// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/learner_store.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <unistd.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "daily_backup.h"
#include "interval_choice.h"
#include "learner_store_inside.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;
using base::Errc;

constexpr int kBusyMs = 5'000;
constexpr int kUsualOf = 10;

fs::path lock_of(const fs::path& path) { return path.string() + ".lock"; }

/// Refuses a file that SQLite would take for damaged only after it had looked around it.
base::Result<void> check_beginning(const fs::path& path) {
  std::array<char, 16> begin{};
  std::ifstream file(path, std::ios::binary);
  if (!file) return base::fail(Errc::io, "cannot be read", path.string(), "check its permissions");
  file.read(begin.data(), begin.size());
  if (file.gcount() == 0) return {};
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  if (std::string_view(begin.data(), static_cast<std::size_t>(file.gcount())) == kMagic) return {};
  return base::fail(Errc::parse, "is damaged, or no learner's file of Nazori", path.string(),
                    "nothing was changed; take a backup: nazori-cli study restore");
}

/// How to name the file to SQLite so that reading it leaves its folder alone.
std::string read_only_uri(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : fs::absolute(path).string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '/' || c == '-' || c == '_' || c == '.';
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  uri += "?mode=ro";
  // Without write permission WAL files cannot be made; a file that was closed well has none to read.
  std::error_code ignored;
  if (::access(path.parent_path().empty() ? "." : path.parent_path().c_str(), W_OK) != 0 &&
      !fs::exists(path.string() + "-wal", ignored)) {
    uri += "&immutable=1";
  }
  return uri;
}

void keep_wal_as_it_is(SQLite::Database& db, bool keep) {
  (void)sqlite3_db_config(db.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, keep ? 1 : 0, nullptr);
}

}  // namespace

LearnerStore::Inside::Inside(SQLite::Database opened, std::string file_name, Clock the_clock)
    : db(std::move(opened)),
      name(std::move(file_name)),
      clock(std::move(the_clock)),
      calendar(*Calendar::create("UTC")),
      timeline{{0, Settings{}}} {}

void LearnerStore::Inside::take_calendar() {
  // A zone this computer does not know is no reason to keep a learner from studying.
  auto own = Calendar::create(settings().time_zone, settings().day_starts_at);
  if (!own) own = Calendar::create("", settings().day_starts_at);
  if (own) calendar = *std::move(own);
}

base::Result<void> LearnerStore::Inside::load() {
  const auto damaged = [&](const char* what) {
    return base::fail(
        Errc::parse, fmt::format("is damaged: {}", what), name,
        "work it out anew: nazori-cli study rebuild; or take a backup: nazori-cli study restore");
  };
  timeline.assign(1, {0, Settings{}});
  undone.clear();
  SQLite::Statement rows(db, "SELECT id, settings FROM log WHERE settings IS NOT NULL ORDER BY id");
  while (rows.executeStep()) {
    auto settings = parse_settings(rows.getColumn(1).getString());
    if (!settings) return damaged("settings that cannot be read");
    timeline.emplace_back(rows.getColumn(0).getInt64(), *std::move(settings));
  }
  SQLite::Statement undos(db, "SELECT undoes FROM log WHERE undoes IS NOT NULL");
  while (undos.executeStep()) undone.insert(undos.getColumn(0).getInt64());
  last_id = db.execAndGet("SELECT coalesce(max(id), 0) FROM log").getInt64();
  auto read = read_cards(db);
  if (!read) return damaged("a card that cannot be");
  cards = *std::move(read);
  take_calendar();
  return {};
}

LearnerStore::LearnerStore(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
LearnerStore::LearnerStore(LearnerStore&&) noexcept = default;
LearnerStore& LearnerStore::operator=(LearnerStore&&) noexcept = default;
LearnerStore::~LearnerStore() = default;

bool LearnerStore::in_use(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(lock_of(path), ignored)) return false;
  bool taken = false;
  (void)FileLock::take(lock_of(path), taken);
  return taken;
}

base::Result<LearnerStore> LearnerStore::in_memory(Clock clock) {
  try {
    SQLite::Database db(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    migrate_store(db, 0, clock());
    auto inside = std::make_unique<Inside>(std::move(db), "memory", std::move(clock));
    if (auto fine = inside->load(); !fine) return tl::unexpected(std::move(fine.error()));
    return LearnerStore(std::move(inside));
  } catch (const SQLite::Exception& trouble) {
    return tl::unexpected(error_of(trouble, "memory"));
  }
}

base::Result<LearnerStore> LearnerStore::open(const fs::path& path, Access access, Clock clock) {
  std::error_code error;
  const bool there = fs::exists(path, error);
  if (!there && access == Access::read) return in_memory(std::move(clock));
  FileLock lock;
  if (access == Access::write) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) {
      return base::fail(Errc::io, "cannot be made: " + error.message(), path.parent_path().string(),
                        "check the permissions of the folder");
    }
    bool taken = false;
    auto own = FileLock::take(lock_of(path), taken);
    if (taken) {
      return base::fail(Errc::io, "is open in another Nazori", path.string(), "close it there first");
    }
    if (!own) return tl::unexpected(std::move(own.error()));
    lock = *std::move(own);
  }
  if (there) {
    if (auto fine = check_beginning(path); !fine) return tl::unexpected(std::move(fine.error()));
  }
  try {
    const bool writes = access == Access::write;
    SQLite::Database db(
        writes ? path.string() : read_only_uri(path),
        writes ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE : SQLite::OPEN_READONLY | SQLite::OPEN_URI,
        kBusyMs);
    keep_wal_as_it_is(db, true);
    const auto version = check_store(db, path.string());
    if (!version) return tl::unexpected(version.error());
    if (!writes && *version == 0) return in_memory(std::move(clock));
    if (!writes && *version < kLearnerVersion) {
      return base::fail(Errc::schema, "was written by an older Nazori", path.string(),
                        "open it for writing once, which brings it up to date");
    }
    auto inside = std::make_unique<Inside>(std::move(db), path.string(), std::move(clock));
    inside->lock = std::move(lock);
    if (writes) {
      keep_wal_as_it_is(inside->db, false);
      if (*version > 0 && *version < kLearnerVersion) {
        auto kept = keep_backup_before_migration(inside->db, path, *version);
        if (!kept) return tl::unexpected(std::move(kept.error()));
      }
      if (*version < kLearnerVersion) migrate_store(inside->db, *version, inside->clock());
      inside->db.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    }
    if (auto fine = inside->load(); !fine) return tl::unexpected(std::move(fine.error()));
    if (writes && inside->last_id > 0) {
      const Day day = inside->calendar.day_of(inside->clock());
      if (auto kept = keep_daily_backup(inside->db, path, day); !kept) {
        inside->backup_trouble = std::move(kept.error());
      }
    }
    return LearnerStore(std::move(inside));
  } catch (const SQLite::Exception& trouble) {
    return tl::unexpected(error_of(trouble, path.string()));
  }
}

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

bool changes_memory(const Settings& before, const Settings& after) {
  return before.fsrs.weights != after.fsrs.weights ||
         before.fsrs.short_term_steps != after.fsrs.short_term_steps;
}

std::vector<LearnerStore::LoggedEntry> LearnerStore::Inside::entries_of(char32_t character) {
  SQLite::Statement rows(db, fmt::format("SELECT {} FROM log WHERE character = ? ORDER BY id", kLogColumns));
  rows.bind(1, static_cast<std::int64_t>(character));
  std::vector<LoggedEntry> entries;
  while (rows.executeStep()) {
    auto entry = read_entry(rows);
    if (entry && !undone.contains(entry->entry.action)) entries.push_back(*std::move(entry));
  }
  return entries;
}

CardHistory LearnerStore::Inside::history_of(char32_t character) {
  CardHistory history(character);
  std::size_t in_force = 0;
  const auto go_to = [&](std::int64_t id) {
    for (; in_force + 1 < timeline.size() && timeline[in_force + 1].first < id; ++in_force) {
      if (changes_memory(timeline[in_force].second, timeline[in_force + 1].second)) {
        history.change_settings(timeline[in_force + 1].second);
      }
    }
  };
  for (const LoggedEntry& logged : entries_of(character)) {
    go_to(logged.entry.id);
    history.apply(logged.entry, timeline[in_force].second);
  }
  go_to(INT64_MAX);
  return history;
}

std::optional<Card> LearnerStore::Inside::refresh_row(char32_t character) {
  const CardHistory history = history_of(character);
  if (history.met()) {
    put_card(db, history.card());
    return history.card();
  }
  SQLite::Statement remove(db, "DELETE FROM card WHERE character = ?");
  remove.bind(1, static_cast<std::int64_t>(character));
  remove.exec();
  return std::nullopt;
}

base::Result<void> LearnerStore::Inside::act(std::span<const char32_t> characters, LogEntry entry,
                                             const Ink* ink) {
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
    std::int64_t id = last_id;
    for (const char32_t character : characters) {
      entry.id = ++id;
      entry.character = character;
      insert_entry(db, entry, motion);
      insert_ink(db, entry.id, packed);
      if (auto card = refresh_row(character)) changed.push_back(*card);
    }
    transaction.commit();
    last_id = id;
    for (const Card& card : changed) cards[card.character] = card;
    return {};
  });
}

base::Result<Card> LearnerStore::add_writing(char32_t character, int strokes, const Writing& writing,
                                             const Ink& ink) {
  if (auto fine = check_writing(character, strokes, writing); !fine) {
    return tl::unexpected(std::move(fine.error()));
  }
  LogEntry entry;
  entry.kind = EntryKind::writing;
  entry.writing = writing;
  entry.strokes = strokes;
  if (writing.stage == Stage::memory) {
    const Card before = card(character);
    const Card after = preview(character, writing.rating);
    const auto fsrs = Fsrs::create(settings().fsrs);
    const int elapsed =
        before.last_day ? std::max(0, static_cast<int>((today() - *before.last_day).count())) : 0;
    if (fsrs) {
      entry.interval_days =
          choose_interval(*fsrs, settings(), cards(), character, after.memory, elapsed, today());
    }
  }
  if (auto done = inside_->act(std::span(&character, 1), entry, &ink); !done) {
    return tl::unexpected(std::move(done.error()));
  }
  return card(character);
}

Card LearnerStore::preview(char32_t character, Rating rating) const {
  try {
    CardHistory history = inside_->history_of(character);
    LogEntry entry;
    entry.at = now();
    entry.day = today();
    entry.character = character;
    entry.writing.rating = rating;
    entry.writing.result.accepted = rating != Rating::again;
    history.apply(entry, settings());
    return history.card();
  } catch (const SQLite::Exception&) {
    return card(character);
  }
}

base::Result<std::optional<Undone>> LearnerStore::undo() {
  return inside_->guarded([&]() -> base::Result<std::optional<Undone>> {
    Inside& in = *inside_;
    SQLite::Statement last(in.db,
                           "SELECT action, kind FROM log WHERE kind NOT IN (1, 2) AND action NOT IN "
                           "(SELECT undoes FROM log WHERE undoes IS NOT NULL) ORDER BY id DESC LIMIT 1");
    if (!last.executeStep()) return std::optional<Undone>();
    const std::int64_t action = last.getColumn(0).getInt64();
    Undone undone;
    undone.kind = static_cast<EntryKind>(last.getColumn(1).getInt());
    last.reset();
    SQLite::Statement about(in.db, "SELECT DISTINCT character FROM log WHERE action = ? ORDER BY character");
    about.bind(1, action);
    while (about.executeStep())
      undone.characters.push_back(static_cast<char32_t>(about.getColumn(0).getInt64()));
    about.reset();

    LogEntry entry;
    entry.id = in.last_id + 1;
    entry.action = entry.id;
    entry.at = now();
    entry.day = today();
    entry.kind = EntryKind::undo;
    entry.undoes = action;
    Cards changed = in.cards;
    in.undone.insert(action);
    try {
      SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
      insert_entry(in.db, entry, std::nullopt);
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
    return std::optional(std::move(undone));
  });
}

base::Result<void> LearnerStore::postpone(std::span<const char32_t> characters, Day until) {
  LogEntry entry;
  entry.kind = EntryKind::postpone;
  entry.until = until;
  return inside_->act(characters, entry, nullptr);
}

base::Result<void> LearnerStore::pause(std::span<const char32_t> characters) {
  LogEntry entry;
  entry.kind = EntryKind::pause;
  return inside_->act(characters, entry, nullptr);
}

base::Result<void> LearnerStore::resume(std::span<const char32_t> characters) {
  LogEntry entry;
  entry.kind = EntryKind::resume;
  return inside_->act(characters, entry, nullptr);
}

base::Result<void> LearnerStore::reset(std::span<const char32_t> characters) {
  LogEntry entry;
  entry.kind = EntryKind::reset;
  return inside_->act(characters, entry, nullptr);
}

base::Result<void> LearnerStore::leech_met(std::span<const char32_t> characters) {
  LogEntry entry;
  entry.kind = EntryKind::leech_met;
  return inside_->act(characters, entry, nullptr);
}

base::Result<std::vector<LearnerStore::LoggedEntry>> LearnerStore::writings_of(char32_t character) const {
  return inside_->guarded([&]() -> base::Result<std::vector<LoggedEntry>> {
    std::vector<LoggedEntry> entries = inside_->entries_of(character);
    std::erase_if(entries, [](const LoggedEntry& one) { return one.entry.kind != EntryKind::writing; });
    return entries;
  });
}

base::Result<Ink> LearnerStore::ink_of(std::int64_t entry) const {
  return inside_->guarded([&]() -> base::Result<Ink> {
    SQLite::Statement row(inside_->db, "SELECT packed FROM ink WHERE entry = ?");
    row.bind(1, entry);
    if (!row.executeStep()) return Ink{};
    const auto column = row.getColumn(0);
    return unpack_ink(
        {static_cast<const std::uint8_t*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())});
  });
}

UsualWriting LearnerStore::usual_writing(char32_t character) const {
  const auto writings = writings_of(character);
  std::vector<std::chrono::milliseconds> durations;
  if (writings) {
    for (auto one = writings->rbegin(); one != writings->rend() && durations.size() < kUsualOf; ++one) {
      const Writing& writing = one->entry.writing;
      if (writing.stage == Stage::memory && writing.result.accepted && writing.result.duration.count() > 0) {
        durations.push_back(writing.result.duration);
      }
    }
  }
  if (durations.empty()) return {};
  const auto middle = durations.begin() + static_cast<std::ptrdiff_t>(durations.size() / 2);
  std::nth_element(durations.begin(), middle, durations.end());
  return {*middle, static_cast<int>(durations.size())};
}

base::Result<void> LearnerStore::for_each_entry(bool in_force_only,
                                                const std::function<bool(const LoggedEntry&)>& take) const {
  return inside_->guarded([&]() -> base::Result<void> {
    SQLite::Statement rows(inside_->db, fmt::format("SELECT {} FROM log ORDER BY id", kLogColumns));
    while (rows.executeStep()) {
      const auto entry = read_entry(rows);
      if (!entry) {
        return base::fail(Errc::parse,
                          fmt::format("is damaged: entry {} cannot be", rows.getColumn(0).getInt64()),
                          inside_->name, "take a backup: nazori-cli study restore");
      }
      if (in_force_only && inside_->undone.contains(entry->entry.action)) continue;
      if (!take(*entry)) break;
    }
    return {};
  });
}

}  // namespace nazori::study
