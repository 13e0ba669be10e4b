// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/kanji/stroke.h"
#include "nazori/surface/height_map.h"

namespace nazori::view {

enum class Style : std::uint8_t {
  classic,  ///< the look of 2005: grey by height, blue background, red arrows, green cone, its camera
  wood,     ///< pale hinoki, lit from the upper left, ink in the grooves
  slate,    ///< the same, dark stone
};

/// How the tablet is looked at. Angles in radians; the default looks straight down on the tablet.
struct Camera {
  double azimuth = 0;         ///< turn about the tablet's normal
  double tilt = 0;            ///< from straight above (0) to grazing (below pi/2)
  double zoom = 1;            ///< 1 fits the tablet into the view; 0.2..20
  geometry::TabletPoint pan;  ///< the point of the plateau in the middle of the view [m]
};

/// Colours that the desktop's theme decides.
enum class Theme : std::uint8_t { light, dark };

/// The stylus as drawn.
struct Cursor {
  glm::dvec3 proxy_m{0};
  glm::dvec3 device_m{0};  ///< drawn faintly where it differs from the proxy
  bool touching = false;
};

/// What is drawn besides the surface. Strokes are numbered from 1.
struct Overlay {
  bool strokes_visible = false;
  bool arrows_visible = true;   ///< arrowheads at the end of each segment's direction
  bool numbers_visible = true;  ///< a disc with the number at each stroke's start
  int current_stroke = 0;       ///< 0: all strokes are drawn, n: only stroke n, as the current one
  /// Part of each stroke's length that has been traced, 0..1; ink fills the groove so far. Missing entries
  /// count as 0.
  std::span<const double> ink;
  std::optional<Cursor> cursor;
};

/// Draws the carved tablet with OpenGL 3.3 core into the framebuffer that is bound. Knows no window toolkit.
///
/// Thread rules: all calls from the thread whose context is current, the same context each time; the
/// destructor too. Cost: a height map and strokes are uploaded once when set; draw() sends only matrices and
/// small uniforms.
class TabletView {
 public:
  /// Compiles shaders and loads the font for numbers.
  /// @return Errc::device when the context is older than OpenGL 3.3 or a shader fails, with the driver's
  /// words.
  [[nodiscard]] static base::Result<std::unique_ptr<TabletView>> create();
  ~TabletView();
  TabletView(const TabletView&) = delete;
  TabletView& operator=(const TabletView&) = delete;

  /// An empty map draws the background only.
  void set_height_map(const surface::HeightMap& map, const geometry::TabletShape& shape = {});
  void set_strokes(std::span<const kanji::StrokeLine> strokes);
  void set_style(Style style);
  void set_theme(Theme theme);
  void set_camera(const Camera& camera);
  [[nodiscard]] const Camera& camera() const;

  /// Draws one picture. @param width,height  of the viewport in pixels.  @param scale  device pixels per
  /// logical pixel (lines and numbers keep their logical size).
  void draw(int width, int height, double scale, const Overlay& overlay);

  /// The point of the plateau under a pixel (y down), nothing where the line of sight misses its plane.
  [[nodiscard]] std::optional<geometry::TabletPoint> pick(glm::dvec2 pixel, int width, int height) const;

 private:
  struct Inside;
  explicit TabletView(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::view
