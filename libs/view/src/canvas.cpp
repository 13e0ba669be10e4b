// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"

#include <algorithm>

#include "gl_upload.h"

namespace nazori::view {
namespace {

constexpr GLint kSamples = 4;

}  // namespace

bool Canvas::resize(int width, int height) {
  if (parts_ && width == width_ && height == height_) return true;
  parts_ = std::make_unique<Parts>();
  width_ = width;
  height_ = height;
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const GLint samples = std::min(most, kSamples);
  glBindRenderbuffer(GL_RENDERBUFFER, parts_->sampled_colour.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, parts_->sampled_depth.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, parts_->sampled.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            parts_->sampled_colour.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            parts_->sampled_depth.name());
  const bool sampled = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  allocate(parts_->picture, GL_RGBA8, GL_RGBA, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, parts_->resolved.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, parts_->picture.name(), 0);
  glBindRenderbuffer(GL_RENDERBUFFER, parts_->depth.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, parts_->depth.name());
  const bool resolved = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (sampled && resolved) return true;
  parts_.reset();
  return false;
}

void Canvas::bind_tablet(bool quick) const {
  glBindFramebuffer(GL_FRAMEBUFFER, quick ? parts_->resolved.name() : parts_->sampled.name());
}

void Canvas::resolve(const PixelBox& box) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, parts_->sampled.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, parts_->resolved.name());
  const int right = box.x + box.width;
  const int top = box.y + box.height;
  glBlitFramebuffer(box.x, box.y, right, top, box.x, box.y, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, parts_->resolved.name());
}

void Canvas::show(GLuint framebuffer) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, parts_->resolved.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace nazori::view
