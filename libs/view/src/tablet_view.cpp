// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/tablet_view.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "canvas.h"
#include "cursor_layer.h"
#include "groove_ink.h"
#include "label_layer.h"
#include "nazori/view/point_under.h"
#include "projection.h"
#include "relief.h"
#include "stroke_layer.h"
#include "tablet_layer.h"
#include "writing_layer.h"

namespace nazori::view {
namespace {

constexpr int kOldestVersion = 33;
/// Side of the relief from which the widths of grooves are read.
constexpr int kInkRelief = 256;
/// Pixels around fresh ink that its soft edge can reach.
constexpr int kInkMargin = 4;
constexpr double kMaxTextScale = 4;
constexpr double kMinTextScale = 0.5;

/// Makes no assumption about the context: other users may have left any state switched on.
void reset_state() {
  for (const GLenum feature :
       {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB,
        GL_COLOR_LOGIC_OP, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD,
        GL_PRIMITIVE_RESTART, GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP})
    glDisable(feature);
  glEnable(GL_MULTISAMPLE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glBlendEquation(GL_FUNC_ADD);
  glDepthRange(0, 1);
  for (const GLuint unit : {0U, 1U}) glBindSampler(unit, 0);
}

/// The content of the cached picture, apart from ink.
struct PictureKey {
  int width = 0;
  int height = 0;
  Camera camera;
  Look look;
  StrokeChoice strokes;
  std::uint64_t content = 0;
};

bool same_camera(const Camera& a, const Camera& b) {
  return a.azimuth == b.azimuth && a.tilt == b.tilt && a.zoom == b.zoom && a.pan == b.pan;
}

bool same_picture(const PictureKey& a, const PictureKey& b) {
  return a.width == b.width && a.height == b.height && same_camera(a.camera, b.camera) && a.look == b.look &&
         a.strokes == b.strokes && a.content == b.content;
}

PixelBox whole(const Projection& projection) { return {0, 0, projection.width, projection.height}; }

/// The pixels that the grooves under discs of ink can cover, from edge to bottom.
PixelBox box_around(std::span<const glm::vec3> discs_m, const Projection& projection, double depth_m) {
  glm::dvec2 low(1e9);
  glm::dvec2 high(-1e9);
  for (const glm::vec3 disc : discs_m) {
    for (const double z : {0.0, -depth_m}) {
      for (const double dx : {-1.0, 1.0}) {
        for (const double dy : {-1.0, 1.0}) {
          const glm::dvec2 pixel = projection.pixel({disc.x + dx * disc.z, disc.y + dy * disc.z, z});
          low = glm::min(low, pixel);
          high = glm::max(high, pixel);
        }
      }
    }
  }
  const int left = std::max(static_cast<int>(std::floor(low.x)) - kInkMargin, 0);
  const int right = std::min(static_cast<int>(std::ceil(high.x)) + kInkMargin, projection.width);
  const int top = std::max(static_cast<int>(std::floor(low.y)) - kInkMargin, 0);
  const int bottom = std::min(static_cast<int>(std::ceil(high.y)) + kInkMargin, projection.height);
  return {left, projection.height - bottom, right - left, bottom - top};
}

}  // namespace

struct TabletView::Inside {
  DrawStatistics statistics;
  TabletLayer tablet;
  GrooveInk ink;
  StrokeLayer strokes;
  WritingLayer writing;
  CursorLayer cursor;
  LabelLayer labels;
  Canvas canvas;

  surface::HeightMap map;
  geometry::TabletShape shape;
  std::vector<geometry::Polyline<geometry::GlyphFrame>> lines;
  Relief ink_relief;
  Look look;
  Camera camera;
  std::uint64_t content = 1;  ///< counts changes of the content
  bool strokes_stale = false;
  bool look_stale = false;
  PictureKey drawn;
  Refinement refinement = Refinement::when_still;
  bool in_motion = false;  ///< the last two pictures had different cameras
  bool drawn_quickly = false;
  bool refines = false;  ///< refine() was called

  Inside(DrawStatistics counted, TabletLayer tablet_layer, GrooveInk ink_layer, StrokeLayer stroke_layer,
         WritingLayer writing_layer, CursorLayer cursor_layer, LabelLayer label_layer)
      : statistics(counted),
        tablet(std::move(tablet_layer)),
        ink(std::move(ink_layer)),
        strokes(std::move(stroke_layer)),
        writing(std::move(writing_layer)),
        cursor(std::move(cursor_layer)),
        labels(std::move(label_layer)) {}

