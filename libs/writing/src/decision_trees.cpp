// SPDX-License-Identifier: Apache-2.0
#include "decision_trees.h"

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
  std::vector<std::size_t> awaited;  // right children that must still come, the nearest last
  bool is_root = true;
  for (std::size_t at = 0; at * kNodeSize < bytes.size(); ++at) {
    const auto from = bytes.subspan(at * kNodeSize, kNodeSize);
    const Node node{from[0], static_cast<std::uint16_t>(number(from.subspan(1, 2))),
                    std::bit_cast<float>(number(from.subspan(3, 4)))};
    const bool is_answer = node.feature == kAnswer;
    if (!std::isfinite(node.value) || is_answer != (node.right == 0) ||
        (!is_answer && node.feature >= features))
      return {};
    if (is_root) trees.roots_.push_back(static_cast<std::uint32_t>(at));
    trees.nodes_.push_back(node);
    is_root = is_answer && awaited.empty();
    if (!is_answer) {
      awaited.push_back(at + node.right);
    } else if (!awaited.empty()) {
      if (awaited.back() != at + 1) return {};
      awaited.pop_back();
    }
  }
  if (!is_root) return {};  // the last tree has no end
  return trees;
}

float DecisionTrees::answer(std::span<const float> features) const {
  float sum = 0;
  for (const std::uint32_t root : roots_) {
    const Node* node = &nodes_[root];
    while (node->feature != kAnswer) node += features[node->feature] <= node->value ? 1 : node->right;
    sum += node->value;
  }
  return sum;
}

}  // namespace nazori::writing
