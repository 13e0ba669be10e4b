// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "characters.h"
#include "json_answers.h"
#include "nazori/exchange/tablets.h"
#include "nazori/haptics/servo.h"
#include "nazori/kanji/stroke_order.h"
#include "nazori/recording/sample_statistics.h"
#include "nazori/recording/trajectory_ticks.h"
#include "options.h"
#include "output_files.h"
#include "own_tablet.h"
#include "sample_output.h"
#include "statistics_text.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

using haptics::GuidingMode;
using recording::SampleStatistics;
using recording::TrajectoryReader;
using recording::TrajectoryTicks;
using Tablet = std::shared_ptr<const tablet::CarvedTablet>;

struct FeelSettings {
  std::vector<std::string> characters;
  std::string database;
  OwnTablet own;
  std::string input;
  std::string output;
  std::string mode = "contact";
  std::optional<double> rate_hz;
  int stroke = 0;
  haptics::Material material;
  std::vector<double> friction;
  devices::SimulatedHardware hardware = devices::SimulatedHardware::touch();
  double tip_radius_m = 0;
  bool json = false;
  carving::Brush brush;
};

constexpr int kCarvedSize = 512;
constexpr std::uint64_t kBetweenProgress = 16'384;

/// The tablet to feel, and its name.
struct Subject {
  std::string name;
  Tablet tablet;
};

tl::expected<Subject, int> carved_subject(Console& console, const FeelSettings& settings) {
  const bool own = !settings.own.height_map.empty() || !settings.own.strokes.empty();
  if (own == !settings.characters.empty()) {
    return tl::unexpected(console.refuse(
        {base::Errc::bad_argument,
         own ? "give either a character or your own file, not both" : "no character or file given", "",
         own ? "omit the character or the file"
             : "give a character such as 休, or --height-map or --strokes"}));
  }
  if (own) {
    auto tablet = own_tablet(settings.own, kCarvedSize, settings.brush);
    if (!tablet) return tl::unexpected(console.refuse(tablet.error()));
    return Subject{settings.own.height_map.empty() ? settings.own.strokes : settings.own.height_map,
                   std::move(*tablet)};
  }
  const auto names = kanji::parse_characters(settings.characters);
  if (!names) return tl::unexpected(console.refuse(names.error()));
  if (names->size() > 1) {
    return tl::unexpected(console.refuse({base::Errc::bad_argument, "only one character at a time",
                                          settings.characters.back(), "give one character"}));
  }
  const auto characters = characters_with_strokes(console, settings.characters, settings.database);
  if (!characters) return tl::unexpected(characters.error());
  auto tablet = tablet::CarvedTablet::from_lines(tablet::tablet_lines(characters->front().lines()),
                                                 settings.own.map_size.value_or(kCarvedSize), settings.brush);
  if (!tablet) return tl::unexpected(console.refuse(tablet.error()));
  return Subject{names->front().text(), std::move(*tablet)};
}

tl::expected<Subject, int> subject_of(Console& console, const FeelSettings& settings) {
  auto subject = carved_subject(console, settings);
  if (!subject || settings.tip_radius_m == 0) return subject;
  auto tipped = subject->tablet->with_tip(settings.tip_radius_m);
  if (!tipped) return tl::unexpected(console.refuse(tipped.error()));
  subject->tablet = std::move(*tipped);
  return subject;
}

base::Result<std::shared_ptr<const haptics::HapticScene>> scene_of(const Subject& subject,
                                                                   const FeelSettings& settings) {
  const int strokes = static_cast<int>(subject.tablet->paths().size());
  if (settings.mode != "contact" && strokes == 0) {
    return base::fail(base::Errc::bad_argument, fmt::format("{} has no strokes", subject.name),
                      "--mode " + settings.mode, "give --strokes, or use --mode contact");
  }
  if (settings.stroke > strokes) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("{} has {} stroke{}", subject.name, strokes, strokes == 1 ? "" : "s"),
                      fmt::format("--stroke {}", settings.stroke), "give a smaller number");
  }
  haptics::Material material = settings.material;
  if (!settings.friction.empty()) {
    material.static_friction = settings.friction[0];
    material.dynamic_friction = settings.friction[1];
    if (material.dynamic_friction > material.static_friction) {
      return base::fail(base::Errc::bad_argument, "dynamic friction is above static friction", "--friction",
                        "give static,dynamic such as 0.4,0.3");
    }
  }
  haptics::Snapping snapping;
  snapping.enabled = settings.mode == "snap";
  snapping.stroke = settings.stroke;
  haptics::Guiding guiding;
  if (settings.mode == "lesson") guiding.mode = GuidingMode::lesson;
  if (settings.mode == "lead") guiding.mode = GuidingMode::lead;
  if (settings.stroke > 0) guiding.stroke = settings.stroke;
  return subject.tablet->scene(material, snapping, guiding);
}

