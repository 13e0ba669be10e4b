// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "sheets.h"

namespace nazori::print {
namespace {

constexpr double kNameShare = 0.13;  // of the width, for the column of the name
constexpr double kSquareShare = 0.9;
constexpr double kNameLetter_mm = 4;
constexpr Pen kFold{0.6, 0.15, 3};

int columns_of(int per_sheet) { return per_sheet < 4 ? 1 : 2; }

}  // namespace

base::Result<void> Sheets::brush(const base::Progress& progress) {
  const auto step = static_cast<std::size_t>(s_.per_sheet);
  for (std::size_t first = 0; first < characters_.size(); first += step) {
    if (progress &&
        !progress(static_cast<double>(first) / static_cast<double>(characters_.size()), "drawing the sheets"))
      return base::fail(base::Errc::cancelled, "stopped", "worksheet");
    for (int sheet = 0; sheet < std::max(1, s_.rows); ++sheet) {
      if (sheet >= s_.copies)
        brush_sheet(first, std::nullopt);
      else
        brush_sheet(first, 0.62 + 0.28 * faded(sheet));
    }
  }
  return {};
}

void Sheets::brush_sheet(std::size_t first, std::optional<double> grey) {
  Canvas& canvas = new_page(false);
  const Rect all = inside_margins();
  const double name = s_.name_line ? all.width * kNameShare : 0;
  const int columns = columns_of(s_.per_sheet);
  const int rows = s_.per_sheet / columns;
  const double width = (all.width - name) / columns;
  const double height = all.height / rows;
  canvas.rectangle(all, {0.45, 0.25, 0});
  for (int column = 0; column < columns; ++column)
    if (const double x = all.x + name + column * width; x > all.x)
      canvas.line(x, all.y, x, all.y + all.height, kFold);
  for (int row = 1; row < rows; ++row)
    canvas.line(all.x + name, all.y + row * height, all.x + all.width, all.y + row * height, kFold);
  if (s_.name_line) {
    // Where the name begins; Latin letters stand on their side.
    const Flow flow({all.x, all.y, name, all.height}, true);
    flow.text(canvas, 2, (name - kNameLetter_mm) / 2, label("Name", "名前"), kNameLetter_mm, 0.5);
  }
  const double side = std::min(width, height) * kSquareShare;
  const auto left = static_cast<int>(characters_.size() - first);
  for (int place = 0; place < std::min(s_.per_sheet, left); ++place) {
    // From top to bottom, then the column to the left.
    const int column = place / rows;
    const double x = all.x + all.width - (column + 1) * width + (width - side) / 2;
    const double y = all.y + place % rows * height + (height - side) / 2;
    const Rect square{x, y, side, side};
    if (s_.guide != Guide::none) place_cell(canvas, square, s_.guide);
    if (!grey) continue;
    const std::size_t i = first + static_cast<std::size_t>(place);
    used_.insert(i);
    canvas.character(static_cast<int>(i), square, *grey);
    annotate(canvas, characters_[i], square);
  }
}

}  // namespace nazori::print
