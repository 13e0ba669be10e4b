// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/model.h"

#include <algorithm>
#include <cmath>

#include "alignment.h"
#include "kana_dots.h"
#include "model_inside.h"
#include "voicing_marks.h"

namespace nazori::writing {
namespace {

/// Types with two readings ("㇔/㇑") may be drawn either way.
constexpr float kFreedomOfTwoTypes = 1.6F;

/// Kana have no types, because they come from cursive writing.
constexpr float kFreedomOfUntyped = 1.12F;

constexpr float kTouchOfDots = 24;  // glyph units

/// Slanting dots vary more in their slant than short bars and verticals do; the figures are those of real
/// writing in docs/writing.md.
float freedom_of_short_strokes(const Samples& model) {
  constexpr float kShort = 25;  // glyph units
  constexpr float kLeast = 0.75F;
  constexpr float kMost = 1.2F;
  const float dx = model.x.back() - model.x.front();
  const float dy = model.y.back() - model.y.front();
  const float squared = dx * dx + dy * dy;
  if (squared <= 0) return 1;
  const float slant = std::abs(2 * dx * dy) / squared;  // 0 for bars and verticals, 1 at 45 degrees
  const float ratio = model.length / kShort;
  return 1 + std::exp(-ratio * ratio) * (kLeast + (kMost - kLeast) * slant - 1);
}

/// Whether `lower` lies below the centre of `upper` and reaches further on both sides, as the bar of 言 does
/// below its dot. The dots of 氵 do not.
bool is_above(const Samples& upper, const Samples& lower) {
  const auto [upper_left, upper_right] = std::minmax_element(upper.x.begin(), upper.x.end());
  const auto [left, right] = std::minmax_element(lower.x.begin(), lower.x.end());
  return *std::min_element(lower.y.begin(), lower.y.end()) > upper.centre_y &&
         *left<*upper_left&& * right> * upper_right;
}

base::Result<Form> make_form(const kanji::Character& character) {
  if (character.strokes.empty())
    return base::fail(base::Errc::bad_argument, "the character has no strokes", {},
                      "choose a character that has strokes");
  Form form;
  form.variant = character.variant;
  form.first_voicing_mark = first_voicing_mark(character);
  for (const auto& stroke : character.strokes) {
    if (stroke.line.points.empty())
      return base::fail(base::Errc::bad_argument, "a stroke of the character has no points");
    auto shape = make_shape<geometry::GlyphFrame>(stroke.line.points);
    const bool two_types = stroke.type.find('/') != std::string::npos;
    shape.freedom = two_types ? kFreedomOfTwoTypes : freedom_of_short_strokes(shape.whole);
    // A stroke that the source calls a dot may be a mere touch even if its model is long: those of 心, 小.
    if (stroke.type.starts_with("㇔")) shape.touch = kTouchOfDots;
    auto& ways = form.other_ways.emplace_back();
    if (stroke.type.empty()) {
      shape.freedom *= kFreedomOfUntyped;
      ways = other_ways(character.code_point, form.shapes.size(), shape);
    }
    // A part that the source does not call a hook belongs to the stroke: the second leg of 糸's first stroke.
    if (stroke.line.ending == kanji::StrokeEnding::stop) shape.body.reset();
    form.shapes.push_back(shape);
    form.endings.push_back(stroke.line.ending);
    form.free_ending.push_back(two_types || stroke.line.ending == kanji::StrokeEnding::either ? 1 : 0);
  }
  for (std::size_t k = 0; k + 1 < form.shapes.size(); ++k)
    form.shapes[k].free_slant = character.strokes[k].type.starts_with("㇔") &&
                                is_above(form.shapes[k].whole, form.shapes[k + 1].whole);
  for (std::size_t k = 0; k + 1 < form.shapes.size(); ++k)
    form.pairs.push_back(joined(form.shapes[k].whole, form.shapes[k + 1].whole));
  return form;
}

bool same_order(const Form& variant, const Form& main) {
  const auto a = align({variant.shapes, main.shapes, main.pairs, Affine{}, Extent::whole});
  return std::is_sorted(a.links.begin(), a.links.end(),
                        [](const Link& x, const Link& y) { return x.model < y.model; }) &&
         std::none_of(a.links.begin(), a.links.end(), [](const Link& l) { return l.difference.reversed; });
}

}  // namespace

Model::Model(std::shared_ptr<const ModelInside> inside) : inside_(std::move(inside)) {}

base::Result<Model> Model::make(const kanji::Character& main, std::span<const kanji::Character> variants) {
  auto form = make_form(main);
  if (!form) return tl::unexpected(form.error());
  ModelInside inside;
  inside.code_point = main.code_point;
  inside.main = std::move(*form);
  for (const auto& order : main.alternative_orders)
    if (order.order.size() == main.strokes.size()) inside.orders.push_back(order);
  for (const auto& v : variants) {
    auto other = make_form(v);
    if (other && same_order(*other, inside.main)) inside.variants.push_back(std::move(*other));
  }
  return Model(std::make_shared<const ModelInside>(std::move(inside)));
}

char32_t Model::code_point() const { return inside_->code_point; }
int Model::stroke_count() const { return static_cast<int>(inside_->main.shapes.size()); }

}  // namespace nazori::writing
