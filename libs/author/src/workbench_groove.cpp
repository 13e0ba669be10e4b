// SPDX-License-Identifier: Apache-2.0
// The number of a stroke, and its groove along its line.
#include <algorithm>
#include <utility>

#include "nazori/author/stroke_edits.h"
#include "nazori/author/workbench.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using geometry::kGlyphSide;

}  // namespace

bool Workbench::select_number() {
  if (character().strokes.empty()) return false;
  select({selection_.stroke.value_or(0), std::nullopt, true});
  return true;
}

std::optional<std::size_t> Workbench::number_at(GlyphPoint at) const {
  const auto places = number_places(character().strokes);
  // The last one is drawn on top.
  for (std::size_t i = places.size(); i-- > 0;) {
    const NumberBox box = number_box(i + 1, places[i]);
    if (at.x >= box.left && at.x <= box.right && at.y >= box.top && at.y <= box.bottom) return i;
  }
  return {};
}

GlyphPoint Workbench::number_place(std::size_t stroke) const {
  return number_places(character().strokes)[stroke];
}

bool Workbench::move_number(GlyphPoint to, bool goes_on) {
  const std::size_t stroke = *selection_.stroke;
  // All of it stays in the picture.
  const NumberBox box = number_box(stroke + 1, {0, 0});
  const GlyphPoint at{std::clamp(to.x, -box.left, kGlyphSide - box.right),
                      std::clamp(to.y, -box.top, kGlyphSide - box.bottom)};
  if (character().strokes[stroke].number_position == at) return false;
  return apply(editor_.set_number(stroke, at, goes_on));
}

EditKind Workbench::kind_of_move() const {
  if (selection_.number) return EditKind::move_number;
  return selection_.point ? EditKind::move_point : EditKind::move_stroke;
}

bool Workbench::place_number() {
  if (!selection_.stroke || !character().strokes[*selection_.stroke].number_position) return false;
  if (apply(editor_.set_number(*selection_.stroke, std::nullopt)))
    edited(EditKind::move_number, EditWay::made);
  return true;
}

bool Workbench::set_half_width(std::size_t point, double half_width, bool goes_on) {
  if (!selection_.stroke) return false;
  const double held = std::clamp(half_width, 0.0, carving::kWidestHalf);
  if (apply(editor_.set_half_width(*selection_.stroke, point, held, goes_on)) && !goes_on)
    edited(EditKind::set_width, EditWay::made);
  return true;
}

bool Workbench::set_depth(std::size_t point, double depth, bool goes_on) {
  if (!selection_.stroke) return false;
  const double held = std::clamp(depth, 0.0, 1.0);
  if (apply(editor_.set_depth(*selection_.stroke, point, held, goes_on)) && !goes_on)
    edited(EditKind::set_depth, EditWay::made);
  return true;
}

}  // namespace nazori::author
