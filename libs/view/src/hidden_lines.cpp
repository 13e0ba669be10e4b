// SPDX-License-Identifier: Apache-2.0
#include "hidden_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nazori::view {
namespace {

constexpr std::size_t kVeryMany = 50'000;
constexpr int kLineCells =
    256;  ///< on each side of the tablet: a cell is as wide as a line on a small picture
constexpr int kHeadCells = 64;  ///< and as long as an arrowhead
constexpr int kEnough = 4;

/// How often each place of the tablet is covered.
class Coverage {
 public:
  Coverage(const geometry::TabletShape& shape, int cells)
      : cells_(cells),
        per_metre_(static_cast<float>(cells / shape.width_m)),
        counts_(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), 0) {}

  /// Takes a line in. @return whether some place on it was not yet covered often enough; if not, nothing is
  /// taken in.
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
  /// In cells, held within the tablet: what lies outside counts to its rim.
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

}  // namespace

std::size_t put_hidden_last(std::vector<LinePiece>& lines, const geometry::TabletShape& shape) {
  if (lines.size() <= kVeryMany) return lines.size();
  Coverage coverage(shape, kLineCells);
  const auto hidden = std::stable_partition(lines.begin(), lines.end(), [&](const LinePiece& piece) {
    return coverage.take(piece.from_m, piece.to_m);
  });
  return static_cast<std::size_t>(hidden - lines.begin());
}

std::size_t put_hidden_last(std::vector<ArrowHead>& heads, const geometry::TabletShape& shape) {
  if (heads.size() <= kVeryMany) return heads.size();
  Coverage coverage(shape, kHeadCells);
  const auto hidden = std::stable_partition(heads.begin(), heads.end(), [&](const ArrowHead& head) {
    return coverage.take(head.tip_m, head.tip_m);
  });
  return static_cast<std::size_t>(hidden - heads.begin());
}

}  // namespace nazori::view
