// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::view {

/// Numbers 1..count as white-on-black coverage, each in the middle of a square cell of one picture.
struct LabelSheet {
  int cell = 0;     ///< side of a cell in pixels
  int columns = 0;  ///< cells in a row; the number n is cell n - 1, row by row from the top
  int rows = 0;
  std::vector<std::uint8_t> coverage;  ///< columns * cell wide, rows * cell high
};

/// One line of text as white-on-black coverage.
struct LabelPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;  ///< row by row from the top
};

/// Draws digits with the system's sans-serif bold face, found by fontconfig; without a font with digits,
/// built-in figures are used, so that a picture always has its numbers.
class NumberFont {
 public:
  NumberFont();
  ~NumberFont();
  NumberFont(NumberFont&&) noexcept;
  NumberFont& operator=(NumberFont&&) noexcept;
  NumberFont(const NumberFont&) = delete;
  NumberFont& operator=(const NumberFont&) = delete;

  /// The figures drawn without a font. For systems without fonts, and for tests.
  [[nodiscard]] static NumberFont built_in();

  /// Family of the face in use, "built-in" without one.
  [[nodiscard]] std::string family() const;

  /// @param count  1..1024.  @param cell  side of a cell in pixels, 8..512: the numbers fill its inscribed
  /// disc.
  [[nodiscard]] LabelSheet draw(int count, int cell) const;

  /// A number as text: digits, '-', '+', '.' and 'e'; any other character is left out.
  /// @param height  of a digit in pixels, at least 5. @param margin  pixels that stay empty on all sides.
  [[nodiscard]] LabelPicture draw_text(std::string_view text, int height, int margin) const;

 private:
  struct Face;
  explicit NumberFont(std::unique_ptr<Face> face);
  std::unique_ptr<Face> face_;
};

}  // namespace nazori::view
