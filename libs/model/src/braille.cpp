// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/braille.h"

#include <array>

namespace nazori::model {
namespace {

constexpr BrailleCell dots(std::initializer_list<int> numbers) {
  unsigned cell = 0;
  for (const int dot : numbers) cell |= 1U << static_cast<unsigned>(dot - 1);
  return static_cast<BrailleCell>(cell);
}

constexpr BrailleCell kNumberSign = dots({3, 4, 5, 6});
constexpr BrailleCell kMinus = dots({3, 6});
constexpr BrailleCell kDecimalPoint = dots({2});

// a to j; digits use the same cells, j for 0.
constexpr std::array<BrailleCell, 10> kFirstTen{
    dots({1}),       dots({1, 2}),       dots({1, 4}),    dots({1, 4, 5}), dots({1, 5}),
    dots({1, 2, 4}), dots({1, 2, 4, 5}), dots({1, 2, 5}), dots({2, 4}),    dots({2, 4, 5})};

BrailleCell letter(char c) {
  if (c == 'w') return dots({2, 4, 5, 6});  // Braille's alphabet had no w: it stands outside the series
  const auto place = static_cast<std::size_t>(c - 'a' - (c > 'w' ? 1 : 0));
  const unsigned below[] = {0, dots({3}), dots({3, 6})};
  return static_cast<BrailleCell>(kFirstTen[place % 10] | below[place / 10]);
}

}  // namespace

std::optional<std::vector<BrailleCell>> braille_cells(std::string_view text) {
  std::vector<BrailleCell> cells;
  bool in_number = false;
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      if (!in_number) cells.push_back(kNumberSign);
      cells.push_back(kFirstTen[static_cast<std::size_t>(c == '0' ? 9 : c - '1')]);
      in_number = true;
    } else if (c == '.' && in_number) {
      cells.push_back(kDecimalPoint);
    } else {
      in_number = false;
      if (c >= 'a' && c <= 'z') {
        cells.push_back(letter(c));
      } else if (c == '-') {
        cells.push_back(kMinus);
      } else if (c == ' ') {
        cells.push_back(0);
      } else {
        return std::nullopt;
      }
    }
  }
  return cells;
}

double braille_width_mm(std::size_t cells, const BrailleSize& size) {
  if (cells == 0) return 0;
  return static_cast<double>(cells - 1) * size.cell_distance_mm + size.dot_distance_mm + size.dot_width_mm;
}

double braille_height_mm(const BrailleSize& size) { return 2 * size.dot_distance_mm + size.dot_width_mm; }

std::vector<PlatePoint> braille_dots(std::span<const BrailleCell> cells, PlatePoint lower_left,
                                     const BrailleSize& size) {
  const double inset = size.dot_width_mm / 2;
  std::vector<PlatePoint> points;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (unsigned dot = 0; dot < 6; ++dot) {
      if ((cells[i] >> dot & 1U) == 0) continue;
      const unsigned column = dot / 3;
      const unsigned row = 2 - dot % 3;
      points.push_back({lower_left.x + inset + static_cast<double>(i) * size.cell_distance_mm +
                            column * size.dot_distance_mm,
                        lower_left.y + inset + row * size.dot_distance_mm});
    }
  }
  return points;
}

void add_braille(Plate& plate, const std::vector<BrailleCell>& cells, PlatePoint lower_left,
                 const BrailleSize& size) {
  for (const PlatePoint dot : braille_dots(cells, lower_left, size))
    plate.add_dot(dot, size.dot_width_mm, size.dot_height_mm);
}

}  // namespace nazori::model
