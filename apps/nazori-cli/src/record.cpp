// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "character_json.h"
#include "nazori/recording/recording_file.h"
#include "nazori/recording/sample_statistics.h"
#include "nazori/recording/session_recorder.h"
#include "options.h"
#include "output_files.h"
#include "statistics_json.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

using recording::RecordingEnd;
using recording::RecordingReader;
using recording::Recovery;
using recording::SampleStatistics;

struct RecordInfoSettings {
  std::string file;
  bool json = false;
};

struct ExportSettings {
  std::string file;
  std::string output;
  bool json = false;
};

/// A recording read whole.
struct Told {
  recording::Session session;
  SampleStatistics samples;
  RecordingEnd end;
  Recovery recovery = Recovery::not_needed;
  std::uint64_t late_ticks = 0;  ///< began more than half a period late
  std::uint64_t gaps = 0;        ///< ticks whose numbers are missing
};

/// "complete", "recovered", "being recorded" or "breaks off".
std::string state_of(const RecordingEnd& end, Recovery recovery) {
  if (end.finished) return end.recovered ? "recovered" : "complete";
  return recovery == Recovery::in_progress ? "being recorded" : "breaks off";
}

base::Result<Told> tell(const std::string& file, ProgressDisplay& progress) {
  Told told;
  const auto recovery = recording::recover(file);
  if (!recovery) return tl::unexpected(recovery.error());
  told.recovery = *recovery;
  auto reader = RecordingReader::open(file);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  told.session = reader->session();
  const double period_s = 1 / told.session.device.rate_hz;
  std::vector<haptics::ServoSample> samples(4096);
  std::uint64_t next_tick = 0;
  for (;;) {
    const auto count = reader->read(samples);
    if (!count) return tl::unexpected(count.error());
    if (*count == 0) break;
    for (std::size_t i = 0; i < *count; ++i) {
      const haptics::ServoSample& sample = samples[i];
      if (told.samples.samples > 0) {
        if (sample.tick > next_tick) told.gaps += sample.tick - next_tick;
        if (sample.time_s - told.samples.last_s > 1.5 * period_s) ++told.late_ticks;
      }
      next_tick = sample.tick + 1;
      told.samples.add(sample);
    }
    if (!progress.show(reader->progress(), "reading"))
      return base::fail(base::Errc::cancelled, "stopped", file);
  }
  told.end = reader->end();
  return told;
}

std::string start_text(const recording::Session& session) {
  const auto seconds = static_cast<std::time_t>(std::floor(static_cast<double>(session.start_ns) * 1e-9));
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(seconds));
}

double lateness_s(const Told& told) {
  return std::max(0.0, told.samples.longest_period_s - 1 / told.session.device.rate_hz);
}

Json told_json(const Told& told, const std::string& file) {
  const recording::Session& session = told.session;
  Json json{{"file", file},
            {"state", state_of(told.end, told.recovery)},
            {"start", start_text(session)},
            {"start_ns", session.start_ns},
            {"device", session.device.name},
            {"has_force", session.device.has_force},
            {"rate_hz", session.device.rate_hz},
            {"character", session.character},
            {"tablet_width_m", session.shape.width_m},
            {"tablet_depth_m", session.shape.depth_m},
            {"lost", told.end.lost},
            {"damaged", told.end.damaged},
            {"gaps", told.gaps},
            {"trailing_bytes", told.end.trailing_bytes},
            {"late_ticks", told.late_ticks},
            {"max_lateness_s", lateness_s(told)}};
  json.update(statistics_json(told.samples));
  return json;
}

