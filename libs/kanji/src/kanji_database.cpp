// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/kanji_database.h"

#include <sqlite3.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>
#include <utility>

#include "character_rows.h"
#include "kanji_database_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/character_name.h"
#include "nazori/kanji/own_characters.h"
#include "own_form.h"
#include "own_rows.h"

namespace nazori::kanji {
namespace {

constexpr const char* kRebuild = "build it again: nazori-cli database build";

std::vector<int> read_numbers(std::string_view text) {
  std::vector<int> out;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    int value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc{}) break;
    out.push_back(value);
    at = read.ptr == end ? end : std::next(read.ptr);
  }
  return out;
}

base::Result<void> check_own(const std::vector<Character>& own) {
  std::set<char32_t> known;
  for (const Character& one : own) {
    const bool is_its_own = is_own(one.own_form.value_or(one.code_point));
    const bool is_published = one.own_form && !is_own(one.code_point);
    if (is_its_own && is_published == one.own_form.has_value() && known.insert(one.code_point).second &&
        (!one.own_form || known.insert(*one.own_form).second))
      continue;
    return base::fail(base::Errc::bad_argument, "is not a code point of its own for an own character",
                      code_point_text(one.code_point), "give each another one of U+F0000 to U+FFFFD");
  }
  return {};
}

}  // namespace

KanjiDatabase::Inside::Inside(SQLite::Database opened, std::string file, OwnForms made)
    : db(std::move(opened)),
      name(std::move(file)),
      own(std::move(made.beside)),
      forms(std::move(made.replaced)),
      character(db,
                "SELECT strokes, grade, frequency, old_jlpt, radical FROM character WHERE code_point = ?"),
      form(db, "SELECT id FROM form WHERE code_point = ? AND variant = ?"),
      variants(db, "SELECT variant FROM form WHERE code_point = ? AND variant <> '' ORDER BY id"),
      strokes(db, "SELECT path, type, ending, number_x, number_y FROM stroke WHERE form = ? ORDER BY number"),
      components(db,
                 "SELECT parent, first_stroke, stroke_count, element, original, place, radical, phon, part, "
                 "number, flags FROM component WHERE form = ? ORDER BY position"),
      orders(db,
             "SELECT stroke_numbers, source FROM alternative_order WHERE code_point = ? ORDER BY position"),
      stroke_counts(db, "SELECT count FROM stroke_count WHERE code_point = ? ORDER BY position"),
      readings(db, "SELECT kind, text FROM reading WHERE code_point = ? ORDER BY position"),
      meanings(db, "SELECT language, text FROM meaning WHERE code_point = ? ORDER BY position"),
      codes(db, "SELECT system, value FROM code WHERE code_point = ? ORDER BY position"),
      all_characters(
          db,
          "SELECT place, code_point, kind, strokes, counted, grade, radical, meaning, reading, old_jlpt, "
          "frequency FROM character"),
      words(db,
            "SELECT w.text, w.reading, w.parts_of_speech, w.common, w.glosses FROM word_of o JOIN word w ON "
            "w.id = o.word WHERE o.code_point = ? ORDER BY o.word LIMIT ?"),
      heard_words(db,
                  "SELECT text, reading, parts_of_speech, common, glosses FROM word WHERE common > 0 AND "
                  "length(coalesce(reading, text)) BETWEEN 2 AND ? AND instr(coalesce(reading, text), ?) > 0 "
                  "ORDER BY id LIMIT ?"),
      elements(db, "SELECT place FROM element_of WHERE element = ? ORDER BY place LIMIT ?"),
      radical(db, "SELECT form, strokes, english_name FROM radical WHERE number = ?"),
      radical_forms(db, "SELECT form FROM radical_form WHERE number = ? ORDER BY position"),
      radical_names(db, "SELECT name FROM radical_name WHERE number = ? ORDER BY position"),
      sources(db, "SELECT name, version, sha256, licence FROM source ORDER BY position"),
      reading_keys(db, "SELECT key, place, fit FROM reading_key WHERE key >= ? AND key < ?"),
      meaning_keys(db, "SELECT key, place, fit FROM meaning_key WHERE key >= ? AND key < ?"),
      word(db, "SELECT text, reading, parts_of_speech, common, glosses FROM word WHERE id = ?"),
      words_of_key(db, "SELECT word FROM word_key WHERE key = ?"),
      words_after_key(db, "SELECT word FROM word_key WHERE key > ? AND key < ? AND word <= ?"),
      words_of_meaning(db, "SELECT key, word, fit FROM word_meaning_key WHERE key >= ? AND key < ?"),
      codes_of(db, "SELECT code_point FROM code WHERE system = ? AND value BETWEEN ? AND ?"),
      all_radicals(db, "SELECT number FROM radical ORDER BY number"),
      form_of_radical(db,
                      "SELECT number FROM radical WHERE form = ?1 UNION ALL SELECT number FROM radical_form "
                      "WHERE form = ?1 ORDER BY 1 LIMIT 1") {
  load_roster();
}

