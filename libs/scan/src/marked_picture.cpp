// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/marked_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nazori::scan {
namespace {

using Colour = std::array<std::uint8_t, 3>;

Colour colour_of(const CellReading& cell) {
  switch (cell.state) {
    case CellState::empty:
      return {150, 150, 150};
    case CellState::traced:
      return {70, 110, 230};
    case CellState::illegible:
      return {220, 30, 30};
    case CellState::legible:
      break;
  }
  return cell.remarks.empty() ? Colour{20, 150, 60} : Colour{240, 140, 0};
}

void draw_line(surface::ColourPicture& picture, PhotoPoint from, PhotoPoint to, double width,
               const Colour& colour) {
  const double length = geometry::distance(from, to);
  const int steps = static_cast<int>(std::min(length * 2, 1e5)) + 1;
  const int reach = static_cast<int>(width / 2);
  for (int i = 0; i <= steps; ++i) {
    const PhotoPoint p = from + (to - from) * (static_cast<double>(i) / steps);
    const int x0 = static_cast<int>(std::lround(std::clamp(p.x, -1e6, 1e6)));
    const int y0 = static_cast<int>(std::lround(std::clamp(p.y, -1e6, 1e6)));
    for (int y = std::max(0, y0 - reach); y <= std::min(picture.height - 1, y0 + reach); ++y)
      for (int x = std::max(0, x0 - reach); x <= std::min(picture.width - 1, x0 + reach); ++x)
        std::copy(colour.begin(), colour.end(),
                  picture.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width + x));
  }
}

}  // namespace

surface::ColourPicture marked_picture(const Photo& photo, std::span<const SheetReading> sheets) {
  surface::ColourPicture picture{photo.width, photo.height, {}};
  picture.rgb.reserve(photo.grey.size() * 3);
  for (const std::uint8_t value : photo.grey) picture.rgb.insert(picture.rgb.end(), 3, value);
  for (const SheetReading& sheet : sheets)
    for (const CellReading& cell : sheet.cells) {
      const auto& c = cell.corners;
      const double width = std::max(2.0, geometry::distance(c[0], c[1]) / 30);
      // Next to the printed outline, so that cells side by side keep their colours.
      std::array<PhotoPoint, 4> inside;
      for (std::size_t i = 0; i < 4; ++i) inside[i] = c[i] + (c[(i + 2) % 4] - c[i]) * 0.03;
      for (std::size_t i = 0; i < 4; ++i)
        draw_line(picture, inside[i], inside[(i + 1) % 4], width, colour_of(cell));
      if (cell.state == CellState::illegible)
        for (const std::size_t i : {0U, 1U}) draw_line(picture, inside[i], inside[i + 2], 1, colour_of(cell));
    }
  return picture;
}

}  // namespace nazori::scan
