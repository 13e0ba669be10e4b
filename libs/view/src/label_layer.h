// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "canvas.h"
#include "nazori/geometry/label.h"
#include "number_labels.h"
#include "projection.h"
#include "shader_program.h"
#include "stroke_layer.h"
#include "tablet_layer.h"

namespace nazori::view {

/// Texts beside points of the face. They face the learner and have an edge in the colour of their ground, so
/// that they can be read over any material.
class LabelLayer {
 public:
  [[nodiscard]] static base::Result<LabelLayer> create();

  void set_labels(std::vector<geometry::Label> labels);
  /// Draws inside `box` of the bound framebuffer.
  void draw(const Projection& projection, const PixelBox& box, const Look& look, const StrokeChoice& choice,
            DrawStatistics& statistics);
  /// The labels of the last draw.
  [[nodiscard]] std::span<const LabelPlace> places() const { return places_; }

 private:
  explicit LabelLayer(ShaderProgram text) : text_(std::move(text)) {}
  void draw_pictures(int height, int edge, DrawStatistics& statistics);
  void lay_out(const Projection& projection, double gap);

  /// Where a label lies in the texture, from its top, in texels.
  struct Cut {
    int top = 0;
    int width = 0;
    int height = 0;
  };

  ShaderProgram text_;
  VertexArray empty_array_;
  Texture texture_;
  NumberFont font_;
  std::vector<geometry::Label> labels_;
  std::vector<Cut> cuts_;
  int drawn_height_ = 0;
  int drawn_edge_ = 0;
  bool stale_ = false;
  std::vector<LabelPlace> places_;
};

}  // namespace nazori::view
