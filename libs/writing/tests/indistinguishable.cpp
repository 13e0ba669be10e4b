// SPDX-License-Identifier: Apache-2.0
#include "indistinguishable.h"

#include <algorithm>
#include <numeric>

#include "nazori/geometry/polyline.h"

namespace nazori::writing::test {

bool indistinguishable_reversed(const kanji::Character&, std::size_t) { return false; }

bool indistinguishable_without(const kanji::Character& character, std::size_t) {
  // The source has a form with a stroke less (the dot of 者 in 儲, the second dot of ⻌): it is that form.
  return std::any_of(character.variants.begin(), character.variants.end(), [](const std::string& name) {
    return name.starts_with("Hyougai") || name.starts_with("Kaisho") || name.starts_with("Insatsu");
  });
}

bool indistinguishable_exchanged(const kanji::Character& character, std::size_t k) {
  // It is a listed order.
  std::vector<int> order(character.strokes.size());
  std::iota(order.begin(), order.end(), 1);
  std::swap(order[k], order[k + 1]);
  return std::any_of(character.alternative_orders.begin(), character.alternative_orders.end(),
                     [&order](const kanji::AlternativeOrder& listed) { return listed.order == order; });
}

bool indistinguishable_shortened(const kanji::Character& character, std::size_t k) {
  // A single stroke shortened is a small one, and size does not count.
  if (character.strokes.size() == 1) return true;
  // A dot may be a mere touch: natives write the dots of 代 and 心 a seventh as long as the model's.
  constexpr double kDot = 17;  // glyph units
  if (length_of(character.strokes[k]) < kDot) return true;
  // The source has a form whose stroke is that much shorter: the inner bars of 日 that do not reach the
  // right.
  return shorter_in_a_variant(character, k);
}

}  // namespace nazori::writing::test
