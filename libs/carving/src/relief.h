// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "centre_line.h"
#include "nazori/carving/carve.h"
#include "nazori/carving/groove.h"

namespace nazori::carving {

/// The map while strokes are cut into it: each sample is the square of the depth, as a fraction of the
/// brush's depth.
///
/// Grooves join as S = a + b - a b of their squared depths a, b: the deeper one where they differ, a rounded
/// edge where their walls meet, never deeper than the brush, in any order. Where a whole tile has reached the
/// depth of the brush, nothing more is cut, so many overlapping strokes cost little more than one full layer.
class Relief {
 public:
  /// @param samples  size x size, all 0 at first, row-major; changed in place.
  Relief(std::span<float> samples, int size, CrossSection cross_section);
  /// Cuts only in a box, and what it cuts there is the same, bit for bit, in every box: tiles that are full
  /// are not passed over, because whether they are depends on samples outside of the box.
  /// @param box  within the map; its samples are 0 at first.
  Relief(std::span<float> samples, int size, const GridBox& box);

  void cut(const Piece& piece);

 private:
  template <class Profile>
  void cut_with(const Piece& piece, Profile profile);
  template <class Profile>
  void sweep(const Joint& from, const Joint& to, Profile profile);
  /// The part of a sweep in rows [row_begin, row_end). @param ux,uy  unit direction of the segment.
  template <class Profile>
  void sweep_rows(const Joint& from, const Joint& to, double ux, double uy, int row_begin, int row_end,
                  Profile profile);
  template <class Profile>
  void press(const Joint& at, Profile profile);
  /// The depths of one row from column `begin` up to `end`, about to be deepened.
  float* row_of(int row, int begin, int end);
  void join();
  /// Records that samples [begin, end) of a row may have become full.
  void mark(int row, int begin, int end);
  /// Whether nothing more can be cut in the tiles of a row of tiles from column `left` to column `right`.
  [[nodiscard]] bool is_full(int tile_row, double left, double right) const;

  std::span<float> samples_;
  int size_;
  CrossSection cross_section_;
  GridBox box_;
  bool skips_full_ = true;
  // Depths of the present piece in rows [first_row_, last_row_) and, per row, the columns that are in use;
  // none are in use outside of [cut_begin_, cut_end_).
  std::vector<float> depths_;
  struct Columns {
    int begin;
    int end;
  };
  std::vector<Columns> used_;
  int first_row_ = 0;
  int last_row_ = 0;
  int cut_begin_ = 0;
  int cut_end_ = 0;
  struct Tile {
    std::uint8_t changes = 0;  ///< since its samples were last checked
    bool is_full = false;
  };
  int tiles_in_row_;
  std::vector<Tile> tiles_;
  bool any_full_ = false;
};

}  // namespace nazori::carving