  void send_what_is_stale();
  void update_picture(const Projection& projection, const Overlay& overlay, double scale);
  [[nodiscard]] Projection projection(int width, int height) const {
    return make_projection(camera, look.style, shape, width, height);
  }
};

void TabletView::Inside::send_what_is_stale() {
  if (look_stale) tablet.set_look(map, look, statistics);
  look_stale = false;
  if (strokes_stale) {
    const StrokeGeometry geometry = make_stroke_geometry(lines, ink_relief, shape);
    strokes.set_strokes(geometry, shape, statistics);
    ink.set_strokes(geometry, shape, statistics);
  }
  strokes_stale = false;
}

void TabletView::Inside::update_picture(const Projection& projection, const Overlay& overlay, double scale) {
  const int count = static_cast<int>(lines.size());
  StrokeChoice choice;
  choice.lines = overlay.strokes_visible;
  choice.heads = overlay.arrows_visible;
  choice.numbers = overlay.numbers_visible;
  choice.lines_opacity = std::clamp(overlay.lines_opacity, 0.0, 1.0);
  choice.current =
      overlay.current_stroke >= 1 && overlay.current_stroke <= count ? overlay.current_stroke : 0;
  choice.scale = scale;
  choice.text_scale = std::clamp(overlay.text_scale, kMinTextScale, kMaxTextScale);
  const PictureKey key{projection.width, projection.height, camera, look, choice, content};

  GrooveInk::Change change;
  const bool inkable = look.style != Style::classic && !tablet.is_empty() && count > 0;
  if (inkable)
    change =
        ink.update(overlay.groove_ink, choice.current, tablet.height_texture(), tablet.face_from_square());
  // The first picture from a new camera has full quality; from the second in a row on the camera is in
  // motion.
  const bool turned = drawn.content == content && !same_camera(camera, drawn.camera);
  const bool changed = !same_picture(key, drawn) || change.everywhere;
  const bool refined = drawn_quickly && !changed && (refines || refinement != Refinement::when_idle);
  const bool quick = (refinement == Refinement::when_still && turned && in_motion) ||
                     (refinement == Refinement::when_idle && !refined);
  in_motion = turned;
  refines = false;
  const bool redraw = changed || refined;
  if (!redraw && change.fresh_m.empty()) return;

  const PixelBox box = redraw ? whole(projection) : box_around(change.fresh_m, projection, shape.depth_m);
  if (!box.is_empty()) {
    const bool sampled = canvas.bind_tablet(quick);
    tablet.draw(projection, box, inkable && ink.has_ink() ? ink.texture() : 0);
    if (sampled) canvas.resolve(box);
    if (refinement == Refinement::when_idle) canvas.free_samples();
    strokes.draw(projection, box, look, choice, statistics);
    labels.draw(projection, box, look, choice, statistics);
    ++(redraw ? statistics.full_redraws : statistics.partial_redraws);
  }
  drawn = key;
  drawn_quickly = quick;
}

TabletView::TabletView(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
TabletView::~TabletView() = default;

Refinement refinement_for(std::string_view renderer) {
  const std::array<std::string_view, 7> in_software{"llvmpipe",
                                                    "softpipe",
                                                    "Software Rasterizer",
                                                    "SwiftShader",
                                                    "GDI Generic",
                                                    "Microsoft Basic Render Driver",
                                                    "Apple Software Renderer"};
  const bool found = std::any_of(in_software.begin(), in_software.end(),
                                 [&](std::string_view name) { return renderer.find(name) != renderer.npos; });
  return found ? Refinement::when_idle : Refinement::when_still;
}

base::Result<std::unique_ptr<TabletView>> TabletView::create() {
  const int version = epoxy_gl_version();
  if (!epoxy_is_desktop_gl() || version < kOldestVersion) {
    return base::fail(base::Errc::device,
                      fmt::format("the graphics context offers {} {}.{}",
                                  epoxy_is_desktop_gl() ? "OpenGL" : "OpenGL ES", version / 10, version % 10),
                      "OpenGL",
                      "OpenGL 3.3 is needed: update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  DrawStatistics statistics;
  auto tablet = TabletLayer::create();
  if (!tablet) return tl::unexpected(tablet.error());
  auto ink = GrooveInk::create();
  if (!ink) return tl::unexpected(ink.error());
  auto strokes = StrokeLayer::create();
  if (!strokes) return tl::unexpected(strokes.error());
  auto writing = WritingLayer::create();
  if (!writing) return tl::unexpected(writing.error());
  auto cursor = CursorLayer::create(statistics);
  if (!cursor) return tl::unexpected(cursor.error());
  auto labels = LabelLayer::create();
  if (!labels) return tl::unexpected(labels.error());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  auto inside = std::make_unique<Inside>(statistics, std::move(*tablet), std::move(*ink), std::move(*strokes),
                                         std::move(*writing), std::move(*cursor), std::move(*labels));
  return std::unique_ptr<TabletView>(new TabletView(std::move(inside)));
}

void TabletView::set_height_map(const surface::HeightMap& map, const geometry::TabletShape& shape) {
  inside_->map = map;
  inside_->shape = shape;
  inside_->tablet.set_relief(map, shape, inside_->look, inside_->statistics);
  inside_->ink_relief = map.is_loaded() ? resampled(map, kInkRelief) : Relief{};
  inside_->look_stale = false;
  inside_->strokes_stale = true;
  inside_->camera = within_limits(inside_->camera, shape);
  ++inside_->content;
}

void TabletView::set_strokes(std::vector<geometry::Polyline<geometry::GlyphFrame>> lines) {
  inside_->lines = std::move(lines);
  inside_->strokes_stale = true;
  ++inside_->content;
}

void TabletView::set_labels(std::vector<geometry::Label> labels) {
  inside_->labels.set_labels(std::move(labels));
  ++inside_->content;
}

void TabletView::set_style(Style style) {
  inside_->look_stale |= inside_->look.style != style;
  inside_->look.style = style;
}
void TabletView::set_theme(Theme theme) {
  inside_->look_stale |= inside_->look.theme != theme;
  inside_->look.theme = theme;
}
void TabletView::set_hand(Hand hand) {
  inside_->look_stale |= inside_->look.hand != hand;
  inside_->look.hand = hand;
}

void TabletView::set_refinement(Refinement refinement) { inside_->refinement = refinement; }
bool TabletView::wants_redraw() const { return inside_->drawn_quickly; }
void TabletView::refine() { inside_->refines = true; }

void TabletView::set_camera(const Camera& camera) { inside_->camera = within_limits(camera, inside_->shape); }
const Camera& TabletView::camera() const { return inside_->camera; }
std::span<const NumberPlace> TabletView::numbers() const { return inside_->strokes.numbers(); }
std::span<const LabelPlace> TabletView::labels() const { return inside_->labels.places(); }
std::span<const SignPlace> TabletView::signs() const { return inside_->writing.signs(); }
const DrawStatistics& TabletView::statistics() const { return inside_->statistics; }

void TabletView::draw(int width, int height, double scale, const Overlay& overlay) {
  if (width < 1 || height < 1) return;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  reset_state();
  inside_->send_what_is_stale();
  const bool kept = inside_->canvas.width() == width && inside_->canvas.height() == height;
  if (!kept) inside_->drawn = {};
  const Projection projection = inside_->projection(width, height);
  if (inside_->canvas.resize(width, height)) {
    inside_->update_picture(projection, overlay, scale);
    inside_->canvas.show(static_cast<GLuint>(target));
  }
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
  inside_->writing.draw(projection, overlay, inside_->look, scale,
                        std::clamp(overlay.text_scale, kMinTextScale, kMaxTextScale), inside_->statistics);
  if (overlay.cursor) {
    const StrokeChoice& choice = inside_->drawn.strokes;
    const auto trace =
        inside_->cursor.draw(projection, *overlay.cursor, inside_->look, choice.current > 0, scale);
    inside_->strokes.draw_numbers_again(projection, inside_->look, choice, trace.tip, trace.end, trace.reach);
  }
  glUseProgram(0);
  ++inside_->statistics.pictures;
}

std::optional<geometry::TabletPoint> TabletView::pick(glm::dvec2 pixel, int width, int height) const {
  if (width < 1 || height < 1) return std::nullopt;
  return inside_->projection(width, height).on_plane(pixel, 0);
}

glm::dvec2 TabletView::project(glm::dvec3 point_m, int width, int height) const {
  return inside_->projection(width, height).pixel(point_m);
}

Camera TabletView::panned(glm::dvec2 from, glm::dvec2 to, int width, int height) const {
  return view::panned(inside_->camera, inside_->look.style, inside_->shape, from, to, width, height);
}

Camera TabletView::zoomed(double factor, glm::dvec2 pixel, int width, int height) const {
  return view::zoomed(inside_->camera, inside_->look.style, inside_->shape, factor, pixel, width, height);
}

}  // namespace nazori::view
