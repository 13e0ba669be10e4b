// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "nazori/carving/carve.h"
#include "nazori/geometry/frames.h"
#include "nazori/kanji/centre_lines.h"
#include "nazori/view/offscreen.h"
#include "nazori/view/tablet_view.h"

namespace nazori::view::fixtures {

/// 休 as in the 2005 program: points on a grid of 128, y down.
/// @source A. D. Horne, "Computer Assisted Learning of Japanese Kanji", West Virginia University, 2005.
inline std::vector<kanji::StrokeLine> rest() {
  using Points = std::vector<geometry::GridPoint>;
  const std::vector<Points> strokes{{{50, 21}, {19, 53}},           {{40, 40}, {38, 99}},
                                    {{63, 32}, {109, 31}},          {{85, 20}, {86, 97}},
                                    {{83, 41}, {72, 59}, {57, 74}}, {{90, 41}, {103, 58}, {125, 70}}};
  std::vector<kanji::StrokeLine> lines;
  for (const Points& points : strokes) {
    kanji::StrokeLine line;
    for (const auto p : points) line.points.push_back(geometry::grid_to_glyph(p, 128));
    line.ending = lines.size() == 4 || lines.size() == 5 || lines.empty() ? kanji::StrokeEnding::taper
                                                                          : kanji::StrokeEnding::stop;
    lines.push_back(line);
  }
  return lines;
}

/// One straight stroke.
inline kanji::StrokeLine straight(geometry::GlyphPoint from, geometry::GlyphPoint to) {
  kanji::StrokeLine line;
  line.points = {from, to};
  return line;
}

inline surface::HeightMap carved(const std::vector<kanji::StrokeLine>& lines, int size = 256) {
  return carving::carve(lines, size).value();
}

/// An off-screen context with a view in it.
struct Studio {
  int width;
  int height;
  std::unique_ptr<OffscreenContext> context;
  std::unique_ptr<TabletView> view;

  Studio(int w, int h)
      : width(w),
        height(h),
        context(OffscreenContext::create(w, h).value()),
        view(TabletView::create().value()) {}
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;
  ~Studio() { view.reset(); }

  Picture shoot(const Overlay& overlay = {}, double scale = 1) {
    view->draw(width, height, scale, overlay);
    return context->read();
  }
};

/// The pixel at which a point of the character is seen.
inline glm::dvec2 seen(const Studio& studio, geometry::GlyphPoint p, double z_m = 0) {
  const auto place = geometry::glyph_to_tablet(p, {});
  return studio.view->project({place.x, place.y, z_m}, studio.width, studio.height);
}

struct Rgb {
  int red;
  int green;
  int blue;
};

inline Rgb pixel(const Picture& picture, int x, int y) {
  const std::size_t at =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)) *
      4;
  return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
}
inline Rgb pixel(const Picture& picture, glm::dvec2 at) {
  return pixel(picture, static_cast<int>(at.x), static_cast<int>(at.y));
}

inline int difference(Rgb a, Rgb b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

/// Pixels that differ by more than `least` over the three channels together.
inline int changed_pixels(const Picture& a, const Picture& b, int least = 24) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) count += difference(pixel(a, x, y), pixel(b, x, y)) > least ? 1 : 0;
  return count;
}

inline double luminance(Rgb c) { return 0.299 * c.red + 0.587 * c.green + 0.114 * c.blue; }

}  // namespace nazori::view::fixtures
