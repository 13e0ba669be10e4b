// SPDX-License-Identifier: Apache-2.0
// Each field and number of an Anki package.
#include <SQLiteCpp/SQLiteCpp.h>
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "learner_fixture.h"
#include "nazori/base/utf8.h"
#include "nazori/study/exchange.h"

namespace nazori::study {
namespace {

using nlohmann::json;
using test::must;
using test::TemporaryFolder;
using testing::ElementsAre;

const kanji::KanjiDatabase& database() {
  static const kanji::KanjiDatabase opened =
      must(kanji::KanjiDatabase::open(must(kanji::KanjiDatabase::locate())));
  return opened;
}

/// The parts of a package.
class Package {
 public:
  explicit Package(std::u32string_view characters, const AnkiOptions& options = {},
                   Time now = *parse_time("2026-01-01T09:00:00.250Z"),
                   const kanji::KanjiDatabase& from = database()) {
    const auto bytes =
        must(anki_package(from, std::vector(characters.begin(), characters.end()), options, now));
    archive* zip = archive_read_new();
    archive_read_support_format_zip(zip);
    EXPECT_EQ(archive_read_open_memory(zip, bytes.data(), bytes.size()), ARCHIVE_OK);
    archive_entry* entry = nullptr;
    while (archive_read_next_header(zip, &entry) == ARCHIVE_OK) {
      std::string content(static_cast<std::size_t>(archive_entry_size(entry)), '\0');
      EXPECT_EQ(archive_read_data(zip, content.data(), content.size()), archive_entry_size(entry));
      EXPECT_EQ(archive_entry_filetype(entry), static_cast<unsigned>(AE_IFREG));
      EXPECT_EQ(archive_entry_perm(entry), 0644U);
      files_[archive_entry_pathname(entry)] = content;
    }
    archive_read_free(zip);
    std::ofstream(folder_ / "c.db", std::ios::binary) << files_["collection.anki2"];
    db_.emplace((folder_ / "c.db").string(), SQLite::OPEN_READONLY);
  }
  [[nodiscard]] const std::map<std::string, std::string>& files() const { return files_; }
  /// The rows of a question, their columns with | between them.
  [[nodiscard]] std::vector<std::string> rows(const std::string& sql) const {
    SQLite::Statement statement(*db_, sql);
    std::vector<std::string> rows;
    while (statement.executeStep()) {
      std::string& row = rows.emplace_back();
      for (int i = 0; i < statement.getColumnCount(); ++i)
        row += (i == 0 ? "" : "|") + statement.getColumn(i).getString();
    }
    return rows;
  }
  [[nodiscard]] json member(const char* name) const {
    return json::parse(rows(std::string("SELECT ") + name + " FROM col").at(0));
  }
  [[nodiscard]] std::vector<std::string> fields(const std::string& sign) const {
    std::vector<std::string> fields(1);
    const std::string joined = rows("SELECT flds FROM notes WHERE sfld = '" + sign + "'").at(0);
    for (const char c : joined) {
      if (c == '\x1F')
        fields.emplace_back();
      else
        fields.back() += c;
    }
    return fields;
  }

