// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "canvas.h"
#include "nazori/view/tablet_view.h"
#include "palette.h"
#include "projection.h"
#include "relief_mesh.h"
#include "shader_program.h"
#include "surface_picture.h"

namespace nazori::view {

/// Tablet, table and shadow: mesh and face on the GPU.
class TabletLayer {
 public:
  [[nodiscard]] static base::Result<TabletLayer> create();

  /// Sends mesh and face. An empty map leaves nothing to draw.
  void set_relief(const surface::HeightMap& map, const geometry::TabletShape& shape, const Look& look,
                  DrawStatistics& statistics);
  /// Sends the face again, and the mesh only if the hand has changed the light on its edges.
  void set_look(const surface::HeightMap& map, const Look& look, DrawStatistics& statistics);

  /// Background, shadow and tablet inside `box` of the bound framebuffer.
  /// @param ink  texture of GrooveInk, 0 for none.
  void draw(const Projection& projection, const PixelBox& box, GLuint ink);

  /// Texture of heights over the face, 255 the plateau.
  [[nodiscard]] GLuint height_texture() const { return heights_.name(); }
  [[nodiscard]] bool is_empty() const { return mesh_.tiles.empty(); }
  /// From the carved square, 0..1 each way, to the face's texture: scale and offset.
  [[nodiscard]] glm::vec2 face_from_square() const { return face_from_square_; }
  [[nodiscard]] const geometry::TabletShape& shape() const { return shape_; }
  [[nodiscard]] std::size_t triangle_count() const { return mesh_.indices.size() / 3; }

 private:
  TabletLayer(ShaderProgram tablet, ShaderProgram inked, ShaderProgram shadow);
  void send_mesh(DrawStatistics& statistics);
  void send_face(const surface::HeightMap& map, DrawStatistics& statistics);
  void draw_shadow(const Projection& projection);
  void collect_tiles(const Projection& projection, const PixelBox& box);

  ShaderProgram tablet_;
  ShaderProgram inked_;
  ShaderProgram shadow_;
  VertexArray array_;
  VertexArray empty_array_;
  Buffer vertices_;
  Buffer indices_;
  Texture face_;
  Texture heights_;
  ReliefMesh mesh_;
  std::shared_ptr<const PlainFace> plain_;
  geometry::TabletShape shape_;
  Look look_;
  glm::vec2 face_from_square_{1, 0};
  std::uint32_t board_first_ = 0;
  std::uint32_t board_count_ = 0;
  std::vector<GLsizei> counts_;         ///< of the tiles to draw
  std::vector<const void*> positions_;  ///< of the tiles to draw, in the index buffer
};

}  // namespace nazori::view
