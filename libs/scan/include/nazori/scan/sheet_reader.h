// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/print/sheet_mark.h"
#include "nazori/scan/picture.h"
#include "nazori/scan/sheet.h"
#include "nazori/writing/ink_shape.h"

namespace nazori::scan {

/// What was found in a cell.
enum class CellState : std::uint8_t {
  empty,      ///< no ink
  legible,    ///< the character that belongs there
  illegible,  ///< ink that is not that character
  traced,     ///< not judged: the character is printed in the cell, and ink cannot be told from it
};

/// What is off in a cell with ink.
enum class CellFlaw : std::uint8_t {
  small,
  large,
  high,
  low,
  left,
  right,
  leans_left,
  leans_right,
  missing_stroke,  ///< there is no ink where the stroke should be
  short_stroke,    ///< only part of the stroke is there
  extra_ink,       ///< ink that belongs to no stroke
};

/// The names in documents and the sentences of explain(), in the order of the enumerations.
inline constexpr std::array<const char*, 4> kCellStates{"empty", "legible", "illegible", "traced"};
inline constexpr std::array<const char*, 11> kCellFlaws{
    "small",      "large",       "high",           "low",          "left",     "right",
    "leans_left", "leans_right", "missing_stroke", "short_stroke", "extra_ink"};

struct CellRemark {
  CellFlaw flaw = CellFlaw::small;
  int stroke = 0;  ///< of the model, from 1; 0 where it is about the whole character

  friend bool operator==(const CellRemark&, const CellRemark&) = default;
};

/// One cell of a sheet.
struct CellReading {
  print::MarkedBox box;
  std::array<PhotoPoint, 4> corners;  ///< where it is seen: upper left, upper right, lower right, lower left
  CellState state = CellState::empty;
  std::optional<char32_t> looks_like;      ///< illegible: the character that it may be
  std::optional<writing::InkShape> shape;  ///< legible and illegible
  std::vector<CellRemark> remarks;         ///< legible: what could be better; illegible: empty
};

/// One sheet of a photograph. The order and direction of strokes cannot be seen.
struct SheetReading {
  print::SheetMark mark;
  std::vector<CellReading> cells;  ///< in the order of writing
};

/// Reads what was written on printed sheets. Thread rules: one thread, like the database.
class SheetReader {
 public:
  /// @param database  must outlive the reader. @return the errors of Recogniser::make(). @cost a second.
  [[nodiscard]] static base::Result<SheetReader> make(const kanji::KanjiDatabase& database);
  SheetReader(SheetReader&&) noexcept;
  SheetReader& operator=(SheetReader&&) noexcept;
  ~SheetReader();

  /// @return the errors of find_sheets(); Errc::not_found for a character that is not in the database.
  [[nodiscard]] base::Result<std::vector<SheetReading>> read(const Photo& photo);

 private:
  struct Inside;
  explicit SheetReader(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// A remark as a few words: "too small", "stroke 3 is missing".
[[nodiscard]] std::string explain(const CellRemark& remark);

}  // namespace nazori::scan
