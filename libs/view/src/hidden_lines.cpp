// SPDX-License-Identifier: Apache-2.0
#include "hidden_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <utility>

namespace nazori::view {
namespace {

constexpr std::size_t kVeryMany = 50'000;
// On each side of the tablet. A cell is as wide as a line on a small picture, or as long as an arrowhead.
constexpr int kLineCells = 256;
constexpr int kHeadCells = 64;
constexpr int kEnough = 4;

/// How often each cell of the tablet is covered.
class Coverage {
 public:
  Coverage(const geometry::TabletShape& shape, int cells)
      : cells_(cells),
        per_metre_(static_cast<float>(cells / shape.width_m)),
        counts_(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), 0) {}

  /// Adds a line. @return whether some cell on it was not yet covered often enough; if not, nothing is added.
  bool take(glm::vec2 from_m, glm::vec2 to_m) {
    const glm::vec2 from = place(from_m);
    const glm::vec2 way = place(to_m) - from;
    const int steps = static_cast<int>(std::max(std::abs(way.x), std::abs(way.y))) + 1;
    const glm::vec2 step = way / static_cast<float>(steps);
    const auto cell_at = [&](int i) {
      return index(from.x + step.x * static_cast<float>(i), from.y + step.y * static_cast<float>(i));
    };
    int i = 0;
    while (i <= steps && counts_[cell_at(i)] >= kEnough) ++i;
    if (i > steps) return false;
    for (; i <= steps; ++i) {
      std::uint8_t& count = counts_[cell_at(i)];
      if (count < kEnough) ++count;
    }
    return true;
  }

 private:
  /// In cells, limited to the tablet: points outside count to its rim.
  [[nodiscard]] glm::vec2 place(glm::vec2 at_m) const {
    const auto side = static_cast<float>(cells_);
    return glm::clamp(at_m * per_metre_ + side * 0.5F, 0.0F, side - 1.0F);
  }
  [[nodiscard]] std::size_t index(float x, float y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(x);
  }

  int cells_;
  float per_metre_;
  std::vector<std::uint8_t> counts_;
};

/// @param cells  on each side of the tablet. @param ends_of  the two ends of a mark [m].
template <class Mark, class EndsOf>
std::size_t put_hidden_last(std::vector<Mark>& marks, const geometry::TabletShape& shape, int cells,
                            EndsOf ends_of) {
  if (marks.size() <= kVeryMany) return marks.size();
  Coverage coverage(shape, cells);
  const auto hidden = std::stable_partition(marks.begin(), marks.end(), [&](const Mark& mark) {
    const auto [from_m, to_m] = ends_of(mark);
    return coverage.take(from_m, to_m);
  });
  return static_cast<std::size_t>(hidden - marks.begin());
}

}  // namespace

std::size_t put_hidden_last(std::vector<LinePiece>& lines, const geometry::TabletShape& shape) {
  return put_hidden_last(lines, shape, kLineCells,
                         [](const LinePiece& piece) { return std::pair(piece.from_m, piece.to_m); });
}

std::size_t put_hidden_last(std::vector<ArrowHead>& heads, const geometry::TabletShape& shape) {
  return put_hidden_last(heads, shape, kHeadCells,
                         [](const ArrowHead& head) { return std::pair(head.tip_m, head.tip_m); });
}

}  // namespace nazori::view
