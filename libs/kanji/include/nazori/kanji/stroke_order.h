// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/stroke.h"

namespace nazori::kanji {

/// A point of a stroke file: whole columns and rows of a height map, y down.
struct StrokeOrderPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const StrokeOrderPoint&, const StrokeOrderPoint&) = default;
};

/// The strokes of one character in writing order, as points on the grid of a height map, and the 2005 file
/// format .str.
///
/// .str: little-endian int32: number of strokes; then for each stroke the number of points, then x and y of
/// each.
/// @source A. D. Horne, West Virginia University, 2005.
class StrokeOrder {
 public:
  using Points = std::vector<StrokeOrderPoint>;

  /// Largest side of a grid, and largest counts that a file may contain.
  static constexpr int kMaxGrid = 8192;
  static constexpr int kMaxStrokes = 1024;
  static constexpr int kMaxPointsPerStroke = 65536;

  StrokeOrder() = default;
  explicit StrokeOrder(std::vector<Points> strokes) : strokes_(std::move(strokes)) {}

  void add_stroke(Points points) { strokes_.push_back(std::move(points)); }
  [[nodiscard]] std::size_t count() const { return strokes_.size(); }
  /// @param number 1..count().
  [[nodiscard]] const Points& stroke(std::size_t number) const { return strokes_.at(number - 1); }
  [[nodiscard]] const std::vector<Points>& all() const { return strokes_; }

  /// @param grid_size  side of the grid that the points must lie in, 2..8192.
  /// @return Errc::parse for a truncated file, extra bytes, counts that are negative or beyond the limits,
  /// and points outside the grid, with the byte offset in the text. Memory used is bounded by the length of
  /// `bytes`.
  [[nodiscard]] static base::Result<StrokeOrder> parse(std::span<const std::uint8_t> bytes, int grid_size);
  [[nodiscard]] std::vector<std::uint8_t> to_bytes() const;

  [[nodiscard]] static base::Result<StrokeOrder> load(const std::filesystem::path& path, int grid_size);
  [[nodiscard]] base::Result<void> save(const std::filesystem::path& path) const;

  /// Lines, such as the strokes of a character (kanji::centre_lines()) or curves, on a grid of `grid_size`:
  /// points rounded to whole samples, bends kept.
  [[nodiscard]] static StrokeOrder from_lines(std::span<const geometry::Polyline<geometry::GlyphFrame>> lines,
                                              int grid_size);
  /// The strokes as lines in the glyph frame. A file does not say how strokes end: the ending is hook where
  /// the last segment is short and turns by more than 60 degrees, otherwise either.
  [[nodiscard]] std::vector<StrokeLine> to_lines(int grid_size) const;

  friend bool operator==(const StrokeOrder&, const StrokeOrder&) = default;

 private:
  std::vector<Points> strokes_;
};

}  // namespace nazori::kanji
