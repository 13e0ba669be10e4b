// SPDX-License-Identifier: Apache-2.0
#include "alternative_orders.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>

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

/// The assignment of rows to columns of a square matrix with the smallest sum of costs: for each column its
/// row. Kuhn and Munkres with potentials, O(n^3).
std::vector<std::size_t> cheapest_assignment(const std::vector<std::vector<double>>& cost) {
  const std::size_t n = cost.size();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::vector<double> row_potential(n + 1);
  std::vector<double> column_potential(n + 1);
  std::vector<std::size_t> row_of(n + 1);  // of column j, 0: none; rows and columns from 1
  std::vector<std::size_t> way(n + 1);
  for (std::size_t row = 1; row <= n; ++row) {
    row_of[0] = row;
    std::size_t column = 0;
    std::vector<double> least(n + 1, kInfinite);
    std::vector<char> used(n + 1);
    do {
      used[column] = 1;
      const std::size_t from = row_of[column];
      double step = kInfinite;
      std::size_t next = 0;
      for (std::size_t j = 1; j <= n; ++j) {
        if (used[j] != 0) continue;
        const double reduced = cost[from - 1][j - 1] - row_potential[from] - column_potential[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          way[j] = column;
        }
        if (least[j] < step) {
          step = least[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j <= n; ++j) {
        if (used[j] != 0) {
          row_potential[row_of[j]] += step;
          column_potential[j] -= step;
        } else {
          least[j] -= step;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    while (column != 0) {
      row_of[column] = row_of[way[column]];
      column = way[column];
    }
  }
  std::vector<std::size_t> out(n);
  for (std::size_t j = 1; j <= n; ++j) out[j - 1] = row_of[j] - 1;
  return out;
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
  // What is left when the names of forms are taken away says which stroke comes when.
  for (const std::string_view form : {"Hyougai", "Jinmei", "Insatsu", "Kaisho", "NoDot"}) {
    if (suffix.starts_with(form)) suffix.remove_prefix(form.size());
  }
  return !suffix.empty();
}

std::optional<std::vector<int>> order_of_variant(const DrawnForm& main, const DrawnForm& variant) {
  const std::size_t n = main.strokes.size();
  if (n == 0 || variant.strokes.size() != n) return std::nullopt;
  std::vector<std::vector<double>> cost(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) cost[i][j] = ends_apart(main.strokes[i], variant.strokes[j]);
  }
  const auto main_of = cheapest_assignment(cost);
  std::vector<int> out;
  for (std::size_t j = 0; j < n; ++j) {
    if (cost[main_of[j]][j] > kFarthestEnds) return std::nullopt;
    out.push_back(static_cast<int>(main_of[j]) + 1);
  }
  return out;
}

}  // namespace nazori::ingest
