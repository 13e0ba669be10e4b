// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "projection.h"
#include "shader_program.h"
#include "tablet_layer.h"

namespace nazori::view {

/// The learner's own writing, flat on the tablet's face, with the verdict on each stroke. Drawn directly into
/// the displayed picture, so that a stroke being written does not require a new picture of the tablet.
class WritingLayer {
 public:
  [[nodiscard]] static base::Result<WritingLayer> create();

  /// Draws the writing and the cross under it. @param scale  device pixels per logical pixel.
  void draw(const Projection& projection, const Overlay& overlay, const Look& look, double scale,
            double text_scale, DrawStatistics& statistics);
  /// The signs of the last draw.
  [[nodiscard]] std::span<const SignPlace> signs() const { return signs_; }

 private:
  /// A piece of a stroke in the layout of the GPU.
  struct Piece {
    glm::vec2 from_m;
    glm::vec2 to_m;
    glm::vec2 radius_m;
    glm::vec4 colour;
    friend bool operator==(const Piece&, const Piece&) = default;
  };
  WritingLayer(ShaderProgram ink, ShaderProgram sign);
  static std::vector<Piece> dashes_of(WritingCross cross, const glm::vec4& colour);
  void place_signs(const Projection& projection, std::span<const InkedStroke> strokes, double radius);
  void draw_sign(const Projection& projection, const SignPlace& place, const Look& look, double scale);

  ShaderProgram ink_;
  ShaderProgram sign_;
  VertexArray array_;
  VertexArray empty_array_;
  Buffer buffer_;
  std::vector<Piece> sent_;
  std::vector<SignPlace> signs_;
};

}  // namespace nazori::view
