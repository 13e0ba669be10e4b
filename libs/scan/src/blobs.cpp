// SPDX-License-Identifier: Apache-2.0
#include "blobs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "connected.h"
#include "reduced.h"

namespace nazori::scan {
namespace {

constexpr int kLongSide = 1800;       // pixels of the picture in which discs are looked for
constexpr double kWindow = 1.0 / 12;  // of its long side: the neighbourhood that decides what is dark
constexpr float kDark = 0.78F;        // of the mean brightness around
constexpr std::size_t kMostBlobs = 28;

/// Which pixels are darker than what is around them.
/// @source D. Bradley, G. Roth, "Adaptive thresholding using the integral image", 2007.
std::vector<std::uint8_t> dark_pixels(const Photo& photo) {
  const auto w = static_cast<std::size_t>(photo.width);
  const auto h = static_cast<std::size_t>(photo.height);
  std::vector<std::uint64_t> sums((w + 1) * (h + 1));
  for (std::size_t y = 0; y < h; ++y) {
    std::uint64_t row = 0;
    for (std::size_t x = 0; x < w; ++x) {
      row += photo.grey[y * w + x];
      sums[(y + 1) * (w + 1) + x + 1] = sums[y * (w + 1) + x + 1] + row;
    }
  }
  const auto half = static_cast<std::size_t>(kWindow * static_cast<double>(std::max(w, h)) / 2) + 1;
  std::vector<std::uint8_t> dark(w * h);
  for (std::size_t y = 0; y < h; ++y) {
    const std::size_t top = y > half ? y - half : 0;
    const std::size_t bottom = std::min(h, y + half + 1);
    for (std::size_t x = 0; x < w; ++x) {
      const std::size_t left = x > half ? x - half : 0;
      const std::size_t right = std::min(w, x + half + 1);
      const std::uint64_t sum = sums[bottom * (w + 1) + right] + sums[top * (w + 1) + left] -
                                sums[top * (w + 1) + right] - sums[bottom * (w + 1) + left];
      const float mean = static_cast<float>(sum) / static_cast<float>((bottom - top) * (right - left));
      dark[y * w + x] = static_cast<float>(photo.grey[y * w + x]) < kDark * mean ? 1 : 0;
    }
  }
  return dark;
}

/// Sums over the pixels of a spot.
struct Spot {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  bool at_edge = false;

  void add(int px, int py) {
    const double fx = px;
    const double fy = py;
    n += 1;
    x += fx;
    y += fy;
    xx += fx * fx;
    xy += fx * fy;
    yy += fy * fy;
  }
};

/// Takes the connected dark pixels around one; they are no longer dark.
Spot take_spot(std::vector<std::uint8_t>& dark, int width, int height, int x0, int y0,
               std::vector<Pixel>& pixels) {
  Spot spot;
  take_connected(dark, width, height, {x0, y0}, pixels);
  for (const auto [x, y] : pixels) {
    spot.add(x, y);
    if (x == 0 || y == 0 || x == width - 1 || y == height - 1) spot.at_edge = true;
  }
  return spot;
}

/// Whether the spot is a filled ellipse: its area is then 4 pi times the root of the determinant of its
/// covariance.
bool is_disc(const Spot& spot, double most_pixels, Blob& blob) {
  constexpr double kFewest = 20;  // pixels
  constexpr double kUnlike = 0.13;
  constexpr double kSlimmest = 2.4;
  if (spot.at_edge || spot.n < kFewest || spot.n > most_pixels) return false;
  const double x = spot.x / spot.n;
  const double y = spot.y / spot.n;
  const double xx = spot.xx / spot.n - x * x + 1.0 / 12;
  const double xy = spot.xy / spot.n - x * y;
  const double yy = spot.yy / spot.n - y * y + 1.0 / 12;
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 0) return false;
  const double unlike = std::abs(spot.n / (4 * std::numbers::pi * std::sqrt(determinant)) - 1);
  const double mean = (xx + yy) / 2;
  const double apart = std::sqrt(std::max(0.0, mean * mean - determinant));
  if (unlike > kUnlike || mean + apart > kSlimmest * kSlimmest * (mean - apart)) return false;
  blob = {{x, y}, std::sqrt(spot.n / std::numbers::pi), unlike};
  return true;
}

/// The centre of what is dark around a blob, from the brightness of the whole picture.
void refine(const Photo& photo, Blob& blob) {
  const double reach = blob.radius * 1.45 + 1;
  const int left = std::max(0, static_cast<int>(std::floor(blob.centre.x - reach)));
  const int right = std::min(photo.width - 1, static_cast<int>(std::ceil(blob.centre.x + reach)));
  const int top = std::max(0, static_cast<int>(std::floor(blob.centre.y - reach)));
  const int bottom = std::min(photo.height - 1, static_cast<int>(std::ceil(blob.centre.y + reach)));
  double bright = 0;
  double dark = 255;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      bright = std::max(bright, static_cast<double>(photo.at(x, y)));
      dark = std::min(dark, static_cast<double>(photo.at(x, y)));
    }
  const double limit = dark + 0.6 * (bright - dark);
  double sum = 0;
  double sum_x = 0;
  double sum_y = 0;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      if (std::hypot(x - blob.centre.x, y - blob.centre.y) > reach) continue;
      const double weight = std::max(0.0, limit - photo.at(x, y));
      sum += weight;
      sum_x += weight * x;
      sum_y += weight * y;
    }
  if (sum > 0) blob.centre = {sum_x / sum, sum_y / sum};
}

}  // namespace

std::vector<Blob> find_discs(const Photo& photo) {
  const int factor = std::max(1, (std::max(photo.width, photo.height) + kLongSide - 1) / kLongSide);
  const Photo small = reduced(photo, factor);
  std::vector<std::uint8_t> dark = dark_pixels(small);
  // A disc is a fiftieth of the narrowest page.
  const double side = std::min(small.width, small.height);
  const double most_pixels = std::numbers::pi / 4 * side * side / (20 * 20);
  std::vector<Blob> blobs;
  std::vector<Pixel> pixels;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      if (dark[static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) +
               static_cast<std::size_t>(x)] == 0)
        continue;
      Blob blob;
      if (is_disc(take_spot(dark, small.width, small.height, x, y, pixels), most_pixels, blob))
        blobs.push_back(blob);
    }
  // A letter or a dot of ink is smaller than the discs.
  std::sort(blobs.begin(), blobs.end(), [](const Blob& a, const Blob& b) {
    return a.radius * (1 - 2 * a.unlike) > b.radius * (1 - 2 * b.unlike);
  });
  if (blobs.size() > kMostBlobs) blobs.resize(kMostBlobs);
  const double shift = (factor - 1) / 2.0;
  for (Blob& blob : blobs) {
    blob.centre = {blob.centre.x * factor + shift, blob.centre.y * factor + shift};
    blob.radius *= factor;
    refine(photo, blob);
  }
  return blobs;
}

}  // namespace nazori::scan
