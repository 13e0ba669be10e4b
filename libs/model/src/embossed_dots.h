// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/embosser.h"
#include "nazori/model/plate.h"

namespace nazori::model {

inline constexpr double kDot_mm = 2.5;
inline constexpr double kCell_mm = 6;
inline constexpr double kLine_mm = 10;

/// A dot of a page: two columns in a cell, three rows in a line.
struct Dot {
  int column;
  int row;
  friend bool operator==(const Dot&, const Dot&) = default;
};

/// The dot nearest to a place.
[[nodiscard]] Dot nearest_dot(double x_mm, double y_mm);

/// The dots along a line [mm, y down], one beside or diagonal to the other, without the inner dot of a step.
[[nodiscard]] std::vector<Dot> dots_along(const PlateLine& line);

/// @param dot  on the page.
void set_dot(EmbosserPage& page, const Dot& dot);
[[nodiscard]] bool has_dot(const EmbosserPage& page, const Dot& dot);

/// Text in lines of this many cells, broken at blanks where there are any.
[[nodiscard]] std::vector<std::vector<BrailleCell>> wrapped(std::span<const std::vector<BrailleCell>> text,
                                                            std::size_t columns);
/// @param line  of the first line of the text. Text and lines fit on the page.
void put_text(EmbosserPage& page, std::span<const std::vector<BrailleCell>> text, int line);

[[nodiscard]] base::Result<void> check_paper(const EmbosserPaper& paper);

}  // namespace nazori::model
