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
  allocate(parts_->picture, GL_RGBA8, GL_RGBA, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, parts_->resolved.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, parts_->picture.name(), 0);
  glBindRenderbuffer(GL_RENDERBUFFER, parts_->depth.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, parts_->depth.name());
  const bool resolved = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (resolved) return true;
  parts_.reset();
  return false;
}

void Canvas::make_samples() {
  parts_->samples = std::make_unique<Samples>();
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const GLint count = std::min(most, kSamples);
  const Samples& made = *parts_->samples;
  glBindRenderbuffer(GL_RENDERBUFFER, made.colour.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_RGBA8, width_, height_);
  glBindRenderbuffer(GL_RENDERBUFFER, made.depth.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH_COMPONENT24, width_, height_);
  glBindFramebuffer(GL_FRAMEBUFFER, made.framebuffer.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, made.colour.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, made.depth.name());
  parts_->samples_refused = glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE;
  if (parts_->samples_refused) parts_->samples.reset();
}

bool Canvas::bind_tablet(bool quick) {
  if (!quick && !parts_->samples && !parts_->samples_refused) make_samples();
  const bool sampled = !quick && parts_->samples != nullptr;
  glBindFramebuffer(GL_FRAMEBUFFER, sampled ? parts_->samples->framebuffer.name() : parts_->resolved.name());
  return sampled;
}

void Canvas::free_samples() { parts_->samples.reset(); }

void Canvas::resolve(const PixelBox& box) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, parts_->samples->framebuffer.name());
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
