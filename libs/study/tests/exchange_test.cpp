// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/exchange.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "learner_fixture.h"

namespace nazori::study {
namespace {

using nlohmann::json;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using test::TemporaryFolder;
using test::use_zone;
using testing::HasSubstr;

constexpr char32_t kRest = U'休';

/// A learner with one entry of every kind.
LearnerStore full_learner(MovedClock& clock) {
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  use_zone(store, "Asia/Tokyo");
  Settings settings = store.settings();
  settings.fuzz = true;
  settings.fsrs.desired_retention = 0.87;
  EXPECT_TRUE(store.change_settings(settings));
  for (const char32_t c : std::u32string_view(U"休木\"あ")) {
    Writing writing = review(Rating::hard);
    writing.result.help = 0.1;
    EXPECT_TRUE(store.add_writing(c, 4, writing, some_ink(static_cast<int>(c % 7))));
    clock.advance(std::chrono::hours(31));
    EXPECT_TRUE(store.add_writing(c, 4, review(Rating::easy)));
  }
  Writing trace = review(Rating::good);
  trace.stage = Stage::trace;
  EXPECT_TRUE(store.add_writing(kRest, 6, trace));
  EXPECT_TRUE(must(store.undo()));
  const std::array both{U'休', U'木'};
  EXPECT_TRUE(store.pause(both));
  EXPECT_TRUE(store.resume(both));
  EXPECT_TRUE(store.postpone(both, store.today() + std::chrono::days(3)));
  EXPECT_TRUE(store.leech_met(both));
  EXPECT_TRUE(store.reset(std::span(both).first(1)));
  EXPECT_TRUE(store.save_list({"trees & \"rest\"", {U'木', U'休'}}));
  const std::vector<std::string> tags{"exam"};
  EXPECT_TRUE(store.set_tags(kRest, tags));
  return store;
}

/// Every entry with its ink.
std::vector<std::pair<LogEntry, std::vector<std::uint8_t>>> everything_in(const LearnerStore& store) {
  std::vector<std::pair<LogEntry, std::vector<std::uint8_t>>> all;
  const auto read = store.for_each_with_ink([&](const auto& logged, std::span<const std::uint8_t> ink) {
    EXPECT_EQ(logged.has_ink, !ink.empty());
    all.emplace_back(logged.entry, std::vector(ink.begin(), ink.end()));
    return true;
  });
  EXPECT_TRUE(read);
  return all;
}

TEST(ExportJson, ComesBackExactly) {
  MovedClock clock("2026-01-01T09:00:00Z");
  const LearnerStore store = full_learner(clock);
  const std::string text = must(export_json(store));
  LearnerStore other = must(LearnerStore::in_memory(clock.clock()));
  const auto imported = import_json(other, text_source(text));
  ASSERT_TRUE(imported) << base::to_line(imported.error());
  EXPECT_EQ(must(export_json(other)), text);
  EXPECT_EQ(other.cards(), store.cards());
  EXPECT_EQ(other.settings(), store.settings());
  EXPECT_EQ(everything_in(other), everything_in(store));
}

TEST(ExportJson, BadInputIsRefusedWithItsLineAndNothingChanges) {
  MovedClock clock("2026-01-01T09:00:00Z");
  const std::string text = must(export_json(full_learner(clock)));
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    LearnerStore other = must(LearnerStore::in_memory(clock.clock()));
    const auto imported = import_json(other, text_source(changed));
    EXPECT_FALSE(imported) << to;
    EXPECT_EQ(other.last_entry(), 0) << to;
    EXPECT_TRUE(other.cards().empty() && must(other.lists()).empty()) << to;
    return imported ? std::string() : base::to_line(imported.error());
  };
  // The first entry is in line 3, the first writing in line 5.
  EXPECT_THAT(refusal("\"rating\":\"hard\"", "\"rating\":\"poor\""),
              testing::AllOf(HasSubstr("line 5"), HasSubstr("poor")));
  EXPECT_THAT(refusal("\"score\":85", "\"score\":850"),
              testing::AllOf(HasSubstr("line 5"), HasSubstr("0 to 100")));
  EXPECT_THAT(refusal("\"id\":3", "\"id\":30"), testing::AllOf(HasSubstr("line 5"), HasSubstr("order")));
  EXPECT_THAT(refusal("\"character\":\"休\"", "\"character\":\"休日\""), HasSubstr("one character"));
  EXPECT_THAT(refusal("\"ink\":\"A", "\"ink\":\"!"), HasSubstr("ink"));
  EXPECT_THAT(refusal("\"undoes\":", "\"undoes\":9"), HasSubstr("undoes no action"));
  EXPECT_THAT(refusal("0.87", "0.5"), HasSubstr("line 4"));
  EXPECT_THAT(refusal("nazori-learner", "letter"), HasSubstr("is not an export"));
  EXPECT_THAT(refusal("\"version\": 1", "\"version\": 2"), HasSubstr("newer"));
  EXPECT_THAT(refusal("\n],\n\"lists\"", "\n\"lists\""), HasSubstr("not JSON"));
}

/// Renames a table of a learner's file while it is open.
void take_away(const std::filesystem::path& file, const std::string& table) {
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE, 1'000)
      .exec("ALTER TABLE " + table + " RENAME TO gone");
}

TEST(ExportJson, ListsAndTagsThatCannotBeReadFailTheExport) {
  for (const char* table : {"list", "list_member", "tag", "ink", "log"}) {
    const TemporaryFolder folder;
    const LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write));
    ASSERT_TRUE(export_json(store)) << table;
    take_away(folder / "learner.db", table);
    const auto text = export_json(store);
    ASSERT_FALSE(text) << table;
    EXPECT_EQ(text.error().code, base::Errc::io) << table;
    EXPECT_THAT(text.error().where, HasSubstr("learner.db")) << table;
    EXPECT_EQ(export_csv(store).has_value(), table != std::string("ink") && table != std::string("log"));
  }
}

