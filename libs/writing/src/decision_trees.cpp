// SPDX-License-Identifier: Apache-2.0
#include "decision_trees.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace nazori::writing {
namespace {

constexpr std::size_t kNodeSize = 7;
constexpr std::uint8_t kAnswer = 255;

std::uint32_t number(std::span<const unsigned char> bytes) {
  std::uint32_t n = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) n = n << 8U | bytes[i];
  return n;
}

}  // namespace

std::optional<DecisionTrees> DecisionTrees::read(std::span<const unsigned char> bytes, std::size_t features) {
  if (bytes.size() % kNodeSize != 0) return {};
  DecisionTrees trees;
  struct Awaited {
    std::size_t at;
    std::uint32_t level;
  };
  std::vector<Awaited> awaited;  // right children that must still come, the nearest last
  std::uint32_t level = 0;
  bool is_root = true;
  for (std::size_t at = 0; at * kNodeSize < bytes.size(); ++at) {
    const auto from = bytes.subspan(at * kNodeSize, kNodeSize);
    const std::uint8_t feature = from[0];
    const auto right = static_cast<std::uint16_t>(number(from.subspan(1, 2)));
    const auto value = std::bit_cast<float>(number(from.subspan(3, 4)));
    const bool is_answer = feature == kAnswer;
    if (!std::isfinite(value) || is_answer != (right == 0) || (!is_answer && feature >= features)) return {};
    if (is_root) {
      trees.trees_.push_back({static_cast<std::uint32_t>(at), 0});
      level = 0;
    }
    is_root = is_answer && awaited.empty();
    if (!is_answer) {
      trees.nodes_.push_back({value, right, 1, feature});
      trees.answers_.push_back(0);
      awaited.push_back({at + right, ++level});
      continue;
    }
    trees.nodes_.push_back({});
    trees.answers_.push_back(value);
    trees.trees_.back().depth = std::max(trees.trees_.back().depth, level);
    if (awaited.empty()) continue;
    if (awaited.back().at != at + 1) return {};
    level = awaited.back().level;
    awaited.pop_back();
  }
  if (!is_root) return {};  // the last tree has no end
  return trees;
}

float DecisionTrees::answer(std::span<const float> features) const {
  float sum = 0;
  for (const auto& tree : trees_) {
    std::size_t at = tree.root;
    // Always to the full depth: the processor need not guess where a tree ends, and works on several at once.
    for (std::uint32_t k = 0; k < tree.depth; ++k) {
      const Node& node = nodes_[at];
      at += features[node.feature] <= node.limit ? node.left : node.right;
    }
    sum += answers_[at];
  }
  return sum;
}

}  // namespace nazori::writing
