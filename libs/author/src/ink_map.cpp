// SPDX-License-Identifier: Apache-2.0
#include "ink_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace nazori::author {
namespace {

using base::Errc;
using geometry::GridPoint;

/// More ink than this is not writing.
constexpr double kMostInk = 0.75;

base::Error no_ink(const char* what) {
  return {Errc::bad_argument, what, {}, "give a picture of dark writing on light paper"};
}

/// Finishes a map whose `level` and `depth` are known.
base::Result<InkMap> finished(InkMap map, double least_area, const base::Error& empty,
                              const base::Error& full) {
  map.ink.resize(map.level.size());
  for (std::size_t i = 0; i < map.level.size(); ++i) map.ink[i] = map.level[i] > 1 ? 1 : 0;

  // Specks are no strokes, and pin holes would become rings.
  const auto least = static_cast<std::size_t>(least_area * kInkPerUnit * kInkPerUnit);
  std::vector<std::uint8_t> seen(map.ink.size());
  std::vector<std::size_t> part;
  for (std::size_t start = 0; start < map.ink.size(); ++start) {
    if (seen[start] != 0) continue;
    const std::uint8_t value = map.ink[start];
    part.assign(1, start);
    seen[start] = 1;
    for (std::size_t n = 0; n < part.size(); ++n) {
      const int x = static_cast<int>(part[n] % kInkSide);
      const int y = static_cast<int>(part[n] / kInkSide);
      for (int v = std::max(0, y - 1); v <= std::min(kInkSide - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(kInkSide - 1, x + 1); ++u) {
          // Ink is connected over corners, paper is not.
          if (value == 0 && u != x && v != y) continue;
          const std::size_t i = static_cast<std::size_t>(v) * kInkSide + static_cast<std::size_t>(u);
          if (seen[i] != 0 || map.ink[i] != value) continue;
          seen[i] = 1;
          part.push_back(i);
        }
    }
    if (part.size() >= least) continue;
    for (const std::size_t i : part) {
      map.ink[i] = value == 0 ? 1 : 0;
      map.level[i] = value == 0 ? std::max(map.level[i], 1.001F) : 0.0F;
    }
  }
  const auto count = static_cast<double>(std::count(map.ink.begin(), map.ink.end(), 1));
  if (count == 0) return tl::unexpected(empty);
  if (count > kMostInk * static_cast<double>(map.ink.size())) return tl::unexpected(full);
  map.distance = distance_map(map.ink, kInkSide);
  return map;
}

/// A picture with fewer pixels, each the mean of `step` x `step`.
struct Grey {
  int width = 0;
  int height = 0;
  std::vector<float> values;
  [[nodiscard]] float at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Grey smaller(const scan::Photo& photo, int step) {
  Grey out{photo.width / step, photo.height / step, {}};
  out.values.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      int sum = 0;
      for (int v = 0; v < step; ++v)
        for (int u = 0; u < step; ++u) sum += photo.at(x * step + u, y * step + v);
      out.values.push_back(static_cast<float>(sum) / static_cast<float>(step * step));
    }
  return out;
}

/// The brightness of the paper at each pixel: in tiles the brighter part, where a tile is all ink that of its
/// neighbours, then between the middles of tiles.
std::vector<float> paper_of(const Grey& grey) {
  constexpr int kTiles = 10;
  constexpr double kBrighter = 0.9;
  const auto edge = [](int tile, int side) { return tile * side / kTiles; };
  const auto index = [](int column, int row) {
    return static_cast<std::size_t>(row) * kTiles + static_cast<std::size_t>(column);
  };
  std::vector<float> tiles;
  std::vector<float> values;
  for (int row = 0; row < kTiles; ++row)
    for (int column = 0; column < kTiles; ++column) {
      values.clear();
      for (int y = edge(row, grey.height); y < edge(row + 1, grey.height); ++y)
        for (int x = edge(column, grey.width); x < edge(column + 1, grey.width); ++x)
          values.push_back(grey.at(x, y));
      const auto at =
          values.begin() + static_cast<std::ptrdiff_t>(kBrighter * static_cast<double>(values.size()));
      std::nth_element(values.begin(), at, values.end());
      tiles.push_back(std::max(*at, 1.0F));
    }
  const std::vector<float> plain = tiles;
  for (int row = 0; row < kTiles; ++row)
    for (int column = 0; column < kTiles; ++column) {
      float most = 0;
      for (int v = std::max(0, row - 1); v <= std::min(kTiles - 1, row + 1); ++v)
        for (int u = std::max(0, column - 1); u <= std::min(kTiles - 1, column + 1); ++u)
          most = std::max(most, plain[index(u, v)]);
      // Light falls off slowly: a tile much darker than its neighbours is ink.
      constexpr float kFallsOff = 0.75F;
      float& tile = tiles[index(column, row)];
      if (tile < kFallsOff * most) tile = most;
    }
  std::vector<float> paper;
  paper.reserve(grey.values.size());
  for (int y = 0; y < grey.height; ++y)
    for (int x = 0; x < grey.width; ++x) {
      const auto place = [](int p, int side) {
        return std::clamp((static_cast<float>(p) + 0.5F) * kTiles / static_cast<float>(side) - 0.5F, 0.0F,
                          kTiles - 1.001F);
      };
      const float fx = place(x, grey.width);
      const float fy = place(y, grey.height);
      const int column = static_cast<int>(fx);
      const int row = static_cast<int>(fy);
      const float u = fx - static_cast<float>(column);
      const float v = fy - static_cast<float>(row);
      const auto tile = [&](int c, int r) { return tiles[index(c, r)]; };
      paper.push_back((tile(column, row) * (1 - u) + tile(column + 1, row) * u) * (1 - v) +
                      (tile(column, row + 1) * (1 - u) + tile(column + 1, row + 1) * u) * v);
    }
  return paper;
}

/// The darkness that divides ink from paper best: the two groups differ most in their means.
/// @source N. Otsu, "A threshold selection method from gray-level histograms", 1979.
double dividing(const std::vector<float>& darkness) {
  constexpr int kBins = 256;
  std::vector<double> bins(kBins);
  for (const float d : darkness)
    bins[static_cast<std::size_t>(std::clamp(static_cast<int>(d * kBins), 0, kBins - 1))] += 1;
  double all = 0;
  for (int i = 0; i < kBins; ++i) all += i * bins[static_cast<std::size_t>(i)];
  const auto total = static_cast<double>(darkness.size());
  double below = 0;
  double sum = 0;
  double best = -1;
  int first = 0;
  int last = 0;
  for (int i = 0; i + 1 < kBins; ++i) {
    below += bins[static_cast<std::size_t>(i)];
    sum += i * bins[static_cast<std::size_t>(i)];
    if (below == 0 || below == total) continue;
    const double apart = sum / below - (all - sum) / (total - below);
    const double between = below * (total - below) * apart * apart;
    if (between > best * (1 + 1e-12)) {
      best = between;
      first = i;
    }
    if (between >= best * (1 - 1e-12)) last = i;
  }
  return (0.5 * (first + last) + 1) / kBins;
}

struct PixelBox {
  int left = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::max();
  int right = -1;
  int bottom = -1;
};

}  // namespace

float between(const std::vector<float>& values, GridPoint at) {
  const double most = kInkSide - 1.000001;
  const double x = std::clamp(at.x, 0.0, most);
  const double y = std::clamp(at.y, 0.0, most);
  const auto column = static_cast<std::size_t>(x);
  const auto row = static_cast<std::size_t>(y);
  const auto u = static_cast<float>(x - static_cast<double>(column));
  const auto v = static_cast<float>(y - static_cast<double>(row));
  const float* p = &values[row * kInkSide + column];
  return (p[0] * (1 - u) + p[1] * u) * (1 - v) + (p[kInkSide] * (1 - u) + p[kInkSide + 1] * u) * v;
}

void blur(std::vector<float>& values, int width, int height, double sigma) {
  const int reach = static_cast<int>(std::ceil(2.5 * sigma));
  if (reach < 1) return;
  std::vector<float> weights;
  float sum = 0;
  for (int k = -reach; k <= reach; ++k) {
    weights.push_back(static_cast<float>(std::exp(-k * k / (2 * sigma * sigma))));
    sum += weights.back();
  }
  for (float& w : weights) w /= sum;
  const auto pass = [&](int lines, int length, std::size_t line_step, std::size_t step) {
    std::vector<float> row(static_cast<std::size_t>(length));
    for (int l = 0; l < lines; ++l) {
      float* p = &values[static_cast<std::size_t>(l) * line_step];
      for (int i = 0; i < length; ++i) {
        float total = 0;
        int from = i - reach;
        for (const float weight : weights)
          total += weight * p[static_cast<std::size_t>(std::clamp(from++, 0, length - 1)) * step];
        row[static_cast<std::size_t>(i)] = total;
      }
      for (int i = 0; i < length; ++i)
        p[static_cast<std::size_t>(i) * step] = row[static_cast<std::size_t>(i)];
    }
  };
  const auto line = static_cast<std::size_t>(width);
  pass(height, width, line, 1);
  pass(width, height, 1, line);
}

base::Result<InkMap> ink_of(const surface::HeightMap& map) {
  if (!map.is_loaded()) return base::fail(Errc::bad_argument, "no height map is loaded");
  // Two steps of an 8-bit map are noise; so is what is much shallower than the groove.
  constexpr float kShallowest = 0.0085F;
  constexpr double kLeastArea = 1.0;  // glyph units squared
  InkMap out;
  out.is_groove = true;
  const auto count = static_cast<std::size_t>(kInkSide) * kInkSide;
  out.depth.reserve(count);
  const double scale = static_cast<double>(map.size() - 1) / (kInkSide - 1);
  const int sub = std::max(1, static_cast<int>(std::lround(scale)));
  const double most = map.size() - 1;
  const auto sample = [&](double x, double y) {
    x = std::clamp(x, 0.0, most);
    y = std::clamp(y, 0.0, most);
    const int column = std::min(static_cast<int>(x), map.size() - 2);
    const int row = std::min(static_cast<int>(y), map.size() - 2);
    const auto u = static_cast<float>(x - column);
    const auto v = static_cast<float>(y - row);
    return (map.at(column, row) * (1 - u) + map.at(column + 1, row) * u) * (1 - v) +
           (map.at(column, row + 1) * (1 - u) + map.at(column + 1, row + 1) * u) * v;
  };
  for (int y = 0; y < kInkSide; ++y)
    for (int x = 0; x < kInkSide; ++x) {
      float sum = 0;
      for (int v = 0; v < sub; ++v)
        for (int u = 0; u < sub; ++u) {
          const double du = (u + 0.5) / sub - 0.5;
          const double dv = (v + 0.5) / sub - 0.5;
          sum += sample((x + du) * scale, (y + dv) * scale);
        }
      out.depth.push_back(1 - sum / static_cast<float>(sub * sub));
    }
  out.level = out.depth;
  for (float& value : out.level) value /= kShallowest;
  return finished(
      std::move(out), kLeastArea,
      {Errc::bad_argument, "the height map has no groove", {}, "give a map with heights below the plateau"},
      {Errc::bad_argument, "nearly the whole height map is groove", {}, "1 or white is the plateau"});
}

base::Result<InkMap> ink_of(const scan::Photo& photo) {
  constexpr int kMostSide = 1400;
  constexpr float kFaintest = 0.12F;     // noise and texture of paper are lighter
  constexpr double kDarkPaper = 24;      // brightness
  constexpr double kLeastArea = 0.0004;  // of a speck, in parts of the box of the ink
  const base::Error full = no_ink("there is nothing but ink in the picture");
  const base::Error empty = no_ink("there is no ink in the picture");
  const int shrunk = std::max(1, (std::max(photo.width, photo.height) + kMostSide - 1) / kMostSide);
  const Grey grey = smaller(photo, shrunk);
  if (std::min(grey.width, grey.height) < 10)
    return base::fail(Errc::bad_argument, "the picture is too narrow", {}, "give at least 10 pixels a side");
  const std::vector<float> paper = paper_of(grey);
  const float brightest = *std::max_element(paper.begin(), paper.end());
  if (brightest < kDarkPaper) return tl::unexpected(full);
  std::vector<float> darkness = grey.values;
  for (std::size_t i = 0; i < darkness.size(); ++i)
    darkness[i] = std::clamp(1 - darkness[i] / paper[i], 0.0F, 1.0F);
  blur(darkness, grey.width, grey.height, std::min(1.0, std::max(grey.width, grey.height) / 500.0));
  const auto limit = static_cast<float>(dividing(darkness));
  // The ink is the darker group; where both groups are about the same, there is only paper.
  double ink_sum = 0;
  double ink_count = 0;
  for (const float d : darkness)
    if (d > limit) {
      ink_sum += static_cast<double>(d);
      ++ink_count;
    }
  if (ink_count == 0 || ink_sum / ink_count < static_cast<double>(2 * kFaintest) || limit < kFaintest / 2)
    return tl::unexpected(empty);
  if (ink_count > kMostInk * static_cast<double>(darkness.size())) return tl::unexpected(full);

  // The box of the ink, without specks.
  std::vector<std::uint8_t> open(darkness.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = darkness[i] > limit ? 1 : 0;
  PixelBox box;
  std::vector<std::size_t> part;
  const auto width = static_cast<std::size_t>(grey.width);
  for (std::size_t start = 0; start < open.size(); ++start) {
    if (open[start] == 0) continue;
    part.assign(1, start);
    open[start] = 0;
    PixelBox own;
    for (std::size_t n = 0; n < part.size(); ++n) {
      const int x = static_cast<int>(part[n] % width);
      const int y = static_cast<int>(part[n] / width);
      own = {std::min(own.left, x), std::min(own.top, y), std::max(own.right, x), std::max(own.bottom, y)};
      for (int v = std::max(0, y - 1); v <= std::min(grey.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(grey.width - 1, x + 1); ++u) {
          const std::size_t i = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
          if (open[i] == 0) continue;
          open[i] = 0;
          part.push_back(i);
        }
    }
    if (static_cast<double>(part.size()) < std::max(6.0, 0.01 * ink_count) &&
        static_cast<double>(part.size()) < 0.0006 * static_cast<double>(darkness.size()))
      continue;
    box = {std::min(box.left, own.left), std::min(box.top, own.top), std::max(box.right, own.right),
           std::max(box.bottom, own.bottom)};
  }
  if (box.right < 0) return tl::unexpected(empty);

  InkMap out;
  const double larger = std::max({box.right - box.left + 1, box.bottom - box.top + 1, 8});
  const double pixels_per_unit = larger / (geometry::kGlyphSide - 2 * kInkMargin);
  const double middle_x = (box.left + box.right) / 2.0;
  const double middle_y = (box.top + box.bottom) / 2.0;
  const double step = pixels_per_unit / kInkPerUnit;
  const int sub = std::max(1, static_cast<int>(std::lround(step)));
  const auto sample = [&](double x, double y) -> float {
    if (x < 0 || y < 0 || x > grey.width - 1 || y > grey.height - 1) return 0;
    const int column = std::min(static_cast<int>(x), grey.width - 2);
    const int row = std::min(static_cast<int>(y), grey.height - 2);
    const auto u = static_cast<float>(x - column);
    const auto v = static_cast<float>(y - row);
    const auto at = [&](int c, int r) {
      return darkness[static_cast<std::size_t>(r) * width + static_cast<std::size_t>(c)];
    };
    return (at(column, row) * (1 - u) + at(column + 1, row) * u) * (1 - v) +
           (at(column, row + 1) * (1 - u) + at(column + 1, row + 1) * u) * v;
  };
  const double half = (kInkSide - 1) / 2.0;
  for (int y = 0; y < kInkSide; ++y)
    for (int x = 0; x < kInkSide; ++x) {
      float sum = 0;
      for (int v = 0; v < sub; ++v)
        for (int u = 0; u < sub; ++u)
          sum += sample(middle_x + (x - half + (u + 0.5) / sub - 0.5) * step,
                        middle_y + (y - half + (v + 0.5) / sub - 0.5) * step);
      out.level.push_back(sum / static_cast<float>(sub * sub) / limit);
    }
  // Where a small picture was made larger, the stairs of its pixels go.
  if (step < 1) blur(out.level, kInkSide, kInkSide, 0.5 / step);
  out.depth.assign(out.level.size(), 1.0F);
  const double side = geometry::kGlyphSide;
  const auto to_photo = [shrunk](double pixel) { return (pixel + 0.5) * shrunk - 0.5; };
  out.place = {to_photo(middle_x - side / 2 * pixels_per_unit),
               to_photo(middle_y - side / 2 * pixels_per_unit), pixels_per_unit * shrunk};
  return finished(std::move(out), kLeastArea * side * side, empty, full);
}

}  // namespace nazori::author
