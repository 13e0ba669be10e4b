// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nazori::writing {

/// Decision trees whose answers are added.
/// @source gradient boosting: J. H. Friedman, "Greedy function approximation: a gradient boosting machine",
/// Annals of Statistics 29 (2001).
class DecisionTrees {
 public:
  /// Trees from their file: nodes of 7 bytes, a parent before its children, the left child right after it.
  /// Each has the number of its feature, or 255 for an answer; the distance to its right child (0 for an
  /// answer), 16 bits; and the largest number that goes left, or the answer, a 32-bit float. Numbers are
  /// little-endian.
  /// @param features  how many numbers the trees may ask for
  /// @return nothing where the bytes are no such trees.
  [[nodiscard]] static std::optional<DecisionTrees> read(std::span<const unsigned char> bytes,
                                                         std::size_t features);

  /// The answers of all trees together. @pre as many numbers as read() was told. Any thread.
  [[nodiscard]] float answer(std::span<const float> features) const;

  [[nodiscard]] std::size_t count() const { return trees_.size(); }

 private:
  struct Node {
    float limit = 0;
    std::uint16_t right = 0;  // steps to the right child; 0 in an answer, which leads to itself
    std::uint8_t left = 0;    // the same
    std::uint8_t feature = 0;
  };
  struct Tree {
    std::uint32_t root = 0;
    std::uint32_t depth = 0;
  };

  std::vector<Node> nodes_;
  std::vector<float> answers_;  // of nodes that are answers
  std::vector<Tree> trees_;
};

}  // namespace nazori::writing
