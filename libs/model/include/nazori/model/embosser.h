// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "nazori/model/braille.h"
#include "nazori/model/raised.h"

namespace nazori::model {

/// The paper of a braille embosser. Its cells have the usual distances: 6 mm side by side, 10 mm below one
/// another, dots 2.5 mm apart.
struct EmbosserPaper {
  int columns = 40;  ///< cells of a line, 12..100
  int lines = 25;    ///< of a page, 12..100
};

/// A page of cells, line by line from the top.
class EmbosserPage {
 public:
  explicit EmbosserPage(const EmbosserPaper& paper);
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int lines() const { return lines_; }
  /// @param column,line  of the cell, within the page.
  [[nodiscard]] BrailleCell at(int column, int line) const { return cells_[index(column, line)]; }
  void set(int column, int line, BrailleCell cell) { cells_[index(column, line)] = cell; }

 private:
  [[nodiscard]] std::size_t index(int column, int line) const {
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int columns_;
  int lines_;
  std::vector<BrailleCell> cells_;
};

/// Where the dots of a page are [mm]: x right from the first dot of a line.
[[nodiscard]] double dot_x_mm(int dot_column);
/// y down from the first dot of a page. Between two lines there is a gap.
[[nodiscard]] double dot_y_mm(int dot_row);

/// A character in dots, and text below it.
struct EmbossedCharacter {
  EmbosserPage page;
  std::vector<int> without_number;  ///< strokes (from 1) for whose number there was no room
};

/// What tells strokes apart.
struct EmbossedMarks {
  bool numbers = true;     ///< the place in the order as digits, without the sign for numbers
  bool start_dots = true;  ///< a full cell where each stroke starts
};

/// Draws the strokes of a character with dots in a square at the top of a page, as large as the page leaves
/// room for above the text, and the text below. The number of each stroke stands beside its start, as a digit
/// in a cell with nothing around it. A stroke that stops is a row of dots without gaps. Where one sinks
/// (LineEnd) three of its last dots are left out, every second one and none of its first 60 %: its end is
/// sparse.
/// @param strokes  x and y are shares of the side, 0..1, y up. @param text  lines of cells; what is longer
/// than a line goes on in the next one, what does not fit on half of the page is left out.
/// @return Errc::bad_argument for a paper out of range or no stroke.
[[nodiscard]] base::Result<EmbossedCharacter> embossed(std::span<const RaisedStroke> strokes,
                                                       std::span<const std::vector<BrailleCell>> text,
                                                       const EmbossedMarks& marks = {},
                                                       const EmbosserPaper& paper = {});

/// A plot in dots. A curve is a row of dots without gaps; a second one has four dots and a gap of two, a
/// third one every third dot. Axes have every second dot, and leave out those that touch a curve. Ticks are
/// dots beside the axes and at the lower and left side; their numbers stand to the left and below, where
/// there is room, and the letters x and y at the ends of the axes.
/// @param plot  without a surface. @param text  below, as embossed().
/// @return Errc::bad_argument for a paper out of range or without room for a square of 40 mm, or a surface.
[[nodiscard]] base::Result<EmbosserPage> embossed_plot(const RaisedPlot& plot,
                                                       std::span<const std::vector<BrailleCell>> text,
                                                       const EmbosserPaper& paper = {});

/// Pages as a file for an embosser (BRF): ASCII braille of North America, lines end with CR LF, pages with a
/// form feed. Blanks at the ends of lines and empty lines at the end of a page are left out.
[[nodiscard]] std::string to_brf(std::span<const EmbosserPage> pages);

}  // namespace nazori::model
