// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "../src/canvas.h"
#include "../src/gl_object.h"
#include "../src/gl_upload.h"
#include "../src/shader_program.h"
#include "nazori/view/offscreen.h"

namespace nazori::view {
namespace {

class Gl : public testing::Test {
 protected:
  std::unique_ptr<OffscreenContext> context_ = OffscreenContext::create(8, 8).value();
};

TEST_F(Gl, AnObjectOwnsItsNameAndGivesItBack) {
  GLuint name = 0;
  {
    Texture texture;
    name = texture.name();
    ASSERT_NE(name, 0U);
    glBindTexture(GL_TEXTURE_2D, name);
    Texture other(std::move(texture));
    EXPECT_EQ(other.name(), name);
    Texture third;
    const GLuint own = third.name();
    third = std::move(other);
    EXPECT_EQ(third.name(), name);
    EXPECT_NE(own, name);
    EXPECT_TRUE(glIsTexture(name));
  }
  EXPECT_FALSE(glIsTexture(name));
}

TEST_F(Gl, EachKindOfObjectIsMadeAndDestroyed) {
  GLuint names[4] = {};
  {
    const Buffer buffer;
    const VertexArray array;
    const Framebuffer framebuffer;
    const Renderbuffer renderbuffer;
    glBindBuffer(GL_ARRAY_BUFFER, names[0] = buffer.name());
    glBindVertexArray(names[1] = array.name());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, names[2] = framebuffer.name());
    glBindRenderbuffer(GL_RENDERBUFFER, names[3] = renderbuffer.name());
    EXPECT_TRUE(glIsBuffer(names[0]) && glIsVertexArray(names[1]) && glIsFramebuffer(names[2]) &&
                glIsRenderbuffer(names[3]));
  }
  EXPECT_FALSE(glIsBuffer(names[0]) || glIsVertexArray(names[1]) || glIsFramebuffer(names[2]) ||
               glIsRenderbuffer(names[3]));
}

constexpr const char* kVertex = "void main() { gl_Position = vec4(0.0); }\n";
constexpr const char* kFragment =
    R"(uniform float one; uniform int two; uniform vec2 three; uniform vec3 four;
uniform vec4 five; uniform mat4 six; out vec4 colour;
void main() { colour = vec4(one, float(two), three.x + four.y, five.z) + six * five; }
)";

TEST_F(Gl, AShaderThatTheDriverRefusesIsNamedInItsWords) {
  for (const auto& [vertex, fragment] : {std::pair{"nonsense", kFragment}, {kVertex, "nonsense"}}) {
    const auto program = ShaderProgram::compile("brush", vertex, fragment);
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().code, base::Errc::device);
    EXPECT_EQ(program.error().where, "brush");
    EXPECT_GT(program.error().what.size(), std::string("the graphics driver refuses a shader: ").size() + 5);
  }
  // Each shader is valid, but the fragment shader needs other inputs than the vertex shader gives.
  const auto unlinked = ShaderProgram::compile(
      "pair", "out vec2 given; void main() { given = vec2(1.0); gl_Position = vec4(0.0); }",
      "in vec3 given; out vec4 c; void main() { c = vec4(given, 1.0); }");
  ASSERT_FALSE(unlinked);
  EXPECT_EQ(unlinked.error().where, "pair");
  EXPECT_GT(unlinked.error().what.size(), std::string("the graphics driver refuses a shader: ").size() + 5);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Gl, AProgramTakesValuesOfEveryKind) {
  ShaderProgram program = ShaderProgram::compile("all", kVertex, kFragment).value();
  program.use();
  GLint name = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &name);
  const auto id = static_cast<GLuint>(name);
  for (int round = 0; round < 2; ++round) {  // names are looked up once
    program.set("one", 1.5F);
    program.set("two", 7);
    program.set("three", glm::vec2(1, 2));
    program.set("four", glm::vec3(3, 4, 5));
    program.set("five", glm::vec4(6, 7, 8, 9));
    glm::mat4 matrix(0);
    matrix[1][2] = 4;
    program.set("six", matrix);
    program.set("none", 3.0F);
  }
  const auto value = [&](const char* uniform) {
    std::array<float, 16> values{};
    glGetUniformfv(id, glGetUniformLocation(id, uniform), values.data());
    return values;
  };
  EXPECT_EQ(value("one")[0], 1.5F);
  EXPECT_EQ(value("two")[0], 7);
  EXPECT_EQ(value("three")[0], 1);
  EXPECT_EQ(value("three")[1], 2);
  EXPECT_EQ(value("four")[1], 4);
  EXPECT_EQ(value("four")[2], 5);
  EXPECT_EQ(value("five")[2], 8);
  EXPECT_EQ(value("five")[3], 9);
  EXPECT_EQ(value("six")[6], 4) << "column by column";
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));

  ShaderProgram moved(std::move(program));
  moved.use();
  ShaderProgram other = ShaderProgram::compile("other", kVertex, kFragment).value();
  other = std::move(moved);
  other.use();
  glGetIntegerv(GL_CURRENT_PROGRAM, &name);
  EXPECT_EQ(name, static_cast<GLint>(id));
  other.set("one", 2.5F);
  EXPECT_EQ(value("one")[0], 2.5F);
  glUseProgram(0);
  { const ShaderProgram last(std::move(other)); }
  EXPECT_FALSE(glIsProgram(id));
}