TEST(ExportCsv, IsATableWithALineForEachWriting) {
  MovedClock clock("2026-01-01T09:00:00Z");
  const std::string text = must(export_csv(full_learner(clock)));
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find("\r\n", at);
    ASSERT_NE(end, std::string::npos);
    lines.push_back(text.substr(at, end - at));
    at = end + 2;
  }
  ASSERT_EQ(lines.size(), 10U);
  EXPECT_TRUE(lines[1].starts_with(
      "3,2026-01-01T09:00:00.000Z,2026-01-01,\"休\",memory,hard,hard,1,85,wrong:3 ending:1,0,"))
      << lines[1];
  EXPECT_THAT(lines[5], HasSubstr(",\"\"\"\","));
  EXPECT_TRUE(lines[1].ends_with(",0"));
  EXPECT_TRUE(lines[9].ends_with(",1"));  // the one that was undone
  for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 19) << line;
}

kanji::KanjiDatabase open_kanji() {
  return must(kanji::KanjiDatabase::open(must(kanji::KanjiDatabase::locate())));
}

std::map<std::string, std::string> unzip(const std::vector<std::uint8_t>& bytes) {
  std::map<std::string, std::string> files;
  archive* zip = archive_read_new();
  archive_read_support_format_zip(zip);
  EXPECT_EQ(archive_read_open_memory(zip, bytes.data(), bytes.size()), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(zip, &entry) == ARCHIVE_OK) {
    std::string content;
    std::array<char, 8192> block{};
    for (la_ssize_t n = 0; (n = archive_read_data(zip, block.data(), block.size())) > 0;) {
      content.append(block.data(), static_cast<std::size_t>(n));
    }
    files[archive_entry_pathname(entry)] = content;
  }
  archive_read_free(zip);
  return files;
}

