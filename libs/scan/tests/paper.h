// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/kanji_database.h"
#include "nazori/print/worksheet.h"
#include "nazori/scan/sheet_reader.h"

namespace nazori::scan {

/// Strokes in the unit square of a cell.
using Handwriting = std::vector<std::vector<std::array<double, 2>>>;

struct WrittenSample {
  char32_t character = 0;
  Handwriting strokes;
};

/// Real writing: the fixture, or the file (JSON Lines with "char" and "strokes") that the environment
/// variable NAZORI_SCAN_HANDWRITING names.
[[nodiscard]] std::vector<WrittenSample> real_handwriting();

/// A character of the database, as an unsteady hand writes it.
[[nodiscard]] Handwriting by_hand(const kanji::Character& character, std::mt19937& random,
                                  double unsteady = 1);

[[nodiscard]] const kanji::KanjiDatabase& database();
[[nodiscard]] std::vector<print::SheetCharacter> sheet_characters(std::u32string_view text);

/// How a page is photographed.
struct View {
  double dpi = 150;     ///< of the photograph
  double turn_deg = 0;  ///< clockwise
  double tilt_x = 0;    ///< how much farther the right edge is than the left, 0.2 is much
  double tilt_y = 0;    ///< the same for the lower edge
  double curl_mm = 0;   ///< by which the middle of the page is bent down
  double blur_px = 0;
  double noise = 0;  ///< standard deviation, of 255
  double light = 0;  ///< by which a corner is darker, 0.5 is much
};

/// A page on paper, at 300 dots per inch.
class PaperSheet {
 public:
  /// Prints a page with poppler's pdftoppm. @param page  from 1
  PaperSheet(const base::Result<std::string>& pdf, int page = 1);
  /// @param darkness  0.4 a pencil, 0.9 a black pen
  void write(const print::MarkedBox& box, const Handwriting& strokes, double pen_mm = 0.6,
             double darkness = 0.85);
  /// Draws over a part of the page [mm].
  void cover(double x, double y, double width, double height, std::uint8_t grey);
  [[nodiscard]] Photo photographed(const View& view, unsigned seed = 1) const;
  [[nodiscard]] double width_mm() const { return width_ / kDots; }
  [[nodiscard]] double height_mm() const { return height_ / kDots; }

 private:
  static constexpr double kDots = 300 / 25.4;  // per mm
  int width_ = 0;
  int height_ = 0;
  std::vector<float> grey_;
};

}  // namespace nazori::scan
