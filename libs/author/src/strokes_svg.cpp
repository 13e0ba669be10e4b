// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "nazori/author/character_file.h"
#include "nazori/author/stroke_edits.h"
#include "nazori/base/utf8.h"
#include "nazori/geometry/svg_path.h"

namespace nazori::author {
namespace {

using base::Errc;
using geometry::GlyphPoint;
using kanji::StrokeEnding;

constexpr std::size_t kLargestSvg = std::size_t{8} << 20;
constexpr int kDeepestGroup = 50;
constexpr std::array<std::string_view, 4> kEndings{"stop", "hook", "taper", "either"};

tl::unexpected<base::Error> refuse(std::string what, std::string where = {}, std::string remedy = {}) {
  return base::fail(Errc::parse, std::move(what), std::move(where), std::move(remedy));
}

/// The shortest text that gives the same number. Paths know no -0.
std::string number(double value) {
  if (value == 0) return "0";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// The name of the file in ids: five hexadecimal digits for a single character, as in KanjiVG.
std::string id_of(const std::string& name) {
  const auto letters = base::decode_utf8(name);
  if (!letters || letters->size() != 1) return "kvg:own";
  std::array<char, 8> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 static_cast<std::uint32_t>((*letters)[0]), 16);
  const std::string hex(digits.data(), end.ptr);
  return "kvg:" + std::string(hex.size() < 5 ? 5 - hex.size() : 0, '0') + hex;
}

/// A part whose strokes follow one another.
struct PartRange {
  const OwnPart* part;
  std::size_t first;
  std::size_t end;
};

/// The parts that groups within groups can show, outer ones first.
std::vector<PartRange> nested_parts(const OwnCharacter& character) {
  std::vector<PartRange> ranges;
  for (const OwnPart& part : character.facts.parts) {
    if (part.strokes.empty() || part.name.empty()) continue;
    const auto first = static_cast<std::size_t>(part.strokes.front());
    const PartRange range{&part, first, first + part.strokes.size()};
    if (static_cast<std::size_t>(part.strokes.back()) + 1 != range.end) continue;
    const auto crosses = [&range](const PartRange& other) {
      const bool apart = other.end <= range.first || range.end <= other.first;
      const bool inside = other.first <= range.first && range.end <= other.end;
      const bool around = range.first <= other.first && other.end <= range.end;
      return !apart && !inside && !around;
    };
    if (std::ranges::none_of(ranges, crosses)) ranges.push_back(range);
  }
  std::ranges::stable_sort(ranges, [](const PartRange& a, const PartRange& b) {
    return a.first != b.first ? a.first < b.first : a.end > b.end;
  });
  if (ranges.size() > static_cast<std::size_t>(kDeepestGroup) - 2) ranges.resize(kDeepestGroup - 2);
  return ranges;
}

std::string list_of(const std::vector<GroovePoint>& points, double GroovePoint::*value) {
  std::string list;
  for (const GroovePoint& p : points) list += (list.empty() ? "" : " ") + number(p.*value);
  return list;
}

void append_path(std::string& svg, const OwnStroke& stroke, const std::string& id) {
  svg += "<path id=\"" + id + "\" nazori:ending=\"";
  svg += kEndings.at(static_cast<std::size_t>(stroke.ending));
  svg += "\" nazori:half-width=\"" + list_of(stroke.points, &GroovePoint::half_width);
  svg += "\" nazori:depth=\"" + list_of(stroke.points, &GroovePoint::depth) + "\" d=\"";
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const GlyphPoint at = stroke.points[i].at;
    svg += (i == 0 ? "M" : "L") + number(at.x) + "," + number(at.y);
  }
  svg += "\"/>\n";
}

/// Numbers of a list that are separated by blanks.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == ',' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
    if (at == end) return numbers;
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    at = read.ptr;
  }
}

/// The place in "matrix(1 0 0 1 25.5 15.5)".
std::optional<GlyphPoint> place_of(std::string_view transform) {
  constexpr std::string_view kBegin = "matrix(";
  if (!transform.starts_with(kBegin) || !transform.ends_with(')')) return std::nullopt;
  const auto numbers = numbers_of(transform.substr(kBegin.size(), transform.size() - kBegin.size() - 1));
  if (!numbers || numbers->size() != 6) return std::nullopt;
  return GlyphPoint{(*numbers)[4], (*numbers)[5]};
}

