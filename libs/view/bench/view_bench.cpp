// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "nazori/carving/carve.h"
#include "nazori/kanji/centre_lines.h"
#include "nazori/view/offscreen.h"
#include "nazori/view/tablet_view.h"

// CPU is the time of all threads together, which other programs on the machine influence least. Pictures of
// 1280 x 800 with Mesa's software renderer: items per second are pictures per second. Budgets on two cores:
// BM_Tracing at least 60, BM_Orbiting at least 20. BM_ImmediateMode2005 draws as the 2005 program did, with
// the same driver in the same run.
namespace nazori::view {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 800;

/// 休. @source A. D. Horne, West Virginia University, 2005.
std::vector<kanji::StrokeLine> rest() {
  const std::vector<std::vector<geometry::GridPoint>> strokes{
      {{50, 21}, {19, 53}}, {{40, 40}, {38, 99}},           {{63, 32}, {109, 31}},
      {{85, 20}, {86, 97}}, {{83, 41}, {72, 59}, {57, 74}}, {{90, 41}, {103, 58}, {125, 70}}};
  std::vector<kanji::StrokeLine> lines;
  for (const auto& points : strokes) {
    kanji::StrokeLine line;
    for (const auto p : points) line.points.push_back(geometry::grid_to_glyph(p, 128));
    lines.push_back(std::move(line));
  }
  return lines;
}

struct Stage {
  std::unique_ptr<OffscreenContext> context = OffscreenContext::create(kWidth, kHeight).value();
  std::unique_ptr<TabletView> view = TabletView::create().value();
  Overlay overlay;
  std::array<double, 6> ink{};

  Stage(int map_size, Style style) {
    view->set_style(style);
    view->set_height_map(carving::carve(rest(), map_size).value());
    view->set_strokes(kanji::centre_lines(rest()));
    view->set_camera(Camera::resting());
    overlay.strokes_visible = true;
    overlay.cursor = Cursor{};
    overlay.groove_ink = ink;
    draw();
  }
  void draw() {
    view->draw(kWidth, kHeight, 1, overlay);
    glFinish();
  }
};

Style style_of(const benchmark::State& state) { return static_cast<Style>(state.range(1)); }

/// A still camera, the stylus moving, with the ink of all strokes growing a little in every picture.
void BM_Tracing(benchmark::State& state) {
  Stage stage(static_cast<int>(state.range(0)), style_of(state));
  stage.overlay.current_stroke = 1;
  int step = 0;
  for (auto _ : state) {
    const double traced = std::fmod(step++ / 150.0, 6.0);
    for (std::size_t i = 0; i < stage.ink.size(); ++i)
      stage.ink[i] = std::clamp(traced - static_cast<double>(i), 0.0, 1.0);
    stage.overlay.current_stroke = static_cast<int>(traced) + 1;
    stage.overlay.cursor->proxy_m = {0.03 * std::cos(traced), 0.03 * std::sin(traced), -0.008};
    stage.draw();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_Tracing)
    ->ArgsProduct({{128, 1024}, {static_cast<long>(Style::classic), static_cast<long>(Style::wood)}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void orbit(benchmark::State& state, Refinement refinement) {
  Stage stage(static_cast<int>(state.range(0)), style_of(state));
  stage.view->set_refinement(refinement);
  Camera camera = Camera::resting();
  camera.tilt = 0.6;
  for (auto _ : state) {
    camera.azimuth += 0.03;
    stage.view->set_camera(camera);
    stage.draw();
  }
  state.SetItemsProcessed(state.iterations());
}
void BM_Orbiting(benchmark::State& state) { orbit(state, Refinement::when_still); }
BENCHMARK(BM_Orbiting)
    ->ArgsProduct({{128, 1024}, {static_cast<long>(Style::classic), static_cast<long>(Style::wood)}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
void BM_OrbitingRefined(benchmark::State& state) { orbit(state, Refinement::always); }
BENCHMARK(BM_OrbitingRefined)
    ->Args({1024, static_cast<long>(Style::wood)})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Another character: mesh, light and shadow, strokes, and the first picture.
void BM_AnotherCharacter(benchmark::State& state) {
  Stage stage(static_cast<int>(state.range(0)), style_of(state));
  const auto map = carving::carve(rest(), static_cast<int>(state.range(0))).value();
  for (auto _ : state) {
    stage.view->set_height_map(map);
    stage.view->set_strokes(kanji::centre_lines(rest()));
    stage.draw();
  }
}
BENCHMARK(BM_AnotherCharacter)
    ->ArgsProduct({{128, 1024}, {static_cast<long>(Style::classic), static_cast<long>(Style::wood)}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// A compatibility context, in which glBegin and glEnd still exist.
class OldContext {
 public:
  OldContext() {
    display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(display_, nullptr, nullptr);
    eglBindAPI(EGL_OPENGL_API);
    const std::array<EGLint, 3> attributes{EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, nullptr, EGL_NO_CONTEXT, attributes.data());
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(2, renderbuffers_.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kWidth, kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers_[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffers_[1]);
    glViewport(0, 0, kWidth, kHeight);
  }
  OldContext(const OldContext&) = delete;
  OldContext& operator=(const OldContext&) = delete;
  ~OldContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  [[nodiscard]] bool is_usable() const {
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return context_ != EGL_NO_CONTEXT && (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
  }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  GLuint framebuffer_ = 0;
  std::array<GLuint, 2> renderbuffers_{};
};

/// 2005: one triangle strip per pair of rows, every vertex and its grey sent again for every picture.
void BM_ImmediateMode2005(benchmark::State& state) {
  const OldContext context;
  if (!context.is_usable()) {
    state.SkipWithError("the driver has no compatibility profile");
    return;
  }
  const auto map = carving::carve(rest(), 128).value();
  const double near = 1 / std::tan(20 * std::numbers::pi / 180);
  double turn = 0;
  for (auto _ : state) {
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glShadeModel(GL_SMOOTH);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    const double aspect = static_cast<double>(kWidth) / kHeight;
    glFrustum(-aspect, aspect, -1, 1, near, near + 2);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslated(0, 0, -(near + 1));
    glRotated(turn, 0, 0, 1);
    turn += 1;
    glTranslated(-1, -1, -0.5);
    glScaled(2.0 / 124, 2.0 / 124, 2.0 / 124);
    const auto vertex = [&](int x, int y) {
      const float height = map.at(x, y);
      glColor3f(height, height, height);
      glVertex3d(x, 128 - y, height * 12.75);
    };
    for (int y = 0; y + 1 < 128; ++y) {
      glBegin(GL_TRIANGLE_STRIP);
      for (int x = 0; x < 128; ++x) {
        vertex(x, y);
        vertex(x, y + 1);
      }
      glEnd();
    }
    glLineWidth(2);
    glColor3f(1, 0, 0);
    for (const auto& line : rest()) {
      glBegin(GL_LINE_STRIP);
      for (const auto p : line.points) {
        const auto grid = geometry::glyph_to_grid(p, 128);
        glVertex3d(grid.x, 128 - grid.y, 257 * 0.05);
      }
      glEnd();
    }
    glFinish();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_ImmediateMode2005)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace nazori::view
