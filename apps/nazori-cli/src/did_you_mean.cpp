// SPDX-License-Identifier: Apache-2.0
#include "did_you_mean.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace nazori::cli {
namespace {

// No word of a command line is longer, and the effort grows with the square.
constexpr std::size_t kLongest = 40;

/// Letters to leave out, add, change or swap with a neighbour, each at most once in a place.
/// @source optimal string alignment distance: L. Boytsov, Indexing methods for approximate dictionary
/// searching, 2011, section 2.2.
std::size_t steps_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) steps[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) steps[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = steps[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      steps[i][j] = std::min({changed, steps[i - 1][j] + 1, steps[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
    }
  }
  return steps[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> meant_word(std::string_view given, std::span<const std::string> words) {
  if (given.empty() || given.size() > kLongest) return std::nullopt;
  const auto begins_so = [given](const std::string& word) { return word.starts_with(given); };
  if (std::count_if(words.begin(), words.end(), begins_so) == 1)
    return *std::find_if(words.begin(), words.end(), begins_so);
  const std::size_t most = 1 + given.size() / 5;
  std::optional<std::string> best;
  std::size_t least = most + 1;
  for (const std::string& word : words) {
    // A word without any matching letter was not meant.
    const std::size_t steps =
        std::max(given.size(), word.size()) <= kLongest ? steps_between(given, word) : least;
    if (steps >= least || steps >= word.size()) continue;
    least = steps;
    best = word;
  }
  return best;
}

}  // namespace nazori::cli