/// How a stroke of KanjiVG usually ends, by the first shape that its type names.
/// @source the table of KanjiVG types in docs/data.md, without its rules for single characters.
StrokeEnding ending_of_type(std::string_view type) {
  const auto letters = base::decode_utf8(type);
  if (!letters || letters->empty()) return StrokeEnding::either;
  constexpr std::u32string_view kHooks = U"㇁㇂㇃㇆㇈㇉㇌㇖㇚㇟";
  constexpr std::u32string_view kTapers = U"㇀㇇㇋㇏㇒㇓㇙㇝";
  const char32_t shape = letters->front();
  if (kHooks.find(shape) != std::u32string_view::npos) return StrokeEnding::hook;
  if (kTapers.find(shape) != std::u32string_view::npos) return StrokeEnding::taper;
  return StrokeEnding::stop;
}

/// Walks the groups in the order of the file, which is the order of writing.
class SvgReader {
 public:
  base::Result<void> read_group(const pugi::xml_node& group, int depth) {
    if (depth > kDeepestGroup) return refuse("groups are nested too deep");
    const std::string element = group.attribute("kvg:element").value();
    const std::size_t first = strokes.size();
    const std::size_t part = parts.size();
    const bool is_part = depth > 0 && !element.empty() && parts.size() < kMostTexts;
    if (is_part) parts.push_back({element, {}});
    if (depth == 0) name = element;
    for (const pugi::xml_node& node : group.children()) {
      const std::string_view kind = node.name();
      base::Result<void> done;
      if (kind == "g") done = read_group(node, depth + 1);
      if (kind == "path") done = read_path(node);
      if (!done) return done;
    }
    if (is_part)
      for (std::size_t i = first; i < strokes.size(); ++i) parts[part].strokes.push_back(static_cast<int>(i));
    return {};
  }

  std::string name;
  std::vector<OwnStroke> strokes;
  std::vector<kanji::StrokeLine> lines;  ///< of strokes without a groove; empty lines for the others
  std::vector<OwnPart> parts;

 private:
  base::Result<void> read_path(const pugi::xml_node& node) {
    const std::string where = "stroke " + std::to_string(strokes.size() + 1);
    if (strokes.size() == kMostStrokes) return refuse("there are more than 200 strokes");
    const auto path = geometry::parse_svg_path(node.attribute("d").value());
    if (!path) return refuse(path.error().what, where + ", " + path.error().where);
    const bool has_groove = node.attribute("nazori:half-width") || node.attribute("nazori:depth");
    OwnStroke stroke;
    kanji::StrokeLine line;
    stroke.ending = ending_of_type(node.attribute("kvg:type").value());
    if (const pugi::xml_attribute ending = node.attribute("nazori:ending")) {
      const auto at = std::ranges::find(kEndings, std::string_view(ending.value()));
      if (at == kEndings.end()) return refuse("has no ending that is known", where);
      stroke.ending = static_cast<StrokeEnding>(at - kEndings.begin());
    }
    if (has_groove) {
      const auto widths = numbers_of(node.attribute("nazori:half-width").value());
      const auto depths = numbers_of(node.attribute("nazori:depth").value());
      const std::size_t count = path->pieces.size() + 1;
      if (!widths || !depths || widths->size() != count || depths->size() != count)
        return refuse(
            "does not give a half width and a depth for each of its " + std::to_string(count) + " points",
            where);
      for (std::size_t i = 0; i < count; ++i)
        stroke.points.push_back({i == 0 ? path->start : path->pieces[i - 1][2], (*widths)[i], (*depths)[i]});
    } else {
      constexpr double kTolerance = 0.05;
      line.points = geometry::flatten(*path, kTolerance);
      line.ending = stroke.ending;
      if (line.points.size() > kMostPoints / 2) return refuse("has too many points", where);
      for (const GlyphPoint p : line.points) {
        const auto inside = [](double v) {
          return v >= -geometry::kGlyphSide && v <= 2 * geometry::kGlyphSide;
        };
        if (!inside(p.x) || !inside(p.y)) return refuse("is too far from the picture", where);
      }
    }
    strokes.push_back(std::move(stroke));
    lines.push_back(std::move(line));
    return {};
  }
};

/// Gives the strokes without a groove that of a brush.
void fit_brush(SvgReader& reader) {
  std::vector<kanji::StrokeLine> drawn;
  for (const kanji::StrokeLine& line : reader.lines)
    if (!line.points.empty()) drawn.push_back(line);
  std::vector<OwnStroke> grooves = own_strokes(drawn);
  std::size_t next = 0;
  for (std::size_t i = 0; i < reader.strokes.size(); ++i)
    if (!reader.lines[i].points.empty()) reader.strokes[i].points = std::move(grooves[next++].points);
}

}  // namespace