void KanjiDatabase::Inside::note_trouble(const char* what) {
  if (trouble) return;
  trouble = base::Error{base::Errc::io, std::string("cannot be read: ") + what, name, kRebuild};
}

void KanjiDatabase::Inside::load_roster() {
  const int characters = db.execAndGet("SELECT count(*) FROM character").getInt();
  roster_.resize(static_cast<std::size_t>(characters));
  places_.reserve(roster_.size());
  Rewound row(all_characters);
  while (row->executeStep()) {
    const int place = row.number(0);
    if (place < 0 || place >= characters) throw SQLite::Exception("places have gaps", SQLITE_CORRUPT);
    RosterEntry& entry = roster_[static_cast<std::size_t>(place)];
    entry.code_point = static_cast<char32_t>(row.number(1));
    entry.kind = static_cast<CharacterKind>(row.number(2));
    entry.drawn = row.number(3);
    entry.counted = row.number(4);
    entry.grade = row.number(5);
    entry.radical = row.number(6);
    entry.meaning = row.text(7);
    entry.reading = row.text(8);
    entry.old_jlpt = row.number(9);
    entry.frequency = row.number(10);
    entry.is_made = is_own(entry.code_point) || forms.contains(entry.code_point);
    places_.emplace(entry.code_point, static_cast<std::size_t>(place));
  }
}

const Character* KanjiDatabase::Inside::find_own(char32_t code_point) const {
  if (!is_own(code_point)) return nullptr;
  const auto place = place_of(code_point);
  return place && *place >= first_own() ? &own[*place - first_own()] : nullptr;
}

