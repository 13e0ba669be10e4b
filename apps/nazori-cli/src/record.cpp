// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "json_answers.h"
#include "nazori/exchange/recordings.h"
#include "nazori/recording/recording_file.h"
#include "nazori/recording/sample_statistics.h"
#include "nazori/recording/session_recorder.h"
#include "options.h"
#include "output_files.h"
#include "statistics_text.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

using recording::RecordingEnd;
using recording::RecordingReader;
using recording::Recovery;

struct RecordInfoSettings {
  std::string file;
  bool json = false;
};

struct ExportSettings {
  std::string file;
  std::string output;
  bool json = false;
};

base::Result<exchange::ReadRecording> read_report(const std::string& file, ProgressDisplay& progress) {
  exchange::ReadRecording report;
  const auto recovery = recording::recover(file);
  if (!recovery) return tl::unexpected(recovery.error());
  report.recovery = *recovery;
  auto reader = RecordingReader::open(file);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  report.session = reader->session();
  const double period_s = 1 / report.session.device.rate_hz;
  std::vector<haptics::ServoSample> samples(4096);
  std::uint64_t next_tick = 0;
  for (;;) {
    const auto count = reader->read(samples);
    if (!count) return tl::unexpected(count.error());
    if (*count == 0) break;
    for (std::size_t i = 0; i < *count; ++i) {
      const haptics::ServoSample& sample = samples[i];
      if (report.samples.samples > 0) {
        if (sample.tick > next_tick) report.gaps += sample.tick - next_tick;
        if (sample.time_s - report.samples.last_s > 1.5 * period_s) ++report.late_ticks;
      }
      next_tick = sample.tick + 1;
      report.samples.add(sample);
    }
    if (!progress.show(reader->progress(), "reading"))
      return base::fail(base::Errc::cancelled, "stopped", file);
  }
  report.end = reader->end();
  return report;
}

std::string describe(const exchange::ReadRecording& report, const std::string& file) {
  const recording::Session& session = report.session;
  std::string state = std::string(report.state());
  if (report.end.recovered)
    state += ": the recording program was killed; the last ticks were recovered from memory";
  if (!report.end.finished && report.recovery == Recovery::nothing_left)
    state +=
        fmt::format(" after the last complete tick; {} bytes of the next one", report.end.trailing_bytes);
  return fmt::format(
      "{}  {}\n"
      "start    {}\n"
      "device   {}, {:g} Hz{}\n"
      "tablet   {}{:.1f} mm wide, {:.1f} mm deep{}\n"
      "{}"
      "clock    {} tick{} late, at most {:.3f} ms\n"
      "lost     {} while recording, {} damaged\n",
      file, state, report.start(), session.device.name, session.device.rate_hz,
      session.device.has_force ? "" : ", without force feedback",
      session.character.empty() ? "" : session.character + ", ", 1e3 * session.shape.width_m,
      1e3 * session.shape.depth_m,
      session.tip_radius_m > 0 ? fmt::format(", felt by a ball of {:g} mm", 1e3 * session.tip_radius_m) : "",
      statistics_text(report.samples, session.device.rate_hz), report.late_ticks,
      report.late_ticks == 1 ? "" : "s", 1e3 * report.max_lateness_s(), report.end.lost, report.end.damaged);
}

int run_info(Console& console, const RecordInfoSettings& settings) {
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto report = read_report(settings.file, progress);
  progress.clear();
  if (!report) return console.refuse(report.error());
  console.print(settings.json ? to_text(exchange::to_json(*report, settings.file))
                              : describe(*report, settings.file));
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
    console.print(to_text(exchange::exported_recording(*end, place->name())));
    return kDone;
  }
  std::string note;
  if (end->damaged > 0) note += fmt::format(", {} damaged ticks skipped", end->damaged);
  if (!end->finished) note += ", the recording is incomplete";
  console.print(fmt::format("{}  {} ticks{}\n", place->name(), end->samples, note));
  return kDone;
}

}  // namespace

void add_record(CLI::App& app, Action& chosen) {
  CLI::App* record = app.add_subcommand("record", "Inspect recordings or convert them to CSV");
  record->require_subcommand(1);
  record->footer(
      "Make one with: nazori-cli demo --record FILE\n\nExamples:\n"
      "  nazori-cli record info session.nzr\n  nazori-cli record export session.nzr --output session.csv");

  auto info = std::make_shared<RecordInfoSettings>();
  CLI::App* verb =
      record->add_subcommand("info", "Show the contents of a recording and whether it is complete");
  verb->add_option("file", info->file, "The recording (.nzr)")->required();
  verb->add_flag("--json", info->json, "Print JSON (see docs/command-line.md)");
  verb->footer(
      "If the recording program was killed, the recording is first completed from memory.\n\nExample:\n"
      "  nazori-cli record info session.nzr --json");
  verb->callback([info, &chosen] { chosen = [info](Console& console) { return run_info(console, *info); }; });

  auto to_csv = std::make_shared<ExportSettings>();
  verb = record->add_subcommand("export", "Convert a recording to CSV");
  verb->add_option("file", to_csv->file, "The recording (.nzr)")->required();
  verb->add_option("-o,--output", to_csv->output, "Output .csv; - is standard output")
      ->required()
      ->type_name("FILE");
  verb->add_flag("--json", to_csv->json, "Print JSON (see docs/command-line.md)");
  verb->footer("Example:\n  nazori-cli record export session.nzr --output session.csv");
  verb->callback(
      [to_csv, &chosen] { chosen = [to_csv](Console& console) { return run_export(console, *to_csv); }; });
}

}  // namespace nazori::cli
