// SPDX-License-Identifier: Apache-2.0
#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <array>
#include <string>

#include "nazori/geometry/svg_path.h"
#include "nazori/ingest/ingest.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::ingest {
namespace {

struct Rule {
  const char* broken;  ///< the error if the query finds a row
  const char* sql;
};

/// Rules that the schema alone cannot express. Each query finds a row that breaks its rule.
constexpr auto kRules = std::to_array<Rule>({
    {"a form has no character",
     "SELECT code_point FROM form WHERE variant = '' AND code_point NOT IN (SELECT code_point FROM "
     "character)"},
    {"a form has no strokes", "SELECT id FROM form WHERE id NOT IN (SELECT form FROM stroke)"},
    {"a stroke has no form", "SELECT form FROM stroke WHERE form NOT IN (SELECT id FROM form)"},
    {"strokes are not numbered from 0 on",
     "SELECT form FROM stroke GROUP BY form HAVING min(number) <> 0 OR max(number) <> count(*) - 1"},
    {"a character says it has other strokes than it has",
     "SELECT c.code_point FROM character c LEFT JOIN form f ON f.code_point = c.code_point AND f.variant = "
     "'' "
     "WHERE c.strokes <> (SELECT count(*) FROM stroke s WHERE s.form = f.id)"},
    {"a form has no groups", "SELECT id FROM form WHERE id NOT IN (SELECT form FROM component)"},
    {"a group holds strokes that the form lacks",
     "SELECT g.form FROM component g WHERE g.first_stroke + g.stroke_count > "
     "(SELECT count(*) FROM stroke s WHERE s.form = g.form)"},
    {"a word in the index does not exist",
     "SELECT word FROM word_of WHERE word NOT IN (SELECT id FROM word)"},
    {"a key of a word has no word",
     "SELECT word FROM word_key WHERE word NOT IN (SELECT id FROM word) UNION ALL "
     "SELECT word FROM word_meaning_key WHERE word NOT IN (SELECT id FROM word)"},
    {"places have gaps", "SELECT 1 FROM character GROUP BY 1 HAVING max(place) <> count(*) - 1"},
    {"a search key has no character",
     "SELECT place FROM reading_key WHERE place NOT IN (SELECT place FROM character) UNION ALL "
     "SELECT place FROM meaning_key WHERE place NOT IN (SELECT place FROM character) UNION ALL "
     "SELECT place FROM element_of WHERE place NOT IN (SELECT place FROM character)"},
});

std::int64_t count(SQLite::Database& db, const char* sql) { return db.execAndGet(sql).getInt64(); }

Counts count_rows(SQLite::Database& db) {
  Counts out;
  out.characters = count(db, "SELECT count(*) FROM character");
  out.drawn_characters = count(db, "SELECT count(*) FROM character WHERE strokes > 0");
  out.variant_forms = count(db, "SELECT count(*) FROM form WHERE variant <> ''");
  out.strokes = count(db, "SELECT count(*) FROM stroke");
  out.components = count(db, "SELECT count(*) FROM component");
  out.dictionary_entries = count(db, "SELECT count(DISTINCT code_point) FROM stroke_count");
  out.alternative_orders = count(db, "SELECT count(*) FROM alternative_order");
  out.words = count(db, "SELECT count(*) FROM word");
  out.common_words = count(db, "SELECT count(*) FROM word WHERE common <> 0");
  out.radicals = count(db, "SELECT count(*) FROM radical");
  return out;
}

}  // namespace

base::Result<CheckReport> check_database(const std::filesystem::path& path) {
  // Opening it refuses a file that is not a kanji.db of this version, with the right message.
  if (const auto opened = kanji::KanjiDatabase::open(path); !opened) return tl::unexpected(opened.error());
  const auto damaged = [&](const std::string& how) {
    return base::fail(base::Errc::parse, "is damaged: " + how, path.string(),
                      "build it again: nazori-cli database build");
  };
  try {
    SQLite::Database db(path.string(), SQLite::OPEN_READONLY);
    // Every page is read, most of them several times. With the cache of 2 MB each read is a call of the
    // system.
    db.exec("PRAGMA cache_size = -131072");
    const std::string integrity = db.execAndGet("PRAGMA integrity_check(1)").getString();
    if (integrity != "ok") return damaged(integrity);
    for (const Rule& rule : kRules) {
      SQLite::Statement broken(db, rule.sql);
      if (broken.executeStep()) return damaged(rule.broken);
    }
    SQLite::Statement strokes(db, "SELECT path FROM stroke");
    while (strokes.executeStep()) {
      if (const auto read = geometry::parse_svg_path(strokes.getColumn(0).getText()); !read) {
        return damaged("a stroke cannot be read: " + read.error().what);
      }
    }
    CheckReport report;
    report.counts = count_rows(db);
    const Counts& c = report.counts;
    for (const std::int64_t rows : {c.drawn_characters, c.dictionary_entries, c.words, c.radicals}) {
      if (rows == 0) return damaged("a table is empty");
    }
    std::error_code ignored;
    report.bytes = std::filesystem::file_size(path, ignored);
    report.sqlite_version = sqlite3_libversion();
    return report;
  } catch (const SQLite::Exception& e) {
    return damaged(e.what());
  }
}

}  // namespace nazori::ingest
