// SPDX-License-Identifier: Apache-2.0
#include "alternative_orders.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <string_view>

#include "nazori/base/assignment.h"
#include "nazori/base/utf8.h"
#include "tables.h"

namespace nazori::ingest {
namespace {

/// Farther than this a stroke of a variant is another stroke.
constexpr double kFarthestEnds = 20;

double ends_apart(const kanji::Stroke& a, const kanji::Stroke& b) {
  return std::max(geometry::distance(a.line.points.front(), b.line.points.front()),
                  geometry::distance(a.line.points.back(), b.line.points.back()));
}

}  // namespace

std::map<char32_t, std::vector<kanji::AlternativeOrder>> listed_orders() {
  std::map<char32_t, std::vector<kanji::AlternativeOrder>> out;
  for (const auto& row : table_rows(alternative_orders_table())) {
    assert(row.size() == 3);
    const auto character = base::decode_utf8(row[0]);
    assert(character && character->size() == 1);
    kanji::AlternativeOrder order;
    for (const std::string_view figure : split(row[1], ' ')) {
      int number = 0;
      std::from_chars(figure.data(), figure.data() + figure.size(), number);
      order.order.push_back(number);
    }
    order.source = row[2];
    out[character->front()].push_back(std::move(order));
  }
  return out;
}

bool names_an_order(std::string_view suffix) {
  // The rest after removing the names of forms describes the order of strokes.
  for (const std::string_view form : {"Hyougai", "Jinmei", "Insatsu", "Kaisho", "NoDot"}) {
    if (suffix.starts_with(form)) suffix.remove_prefix(form.size());
  }
  return !suffix.empty();
}

std::optional<std::vector<int>> order_of_variant(const DrawnForm& main, const DrawnForm& variant) {
  const std::size_t n = main.strokes.size();
  if (n == 0 || variant.strokes.size() != n) return std::nullopt;
  std::vector<double> costs(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) costs[i * n + j] = ends_apart(main.strokes[i], variant.strokes[j]);
  }
  const auto variant_of = base::cheapest_assignment(std::span<const double>(costs), n);
  std::vector<int> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (costs[i * n + variant_of[i]] > kFarthestEnds) return std::nullopt;
    out[variant_of[i]] = static_cast<int>(i) + 1;
  }
  return out;
}

}  // namespace nazori::ingest
