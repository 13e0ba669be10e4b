// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>

#include "learner_store_inside.h"
#include "named_values.h"
#include "times_as_numbers.h"

namespace nazori::study {
namespace {

using std::chrono::milliseconds;

constexpr int kMostMistakes = 1'000;

/// Binds values one after another; nullopt becomes NULL.
class Binder {
 public:
  explicit Binder(SQLite::Statement& statement) : statement_(statement) {}
  Binder& operator<<(std::int64_t value) {
    statement_.bind(++column_, value);
    return *this;
  }
  Binder& operator<<(int value) { return *this << static_cast<std::int64_t>(value); }
  Binder& operator<<(bool value) { return *this << static_cast<std::int64_t>(value); }
  Binder& operator<<(char32_t value) { return *this << static_cast<std::int64_t>(value); }
  Binder& operator<<(double value) {
    statement_.bind(++column_, value);
    return *this;
  }
  Binder& operator<<(const std::string& value) {
    statement_.bind(++column_, value);
    return *this;
  }
  Binder& operator<<(Time value) { return *this << number_of(value); }
  Binder& operator<<(Day value) { return *this << number_of(value); }
  template <class Value>
  Binder& operator<<(const std::optional<Value>& value) {
    if (value) return *this << *value;
    ++column_;
    return *this;
  }
  void skip(int columns) { column_ += columns; }

 private:
  SQLite::Statement& statement_;
  int column_ = 0;
};

/// Reads columns one after another and records whether one is outside its range.
class RowReader {
 public:
  explicit RowReader(SQLite::Statement& row) : row_(row) {}
  std::int64_t whole(std::int64_t lowest, std::int64_t highest) {
    const auto column = row_.getColumn(at_++);
    const std::int64_t value = column.getInt64();
    ok_ = ok_ && !column.isNull() && value >= lowest && value <= highest;
    return ok_ ? value : lowest;
  }
  int integer(int lowest, int highest) { return static_cast<int>(whole(lowest, highest)); }
  /// An enumerator that this version knows.
  template <class Enum>
  Enum one_of() {
    const auto value = value_of<Enum>(whole(0, UINT8_MAX));
    ok_ = ok_ && value.has_value();
    return value.value_or(Enum{});
  }
  std::optional<std::int64_t> optional(std::int64_t lowest, std::int64_t highest) {
    if (row_.getColumn(at_).isNull()) {
      ++at_;
      return std::nullopt;
    }
    return whole(lowest, highest);
  }
  double real() { return row_.getColumn(at_++).getDouble(); }
  std::string text() { return row_.getColumn(at_++).getString(); }
  [[nodiscard]] bool is_null() const { return row_.getColumn(at_).isNull(); }
  Time time() { return time_of(whole(kEarliestMs, kLatestMs)); }
  Day day() { return day_of(whole(number_of(kFirstDay), number_of(kLastDay))); }
  std::optional<Day> optional_day() {
    const auto number = optional(number_of(kFirstDay), number_of(kLastDay));
    return number ? std::optional(day_of(*number)) : std::nullopt;
  }
  void skip(int columns) { at_ += columns; }
  [[nodiscard]] bool ok() const { return ok_; }
  void refuse() { ok_ = false; }

 private:
  static constexpr std::int64_t kLatestMs = std::chrono::milliseconds(kLastDay.time_since_epoch()).count();
  static constexpr std::int64_t kEarliestMs = -kLatestMs;
  SQLite::Statement& row_;
  int at_ = 0;
  bool ok_ = true;
};

std::string mistakes_text(const std::vector<StrokeMistake>& mistakes) {
  std::string text;
  for (const StrokeMistake& mistake : mistakes) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : " ", name_of(mistake.kind), mistake.stroke);
  }
  return text;
}

std::optional<std::vector<StrokeMistake>> read_mistakes(std::string_view text) {
  std::vector<StrokeMistake> mistakes;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const auto kind = kanji::mistake_named(word.substr(0, colon));
    StrokeMistake mistake;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + colon + 1, end, mistake.stroke);
    if (!kind || read.ec != std::errc() || read.ptr != end) return std::nullopt;
    mistake.kind = *kind;
    mistakes.push_back(mistake);
  }
  return mistakes;
}

