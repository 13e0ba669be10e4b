// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/paper_alone.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "connected.h"
#include "convex_outline.h"
#include "nazori/scan/sheet.h"
#include "reduced.h"

namespace nazori::scan {
namespace {

constexpr int kLongSide = 480;          // pixels of the picture in which the sheet is looked for
constexpr float kStep = 0.06F;          // an edge: the change of the logarithm of brightness over two pixels
constexpr double kSmallestSheet = 0.1;  // of the picture
constexpr double kWholePicture = 0.97;
constexpr double kConvex = 0.93;       // of its convex outline that a sheet fills
constexpr double kStraight = 0.95;     // of its convex outline that the quadrilateral of a sheet fills
constexpr double kAsBright = 0.93;     // of the paper: brighter surroundings may be paper as well
constexpr double kMostAsBright = 0.1;  // of the surroundings
constexpr double kInk = 0.65;          // of the paper: darker is writing
constexpr double kLeastInk = 0.0008;   // of the sheet
constexpr double kAtBorder = 2.5;      // pixels: a corner so near to the border may lie beyond it

/// The logarithm of brightness, so that the same edge is the same step in light and in shade.
struct LogPicture {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] float at(int x, int y) const {
    return values[index(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1))];
  }
};

LogPicture log_picture(const Photo& photo) {
  LogPicture out{photo.width, photo.height, {}};
  out.values.reserve(photo.grey.size());
  const auto grey = [&](int x, int y) {
    return static_cast<int>(photo.at(std::clamp(x, 0, photo.width - 1), std::clamp(y, 0, photo.height - 1)));
  };
  for (int y = 0; y < photo.height; ++y)
    for (int x = 0; x < photo.width; ++x) {
      int sum = 0;
      for (int v = -1; v <= 1; ++v)
        for (int u = -1; u <= 1; ++u) sum += grey(x + u, y + v);
      out.values.push_back(std::log(static_cast<float>(sum) / 9 + 4));
    }
  return out;
}

/// Which pixels lie between edges.
std::vector<std::uint8_t> level_pixels(const LogPicture& picture) {
  std::vector<std::uint8_t> level;
  level.reserve(picture.values.size());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float across = picture.at(x + 1, y) - picture.at(x - 1, y);
      const float down = picture.at(x, y + 1) - picture.at(x, y - 1);
      level.push_back(across * across + down * down < kStep * kStep ? 1 : 0);
    }
  return level;
}

/// Pixels and what they enclose.
std::vector<std::uint8_t> filled(const std::vector<Pixel>& pixels, int width, int height) {
  std::vector<std::uint8_t> around(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1);
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  for (const auto [x, y] : pixels) around[index(x, y)] = 0;
  std::vector<std::uint8_t> inside(around.size(), 1);
  std::vector<Pixel> outside;
  const auto take = [&](int x, int y) {
    if (around[index(x, y)] == 0) return;
    take_connected(around, width, height, {x, y}, outside);
    for (const auto [u, v] : outside) inside[index(u, v)] = 0;
  };
  for (int x = 0; x < width; ++x) {
    take(x, 0);
    take(x, height - 1);
  }
  for (int y = 0; y < height; ++y) {
    take(0, y);
    take(width - 1, y);
  }
  return inside;
}

/// Even light on paper: the logarithm of its brightness as a plane over the picture.
class Light {
 public:
  Light(const LogPicture& picture, const std::vector<Pixel>& paper) {
    Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto [x, y] : paper) {
      const Eigen::Vector3d place(1, x, y);
      left += place * place.transpose();
      right += place * static_cast<double>(picture.at(x, y));
    }
    plane_ = left.ldlt().solve(right);
  }
  /// How much brighter a pixel is than paper would be there, as a factor.
  [[nodiscard]] double over(const LogPicture& picture, int x, int y) const {
    return std::exp(static_cast<double>(picture.at(x, y)) - plane_.dot(Eigen::Vector3d(1, x, y)));
  }

 private:
  Eigen::Vector3d plane_;
};

/// Whether there is writing on a piece of paper, and something darker around it.
bool is_sheet(const LogPicture& picture, const std::vector<Pixel>& paper,
              const std::vector<std::uint8_t>& inside) {
  const Light light(picture, paper);
  double ink = 0;
  double area = 0;
  double around = 0;
  double bright = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double over = light.over(picture, x, y);
      if (inside[picture.index(x, y)] != 0) {
        ++area;
        if (over < kInk) ++ink;
      } else {
        ++around;
        if (over > kAsBright) ++bright;
      }
    }
  return ink > kLeastInk * area && bright < kMostAsBright * around;
}

/// The outline of the largest sheet.
std::optional<ConvexOutline> find_outline(const Photo& photo) {
  const LogPicture picture = log_picture(photo);
  std::vector<std::uint8_t> level = level_pixels(picture);
  const auto all = static_cast<double>(picture.values.size());
  std::optional<ConvexOutline> best;
  std::vector<Pixel> pixels;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (level[picture.index(x, y)] == 0) continue;
      take_connected(level, picture.width, picture.height, {x, y}, pixels);
      if (static_cast<double>(pixels.size()) < kSmallestSheet * all / 2) continue;
      const std::vector<std::uint8_t> inside = filled(pixels, picture.width, picture.height);
      const auto area = static_cast<double>(std::count(inside.begin(), inside.end(), 1));
      if (area < kSmallestSheet * all || area > kWholePicture * all) continue;
      ConvexOutline outline = outline_of(pixels);
      const double wanted = area_of(outline);
      if (area < kConvex * wanted || (best && area_of(*best) > wanted)) continue;
      if (is_sheet(picture, pixels, inside)) best = std::move(outline);
    }
  return best;
}

