// SPDX-License-Identifier: Apache-2.0
#include "shader_program.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace nazori::view {
namespace {

std::string shader_log(GLuint shader) {
  std::array<char, 2048> text{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(text.size()), nullptr, text.data());
  return text.data();
}

GLuint compile_stage(GLenum stage, std::string_view source, std::string& log) {
  constexpr std::string_view kVersion = "#version 330 core\n";
  const std::array<const char*, 2> parts{kVersion.data(), source.data()};
  const std::array<GLint, 2> lengths{static_cast<GLint>(kVersion.size()), static_cast<GLint>(source.size())};
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 2, parts.data(), lengths.data());
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return shader;
  log += shader_log(shader);
  glDeleteShader(shader);
  return 0;
}

}  // namespace

base::Result<ShaderProgram> ShaderProgram::compile(std::string_view name, std::string_view vertex,
                                                   std::string_view fragment) {
  std::string log;
  const GLuint vertex_stage = compile_stage(GL_VERTEX_SHADER, vertex, log);
  const GLuint fragment_stage = compile_stage(GL_FRAGMENT_SHADER, fragment, log);
  GLuint program = 0;
  if (vertex_stage != 0 && fragment_stage != 0) {
    program = glCreateProgram();
    glAttachShader(program, vertex_stage);
    glAttachShader(program, fragment_stage);
    glLinkProgram(program);
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (done != GL_TRUE) {
      std::array<char, 2048> text{};
      glGetProgramInfoLog(program, static_cast<GLsizei>(text.size()), nullptr, text.data());
      log += text.data();
      glDeleteProgram(program);
      program = 0;
    }
  }
  glDeleteShader(vertex_stage);
  glDeleteShader(fragment_stage);
  if (program == 0) {
    return base::fail(base::Errc::device, fmt::format("the graphics driver refuses a shader: {}", log),
                      std::string(name), "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
  return ShaderProgram(program);
}

ShaderProgram::~ShaderProgram() {
  if (program_ != 0) glDeleteProgram(program_);
}
ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : program_(std::exchange(other.program_, 0)), locations_(std::move(other.locations_)) {}
ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(program_, other.program_);
  std::swap(locations_, other.locations_);
  return *this;
}

GLint ShaderProgram::location(std::string_view name) {
  const auto known = locations_.find(name);
  if (known != locations_.end()) return known->second;
  const std::string text(name);
  return locations_.emplace(text, glGetUniformLocation(program_, text.c_str())).first->second;
}

void ShaderProgram::set(std::string_view name, float value) { glUniform1f(location(name), value); }
void ShaderProgram::set(std::string_view name, int value) { glUniform1i(location(name), value); }
void ShaderProgram::set(std::string_view name, glm::vec2 value) {
  glUniform2f(location(name), value.x, value.y);
}
void ShaderProgram::set(std::string_view name, glm::vec3 value) {
  glUniform3f(location(name), value.x, value.y, value.z);
}
void ShaderProgram::set(std::string_view name, glm::vec4 value) {
  glUniform4f(location(name), value.x, value.y, value.z, value.w);
}
void ShaderProgram::set(std::string_view name, const glm::mat4& value) {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
}

}  // namespace nazori::view
