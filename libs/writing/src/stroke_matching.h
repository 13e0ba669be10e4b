// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "alignment.h"
#include "stroke_comparer.h"

namespace nazori::writing {

/// What the links leave over is missing or extra.
[[nodiscard]] Alignment explanation_of(std::vector<Link> links, float cost, std::size_t drawn_count,
                                       std::size_t model_count, Extent extent);

/// Finds which drawn stroke is which of the model under one map. What cannot be part of the best explanation
/// is not looked at.
class StrokeMatching {
 public:
  /// @param far  costs of places beyond which strokes are not compared
  StrokeMatching(StrokeComparer& strokes, Extent extent, float far);

  /// The best explanation under a map, without the cost of the map.
  [[nodiscard]] Alignment best(const Affine& map);

 private:
  enum class Move : unsigned char { none, match, missing, extra, join, split };
  struct Cell {
    float cost = 0;
    Move move = Move::none;
    unsigned char missed = 1;  // model strokes a `missing` passes over
  };

  [[nodiscard]] Cell& cell(std::size_t i, std::size_t j) { return cells_[i * (m_ + 1) + j]; }
  [[nodiscard]] float cost(std::size_t i, std::size_t j);
  [[nodiscard]] float match_cost(std::size_t i, std::size_t j);
  [[nodiscard]] float around_a_gap();
  [[nodiscard]] float rest(std::size_t i, std::size_t j) const;
  void improve(std::size_t i, std::size_t j, float cost, Move move, std::size_t missed = 1);
  void go_on_from(std::size_t i, std::size_t j);
  void try_match(std::size_t i, std::size_t j, float here);
  void try_join(std::size_t i, std::size_t j, float here);
  void try_split(std::size_t i, std::size_t j, float here);
  [[nodiscard]] Link link_of(std::size_t i, std::size_t j, Move move);
  [[nodiscard]] Alignment in_order();
  [[nodiscard]] float least_in_any_order();
  [[nodiscard]] Alignment in_any_order();

  StrokeComparer& strokes_;
  Extent extent_;
  float far_;
  std::size_t n_;
  std::size_t m_;
  std::vector<float> costs_;  // drawn by model; negative: not looked at yet
  std::vector<Cell> cells_;
  float enough_ = 0;  // no better explanation costs more
};

}  // namespace nazori::writing
