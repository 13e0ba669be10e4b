// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "view_fixtures.h"

namespace nazori::view {
namespace {

using fixtures::carved;
using fixtures::changed_pixels;
using fixtures::rest;
using fixtures::Studio;

/// A picture with everything in it.
class Everything : public testing::Test {
 protected:
  // One for all tests, because making the face takes time.
  static void SetUpTestSuite() { shared_ = std::make_unique<Studio>(300, 200); }
  static void TearDownTestSuite() { shared_.reset(); }
  Everything() {
    studio_.view->set_style(Style::wood);
    studio_.view->set_theme(Theme::light);
    studio_.view->set_hand(Hand::right);
    studio_.view->set_camera({});
    studio_.view->set_refinement(Refinement::when_still);
    studio_.view->set_height_map(carved(rest()));
    studio_.view->set_strokes(kanji::centre_lines(rest()));
    stroke_.verdict = Verdict::wrong;
    stroke_.points = {{{-0.02, 0.01}}, {{0.02, 0.01}}};
    stroke_.half_width_m = 0.001;
    writing_ = {stroke_};
    overlay_.strokes_visible = true;
    overlay_.cursor = Cursor{};
    overlay_.groove_ink = ink_;
    overlay_.writing = writing_;
  }
  /// The same picture without anything cached from earlier ones.
  Picture anew(const Overlay& overlay) {
    studio_.view->set_strokes(kanji::centre_lines(rest()));
    return studio_.shoot(overlay);
  }
  static inline std::unique_ptr<Studio> shared_;
  Studio& studio_ = *shared_;
  InkedStroke stroke_;
  std::vector<InkedStroke> writing_;
  std::array<double, 6> ink_{1, 0.5, 0, 0, 0, 0};
  Overlay overlay_;
};

TEST_F(Everything, LeavesNothingSwitchedOnOrBound) {
  for (const Style style : {Style::wood, Style::classic}) {
    studio_.view->set_style(style);
    studio_.view->draw(300, 200, 1, overlay_);
    for (const GLenum feature : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST})
      EXPECT_FALSE(glIsEnabled(feature)) << feature;
    for (const GLenum binding : {GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM}) {
      GLint bound = -1;
      glGetIntegerv(binding, &bound);
      EXPECT_EQ(bound, 0) << binding;
    }
    GLint equation = 0;
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &equation);
    EXPECT_EQ(equation, GL_FUNC_ADD);
    GLboolean depth = GL_FALSE;
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depth);
    EXPECT_TRUE(depth);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST_F(Everything, IsDrawnAlikeWhateverOthersHaveLeftSwitchedOn) {
  const Picture clean = studio_.shoot(overlay_);
  const std::array<GLenum, 11> features{
      GL_FRAMEBUFFER_SRGB,    GL_COLOR_LOGIC_OP,     GL_SAMPLE_ALPHA_TO_COVERAGE,
      GL_SAMPLE_COVERAGE,     GL_RASTERIZER_DISCARD, GL_PRIMITIVE_RESTART,
      GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP,        GL_STENCIL_TEST,
      GL_CULL_FACE,           GL_DEPTH_TEST};
  for (const GLenum feature : features) {
    glLogicOp(GL_INVERT);
    glSampleCoverage(0.3F, GL_TRUE);
    glPrimitiveRestartIndex(5);
    glPolygonOffset(-100, -1000);
    glStencilFunc(GL_NEVER, 0, 0);
    glCullFace(GL_FRONT_AND_BACK);
    glDepthFunc(GL_NEVER);
    glEnable(feature);
    studio_.view->set_strokes(kanji::centre_lines(rest()));  // the whole picture is drawn again
    const Picture picture = studio_.shoot(overlay_);
    glDisable(feature);
    EXPECT_EQ(changed_pixels(clean, picture, 0), 0) << feature;
  }
  glDisable(GL_MULTISAMPLE);
  glDepthMask(GL_FALSE);
  glDepthRange(1, 0);
  studio_.view->set_strokes(kanji::centre_lines(rest()));
  EXPECT_EQ(changed_pixels(clean, studio_.shoot(overlay_), 0), 0);
  GLuint sampler = 0;
  glGenSamplers(1, &sampler);
  glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glSamplerParameterf(sampler, GL_TEXTURE_MIN_LOD, 5);
  for (const GLuint unit : {0U, 1U}) glBindSampler(unit, sampler);
  studio_.view->set_strokes(kanji::centre_lines(rest()));
  EXPECT_EQ(changed_pixels(clean, studio_.shoot(overlay_), 0), 0);
  glDeleteSamplers(1, &sampler);
}

TEST_F(Everything, APictureWithoutPixelsIsNotDrawn) {
  const DrawStatistics before = studio_.view->statistics();
  studio_.view->draw(0, 200, 1, overlay_);
  studio_.view->draw(300, 0, 1, overlay_);
  EXPECT_EQ(studio_.view->statistics(), before);
  EXPECT_FALSE(studio_.view->pick({0, 0}, 0, 10));
  EXPECT_FALSE(studio_.view->pick({0, 0}, 10, 0));
  EXPECT_TRUE(studio_.view->pick({0, 0}, 1, 1));
  studio_.view->draw(1, 1, 1, overlay_);
  EXPECT_EQ(studio_.view->statistics().pictures, before.pictures + 1);
}

TEST_F(Everything, WhatIsSetAgainIsNotSentAgain) {
  (void)studio_.shoot(overlay_);
  const DrawStatistics before = studio_.view->statistics();
  studio_.view->set_style(Style::wood);
  studio_.view->set_theme(Theme::light);
  studio_.view->set_hand(Hand::right);
  studio_.view->set_camera(studio_.view->camera());
  (void)studio_.shoot(overlay_);
  EXPECT_EQ(studio_.view->statistics().texture_uploads, before.texture_uploads);
  EXPECT_EQ(studio_.view->statistics().buffer_uploads, before.buffer_uploads);
  EXPECT_EQ(studio_.view->statistics().full_redraws, before.full_redraws);
}

TEST_F(Everything, AnotherLookSendsTheFaceAndOnlyAnotherHandTheMesh) {
  overlay_.writing = {};  // its colours depend on the look
  (void)studio_.shoot(overlay_);
  const auto sent = [&] {
    const DrawStatistics before = studio_.view->statistics();
    (void)studio_.shoot(overlay_);
    const DrawStatistics after = studio_.view->statistics();
    EXPECT_EQ(after.full_redraws, before.full_redraws + 1);
    EXPECT_EQ(after.texture_uploads, before.texture_uploads + 2) << "colours and heights";
    return after.buffer_uploads - before.buffer_uploads;
  };
  studio_.view->set_theme(Theme::dark);
  EXPECT_EQ(sent(), 0U);
  studio_.view->set_style(Style::slate);
  EXPECT_EQ(sent(), 0U);
  studio_.view->set_hand(Hand::left);
  EXPECT_EQ(sent(), 2U);
}

TEST_F(Everything, AnyChangeOfWhatIsChosenIsDrawn) {
  (void)studio_.shoot(overlay_);
  const auto drawn = [&] {
    const DrawStatistics before = studio_.view->statistics();
    (void)studio_.shoot(overlay_);
    return studio_.view->statistics().full_redraws - before.full_redraws;
  };
  EXPECT_EQ(drawn(), 0U);
  overlay_.arrows_visible = false;
  EXPECT_EQ(drawn(), 1U);
  overlay_.numbers_visible = false;
  EXPECT_EQ(drawn(), 1U);
  overlay_.lines_opacity = 0.5;
  EXPECT_EQ(drawn(), 1U);
  overlay_.current_stroke = 3;
  EXPECT_EQ(drawn(), 1U);
  overlay_.text_scale = 2;
  EXPECT_EQ(drawn(), 1U);
  overlay_.strokes_visible = false;
  EXPECT_EQ(drawn(), 1U);
  for (const Camera& camera : {Camera{0.1, 0, 1, {}},
                               {0.1, 0.2, 1, {}},
                               {0.1, 0.2, 2, {}},
                               {0.1, 0.2, 2, {0.01, 0}},
                               {0.1, 0.2, 2, {0.01, 0.01}}}) {
    studio_.view->set_refinement(Refinement::always);
    studio_.view->set_camera(camera);
    EXPECT_EQ(drawn(), 1U);
    EXPECT_FALSE(studio_.view->wants_redraw());
  }
  EXPECT_EQ(drawn(), 0U);
}

TEST_F(Everything, InkIsHeldWithinItsStrokeAndWhatIsNoNumberIsNone) {
  overlay_.strokes_visible = false;
  overlay_.cursor.reset();
  const Picture full = studio_.shoot(overlay_);
  ink_[0] = 7;
  EXPECT_EQ(changed_pixels(full, studio_.shoot(overlay_), 0), 0);
  ink_[2] = std::numeric_limits<double>::quiet_NaN();
  ink_[3] = -1;
  EXPECT_EQ(changed_pixels(full, studio_.shoot(overlay_), 0), 0);
  const DrawStatistics before = studio_.view->statistics();
  overlay_.groove_ink = std::span(ink_).first(1);  // the second stroke has none any more
  const Picture fewer = studio_.shoot(overlay_);
  EXPECT_GT(changed_pixels(full, fewer), 20);
  EXPECT_EQ(studio_.view->statistics().full_redraws, before.full_redraws + 1);
  overlay_.groove_ink = ink_;
  EXPECT_EQ(changed_pixels(full, studio_.shoot(overlay_), 6), 0);
  EXPECT_EQ(studio_.view->statistics().full_redraws, before.full_redraws + 1) << "fresh ink is drawn alone";
  EXPECT_EQ(studio_.view->statistics().partial_redraws, before.partial_redraws + 1);
}

TEST_F(Everything, InkOfAStrokeThatBecomesTheCurrentOneChangesItsColourEverywhere) {
  (void)studio_.shoot(overlay_);
  overlay_.current_stroke = 2;
  overlay_.strokes_visible = false;
  const Picture changed = studio_.shoot(overlay_);
  EXPECT_EQ(changed_pixels(changed, anew(overlay_), 6), 0);
  overlay_.current_stroke = 1;
  const Picture again = studio_.shoot(overlay_);
  EXPECT_EQ(changed_pixels(again, anew(overlay_), 6), 0);
  EXPECT_GT(changed_pixels(again, changed), 20);
  // A stroke without ink may become the current one without that.
  overlay_.current_stroke = 5;
  (void)studio_.shoot(overlay_);
  EXPECT_EQ(changed_pixels(studio_.shoot(overlay_), anew(overlay_), 6), 0);
}

TEST_F(Everything, AnotherSizeOfPictureIsDrawnAnew) {
  const Picture whole = studio_.shoot(overlay_);
  studio_.view->draw(150, 100, 1, overlay_);
  EXPECT_EQ(changed_pixels(whole, studio_.shoot(overlay_), 0), 0);
}

TEST_F(Everything, FreshInkIsDrawnInItsBoxAloneAsIfAllWereDrawn) {
  Overlay overlay = overlay_;
  overlay.cursor.reset();
  overlay.writing = {};
  for (const Camera& camera :
       {Camera{}, Camera{2.2, 0.9, 2, {0.01, 0.01}}, Camera{-1, 0.5, 6, {-0.02, 0.02}}}) {
    studio_.view->set_camera(camera);
    std::array<double, 6> ink{};
    overlay.groove_ink = ink;
    (void)studio_.shoot(overlay);
    (void)studio_.shoot(overlay);
    for (int step = 1; step <= 10; ++step)
      for (std::size_t stroke = 0; stroke < 6; ++stroke) {
        ink[stroke] = step / 10.0;
        studio_.view->draw(300, 200, 1, overlay);
      }
    const Picture slowly = studio_.context->read();
    EXPECT_EQ(changed_pixels(slowly, anew(overlay), 9), 0) << camera.zoom;
  }
}

TEST_F(Everything, WithoutAGraphicsCardEdgesAreSmoothedOnlyWhenThatIsAskedFor) {
  overlay_.cursor.reset();
  const auto redraws = [&] { return studio_.view->statistics().full_redraws; };
  const Picture smooth = studio_.shoot(overlay_);
  studio_.view->set_refinement(Refinement::when_idle);
  const Picture quick = anew(overlay_);
  EXPECT_TRUE(studio_.view->wants_redraw());
  EXPECT_GT(changed_pixels(smooth, quick), 20) << "the edges of the board have steps";
  const auto before = redraws();
  EXPECT_EQ(changed_pixels(quick, studio_.shoot(overlay_), 0), 0);
  EXPECT_EQ(redraws(), before) << "a picture that is shown again is not smoothed by that";
  studio_.view->refine();
  EXPECT_EQ(changed_pixels(smooth, studio_.shoot(overlay_), 0), 0);
  EXPECT_EQ(redraws(), before + 1);
  EXPECT_FALSE(studio_.view->wants_redraw());
  studio_.view->refine();
  (void)studio_.shoot(overlay_);
  EXPECT_EQ(redraws(), before + 1) << "it is smooth already";

  ink_[2] = 0.7;
  (void)studio_.shoot(overlay_);
  EXPECT_EQ(redraws(), before + 1) << "fresh ink is drawn alone";
  EXPECT_TRUE(studio_.view->wants_redraw());
  studio_.view->refine();
  const Picture inked = studio_.shoot(overlay_);
  EXPECT_FALSE(studio_.view->wants_redraw());
  studio_.view->set_refinement(Refinement::always);
  EXPECT_EQ(changed_pixels(inked, anew(overlay_), 0), 0);
}

TEST_F(Everything, WhatChangesBeforeItIsSmoothedHasToBeAskedForAgain) {
  studio_.view->set_refinement(Refinement::when_idle);
  (void)studio_.shoot(overlay_);
  (void)anew(overlay_);
  studio_.view->refine();
  studio_.view->set_camera({0.1, 0.2, 1, {}});
  const Picture turned = studio_.shoot(overlay_);
  EXPECT_TRUE(studio_.view->wants_redraw());
  EXPECT_EQ(changed_pixels(turned, studio_.shoot(overlay_), 0), 0);
  EXPECT_TRUE(studio_.view->wants_redraw());
}

TEST(Refinement, WaitsWhereTheProcessorDrawsAndNotWithAGraphicsCard) {
  for (const char* software :
       {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer", "Google SwiftShader",
        "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)", "GDI Generic",
        "Microsoft Basic Render Driver", "D3D12 (Microsoft Basic Render Driver)", "Apple Software Renderer"})
    EXPECT_EQ(refinement_for(software), Refinement::when_idle) << software;
  for (const char* card : {"", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "AMD Radeon RX 580", "Apple M1",
                           "NVIDIA GeForce GT 710/PCIe/SSE2", "virgl (Mesa Intel(R) HD Graphics)", "V3D 4.2"})
    EXPECT_EQ(refinement_for(card), Refinement::when_still) << card;
}

}  // namespace
}  // namespace nazori::view
