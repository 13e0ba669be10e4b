// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <algorithm>
#include <cstddef>

namespace nazori::print {
namespace {

constexpr double kCardWidth_mm = 85;
constexpr double kCardHeight_mm = 50;
constexpr double kCutMark_mm = 4;

}  // namespace

void Sheets::card_front(Canvas& canvas, std::size_t i, const Rect& card) {
  const double side = card.height - 8;
  const Rect box{card.x + (card.width - side) / 2, card.y + 4, side, side};
  used_.insert(i);
  canvas.character(static_cast<int>(i), box, 0);
  if (s_.numbers) draw_numbers(canvas, characters_[i].character, box);
  place_text(canvas, characters_[i], box);
}

void Sheets::card_back(std::size_t i, const Rect& card) {
  const Rect inside{card.x + 5, card.y + 5, card.width - 10, card.height - 10};
  draw_facts(characters_[i], Flow(inside, false), 0, 0, inside.width, inside.height);
}

void Sheets::cards() {
  const double width = size_.width - 2 * kMargin_mm - 2 * kCutMark_mm;
  const double height = size_.height - 2 * kMargin_mm - 2 * kCutMark_mm - kFooter_mm;
  const int columns = std::max(1, static_cast<int>(width / kCardWidth_mm));
  const int rows = std::max(1, static_cast<int>(height / kCardHeight_mm));
  const double card_width = std::min(kCardWidth_mm, width);
  const double left = (size_.width - columns * card_width) / 2;
  const double top = kMargin_mm + kCutMark_mm;
  const auto on_page = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (std::size_t first = 0; first < characters_.size(); first += on_page) {
    for (const bool back : {false, true}) {
      Canvas& canvas = new_page(false);
      const Pen pen{0.3, 0.15, 0};
      for (int c = 0; c <= columns; ++c) {
        const double x = left + c * card_width;
        canvas.line(x, top - kCutMark_mm, x, top - 1, pen);
        canvas.line(x, top + rows * kCardHeight_mm + 1, x, top + rows * kCardHeight_mm + kCutMark_mm, pen);
      }
      for (int r = 0; r <= rows; ++r) {
        const double y = top + r * kCardHeight_mm;
        canvas.line(left - kCutMark_mm, y, left - 1, y, pen);
        canvas.line(left + columns * card_width + 1, y, left + columns * card_width + kCutMark_mm, y, pen);
      }
      for (std::size_t i = first; i < std::min(first + on_page, characters_.size()); ++i) {
        const int place = static_cast<int>(i - first);
        // Turned over at its long side, a sheet has its left column on the right.
        const int column = back ? columns - 1 - place % columns : place % columns;
        const int row = place / columns;
        const Rect card{left + column * card_width, top + row * kCardHeight_mm, card_width, kCardHeight_mm};
        if (back) {
          card_back(i, card);
        } else {
          card_front(canvas, i, card);
        }
      }
    }
  }
}

}  // namespace nazori::print
