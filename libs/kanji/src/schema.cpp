// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/schema.h"

namespace nazori::kanji {

std::string_view schema_sql() {
  return R"sql(
-- The published files this database was built from.
CREATE TABLE source(
  position INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  version TEXT NOT NULL,
  sha256 TEXT NOT NULL,           -- of the file as fetched, hexadecimal
  licence TEXT NOT NULL);

-- Every character that has strokes or a dictionary entry.
CREATE TABLE character(
  code_point INTEGER PRIMARY KEY,
  place INTEGER NOT NULL UNIQUE,  -- 0, 1, 2, ...: the commonest first
  kind INTEGER NOT NULL,          -- CharacterKind
  strokes INTEGER NOT NULL,       -- of the main form; 0 where nothing is drawn
  counted INTEGER NOT NULL,       -- the dictionary's accepted stroke count; 0 where it has none
  grade INTEGER,
  frequency INTEGER,
  old_jlpt INTEGER,
  radical INTEGER,
  meaning TEXT NOT NULL,          -- the first English one, or ''
  reading TEXT NOT NULL);         -- the first kun or on reading, or ''

-- What the dictionary says, in its order.
CREATE TABLE stroke_count(code_point INTEGER, position INTEGER, count INTEGER NOT NULL,
  PRIMARY KEY(code_point, position)) WITHOUT ROWID;
CREATE TABLE reading(code_point INTEGER, position INTEGER, kind INTEGER NOT NULL, text TEXT NOT NULL,
  PRIMARY KEY(code_point, position)) WITHOUT ROWID;
CREATE TABLE meaning(code_point INTEGER, position INTEGER, language TEXT NOT NULL, text TEXT NOT NULL,
  PRIMARY KEY(code_point, position)) WITHOUT ROWID;
CREATE TABLE code(code_point INTEGER, position INTEGER, system TEXT NOT NULL, value TEXT NOT NULL,
  PRIMARY KEY(code_point, position)) WITHOUT ROWID;

-- The drawn forms: '' is the main one, the others have KanjiVG's suffix.
CREATE TABLE form(
  id INTEGER PRIMARY KEY,
  code_point INTEGER NOT NULL,
  variant TEXT NOT NULL,
  UNIQUE(code_point, variant));
CREATE TABLE stroke(
  form INTEGER,
  number INTEGER,                 -- from 0, in writing order
  path TEXT NOT NULL,             -- SVG path data as published
  type TEXT NOT NULL,             -- kvg:type as published, or ''
  ending INTEGER NOT NULL,        -- StrokeEnding
  number_x REAL, number_y REAL,   -- baseline left of the printed number, glyph units
  PRIMARY KEY(form, number)) WITHOUT ROWID;
-- KanjiVG's groups, a parent before its children; strokes first_stroke .. first_stroke + stroke_count - 1.
CREATE TABLE component(
  form INTEGER,
  position INTEGER,               -- from 0, the root
  parent INTEGER NOT NULL,        -- position of the parent, -1 for the root
  first_stroke INTEGER NOT NULL,
  stroke_count INTEGER NOT NULL,
  element TEXT, original TEXT, place TEXT, radical TEXT, phon TEXT,
  part INTEGER, number INTEGER,
  flags INTEGER NOT NULL,         -- 1 variant, 2 partial, 4 tradForm, 8 radicalForm
  PRIMARY KEY(form, position)) WITHOUT ROWID;
CREATE TABLE alternative_order(
  code_point INTEGER,
  position INTEGER,
  stroke_numbers TEXT NOT NULL,   -- "1 3 2": numbers of the main form in the order they are written
  source TEXT NOT NULL,
  PRIMARY KEY(code_point, position)) WITHOUT ROWID;

-- The 214 classical radicals.
CREATE TABLE radical(number INTEGER PRIMARY KEY, form TEXT NOT NULL, strokes INTEGER NOT NULL,
  english_name TEXT NOT NULL);
CREATE TABLE radical_form(number INTEGER, position INTEGER, form TEXT NOT NULL,
  PRIMARY KEY(number, position)) WITHOUT ROWID;
CREATE TABLE radical_name(number INTEGER, position INTEGER, name TEXT NOT NULL,
  PRIMARY KEY(number, position)) WITHOUT ROWID;

-- Words; a smaller id is a commoner word.
CREATE TABLE word(
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL,
  reading TEXT,                   -- NULL: the same as text
  parts_of_speech TEXT NOT NULL,
  common INTEGER NOT NULL,        -- WordRank
  glosses TEXT NOT NULL);         -- senses apart by line breaks, glosses of a sense by '/'
CREATE TABLE word_of(code_point INTEGER, word INTEGER, PRIMARY KEY(code_point, word)) WITHOUT ROWID;

-- For searching. Readings are hiragana without marks; meanings are lower-case English words, single spaces.
CREATE TABLE reading_key(key TEXT, place INTEGER, fit INTEGER NOT NULL,
  PRIMARY KEY(key, place)) WITHOUT ROWID;
CREATE TABLE meaning_key(key TEXT, place INTEGER, fit INTEGER NOT NULL,
  PRIMARY KEY(key, place)) WITHOUT ROWID;
-- The reading of a word as above, and its text if that has other characters than kana.
CREATE TABLE word_key(key TEXT, word INTEGER, PRIMARY KEY(key, word)) WITHOUT ROWID;
-- Of common words. Glosses without the marks of the editors, brackets and "to", "a", "an", "the" in front.
CREATE TABLE word_meaning_key(key TEXT, word INTEGER, fit INTEGER NOT NULL,
  PRIMARY KEY(key, word)) WITHOUT ROWID;
CREATE INDEX code_value ON code(system, value);
CREATE TABLE element_of(element TEXT, place INTEGER, PRIMARY KEY(element, place)) WITHOUT ROWID;
)sql";
}

}  // namespace nazori::kanji
