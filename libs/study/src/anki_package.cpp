// SPDX-License-Identifier: Apache-2.0
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <sqlite3.h>

#include <array>
#include <memory>

#include "nazori/archive/zip.h"
#include "nazori/base/utf8.h"
#include "nazori/json/json.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/kanji/own_characters.h"
#include "nazori/study/exchange.h"

namespace nazori::study {
namespace {

using base::Errc;
using Bytes = std::vector<std::uint8_t>;

// Fixed, so that a second import finds the first. Anki takes moments in milliseconds for numbers.
constexpr std::int64_t kModel = 1'763'700'000'001;
constexpr std::int64_t kDeck = 1'763'700'000'002;
constexpr std::int64_t kFirstNote = 1'763'700'100'000;
constexpr std::int64_t kFirstCard = 1'763'702'000'000;
constexpr std::time_t kTimeOfFiles = 1'763'700'000;
constexpr char kBetweenFields = 0x1F;
constexpr int kMostWords = 20;
constexpr char32_t kFirstKatakana = 0x30A0;
constexpr char32_t kLastKatakana = 0x30FF;

constexpr const char* kTables = R"sql(
CREATE TABLE col(id integer primary key, crt integer not null, mod integer not null, scm integer not null,
  ver integer not null, dty integer not null, usn integer not null, ls integer not null, conf text not null,
  models text not null, decks text not null, dconf text not null, tags text not null);
CREATE TABLE notes(id integer primary key, guid text not null, mid integer not null, mod integer not null,
  usn integer not null, tags text not null, flds text not null, sfld integer not null, csum integer not null,
  flags integer not null, data text not null);
CREATE TABLE cards(id integer primary key, nid integer not null, did integer not null, ord integer not null,
  mod integer not null, usn integer not null, type integer not null, queue integer not null,
  due integer not null, ivl integer not null, factor integer not null, reps integer not null,
  lapses integer not null, left integer not null, odue integer not null, odid integer not null,
  flags integer not null, data text not null);
CREATE TABLE revlog(id integer primary key, cid integer not null, usn integer not null, ease integer not null,
  ivl integer not null, lastIvl integer not null, factor integer not null, time integer not null,
  type integer not null);
CREATE TABLE graves(usn integer not null, oid integer not null, type integer not null);
CREATE INDEX ix_notes_usn ON notes(usn);
CREATE INDEX ix_cards_usn ON cards(usn);
CREATE INDEX ix_revlog_usn ON revlog(usn);
CREATE INDEX ix_cards_nid ON cards(nid);
CREATE INDEX ix_cards_sched ON cards(did, queue, due);
CREATE INDEX ix_revlog_cid ON revlog(cid);
CREATE INDEX ix_notes_csum ON notes(csum);
)sql";

constexpr const char* kQuestion =
    "<div class=meaning>{{Meanings}}</div><div class=reading>{{On}}</div><div class=reading>{{Kun}}</div>";
constexpr const char* kAnswer =
    "{{FrontSide}}<hr id=answer><div class=kanji lang=ja>{{Kanji}}</div><div>{{Strokes}}</div>"
    "<div class=words lang=ja>{{Words}}</div><div class=source>Strokes: KanjiVG (CC BY-SA 3.0), but for own "
    "characters. "
    "Readings, meanings, words: KANJIDIC2 and EDICT (EDRDG, CC BY-SA 4.0).</div>";
constexpr const char* kStyle =
    ".card { font-family: sans-serif; font-size: 22px; text-align: center; }\n"
    ".kanji { font-family: 'Klee One', 'Noto Sans CJK JP', sans-serif; font-size: 120px; }\n"
    ".words { font-size: 18px; }\n.source { font-size: 10px; color: #888; margin-top: 2em; }\n"
    "img { max-width: 100%; }\n";

std::string for_html(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case kBetweenFields:
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string joined(std::span<const std::string> texts, const char* between) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : between) + for_html(text);
  return all;
}

/// Anki's checksum of a first field: the first 32 bits of SHA-1.
std::int64_t checksum(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha1(), nullptr) != 1) return 0;
  return (static_cast<std::int64_t>(digest[0]) << 24) | (digest[1] << 16) | (digest[2] << 8) | digest[3];
}

json::Value models_json(std::int64_t seconds) {
  json::Value fields = json::Value::array();
  int place = 0;
  for (const char* name : {"Kanji", "Meanings", "On", "Kun", "Words", "Strokes"}) {
    fields.push_back({{"name", name},
                      {"ord", place++},
                      {"sticky", false},
                      {"rtl", false},
                      {"font", "Arial"},
                      {"size", 20},
                      {"media", json::Value::array()}});
  }
  const json::Value card{{"name", "Write"}, {"ord", 0},    {"qfmt", kQuestion}, {"afmt", kAnswer},
                         {"did", nullptr},  {"bqfmt", ""}, {"bafmt", ""}};
  return {{std::to_string(kModel),
           {{"id", kModel},
            {"name", "Nazori kanji"},
            {"type", 0},
            {"mod", seconds},
            {"usn", -1},
            {"sortf", 0},
            {"did", kDeck},
            {"tmpls", json::Value::array({card})},
            {"flds", fields},
            {"css", kStyle},
            {"latexPre", ""},
            {"latexPost", ""},
            {"req", json::Value::array({json::Value::array({0, "any", json::Value::array({1, 2, 3})})})},
            {"tags", json::Value::array()},
            {"vers", json::Value::array()}}}};
}

