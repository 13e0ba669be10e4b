// SPDX-License-Identifier: Apache-2.0
#include "character_rows.h"

#include <sqlite3.h>

#include <algorithm>

#include "nazori/geometry/svg_path.h"

namespace nazori::kanji {
namespace {

constexpr double kFlattenTolerance = 0.05;

[[noreturn]] void throw_damage(const char* what) { throw SQLite::Exception(what, SQLITE_CORRUPT); }

StrokeEnding ending_of(int value) {
  if (value < 0 || value > static_cast<int>(StrokeEnding::either))
    throw_damage("a stroke ends in no known way");
  return static_cast<StrokeEnding>(value);
}

}  // namespace

Stroke read_stroke(Rewound& row) {
  Stroke stroke;
  stroke.path = row.text(0);
  stroke.type = row.text(1);
  stroke.line.ending = ending_of(row.number(2));
  const auto x = row->getColumn(3);
  const auto y = row->getColumn(4);
  if (!x.isNull() && !y.isNull()) stroke.line.number_position = {x.getDouble(), y.getDouble()};
  const auto path = geometry::parse_svg_path(stroke.path);
  if (!path) throw_damage("a stroke is no path");
  stroke.line.points = geometry::flatten(*path, kFlattenTolerance);
  return stroke;
}

Component read_component(Rewound& row) {
  Component out;
  out.first_stroke = row.number(1);
  for (int i = 0; i < row.number(2); ++i) out.strokes.push_back(out.first_stroke + i);
  out.element = row.text(3);
  out.original = row.text(4);
  out.position = row.text(5);
  out.radical = row.text(6);
  out.phon = row.text(7);
  out.part = row.optional_number(8);
  out.number = row.optional_number(9);
  const int flags = row.number(10);
  out.variant = (flags & 1) != 0;
  out.partial = (flags & 2) != 0;
  out.trad_form = (flags & 4) != 0;
  out.radical_form = (flags & 8) != 0;
  return out;
}

Component assemble(std::vector<std::pair<int, Component>> rows) {
  for (std::size_t i = rows.size(); i-- > 1;) {
    const auto parent = static_cast<std::size_t>(rows[i].first);
    if (rows[i].first < 0 || parent >= i) continue;
    rows[parent].second.children.push_back(std::move(rows[i].second));
  }
  if (rows.empty()) return {};
  // Children were added in reverse order.
  const auto turn = [](const auto& self, Component& node) -> void {
    std::reverse(node.children.begin(), node.children.end());
    for (Component& child : node.children) self(self, child);
  };
  turn(turn, rows.front().second);
  return std::move(rows.front().second);
}

}  // namespace nazori::kanji
