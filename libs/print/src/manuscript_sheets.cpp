// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <algorithm>
#include <string_view>

namespace nazori::print {
namespace {

constexpr int kManuscriptCells = 20;

}  // namespace

void Sheets::manuscript() {
  const Rect all = inside_margins();
  constexpr double kColumnInCells = 1.4;  // with the gap for readings to its right
  const double columns_wide = (kManuscriptCells + 1) * kColumnInCells;
  const double cell = std::min(all.width / columns_wide, all.height / kManuscriptCells);
  const double left = all.x + (all.width - columns_wide * cell) / 2;
  const double top = all.y + (all.height - kManuscriptCells * cell) / 2;
  const auto cell_at = [&](int place) {
    const int column = place / kManuscriptCells;
    // The middle of the sheet, where it is folded, stays free.
    const double from_right = (column + (column >= kManuscriptCells / 2 ? 1 : 0) + 1) * kColumnInCells * cell;
    return Rect{left + columns_wide * cell - from_right, top + place % kManuscriptCells * cell, cell, cell};
  };
  const auto sheet = [&]() -> Canvas& {
    Canvas& canvas = new_page(false);
    for (int place = 0; place < kManuscriptCells * kManuscriptCells; ++place)
      canvas.rectangle(cell_at(place), {0.55, 0.2, 0});
    return canvas;
  };
  Canvas* canvas = &sheet();
  constexpr int kCells = kManuscriptCells * kManuscriptCells;
  const std::u32string_view closing = U"、。，．」』）";
  int place = 0;
  for (const char32_t letter : wide(s_.text)) {
    if (letter == U'\r') continue;
    if (letter == U'\n') {
      place = (place + kManuscriptCells - 1) / kManuscriptCells * kManuscriptCells;
      continue;
    }
    // A sign that closes does not begin a column: it shares the last cell of the one before.
    const bool shares =
        place > 0 && place % kManuscriptCells == 0 && closing.find(letter) != std::u32string_view::npos;
    if (!shares && place >= kCells) {
      canvas = &sheet();
      place = 0;
    }
    const Rect box = cell_at(shares ? place - 1 : place);
    const double size = cell * 0.84;
    const double inset = (cell - size) / 2;
    canvas->vertical_letter(box.x + inset, box.y + inset + (shares ? cell * 0.12 : 0), letter, size, 0.5);
    if (!shares) ++place;
  }
}

}  // namespace nazori::print
