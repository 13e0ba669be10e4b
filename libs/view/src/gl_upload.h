// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <span>

#include "gl_object.h"
#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// The only functions that send vertices and pixels to the GPU; each call is counted.
template <class T>
void upload(const Buffer& buffer, GLenum target, std::span<const T> data, DrawStatistics& statistics) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STATIC_DRAW);
  ++statistics.buffer_uploads;
}

/// Pixels of a texture and how they are laid out.
struct TexelLayout {
  GLint internal_format;
  GLenum format;
  int width;
  int height;
  bool mipmaps;  ///< only of GL_RGBA
};

/// Leaves the texture bound to unit 0.
void upload(const Texture& texture, const TexelLayout& layout, std::span<const std::uint8_t> texels,
            DrawStatistics& statistics);

/// Makes an empty texture as a render target, filtered linearly.
void allocate(const Texture& texture, GLint internal_format, GLenum format, int width, int height);

/// One attribute of the buffer bound to GL_ARRAY_BUFFER. @param divisor  1 for one value per instance.
void attribute(GLuint index, GLint components, std::size_t stride, std::size_t offset, GLuint divisor = 0);

}  // namespace nazori::view
