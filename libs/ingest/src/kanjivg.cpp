// SPDX-License-Identifier: Apache-2.0
#include "nazori/ingest/kanjivg.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <pugixml.hpp>
#include <utility>

#include "nazori/geometry/svg_path.h"

namespace nazori::ingest {
namespace {

constexpr std::size_t kMostStrokes = 200;
constexpr int kDeepestGroup = 50;
/// The flattening tolerance that kanji::Stroke documents.
constexpr double kTolerance = 0.05;

tl::unexpected<base::Error> refuse(std::string what) {
  return base::fail(base::Errc::parse, std::move(what));
}

std::optional<int> number_of(const pugi::xml_attribute& attribute) {
  if (!attribute) return std::nullopt;
  const std::string_view text = attribute.value();
  int value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} ? std::optional(value) : std::nullopt;
}

bool is_true(const pugi::xml_attribute& attribute) { return std::string_view(attribute.value()) == "true"; }

/// Walks the groups in document order, which is writing order.
class GroupReader {
 public:
  explicit GroupReader(std::vector<kanji::Stroke>& strokes) : strokes_(strokes) {}

  base::Result<kanji::Component> read(const pugi::xml_node& group, int depth) {
    if (depth > kDeepestGroup) return refuse("groups are nested too deep");
    kanji::Component out;
    out.element = group.attribute("kvg:element").value();
    out.original = group.attribute("kvg:original").value();
    out.position = group.attribute("kvg:position").value();
    out.radical = group.attribute("kvg:radical").value();
    out.phon = group.attribute("kvg:phon").value();
    out.part = number_of(group.attribute("kvg:part"));
    out.number = number_of(group.attribute("kvg:number"));
    out.variant = is_true(group.attribute("kvg:variant"));
    out.partial = is_true(group.attribute("kvg:partial"));
    out.trad_form = is_true(group.attribute("kvg:tradForm"));
    out.radical_form = is_true(group.attribute("kvg:radicalForm"));
    const std::size_t first = strokes_.size();
    for (const pugi::xml_node& node : group.children()) {
      const std::string_view name = node.name();
      if (name == "g") {
        auto child = read(node, depth + 1);
        if (!child) return child;
        out.children.push_back(std::move(*child));
      } else if (name == "path") {
        if (auto added = add_stroke(node); !added) return tl::unexpected(added.error());
      }
    }
    out.first_stroke = static_cast<int>(first);
    for (std::size_t i = first; i < strokes_.size(); ++i) out.strokes.push_back(static_cast<int>(i));
    return out;
  }

 private:
  base::Result<void> add_stroke(const pugi::xml_node& node) {
    const std::string where = "stroke " + std::to_string(strokes_.size() + 1);
    if (strokes_.size() == kMostStrokes) return refuse("more than 200 strokes");
    kanji::Stroke stroke;
    stroke.path = node.attribute("d").value();
    stroke.type = node.attribute("kvg:type").value();
    const auto path = geometry::parse_svg_path(stroke.path);
    if (!path) return refuse(where + ": " + path.error().what + " (" + path.error().where + ")");
    const auto far = [](geometry::GlyphPoint p) {
      const auto outside = [](double v) { return v < -geometry::kGlyphSide || v > 2 * geometry::kGlyphSide; };
      return outside(p.x) || outside(p.y);
    };
    bool leaves = far(path->start);
    for (const auto& piece : path->pieces) leaves = leaves || std::any_of(piece.begin(), piece.end(), far);
    if (leaves) return refuse(where + " leaves the box");
    stroke.line.points = geometry::flatten(*path, kTolerance);
    strokes_.push_back(std::move(stroke));
    return {};
  }

  std::vector<kanji::Stroke>& strokes_;
};

/// The translation of "matrix(1 0 0 1 25.50 15.50)".
std::optional<geometry::GlyphPoint> position_of(std::string_view transform) {
  constexpr std::string_view kBegin = "matrix(";
  if (!transform.starts_with(kBegin) || !transform.ends_with(')')) return std::nullopt;
  transform = transform.substr(kBegin.size(), transform.size() - kBegin.size() - 1);
  std::vector<double> numbers;
  const char* at = transform.data();
  const char* const end = at + transform.size();
  while (at != end) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    at = read.ptr;
  }
  if (numbers.size() != 6) return std::nullopt;
  return geometry::GlyphPoint{numbers[4], numbers[5]};
}

}  // namespace

std::optional<FormName> parse_form_name(std::string_view file_name) {
  constexpr std::string_view kEnding = ".svg";
  constexpr std::size_t kDigits = 5;
  if (!file_name.ends_with(kEnding)) return std::nullopt;
  file_name.remove_suffix(kEnding.size());
  if (file_name.size() < kDigits) return std::nullopt;
  std::uint32_t code = 0;
  const auto read = std::from_chars(file_name.data(), file_name.data() + kDigits, code, 16);
  if (read.ec != std::errc{} || read.ptr != file_name.data() + kDigits || code == 0) return std::nullopt;
  if (code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return std::nullopt;
  file_name.remove_prefix(kDigits);
  if (file_name.empty()) return FormName{static_cast<char32_t>(code), {}};
  if (file_name.size() < 2 || file_name[0] != '-') return std::nullopt;
  file_name.remove_prefix(1);
  const bool plain = std::all_of(file_name.begin(), file_name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  });
  if (!plain) return std::nullopt;
  return FormName{static_cast<char32_t>(code), std::string(file_name)};
}

base::Result<DrawnForm> parse_kanjivg_svg(const FormName& name, std::span<const char> svg) {
  pugi::xml_document document;
  const auto status = document.load_buffer(svg.data(), svg.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!status) {
    return refuse(std::string("is not XML: ") + status.description() + " at byte " +
                  std::to_string(status.offset));
  }
  DrawnForm out{name.code_point, name.variant, {}, {}};
  pugi::xml_node strokes;
  pugi::xml_node numbers;
  for (const pugi::xml_node& group : document.child("svg").children("g")) {
    const std::string_view id = group.attribute("id").value();
    if (id.starts_with("kvg:StrokePaths")) strokes = group;
    if (id.starts_with("kvg:StrokeNumbers")) numbers = group;
  }
  const pugi::xml_node root = strokes.child("g");
  if (!root) return refuse("has no strokes");
  auto components = GroupReader(out.strokes).read(root, 0);
  if (!components) return tl::unexpected(components.error());
  if (out.strokes.empty()) return refuse("has no strokes");
  out.components = std::move(*components);
  for (const pugi::xml_node& text : numbers.children("text")) {
    const int number = text.text().as_int();
    if (number < 1 || static_cast<std::size_t>(number) > out.strokes.size()) continue;
    out.strokes[static_cast<std::size_t>(number - 1)].line.number_position =
        position_of(text.attribute("transform").value());
  }
  return out;
}

}  // namespace nazori::ingest
