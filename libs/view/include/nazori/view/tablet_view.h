// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/label.h"
#include "nazori/kanji/stroke.h"
#include "nazori/surface/height_map.h"
#include "nazori/view/camera.h"
#include "nazori/view/inked_stroke.h"

namespace nazori::view {

enum class Style : std::uint8_t {
  classic,  ///< the look of the 2005 program: grey by height, blue background, red arrows, green cone, its
            ///< camera
  wood,     ///< pale hinoki, lit from the upper left, ink in the grooves
  slate,    ///< the same, dark stone
};

/// Colours that depend on the desktop's theme.
enum class Theme : std::uint8_t { light, dark };

/// Thin dashed lines on the face of the tablet, as on practice paper.
enum class WritingCross : std::uint8_t {
  none,
  halves,    ///< 十: a line down and a line across the middle
  quarters,  ///< 田: the same within a square
};

/// The stylus as drawn.
struct Cursor {
  glm::dvec3 proxy_m{0};
  glm::dvec3 device_m{0};  ///< drawn faintly where it differs from the proxy
  bool touching = false;
  /// From the tip towards the learner's hand, tablet frame; zero: leaning as a right or left hand holds it.
  glm::dvec3 axis{0};
};

/// The position of a sign in a picture.
struct SignPlace {
  int stroke = 0;  ///< index into Overlay::writing
  Verdict verdict = Verdict::none;
  glm::dvec2 pixel{0};  ///< middle of the disc, y down
  double radius = 0;    ///< of the disc in pixels
};

/// The elements drawn besides the surface. Strokes are numbered from 1.
struct Overlay {
  bool strokes_visible = false;
  bool arrows_visible = true;   ///< arrowheads at the end of each segment's direction
  bool numbers_visible = true;  ///< a disc with the number at each stroke's start
  /// Of lines and arrowheads, 0..1; at 0 only the numbers show where strokes start.
  double lines_opacity = 1;
  int current_stroke = 0;  ///< 0: draw all strokes, n: only stroke n, as the current one
  /// Part of each stroke's length that has been traced, 0..1; ink fills that part of the groove. Missing
  /// entries count as 0.
  std::span<const double> groove_ink;
  /// Flat ink on the tablet's face, drawn in this order: the learner's own writing, and models over it.
  std::span<const InkedStroke> writing;
  WritingCross cross = WritingCross::none;
  std::optional<Cursor> cursor;
  /// Size of interface text relative to 12 pt: numbers, arrowheads and lines grow with it. 0.5..4.
  double text_scale = 1;
};

/// The position of a stroke number in a picture.
struct NumberPlace {
  int stroke = 0;       ///< from 1
  glm::dvec2 pixel{0};  ///< middle of the disc, y down
  double radius = 0;    ///< of the disc in pixels
};

/// The position of a label in a picture.
struct LabelPlace {
  std::size_t label = 0;  ///< index in what set_labels() was given
  glm::dvec2 low{0};      ///< corners of the box around its text [pixels, y down]
  glm::dvec2 high{0};
};

/// The hand that holds the stylus: the light comes from the other side, so that the hand casts no shadow on
/// its work.
enum class Hand : std::uint8_t { right, left };

/// When the edges of the tablet are smoothed with several samples per pixel.
enum class Refinement : std::uint8_t {
  when_still,  ///< not while the camera moves, for more pictures per second
  when_idle,   ///< only by TabletView::refine(): the first picture of a character is there sooner, and the
               ///< memory for the samples is freed after each use
  always,
};

/// How a renderer is best used. @param renderer  what OpenGL calls it (GL_RENDERER): when_idle for those that
/// draw with the processor alone, where several samples a pixel take most of the time of a picture.
/// @source the names of Mesa's, Google's, Microsoft's and Apple's software renderers.
[[nodiscard]] Refinement refinement_for(std::string_view renderer);

/// Counters since creation, with which a caller or a test can check that nothing is sent twice.
struct DrawStatistics {
  std::uint64_t pictures = 0;         ///< calls of draw()
  std::uint64_t full_redraws = 0;     ///< pictures for which tablet and strokes were drawn again
  std::uint64_t partial_redraws = 0;  ///< pictures for which only the region of new ink was drawn again
  std::uint64_t buffer_uploads = 0;   ///< vertex and index buffers sent
  std::uint64_t texture_uploads = 0;  ///< textures sent