TEST_F(Gl, WhatIsSentIsCountedAndArrivesWhateverWasSetBefore) {
  DrawStatistics statistics;
  const Buffer buffer;
  const std::array<float, 3> numbers{1, 2, 3};
  upload(buffer, GL_ARRAY_BUFFER, std::span<const float>(numbers), statistics);
  EXPECT_EQ(statistics.buffer_uploads, 1U);
  std::array<float, 3> back{};
  glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof back, back.data());
  EXPECT_EQ(back, numbers);

  const Buffer pixels;
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, pixels.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 17);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
  glActiveTexture(GL_TEXTURE1);
  const Texture texture;
  const std::vector<std::uint8_t> texels{10, 20, 30, 40, 50, 60};
  upload(texture, {GL_R8, GL_RED, 3, 2, false}, texels, statistics);
  EXPECT_EQ(statistics.texture_uploads, 1U);
  std::vector<std::uint8_t> seen(6);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, seen.data());
  EXPECT_EQ(seen, texels);
  GLint unit = 0, bound = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  EXPECT_EQ(unit, GL_TEXTURE0);
  EXPECT_EQ(bound, static_cast<GLint>(texture.name()));
}

GLint parameter(GLenum which) {
  GLint value = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, which, &value);
  return value;
}

GLint level(GLint number, GLenum which) {
  GLint value = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, number, which, &value);
  return value;
}

TEST_F(Gl, TexturesAreSmoothAndEndAtTheirEdge) {
  DrawStatistics statistics;
  const std::vector<std::uint8_t> texels(64, 9);
  for (const bool mipmaps : {false, true}) {
    const Texture texture;
    upload(texture, {GL_RGBA8, GL_RGBA, 4, 4, mipmaps}, texels, statistics);
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP_TO_EDGE);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_CLAMP_TO_EDGE);
    EXPECT_EQ(level(0, GL_TEXTURE_WIDTH), 4);
    EXPECT_EQ(level(1, GL_TEXTURE_WIDTH), mipmaps ? 2 : 0);
  }
  const Buffer pixels;
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, pixels.name());
  glActiveTexture(GL_TEXTURE1);
  const Texture empty;
  allocate(empty, GL_RG8, GL_RG, 5, 3);
  GLint unit = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  EXPECT_EQ(unit, GL_TEXTURE0);
  EXPECT_EQ(level(0, GL_TEXTURE_WIDTH), 5);
  EXPECT_EQ(level(0, GL_TEXTURE_HEIGHT), 3);
  EXPECT_EQ(level(0, GL_TEXTURE_INTERNAL_FORMAT), GL_RG8);
  EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR);
  EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_LINEAR);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP_TO_EDGE);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_CLAMP_TO_EDGE);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Gl, AnAttributeIsSetAsToldAndForEachVertexUnlessToldOtherwise) {
  const VertexArray array;
  const Buffer buffer;
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  attribute(3, 2, 24, 8);
  attribute(4, 4, 32, 16, 1);
  const auto of = [](GLuint index, GLenum which) {
    GLint value = -1;
    glGetVertexAttribiv(index, which, &value);
    return value;
  };
  EXPECT_EQ(of(3, GL_VERTEX_ATTRIB_ARRAY_ENABLED), 1);
  EXPECT_EQ(of(3, GL_VERTEX_ATTRIB_ARRAY_SIZE), 2);
  EXPECT_EQ(of(3, GL_VERTEX_ATTRIB_ARRAY_STRIDE), 24);
  EXPECT_EQ(of(3, GL_VERTEX_ATTRIB_ARRAY_DIVISOR), 0);
  EXPECT_EQ(of(4, GL_VERTEX_ATTRIB_ARRAY_DIVISOR), 1);
  void* offset = nullptr;
  glGetVertexAttribPointerv(4, GL_VERTEX_ATTRIB_ARRAY_POINTER, &offset);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(offset), 16U);
}

std::array<std::uint8_t, 4> pixel_of_read(int x, int y) {
  std::array<std::uint8_t, 4> rgba{};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

void fill(float red) {
  glClearColor(red, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

TEST_F(Gl, ACanvasResolvesTheBoxAskedAndShowsAll) {
  GLint screen = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &screen);
  Canvas canvas;
  ASSERT_TRUE(canvas.resize(8, 6));
  EXPECT_EQ(canvas.width(), 8);
  EXPECT_EQ(canvas.height(), 6);
  canvas.bind_tablet(true);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  fill(0);
  canvas.bind_tablet(false);
  GLint samples = 0, most = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  EXPECT_EQ(samples, std::min(most, 4));
  fill(1);
  canvas.resolve({2, 1, 3, 4});
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  canvas.bind_tablet(true);
  GLint quick = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &quick);
  EXPECT_EQ(bound, quick) << "the resolved picture is drawn on";
  canvas.resolve({2, 1, 3, 4});
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(bound, quick) << "and read";
  EXPECT_TRUE(canvas.resize(8, 6)) << "the same size keeps the pixels";
  canvas.show(static_cast<GLuint>(screen));
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(bound, screen);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(bound, screen);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(pixel_of_read(x, y)[0], x >= 2 && x < 5 && y >= 1 && y < 5 ? 255 : 0) << x << ", " << y;
}

TEST_F(Gl, ACanvasThatTheGraphicsCannotHoldIsRefused) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  Canvas canvas;
  EXPECT_FALSE(canvas.resize(most + 1, 4));
  while (glGetError() != GL_NO_ERROR) {
  }
  EXPECT_TRUE(canvas.resize(4, 4));
}

TEST(PixelBoxes, WithoutWidthOrHeightAreEmpty) {
  EXPECT_TRUE(PixelBox{}.is_empty());
  EXPECT_TRUE((PixelBox{0, 0, 0, 1}.is_empty()));
  EXPECT_TRUE((PixelBox{0, 0, 1, 0}.is_empty()));
  EXPECT_TRUE((PixelBox{0, 0, 4, -1}.is_empty()));
  EXPECT_FALSE((PixelBox{0, 0, 1, 1}.is_empty()));
}

}  // namespace
}  // namespace nazori::view
