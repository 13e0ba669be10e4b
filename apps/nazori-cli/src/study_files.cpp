// SPDX-License-Identifier: Apache-2.0
// study export, import, backup, restore, rebuild, replay
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <system_error>

#include "nazori/base/file.h"
#include "nazori/base/unfinished_file.h"
#include "nazori/exchange/cards.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "nazori/study/replay.h"
#include "options.h"
#include "output_files.h"
#include "study_session.h"

namespace nazori::cli {
namespace {

namespace fs = std::filesystem;
using study::Access;

constexpr std::size_t kMostReplayBytes = std::size_t{1} << 30;
constexpr double kChecking = 0.3;  // of an import

struct FileSettings {
  StudyOptions options;
  std::string file;
  std::string output;
  std::string deck = "Nazori";
  std::vector<std::string> lists;
  int words = 4;
  bool list = false;
  bool check = false;
};

std::string_view as_text(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

base::Result<std::vector<std::uint8_t>> anki(const FileSettings& settings, const base::Progress& progress) {
  auto session = StudySession::open(settings.options, Access::read);
  if (!session) return tl::unexpected(session.error());
  std::vector<char32_t> characters;
  if (settings.lists.empty()) {
    for (const auto& [character, card] : session->learner().cards()) characters.push_back(character);
    if (characters.empty()) {
      return base::fail(base::Errc::not_found, "nothing studied yet", "Anki package",
                        "give lists with --list");
    }
  } else {
    auto named = session->characters(settings.lists);
    if (!named) return tl::unexpected(named.error());
    characters = *std::move(named);
  }
  return study::anki_package(session->database(), characters, {settings.deck, settings.words},
                             session->learner().now(), progress);
}

base::Result<void> write_learner(const FileSettings& settings, const fs::path& file,
                                 const base::Progress& progress) {
  if (has_extension(file, ".apkg")) {
    const auto bytes = anki(settings, progress);
    return bytes ? base::write_file(file, *bytes) : tl::unexpected(bytes.error());
  }
  const auto learner = open_learner(settings.options, Access::read);
  if (!learner) return tl::unexpected(learner.error());
  auto output = base::OutputFile::create(file);
  if (!output) return tl::unexpected(std::move(output.error()));
  const auto append = [&output](std::string_view piece) { return output->append(piece); };
  auto written = has_extension(file, ".csv") ? study::export_csv(*learner, append, progress)
                                             : study::export_json(*learner, append, progress);
  return written ? output->commit() : written;
}

int export_learner(Console& console, const FileSettings& settings) {
  const auto place = output_file({"--output", settings.output, {".json", ".csv", ".apkg"}});
  if (!place) return console.refuse(place.error());
  const NamedFile files[] = {{"--output", place->name()}};
  if (auto fine = check_distinct(files, settings.options.json); !fine) return console.refuse(fine.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  auto written = write_learner(settings, place->path(), progress.callback());
  progress.clear();
  if (written) written = place->deliver(console);
  if (!written) return console.refuse(written.error());
  if (place->is_console()) return kDone;
  console.print(settings.options.json ? to_text({{"file", place->name()}}) : place->name() + "\n");
  return kDone;
}

/// The file of a learner who did not exist before, until the import is in it.
class NewLearner {
 public:
  explicit NewLearner(const fs::path& file)
      : folder_(file.parent_path()),
        lock_(file.string() + ".lock"),
        file_(file, base::UnfinishedKind::database) {}
  void finish() {
    file_.finish();
    lock_.finish();
    folder_.finish();
  }

 private:
  // Registered files are removed in reverse order.
  base::UnfinishedFile folder_, lock_, file_;
};

int import_learner(Console& console, const FileSettings& settings) {
  const auto to_check = study::file_source(settings.file);
  if (!to_check) return console.refuse(to_check.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  // Checked completely first, so that a refused file does not even leave an empty profile.
  auto checked = study::check_json(*to_check, base::part_of(progress.callback(), 0, kChecking));
  if (!checked) {
    base::Error& error = checked.error();
    if (error.code == base::Errc::parse || error.code == base::Errc::schema)
      error.where = settings.file + ": " + error.where;
    return console.refuse(error);
  }
  const auto source = study::file_source(settings.file);
  if (!source) return console.refuse(source.error());
  const auto path = learner_path(settings.options);
  if (!path) return console.refuse(path.error());
  std::error_code unknown;
  const bool is_new = !fs::exists(*path, unknown) && !unknown;
  std::optional<NewLearner> unfinished;
  auto making = base::making_files();
  auto learner = open_learner(settings.options, Access::write);
  if (!learner) return console.refuse(learner.error());
  // Registered only after it is open here: before that the file may belong to another program.
  if (is_new && learner->last_entry() == 0) unfinished.emplace(*path);
  making.unlock();
  const auto done = study::import_json(*learner, *source, base::part_of(progress.callback(), kChecking, 1));
  progress.clear();
  if (!done) return console.refuse(done.error());
  if (unfinished) unfinished->finish();
  console.print(settings.options.json
                    ? to_text({{"entries", learner->last_entry()}, {"characters", learner->cards().size()}})
                    : fmt::format("{}, {}\n", counted(learner->last_entry(), "entry", "entries"),
                                  counted(static_cast<std::int64_t>(learner->cards().size()), "character")));
  return kDone;
}

int backup(Console& console, const FileSettings& settings) {
  const auto path = learner_path(settings.options);
  if (!path) return console.refuse(path.error());
  if (settings.output == kConsoleFile) {
    return console.refuse({base::Errc::bad_argument, "a backup cannot go to standard output", "--output",
                           "give the name of a file; study export writes to standard output"});
  }
  const NamedFile files[] = {{"the learner's file", path->string(), NamedFile::Use::read},
                             {"--output", settings.output}};
  if (auto fine = check_distinct(files, settings.options.json); !fine) return console.refuse(fine.error());
  const auto learner = open_learner(settings.options, Access::read);
  if (!learner) return console.refuse(learner.error());
  if (learner->last_entry() == 0) {
    return console.deny({base::Errc::not_found, "nothing studied yet", path->string(), ""});
  }
  fs::path file = settings.output;
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  if (file.empty()) {
    auto made = study::make_backup(*learner, *path, progress.callback());
    if (!made) return console.refuse(made.error());
    file = *std::move(made);
  } else if (auto done = learner->copy_to(file, progress.callback()); !done) {
    return console.refuse(done.error());
  }
  progress.clear();
  console.print(settings.options.json ? to_text({{"file", file.string()}}) : file.string() + "\n");
  return kDone;
}

int restore(Console& console, const FileSettings& settings) {
  const auto path = learner_path(settings.options);
  if (!path) return console.refuse(path.error());
  const auto backups = study::backups_of(*path);
  if (settings.list) {
    Json json = Json::array();
    std::string lines;
    for (const study::Backup& one : backups) {
      const auto inside = study::look_into(one.file);
      const std::string last =
          inside && inside->last_day ? study::to_text(*inside->last_day) : std::string("-");
      json.push_back({{"file", one.file.string()},
                      {"bytes", one.bytes},
                      {"automatic", one.automatic},
                      {"sound", inside.has_value()},
                      {"writings", inside ? Json(inside->writings) : Json()},
                      {"characters", inside ? Json(inside->characters) : Json()},
                      {"last_day", inside && inside->last_day ? Json(last) : Json()}});
      lines += inside ? fmt::format("{}  {} of {}, last study day {}\n", one.file.string(),
                                    counted(inside->writings, "writing"),
                                    counted(inside->characters, "character"), last)
                      : fmt::format("{}  cannot be used: {}\n", one.file.string(), inside.error().what);
    }
    console.print(settings.options.json ? to_text(json) : lines);
    return backups.empty() ? console.deny({base::Errc::not_found, "there is no backup", path->string(), ""})
                           : kDone;
  }
  fs::path file = settings.file;
  if (settings.file.empty()) {
    for (const study::Backup& one : backups) {
      if (one.automatic) {
        file = one.file;
        break;
      }
    }
    if (file.empty()) return console.deny({base::Errc::not_found, "there is no backup", path->string(), ""});
  }
  const auto clock = study_clock(settings.options);
  if (!clock) return console.refuse(clock.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto kept = when_free(
      settings.options, [&] { return study::restore_backup(file, *path, *clock, progress.callback()); });
  progress.clear();
  if (!kept) return console.refuse(kept.error());
  if (settings.options.json) {
    console.print(to_text({{"restored", file.string()}, {"kept", kept->string()}}));
  } else {
    console.print(fmt::format("restored {}\n", file.string()));
    if (!kept->empty()) console.print(fmt::format("the previous data was saved as {}\n", kept->string()));
  }
  return kDone;
}

int rebuild(Console& console, const FileSettings& settings) {
  if (const auto code = refuse_missing(console, settings.options)) return *code;
  auto learner = open_learner(settings.options, Access::rebuild);
  if (!learner) return console.refuse(learner.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto report = learner->rebuild(progress.callback());
  progress.clear();
  if (!report) return console.refuse(report.error());
  console.print(settings.options.json
                    ? to_text({{"entries", report->entries},
                               {"characters", report->cards},
                               {"studied", report->studied},
                               {"differences", report->differences}})
                    : fmt::format("{}, {} ({} of them studied), {} differed from the saved states\n",
                                  counted(report->entries, "entry", "entries"),
                                  counted(report->cards, "character"), report->studied, report->differences));
  return kDone;
}

int replay(Console& console, const FileSettings& settings) {
  const auto bytes = base::read_file(settings.file, kMostReplayBytes);
  if (!bytes) return console.refuse(bytes.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  auto replayed = study::replay_histories(as_text(*bytes), progress.callback());
  progress.clear();
  if (!replayed) {
    replayed.error().where = settings.file + ": " + replayed.error().where;
    return console.refuse(replayed.error());
  }
  if (!settings.check) {
    console.print(study::to_json(*replayed));
    return kDone;
  }
  const auto found = study::compare_with_own_numbers(as_text(*bytes), *replayed);
  if (!found) return console.refuse(found.error());
  if (settings.options.json) {
    console.print(to_text(exchange::to_json(*found)));
    if (found->first.empty()) return kDone;
    return console.deny({base::Errc::schema, "differs within 8 decimal places", found->first, ""});
  }
  console.print(
      fmt::format("{} steps; largest differences: stability {}, difficulty {}, retrievability {}, interval "
                  "{} days, due {} s; {} different states\n",
                  found->steps, found->stability, found->difficulty, found->retrievability,
                  found->scheduled_days, found->due_s, found->states));
  if (found->first.empty()) return kDone;
  return console.deny({base::Errc::schema, "differs within 8 decimal places", found->first, ""});
}

using Run = int (*)(Console&, const FileSettings&);
/// Whether a command changes a learner.
enum class Writes { no, yes };

CLI::App* add(CLI::App& study, Action& chosen, const char* name, const char* description, const char* footer,
              const std::shared_ptr<FileSettings>& settings, Run run, Writes writes = Writes::no) {
  CLI::App* verb = add_study_verb(study, name, description, footer);
  if (writes == Writes::yes) {
    add_writer_options(*verb, settings->options);
  } else {
    add_learner_options(*verb, settings->options);
  }
  verb->callback([settings, &chosen, run] {
    chosen = [settings, run](Console& console) { return run(console, *settings); };
  });
  return verb;
}

}  // namespace

void add_study_files(CLI::App& study, Action& chosen) {
  auto settings = std::make_shared<FileSettings>();
  CLI::App* verb =
      add(study, chosen, "export", "Export everything (.json), a table (.csv) or an Anki package (.apkg)",
          "Examples:\n  nazori-cli study export --output me.json\n"
          "  nazori-cli study export --output reviews.csv\n"
          "  nazori-cli study export --output kanji.apkg --list grade-1 --deck 'Kanji::Grade 1'",
          settings, export_learner);
  verb->add_option("-o,--output", settings->output, "Output file; - is standard output (JSON)")
      ->required()
      ->type_name("FILE");
  verb->add_option("--list", settings->lists,
                   "For Anki: characters or lists (default: every character studied so far)")
      ->type_name("LIST");
  verb->add_option("--deck", settings->deck, "For Anki: name of the deck")
      ->capture_default_str()
      ->type_name("NAME");
  verb->add_option("--words", settings->words, "For Anki: maximum number of words per character")
      ->check(within(0, 20))
      ->capture_default_str()
      ->type_name("N");
  verb->add_option("--database", settings->options.database, "Kanji database to use")->type_name("FILE");

  settings = std::make_shared<FileSettings>();
  verb = add(study, chosen, "import", "Import a JSON export into an empty profile",
             "Example:\n  nazori-cli study import me.json --profile Mari", settings, import_learner,
             Writes::yes);
  verb->add_option("file", settings->file, "The exported file")->required()->type_name("FILE");

  settings = std::make_shared<FileSettings>();
  verb = add(study, chosen, "backup", "Make a backup now, in addition to the daily ones",
             "Example:\n  nazori-cli study backup --output /media/stick/learner.db", settings, backup);
  verb->add_option("-o,--output", settings->output, "Output file (default: in the folder of backups)")
      ->type_name("FILE");

  settings = std::make_shared<FileSettings>();
  verb = add(study, chosen, "restore", "Restore a learner's study data from a backup",
             "Without a file, the newest daily backup is used. The current data is backed up first.\n\n"
             "Examples:\n  nazori-cli study restore --list\n  nazori-cli study restore",
             settings, restore, Writes::yes);
  verb->add_option("file", settings->file, "The backup")->type_name("FILE");
  verb->add_flag("--list", settings->list, "Only list the backups, newest first");

  settings = std::make_shared<FileSettings>();
  add(study, chosen, "rebuild", "Recalculate all states from the study history",
      "Example:\n  nazori-cli study rebuild", settings, rebuild, Writes::yes);

  settings = std::make_shared<FileSettings>();
  verb = add(study, chosen, "replay", "Reschedule review histories with FSRS-6",
             "Prints the same form with its own numbers; with --check only how far they differ, and exit\n"
             "code 1 where they do. It is the same for every learner.\n\nExample:\n  nazori-cli study replay "
             "histories.json --check",
             settings, replay);
  verb->add_option("file", settings->file, "Histories in JSON (docs/file-formats.md)")
      ->required()
      ->type_name("FILE");
  verb->add_flag("--check", settings->check, "Compare with the numbers in the file");
}

}  // namespace nazori::cli
