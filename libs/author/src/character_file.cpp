// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "facts_json.h"
#include "nazori/archive/zip.h"
#include "nazori/base/bytes.h"
#include "nazori/base/file.h"
#include "nazori/carving/carve.h"
#include "nazori/kanji/centre_lines.h"
#include "nazori/kanji/stroke_order.h"

namespace nazori::author {
namespace {

using base::ByteReader;
using base::ByteWriter;
using base::Errc;

constexpr std::string_view kMeta = "meta.json";
constexpr std::string_view kStrokes = "strokes.svg";
constexpr std::string_view kRelief = "relief.f32";
constexpr std::string_view kLicence = "LICENCE.txt";

std::string licence_text(const Rights& rights) {
  std::string text = "Licence: " + (rights.licence.empty() ? "not said" : rights.licence) + "\n";
  if (rights.licence == kKanjiVgLicence) text += "https://creativecommons.org/licenses/by-sa/3.0/\n";
  if (!rights.author.empty()) text += "Author: " + rights.author + "\n";
  if (!rights.source.empty()) text += "Source: " + rights.source + "\n";
  if (rights.source == kKanjiVgSource)
    text += "The strokes were made from those of KanjiVG, and may have been changed since.\n";
  return text;
}

std::vector<std::uint8_t> to_floats(const std::vector<float>& heights) {
  ByteWriter out;
  out.bytes().reserve(heights.size() * sizeof(float));
  for (const float height : heights) out.f32(height);
  return std::move(out.bytes());
}

base::Result<HandLayer> parse_relief(std::span<const std::uint8_t> bytes) {
  const std::size_t count = bytes.size() / sizeof(float);
  const auto side = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(count))));
  const bool fits = bytes.size() % sizeof(float) == 0 && side * side == count &&
                    side >= static_cast<std::size_t>(surface::HeightMap::kMinSize) &&
                    side <= static_cast<std::size_t>(surface::HeightMap::kMaxSize);
  if (!fits) return base::fail(Errc::parse, "is not a square of samples", std::string(kRelief));
  HandLayer hand{static_cast<int>(side), std::vector<float>(count)};
  ByteReader in(bytes);
  for (float& height : hand.heights) height = in.f32();
  return hand;
}

std::string_view text_of(const archive::ZipMember& member) {
  return {reinterpret_cast<const char*>(member.content.data()), member.content.size()};
}

/// An error of a member, with the member's name before its place.
tl::unexpected<base::Error> in_member(base::Error error, std::string_view member) {
  error.where = error.where.empty() ? std::string(member) : std::string(member) + ", " + error.where;
  return tl::unexpected(std::move(error));
}

/// Centre lines on a grid. Rounding can make points needless, so they are left out until none is: then the
/// file gives the same bytes when it is read and written again.
kanji::StrokeOrder order_of(const std::vector<OwnStroke>& strokes, int grid) {
  kanji::StrokeOrder order = kanji::StrokeOrder::from_lines(kanji::centre_lines(stroke_lines(strokes)), grid);
  while (true) {
    kanji::StrokeOrder again =
        kanji::StrokeOrder::from_lines(kanji::centre_lines(order.to_lines(grid)), grid);
    if (again == order) return order;
    order = std::move(again);
  }
}

