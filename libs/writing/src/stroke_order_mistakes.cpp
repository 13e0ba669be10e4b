// SPDX-License-Identifier: Apache-2.0
#include "stroke_order_mistakes.h"

#include <algorithm>
#include <utility>

namespace nazori::writing {
namespace {

/// Positions in `links` of a longest sequence whose model strokes ascend. If there are several, the strokes
/// drawn first are kept, so that the later ones are reported.
std::vector<char> longest_in_order(std::span<const Link> links) {
  const std::size_t n = links.size();
  std::vector<std::size_t> length(n, 1), before(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (links[k].model < links[i].model && length[k] + 1 > length[i]) {
        length[i] = length[k] + 1;
        before[i] = k;
      }
  std::vector<char> kept(n);
  std::size_t i = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  for (; i < n; i = before[i]) kept[i] = 1;
  return kept;
}

/// The two positions whose exchange restores the order, if any.
std::pair<std::size_t, std::size_t> exchanged(std::span<const Link> links) {
  std::vector<int> sorted;
  for (const auto& l : links) sorted.push_back(l.model);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> off;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].model != sorted[i]) off.push_back(i);
  if (off.size() == 2) return {off[0], off[1]};
  return {0, 0};
}

}  // namespace

std::vector<OutOfTurn> strokes_out_of_turn(std::span<const Link> links) {
  if (std::is_sorted(links.begin(), links.end(),
                     [](const Link& a, const Link& b) { return a.model < b.model; }))
    return {};
  if (const auto [first, second] = exchanged(links); first != second)
    return {{links[first].drawn, links[second].drawn, {links[first].drawn, links[second].drawn}}};
  std::vector<OutOfTurn> result;
  const auto kept = longest_in_order(links);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (kept[i] != 0) continue;
    // Report the stroke that came too early, whichever of the two was moved.
    OutOfTurn mistake{links[i].drawn, links[i].drawn, {links[i].drawn}};
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (kept[k] == 0) continue;
      if (k > i && links[k].model < links[i].model) mistake.before = links[k].drawn;
      if (k < i && links[k].model > links[i].model) {
        mistake.drawn = links[k].drawn;
        mistake.before = links[i].drawn;
        break;
      }
    }
    if (mistake.drawn != mistake.before) result.push_back(std::move(mistake));
  }
  return result;
}

}  // namespace nazori::writing
