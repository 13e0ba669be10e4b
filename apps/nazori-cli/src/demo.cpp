// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "characters.h"
#include "followed_tablet.h"
#include "json_answers.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/exchange/tablets.h"
#include "nazori/tablet/carved_tablet.h"
#include "options.h"
#include "output_files.h"
#include "statistics_text.h"
#include "tablet_picture.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct DemoSettings {
  std::vector<std::string> characters;
  std::string database;
  std::string output = "{}-demo.png";
  std::string record;
  devices::SimulatedHardware hardware = devices::SimulatedHardware::touch();
  double tip_radius_m = 0;
  bool snap = false;
  bool real_time = false;
  bool json = false;
  carving::Brush brush;
  Look look;
};

constexpr int kMapSize = 512;

double mm(double metres) { return metres * 1000; }
double percent(double share) { return share * 100; }

std::string describe(const std::string& name, const FollowedTablet& followed, const DemoSettings& settings) {
  const devices::HandReport& hand = followed.hand;
  std::string text = fmt::format(
      "{}  {} stroke{}, traced by a simulated hand through the servo at {:g} kHz, snapping {}\ndevice: {}\n"
      "                   aim error     tip error        force\n"
      "stroke    length    rms     most      rms     most     mean    peak    contact     depth  slips  "
      "traced\n",
      name, hand.strokes.size(), hand.strokes.size() == 1 ? "" : "s", settings.hardware.rate_hz / 1000,
      settings.snap ? "on" : "off", settings.hardware.name);
  for (const devices::FollowedStroke& s : hand.strokes) {
    text += fmt::format(
        "{:6} {:6.1f} mm   {:4.2f}  {:4.2f} mm     {:4.2f}  {:4.2f} mm     {:4.2f}  {:4.2f} N     {:4.0f} %  "
        " {:4.1f} mm  {:5}  {:4.0f} %\n",
        s.stroke, mm(s.length_m), mm(s.aim_rms_m), mm(s.aim_max_m), mm(s.tip_rms_m), mm(s.tip_max_m),
        s.mean_force_n, s.peak_force_n, percent(s.contact_share), mm(s.mean_depth_m), s.slips,
        percent(s.followed_share));
  }
  const exchange::HandTracking tracking = exchange::tracking_of(hand);
  text += fmt::format(
      "all strokes: tip error {:.2f} mm rms, {:.2f} mm at most; force {:.2f} N mean, {:.2f} N peak\n"
      "energy: {} {:.3f} mJ {} the hand\n",
      mm(tracking.rms_m), mm(tracking.max_m), followed.samples.mean_force_n(), followed.samples.peak_force_n,
      hand.work_on_hand_j > 0 ? "the motors did" : "the tablet dissipated",
      std::abs(hand.work_on_hand_j) * 1e3, hand.work_on_hand_j > 0 ? "of work on" : "from");
  if (settings.real_time) {
    text += fmt::format(
        "clock thread, {}: {} ticks, {} late, {} missed; a tick took {:.1f} us, 99.9 % at most {:.1f} us, "
        "all "
        "at most {:.1f} us; 99.9 % at most {:.3f} ms late, all at most {:.3f} ms\n",
        exchange::scheduling_of(hand), hand.timing.ticks, hand.timing.late_ticks, hand.timing.missed_ticks,
        hand.timing.mean_tick_s * 1e6, hand.p999_tick_s * 1e6, hand.timing.max_tick_s * 1e6,
        hand.p999_lateness_s * 1e3, hand.timing.max_lateness_s * 1e3);
  }
  return text;
}

base::Result<void> paint(const tablet::CarvedTablet& tablet, const devices::HandReport& hand,
                         const Look& look, const std::filesystem::path& path) {
  auto painter = TabletPainter::create(look);
  if (!painter) return tl::unexpected(painter.error());
  std::vector<double> ink;
  for (const devices::FollowedStroke& stroke : hand.strokes) ink.push_back(stroke.followed_share);
  view::Overlay overlay;
  overlay.strokes_visible = false;
  overlay.groove_ink = ink;
  return view::save_png(painter->paint(tablet, overlay), path);
}

