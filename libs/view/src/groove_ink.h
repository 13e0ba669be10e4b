// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "canvas.h"
#include "projection.h"
#include "shader_program.h"
#include "stroke_geometry.h"

namespace nazori::view {

/// Ink on the tablet's face, as a texture into which the brush is drawn: red is sumi, green the vermilion of
/// the current stroke. New ink is added without drawing the old ink again.
class GrooveInk {
 public:
  [[nodiscard]] static base::Result<GrooveInk> create();

  void set_strokes(const StrokeGeometry& strokes, const geometry::TabletShape& shape,
                   DrawStatistics& statistics);

  /// The part of the picture that a change of ink affects.
  struct Change {
    bool everywhere = false;         ///< ink was removed or another stroke is current
    std::vector<glm::vec3> fresh_m;  ///< x, y and radius of discs that cover all fresh ink
    [[nodiscard]] bool is_none() const { return !everywhere && fresh_m.empty(); }
  };
  /// Updates the texture to `ink` (one share per stroke, 0..1).
  /// @param heights  texture of heights over the face.  @param face_from_square  scale and offset.
  Change update(std::span<const double> ink, int current_stroke, GLuint heights, glm::vec2 face_from_square);
  /// Discards all ink, so that the next update draws it again.
  void invalidate() { drawn_valid_ = false; }

  [[nodiscard]] bool has_ink() const { return has_ink_; }
  [[nodiscard]] GLuint texture() const { return texture_.name(); }

 private:
  explicit GrooveInk(ShaderProgram brush);
  void draw_stroke(std::size_t stroke, double from, double to, bool current);

  ShaderProgram brush_;
  VertexArray array_;
  Buffer pieces_;
  Texture texture_;
  Framebuffer framebuffer_;
  std::vector<InkPiece> shapes_;
  float plateau_ = 1;
  std::vector<InkRange> ranges_;
  geometry::TabletShape shape_;
  std::vector<double> drawn_;
  int drawn_current_ = 0;
  bool drawn_valid_ = false;
  bool has_ink_ = false;
};

}  // namespace nazori::view