/// Width over height of a rectangle, from its corners in a photograph that shows the middle of its picture.
/// @param corners  around from the upper left one.
/// @source Z. Zhang, L. He, "Whiteboard scanning and image enhancement", 2007.
double aspect_of(const std::array<PhotoPoint, 4>& corners, const Photo& photo) {
  // Of cameras in phones; where the sheet is seen from nearly straight above, its corners do not say it.
  constexpr double kUsual = 0.9;
  const double side = std::max(photo.width, photo.height);
  const auto ray = [&](PhotoPoint p) {
    return Eigen::Vector3d((p.x - photo.width / 2.0) / side, (p.y - photo.height / 2.0) / side, 1);
  };
  const Eigen::Vector3d a = ray(corners[0]), b = ray(corners[1]), c = ray(corners[3]), d = ray(corners[2]);
  const double kb = a.cross(d).dot(c) / b.cross(d).dot(c);
  const double kc = a.cross(d).dot(b) / c.cross(d).dot(b);
  const Eigen::Vector3d across = kb * b - a;
  const Eigen::Vector3d down = kc * c - a;
  double focus = -(across.x() * down.x() + across.y() * down.y()) / (across.z() * down.z());
  if (!(focus > 0.5 * 0.5 && focus < 2.5 * 2.5)) focus = kUsual * kUsual;
  const auto length = [&](const Eigen::Vector3d& v) {
    return std::sqrt((v.x() * v.x() + v.y() * v.y()) / focus + v.z() * v.z());
  };
  return length(across) / length(down);
}

/// The sheet with these corners, seen from above.
Photo flattened(const Photo& photo, const std::array<PhotoPoint, 4>& corners) {
  constexpr double kMost = 1'400;  // pixels a side
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::hypot(corners[i].x - corners[j].x, corners[i].y - corners[j].y);
  };
  const double aspect = aspect_of(corners, photo);
  double height = std::max(distance(0, 3), distance(1, 2));
  height = std::max(height, std::max(distance(0, 1), distance(3, 2)) / aspect);
  height = std::min({height, kMost, kMost / aspect});
  Photo out;
  out.width = std::max(kFewestPixels, static_cast<int>(std::lround(height * aspect)));
  out.height = std::max(kFewestPixels, static_cast<int>(std::lround(height)));
  const double right = out.width - 1;
  const double bottom = out.height - 1;
  const PageMap map = PageMap::through({{{0, 0}, {right, 0}, {right, bottom}, {0, bottom}}}, corners);
  out.grey.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const PhotoPoint from = map.at({static_cast<double>(x), static_cast<double>(y)});
      out.grey.push_back(static_cast<std::uint8_t>(std::lround(photo.sample(from.x, from.y))));
    }
  return out;
}

/// The part of a photograph inside an outline; the rest of its rows has the brightness of the paper beside
/// it.
Photo cut_out(const Photo& photo, const ConvexOutline& outline) {
  constexpr int kBeside = 9;  // pixels whose mean is the paper
  const auto rows = rows_inside(outline, photo.width, photo.height);
  Photo out;
  out.width = photo.width;
  for (const RowInside& row : rows) {
    if (row.last - row.first < kBeside) continue;
    ++out.height;
    const auto paper = [&](int from) {
      int sum = 0;
      for (int x = from; x < from + kBeside; ++x) sum += photo.at(x, row.row);
      return static_cast<std::uint8_t>(sum / kBeside);
    };
    const std::uint8_t left = paper(row.first);
    const std::uint8_t right = paper(row.last - kBeside + 1);
    for (int x = 0; x < photo.width; ++x)
      out.grey.push_back(x < row.first ? left : x > row.last ? right : photo.at(x, row.row));
  }
  return out;
}

}  // namespace

Photo paper_alone(Photo photo) {
  const int factor = std::max(1, (std::max(photo.width, photo.height) + kLongSide - 1) / kLongSide);
  const Photo small = reduced(photo, factor);
  if (std::min(small.width, small.height) < 16) return photo;
  auto outline = find_outline(small);
  if (!outline) return photo;
  const auto to_photo = [factor](PhotoPoint p) -> PhotoPoint {
    return {(p.x + 0.5) * factor - 0.5, (p.y + 0.5) * factor - 0.5};
  };
  const auto is_inside = [&](PhotoPoint p) {
    return p.x > kAtBorder && p.y > kAtBorder && p.x < small.width - 1 - kAtBorder &&
           p.y < small.height - 1 - kAtBorder;
  };
  if (auto corners = quadrilateral_in(*outline, kStraight);
      corners && std::all_of(corners->begin(), corners->end(), is_inside)) {
    for (PhotoPoint& corner : *corners) corner = to_photo(corner);
    return flattened(photo, *corners);
  }
  for (PhotoPoint& corner : *outline) corner = to_photo(corner);
  Photo cut = cut_out(photo, *outline);
  return cut.height >= kFewestPixels ? cut : photo;
}

}  // namespace nazori::scan
