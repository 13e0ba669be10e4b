// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <memory>

#include "gl_object.h"

namespace nazori::view {

/// A rectangle of pixels, y up as OpenGL counts. Empty where it has no width.
struct PixelBox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  [[nodiscard]] bool is_empty() const { return width <= 0 || height <= 0; }
};

/// The picture that is kept between draws: the tablet is drawn with four samples a pixel and resolved, or
/// directly with one sample where speed matters more; lines and numbers (which smooth their own edges) are
/// drawn over it.
class Canvas {
 public:
  /// Keeps the pixels if the size is unchanged. @return false when the GPU refuses framebuffers of this size.
  bool resize(int width, int height);
  /// Binds the framebuffer for the tablet. @param quick  one sample a pixel: the picture itself.
  /// @return whether it has several samples and so needs resolve(). The GPU may refuse them.
  bool bind_tablet(bool quick);
  /// Frees the memory of the samples until bind_tablet() needs them again.
  void free_samples();
  /// Resolves `box` of the tablet, then binds the resolved picture.
  void resolve(const PixelBox& box) const;
  /// Copies the resolved picture into `framebuffer` at the origin and leaves it bound.
  void show(GLuint framebuffer) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  struct Samples {
    Framebuffer framebuffer;
    Renderbuffer colour;
    Renderbuffer depth;
  };
  struct Parts {
    Framebuffer resolved;
    Texture picture;
    Renderbuffer depth;
    std::unique_ptr<Samples> samples;
    bool samples_refused = false;
  };
  void make_samples();
  std::unique_ptr<Parts> parts_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace nazori::view
