// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/trace.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "author.h"
#include "characters.h"
#include "json_answers.h"
#include "nazori/author/stroke_edits.h"
#include "nazori/base/file.h"
#include "nazori/exchange/characters.h"
#include "nazori/scan/picture.h"
#include "nazori/surface/height_map.h"
#include "options.h"
#include "output_files.h"

namespace nazori::cli {
namespace {

struct AuthorTraceSettings {
  std::string picture;
  bool relief = false;
  std::string character;
  std::string output;
  std::string database;
  int size = 512;
  bool json = false;
};

base::Result<std::vector<author::FittedStroke>> found_in(const AuthorTraceSettings& s,
                                                         const std::vector<kanji::StrokeLine>& character) {
  const auto strokes = [&](const auto& picture) -> base::Result<std::vector<author::FittedStroke>> {
    if (!character.empty()) return author::trace_as(picture, character);
    auto plain = author::trace(picture);
    if (!plain) return tl::unexpected(plain.error());
    std::vector<author::FittedStroke> out;
    for (author::OwnStroke& stroke : *plain) {
      const kanji::StrokeEnding ending = stroke.ending;
      out.push_back({std::move(stroke), ending, 1, 0});
    }
    return out;
  };
  base::Result<std::vector<author::FittedStroke>> found;
  if (s.relief || has_extension(s.picture, ".raw")) {
    const auto map =
        has_extension(s.picture, ".raw") ? surface::load_raw(s.picture) : surface::load_png(s.picture);
    if (!map) return tl::unexpected(map.error());
    found = strokes(*map);
  } else {
    const auto photo = scan::load_photo(s.picture);
    if (!photo) return tl::unexpected(photo.error());
    found = strokes(*photo);
  }
  if (!found && found.error().where.empty()) found.error().where = s.picture;
  return found;
}

base::Result<void> write(const AuthorTraceSettings& s, std::vector<author::OwnStroke> strokes,
                         const OutputPlace& place) {
  author::OwnCharacter character = author::from_strokes(std::move(strokes));
  character.facts.name = s.character;
  character.facts.rights.source = std::filesystem::path(s.picture).filename().string();
  const auto format = author::format_of(place.path()).value_or(author::CharacterFormat::svg);
  const auto bytes = author::export_character(character, format, s.size);
  if (!bytes) return tl::unexpected(bytes.error());
  return base::write_file(place.path(), *bytes);
}

/// Two digits after the point are a hundredth of a glyph unit.
double rounded(double value) { return std::round(value * 100) / 100; }

Json document_of(const AuthorTraceSettings& s, const std::vector<author::FittedStroke>& found, bool known) {
  Json strokes = Json::array();
  for (const author::FittedStroke& fit : found) {
    Json points = Json::array();
    for (const author::GroovePoint& p : fit.stroke.points)
      points.push_back(
          Json::array({rounded(p.at.x), rounded(p.at.y), rounded(p.half_width), rounded(p.depth)}));
    Json stroke = Json::object();
    stroke["ending"] = exchange::name_of(fit.stroke.ending);
    if (known) {
      stroke["ending_of_ink"] = exchange::name_of(fit.ending_of_ink);
      stroke["covered"] = rounded(fit.covered);
      stroke["moved"] = rounded(fit.moved);
    }
    stroke["points"] = std::move(points);
    strokes.push_back(std::move(stroke));
  }
  Json document = Json::object();
  document["version"] = 1;
  document["picture"] = s.picture;
  if (known) document["character"] = s.character;
  document["strokes"] = std::move(strokes);
  return document;
}

std::string text_of(const std::vector<author::FittedStroke>& found, bool known) {
  constexpr double kCovered = 0.6;
  constexpr double kMoved = 4;
  std::string text;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const author::FittedStroke& fit = found[k];
    const auto& points = fit.stroke.points;
    text += fmt::format("{:>3}  {:>5.1f},{:>5.1f} to {:>5.1f},{:>5.1f}  {}", k + 1, points.front().at.x,
                        points.front().at.y, points.back().at.x, points.back().at.y,
                        exchange::name_of(fit.stroke.ending));
    if (known) text += fmt::format("  {:>3.0f} % on ink, moved by {:.1f}", 100 * fit.covered, fit.moved);
    if (known && (fit.covered < kCovered || fit.moved > kMoved)) text += "  check this stroke";
    text += '\n';
  }
  return text;
}

int run(Console& console, const AuthorTraceSettings& s) {
  std::optional<OutputPlace> place;
  if (!s.output.empty()) {
    auto named = output_file({"--output", s.output, {".svg", ".nazori", ".str", ".raw", ".png"}});
    if (!named) return console.refuse(named.error());
    place = *std::move(named);
  }
  const NamedFile files[] = {{"picture", s.picture, NamedFile::Use::read},
                             {"--output", place ? place->name() : std::string()}};
  if (auto fine = check_distinct(files, s.json); !fine) return console.refuse(fine.error());
  std::vector<kanji::StrokeLine> character;
  if (!s.character.empty()) {
    const auto characters = characters_with_strokes(console, {&s.character, 1}, s.database);
    if (!characters) return characters.error();
    if (characters->size() != 1)
      return console.refuse({base::Errc::bad_argument, "is for one character", "--character", "give one"});
    character = characters->front().lines();
  }
  const auto found = found_in(s, character);
  if (!found) return console.refuse(found.error());
  if (place) {
    std::vector<author::OwnStroke> strokes;
    for (const author::FittedStroke& fit : *found) strokes.push_back(author::thinned(fit.stroke));
    if (auto saved = write(s, std::move(strokes), *place); !saved) return console.refuse(saved.error());
    if (auto sent = place->deliver(console); !sent) return console.refuse(sent.error());
    if (place->is_console()) return kDone;
  }
  const bool known = !character.empty();
  console.print(s.json ? to_text(document_of(s, *found, known)) : text_of(*found, known));
  return kDone;
}

}  // namespace

void add_author_trace(CLI::App& author, Action& chosen) {
  auto s = std::make_shared<AuthorTraceSettings>();
  CLI::App* verb = author.add_subcommand("trace", "Find the strokes of a picture of a character");
  verb->add_option("picture", s->picture,
                   "PNG, JPEG or SVG picture of dark writing on light paper; or a height map (.raw)")
      ->required()
      ->type_name("FILE");
  verb->add_flag("--relief", s->relief, "The picture is a height map: white is the plateau");
  verb->add_option("--character", s->character,
                   "The character that it shows: its order, directions and endings are taken over");
  verb->add_option("-o,--output", s->output,
                   "Output file: .nazori, .svg (paths as in KanjiVG), .str (stroke order), .raw or .png "
                   "(carved again); "
                   "- is standard output (SVG)")
      ->type_name("FILE");
  verb->add_option("--size", s->size, "Samples per side of .str, .raw and .png")
      ->check(within(surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize))
      ->capture_default_str()
      ->type_name("N");
  verb->add_flag("--json", s->json, "Print JSON (see docs/command-line.md)");
  add_database_option(*verb, s->database);
  verb->footer(
      "Without --character, order, direction and endings are guesses from the shape.\n"
      "Points are in glyph units: the box is 109 wide, y goes down.\n\n"
      "Examples:\n  nazori-cli author trace brush.jpg --character 永 --output 永.svg\n"
      "  nazori-cli author trace 休.raw --json");
  verb->callback([s, &chosen] { chosen = [s](Console& console) { return run(console, *s); }; });
}

}  // namespace nazori::cli
