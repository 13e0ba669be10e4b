// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/model.h"

#include <algorithm>

#include "alignment.h"
#include "model_inside.h"

namespace nazori::writing {
namespace {

/// Types with two readings ("㇔/㇑") may be drawn either way.
constexpr float kFreedomOfTwoTypes = 1.6F;
/// The slant of dots is officially free (言, 主, 礻).
constexpr float kFreedomOfDots = 1.0F;

base::Result<Form> make_form(const kanji::Character& character) {
  if (character.strokes.empty())
    return base::fail(base::Errc::bad_argument, "The character has no strokes.", {},
                      "give a character that is drawn");
  Form form;
  form.variant = character.variant;
  for (const auto& stroke : character.strokes) {
    if (stroke.line.points.empty())
      return base::fail(base::Errc::bad_argument, "A stroke of the character has no points.");
    auto shape = make_shape<geometry::GlyphFrame>(stroke.line.points);
    const bool two_types = stroke.type.find('/') != std::string::npos;
    if (two_types)
      shape.freedom = kFreedomOfTwoTypes;
    else if (stroke.type.starts_with("㇔"))
      shape.freedom = kFreedomOfDots;
    form.shapes.push_back(shape);
    form.endings.push_back(stroke.line.ending);
    form.free_ending.push_back(two_types || stroke.line.ending == kanji::StrokeEnding::either ? 1 : 0);
  }
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
