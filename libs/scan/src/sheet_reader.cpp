// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/sheet_reader.h"

#include <algorithm>
#include <utility>

#include "ink.h"
#include "lines.h"
#include "nazori/writing/model_library.h"
#include "nazori/writing/recogniser.h"
#include "remarks.h"

namespace nazori::scan {
namespace {

// Ink is the character where no other character is much likelier.
constexpr double kAsLikely = 0.92;

}  // namespace

struct SheetReader::Inside {
  Inside(const kanji::KanjiDatabase& database, writing::Recogniser all)
      : library(database), recogniser(std::move(all)) {}

  [[nodiscard]] base::Result<void> judge(CellReading& cell, const writing::WrittenCharacter& ink);

  writing::ModelLibrary library;
  writing::Recogniser recogniser;
};

/// Whether ink is the character of its cell: of the characters that it may be none is much likelier, and what
/// is easily mistaken for it is not likelier at all.
base::Result<void> SheetReader::Inside::judge(CellReading& cell, const writing::WrittenCharacter& ink) {
  const char32_t asked = cell.box.character;
  const auto entry = library.find(asked);
  if (!entry) return tl::unexpected(entry.error());
  if (ink.strokes.empty()) return {};
  auto shape = writing::compare_ink(ink, (*entry)->model);
  cell.state = CellState::illegible;
  if (!shape) return {};  // A blot of thousands of lines is no character.
  cell.shape = *std::move(shape);
  writing::RecogniseOptions options;
  options.limit = 12;
  const auto candidates = recogniser.recognise(ink, options);
  if (!candidates || candidates->empty()) return {};
  const auto is_asked = [asked](const writing::Candidate& c) { return c.character == asked; };
  const auto found = std::find_if(candidates->begin(), candidates->end(), is_asked);
  const double likeness = found == candidates->end() ? 0 : found->likeness;
  const writing::Candidate& first = candidates->front();
  const bool likely = likeness >= kAsLikely * first.likeness;
  if (likely && is_alike(*cell.shape)) {
    cell.state = CellState::legible;
    cell.remarks = remarks_on(*cell.shape);
  } else if (first.character != asked) {
    cell.looks_like = first.character;
  }
  return {};
}

SheetReader::SheetReader(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
SheetReader::SheetReader(SheetReader&&) noexcept = default;
SheetReader& SheetReader::operator=(SheetReader&&) noexcept = default;
SheetReader::~SheetReader() = default;

base::Result<SheetReader> SheetReader::make(const kanji::KanjiDatabase& database) {
  auto recogniser = writing::Recogniser::make(database);
  if (!recogniser) return tl::unexpected(std::move(recogniser.error()));
  return SheetReader(std::make_unique<Inside>(database, *std::move(recogniser)));
}

base::Result<std::vector<SheetReading>> SheetReader::read(const Photo& photo) {
  const auto sheets = find_sheets(photo);
  if (!sheets) return tl::unexpected(sheets.error());
  std::vector<SheetReading> readings;
  for (const FoundSheet& sheet : *sheets) {
    SheetReading& reading = readings.emplace_back();
    reading.mark = sheet.mark;
    const auto placed = place_boxes(photo, sheet, print::boxes_of(sheet.mark));
    std::vector<DarkCell> cells;
    std::vector<DarkCell> open;
    for (const PlacedBox& box : placed) {
      cells.push_back(cut_out(photo, sheet.map, box));
      if (!box.box.traced) open.push_back(cells.back());
    }
    const float guides = guide_darkness(open, sheet.mark.guide);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      CellReading& cell = reading.cells.emplace_back();
      cell.box = placed[i].box;
      const double x = cell.box.corner.x + placed[i].x_mm;
      const double y = cell.box.corner.y + placed[i].y_mm;
      const double side = cell.box.side_mm;
      cell.corners = {sheet.map.at({x, y}), sheet.map.at({x + side, y}), sheet.map.at({x + side, y + side}),
                      sheet.map.at({x, y + side})};
      if (cell.box.traced) {
        cell.state = CellState::traced;
        continue;
      }
      const auto ink = lines_of(ink_of(cells[i], cell.box, sheet.mark.guide, guides));
      if (auto judged = inside_->judge(cell, ink); !judged) return tl::unexpected(std::move(judged.error()));
    }
  }
  // As they are numbered, not as they happened to lie.
  std::stable_sort(readings.begin(), readings.end(),
                   [](const SheetReading& a, const SheetReading& b) { return a.mark.page < b.mark.page; });
  return readings;
}

}  // namespace nazori::scan
