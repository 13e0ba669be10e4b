// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace nazori::author {

/// Numbers one after another, the highest byte first, as in fonts.
class FontBytes {
 public:
  void u8(unsigned value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
  void u16(std::size_t value) {
    u8(static_cast<unsigned>(value >> 8U) & 0xFFU);
    u8(static_cast<unsigned>(value) & 0xFFU);
  }
  void i16(int value) { u16(static_cast<std::uint16_t>(value)); }
  void u32(std::size_t value) {
    u16((value >> 16U) & 0xFFFFU);
    u16(value & 0xFFFFU);
  }
  void text(std::string_view ascii) { bytes_.insert(bytes_.end(), ascii.begin(), ascii.end()); }
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  void zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  /// Zeros up to a multiple of `unit` bytes.
  void align(std::size_t unit) { zeros((unit - bytes_.size() % unit) % unit); }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// What tables say so that readers can halve a list of `count` entries: the highest power of two in it, its
/// exponent, and what remains; the first and the last times the size of an entry.
struct SearchRange {
  std::size_t range = 0;
  std::size_t selector = 0;
  std::size_t shift = 0;
};
[[nodiscard]] SearchRange search_range(std::size_t count, std::size_t entry_size);

/// A table of a font.
struct FontTable {
  std::string_view tag;  ///< four letters
  std::vector<std::uint8_t> bytes;
};

/// The file of a TrueType font. `checkSumAdjustment` of the table head is filled in.
/// @param tables  in any order, one of them "head".
/// @source OpenType specification, "Organization of an OpenType Font".
[[nodiscard]] std::vector<std::uint8_t> font_file(std::vector<FontTable> tables);

/// A point of a glyph [font units], y up.
struct FontPoint {
  int x = 0;
  int y = 0;
  bool on_curve = true;
  friend bool operator==(const FontPoint&, const FontPoint&) = default;
};
using FontContour = std::vector<FontPoint>;

/// The box of points [font units].
struct FontBox {
  int left = 0;
  int bottom = 0;
  int right = 0;
  int top = 0;
};

/// Box of all points; of none, zeros.
[[nodiscard]] FontBox box_of_points(std::span<const FontContour> contours);
[[nodiscard]] std::size_t count_points(std::span<const FontContour> contours);

/// The bytes of a glyph with contours that may overlap; none for a blank one. Their number is a multiple
/// of 4.
/// @param contours  at most 32,767, with at most 65,535 points in all, each -16,384..16,383.
/// @source OpenType specification, "glyf: Simple Glyph Description".
[[nodiscard]] std::vector<std::uint8_t> glyph_bytes(std::span<const FontContour> contours);

}  // namespace nazori::author
