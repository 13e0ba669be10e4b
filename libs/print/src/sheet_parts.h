// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvas.h"
#include "nazori/kanji/character.h"
#include "nazori/print/worksheet.h"

namespace nazori::print {

/// The direction in which a page is filled. "Along" is the direction of writing, "across" that of the lines:
/// right and down, or for vertical pages down and left.
class Flow {
 public:
  Flow(const Rect& area, bool vertical) : area_(area), vertical_(vertical) {}
  [[nodiscard]] double length() const { return vertical_ ? area_.height : area_.width; }
  [[nodiscard]] double depth() const { return vertical_ ? area_.width : area_.height; }
  [[nodiscard]] Rect rect(double along, double across, double length, double depth) const {
    if (vertical_) return {area_.x + area_.width - across - depth, area_.y + along, depth, length};
    return {area_.x + along, area_.y + across, length, depth};
  }
  /// One line of text in a strip as deep as the letters. Vertical: letters below one another, Latin text
  /// turned.
  void text(Canvas& canvas, double along, double across, std::u32string_view text, double size_mm,
            double grey = 0) const;

 private:
  Rect area_;
  bool vertical_;
};

/// The outline of a cell and its guides.
void draw_cell(Canvas& canvas, const Rect& cell, Guide guide);

/// The strokes of a character as content in glyph units. @param first,last  of the strokes, 0-based, last one
/// not included.
[[nodiscard]] std::string strokes_content(const kanji::Character& character, std::size_t first,
                                          std::size_t last);

/// The same strokes as a brush draws them: broad, and thinning out where they sweep or flick.
[[nodiscard]] std::string brush_content(const kanji::Character& character);

/// Numbers and arrows of the strokes of a model.
void draw_numbers(Canvas& canvas, const kanji::Character& character, const Rect& square);
void draw_arrows(Canvas& canvas, const kanji::Character& character, const Rect& square);

/// What is said about a character.
struct Facts {
  std::u32string on;        ///< "キュウ"
  std::u32string kun;       ///< "やす(む)、やす(まる)"
  std::u32string meanings;  ///< "rest, day off"
};
[[nodiscard]] Facts facts_of(const kanji::Character& character);

/// A character as text that can be searched for: of one that somebody made, which has no letter, its name.
[[nodiscard]] std::u32string text_of(const SheetCharacter& one);

/// Who made the strokes of a document, as their licences ask.
[[nodiscard]] std::u32string credits_of(std::span<const SheetCharacter> characters);

/// A text cut where it does not fit.
[[nodiscard]] std::u32string cut(Fonts& fonts, std::u32string text, double most);

/// UTF-8 as code points; what is not UTF-8 is empty.
[[nodiscard]] std::u32string wide(std::string_view utf8);

}  // namespace nazori::print