int run(Console& console, const DemoSettings& settings) {
  const auto names = kanji::parse_characters(settings.characters);
  if (!names) return console.refuse(names.error());
  if (auto size = parse_picture_size(settings.look.size); !size) return console.refuse(size.error());
  const auto paths = output_files({"--output", settings.output, {".png"}}, *names);
  if (!paths) return console.refuse(paths.error());
  std::vector<NamedFile> named;
  for (const OutputPlace& path : *paths) named.push_back({"--output", path.name()});
  std::vector<std::filesystem::path> recordings;
  if (!settings.record.empty()) {
    if (settings.record == kConsoleFile) {
      return console.refuse({base::Errc::bad_argument, "a recording cannot go to standard output", "--record",
                             "give a .nzr or a .csv"});
    }
    const auto files = output_files({"--record", settings.record, {".nzr", ".csv"}}, *names);
    if (!files) return console.refuse(files.error());
    for (const OutputPlace& file : *files) {
      recordings.push_back(file.path());
      named.push_back({"--record", file.name()});
    }
  }
  if (auto fine = check_distinct(named, settings.json); !fine) return console.refuse(fine.error());
  const auto characters = characters_with_strokes(console, settings.characters, settings.database);
  if (!characters) return characters.error();

  Json document = Json::array();
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  for (std::size_t i = 0; i < characters->size(); ++i) {
    const kanji::Character& character = (*characters)[i];
    const std::string name = kanji::name_of(character).text();
    auto tablet =
        tablet::CarvedTablet::from_lines(tablet::tablet_lines(character.lines()), kMapSize, settings.brush);
    if (tablet && settings.tip_radius_m > 0) tablet = (*tablet)->with_tip(settings.tip_radius_m);
    if (!tablet) return console.refuse(tablet.error());
    std::optional<Record> record;
    if (!recordings.empty()) record = Record{recordings[i], name};
    const auto all = static_cast<double>(characters->size());
    const auto followed = follow_strokes(
        **tablet, settings.hardware, settings.snap,
        settings.real_time ? devices::HandClock::real_time : devices::HandClock::none, record,
        [&](double done, std::string_view step) {
          return progress.show((static_cast<double>(i) + done) / all, fmt::format("{} {}", step, name));
        });
    progress.clear();
    if (!followed) return console.refuse(followed.error());
    const bool tells = !settings.json && !(*paths)[i].is_console();
    if (tells) console.print((i == 0 ? "" : "\n") + describe(name, *followed, settings));
    const OutputPlace& picture = (*paths)[i];
    auto drawn = paint(**tablet, followed->hand, settings.look, picture.path());
    if (drawn) drawn = picture.deliver(console);
    if (!drawn) return console.refuse(drawn.error());
    if (settings.json) {
      document.push_back(exchange::to_json(character,
                                           {settings.hardware.name, settings.hardware.rate_hz, settings.snap,
                                            picture.path().string(), settings.real_time},
                                           followed->hand, followed->samples));
    } else if (tells) {
      console.print(fmt::format("picture {}\n", picture.name()));
      if (record) console.print(fmt::format("recording {}\n", record->path.string()));
    }
  }
  if (settings.json) console.print(to_text(document));
  return kDone;
}

}  // namespace

void add_demo(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<DemoSettings>();
  CLI::App* verb = app.add_subcommand(
      "demo", "Let a simulated hand trace characters and measure how well the grooves guide it");
  verb->add_option("characters", settings->characters,
                   "Characters, such as 休, 休日, 正-HzFst (a variant form) or U+4F11")
      ->required();
  verb->add_option("-o,--output", settings->output,
                   "Output .png with the traced tablet. For several characters: a folder, or a name with {} "
                   "for the character; - is standard output")
      ->capture_default_str()
      ->type_name("FILE");
  add_device_option(*verb, settings->hardware, "Device to simulate");
  add_tip_option(*verb, settings->tip_radius_m);
  verb->add_flag("--snap", settings->snap, "Switch snapping on: strokes attract the stylus");
  verb->add_flag("--real-time", settings->real_time, "Run in real time like a device, and report the timing");
  verb->add_option("--record", settings->record,
                   "Record every tick to a .nzr (see nazori-cli record) or a .csv")
      ->type_name("FILE");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  add_look_options(*verb, settings->look);
  add_brush_options(*verb, settings->brush);
  add_database_option(*verb, settings->database);
  verb->footer(
      "The hand aims beside the line as people do; the groove and, with --snap, the\n"
      "stroke hold the tip nearer. Where it slips into a groove that crosses, it sees\n"
      "that, lifts the tip and comes back. Distances are seen from above, from the\n"
      "stroke's centre line; rms is the root of the mean square.\n"
      "Without --real-time the result is the same every time.\n\nExamples:\n  nazori-cli demo 休\n"
      "  nazori-cli demo 休 木 --output 'traced/{}.png' --snap --json");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
