// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/print/page_drawing.h"
#include "nazori/print/worksheet.h"

namespace nazori::print {

/// One line of a quiz or the cells of one character on a practice sheet: what the mark says about it.
struct MarkedRun {
  double across_mm = 0;  ///< from the beginning of the page's area, across the direction of writing
  int rows = 1;          ///< of cells; a quiz has one
  /// Practice: the character. Quiz: of each cell its character, 0 where it is printed.
  std::vector<char32_t> characters;

  friend bool operator==(const MarkedRun&, const MarkedRun&) = default;
};

/// What the mark of a printed page holds: enough to find all cells and to know what belongs into them.
struct SheetMark {
  Layout layout = Layout::practice;  ///< practice or quiz
  bool vertical = false;
  Guide guide = Guide::cross;
  double width_mm = 210;  ///< of the page; of a booklet, of half a sheet
  double height_mm = 297;
  double cell_mm = 15;
  int copies = 0;  ///< practice: cells of each character that show it
  int page = 1;    ///< 1..1023
  std::vector<MarkedRun> runs;

  friend bool operator==(const SheetMark&, const SheetMark&) = default;
};

/// A cell to write in.
struct MarkedBox {
  char32_t character = 0;
  PaperPoint corner;  ///< upper left
  double side_mm = 0;
  bool traced = false;  ///< the character is printed in it, in grey

  friend bool operator==(const MarkedBox&, const MarkedBox&) = default;
};

/// Every cell in the order of writing.
[[nodiscard]] std::vector<MarkedBox> boxes_of(const SheetMark& mark);

/// The version that this program writes; it reads no other.
inline constexpr int kMarkVersion = 1;
/// The mark: four discs in the corners of the printed area, and from the lower left disc to the right a strip
/// of modules. The first row of the strip alternates, dark first; the others hold the bytes, column by column
/// from top to bottom, the highest bit first.
inline constexpr double kDisc_mm = 4;      ///< diameter
inline constexpr double kModule_mm = 0.8;  ///< side
inline constexpr int kMarkRows = 5;        ///< of data

/// Centres of the discs: upper left, upper right, lower right, lower left.
[[nodiscard]] std::array<PaperPoint, 4> disc_centres(double width_mm, double height_mm);
/// Centre of a module. @param row  0: the alternating row; 1..kMarkRows: data.
[[nodiscard]] PaperPoint module_centre(double height_mm, int column, int row);
/// Columns for so many bytes.
[[nodiscard]] constexpr int mark_columns(std::size_t bytes) {
  return static_cast<int>((bytes * 8 + kMarkRows - 1) / kMarkRows);
}
/// The most bytes for which a page of this width has room.
[[nodiscard]] std::size_t mark_room(double width_mm);

/// Marks have a multiple of this many bytes, from kFewestMarkBytes to kMostMarkBytes.
inline constexpr std::size_t kMarkStep = 5;
inline constexpr std::size_t kFewestMarkBytes = 20;
inline constexpr std::size_t kMostMarkBytes = 140;

/// The bytes of a mark: version, content, a checksum and the symbols that correct errors.
/// @return Errc::bad_argument where they are more than `room` or the content is out of range.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> mark_bytes(const SheetMark& mark, std::size_t room);

/// The content of a mark, of any bytes, filled up and with its checksum and the symbols that correct errors.
/// What is more than the largest mark holds is cut off.
[[nodiscard]] std::vector<std::uint8_t> sealed_mark(std::span<const std::uint8_t> content);

/// Reads what mark_bytes() made; up to one byte in seven may be wrong.
/// @return Errc::parse for damaged or foreign bytes, Errc::schema for another version. Any bytes are allowed.
[[nodiscard]] base::Result<SheetMark> read_mark(std::span<const std::uint8_t> bytes);

/// The page sizes of all papers and booklets: width and height [mm].
[[nodiscard]] const std::vector<std::array<double, 2>>& page_sizes();

}  // namespace nazori::print