std::optional<std::size_t> KanjiDatabase::Inside::place_of(char32_t code_point) const {
  const auto found = places_.find(code_point);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

Summary KanjiDatabase::Inside::summary(std::size_t place) const {
  const RosterEntry& entry = roster_.at(place);
  Summary out{
      entry.code_point, entry.meaning, entry.reading, entry.drawn > 0 ? entry.drawn : entry.counted, {}};
  if (entry.grade > 0) out.grade = entry.grade;
  return out;
}

KanjiDatabase::KanjiDatabase(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
KanjiDatabase::KanjiDatabase(KanjiDatabase&&) noexcept = default;
KanjiDatabase& KanjiDatabase::operator=(KanjiDatabase&&) noexcept = default;
KanjiDatabase::~KanjiDatabase() = default;

base::Result<KanjiDatabase> KanjiDatabase::open(const std::filesystem::path& path,
                                                std::vector<Character> own) {
  if (auto fit = check_own(own); !fit) return tl::unexpected(std::move(fit.error()));
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) {
    return base::fail(base::Errc::not_found, "does not exist", path.string(), kRebuild);
  }
  if (std::filesystem::is_directory(status)) {
    return base::fail(base::Errc::schema, "is a folder, not a kanji database", path.string(), kRebuild);
  }
  // Opening a pipe would wait until another program writes to it.
  if (!std::filesystem::is_regular_file(status)) {
    return base::fail(base::Errc::schema, "is not a regular file", path.string(), kRebuild);
  }
  try {
    SQLite::Database db(path.string(), SQLite::OPEN_READONLY | SQLite::OPEN_NOMUTEX);
    if (db.execAndGet("PRAGMA application_id").getInt() != kSchemaApplicationId) {
      return base::fail(base::Errc::schema, "is not a kanji database", path.string(), kRebuild);
    }
    const int version = db.execAndGet("PRAGMA user_version").getInt();
    if (version != kSchemaVersion) {
      return base::fail(base::Errc::schema,
                        "has version " + std::to_string(version) + ", this program reads version " +
                            std::to_string(kSchemaVersion),
                        path.string(), kRebuild);
    }
    OwnForms forms = sorted_forms(db, std::move(own));
    if (!forms.beside.empty() || !forms.replaced.empty()) add_own_rows(db, forms);
    return KanjiDatabase(std::make_unique<Inside>(std::move(db), path.string(), std::move(forms)));
  } catch (const SQLite::Exception& e) {
    const bool refused = e.getErrorCode() == SQLITE_CANTOPEN || e.getErrorCode() == SQLITE_IOERR;
    return base::fail(refused ? base::Errc::io : base::Errc::schema,
                      std::string("cannot be read as a kanji database: ") + e.what(), path.string(),
                      kRebuild);
  }
}

const std::optional<base::Error>& KanjiDatabase::trouble() const { return inside_->trouble; }

std::optional<Character> KanjiDatabase::find(char32_t code_point, std::string_view variant) const {
  return inside_->answer_or<std::optional<Character>>(std::nullopt, [&]() -> std::optional<Character> {
    if (const Character* own = inside_->find_own(code_point)) {
      return variant.empty() ? std::optional(*own) : std::nullopt;
    }
    const auto key = static_cast<std::int64_t>(code_point);
    Character out;
    out.code_point = code_point;
    out.variant = variant;
    {
      Rewound row(inside_->character);
      row->bind(1, key);
      if (!row->executeStep()) return std::nullopt;
      out.entry.grade = row.optional_number(1);
      out.entry.frequency = row.optional_number(2);
      out.entry.old_jlpt_level = row.optional_number(3);
      out.entry.radical = row.optional_number(4);
    }
    std::optional<std::int64_t> form;
    {
      Rewound row(inside_->form);
      row->bind(1, key);
      row->bind(2, std::string(variant));
      if (row->executeStep()) form = row->getColumn(0).getInt64();
    }
    if (!form && !variant.empty()) return std::nullopt;
    if (form) {
      Rewound stroke(inside_->strokes);
      stroke->bind(1, *form);
      while (stroke->executeStep()) out.strokes.push_back(read_stroke(stroke));
      std::vector<std::pair<int, Component>> rows;
      Rewound component(inside_->components);
      component->bind(1, *form);
      while (component->executeStep()) rows.emplace_back(component.number(0), read_component(component));
      out.components = assemble(std::move(rows));
    }
    const auto for_each_row = [&](SQLite::Statement& statement, const auto& take) {
      Rewound row(statement);
      row->bind(1, key);
      while (row->executeStep()) take(row);
    };
    if (variant.empty()) {
      for_each_row(inside_->variants, [&](Rewound& row) { out.variants.push_back(row.text(0)); });
      for_each_row(inside_->orders, [&](Rewound& row) {
        out.alternative_orders.push_back({read_numbers(row.text(0)), row.text(1)});
      });
    }
    for_each_row(inside_->stroke_counts,
                 [&](Rewound& row) { out.entry.stroke_counts.push_back(row.number(0)); });
    for_each_row(inside_->readings, [&](Rewound& row) {
      const auto kind = static_cast<ReadingKind>(row.number(0));
      auto& list = kind == ReadingKind::on    ? out.entry.on_readings
                   : kind == ReadingKind::kun ? out.entry.kun_readings
                                              : out.entry.nanori;
      list.push_back(row.text(1));
    });
    for_each_row(inside_->meanings, [&](Rewound& row) {
      out.entry.meanings.push_back({row.text(0), row.text(1)});
    });
    for_each_row(inside_->codes, [&](Rewound& row) {
      out.entry.codes.push_back({row.text(0), row.text(1)});
    });
    const auto form_of_it = variant.empty() ? inside_->forms.find(code_point) : inside_->forms.end();
    if (form_of_it != inside_->forms.end()) take_form(out, form_of_it->second);
    return out;
  });
}

std::vector<Summary> KanjiDatabase::list(List which) const {
  const auto belongs = [which](const RosterEntry& e) {
    switch (which) {
      case List::grade_1:
        return e.grade == 1;
      case List::grade_2:
        return e.grade == 2;
      case List::grade_3:
        return e.grade == 3;
      case List::grade_4:
        return e.grade == 4;
      case List::grade_5:
        return e.grade == 5;
      case List::grade_6:
        return e.grade == 6;
      case List::secondary:
        return e.grade == 8;
      case List::jinmeiyou:
        return e.grade == 9 || e.grade == 10;
      case List::hiragana:
        return e.kind == CharacterKind::hiragana;
      case List::katakana:
        return e.kind == CharacterKind::katakana;
      case List::latin_and_digits:
        return e.kind == CharacterKind::latin;
      case List::own:
        return e.is_made;
      case List::all:
        return e.drawn > 0;
    }
    return false;
  };
  return inside_->answer_or<std::vector<Summary>>({}, [&] {
    std::vector<Summary> out;
    const auto& roster = inside_->roster();
    for (std::size_t place = 0; place < roster.size(); ++place) {
      if (belongs(roster[place])) out.push_back(inside_->summary(place));
    }
    return out;
  });
}

std::optional<Summary> KanjiDatabase::summary(char32_t code_point) const {
  const auto place = inside_->place_of(code_point);
  return place ? std::optional(inside_->summary(*place)) : std::nullopt;
}

std::vector<std::string> KanjiDatabase::readings(char32_t code_point) const {
  return inside_->answer_or<std::vector<std::string>>({}, [&] {
    std::vector<std::string> out;
    Rewound row(inside_->readings);
    row->bind(1, static_cast<std::int64_t>(code_point));
    while (row->executeStep()) {
      if (static_cast<ReadingKind>(row.number(0)) != ReadingKind::nanori) out.push_back(row.text(1));
    }
    return out;
  });
}

bool KanjiDatabase::draws(char32_t code_point) const {
  const auto place = inside_->place_of(code_point);
  return place && inside_->roster()[*place].drawn > 0;
}

Word KanjiDatabase::Inside::read_word(Rewound& row) {
  Word word;
  word.text = row.text(0);
  word.reading = row->getColumn(1).isNull() ? word.text : row.text(1);
  word.parts_of_speech = row.text(2);
  const auto rank = static_cast<WordRank>(row.number(3));
  word.common = rank != WordRank::other;
  word.basic = rank == WordRank::basic;
  int sense = 1;
  std::string gloss;
  const auto finish = [&] {
    word.glosses.push_back(std::move(gloss));
    word.senses.push_back(sense);
    gloss.clear();
  };
  for (const char c : row.text(4)) {
    if (c != '/' && c != '\n') {
      gloss += c;
      continue;
    }
    finish();
    if (c == '\n') ++sense;
  }
  finish();
  return word;
}

std::vector<Word> KanjiDatabase::words(char32_t code_point, int limit) const {
  return inside_->answer_or<std::vector<Word>>({}, [&] {
    std::vector<Word> out;
    Rewound row(inside_->words);
    row->bind(1, static_cast<std::int64_t>(code_point));
    row->bind(2, std::max(limit, 0));
    while (row->executeStep()) out.push_back(Inside::read_word(row));
    return out;
  });
}

std::vector<Word> KanjiDatabase::words_heard_with(char32_t kana, int most_kana, int limit) const {
  return inside_->answer_or<std::vector<Word>>({}, [&] {
    std::vector<Word> out;
    Rewound row(inside_->heard_words);
    row->bind(1, most_kana);
    row->bind(2, base::encode_utf8(kana));
    row->bind(3, std::max(limit, 0));
    while (row->executeStep()) out.push_back(Inside::read_word(row));
    return out;
  });
}

std::vector<Summary> KanjiDatabase::containing(std::string_view element, int limit) const {
  return inside_->answer_or<std::vector<Summary>>({}, [&] {
    std::vector<Summary> out;
    Rewound row(inside_->elements);
    row->bind(1, std::string(element));
    row->bind(2, std::max(limit, 0));
    while (row->executeStep()) {
      const auto place = static_cast<std::size_t>(row.number(0));
      if (place < inside_->roster().size()) out.push_back(inside_->summary(place));
    }
    return out;
  });
}

std::vector<Source> KanjiDatabase::sources() const {
  return inside_->answer_or<std::vector<Source>>({}, [&] {
    std::vector<Source> out;
    Rewound row(inside_->sources);
    while (row->executeStep()) out.push_back({row.text(0), row.text(1), row.text(2), row.text(3)});
    return out;
  });
}

void KanjiDatabase::for_each_stroke(const std::function<void(const StrokePath&)>& take) const {
  inside_->answer_or(0, [&] {
    SQLite::Statement row(
        inside_->db,
        "SELECT f.code_point, c.place, s.path FROM form f JOIN main.character c ON "
        "c.code_point = f.code_point JOIN stroke s ON s.form = f.id WHERE f.variant = '' ORDER BY f.id, "
        "s.number");
    while (row.executeStep()) {
      const auto code_point = static_cast<char32_t>(row.getColumn(0).getInt());
      if (inside_->forms.contains(code_point)) continue;
      const auto path = row.getColumn(2);
      const char* text = path.getText();
      take({code_point, row.getColumn(1).getInt(), text});
    }
    for (const auto& [code_point, one] : inside_->forms) {
      const auto rank = static_cast<int>(inside_->place_of(code_point).value_or(0));
      for (const Stroke& stroke : one.strokes) take({code_point, rank, stroke.path});
    }
    auto place = static_cast<int>(inside_->first_own());
    for (const Character& one : inside_->own) {
      for (const Stroke& stroke : one.strokes) take({one.code_point, place, stroke.path});
      ++place;
    }
    return 0;
  });
}

}  // namespace nazori::kanji
