// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carved_sheet.h"
#include "nazori/paint/sheet_file.h"
#include "nazori/surface/colour_picture.h"
#include "stroke_bytes.h"

namespace nazori::calligraphy {
namespace {

using base::Errc;

/// Samples are at least so far apart, where a device gives two of them the same time.
constexpr double kLeastTime_s = 1e-3;

bool is_finite(const brush::PenSample& s) {
  return std::isfinite(s.time_s) && std::isfinite(s.at.x) && std::isfinite(s.at.y) &&
         std::isfinite(s.pressure.value_or(0)) && std::isfinite(s.height_m.value_or(0)) &&
         std::isfinite(s.lean_rad) && std::isfinite(s.lean_to_rad) && std::isfinite(s.twist_rad);
}

std::array<paint::Pigment, paint::kSlots> first_palette() {
  return {paint::find_pigment("sumi").value(), paint::find_pigment("vermilion").value(),
          paint::find_pigment("sumi-blue").value()};
}

void move_last(std::vector<BrushStroke>& from, std::vector<BrushStroke>& to) {
  to.push_back(std::move(from.back()));
  from.pop_back();
}

base::Result<paint::Sheet> empty_sheet(std::string_view paper, int cells,
                                       const std::array<paint::Pigment, paint::kSlots>& palette) {
  auto kind = paint::find_paper(paper);
  if (!kind) return tl::unexpected(std::move(kind.error()));
  return paint::Sheet::create(cells, *kind, palette);
}

}  // namespace

base::Result<SheetEditor> SheetEditor::create(std::string_view paper, int cells) {
  auto sheet = empty_sheet(paper, cells, first_palette());
  if (!sheet) return tl::unexpected(std::move(sheet.error()));
  SheetEditor editor(Board(std::move(*sheet), 0), BrushChoice{});
  editor.suit_ink_to_paper({});
  return editor;
}

SheetEditor::SheetEditor(Board board, const BrushChoice& choice)
    : board_(std::move(board)),
      choice_(choice),
      form_(form_of(choice)),
      brush_(form_, handling_),
      load_(paint::dipped(form_.holds_m3, 0, {}, {})),
      ink_(kInks.front()) {
  dip_in_ink();
}

void SheetEditor::set_brush(const BrushChoice& choice) {
  lift_pen();
  choice_ = choice;
  form_ = form_of(choice);
  const brush::PenSample pen = brush_.pen();
  brush_ = brush::HeldBrush(form_, handling_);
  fit_load();
  // The new brush is in the hand where the old one was.
  static_cast<void>(brush_.move(pen, load_.fullness()));
}

void SheetEditor::set_handling(const brush::Handling& handling) {
  lift_pen();
  handling_ = handling;
  brush_.set_handling(handling);
}

/// The slot of the ink on this sheet. A sheet from a file may lack it; then its first ink is used.
void SheetEditor::find_ink() {
  if (ink_ == kWater) {
    slot_ = -1;
    return;
  }
  const auto& palette = board_.sheet.palette();
  const auto named = [&palette](std::string_view name) {
    return std::find_if(palette.begin(), palette.end(), [&](const auto& p) { return p.name == name; });
  };
  auto found = named(ink_);
  if (found == palette.end()) found = palette.begin();
  slot_ = static_cast<int>(found - palette.begin());
}

base::Result<void> SheetEditor::set_ink(std::string_view ink) {
  if (std::find(kInks.begin(), kInks.end(), ink) == kInks.end())
    return base::fail(Errc::not_found, "there is no such ink", std::string(ink));
  lift_pen();
  int slot = -1;
  if (ink != kWater) {
    const auto& palette = board_.sheet.palette();
    for (std::size_t k = 0; k < palette.size() && slot < 0; ++k)
      if (palette[k].name == ink) slot = static_cast<int>(k);
    const paint::Pigment pigment = paint::find_pigment(ink).value();
    for (int k = paint::kSlots - 1; k >= 0 && slot < 0; --k)
      if (board_.sheet.set_pigment(k, pigment)) slot = k;
    if (slot < 0)
      return base::fail(Errc::in_use, "every ink on the sheet is still wet", std::string(ink),
                        "dry the sheet first");
  }
  ink_ = ink;
  slot_ = slot;
  load_ = paint::dipped(form_.holds_m3, 0, {}, {});
  dip_in_ink();
  return {};
}

void SheetEditor::fit_load() { load_ = moved_to_brush(load_, form_.holds_m3); }

void SheetEditor::dip_in_ink() {
  lift_pen();
  fit_load();
  calligraphy::dip_in_ink(load_, slot_);
  brush_.reset();
}

void SheetEditor::dip_in_water() {
  lift_pen();
  fit_load();
  calligraphy::dip_in_water(load_);
  brush_.reset();
}

void SheetEditor::wipe() {
  lift_pen();
  fit_load();
  calligraphy::wipe(load_);
  brush_.reset();
}

void SheetEditor::remember(Edit edit) {
  board_.history.remember(board_.sheet, load_);
  board_.past.push_back({edit, board_.strokes, board_.revision, ink_});
  if (board_.past.size() > paint::History::kStrokes) board_.past.pop_front();
  board_.future.clear();
  board_.undone.clear();
  later_.clear();
  board_.revision = ++revisions_;
}

void SheetEditor::begin_stroke() {
  fit_load();
  remember(Edit::stroke);
  ++board_.strokes;
  board_.written.emplace_back();
}

void SheetEditor::move_pen(brush::PenSample sample) {
  if (!is_finite(sample)) return;
  sample.time_s = std::max(sample.time_s, brush_.pen().time_s + kLeastTime_s);
  if (sample.pressure) sample.pressure = std::clamp(*sample.pressure, 0.0, 1.0);
  const bool was_down = brush_.pen().is_down();
  if (sample.is_down() && !was_down) begin_stroke();
  const auto swept = brush_.move(sample, load_.fullness());
  if (!sample.is_down() && !was_down) return;
  board_.sheet.touch(swept, load_);
  // The hair that leaves the paper sweeps on behind the pen; the stroke ends where it was pressed last.
  if (sample.is_down()) add_point(board_.written.back(), sample, swept, handling_.guess_pressure);
}

void SheetEditor::lift_pen() {
  if (!brush_.pen().is_down()) return;
  brush::PenSample up = brush_.pen().lifted();
  up.time_s += kLeastTime_s;
  move_pen(up);
}

void SheetEditor::step() { board_.sheet.step(); }

Edit SheetEditor::undo() {
  lift_pen();
  if (board_.past.empty()) {
    if (earlier_.empty()) return Edit::none;
    swap_board(earlier_, later_);
    return Edit::new_sheet;
  }
  board_.history.undo(board_.sheet, load_);
  if (board_.past.back().edit == Edit::stroke) move_last(board_.written, board_.undone);
  return travel(board_.past, board_.future);
}

Edit SheetEditor::redo() {
  lift_pen();
  if (board_.future.empty()) {
    if (later_.empty()) return Edit::none;
    swap_board(later_, earlier_);
    return Edit::new_sheet;
  }
  board_.history.redo(board_.sheet, load_);
  if (board_.future.back().edit == Edit::stroke) move_last(board_.undone, board_.written);
  return travel(board_.future, board_.past);
}

Edit SheetEditor::travel(std::deque<Mark>& from, std::deque<Mark>& to) {
  const Mark there = from.back();
  from.pop_back();
  to.push_back({there.edit, board_.strokes, board_.revision, ink_});
  board_.strokes = there.strokes;
  board_.revision = there.revision;
  ink_ = there.ink;
  find_ink();
  return there.edit;
}

bool SheetEditor::dry_now() {
  lift_pen();
  if (!board_.sheet.is_wet()) return false;
  remember(Edit::drying);
  board_.sheet.dry_now();
  return true;
}

/// Takes the newest sheet of `from` and keeps the present one in `to`.
void SheetEditor::swap_board(std::vector<Board>& from, std::vector<Board>& to) {
  board_.load = load_;
  board_.ink = ink_;
  to.push_back(std::exchange(board_, std::move(from.back())));
  from.pop_back();
  load_ = board_.load;
  ink_ = board_.ink;
  find_ink();
  // A picture that was drawn from another sheet may have the numbers of its tiles.
  picture_ = {};
}

void SheetEditor::put(Board board) {
  board_.future.clear();
  board_.undone.clear();
  later_.clear();
  board_.load = load_;
  board_.ink = ink_;
  earlier_.push_back(std::exchange(board_, std::move(board)));
  if (earlier_.size() > kEarlierSheets) earlier_.erase(earlier_.begin());
  find_ink();
  picture_ = {};
}

/// Paper for water is written on with water, other paper with ink.
void SheetEditor::suit_ink_to_paper(std::string_view before) {
  const bool is_for_water = board_.sheet.paper().name == kWater;
  if (is_for_water == (before == kWater)) return;
  // An empty sheet has dry slots, so this does not fail.
  if (is_for_water)
    static_cast<void>(set_ink(kWater));
  else if (ink_ == kWater)
    static_cast<void>(set_ink(kInks.front()));
}

base::Result<void> SheetEditor::take_new_sheet(std::string_view paper) {
  auto sheet = empty_sheet(paper, board_.sheet.size(), board_.sheet.palette());
  if (!sheet) return tl::unexpected(std::move(sheet.error()));
  lift_pen();
  const std::string before = board_.sheet.paper().name;
  put(Board(std::move(*sheet), ++revisions_));
  suit_ink_to_paper(before);
  return {};
}

std::vector<std::uint8_t> SheetEditor::bytes() const {
  return paint::to_bytes(board_.sheet, load_, to_bytes(board_.written));
}

base::Result<void> SheetEditor::save(const std::filesystem::path& path) {
  lift_pen();
  auto saved = paint::save_sheet(board_.sheet, load_, path, to_bytes(board_.written));
  if (saved) board_.saved = board_.revision;
  return saved;
}

base::Result<void> SheetEditor::open(const std::filesystem::path& path) {
  auto opened = paint::load_sheet(path);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  auto written = parse_strokes(opened->attached);
  if (!written) {
    written.error().where = path.string();
    return tl::unexpected(std::move(written.error()));
  }
  lift_pen();
  put(Board(std::move(opened->sheet), ++revisions_));
  board_.strokes = static_cast<int>(written->size());
  board_.written = std::move(*written);
  load_ = opened->load;
  if (slot_ >= 0) ink_ = board_.sheet.palette()[static_cast<std::size_t>(slot_)].name;
  return {};
}

base::Result<void> SheetEditor::save_png(const std::filesystem::path& path) {
  // With a picture of its own, so that the tiles that changed are still reported by picture().
  paint::SheetPicture drawn;
  drawn.update(board_.sheet);
  return surface::save_png(drawn.picture(), path);
}

base::Result<std::shared_ptr<const tablet::CarvedTablet>> SheetEditor::carve() const {
  return carved_sheet(board_.sheet);
}

SheetState SheetEditor::state() const {
  SheetState state;
  state.strokes = board_.strokes;
  const auto last = [](const std::deque<Mark>& marks, const std::vector<Board>& boards) {
    if (!marks.empty()) return marks.back().edit;
    return boards.empty() ? Edit::none : Edit::new_sheet;
  };
  state.undoes = last(board_.past, earlier_);
  state.redoes = last(board_.future, later_);
  state.is_wet = board_.sheet.is_wet();
  state.is_writing = brush_.pen().is_down();
  state.is_saved = board_.saved == board_.revision;
  state.paper = board_.sheet.paper().name;
  state.ink = ink_;
  state.brush = choice_;
  state.fullness = load_.fullness();
  state.strength = strength_of(load_);
  return state;
}

BrushShape SheetEditor::brush_shape() const {
  return {brush_.pen().at, brush_.tuft().sections(), form_.shaft_m, brush_.tuft().touching()};
}

const surface::ColourPicture& SheetEditor::picture(std::vector<int>& changed) {
  changed = picture_.update(board_.sheet);
  return picture_.picture();
}

}  // namespace nazori::calligraphy
