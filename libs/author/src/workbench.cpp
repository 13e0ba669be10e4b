// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/workbench.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "nazori/author/stroke_edits.h"
#include "nazori/carving/carve.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using geometry::kGlyphSide;

bool is_finite(GlyphPoint p) { return std::isfinite(p.x) && std::isfinite(p.y); }

GlyphPoint in_box(GlyphPoint p) {
  return {std::clamp(p.x, 0.0, kGlyphSide), std::clamp(p.y, 0.0, kGlyphSide)};
}

/// The index `by` further in a circle of `count`; from nothing the first or the last.
std::size_t turned(std::optional<std::size_t> from, int by, std::size_t count) {
  assert(count > 0);
  const auto n = static_cast<std::ptrdiff_t>(count);
  if (!from) return by > 0 ? 0 : count - 1;
  return static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(*from) + by) % n + n) % n);
}

std::optional<ReliefTool> relief_tool(Tool tool) {
  switch (tool) {
    case Tool::groove:
      return ReliefTool::groove;
    case Tool::raise:
      return ReliefTool::raise;
    case Tool::smooth:
      return ReliefTool::smooth;
    case Tool::erase:
      return ReliefTool::erase;
    default:
      return {};
  }
}

}  // namespace

void Workbench::take(CharacterEditor editor) {
  lose_pen();
  editor_ = std::move(editor);
  selection_ = {};
  placed_.clear();
  relief_changed(carving::whole_map(editor_.map().size()));
  changed();
}

void Workbench::set_settings(BenchSettings settings) {
  settings.width = std::clamp(settings.width, kThinnestTool, kWidestTool);
  settings.depth = std::clamp(settings.depth, kShallowestTool, 1.0);
  if (settings.tool != settings_.tool) {
    lose_pen();
    placed_.clear();
  }
  settings_ = settings;
  changed();
}

bool Workbench::uses_movement() const {
  return settings_.tool == Tool::draw || relief_tool(settings_.tool).has_value();
}

bool Workbench::apply(CharacterEditor::Touched touched) {
  if (!touched) {
    refused(touched.error());
    return false;
  }
  keep_selection_valid();
  if (!touched->is_empty()) relief_changed(*touched);
  changed();
  return true;
}

void Workbench::keep_selection_valid() {
  const auto& strokes = character().strokes;
  if (selection_.stroke && *selection_.stroke >= strokes.size()) selection_ = {};
  if (!selection_.stroke) selection_.number = false;
  if (!selection_.stroke || selection_.number ||
      selection_.point >= strokes[*selection_.stroke].points.size())
    selection_.point.reset();
}

void Workbench::move_pen(const geometry::WrittenPoint<geometry::GlyphFrame>& pen, bool down) {
  if (!is_finite(pen.at)) return;
  const bool was_down = std::exchange(down_, down);
  if (!was_down && !down) return;
  if (!was_down) return begin(pen);
  if (drags_) {
    drag(pen.at);
  } else if (uses_movement()) {
    movement_.push_back(pen);
    pen_moved();
  }
  if (!down) end();
}

void Workbench::begin(const geometry::WrittenPoint<geometry::GlyphFrame>& pen) {
  cursor_ = in_box(pen.at);
  if (uses_movement()) {
    movement_ = {pen};
    pen_moved();
  } else {
    click(pen.at);
  }
}

void Workbench::click(GlyphPoint at) {
  switch (settings_.tool) {
    case Tool::place:
      placed_.push_back(snapped(at));
      changed();
      return;
    case Tool::edit:
      choose_at(at);
      return;
    case Tool::stamp:
      if (apply(editor_.press_stamp(stamp_of(settings_.stamp),
                                    {settings_.width, settings_.depth, false, settings_.mirrored}, at)))
        edited(EditKind::stamp, EditWay::made);
      return;
    default:
      return;
  }
}

GlyphPoint Workbench::snapped(GlyphPoint at) const {
  if (const auto near = snap(character().strokes, at, kReach))
    return character().strokes[near->stroke].points[near->point].at;
  return at;
}

void Workbench::choose_at(GlyphPoint at) {
  const auto& strokes = character().strokes;
  // A number may be so near to a point that both are in reach.
  constexpr double kOnPoint = 1.5;
  Selection chosen;
  const auto near = snap(strokes, at, kReach);
  const auto number = near && near->distance <= kOnPoint ? std::nullopt : number_at(at);
  if (number) {
    chosen = {number, std::nullopt, true};
    number_grip_ = number_place(*number) - at;
  } else if (near) {
    chosen = {near->stroke, near->point};
  } else if (const auto place = nearest_place(strokes, at);
             place && place->distance <= std::max(kReach, place->groove.half_width)) {
    chosen = {place->stroke, std::nullopt};
  }
  selection_ = chosen;
  drags_ = chosen.stroke.has_value();
  has_dragged_ = false;
  dragged_to_ = at;
  changed();
}