json::Value deck_json(std::int64_t id, const std::string& name, std::int64_t seconds) {
  const json::Value today = json::Value::array({0, 0});
  return {{"id", id},          {"name", name},      {"mod", seconds},     {"usn", -1},
          {"desc", ""},        {"dyn", 0},          {"collapsed", false}, {"browserCollapsed", false},
          {"conf", 1},         {"extendNew", 0},    {"extendRev", 0},     {"newToday", today},
          {"revToday", today}, {"lrnToday", today}, {"timeToday", today}};
}

json::Value deck_options_json(std::int64_t seconds) {
  return {{"1",
           {{"id", 1},
            {"name", "Default"},
            {"mod", seconds},
            {"usn", -1},
            {"maxTaken", 60},
            {"autoplay", true},
            {"timer", 0},
            {"replayq", true},
            {"dyn", false},
            {"new",
             {{"delays", {1, 10}},
              {"ints", {1, 4, 7}},
              {"initialFactor", 2500},
              {"order", 1},
              {"perDay", 20},
              {"bury", false},
              {"separate", true}}},
            {"rev",
             {{"perDay", 200},
              {"ease4", 1.3},
              {"fuzz", 0.05},
              {"minSpace", 1},
              {"ivlFct", 1},
              {"maxIvl", 36500},
              {"bury", false}}},
            {"lapse",
             {{"delays", json::Value::array({10})},
              {"mult", 0},
              {"minInt", 1},
              {"leechFails", 8},
              {"leechAction", 0}}}}}};
}

void insert_collection(SQLite::Database& db, const std::string& deck, Time now) {
  const std::int64_t milliseconds = now.time_since_epoch().count();
  const std::int64_t seconds = milliseconds / 1000;
  const json::Value configuration{
      {"nextPos", 1},          {"estTimes", true},  {"activeDecks", json::Value::array({1})},
      {"sortType", "noteFld"}, {"timeLim", 0},      {"sortBackwards", false},
      {"addToCur", true},      {"curDeck", 1},      {"newBury", true},
      {"newSpread", 0},        {"dueCounts", true}, {"curModel", std::to_string(kModel)},
      {"collapseTime", 1200}};
  const json::Value decks{{"1", deck_json(1, "Default", seconds)},
                          {std::to_string(kDeck), deck_json(kDeck, deck, seconds)}};
  SQLite::Statement insert(db, "INSERT INTO col VALUES(1,?,?,?,11,0,0,0,?,?,?,?,'{}')");
  insert.bind(1, seconds);
  insert.bind(2, milliseconds);
  insert.bind(3, milliseconds);
  insert.bind(4, configuration.dump());
  insert.bind(5, models_json(seconds).dump());
  insert.bind(6, decks.dump());
  insert.bind(7, deck_options_json(seconds).dump());
  insert.exec();
}

std::string picture_name(char32_t character) {
  return fmt::format("nazori-{:05x}.svg", static_cast<unsigned>(character));
}

std::string shape_name(char32_t character) {
  return fmt::format("nazori-{:05x}-shape.svg", static_cast<unsigned>(character));
}

/// Whether no font shows the character as it is: somebody made it, or its form.
bool is_made(const kanji::Character& character) {
  return kanji::is_own(character.code_point) || character.own_form;
}

/// The character alone, as large as a letter.
std::string shape_svg(const kanji::Character& character) {
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 109 109\" width=\"120\" height=\"120\" "
      "fill=\"none\" stroke=\"#888\" stroke-width=\"4.4\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">";
  for (const kanji::Stroke& stroke : character.strokes) svg += "<path d=\"" + stroke.path + "\"/>";
  return svg + "</svg>\n";
}

/// The letter as it is shown, which is the first field of the note.
std::string sign_of(const kanji::Character& character) {
  return is_made(character) ? "<img src=\"" + shape_name(character.code_point) + "\">"
                            : for_html(base::encode_utf8(character.code_point));
}

/// What a kana is asked for by: "ka (katakana)"; nothing for other characters.
std::string sound_of(char32_t kana) {
  const auto sound = kanji::kana_sound(kana);
  if (!sound) return {};
  // Of kana that sound the same, how they are typed tells which is meant.
  std::string name = sound->typed.empty() ? sound->romaji : sound->typed;
  if (name == "-") name = "long vowel mark";
  return (sound->is_small ? "small " : "") + name +
         (kana >= kFirstKatakana && kana <= kLastKatakana ? " (katakana)" : " (hiragana)");
}

