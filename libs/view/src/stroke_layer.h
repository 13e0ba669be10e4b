// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "canvas.h"
#include "number_labels.h"
#include "number_layout.h"
#include "projection.h"
#include "shader_program.h"
#include "stroke_geometry.h"
#include "tablet_layer.h"

namespace nazori::view {

/// Which parts of the strokes are drawn.
struct StrokeChoice {
  bool lines = false;
  bool heads = true;
  bool numbers = true;
  double lines_opacity = 1;
  int current = 0;
  double scale = 1;  ///< device pixels per logical pixel
  double text_scale = 1;
  friend bool operator==(const StrokeChoice&, const StrokeChoice&) = default;
};

/// Centre lines, arrowheads and numbers, over the tablet and never behind it.
class StrokeLayer {
 public:
  [[nodiscard]] static base::Result<StrokeLayer> create();

  void set_strokes(const StrokeGeometry& strokes, const geometry::TabletShape& shape,
                   DrawStatistics& statistics);
  /// Draws inside `box` of the bound framebuffer.
  void draw(const Projection& projection, const PixelBox& box, const Look& look, const StrokeChoice& choice,
            DrawStatistics& statistics);
  /// Draws again those numbers of the last draw that touch the line from `from` to `to` [pixels, y down],
  /// `reach` wide on both sides, so that later drawing does not hide them.
  void draw_numbers_again(const Projection& projection, const Look& look, const StrokeChoice& choice,
                          glm::dvec2 from, glm::dvec2 to, double reach);
  /// The numbers of the last draw.
  [[nodiscard]] std::span<const NumberPlace> numbers() const { return numbers_; }

 private:
  StrokeLayer(ShaderProgram line, ShaderProgram head, ShaderProgram disc);
  void draw_ways(const Projection& projection, const Look& look, const StrokeChoice& choice);
  void draw_lines(const VertexArray& array, std::size_t count, float half_width, Colour colour, int current);
  void draw_heads(const Projection& projection, float size, float grow, Colour colour, int current);
  void draw_numbers(const Projection& projection, const Look& look, const StrokeChoice& choice,
                    DrawStatistics& statistics);
  void prepare_discs(const Projection& projection, const Look& look, const StrokeChoice& choice);
  void draw_disc(const Projection& projection, const NumberPlace& place);

  ShaderProgram line_;
  ShaderProgram head_;
  ShaderProgram disc_;
  VertexArray lines_array_;
  VertexArray heads_array_;
  VertexArray classic_array_;
  VertexArray empty_array_;
  Buffer lines_;
  Buffer heads_;
  Buffer classic_heads_;
  Texture labels_;
  NumberFont font_;
  LabelSheet sheet_;
  int sheet_numbers_ = 0;
  /// The number of all, and of those drawn when all strokes are shown.
  struct Count {
    std::size_t all = 0;
    std::size_t shown = 0;
    [[nodiscard]] std::size_t of(int current) const { return current > 0 ? all : shown; }
  };
  Count line_count_;
  Count head_count_;
  Count classic_count_;
  std::vector<NumberAnchor> anchors_;
  geometry::TabletShape shape_;
  std::vector<NumberPlace> numbers_;
};

}  // namespace nazori::view
