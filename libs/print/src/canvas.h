// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "font.h"

namespace nazori::print {

/// The fonts of a document; a letter is taken from the first that has it.
class Fonts {
 public:
  [[nodiscard]] static base::Result<Fonts> installed();
  struct Choice {
    std::size_t font = 0;
    GlyphId glyph = 0;
  };
  [[nodiscard]] Choice choose(char32_t code_point, bool vertical);
  /// Width of a text in ems.
  [[nodiscard]] double width(std::u32string_view text);
  [[nodiscard]] Font& at(std::size_t i) { return fonts_[i]; }
  [[nodiscard]] std::size_t count() const { return fonts_.size(); }

 private:
  std::vector<Font> fonts_;
};

/// A rectangle on a page [mm], from the upper left corner; y down.
struct Rect {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// How a line is drawn.
struct Pen {
  double grey = 0;  ///< 0 black, 1 white
  double width_mm = 0.2;
  double dash_mm = 0;  ///< 0: solid
};

/// The content of one page, in millimetres from its upper left corner, y down. Thread rules: one thread.
class Canvas {
 public:
  Canvas(Fonts& fonts, double height_mm) : fonts_(&fonts), height_mm_(height_mm) {}

  void line(double x0, double y0, double x1, double y1, const Pen& pen);
  void rectangle(const Rect& rect, const Pen& pen);
  /// A filled triangle.
  void triangle(double x0, double y0, double x1, double y1, double x2, double y2, double grey);
  void disc(double x, double y, double radius);
  /// Filled rectangles, black.
  void fill(std::span<const Rect> rects);
  /// Text from left to right. @param x,y  left end of the baseline. @param size_mm  of the em.
  void text(double x, double y, std::u32string_view text, double size_mm, double grey = 0,
            bool invisible = false);
  /// Text from left to right, turned clockwise by 90 degrees around (x, y).
  void turned_text(double x, double y, std::u32string_view text, double size_mm, double grey = 0);
  /// One letter of vertical text in its em box.
  void vertical_letter(double x, double y, char32_t letter, double size_mm, double grey = 0);
  /// An object that was drawn in a rectangle of this size at the corner of a canvas of its own.
  void object(std::string_view name, const Rect& rect);
  /// An object "/C<index>" that was drawn in glyph units into a square.
  void character(int index, const Rect& square, double grey);
  /// Content in glyph units in a square.
  void in_square(const Rect& square, std::string_view content, double grey);

  [[nodiscard]] const std::string& content() const { return content_; }

 private:
  void set(const Pen& pen);
  void show(std::u32string_view text, double size_mm, bool vertical);
  Fonts* fonts_;
  double height_mm_;
  std::string content_;
};

/// A number with two decimals at most.
[[nodiscard]] std::string number(double value);
/// "1 0 0 1 0 0 cm" and the like in points, for a square of glyph units at a place of a page.
[[nodiscard]] std::string square_matrix(const Rect& square, double page_height_mm);

}  // namespace nazori::print