/// The result of a replay.
struct Felt {
  SampleStatistics samples;
  haptics::ServoTiming timing;
  double took_s = 0;
};

base::Result<Felt> feel(TrajectoryTicks& ticks, haptics::Servo& servo, SampleOutput& output,
                        ProgressDisplay& progress) {
  const auto begin = std::chrono::steady_clock::now();
  Felt felt;
  recording::TrajectoryPoint point;
  for (;;) {
    const auto more = ticks.next(point);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    haptics::DeviceSample pose;
    pose.time_s = point.time_s;
    pose.position_m = point.position_m;
    (void)servo.tick(pose);
    const haptics::ServoSample& sample = servo.latest();
    felt.samples.add(sample);
    if (auto written = output.add(sample); !written) return tl::unexpected(std::move(written.error()));
    if (felt.samples.samples % kBetweenProgress == 0 && !progress.show(ticks.progress(), "feeling"))
      return base::fail(base::Errc::cancelled, "stopped", "feel");
  }
  if (auto done = output.commit(); !done) return tl::unexpected(std::move(done.error()));
  felt.timing = servo.timing();
  felt.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return felt;
}

exchange::FeltMotion motion_of(const Felt& felt, const Subject& subject, const FeelSettings& settings,
                               double rate_hz) {
  return {subject.name,   settings.mode,        settings.hardware.name, rate_hz,
          settings.input, settings.output,      felt.samples,           felt.timing,
          felt.took_s,    settings.tip_radius_m};
}

std::string describe(const Felt& felt, const Subject& subject, const FeelSettings& settings, double rate_hz) {
  return fmt::format(
      "{}  mode {}, device {}{}\n{}replayed in {:.2f} s, {:.0f} times as fast as real time\n{}\n",
      subject.name, settings.mode, settings.hardware.name,
      settings.tip_radius_m > 0 ? fmt::format(", ball of {:g} mm", 1e3 * settings.tip_radius_m) : "",
      statistics_text(felt.samples, rate_hz), felt.took_s,
      motion_of(felt, subject, settings, rate_hz).real_time_factor(), settings.output);
}

int run(Console& console, const FeelSettings& settings) {
  // Samples go directly to standard output, so no file is made for them.
  const bool to_console = settings.output == kConsoleFile;
  if (!to_console) {
    if (auto path = output_file({"--output", settings.output, {".csv"}}); !path)
      return console.refuse(path.error());
  }
  const NamedFile files[] = {{"--input", settings.input, NamedFile::Use::read},
                             {"--height-map", settings.own.height_map, NamedFile::Use::read},
                             {"--strokes", settings.own.strokes, NamedFile::Use::read},
                             {"--output", settings.output}};
  if (auto fine = check_distinct(files, settings.json); !fine) return console.refuse(fine.error());
  const auto subject = subject_of(console, settings);
  if (!subject) return subject.error();
  auto scene = scene_of(*subject, settings);
  if (!scene) return console.refuse(scene.error());
  auto reader = TrajectoryReader::open(settings.input);
  if (!reader) return console.refuse(reader.error());
  auto ticks = TrajectoryTicks::create(std::move(*reader), settings.rate_hz);
  if (!ticks) return console.refuse(ticks.error());

  haptics::Servo servo({settings.hardware.name, ticks->rate_hz(), true, settings.hardware.limits});
  servo.set_scene(std::move(*scene));
  auto output = to_console ? SampleOutput::to_console(console) : SampleOutput::to_file(settings.output);
  if (!output) return console.refuse(output.error());
  ProgressDisplay progress(console, ProgressDisplay::Plain::silent);
  const auto felt = feel(*ticks, servo, *output, progress);
  progress.clear();
  if (!felt) return console.refuse(felt.error());
  if (settings.json) {
    console.print(to_text(exchange::to_json(motion_of(*felt, *subject, settings, ticks->rate_hz()))));
  } else if (!to_console) {
    console.print(describe(*felt, *subject, settings, ticks->rate_hz()));
  }
  return kDone;
}