void Workbench::drag(GlyphPoint to) {
  // A click that trembles is no drag.
  constexpr double kTremble = 0.6;
  if (!has_dragged_ && distance(dragged_to_, to) < kTremble) return;
  if (!selection_.stroke) return;
  const GlyphPoint by = to - dragged_to_;
  if (by == GlyphPoint{}) return;
  bool done = false;
  if (selection_.number)
    done = move_number(to + number_grip_, has_dragged_);
  else if (selection_.point)
    done = apply(editor_.move_point(*selection_.stroke, *selection_.point,
                                    character().strokes[*selection_.stroke].points[*selection_.point].at + by,
                                    has_dragged_));
  else
    done = apply(editor_.move_stroke(*selection_.stroke, by, has_dragged_));
  if (!done) return;
  dragged_to_ = to;
  has_dragged_ = true;
}

void Workbench::end() {
  const bool dragged = std::exchange(has_dragged_, false);
  if (std::exchange(drags_, false)) {
    if (dragged) edited(kind_of_move(), EditWay::made);
    return;
  }
  if (!uses_movement()) return;
  auto movement = std::exchange(movement_, {});
  if (settings_.straight && movement.size() > 2) movement = {movement.front(), movement.back()};
  if (const auto tool = relief_tool(settings_.tool)) {
    const ToolSettings held{settings_.width, settings_.depth, settings_.straight, settings_.mirrored};
    constexpr std::array kKinds{EditKind::groove, EditKind::raise, EditKind::smooth, EditKind::erase};
    if (apply(editor_.use_tool(*tool, held, movement)))
      edited(kKinds[static_cast<std::size_t>(*tool)], EditWay::made);
    return;
  }
  PenSettings held;
  held.width = settings_.width;
  held.depth = settings_.depth;
  if (!apply(editor_.draw_stroke(movement, held))) return;
  select({character().strokes.size() - 1, std::nullopt});
  edited(EditKind::draw_stroke, EditWay::made);
}

void Workbench::lose_pen() {
  down_ = drags_ = has_dragged_ = false;
  movement_.clear();
}

bool Workbench::finish_placing() {
  if (placed_.size() < 2) return false;
  kanji::StrokeLine line;
  line.points = std::exchange(placed_, {});
  line.ending = settings_.ending;
  carving::Brush brush;
  brush.width = settings_.width;
  brush.depth = settings_.depth;
  brush.fit = false;
  if (!apply(editor_.add_strokes(own_strokes({line}, brush)))) return false;
  select({character().strokes.size() - 1, std::nullopt});
  edited(EditKind::draw_stroke, EditWay::made);
  return true;
}

void Workbench::step_back() {
  if (placed_.empty()) return undo();
  placed_.pop_back();
  changed();
}

bool Workbench::insert_point_at(GlyphPoint at) {
  const auto place = nearest_place(character().strokes, at);
  if (!place || place->distance > std::max(kReach, place->groove.half_width)) return false;
  lose_pen();
  if (!apply(editor_.insert_point(place->stroke, at))) return false;
  select({place->stroke, place->segment + 1});
  edited(EditKind::insert_point, EditWay::made);
  return true;
}

void Workbench::select(Selection selection) {
  selection_ = selection;
  keep_selection_valid();
  changed();
}

void Workbench::select_next_stroke(int by) {
  if (character().strokes.empty()) return;
  select({turned(selection_.stroke, by, character().strokes.size()), std::nullopt});
}

void Workbench::select_next_point(int by) {
  if (character().strokes.empty()) return;
  const std::size_t stroke = selection_.stroke.value_or(0);
  select({stroke, turned(selection_.point, by, character().strokes[stroke].points.size())});
}

void Workbench::move_by_key(GlyphPoint by) {
  if (settings_.tool == Tool::edit && selection_.stroke) {
    const std::size_t stroke = *selection_.stroke;
    bool done = false;
    if (selection_.number)
      done = move_number(number_place(stroke) + by, false);
    else if (selection_.point)
      done = apply(editor_.move_point(stroke, *selection_.point,
                                      character().strokes[stroke].points[*selection_.point].at + by));
    else
      done = apply(editor_.move_stroke(stroke, by));
    if (done) edited(kind_of_move(), EditWay::made);
    return;
  }
  cursor_ = in_box(cursor_ + by);
  if (down_ && uses_movement()) movement_.push_back({cursor_});
  pen_moved();
}

void Workbench::press_at_cursor(double time_s) {
  const geometry::WrittenPoint<geometry::GlyphFrame> pen{cursor_, time_s};
  if (uses_movement()) return move_pen(pen, !down_);
  move_pen(pen, true);
  move_pen(pen, false);
}

bool Workbench::insert_point() {
  if (!selection_.stroke) return false;
  const auto& points = character().strokes[*selection_.stroke].points;
  if (points.size() < 2) return false;
  const std::size_t from = std::min(selection_.point.value_or(0), points.size() - 2);
  const GlyphPoint between = (points[from].at + points[from + 1].at) * 0.5;
  if (!apply(editor_.insert_point(*selection_.stroke, between))) return true;
  select({selection_.stroke, from + 1});
  edited(EditKind::insert_point, EditWay::made);
  return true;
}