void read_writing(RowReader& row, LogEntry& entry) {
  Writing& writing = entry.writing;
  WritingResult& result = writing.result;
  writing.stage = row.one_of<Stage>();
  writing.rating = row.one_of<Rating>();
  writing.proposed = row.one_of<Rating>();
  result.accepted = row.integer(0, 1) == 1;
  result.score = row.integer(0, 100);
  if (auto mistakes = read_mistakes(row.text())) {
    result.mistakes = *std::move(mistakes);
  } else {
    row.refuse();
  }
  result.hints = row.integer(0, INT32_MAX);
  result.misses = row.integer(0, INT32_MAX);
  result.shown_strokes = row.integer(0, INT32_MAX);
  result.help = row.real();
  result.duration = milliseconds(row.whole(0, INT64_MAX));
  entry.strokes = row.integer(1, INT32_MAX);
  if (const auto days = row.optional(1, 36'600)) entry.interval_days = static_cast<int>(*days);
}

}  // namespace

const char* const log_columns =
    "id, action, at_ms, day, kind, character, stage, rating, proposed, accepted, score, faults, hints, "
    "misses, "
    "shown_strokes, help, duration_ms, strokes, interval_days, speed, smoothness, undoes, until_day, "
    "settings, "
    "EXISTS(SELECT 1 FROM ink WHERE ink.entry = log.id)";

std::optional<LearnerStore::LoggedEntry> read_entry(SQLite::Statement& statement) {
  constexpr int kWritingColumns = 13;
  RowReader row(statement);
  LearnerStore::LoggedEntry logged;
  LogEntry& entry = logged.entry;
  entry.id = row.whole(1, INT64_MAX);
  entry.action = row.whole(1, entry.id);
  entry.at = row.time();
  entry.day = row.day();
  entry.kind = row.one_of<EntryKind>();
  entry.character = static_cast<char32_t>(row.optional(1, 0x10FFFF).value_or(0));
  if (entry.kind == EntryKind::writing) {
    read_writing(row, entry);
  } else {
    row.skip(kWritingColumns);
  }
  if (row.is_null()) {
    row.skip(2);
  } else {
    const double speed = row.real();
    logged.motion = PenMotion{speed, row.real()};
  }
  entry.undoes = row.optional(1, entry.id);
  entry.until = row.optional_day();
  entry.settings = row.text();
  logged.has_ink = row.integer(0, 1) == 1;
  if (!row.ok()) return std::nullopt;
  return logged;
}

LogWriter::LogWriter(SQLite::Database& db)
    : entry_(db, "INSERT INTO log VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      ink_(db, "INSERT INTO ink VALUES(?, ?)") {}

void LogWriter::add(const LogEntry& entry, const std::optional<PenMotion>& motion,
                    std::span<const std::uint8_t> packed_ink) {
  entry_.reset();
  entry_.clearBindings();
  Binder bind(entry_);
  bind << entry.id << entry.action << entry.at << entry.day << static_cast<int>(entry.kind)
       << (entry.character == 0 ? std::nullopt : std::optional(entry.character));
  if (entry.kind == EntryKind::writing) {
    const Writing& writing = entry.writing;
    const WritingResult& result = writing.result;
    bind << static_cast<int>(writing.stage) << static_cast<int>(writing.rating)
         << static_cast<int>(writing.proposed) << result.accepted << result.score
         << mistakes_text(result.mistakes) << result.hints << result.misses << result.shown_strokes
         << result.help << static_cast<std::int64_t>(result.duration.count()) << entry.strokes
         << entry.interval_days;
  } else {
    bind.skip(13);
  }
  bind << (motion ? std::optional(motion->speed) : std::nullopt)
       << (motion ? std::optional(motion->smoothness) : std::nullopt) << entry.undoes << entry.until
       << (has_settings(entry.kind) ? std::optional(entry.settings) : std::nullopt);
  entry_.exec();
  if (packed_ink.empty()) return;
  ink_.reset();
  ink_.bind(1, entry.id);
  ink_.bind(2, packed_ink.data(), static_cast<int>(packed_ink.size()));
  ink_.exec();
}

namespace {

Memory read_memory(RowReader& row) {
  Memory memory;
  memory.phase = row.one_of<Phase>();
  memory.stability = row.real();
  memory.difficulty = row.real();
  memory.step = row.integer(0, 1'000);
  memory.scheduled_days = row.integer(0, 40'000);
  memory.reps = row.integer(0, INT32_MAX);
  memory.lapses = row.integer(0, INT32_MAX);
  memory.due = row.time();
  if (row.is_null()) {
    row.skip(1);
  } else {
    memory.last_review = row.time();
  }
  return memory;
}

/// @return false where a row is impossible, or has no card.
bool read_brush_cards(SQLite::Database& db, Cards& cards) {
  SQLite::Statement rows(
      db,
      "SELECT character, phase, stability, difficulty, step, scheduled_days, reps, lapses, due_ms, "
      "last_review_ms, last_day, due_day FROM brush_card");
  while (rows.executeStep()) {
    RowReader row(rows);
    const auto card = cards.find(static_cast<char32_t>(row.whole(1, 0x10FFFF)));
    BrushReviews brush;
    brush.memory = read_memory(row);
    brush.last_day = row.optional_day();
    brush.due_day = row.optional_day();
    if (!row.ok() || card == cards.end()) return false;
    card->second.brush = brush;
  }
  return true;
}

void bind_memory(Binder& bind, const Memory& memory) {
  bind << static_cast<int>(memory.phase) << memory.stability << memory.difficulty << memory.step
       << memory.scheduled_days << memory.reps << memory.lapses << memory.due << memory.last_review;
}

void put_brush_card(SQLite::Database& db, const Card& card) {
  if (card.brush == BrushReviews()) {
    SQLite::Statement remove(db, "DELETE FROM brush_card WHERE character = ?");
    remove.bind(1, static_cast<std::int64_t>(card.character));
    remove.exec();
    return;
  }
  SQLite::Statement put(db, "INSERT OR REPLACE INTO brush_card VALUES(?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder bind(put);
  bind << card.character;
  bind_memory(bind, card.brush.memory);
  bind << card.brush.last_day << card.brush.due_day;
  put.exec();
}

}  // namespace

std::optional<Cards> read_cards(SQLite::Database& db) {
  SQLite::Statement rows(
      db,
      "SELECT character, phase, stability, difficulty, step, scheduled_days, reps, lapses, due_ms, "
      "last_review_ms, introduced, last_day, due_day, postponed_until, paused, leech, leech_at, practices, "
      "next_stage, help FROM card ORDER BY character");
  Cards cards;
  while (rows.executeStep()) {
    RowReader row(rows);
    Card card;
    card.character = static_cast<char32_t>(row.whole(1, 0x10FFFF));
    card.memory = read_memory(row);
    card.introduced = row.optional_day();
    card.last_day = row.optional_day();
    card.due_day = row.optional_day();
    card.postponed_until = row.optional_day();
    card.paused = row.integer(0, 1) == 1;
    card.leech = row.integer(0, 1) == 1;
    card.leech_at = row.integer(0, INT32_MAX);
    card.practices = row.integer(0, INT32_MAX);
    card.next_stage = row.one_of<Stage>();
    if (card.next_stage == Stage::brush) row.refuse();  // no part of a lesson
    card.help = row.real();
    if (!row.ok()) return std::nullopt;
    cards.emplace(card.character, card);
  }
  if (!read_brush_cards(db, cards)) return std::nullopt;
  return cards;
}

void put_card(SQLite::Database& db, const Card& card) {
  SQLite::Statement put(db, "INSERT OR REPLACE INTO card VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder bind(put);
  bind << card.character;
  bind_memory(bind, card.memory);
  bind << card.introduced << card.last_day << card.due_day << card.postponed_until << card.paused
       << card.leech << card.leech_at << card.practices << static_cast<int>(card.next_stage) << card.help;
  put.exec();
  put_brush_card(db, card);
}

void delete_card(SQLite::Database& db, char32_t character) {
  for (const char* const statement :
       {"DELETE FROM card WHERE character = ?", "DELETE FROM brush_card WHERE character = ?"}) {
    SQLite::Statement remove(db, statement);
    remove.bind(1, static_cast<std::int64_t>(character));
    remove.exec();
  }
}

bool names_a_character(EntryKind kind) { return kind != EntryKind::undo && !has_settings(kind); }

bool has_settings(EntryKind kind) { return kind == EntryKind::settings || kind == EntryKind::choices; }

base::Result<void> check_writing(char32_t character, int strokes, const Writing& writing) {
  const auto refuse = [](const char* what, const char* where) -> base::Result<void> {
    return base::fail(base::Errc::bad_argument, what, where);
  };
  const WritingResult& result = writing.result;
  if (character == 0 || character > 0x10FFFF || (character >= 0xD800 && character <= 0xDFFF)) {
    return refuse("is no character", "character");
  }
  if (strokes < 1 || strokes > 1'000) return refuse("is no number of strokes", "strokes");
  if (result.score < 0 || result.score > 100) return refuse("is outside 0..100", "score");
  if (!(result.help >= 0 && result.help <= 1)) return refuse("is outside 0..1", "help");
  if (result.hints < 0 || result.misses < 0 || result.shown_strokes < 0) {
    return refuse("are less than none", "hints, misses or shown strokes");
  }
  if (result.duration < milliseconds(0) || result.duration > std::chrono::hours(24)) {
    return refuse("is outside a day", "duration");
  }
  if (result.mistakes.size() > kMostMistakes) return refuse("are too many", "faults");
  for (const StrokeMistake& mistake : result.mistakes) {
    if (mistake.stroke < 0 || mistake.stroke > 1'000) return refuse("names no stroke", "fault");
  }
  return {};
}

}  // namespace nazori::study
