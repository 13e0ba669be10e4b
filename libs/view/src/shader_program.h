// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::view {

/// A linked vertex and fragment shader. The sources are GLSL 3.30 core without the version line.
class ShaderProgram {
 public:
  /// @param name  for the error text.
  /// @return Errc::device with the driver's log.
  [[nodiscard]] static base::Result<ShaderProgram> compile(std::string_view name, std::string_view vertex,
                                                           std::string_view fragment);
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const { glUseProgram(program_); }
  /// The program must be in use. A name that the shader does not have is ignored.
  void set(std::string_view name, float value);
  void set(std::string_view name, int value);
  void set(std::string_view name, glm::vec2 value);
  void set(std::string_view name, glm::vec3 value);
  void set(std::string_view name, glm::vec4 value);
  void set(std::string_view name, const glm::mat4& value);

 private:
  explicit ShaderProgram(GLuint program) : program_(program) {}
  GLint location(std::string_view name);
  GLuint program_ = 0;
  std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace nazori::view
