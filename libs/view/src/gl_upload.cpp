// SPDX-License-Identifier: Apache-2.0
#include "gl_upload.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mipmaps.h"

namespace nazori::view {
namespace {

/// glGenerateMipmap takes ten times as long where the driver draws with the processor.
template <class Send>
void send_mipmaps(const TexelLayout& layout, std::span<const std::uint8_t> texels, const Send& send) {
  int width = layout.width;
  int height = layout.height;
  std::vector<std::uint8_t> smaller;
  for (int level = 1; width > 1 || height > 1; ++level) {
    smaller = halved_picture(level == 1 ? texels : smaller, width, height);
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    send(level, width, height, smaller.data());
  }
}

}  // namespace

void upload(const Texture& texture, const TexelLayout& layout, std::span<const std::uint8_t> texels,
            DrawStatistics& statistics) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  const auto send = [&](int level, int width, int height, const std::uint8_t* data) {
    glTexImage2D(GL_TEXTURE_2D, level, layout.internal_format, width, height, 0, layout.format,
                 GL_UNSIGNED_BYTE, data);
  };
  send(0, layout.width, layout.height, texels.data());
  if (layout.mipmaps) send_mipmaps(layout, texels, send);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, layout.mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  ++statistics.texture_uploads;
}

void allocate(const Texture& texture, GLint internal_format, GLenum format, int width, int height) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void attribute(GLuint index, GLint components, std::size_t stride, std::size_t offset, GLuint divisor) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr)
  glVertexAttribDivisor(index, divisor);
}

}  // namespace nazori::view
