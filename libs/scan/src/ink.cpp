// SPDX-License-Identifier: Apache-2.0
#include "ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "connected.h"

namespace nazori::scan {
namespace {

constexpr auto kSide = static_cast<std::size_t>(kCellSide);
constexpr float kEmptyDarkness = 0.2F;  // ink is darker than the noise of paper
constexpr double kOutline_mm = 0.55;    // next to the edge of a cell is its outline

std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x); }

/// How much darker a line of the outline is than the paper on both sides of it, of all four sides of a cell.
double outline_contrast(const Photo& photo, const PageMap& map, const print::MarkedBox& box, double dx,
                        double dy) {
  constexpr int kPoints = 16;
  constexpr double kBeside_mm = 0.6;
  constexpr double kMost = 0.5;  // ink that crosses the outline must not count more than the outline
  const auto brightness = [&](double x, double y) {
    const PhotoPoint p = map.at({box.corner.x + dx + x, box.corner.y + dy + y});
    return static_cast<double>(photo.sample(p.x, p.y));
  };
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double t = (i + 0.5) / kPoints * box.side_mm;
    for (const double edge : {0.0, box.side_mm}) {
      for (const bool upright : {false, true}) {
        const auto at = [&](double off) {
          return upright ? brightness(edge + off, t) : brightness(t, edge + off);
        };
        const double beside = std::max((at(-kBeside_mm) + at(kBeside_mm)) / 2, 1.0);
        sum += std::clamp(1 - at(0) / beside, -kMost, kMost);
      }
    }
  }
  return sum / (4 * kPoints);
}

struct Offset {
  double x = 0;
  double y = 0;
};

std::pair<double, Offset> search(const Photo& photo, const PageMap& map, const print::MarkedBox& box,
                                 Offset from, double reach, double step) {
  std::pair<double, Offset> best{-1, from};
  for (double y = -reach; y <= reach + 1e-9; y += step)
    for (double x = -reach; x <= reach + 1e-9; x += step) {
      const double c = outline_contrast(photo, map, box, from.x + x, from.y + y) - 0.004 * std::hypot(x, y);
      if (c > best.first) best = {c, {from.x + x, from.y + y}};
    }
  return best;
}

/// The brightness of the paper in squares of the cell, then between them: light is seldom even.
class Paper {
 public:
  explicit Paper(const DarkCell& brightness) {
    std::vector<float> values;
    for (int row = 0; row < kTiles; ++row)
      for (int column = 0; column < kTiles; ++column) {
        values.clear();
        for (int y = row * kTile; y < (row + 1) * kTile; ++y)
          for (int x = column * kTile; x < (column + 1) * kTile; ++x)
            values.push_back(brightness[index(x, y)]);
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 8 / 10);
        std::nth_element(values.begin(), at, values.end());
        tiles_[static_cast<std::size_t>(row * kTiles + column)] = std::max(*at, 1.0F);
      }
  }
  [[nodiscard]] float at(int x, int y) const {
    const float fx = std::clamp(static_cast<float>(x) / kTile - 0.5F, 0.0F, kTiles - 1.001F);
    const float fy = std::clamp(static_cast<float>(y) / kTile - 0.5F, 0.0F, kTiles - 1.001F);
    const int column = static_cast<int>(fx);
    const int row = static_cast<int>(fy);
    const float u = fx - static_cast<float>(column);
    const float v = fy - static_cast<float>(row);
    const auto tile = [&](int c, int r) { return tiles_[static_cast<std::size_t>(r * kTiles + c)]; };
    return (tile(column, row) * (1 - u) + tile(column + 1, row) * u) * (1 - v) +
           (tile(column, row + 1) * (1 - u) + tile(column + 1, row + 1) * u) * v;
  }

 private:
  static constexpr int kTiles = 4;
  static constexpr int kTile = kCellSide / kTiles;
  std::array<float, kTiles * kTiles> tiles_{};
};

/// Distance of a pixel to the nearest guide line, in pixels.
double to_guide(int x, int y, print::Guide guide) {
  if (guide == print::Guide::none) return kCellSide;
  const double half = (kCellSide - 1) / 2.0;
  double least = std::min(std::abs(x - half), std::abs(y - half));
  if (guide == print::Guide::diagonals)
    least = std::min({least, std::abs(x - y) / std::sqrt(2.0), std::abs(x + y - 2 * half) / std::sqrt(2.0)});
  return least;
}

/// Takes away connected spots with fewer pixels than `least`.
void remove_specks(InkCell& ink, std::size_t least) {
  InkCell open = ink;
  std::vector<Pixel> spot;
  for (int y0 = 0; y0 < kCellSide; ++y0)
    for (int x0 = 0; x0 < kCellSide; ++x0) {
      if (open[index(x0, y0)] == 0) continue;
      take_connected(open, kCellSide, kCellSide, {x0, y0}, spot);
      if (spot.size() < least)
        for (const auto& [x, y] : spot) ink[index(x, y)] = 0;
    }
}

}  // namespace

std::vector<PlacedBox> place_boxes(const Photo& photo, const FoundSheet& sheet,
                                   const std::vector<print::MarkedBox>& boxes) {
  constexpr double kFirstReach_mm = 1.6;
  constexpr double kReach_mm = 0.6;
  constexpr double kFaintest = 0.03;
  std::vector<PlacedBox> placed;
  for (const print::MarkedBox& box : boxes) {
    // The nearest of the cells before.
    const PlacedBox* near = nullptr;
    double least = 0;
    for (const PlacedBox& other : placed) {
      const double d = geometry::distance(other.box.corner, box.corner);
      if (near == nullptr || d < least) {
        near = &other;
        least = d;
      }
    }
    const Offset from = near != nullptr ? Offset{near->x_mm, near->y_mm} : Offset{};
    const bool beside = near != nullptr && least < 1.5 * box.side_mm;
    auto found = search(photo, sheet.map, box, from, beside ? kReach_mm : kFirstReach_mm, 0.2);
    if (found.first > kFaintest) found = search(photo, sheet.map, box, found.second, 0.1, 0.1);
    const Offset at = found.first > kFaintest ? found.second : from;
    placed.push_back({box, at.x, at.y});
  }
  return placed;
}

