// SPDX-License-Identifier: Apache-2.0
#include "decision_trees.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace nazori::writing {
namespace {

constexpr std::size_t kNodeSize = 7;
constexpr std::uint8_t kAnswer = 255;

std::uint32_t number(std::span<const unsigned char> bytes) {
  std::uint32_t n = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) n = n << 8U | bytes[i];
  return n;
}

struct Node {
  std::uint8_t feature = 0;
  std::uint16_t right = 0;
  float value = 0;

  explicit Node(std::span<const unsigned char> bytes)
      : feature(bytes[0]),
        right(static_cast<std::uint16_t>(number(bytes.subspan(1, 2)))),
        value(std::bit_cast<float>(number(bytes.subspan(3, 4)))) {}
  [[nodiscard]] bool is_answer() const { return feature == kAnswer; }
  [[nodiscard]] bool is_good(std::size_t features) const {
    return std::isfinite(value) && is_answer() == (right == 0) && (is_answer() || feature < features);
  }
};

/// The bits from `first` up to before `end`.
std::uint16_t bits(std::size_t first, std::size_t end) {
  return static_cast<std::uint16_t>((1U << end) - (1U << first));
}

}  // namespace

std::optional<DecisionTrees> DecisionTrees::read(std::span<const unsigned char> bytes, std::size_t features) {
  if (bytes.size() % kNodeSize != 0) return {};
  DecisionTrees trees;
  std::vector<std::vector<Question>> by_feature(features);
  struct Asked {  // a question whose right child must still come
    std::size_t right;
    Node node;
    std::size_t first_answer;  // of the tree's
  };
  std::vector<Asked> asked;  // the nearest right child last
  bool is_root = true;
  for (std::size_t at = 0; at * kNodeSize < bytes.size(); ++at) {
    const Node node(bytes.subspan(at * kNodeSize, kNodeSize));
    if (!node.is_good(features)) return {};
    if (is_root) trees.first_answer_.push_back(trees.answers_.size());
    const std::size_t given = trees.answers_.size() - trees.first_answer_.back();
    is_root = node.is_answer() && asked.empty();
    if (!node.is_answer()) {
      asked.push_back({at + node.right, node, given});
      continue;
    }
    if (given == kMostAnswers) return {};
    trees.answers_.push_back(node.value);
    if (asked.empty()) continue;
    const auto& question = asked.back();
    if (question.right != at + 1) return {};
    by_feature[question.node.feature].push_back({question.node.value,
                                                 static_cast<std::uint16_t>(trees.first_answer_.size() - 1),
                                                 bits(question.first_answer, given + 1)});
    asked.pop_back();
  }
  if (!is_root || trees.first_answer_.size() > std::numeric_limits<std::uint16_t>::max()) return {};
  for (auto& questions : by_feature) {
    trees.first_question_.push_back(trees.questions_.size());
    std::stable_sort(questions.begin(), questions.end(),
                     [](const Question& a, const Question& b) { return a.limit < b.limit; });
    trees.questions_.insert(trees.questions_.end(), questions.begin(), questions.end());
  }
  trees.first_question_.push_back(trees.questions_.size());
  return trees;
}

float DecisionTrees::answer(std::span<const float> features) const {
  std::vector<std::uint16_t> ruled_out(count(), 0);
  for (std::size_t f = 0; f + 1 < first_question_.size(); ++f) {
    for (std::size_t k = first_question_[f]; k < first_question_[f + 1]; ++k) {
      const auto& question = questions_[k];
      if (features[f] <= question.limit) break;
      ruled_out[question.tree] |= question.left;
    }
  }
  // The first answer that no question rules out is the one to which the tree leads.
  float sum = 0;
  for (std::size_t tree = 0; tree < count(); ++tree)
    sum += answers_[first_answer_[tree] + static_cast<std::size_t>(std::countr_one(ruled_out[tree]))];
  return sum;
}

}  // namespace nazori::writing
