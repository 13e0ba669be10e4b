// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "projection.h"
#include "shader_program.h"
#include "tablet_layer.h"

namespace nazori::view {

/// The stylus: a writing brush (classic: a green cone) whose tip is the proxy, its shadow, and the device's
/// own point where that differs. Drawn directly into the displayed picture, so that moving it costs little.
class CursorLayer {
 public:
  [[nodiscard]] static base::Result<CursorLayer> create(DrawStatistics& statistics);

  /// The area that the stylus covers: the line from tip to end [pixels, y down] and its half width.
  struct Trace {
    glm::dvec2 tip{0};
    glm::dvec2 end{0};
    double reach = 0;
  };
  /// @param current  the stroke being written is the current one: the brush has its colour.
  /// @param scale  device pixels per logical pixel.
  Trace draw(const Projection& projection, const Cursor& cursor, const Look& look, bool current,
             double scale);

 private:
  struct Body {
    std::size_t first_ring = 0;  ///< bands between rings, counted over all bodies
    std::size_t rings = 0;
  };
  CursorLayer(ShaderProgram body, ShaderProgram mark);
  void send_bodies(DrawStatistics& statistics);
  void draw_body(const Projection& projection, const Body& body, glm::dvec3 tip_m, glm::dvec3 axis,
                 double length_m, double opacity);
  void mark(const Projection& projection, glm::dvec2 from, glm::dvec2 to, glm::vec4 size, glm::vec4 colour);

  ShaderProgram body_;
  ShaderProgram mark_;
  VertexArray array_;
  VertexArray empty_array_;
  Buffer vertices_;
  Buffer indices_;
  Body brush_;
  Body cone_;
};

}  // namespace nazori::view
