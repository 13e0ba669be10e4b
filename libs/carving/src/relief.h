// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "centre_line.h"
#include "nazori/carving/carve.h"

namespace nazori::carving {

/// The map while strokes are cut into it: each sample holds the square of the depth, as a fraction of the
/// brush's depth.
///
/// Grooves join as S = a + b - a b of their squared depths a, b: the deeper one where they differ, a rounded
/// edge where their walls meet, never deeper than the brush, in any order.
class Relief {
 public:
  /// @param samples  size x size, all 0 at first, row-major; changed in place.
  Relief(std::span<float> samples, int size, CrossSection cross_section);

  void cut(const Piece& piece);

 private:
  template <class Profile>
  void cut_with(const Piece& piece, Profile profile);
  template <class Profile>
  void sweep(const Joint& from, const Joint& to, Profile profile);
  template <class Profile>
  void press(const Joint& at, Profile profile);
  /// The depths of one row from column `begin` up to `end`, ready to be deepened.
  float* row_of(int row, int begin, int end);
  void join();

  std::span<float> samples_;
  int size_;
  CrossSection cross_section_;
  // Depths of the present piece in rows [first_row_, last_row_) and, per row, the columns that are in use.
  std::vector<float> depths_;
  struct Columns {
    int begin;
    int end;
  };
  std::vector<Columns> used_;
  int first_row_ = 0;
  int last_row_ = 0;
};

}  // namespace nazori::carving