std::string to_strokes_svg(const OwnCharacter& character) {
  const std::string id = id_of(character.facts.name);
  const Rights& rights = character.facts.rights;
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:kvg=\"http://kanjivg.tagaini.net\""
      " xmlns:nazori=\"urn:nazori:groove:1\" width=\"109\" height=\"109\" viewBox=\"0 0 109 109\">\n"
      "<metadata nazori:licence=\"" +
      escaped(rights.licence) + "\" nazori:author=\"" + escaped(rights.author) + "\" nazori:source=\"" +
      escaped(rights.source) + "\"/>\n";
  const std::string paths = "kvg:StrokePaths_" + id.substr(4);
  svg +=
      "<g id=\"" + paths +
      "\" style=\"fill:none;stroke:#000000;stroke-width:3;stroke-linecap:round;stroke-linejoin:round;\">\n";
  svg += "<g id=\"" + id + "\" kvg:element=\"" + escaped(character.facts.name) + "\">\n";
  const std::vector<PartRange> parts = nested_parts(character);
  std::size_t next = 0;
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < character.strokes.size(); ++i) {
    for (; next < parts.size() && parts[next].first == i; ++next) {
      svg += "<g id=\"" + id + "-g" + std::to_string(next + 1) + "\" kvg:element=\"" +
             escaped(parts[next].part->name) + "\">\n";
      ends.push_back(parts[next].end);
    }
    append_path(svg, character.strokes[i], id + "-s" + std::to_string(i + 1));
    for (; !ends.empty() && ends.back() == i + 1; ends.pop_back()) svg += "</g>\n";
  }
  svg += "</g>\n</g>\n<g id=\"kvg:StrokeNumbers_" + id.substr(4) + "\" style=\"font-size:8;fill:#808080\">\n";
  const std::vector<GlyphPoint> places = number_places(character.strokes);
  for (std::size_t i = 0; i < places.size(); ++i) {
    svg += "<text transform=\"matrix(1 0 0 1 " + number(places[i].x) + " " + number(places[i].y) + ")\"";
    if (!character.strokes[i].number_position) svg += " nazori:placed=\"yes\"";
    svg += ">" + std::to_string(i + 1) + "</text>\n";
  }
  svg += "</g>\n</svg>\n";
  return svg;
}

base::Result<OwnCharacter> parse_strokes_svg(std::string_view svg) {
  if (svg.size() > kLargestSvg) return refuse("is too large");
  pugi::xml_document document;
  const auto status = document.load_buffer(svg.data(), svg.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!status)
    return refuse(std::string("is not XML: ") + status.description() + " at byte " +
                  std::to_string(status.offset));
  const pugi::xml_node root = document.child("svg");
  pugi::xml_node paths;
  pugi::xml_node numbers;
  for (const pugi::xml_node& group : root.children("g")) {
    const std::string_view id = group.attribute("id").value();
    if (id.starts_with("kvg:StrokePaths")) paths = group;
    if (id.starts_with("kvg:StrokeNumbers")) numbers = group;
  }
  if (!paths.child("g"))
    return refuse("is a drawing, without strokes in a group kvg:StrokePaths", {},
                  "find its strokes: nazori-cli author trace, or Ctrl+I on the page Workshop");
  SvgReader reader;
  if (auto read = reader.read_group(paths.child("g"), 0); !read)
    return tl::unexpected(std::move(read).error());
  if (reader.strokes.empty()) return refuse("has no strokes");
  fit_brush(reader);
  for (const pugi::xml_node& text : numbers.children("text")) {
    const int index = text.text().as_int() - 1;
    if (index < 0 || static_cast<std::size_t>(index) >= reader.strokes.size()) continue;
    if (!text.attribute("nazori:placed"))
      reader.strokes[static_cast<std::size_t>(index)].number_position =
          place_of(text.attribute("transform").value());
  }
  OwnCharacter character;
  character.strokes = std::move(reader.strokes);
  character.facts.name = std::move(reader.name);
  character.facts.parts = std::move(reader.parts);
  if (const pugi::xml_node rights = root.child("metadata")) {
    character.facts.rights = {rights.attribute("nazori:licence").value(),
                              rights.attribute("nazori:author").value(),
                              rights.attribute("nazori:source").value()};
  } else {
    // Only KanjiVG's own files have this form and say nothing of Nazori.
    character.facts.rights = kanjivg_rights();
  }
  if (auto fit = validate(character); !fit) return refuse(fit.error().what, fit.error().where);
  return character;
}

}  // namespace nazori::author
