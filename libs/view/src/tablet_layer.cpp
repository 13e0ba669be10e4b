// SPDX-License-Identifier: Apache-2.0
#include "tablet_layer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>

#include "board_mesh.h"
#include "gl_upload.h"

namespace nazori::view {
namespace {

constexpr float kMeshTolerance = 0.008F;
constexpr int kCoarseGrid = 256;
constexpr int kFineGrid = 512;
constexpr int kCoarseMap = 160;

constexpr const char* kVertex = R"glsl(
layout(location = 0) in vec4 corner;  // x, y, z in metres; light relative to the plateau
uniform mat4 clip_from_tablet;
uniform vec3 face;                    // 1 / width, scale and offset of the face's texture
out vec2 uv;
out float light;
void main() {
  vec2 square = vec2(corner.x, -corner.y) * face.x + 0.5;
  uv = square * face.y + face.z;
  light = corner.w;
  gl_Position = clip_from_tablet * vec4(corner.xyz, 1.0);
}
)glsl";

constexpr const char* kFragment = R"glsl(
in vec2 uv;
in float light;
uniform sampler2D face_picture;
out vec4 colour;
void main() { colour = vec4(texture(face_picture, uv).rgb * light, 1.0); }
)glsl";

constexpr const char* kInkedFragment = R"glsl(
in vec2 uv;
in float light;
uniform sampler2D face_picture;
uniform sampler2D ink;
uniform vec4 sumi;        // colour and gloss
uniform vec3 vermilion;
uniform float light_range;
out vec4 colour;
void main() {
  vec4 face = texture(face_picture, uv);
  vec2 wet = texture(ink, uv).rg;
  float falls = face.a * light_range;
  float gloss = max(falls - 0.80, 0.0);
  vec3 black = sumi.rgb * (0.45 + 0.55 * falls) + sumi.a * gloss * gloss * 9.0;
  vec3 red = vermilion * (0.42 + 0.58 * falls) + sumi.a * gloss * gloss * 5.0;
  vec3 shown = mix(mix(face.rgb, black, wet.r * 0.94), red, wet.g * 0.92);
  colour = vec4(shown * light, 1.0);
}
)glsl";

/// The board's shadow on the table: the distance to a rounded square, softened.
constexpr const char* kShadowVertex = R"glsl(
uniform mat4 clip_from_tablet;
uniform vec4 square;  // half side, corner radius, reach of the shadow, height of the table
uniform vec2 offset;
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = corner * (square.x + square.z);
  gl_Position = clip_from_tablet * vec4(place + offset, square.w, 1.0);
}
)glsl";

constexpr const char* kShadowFragment = R"glsl(
in vec2 place;
uniform vec4 square;
uniform float darkness;
out vec4 colour;
void main() {
  vec2 beyond = abs(place) - (square.x - square.y);
  float distance = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - square.y;
  float fade = clamp(0.5 - 0.5 * distance / square.z, 0.0, 1.0);
  colour = vec4(vec3(0.07, 0.055, 0.04), darkness * fade * fade * (3.0 - 2.0 * fade) * 1.25);
}
)glsl";

}  // namespace

TabletLayer::TabletLayer(ShaderProgram tablet, ShaderProgram inked, ShaderProgram shadow)
    : tablet_(std::move(tablet)), inked_(std::move(inked)), shadow_(std::move(shadow)) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  attribute(0, 4, sizeof(glm::vec4), 0);
  glBindVertexArray(0);
}

base::Result<TabletLayer> TabletLayer::create() {
  auto tablet = ShaderProgram::compile("tablet", kVertex, kFragment);
  if (!tablet) return tl::unexpected(tablet.error());
  auto inked = ShaderProgram::compile("inked tablet", kVertex, kInkedFragment);
  if (!inked) return tl::unexpected(inked.error());
  auto shadow = ShaderProgram::compile("shadow", kShadowVertex, kShadowFragment);
  if (!shadow) return tl::unexpected(shadow.error());
  return TabletLayer(std::move(*tablet), std::move(*inked), std::move(*shadow));
}

void TabletLayer::set_relief(const surface::HeightMap& map, const geometry::TabletShape& shape,
                             const Look& look, DrawStatistics& statistics) {
  shape_ = shape;
  look_ = look;
  mesh_ = {};
  if (!map.is_loaded()) return;
  const int grid = map.size() <= kCoarseMap ? kCoarseGrid : kFineGrid;
  mesh_ = make_relief_mesh(resampled(map, grid + 1), kMeshTolerance);
  send_mesh(statistics);
  send_face(map, statistics);
}

void TabletLayer::set_look(const surface::HeightMap& map, const Look& look, DrawStatistics& statistics) {
  const bool new_edges = look.hand != look_.hand;
  look_ = look;
  if (is_empty()) return;
  if (new_edges) send_mesh(statistics);
  send_face(map, statistics);
}

void TabletLayer::send_mesh(DrawStatistics& statistics) {
  std::vector<glm::vec4> vertices;
  vertices.reserve(mesh_.vertices.size());
  for (const MeshVertex& v : mesh_.vertices) {
    vertices.emplace_back((static_cast<double>(v.column) / mesh_.grid - 0.5) * shape_.width_m,
                          (0.5 - static_cast<double>(v.row) / mesh_.grid) * shape_.width_m,
                          (v.height / 65535.0 - 1) * shape_.depth_m, 1.0F);
  }
  const auto first = static_cast<std::uint32_t>(vertices.size());
  const BoardMesh board = make_board_mesh(mesh_, shape_, look_.hand);
  vertices.insert(vertices.end(), board.vertices.begin(), board.vertices.end());
  std::vector<std::uint32_t> indices = mesh_.indices;
  board_first_ = static_cast<std::uint32_t>(indices.size());
  board_count_ = static_cast<std::uint32_t>(board.indices.size());
  for (const std::uint32_t index : board.indices) indices.push_back(index + first);
  glBindVertexArray(array_.name());
  upload(vertices_, GL_ARRAY_BUFFER, std::span<const glm::vec4>(vertices), statistics);
  upload(indices_, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(indices), statistics);
  glBindVertexArray(0);
}