TEST(AnkiPackage, HoldsACollectionOfSchema11AndItsPictures) {
  const auto database = open_kanji();
  const Time now = *parse_time("2026-01-01T09:00:00Z");
  const std::u32string wanted = U"休木あカ休";
  const auto bytes = must(
      anki_package(database, std::vector<char32_t>(wanted.begin(), wanted.end()), {"Test::Deck", 3}, now));
  const auto files = unzip(bytes);
  ASSERT_TRUE(files.contains("collection.anki2") && files.contains("media"));
  const json media = json::parse(files.at("media"));
  ASSERT_EQ(media.size(), 4U);
  EXPECT_EQ(files.size(), 6U);
  for (const auto& [number, name] : media.items()) {
    const std::string& svg = files.at(number);
    EXPECT_TRUE(svg.starts_with("<svg ")) << name;
    EXPECT_THAT(svg, HasSubstr("KanjiVG"));
  }
  const TemporaryFolder folder;
  const std::string path = (folder / "collection.anki2").string();
  std::ofstream(path, std::ios::binary) << files.at("collection.anki2");
  SQLite::Database db(path, SQLite::OPEN_READONLY);
  EXPECT_EQ(db.execAndGet("PRAGMA integrity_check").getString(), "ok");
  EXPECT_EQ(db.execAndGet("SELECT ver FROM col").getInt(), 11);
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM notes").getInt(), 4);
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM cards JOIN notes ON cards.nid = notes.id").getInt(), 4);
  const json models = json::parse(db.execAndGet("SELECT models FROM col").getString());
  const json decks = json::parse(db.execAndGet("SELECT decks FROM col").getString());
  const std::string model = std::to_string(db.execAndGet("SELECT mid FROM notes").getInt64());
  const std::string deck = std::to_string(db.execAndGet("SELECT did FROM cards").getInt64());
  ASSERT_TRUE(models.contains(model) && decks.contains(deck));
  EXPECT_EQ(decks[deck]["name"], "Test::Deck");
  const std::string fields = db.execAndGet("SELECT flds FROM notes WHERE sfld = '休'").getString();
  EXPECT_EQ(static_cast<std::size_t>(std::count(fields.begin(), fields.end(), '\x1F')) + 1,
            models[model]["flds"].size());
  for (const char* part : {"休", "rest", "キュウ", "やす.む", "休む", "nazori-04f11.svg"}) {
    EXPECT_THAT(fields, HasSubstr(part));
  }
  // sha1sum of the three bytes of 休 begins with these eight digits.
  EXPECT_EQ(db.execAndGet("SELECT csum FROM notes WHERE sfld = '休'").getInt64(), 0x0AFBE7B5);
  EXPECT_THAT(db.execAndGet("SELECT flds FROM notes WHERE sfld = 'あ'").getString(),
              HasSubstr("a (hiragana)"));
  EXPECT_THAT(db.execAndGet("SELECT flds FROM notes WHERE sfld = 'カ'").getString(),
              HasSubstr("ka (katakana)"));
}

TEST(AnkiPackage, AsksSomethingOfEveryKanaAndKanji) {
  // Anki offers to delete a card with an empty question.
  const auto database = open_kanji();
  std::vector<char32_t> wanted;
  for (const auto list : {kanji::List::hiragana, kanji::List::katakana, kanji::List::grade_1}) {
    for (const kanji::Summary& one : database.list(list)) wanted.push_back(one.code_point);
  }
  const auto files = unzip(must(anki_package(database, wanted, {}, {})));
  const TemporaryFolder folder;
  const std::string path = (folder / "collection.anki2").string();
  std::ofstream(path, std::ios::binary) << files.at("collection.anki2");
  SQLite::Database db(path, SQLite::OPEN_READONLY);
  SQLite::Statement notes(db, "SELECT sfld, flds FROM notes");
  int asked = 0;
  while (notes.executeStep()) {
    const std::string fields = notes.getColumn(1).getString();
    const auto meaning = fields.find('\x1F') + 1;
    EXPECT_FALSE(fields.substr(meaning).starts_with("\x1F\x1F\x1F")) << notes.getColumn(0).getString();
    ++asked;
  }
  EXPECT_GT(asked, 240);
  EXPECT_THAT(db.execAndGet("SELECT flds FROM notes WHERE sfld = 'ょ'").getString(),
              HasSubstr("small yo (hiragana)"));
  EXPECT_THAT(db.execAndGet("SELECT flds FROM notes WHERE sfld = 'ァ'").getString(),
              HasSubstr("small a (katakana)"));
  EXPECT_THAT(db.execAndGet("SELECT flds FROM notes WHERE sfld = 'ヴ'").getString(),
              HasSubstr("vu (katakana)"));
}

TEST(AnkiPackage, RefusesWhatCannotBe) {
  const auto database = open_kanji();
  const std::array one{U'休'};
  const std::array none{U'\x1F600'};
  EXPECT_EQ(anki_package(database, none, {}, {}).error().code, base::Errc::not_found);
  EXPECT_EQ(anki_package(database, one, {"", 3}, {}).error().code, base::Errc::bad_argument);
  EXPECT_EQ(anki_package(database, one, {"Deck", 99}, {}).error().where, "words");
  EXPECT_EQ(anki_package(database, one, {}, {}, [](double, std::string_view) { return false; }).error().code,
            base::Errc::cancelled);
}

TEST(StrokeOrderSvg, HasASquareForEachStroke) {
  const auto character = open_kanji().find(kRest);
  ASSERT_TRUE(character);
  const std::string svg = stroke_order_svg(*character);
  std::size_t dots = 0;
  for (std::size_t at = 0; (at = svg.find("<circle", at)) != std::string::npos; ++at) ++dots;
  EXPECT_EQ(dots, 6U);
  EXPECT_THAT(svg, HasSubstr(character->strokes[5].path));
}

}  // namespace
}  // namespace nazori::study