/// The strokes of a .str: a groove as broad as the others leave room for, the same along its whole length but
/// at the end of a hook. No points are added, so that the file can be written again.
std::vector<OwnStroke> strokes_of_order(const kanji::StrokeOrder& order, int grid) {
  const std::vector<kanji::StrokeLine> lines = order.to_lines(grid);
  const double half_width = carving::fitted({}, lines).width / 2;
  std::vector<OwnStroke> strokes;
  for (const kanji::StrokeLine& line : lines) {
    OwnStroke stroke{{}, line.ending, {}};
    for (const geometry::GlyphPoint p : line.points) stroke.points.push_back({p, half_width, 1});
    if (line.ending == kanji::StrokeEnding::hook) {
      stroke.points.back().half_width = 0;
      stroke.points.back().depth = 0;
    }
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace

base::Result<std::vector<std::uint8_t>> to_bytes(const OwnCharacter& character) {
  if (auto fit = validate(character); !fit) return tl::unexpected(std::move(fit).error());
  constexpr int kLevel = 6;
  archive::ZipWriter zip(kLevel);
  zip.add(kMeta, to_json(character.facts));
  if (!character.strokes.empty()) zip.add(kStrokes, to_strokes_svg(character));
  if (!character.hand.is_untouched()) zip.add(kRelief, to_floats(character.hand.heights));
  zip.add(kLicence, licence_text(character.facts.rights));
  return zip.finish();
}

base::Result<OwnCharacter> parse_character(std::span<const std::uint8_t> bytes, FileParts parts) {
  if (bytes.size() > kLargestFile) return base::fail(Errc::parse, "is too large");
  archive::ZipLimits limits{.members = 50, .bytes = kLargestUnpacked};
  if (parts == FileParts::without_relief) limits.only = {std::string(kMeta), std::string(kStrokes)};
  const auto members = archive::read_zip(bytes, limits);
  if (!members) return tl::unexpected(members.error());
  const auto find = [&members](std::string_view name) {
    const auto at = std::ranges::find(*members, name, &archive::ZipMember::name);
    return at == members->end() ? nullptr : &*at;
  };
  const archive::ZipMember* const meta = find(kMeta);
  if (meta == nullptr) return base::fail(Errc::parse, "is not a character of Nazori: it has no meta.json");
  auto facts = parse_facts(text_of(*meta));
  if (!facts) return in_member(std::move(facts).error(), kMeta);
  OwnCharacter character;
  if (const archive::ZipMember* const strokes = find(kStrokes)) {
    auto drawn = parse_strokes_svg(text_of(*strokes));
    if (!drawn) return in_member(std::move(drawn).error(), kStrokes);
    character.strokes = std::move(drawn->strokes);
  }
  character.facts = *std::move(facts);
  if (const archive::ZipMember* const relief = find(kRelief)) {
    auto hand = parse_relief(relief->content);
    if (!hand) return tl::unexpected(std::move(hand).error());
    character.hand = *std::move(hand);
  }
  if (auto fit = validate(character); !fit) {
    base::Error error = std::move(fit).error();
    error.code = Errc::parse;
    return tl::unexpected(std::move(error));
  }
  return character;
}

base::Result<void> save_character(const OwnCharacter& character, const std::filesystem::path& path) {
  const auto bytes = to_bytes(character);
  if (!bytes) return tl::unexpected(bytes.error());
  return base::write_file(path, *bytes);
}

base::Result<OwnCharacter> load_character(const std::filesystem::path& path, FileParts parts) {
  const auto bytes = base::read_file(path, kLargestFile);
  if (!bytes) return tl::unexpected(bytes.error());
  auto character = parse_character(*bytes, parts);
  if (!character) return in_member(std::move(character).error(), path.string());
  return character;
}

std::optional<CharacterFormat> format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (ending == ".nazori") return CharacterFormat::document;
  if (ending == ".svg") return CharacterFormat::svg;
  if (ending == ".str") return CharacterFormat::strokes;
  if (ending == ".raw") return CharacterFormat::raw;
  if (ending == ".png") return CharacterFormat::png;
  return std::nullopt;
}

base::Result<std::vector<std::uint8_t>> export_character(const OwnCharacter& character,
                                                         CharacterFormat format, int size) {
  if (auto fit = validate(character); !fit) return tl::unexpected(std::move(fit).error());
  const bool needs_strokes = format == CharacterFormat::svg || format == CharacterFormat::strokes;
  if (needs_strokes && character.strokes.empty())
    return base::fail(Errc::bad_argument, "has no strokes", "the character", "write a .nazori, .raw or .png");
  switch (format) {
    case CharacterFormat::document:
      return to_bytes(character);
    case CharacterFormat::svg: {
      const std::string svg = to_strokes_svg(character);
      return std::vector<std::uint8_t>(svg.begin(), svg.end());
    }
    case CharacterFormat::strokes: {
      if (size < surface::HeightMap::kMinSize || size > kanji::StrokeOrder::kMaxGrid)
        return base::fail(Errc::bad_argument, "is out of range", "size", "give 2 to 8192");
      return order_of(character.strokes, size).to_bytes();
    }
    case CharacterFormat::raw:
    case CharacterFormat::png:
      break;
  }
  const auto map = carve(character, size);
  if (!map) return tl::unexpected(map.error());
  return format == CharacterFormat::raw ? surface::to_raw(*map)
                                        : surface::to_png(*map, surface::PngDepth::bits_16);
}

base::Result<OwnCharacter> import_character(std::span<const std::uint8_t> bytes, CharacterFormat format,
                                            std::optional<int> grid) {
  base::Result<surface::HeightMap> map;
  switch (format) {
    case CharacterFormat::document:
      return parse_character(bytes);
    case CharacterFormat::svg:
      return parse_strokes_svg({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    case CharacterFormat::strokes: {
      // The file does not say its grid: the smallest power of two from 128 on that holds every point.
      constexpr int kClassicGrid = 128;
      const auto order = kanji::StrokeOrder::parse(bytes, grid.value_or(kanji::StrokeOrder::kMaxGrid));
      if (!order) return tl::unexpected(order.error());
      int side = grid.value_or(kClassicGrid);
      if (!grid) {
        for (const auto& stroke : order->all())
          for (const kanji::StrokeOrderPoint p : stroke)
            while (std::max(p.x, p.y) >= side) side *= 2;
      }
      OwnCharacter character = from_strokes(strokes_of_order(*order, side));
      if (auto fit = validate(character); !fit) {
        base::Error error = std::move(fit).error();
        error.code = Errc::parse;
        return tl::unexpected(std::move(error));
      }
      return character;
    }
    case CharacterFormat::raw:
      map = surface::parse_raw(bytes, grid);
      break;
    case CharacterFormat::png:
      map = surface::parse_png(bytes);
      break;
  }
  if (!map) return tl::unexpected(std::move(map).error());
  return from_height_map(*map);
}

}  // namespace nazori::author