bool Workbench::remove() {
  if (!selection_.stroke) return false;
  if (selection_.number) return place_number();
  const std::size_t stroke = *selection_.stroke;
  const bool point = selection_.point && character().strokes[stroke].points.size() > 1;
  if (!apply(point ? editor_.delete_point(stroke, *selection_.point) : editor_.delete_stroke(stroke)))
    return true;
  if (!point) select({});
  edited(point ? EditKind::delete_point : EditKind::delete_stroke, EditWay::made);
  return true;
}

bool Workbench::reverse() {
  if (!selection_.stroke) return false;
  if (apply(editor_.reverse_stroke(*selection_.stroke))) {
    select({selection_.stroke, std::nullopt});
    edited(EditKind::reverse_stroke, EditWay::made);
  }
  return true;
}

bool Workbench::split() {
  if (!selection_.point) return false;
  const std::size_t stroke = *selection_.stroke;
  if (*selection_.point == 0 || *selection_.point + 1 >= character().strokes[stroke].points.size())
    return false;
  if (apply(editor_.split_stroke(stroke, *selection_.point))) {
    select({stroke + 1, std::nullopt});
    edited(EditKind::split_stroke, EditWay::made);
  }
  return true;
}

bool Workbench::join() {
  if (!selection_.stroke || *selection_.stroke + 1 >= character().strokes.size()) return false;
  if (apply(editor_.join_strokes(*selection_.stroke, *selection_.stroke + 1)))
    edited(EditKind::join_strokes, EditWay::made);
  return true;
}

bool Workbench::reorder(int by) {
  if (!selection_.stroke) return false;
  const auto to = static_cast<std::ptrdiff_t>(*selection_.stroke) + by;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(character().strokes.size())) return false;
  if (apply(editor_.reorder(*selection_.stroke, static_cast<std::size_t>(to)))) {
    select({static_cast<std::size_t>(to), std::nullopt});
    edited(EditKind::reorder_strokes, EditWay::made);
  }
  return true;
}

bool Workbench::set_ending(kanji::StrokeEnding ending) {
  if (!selection_.stroke) return false;
  if (apply(editor_.set_ending(*selection_.stroke, ending))) edited(EditKind::set_ending, EditWay::made);
  return true;
}

bool Workbench::scale_width(double factor) {
  if (!selection_.stroke) return false;
  const std::size_t stroke = *selection_.stroke;
  const bool done =
      selection_.point
          ? apply(editor_.set_half_width(
                stroke, *selection_.point,
                std::clamp(character().strokes[stroke].points[*selection_.point].half_width * factor, 0.0,
                           carving::kWidestHalf)))
          : apply(editor_.scale_width(stroke, factor));
  if (done) edited(EditKind::set_width, EditWay::made);
  return true;
}

bool Workbench::scale_depth(double factor) {
  if (!selection_.stroke) return false;
  const std::size_t stroke = *selection_.stroke;
  const bool done =
      selection_.point
          ? apply(editor_.set_depth(
                stroke, *selection_.point,
                std::clamp(character().strokes[stroke].points[*selection_.point].depth * factor, 0.0, 1.0)))
          : apply(editor_.scale_depth(stroke, factor));
  if (done) edited(EditKind::set_depth, EditWay::made);
  return true;
}

void Workbench::set_facts(const Facts& facts) {
  if (facts == character().facts) return;
  if (apply(editor_.set_facts(facts))) edited(EditKind::set_facts, EditWay::made);
}

void Workbench::add_strokes(const std::vector<OwnStroke>& strokes) {
  if (apply(editor_.add_strokes(strokes))) edited(EditKind::add_strokes, EditWay::made);
}

void Workbench::load_relief(const surface::HeightMap& map) {
  if (apply(editor_.load_relief(map))) edited(EditKind::load_relief, EditWay::made);
}

void Workbench::clear_relief() {
  if (apply(editor_.clear_relief())) edited(EditKind::clear_relief, EditWay::made);
}

void Workbench::undo() {
  lose_pen();
  const EditKind kind = editor_.state().undoes;
  apply(editor_.undo());
  edited(kind, EditWay::undone);
}

void Workbench::redo() {
  lose_pen();
  const EditKind kind = editor_.state().redoes;
  apply(editor_.redo());
  edited(kind, EditWay::redone);
}

base::Result<void> Workbench::autosave_to(const std::filesystem::path& path) {
  auto begun = editor_.autosave_to(path);
  changed();
  return begun;
}

void Workbench::end_save(SavePoint point) {
  editor_.end_save(std::move(point));
  changed();
}

base::Result<void> Workbench::save(const std::filesystem::path& path) {
  auto saved = editor_.save(path);
  changed();
  return saved;
}

}  // namespace nazori::author
