// SPDX-License-Identifier: Apache-2.0
#include "indistinguishable.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "nazori/geometry/polyline.h"

namespace nazori::writing::test {

namespace {

// clang-format off
// Few strokes, and this one determines the proportions of the whole: it looks the same as flat writing.
constexpr Spoilt kProportions[] = {
    {U'i', 1},
};
// A comma is so small that its tail shows no direction.
constexpr Spoilt kSpecks[] = {{U',', 1}, {U';', 2}};
// clang-format on

bool listed(std::span<const Spoilt> list, char32_t character, std::size_t k) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Spoilt& one) { return one.character == character && one.stroke == k + 1; });
}

double length_of(const kanji::Stroke& stroke) {
  return geometry::arc_length<geometry::GlyphFrame>(stroke.line.points);
}

bool shorter_in_a_variant(const kanji::KanjiDatabase& database, const kanji::Character& character,
                          std::size_t k) {
  constexpr double kShorter = 0.8;
  return std::any_of(character.variants.begin(), character.variants.end(), [&](const std::string& name) {
    const auto form = database.find(character.code_point, name);
    return form && form->strokes.size() == character.strokes.size() &&
           length_of(form->strokes[k]) < kShorter * length_of(character.strokes[k]);
  });
}

}  // namespace

std::vector<Spoilt> listed_as_shortened() { return {std::begin(kProportions), std::end(kProportions)}; }

bool indistinguishable_reversed(const kanji::Character& character, std::size_t k) {
  return listed(kSpecks, character.code_point, k);
}

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

bool indistinguishable_shortened(const kanji::KanjiDatabase& database, const kanji::Character& character,
                                 std::size_t k) {
  // A single stroke shortened is a small one, and size does not count.
  if (character.strokes.size() == 1) return true;
  // A dot may be a mere touch: natives write the dots of 代 and 心 a seventh as long as the model's.
  constexpr double kDot = 17;  // glyph units
  if (length_of(character.strokes[k]) < kDot) return true;
  // The dots of 小, 心, 志: the source calls the stroke a dot (㇔), and a quick hand writes it as a touch.
  constexpr double kLongDot = 27;
  if (character.strokes[k].type.starts_with("㇔") && length_of(character.strokes[k]) < kLongDot) return true;
  // The source has a form whose stroke is that much shorter: the inner bars of 日 that do not reach the
  // right.
  return shorter_in_a_variant(database, character, k) || listed(kProportions, character.code_point, k);
}

}  // namespace nazori::writing::test
