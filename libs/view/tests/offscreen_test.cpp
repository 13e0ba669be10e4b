// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/offscreen.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "nazori/base/file.h"
#include "view_fixtures.h"

namespace nazori::view {
namespace {

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / (std::to_string(getpid()) + name);
}

TEST(OffscreenContext, OffersOpenGl33CoreWithoutADisplay) {
  const auto context = OffscreenContext::create(16, 16);
  ASSERT_TRUE(context.has_value()) << base::to_line(context.error());
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(epoxy_gl_version(), 33);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST(OffscreenContext, ReadsThePictureTopRowFirst) {
  const auto context = OffscreenContext::create(8, 6).value();
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 5, 8, 1);  // OpenGL counts rows from below
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const Picture picture = context->read();
  EXPECT_EQ(picture.width, 8);
  EXPECT_EQ(picture.height, 6);
  EXPECT_EQ(fixtures::pixel(picture, 3, 0).red, 255);
  EXPECT_EQ(fixtures::pixel(picture, 3, 1).red, 0);
  EXPECT_EQ(fixtures::pixel(picture, 3, 5).red, 0);
}

TEST(OffscreenContext, ReadingLeavesTheFramebufferThatIsReadFrom) {
  const auto context = OffscreenContext::create(8, 8).value();
  GLuint own = 0;
  glGenFramebuffers(1, &own);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, own);
  (void)context->read();
  GLint bound = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(bound, static_cast<GLint>(own));
  glDeleteFramebuffers(1, &own);
}

TEST(OffscreenContext, RefusesSizesThatNoPictureHas) {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {100000, 10}}) {
    const auto context = OffscreenContext::create(width, height);
    ASSERT_FALSE(context.has_value());
    EXPECT_EQ(context.error().code, base::Errc::bad_argument);
  }
}

TEST(OffscreenContext, CanBeMadeManyTimesAndTwoAtOnce) {
  for (int i = 0; i < 3; ++i) {
    auto first = OffscreenContext::create(16, 16);
    auto second = OffscreenContext::create(32, 16);
    ASSERT_TRUE(first && second);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    first->reset();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 16, 16);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);  // into the second, which has stayed current
    const Picture picture = (*second)->read();
    EXPECT_EQ(picture.width, 32);
    EXPECT_EQ(fixtures::pixel(picture, 4, 4).blue, 255);
    EXPECT_EQ(fixtures::pixel(picture, 20, 4).green, 255);
  }
}

TEST(PicturePng, ComesBackAsItWasSaved) {
  Picture picture{3, 2, {}};
  for (int i = 0; i < 6; ++i) {
    picture.rgba.insert(picture.rgba.end(),
                        {static_cast<std::uint8_t>(i * 40), static_cast<std::uint8_t>(255 - i),
                         static_cast<std::uint8_t>(i), 255});
  }
  const auto path = scratch("picture.png");
  ASSERT_TRUE(save_png(picture, path).has_value());
  const auto loaded = load_picture_png(path);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->width, 3);
  EXPECT_EQ(loaded->height, 2);
  EXPECT_EQ(loaded->rgba, picture.rgba);
  std::filesystem::remove(path);
}

TEST(PicturePng, RefusesPicturesWithoutPixelsAndFilesThatAreNotPng) {
  EXPECT_EQ(save_png(Picture{4, 4, {1, 2, 3}}, scratch("none.png")).error().code, base::Errc::bad_argument);
  EXPECT_FALSE(std::filesystem::exists(scratch("none.png")));
  const auto path = scratch("text.png");
  ASSERT_TRUE(base::write_file(path, "not a picture").has_value());
  EXPECT_EQ(load_picture_png(path).error().code, base::Errc::parse);
  std::filesystem::remove(path);
  EXPECT_EQ(load_picture_png(path).error().code, base::Errc::not_found);
}

TEST(PicturePng, RefusesADamagedFile) {
  Picture picture{40, 40, std::vector<std::uint8_t>(6400, 77)};
  const auto path = scratch("damaged.png");
  ASSERT_TRUE(save_png(picture, path).has_value());
  auto bytes = base::read_file(path, 1 << 20).value();
  bytes.resize(bytes.size() / 2);
  ASSERT_TRUE(base::write_file(path, bytes).has_value());
  EXPECT_EQ(load_picture_png(path).error().code, base::Errc::parse);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace nazori::view
