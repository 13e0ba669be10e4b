// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/offscreen.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
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

TEST(OffscreenContext, TheGreatestSideCanBeDrawnAndOneMoreIsRefused) {
  for (const auto& [width, height] : {std::pair{16385, 1}, {1, 16385}, {0, 1}, {1, 0}})
    EXPECT_FALSE(OffscreenContext::create(width, height)) << width << " x " << height;
  for (const auto& [width, height] : {std::pair{16384, 1}, {1, 16384}, {1, 1}})
    EXPECT_TRUE(OffscreenContext::create(width, height)) << width << " x " << height;
  const auto refused = OffscreenContext::create(20000, 3);
  EXPECT_EQ(refused.error().what, "a picture of 20000 x 3 pixels cannot be drawn");
  EXPECT_EQ(refused.error().remedy, "give 1 to 16384 pixels a side");
}

/// Ends the program with 0 where a context is refused with these words.
[[noreturn]] void end_as_refused(const char* words) {
  const auto context = OffscreenContext::create(16, 16);
  const bool is_refused = !context && context.error().code == base::Errc::device &&
                          context.error().what.find(words) != std::string::npos &&
                          context.error().remedy.find("libegl1") != std::string::npos;
  if (!is_refused) std::fprintf(stderr, "%s\n", context ? "made" : base::to_line(context.error()).c_str());
  std::exit(is_refused ? 0 : 1);
}

TEST(OffscreenContextDeathTest, WithoutADriverItSaysThatEglCannotDrawWithoutAScreen) {
  // A program of its own, in which EGL has not been asked yet.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/egl.json", 1);
        end_as_refused("EGL here cannot draw without a screen");
      },
      testing::ExitedWithCode(0), "");
}

TEST(OffscreenContext, ReadsIntoMemoryWhateverWasSetForReading) {
  const auto context = OffscreenContext::create(5, 4).value();
  glClearColor(1, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const Picture clean = context->read();
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glPixelStorei(GL_PACK_ROW_LENGTH, 2);
  EXPECT_EQ(context->read().rgba, clean.rgba);
  glDeleteBuffers(1, &buffer);
  ASSERT_EQ(clean.rgba.size(), 80U);
  for (std::size_t i = 0; i < 80; ++i) EXPECT_EQ(clean.rgba[i], i % 4 == 1 ? 0 : 255);
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

TEST(PicturePng, RefusesAPictureThatHasNoSideOrAnotherNumberOfPixels) {
  for (const Picture& picture :
       {Picture{0, 2, {}}, Picture{2, 0, {}}, Picture{1, 1, {1, 2, 3}}, Picture{1, 1, {1, 2, 3, 4, 5}}}) {
    const auto saved = save_png(picture, scratch("none.png"));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().what, "the picture has no pixels or too few");
  }
  EXPECT_TRUE(save_png(Picture{1, 1, {1, 2, 3, 4}}, scratch("one.png")));
  EXPECT_EQ(load_picture_png(scratch("one.png"))->rgba, (std::vector<std::uint8_t>{1, 2, 3, 255}))
      << "a picture of the view is opaque";
  std::filesystem::remove(scratch("one.png"));
}

TEST(PicturePng, ASideOf16384PixelsIsTheLongestThatIsRead) {
  for (const int side : {16384, 16385}) {
    const auto path = scratch("long.png");
    ASSERT_TRUE(
        save_png(Picture{side, 1, std::vector<std::uint8_t>(static_cast<std::size_t>(side) * 4, 9)}, path));
    const auto wide = load_picture_png(path);
    ASSERT_TRUE(
        save_png(Picture{1, side, std::vector<std::uint8_t>(static_cast<std::size_t>(side) * 4, 9)}, path));
    const auto high = load_picture_png(path);
    EXPECT_EQ(wide.has_value(), side == 16384);
    EXPECT_EQ(high.has_value(), side == 16384);
    EXPECT_TRUE(wide || wide.error().what == "the picture has 16385 x 1 pixels");
    std::filesystem::remove(path);
  }
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
