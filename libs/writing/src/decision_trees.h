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
/// Annals of Statistics 29 (2001); all trees at once, feature by feature: C. Lucchese et al., "QuickScorer: a
/// fast algorithm to rank documents with additive ensembles of regression trees", SIGIR 2015.
class DecisionTrees {
 public:
  /// Answers that one tree may have.
  static constexpr std::size_t kMostAnswers = 16;

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

  [[nodiscard]] std::size_t count() const { return first_answer_.size(); }

 private:
  /// A question of a tree: what a number above the limit rules out.
  struct Question {
    float limit = 0;
    std::uint16_t tree = 0;
    std::uint16_t left = 0;  // the tree's answers under the left child, one bit each
  };

  std::vector<Question> questions_;          // by feature, the lowest limit first
  std::vector<std::size_t> first_question_;  // of each feature, and one more
  std::vector<float> answers_;
  std::vector<std::size_t> first_answer_;  // of each tree
};

}  // namespace nazori::writing