void add_material_options(CLI::App& verb, FeelSettings& settings) {
  const std::string group = "Material";
  haptics::Material& material = settings.material;
  verb.add_option("--stiffness", material.stiffness, "Fraction of the maximum that the device can render")
      ->check(within(0, 1))
      ->capture_default_str()
      ->type_name("FRACTION")
      ->group(group);
  verb.add_option("--damping", material.damping, "Fraction of the maximum that the device can render")
      ->check(within(0, 1))
      ->capture_default_str()
      ->type_name("FRACTION")
      ->group(group);
  verb.add_option("--friction", settings.friction, "Static and dynamic friction coefficients (default: 0,0)")
      ->delimiter(',')
      ->expected(2)
      ->check(within(0, 10))
      ->type_name("S,D")
      ->group(group);
  using haptics::Texture;
  static const std::map<std::string, Texture> textures{
      {"none", Texture::none}, {"paper", Texture::paper}, {"wood", Texture::wood}, {"stone", Texture::stone}};
  verb.add_option_function<std::string>(
          "--texture", [&material](const std::string& name) { material.texture = textures.at(name); },
          "none, paper, wood or stone")
      ->check(CLI::IsMember({"none", "paper", "wood", "stone"}))
      ->default_str("none")
      ->type_name("TEXTURE")
      ->group(group);
  verb.add_option("--roughness", material.roughness, "Roughness of the texture")
      ->check(within(0, 1))
      ->capture_default_str()
      ->type_name("FRACTION")
      ->group(group);
}

}  // namespace

void add_feel(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<FeelSettings>();
  CLI::App* verb =
      app.add_subcommand("feel", "Replay recorded hand motion through the servo and write the forces");
  verb->add_option("characters", settings->characters, "The character to feel: 休, 正-HzFst or U+4F11");
  verb->add_option("-i,--input", settings->input,
                   "Hand motion: a .csv with columns t,x,y,z in seconds and metres, in the tablet frame; - "
                   "is standard input")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", settings->output, "Output .csv; - is standard output")
      ->required()
      ->type_name("FILE");
  verb->add_option("--mode", settings->mode,
                   "contact: only the surface; snap: strokes also attract; lesson: one stroke after another; "
                   "lead: the hand is led along the strokes")
      ->check(CLI::IsMember({"contact", "snap", "lesson", "lead"}))
      ->capture_default_str()
      ->type_name("MODE");
  verb->add_option("--stroke", settings->stroke,
                   "snap: only this stroke (0: all); lesson and lead: the first stroke to write")
      ->check(within(0, kanji::StrokeOrder::kMaxStrokes))
      ->capture_default_str()
      ->type_name("N");
  verb->add_option("--rate", settings->rate_hz,
                   "Ticks per second, interpolated linearly between rows (default: one tick per row)")
      ->check(within(TrajectoryTicks::kLowestRate_hz, TrajectoryTicks::kHighestRate_hz))
      ->type_name("HZ");
  add_device_option(*verb, settings->hardware, "Device whose limits apply");
  add_tip_option(*verb, settings->tip_radius_m);
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  add_material_options(*verb, *settings);
  const std::string own = "Your own tablet instead of a character";
  verb->add_option("--height-map", settings->own.height_map, "A height map: 8-bit RAW or greyscale PNG")
      ->type_name("FILE")
      ->group(own);
  verb->add_option("--strokes", settings->own.strokes,
                   "A stroke order file (.str) on the grid of the height map; if given alone, it is carved")
      ->type_name("FILE")
      ->group(own);
  verb->add_option("--map-size", settings->own.map_size,
                   "Samples per side of the RAW or of the .str grid (default: from the size of the RAW file, "
                   "otherwise 128); for a character, of the carved map (default: 512)")
      ->check(within(surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize))
      ->type_name("N")
      ->group(own);
  add_brush_options(*verb, settings->brush);
  add_database_option(*verb, settings->database);
  verb->footer(
      "Only positions go in: the velocity is estimated as on a device, by the same\n"
      "code. The same input gives the same bytes.\n\nExamples:\n"
      "  nazori-cli feel 休 --input hand.csv --output forces.csv\n"
      "  nazori-cli feel --height-map 0018.raw --map-size 128 --input - --output - --friction 0.4,0.3 < "
      "hand.csv");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