DarkCell cut_out(const Photo& photo, const PageMap& map, const PlacedBox& placed) {
  const print::MarkedBox& box = placed.box;
  DarkCell cell(kSide * kSide);
  const double unit = box.side_mm / kCellSide;
  const double left = box.corner.x + placed.x_mm;
  const double top = box.corner.y + placed.y_mm;
  for (int y = 0; y < kCellSide; ++y)
    for (int x = 0; x < kCellSide; ++x) {
      float sum = 0;
      for (const double v : {0.25, 0.75})
        for (const double u : {0.25, 0.75}) {
          const PhotoPoint p = map.at({left + (x + u) * unit, top + (y + v) * unit});
          sum += photo.sample(p.x, p.y);
        }
      cell[index(x, y)] = sum / 4;
    }
  const Paper paper(cell);
  for (int y = 0; y < kCellSide; ++y)
    for (int x = 0; x < kCellSide; ++x) {
      float& value = cell[index(x, y)];
      value = std::clamp(1 - value / paper.at(x, y), 0.0F, 1.0F);
    }
  return cell;
}

float guide_darkness(const std::vector<DarkCell>& cells, print::Guide guide) {
  if (guide == print::Guide::none || cells.empty()) return 0;
  // The darker part of the guides of each cell, then the lighter cells: a few with ink on them change
  // nothing.
  constexpr int kOff = 2;
  const auto darkness = [&](int from, int to) {
    std::vector<float> of_cells;
    std::vector<float> on_guide;
    for (const DarkCell& cell : cells) {
      on_guide.clear();
      for (int along = from; along < kCellSide - from; ++along) {
        if (std::min(along, kCellSide - 1 - along) >= to) continue;
        // Printers and viewers put thin lines on whole dots, so the darkest beside the line counts.
        const auto darkest = [&](const auto& place) {
          float most = 0;
          for (int off = -kOff; off <= kOff; ++off) most = std::max(most, cell[place(off)]);
          on_guide.push_back(most);
        };
        const auto inside = [](int v) { return std::clamp(v, 0, kCellSide - 1); };
        darkest([&](int off) { return index(kCellSide / 2 + off, along); });
        darkest([&](int off) { return index(along, kCellSide / 2 + off); });
        if (guide != print::Guide::diagonals) continue;
        darkest([&](int off) { return index(inside(along + off), along); });
        darkest([&](int off) { return index(inside(kCellSide - 1 - along + off), along); });
      }
      const auto at = on_guide.begin() + static_cast<std::ptrdiff_t>(on_guide.size() * 3 / 4);
      std::nth_element(on_guide.begin(), at, on_guide.end());
      of_cells.push_back(*at);
    }
    const auto middle = of_cells.begin() + static_cast<std::ptrdiff_t>(of_cells.size() / 4);
    std::nth_element(of_cells.begin(), middle, of_cells.end());
    return *middle;
  };
  // Where every cell has strokes on its guides (十, 田), their ends near the edge are still without ink. They
  // are short, and dashes make them uncertain, so they only limit what the whole lines say.
  constexpr float kMostOfEnds = 1.6F;
  return std::min(darkness(kCellSide / 16, kCellSide),
                  kMostOfEnds * darkness(kCellSide / 24, kCellSide / 10));
}

InkCell ink_of(const DarkCell& cell, const print::MarkedBox& box, print::Guide guide, float guide_darkness) {
  constexpr float kOfDarkest = 0.45F;
  constexpr double kBesideGuide_mm = 0.4;
  constexpr double kSpeck_mm2 = 0.2;
  const double pixel_mm = box.side_mm / kCellSide;
  const int rim = static_cast<int>(std::ceil(kOutline_mm / pixel_mm));
  const double beside = kBesideGuide_mm / pixel_mm;
  const float over_guide = guide_darkness * 1.5F + 0.06F;
  InkCell ink(kSide * kSide);
  const auto each = [&](const auto& work) {
    for (int y = rim; y < kCellSide - rim; ++y)
      for (int x = rim; x < kCellSide - rim; ++x) work(x, y, to_guide(x, y, guide) < beside);
  };
  std::vector<float> dark;
  each([&](int x, int y, bool on_guide) {
    const float d = cell[index(x, y)];
    if (d > (on_guide ? std::max(kEmptyDarkness, over_guide) : kEmptyDarkness)) dark.push_back(d);
  });
  if (dark.empty()) return ink;
  // How dark the pen is: the darker half of its ink.
  const auto at = dark.begin() + static_cast<std::ptrdiff_t>(dark.size() * 7 / 10);
  std::nth_element(dark.begin(), at, dark.end());
  const float limit = std::max(kEmptyDarkness, *at * kOfDarkest);
  each([&](int x, int y, bool on_guide) {
    if (cell[index(x, y)] > (on_guide ? std::max(limit, over_guide) : limit)) ink[index(x, y)] = 1;
  });
  remove_specks(ink, static_cast<std::size_t>(std::max(6.0, kSpeck_mm2 / (pixel_mm * pixel_mm))));
  return ink;
}

}  // namespace nazori::scan