 private:
  TemporaryFolder folder_;
  std::map<std::string, std::string> files_;
  std::optional<SQLite::Database> db_;
};

TEST(AnkiCollection, IsOfSchema11AndOfTheMomentItIsMade) {
  // 2026-01-01T09:00:00.250Z
  const Package package(U"休");
  EXPECT_THAT(package.rows("SELECT id, crt, mod, scm, ver, dty, usn, ls, tags FROM col"),
              ElementsAre("1|1767258000|1767258000250|1767258000250|11|0|0|0|{}"));
  const json decks = package.member("decks");
  ASSERT_EQ(decks.size(), 2U);
  EXPECT_EQ(decks["1"]["name"], "Default");
  const std::string deck = package.rows("SELECT did FROM cards").at(0);
  EXPECT_EQ(decks[deck]["name"], "Nazori");
  for (const char* id : {"1", deck.c_str()}) {
    json expected{{"id", std::stoll(id)},
                  {"name", decks[id]["name"]},
                  {"mod", 1'767'258'000},
                  {"usn", -1},
                  {"desc", ""},
                  {"dyn", 0},
                  {"collapsed", false},
                  {"browserCollapsed", false},
                  {"conf", 1},
                  {"extendNew", 0},
                  {"extendRev", 0}};
    for (const char* today : {"newToday", "revToday", "lrnToday", "timeToday"}) expected[today] = {0, 0};
    EXPECT_EQ(decks[id], expected);
  }
}

TEST(AnkiCollection, HasTheOptionsThatAnkiBeginsWith) {
  // AnkiDroid wiki, "Database Structure": conf and dconf of a new collection.
  const Package package(U"休");
  const std::string model = package.rows("SELECT mid FROM notes").at(0);
  EXPECT_EQ(package.member("conf"), (json{{"nextPos", 1},
                                          {"estTimes", true},
                                          {"activeDecks", {1}},
                                          {"sortType", "noteFld"},
                                          {"timeLim", 0},
                                          {"sortBackwards", false},
                                          {"addToCur", true},
                                          {"curDeck", 1},
                                          {"newBury", true},
                                          {"newSpread", 0},
                                          {"dueCounts", true},
                                          {"curModel", model},
                                          {"collapseTime", 1'200}}));
  const json options = package.member("dconf")["1"];
  EXPECT_EQ(options["id"], 1);
  EXPECT_EQ(options["name"], "Default");
  EXPECT_EQ(options["mod"], 1'767'258'000);
  EXPECT_EQ(options["usn"], -1);
  EXPECT_EQ(options["maxTaken"], 60);
  EXPECT_EQ(options["timer"], 0);
  EXPECT_EQ(options["autoplay"], true);
  EXPECT_EQ(options["replayq"], true);
  EXPECT_EQ(options["new"], (json{{"delays", {1, 10}},
                                  {"ints", {1, 4, 7}},
                                  {"initialFactor", 2'500},
                                  {"order", 1},
                                  {"perDay", 20},
                                  {"bury", false},
                                  {"separate", true}}));
  EXPECT_EQ(options["rev"], (json{{"perDay", 200},
                                  {"ease4", 1.3},
                                  {"fuzz", 0.05},
                                  {"minSpace", 1},
                                  {"ivlFct", 1},
                                  {"maxIvl", 36'500},
                                  {"bury", false}}));
  EXPECT_EQ(options["lapse"],
            (json{{"delays", {10}}, {"mult", 0}, {"minInt", 1}, {"leechFails", 8}, {"leechAction", 0}}));
}

TEST(AnkiCollection, DescribesItsFieldsAndItsCard) {
  const Package package(U"休");
  const std::string id = package.rows("SELECT mid FROM notes").at(0);
  const json model = package.member("models")[id];
  EXPECT_EQ(model["id"], std::stoll(id));
  EXPECT_EQ(model["name"], "Nazori kanji");
  EXPECT_EQ(model["type"], 0) << "no cloze";
  EXPECT_EQ(model["mod"], 1'767'258'000);
  EXPECT_EQ(model["usn"], -1);
  EXPECT_EQ(model["sortf"], 0);
  EXPECT_EQ(std::to_string(model["did"].get<std::int64_t>()), package.rows("SELECT did FROM cards").at(0));
  // The question shows the fields 1 to 3; the card needs at least one of them.
  EXPECT_EQ(model["req"], json::parse(R"([[0, "any", [1, 2, 3]]])"));
  const std::array kNames{"Kanji", "Meanings", "On", "Kun", "Words", "Strokes"};
  ASSERT_EQ(model["flds"].size(), kNames.size());
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    EXPECT_EQ(model["flds"][i], (json{{"name", kNames.at(i)},
                                      {"ord", i},
                                      {"sticky", false},
                                      {"rtl", false},
                                      {"font", "Arial"},
                                      {"size", 20},
                                      {"media", json::array()}}));
  }
  ASSERT_EQ(model["tmpls"].size(), 1U);
  EXPECT_EQ(model["tmpls"][0]["ord"], 0);
  EXPECT_EQ(model["tmpls"][0]["did"], nullptr);
}

TEST(AnkiNotes, HaveNumbersThatStayWhateverElseIsInThePackage) {
  const Package alone(U"木", {}, *parse_time("2026-05-05T00:00:00Z"));
  const Package both(U"休木");
  for (const char* table :
       {"SELECT id, guid, mid FROM notes WHERE sfld = '木'",
        "SELECT id, nid, did FROM cards WHERE nid = (SELECT id FROM notes WHERE sfld = '木')"})
    EXPECT_EQ(alone.rows(table), both.rows(table));
  EXPECT_THAT(both.rows("SELECT guid FROM notes ORDER BY id"), ElementsAre("nazori-04f11", "nazori-06728"));
  // The numbers differ as much as the code points.
  EXPECT_THAT(both.rows("SELECT max(id) - min(id) FROM notes"), ElementsAre(std::to_string(0x6728 - 0x4F11)));
  EXPECT_THAT(both.rows("SELECT max(id) - min(id) FROM cards"), ElementsAre(std::to_string(0x6728 - 0x4F11)));
  // Anki's ids of notes and cards are times in milliseconds, in two tables.
  EXPECT_THAT(both.rows("SELECT count(*) FROM notes WHERE id BETWEEN 1500000000000 AND 1800000000000"),
              ElementsAre("2"));
}

TEST(AnkiNotes, KeepTheNumbersOfTheFirstPackages) {
  // An Anki that imported an older package finds its notes by these numbers. 休 is U+4F11, 20241.
  const Package package(U"休");
  EXPECT_THAT(package.rows("SELECT id, mid FROM notes"), ElementsAre("1763700120241|1763700000001"));
  EXPECT_THAT(package.rows("SELECT id, nid, did FROM cards"),
              ElementsAre("1763702020241|1763700120241|1763700000002"));
}

TEST(AnkiNotes, AreNewCardsInTheOrderThatWasGiven) {
  const Package package(U"木休一木");
  EXPECT_THAT(
      package.rows("SELECT sfld, ord, cards.mod, cards.usn, type, queue, due, ivl, factor, reps, lapses, "
                   "left, odue, odid, cards.flags, cards.data FROM cards JOIN notes ON nid = notes.id "
                   "ORDER BY due"),
      ElementsAre("木|0|1767258000|-1|0|0|1|0|0|0|0|0|0|0|0|", "休|0|1767258000|-1|0|0|2|0|0|0|0|0|0|0|0|",
                  "一|0|1767258000|-1|0|0|3|0|0|0|0|0|0|0|0|"));
  EXPECT_THAT(
      package.rows("SELECT mod, usn, tags, flags, data FROM notes ORDER BY id"),
      ElementsAre("1767258000|-1| grade-1 |0|", "1767258000|-1| grade-1 |0|", "1767258000|-1| grade-1 |0|"));
  EXPECT_EQ(json::parse(package.files().at("media")),
            (json{{"0", "nazori-06728.svg"}, {"1", "nazori-04f11.svg"}, {"2", "nazori-04e00.svg"}}));
  EXPECT_EQ(package.files().at("0"), stroke_order_svg(*database().find(U'木')));
  EXPECT_EQ(package.files().size(), 5U);
}

TEST(AnkiNotes, AnswerWithReadingsMeaningsAndWords) {
  const auto fields = Package(U"木", {"Nazori", 2}).fields("木");
  ASSERT_EQ(fields.size(), 6U);
  const auto character = database().find(U'木');
  ASSERT_TRUE(character);
  EXPECT_EQ(fields[0], "木");
  EXPECT_EQ(fields[1], "tree, wood");
  EXPECT_EQ(fields[2], "ボク、モク");
  EXPECT_TRUE(fields[3].starts_with("き、こ-")) << fields[3];
  const auto words = database().words(U'木', 2);
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(fields[4], words[0].text + "（" + words[0].reading + "） " + words[0].glosses.front() + "<br>" +
                           words[1].text + "（" + words[1].reading + "） " + words[1].glosses.front());
  EXPECT_EQ(fields[5], "<img src=\"nazori-06728.svg\">");
  EXPECT_EQ(Package(U"木", {"Nazori", 0}).fields("木")[4], "");
}

// No font has an own character, and fonts have the published form of one that somebody corrected.
TEST(AnkiNotes, ShowWhatSomebodyMadeAsAPicture) {
  kanji::Character sign;
  sign.code_point = 0xF1234;
  sign.strokes = {{"M20,30L80,30", "", {{{20, 30}, {80, 30}}, kanji::StrokeEnding::stop, {}}}};
  sign.entry.meanings = {{"en", "school sign"}};
  kanji::Character form = sign;
  form.code_point = U'木';
  form.own_form = 0xF0007;
  form.strokes[0].path = "M20,60L80,60";
  const auto with_own = must(kanji::KanjiDatabase::open(must(kanji::KanjiDatabase::locate()), {sign, form}));
  const Package package(U"休木\U000F1234", {}, *parse_time("2026-01-01T09:00:00Z"), with_own);
  EXPECT_EQ(package.rows("SELECT count(*) FROM notes"), std::vector<std::string>{"3"});
  EXPECT_THAT(package.rows("SELECT due FROM cards ORDER BY due"), ElementsAre("1", "2", "3"));
  EXPECT_EQ(package.fields("休")[0], "休");
  EXPECT_EQ(package.fields("木")[0], "<img src=\"nazori-06728-shape.svg\">");
  EXPECT_EQ(package.fields("木")[1], "tree, wood");
  const std::string letter = base::encode_utf8(U'\U000F1234');
  EXPECT_EQ(package.fields(letter)[0], "<img src=\"nazori-f1234-shape.svg\">");
  EXPECT_EQ(package.fields(letter)[1], "school sign");
  EXPECT_EQ(package.fields(letter)[5], "<img src=\"nazori-f1234.svg\">");
  const json media = json::parse(package.files().at("media"));
  ASSERT_EQ(media.size(), 5U);
  std::map<std::string, std::string> pictures;
  for (const auto& [number, name] : media.items()) pictures[name] = package.files().at(number);
  EXPECT_EQ(pictures.size(), 5U);
  EXPECT_NE(pictures.at("nazori-f1234-shape.svg").find("d=\"M20,30L80,30\""), std::string::npos);
  EXPECT_NE(pictures.at("nazori-06728-shape.svg").find("d=\"M20,60L80,60\""), std::string::npos);
  EXPECT_NE(pictures.at("nazori-06728.svg"), stroke_order_svg(*database().find(U'木')));
  EXPECT_EQ(pictures.at("nazori-04f11.svg"), stroke_order_svg(*database().find(U'休')));
  // SHA-1 of " nazori-f1234-shape.svg ", as Anki finds notes that are there already.
  EXPECT_EQ(package.rows("SELECT csum FROM notes WHERE sfld = '" + letter + "'").at(0),
            std::to_string(std::stoll("1f68910c", nullptr, 16)));
}

TEST(AnkiNotes, AskForAKanaByItsSound) {
  const std::array<std::pair<std::string, std::string>, 30> kSounds{
      {{"あ", "a (hiragana)"},         {"ア", "a (katakana)"},         {"し", "shi (hiragana)"},
       {"チ", "chi (katakana)"},       {"つ", "tsu (hiragana)"},       {"フ", "fu (katakana)"},
       {"じ", "ji (hiragana)"},        {"ん", "n (hiragana)"},         {"ン", "n (katakana)"},
       {"っ", "small tsu (hiragana)"}, {"ッ", "small tsu (katakana)"}, {"ゃ", "small ya (hiragana)"},
       {"ュ", "small yu (katakana)"},  {"ょ", "small yo (hiragana)"},  {"ぁ", "small a (hiragana)"},
       {"ィ", "small i (katakana)"},   {"ぉ", "small o (hiragana)"},   {"か", "ka (hiragana)"},
       {"ゴ", "go (katakana)"},        {"ざ", "za (hiragana)"},        {"ど", "do (hiragana)"},
       {"ベ", "be (katakana)"},        {"ぽ", "po (hiragana)"},        {"や", "ya (hiragana)"},
       {"ル", "ru (katakana)"},        {"わ", "wa (hiragana)"},        {"ヲ", "wo (katakana)"},
       {"ヴ", "vu (katakana)"},        {"な", "na (hiragana)"},        {"ー", "long vowel mark (katakana)"}}};
  std::u32string all;
  for (const auto& [kana, sound] : kSounds) {
    const char32_t c = base::decode_utf8(kana)->front();
    if (database().find(c)) all += c;
  }
  ASSERT_GT(all.size(), 28U);
  const Package package(all);
  for (const auto& [kana, sound] : kSounds) {
    if (package.rows("SELECT 1 FROM notes WHERE sfld = '" + kana + "'").empty()) continue;
    EXPECT_EQ(package.fields(kana)[1], sound) << kana;
    EXPECT_THAT(package.rows("SELECT tags FROM notes WHERE sfld = '" + kana + "'"), ElementsAre(""));
  }
}

TEST(AnkiNotes, AreMadeOfUpToTwentyWordsAndTellHowFarTheyAre) {
  const std::array two{U'休', U'木'};
  const auto made = [&](int words) { return anki_package(database(), two, {"Deck", words}, {}).has_value(); };
  EXPECT_FALSE(made(-1));
  EXPECT_TRUE(made(0));
  EXPECT_TRUE(made(20));
  EXPECT_FALSE(made(21));
  std::vector<double> reported;
  ASSERT_TRUE(anki_package(database(), two, {}, {}, [&](double done, std::string_view) {
    reported.push_back(done);
    return true;
  }));
  EXPECT_THAT(reported, ElementsAre(0, 0.5));
  // Characters without strokes are left out.
  const Package package(U"\x1F600木");
  EXPECT_THAT(package.rows("SELECT due FROM cards"), ElementsAre("1"));
}

/// An invented character: the path of each stroke is its number.
kanji::Character drawn(int strokes) {
  kanji::Character character;
  for (int i = 1; i <= strokes; ++i) {
    kanji::Stroke& stroke = character.strokes.emplace_back();
    stroke.path = "M" + std::to_string(i);
    stroke.line.points = {{i + 0.25, 2.0 * i}, {50, 50}};
  }
  return character;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

TEST(StrokeOrderSvg, PutsSixSquaresInARow) {
  struct Size {
    int strokes, columns, rows;
  };
  for (const auto& [strokes, columns, rows] :
       {Size{0, 1, 1}, Size{1, 1, 1}, Size{6, 6, 1}, Size{7, 6, 2}, Size{12, 6, 2}, Size{13, 6, 3}}) {
    const std::string svg = stroke_order_svg(drawn(strokes));
    const std::string width = std::to_string(109 * columns);
    const std::string height = std::to_string(109 * rows);
    EXPECT_EQ(count(svg, "viewBox=\"0 0 " + width + " " + height + "\" width=\"" + width + "\" height=\"" +
                             height + "\">"),
              1U)
        << strokes;
    EXPECT_EQ(count(svg, "<circle"), static_cast<std::size_t>(strokes));
  }
  const std::string svg = stroke_order_svg(drawn(8));
  for (const char* place :
       {"(0 0)", "(109 0)", "(218 0)", "(327 0)", "(436 0)", "(545 0)", "(0 109)", "(109 109)"})
    EXPECT_EQ(count(svg, std::string("translate") + place), 1U) << place;
}

TEST(StrokeOrderSvg, ShowsTheStrokesSoFarAndTheNewOneBlack) {
  const std::string svg = stroke_order_svg(drawn(3));
  // The first stroke is in each of the three squares, in one of them black.
  EXPECT_EQ(count(svg, "<path d=\"M1\" stroke=\"#999\""), 2U);
  EXPECT_EQ(count(svg, "<path d=\"M2\" stroke=\"#999\""), 1U);
  EXPECT_EQ(count(svg, "<path d=\"M3\" stroke=\"#999\""), 0U);
  for (const char* one : {"M1", "M2", "M3"})
    EXPECT_EQ(count(svg, std::string("<path d=\"") + one + "\" stroke=\"#000\" stroke-width=\"4\"/>"), 1U)
        << one;
  EXPECT_EQ(count(svg, "cx=\"2.25\" cy=\"4.00\""), 1U) << "where the second begins";
  for (const char* number : {">1</text>", ">2</text>", ">3</text>"}) EXPECT_EQ(count(svg, number), 1U);
  EXPECT_EQ(count(svg, "M0.5 0.5H108.5V108.5H0.5Z"), 3U);
  kanji::Character no_line = drawn(1);
  no_line.strokes[0].line.points.clear();
  EXPECT_EQ(count(stroke_order_svg(no_line), "<circle"), 0U);
}

}  // namespace
}  // namespace nazori::study
