// SPDX-License-Identifier: Apache-2.0
#include "own_form.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "nazori/base/utf8.h"

namespace nazori::kanji {
namespace {

/// How far a stroke starts and ends from another.
double distance(const Stroke& a, const Stroke& b) {
  return geometry::distance(a.line.points.front(), b.line.points.front()) +
         geometry::distance(a.line.points.back(), b.line.points.back());
}

double distance_turned(const Stroke& a, const Stroke& b) {
  return geometry::distance(a.line.points.front(), b.line.points.back()) +
         geometry::distance(a.line.points.back(), b.line.points.front());
}

/// Whether each stroke still is the one of the same number: none of the others is nearer to it, and its
/// direction is the same.
bool correspond(const std::vector<Stroke>& published, const std::vector<Stroke>& form) {
  if (published.size() != form.size()) return false;
  const auto has_line = [](const Stroke& stroke) { return !stroke.line.points.empty(); };
  if (!std::ranges::all_of(published, has_line) || !std::ranges::all_of(form, has_line)) return false;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const double own = distance(form[i], published[i]);
    if (distance_turned(form[i], published[i]) < own) return false;
    for (const Stroke& other : published)
      if (distance(form[i], other) < own) return false;
  }
  return true;
}

using Part = std::pair<std::string, std::vector<int>>;

/// The parts at any depth, those written in several pieces as one.
void collect_parts(const Component& group, std::vector<Part>& parts) {
  for (const Component& child : group.children) {
    if (!child.element.empty() && !child.strokes.empty()) {
      const auto same = std::ranges::find_if(parts, [&child](const Part& part) {
        return child.part.value_or(1) > 1 && part.first == child.element;
      });
      if (same == parts.end()) {
        parts.emplace_back(child.element, child.strokes);
      } else {
        std::vector<int>& strokes = same->second;
        strokes.insert(strokes.end(), child.strokes.begin(), child.strokes.end());
        std::ranges::sort(strokes);
        strokes.erase(std::unique(strokes.begin(), strokes.end()), strokes.end());
      }
    }
    collect_parts(child, parts);
  }
}

std::vector<Part> parts_of(const Component& root) {
  std::vector<Part> parts;
  collect_parts(root, parts);
  std::ranges::sort(parts);
  return parts;
}

/// The group of the character itself, which may be the only part of a nameless one.
const Component& group_of(const Component& root, const std::string& character) {
  const bool is_inside = root.element.empty() && root.children.size() == 1 &&
                         root.children.front().element == character &&
                         root.children.front().strokes.size() == root.strokes.size();
  return is_inside ? root.children.front() : root;
}

}  // namespace

void take_form(Character& published, const Character& form) {
  const Component& own = group_of(form.components, base::encode_utf8(published.code_point));
  const bool is_same = correspond(published.strokes, form.strokes);
  if (!is_same) published.alternative_orders.clear();
  if (!is_same || parts_of(own) != parts_of(published.components)) {
    published.components = own;
    published.components.element = base::encode_utf8(published.code_point);
  }
  std::vector<Stroke> strokes = form.strokes;
  if (is_same)
    for (std::size_t i = 0; i < strokes.size(); ++i)
      // A type says how the stroke ends, too.
      if (strokes[i].line.ending == published.strokes[i].line.ending)
        strokes[i].type = published.strokes[i].type;
  published.strokes = std::move(strokes);
  published.own_form = form.own_form;
}

}  // namespace nazori::kanji