std::string fields_of(const kanji::Character& character, std::span<const kanji::Word> words) {
  const kanji::DictionaryEntry& entry = character.entry;
  std::vector<std::string> meanings;
  for (const kanji::Meaning& meaning : entry.meanings) {
    if (meaning.language == "en") meanings.push_back(meaning.text);
  }
  std::string word_lines;
  for (const kanji::Word& word : words) {
    const std::string gloss = word.glosses.empty() ? "" : word.glosses.front();
    word_lines += fmt::format("{}{}（{}） {}", word_lines.empty() ? "" : "<br>", for_html(word.text),
                              for_html(word.reading), for_html(gloss));
  }
  std::string meaning = meanings.empty() ? sound_of(character.code_point) : joined(meanings, ", ");
  // A card that asks nothing is one that Anki offers to delete.
  if (meaning.empty() && entry.on_readings.empty() && entry.kun_readings.empty())
    meaning = fmt::format("U+{:04X}", static_cast<unsigned>(character.code_point));
  return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}<img src=\"{6}\">", kBetweenFields, sign_of(character),
                     meaning, joined(entry.on_readings, "、"), joined(entry.kun_readings, "、"), word_lines,
                     picture_name(character.code_point));
}

void insert_note(SQLite::Database& db, const kanji::Character& character, const std::string& fields,
                 int position, Time now) {
  const std::int64_t seconds = now.time_since_epoch().count() / 1000;
  const std::string sign = base::encode_utf8(character.code_point);
  SQLite::Statement note(db, "INSERT INTO notes VALUES(?,?,?,?,-1,?,?,?,?,0,'')");
  note.bind(1, kFirstNote + static_cast<std::int64_t>(character.code_point));
  note.bind(2, fmt::format("nazori-{:05x}", static_cast<unsigned>(character.code_point)));
  note.bind(3, kModel);
  note.bind(4, seconds);
  note.bind(5, character.entry.grade ? fmt::format(" grade-{} ", *character.entry.grade) : "");
  note.bind(6, fields);
  note.bind(7, sign);
  // Of a picture Anki takes the name between spaces.
  note.bind(8, checksum(is_made(character) ? " " + shape_name(character.code_point) + " " : for_html(sign)));
  note.exec();
  SQLite::Statement card(db, "INSERT INTO cards VALUES(?,?,?,0,?,-1,0,0,?,0,0,0,0,0,0,0,0,'')");
  card.bind(1, kFirstCard + static_cast<std::int64_t>(character.code_point));
  card.bind(2, kFirstNote + static_cast<std::int64_t>(character.code_point));
  card.bind(3, kDeck);
  card.bind(4, seconds);
  card.bind(5, position);
  card.exec();
}

Bytes serialized(SQLite::Database& db) {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
      sqlite3_serialize(db.getHandle(), "main", &size, 0), &sqlite3_free);
  if (bytes == nullptr) return {};
  return {bytes.get(), bytes.get() + size};
}

std::span<const std::uint8_t> as_bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

base::Result<Bytes> anki_package(const kanji::KanjiDatabase& database, std::span<const char32_t> characters,
                                 const AnkiOptions& options, Time now, const base::Progress& progress) {
  if (!can_be_name(options.deck)) {
    return base::fail(Errc::bad_argument, "is not a valid deck name", options.deck,
                      "give 1 to 100 bytes of text");
  }
  if (options.words < 0 || options.words > kMostWords) {
    return base::fail(Errc::bad_argument, fmt::format("{} is out of range", options.words), "words",
                      "give 0 to 20");
  }
  try {
    SQLite::Database db(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec(kTables);
    insert_collection(db, options.deck, now);
    archive::ZipWriter zip({}, kTimeOfFiles);
    json::Value media = json::Value::object();
    int position = 0;
    int pictures = 0;
    SQLite::Transaction transaction(db);
    for (std::size_t i = 0; i < characters.size(); ++i) {
      if (progress &&
          !progress(static_cast<double>(i) / static_cast<double>(characters.size()), "Anki package")) {
        return base::fail(Errc::cancelled, "stopped");
      }
      const auto character = database.find(characters[i]);
      const std::string name = picture_name(characters[i]);
      if (!character || character->strokes.empty() || media.contains(name)) continue;
      std::vector<kanji::Word> words;
      if (options.words > 0) words = database.words(characters[i], options.words);
      insert_note(db, *character, fields_of(*character, words), position + 1, now);
      const std::string svg = stroke_order_svg(*character);
      zip.add(std::to_string(pictures), as_bytes(svg));
      media[name] = std::to_string(pictures++);
      if (is_made(*character)) {
        const std::string shape = shape_svg(*character);
        zip.add(std::to_string(pictures), as_bytes(shape));
        media[shape_name(characters[i])] = std::to_string(pictures++);
      }
      ++position;
    }
    transaction.commit();
    if (database.trouble()) return tl::unexpected(*database.trouble());
    if (position == 0) return base::fail(Errc::not_found, "none of the characters has strokes", "characters");
    json::Value names = json::Value::object();
    for (const auto& [name, number] : media.items()) names[number.get<std::string>()] = name;
    const std::string index = names.dump();
    zip.add("media", as_bytes(index));
    zip.add("collection.anki2", serialized(db));
    return zip.finish();
  } catch (const SQLite::Exception& trouble) {
    return base::fail(Errc::io, std::string("cannot be built: ") + trouble.what(), "the Anki package");
  }
}

}  // namespace nazori::study