  friend bool operator==(const DrawStatistics&, const DrawStatistics&) = default;
};

/// Draws the carved tablet with OpenGL 3.3 core into the framebuffer that is bound. It does not depend on a
/// window toolkit.
///
/// Thread rules: all calls from the thread whose context is current, the same context each time; the
/// destructor too. Cost: a height map and strokes are uploaded once when set; draw() sends only matrices and
/// small uniforms.
class TabletView {
 public:
  /// Compiles shaders and loads the font for numbers.
  /// @return Errc::device when the context is older than OpenGL 3.3 or a shader fails, with the driver's
  /// message.
  [[nodiscard]] static base::Result<std::unique_ptr<TabletView>> create();
  ~TabletView();
  TabletView(const TabletView&) = delete;
  TabletView& operator=(const TabletView&) = delete;

  /// An empty map draws the background only.
  void set_height_map(const surface::HeightMap& map, const geometry::TabletShape& shape = {});
  /// The lines to be drawn and numbered: strokes of a character in their order, or curves.
  void set_strokes(std::vector<geometry::Polyline<geometry::GlyphFrame>> lines);
  /// Texts beside points of the face. One that would cover an earlier one, or leave the picture, is not
  /// drawn.
  void set_labels(std::vector<geometry::Label> labels);
  void set_style(Style style);
  void set_theme(Theme theme);
  void set_hand(Hand hand);
  /// Sets the camera to within_limits() of `camera`, which camera() then returns.
  void set_camera(const Camera& camera);
  [[nodiscard]] const Camera& camera() const;

  /// Draws one picture. @param width,height  of the viewport in pixels.  @param scale  device pixels per
  /// logical pixel (lines and numbers keep their logical size).
  void draw(int width, int height, double scale, const Overlay& overlay);

  /// Refinement::when_still by default.
  void set_refinement(Refinement refinement);
  /// Whether the last picture was drawn at lower quality: when nothing changes any more, call refine() and
  /// draw again.
  [[nodiscard]] bool wants_redraw() const;
  /// The next picture is drawn in full quality if nothing else has changed by then.
  void refine();

  /// The point of the plateau under a pixel (y down), nothing where the line of sight misses its plane.
  [[nodiscard]] std::optional<geometry::TabletPoint> pick(glm::dvec2 pixel, int width, int height) const;
  /// The pixel (y down) of a point of the tablet frame [m]: the inverse of pick() at z = 0.
  [[nodiscard]] glm::dvec2 project(glm::dvec3 point_m, int width, int height) const;
  /// The camera with the tablet moved by a drag: the point of the plateau under `from` moves to `to`.
  [[nodiscard]] Camera panned(glm::dvec2 from, glm::dvec2 to, int width, int height) const;
  /// The camera zoomed by `factor` while the point of the plateau under `pixel` stays fixed.
  [[nodiscard]] Camera zoomed(double factor, glm::dvec2 pixel, int width, int height) const;

  /// The numbers of the last picture, for tests and for clicks in a window. A stroke whose start lies outside
  /// the picture has none.
  [[nodiscard]] std::span<const NumberPlace> numbers() const;
  /// The labels of the last picture.
  [[nodiscard]] std::span<const LabelPlace> labels() const;
  /// The signs of the last picture.
  [[nodiscard]] std::span<const SignPlace> signs() const;

  [[nodiscard]] const DrawStatistics& statistics() const;

 private:
  struct Inside;
  explicit TabletView(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::view
