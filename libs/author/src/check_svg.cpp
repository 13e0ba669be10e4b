// SPDX-License-Identifier: Apache-2.0
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "nazori/author/check.h"

namespace nazori::author {
namespace {

constexpr std::string_view kPaths = "kvg:StrokePaths_";
constexpr std::string_view kNumbers = "kvg:StrokeNumbers_";
constexpr std::size_t kLargest = std::size_t{8} << 20;
constexpr int kDeepest = 50;

/// The ids of a character's groups and strokes, in the order of the file.
class Ids {
 public:
  explicit Ids(std::string name) : name_(std::move(name)) {}

  void check(const pugi::xml_node& group, int depth, std::vector<Finding>& findings) {
    if (depth > kDeepest) return;
    for (const pugi::xml_node& node : group.children()) {
      const std::string_view kind = node.name();
      const std::string id = node.attribute("id").value();
      if (kind == "g") {
        const std::string right = "kvg:" + name_ + "-g" + std::to_string(++groups_);
        if (id != right)
          findings.push_back({.kind = FindingKind::svg_group_id, .severity = Severity::note, .text = id});
        check(node, depth + 1, findings);
      } else if (kind == "path") {
        const std::string right = "kvg:" + name_ + "-s" + std::to_string(++strokes_);
        if (id != right)
          findings.push_back({.kind = FindingKind::svg_stroke_id, .stroke = strokes_ - 1, .text = id});
      }
    }
  }
  [[nodiscard]] std::size_t strokes() const { return strokes_; }

 private:
  std::string name_;
  std::size_t groups_ = 0;
  std::size_t strokes_ = 0;
};

}  // namespace

std::vector<Finding> check_svg(std::string_view svg) {
  std::vector<Finding> findings;
  pugi::xml_document document;
  if (svg.size() > kLargest ||
      !document.load_buffer(svg.data(), svg.size(), pugi::parse_default, pugi::encoding_utf8))
    return findings;
  const pugi::xml_node root = document.child("svg");
  pugi::xml_node paths;
  pugi::xml_node numbers;
  for (const pugi::xml_node& group : root.children("g")) {
    const std::string_view id = group.attribute("id").value();
    if (id.starts_with("kvg:StrokePaths")) paths = group;
    if (id.starts_with("kvg:StrokeNumbers")) numbers = group;
  }
  if (!paths.child("g")) return findings;
  const auto add = [&findings](FindingKind kind, std::string text) {
    findings.push_back({.kind = kind, .text = std::move(text)});
  };
  const std::string box = root.attribute("viewBox").value();
  if (box != "0 0 109 109") add(FindingKind::svg_view_box, box);
  for (const char* side : {"width", "height"}) {
    const std::string value = root.attribute(side).value();
    if (value != "109") add(FindingKind::svg_size, value);
  }
  const std::string path_id = paths.attribute("id").value();
  const std::string number_id = numbers.attribute("id").value();
  const std::string name = path_id.starts_with(kPaths) ? path_id.substr(kPaths.size()) : std::string();
  const pugi::xml_node drawing = paths.child("g");
  if (name.empty() || drawing.attribute("id").value() != "kvg:" + name)
    add(FindingKind::svg_root_id, path_id);
  if (number_id != std::string(kNumbers) + name) add(FindingKind::svg_root_id, number_id);
  for (const pugi::xml_node& group : {paths, numbers})
    if (std::string_view(group.attribute("style").value()).empty())
      add(FindingKind::svg_style, group.attribute("id").value());
  Ids ids(name);
  ids.check(drawing, 0, findings);
  std::size_t count = 0;
  for (const pugi::xml_node& text : numbers.children("text")) {
    const std::string number = text.text().as_string();
    if (number != std::to_string(++count)) add(FindingKind::svg_number_order, number);
  }
  if (count != ids.strokes())
    findings.push_back({.kind = FindingKind::svg_number_count,
                        .severity = Severity::error,
                        .amount = static_cast<double>(count)});
  return findings;
}

}  // namespace nazori::author