std::string describe(const Told& told, const std::string& file) {
  const recording::Session& session = told.session;
  std::string state = state_of(told.end, told.recovery);
  if (told.end.recovered)
    state += ": the program that recorded ended by force, the last ticks came from memory";
  if (!told.end.finished && told.recovery == Recovery::nothing_left)
    state += fmt::format(" after the last whole tick, {} bytes of the next", told.end.trailing_bytes);
  return fmt::format(
      "{}  {}\n"
      "start    {}\n"
      "device   {}, {:g} Hz{}\n"
      "tablet   {}{:.1f} mm wide, {:.1f} mm deep\n"
      "{}"
      "clock    {} tick{} late, at most {:.3f} ms\n"
      "lost     {} while recording, {} damaged\n",
      file, state, start_text(session), session.device.name, session.device.rate_hz,
      session.device.has_force ? "" : ", forces not felt",
      session.character.empty() ? "" : session.character + ", ", 1e3 * session.shape.width_m,
      1e3 * session.shape.depth_m, statistics_text(told.samples, session.device.rate_hz), told.late_ticks,
      told.late_ticks == 1 ? "" : "s", 1e3 * lateness_s(told), told.end.lost, told.end.damaged);
}

int run_info(Console& console, const RecordInfoSettings& settings) {
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto told = tell(settings.file, progress);
  progress.clear();
  if (!told) return console.refuse(told.error());
  console.print(settings.json ? to_text(told_json(*told, settings.file)) : describe(*told, settings.file));
  return kDone;
}

int run_export(Console& console, const ExportSettings& settings) {
  const auto place = output_file({"--output", settings.output, {".csv"}});
  if (!place) return console.refuse(place.error());
  const NamedFile files[] = {{"file", settings.file, NamedFile::Use::read}, {"--output", place->name()}};
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());
  if (const auto recovery = recording::recover(settings.file); !recovery)
    return console.refuse(recovery.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto end = recording::export_csv(settings.file, place->path(), progress.callback());
  progress.clear();
  if (!end) return console.refuse(end.error());
  if (place->is_console()) {
    const auto sent = place->deliver(console);
    return sent ? kDone : console.refuse(sent.error());
  }
  if (settings.json) {
    console.print(to_text({{"file", place->name()},
                           {"ticks", end->samples},
                           {"damaged", end->damaged},
                           {"finished", end->finished}}));
    return kDone;
  }
  std::string note;
  if (end->damaged > 0) note += fmt::format(", {} damaged left out", end->damaged);
  if (!end->finished) note += ", the recording breaks off";
  console.print(fmt::format("{}  {} ticks{}\n", place->name(), end->samples, note));
  return kDone;
}

}  // namespace

void add_record(CLI::App& app, Action& chosen) {
  CLI::App* record = app.add_subcommand("record", "Look into recordings of sessions, or turn them into CSV");
  record->require_subcommand(1);
  record->footer(
      "nazori-cli demo --record FILE makes one.\n\nExamples:\n"
      "  nazori-cli record info session.nzr\n  nazori-cli record export session.nzr --output session.csv");

  auto info = std::make_shared<RecordInfoSettings>();
  CLI::App* verb = record->add_subcommand("info", "Tell what a recording holds and whether it is whole");
  verb->add_option("file", info->file, "The recording, a .nzr")->required();
  verb->add_flag("--json", info->json, "Answer in JSON (see docs/command-line.md)");
  verb->footer(
      "A recording whose program ended by force is completed first, from memory.\n\nExample:\n"
      "  nazori-cli record info session.nzr --json");
  verb->callback([info, &chosen] { chosen = [info](Console& console) { return run_info(console, *info); }; });

  auto to_csv = std::make_shared<ExportSettings>();
  verb = record->add_subcommand("export", "Write a recording as CSV");
  verb->add_option("file", to_csv->file, "The recording, a .nzr")->required();
  verb->add_option("-o,--output", to_csv->output, "The .csv to write; - is standard output")
      ->required()
      ->type_name("FILE");
  verb->add_flag("--json", to_csv->json, "Answer in JSON (see docs/command-line.md)");
  verb->footer("Example:\n  nazori-cli record export session.nzr --output session.csv");
  verb->callback(
      [to_csv, &chosen] { chosen = [to_csv](Console& console) { return run_export(console, *to_csv); }; });
}

}  // namespace nazori::cli