void TabletLayer::send_face(const surface::HeightMap& map, DrawStatistics& statistics) {
  SurfacePicture face;
  if (look_.style == Style::classic) {
    face = grey_picture(map);
  } else {
    plain_ = shared_plain_face(look_, shaded_size(map.size()));
    face = lit_picture(map, shape_, *plain_);
  }
  upload(face_, {GL_RGBA8, GL_RGBA, face.size, face.size, true}, face.rgba, statistics);
  upload(heights_, {GL_R8, GL_RED, face.size, face.size, false}, face.heights, statistics);
  // Samples sit in the middle of texels; the square spans from the first sample to the last.
  const double samples = face.size - 2 * face.rim;
  face_from_square_ = {(samples - 1) / face.size, (face.rim + 0.5) / face.size};
}

/// The tiles that can be seen in `box`; all of them where it is the whole viewport.
void TabletLayer::collect_tiles(const Projection& projection, const PixelBox& box) {
  counts_.clear();
  positions_.clear();
  const bool whole = box.width >= projection.width && box.height >= projection.height;
  for (const MeshTile& tile : mesh_.tiles) {
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    for (int corner = 0; corner < 8 && !whole; ++corner) {
      const double column = tile.bounds[(corner & 1) != 0 ? 2 : 0];
      const double row = tile.bounds[(corner & 2) != 0 ? 3 : 1];
      const glm::dvec3 point((column / mesh_.grid - 0.5) * shape_.width_m,
                             (0.5 - row / mesh_.grid) * shape_.width_m,
                             (corner & 4) != 0 ? -shape_.depth_m : 0.0);
      const glm::dvec2 pixel = projection.pixel(point);
      const glm::dvec2 upward(pixel.x, projection.height - pixel.y);
      low = glm::min(low, upward);
      high = glm::max(high, upward);
    }
    const bool outside = !whole && (high.x < box.x - 1 || high.y < box.y - 1 ||
                                    low.x > box.x + box.width + 1 || low.y > box.y + box.height + 1);
    if (outside) continue;
    counts_.push_back(static_cast<GLsizei>(tile.index_count));
    positions_.push_back(reinterpret_cast<const void*>(  // NOLINT(performance-no-int-to-ptr)
        static_cast<std::uintptr_t>(tile.first_index) * sizeof(std::uint32_t)));
  }
  if (look_.style != Style::classic) {
    counts_.push_back(static_cast<GLsizei>(board_count_));
    positions_.push_back(reinterpret_cast<const void*>(  // NOLINT(performance-no-int-to-ptr)
        static_cast<std::uintptr_t>(board_first_) * sizeof(std::uint32_t)));
  }
}

void TabletLayer::draw_shadow(const Projection& projection) {
  const Palette& colours = palette(look_.style, look_.theme);
  if (colours.shadow <= 0) return;
  const double half = shape_.width_m * (0.5 + kRimFraction);
  const double thickness = board_thickness_m(shape_);
  const glm::vec3 light = light_direction(look_.hand);
  const double throw_m = thickness * 0.55 / light.z;
  glBindVertexArray(empty_array_.name());
  shadow_.use();
  shadow_.set("clip_from_tablet", glm::mat4(projection.clip_from_tablet));
  shadow_.set("square", glm::vec4(half, board_corner_m(shape_), shape_.width_m * 0.07, -thickness));
  shadow_.set("offset", glm::vec2(-light.x * throw_m, -light.y * throw_m));
  shadow_.set("darkness", colours.shadow);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void TabletLayer::draw(const Projection& projection, const PixelBox& box, GLuint ink) {
  const Palette& colours = palette(look_.style, look_.theme);
  glViewport(0, 0, projection.width, projection.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.x, box.y, box.width, box.height);
  glClearColor(colours.background.r, colours.background.g, colours.background.b, 1);
  glClearDepth(1);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!is_empty()) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    collect_tiles(projection, box);
    ShaderProgram& program = ink != 0 ? inked_ : tablet_;
    program.use();
    program.set("clip_from_tablet", glm::mat4(projection.clip_from_tablet));
    program.set("face", glm::vec3(1 / shape_.width_m, face_from_square_.x, face_from_square_.y));
    program.set("face_picture", 0);
    if (ink != 0) {
      program.set("ink", 1);
      program.set("sumi", glm::vec4(colours.ink, colours.ink_gloss));
      program.set("vermilion", colours.current_ink);
      program.set("light_range", std::pow(kLightRange, 1 / 2.2F));
      glActiveTexture(GL_TEXTURE1);
      glBindTexture(GL_TEXTURE_2D, ink);
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, face_.name());
    glBindVertexArray(array_.name());
    glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, positions_.data(),
                        static_cast<GLsizei>(counts_.size()));
    glDisable(GL_CULL_FACE);
    draw_shadow(projection);
    glDisable(GL_DEPTH_TEST);
  }
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
}

}  // namespace nazori::view
