// SPDX-License-Identifier: Apache-2.0
#include "groove_ink.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gl_upload.h"

namespace nazori::view {
namespace {

constexpr int kTextureSize = 1024;

constexpr const char* kVertex = R"glsl(
layout(location = 0) in vec4 ends;     // from, to in metres
layout(location = 1) in vec4 brush;    // radius and arc length at both ends, in metres
uniform vec3 face;                     // 1 / width, scale and offset of the face's texture
uniform float front;                   // arc length that the ink has reached
uniform float soft;                    // softness of the edge in metres
out vec2 place;
out vec2 along;
flat out vec4 piece;
flat out vec2 radius;
void main() {
  float part = brush.w > brush.z ? clamp((front - brush.z) / (brush.w - brush.z), 0.0, 1.0) : 1.0;
  vec2 from = ends.xy;
  vec2 to = mix(ends.xy, ends.zw, part);
  float r = max(brush.x, brush.y) + soft;
  vec2 way = ends.zw - ends.xy;
  vec2 forward = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
  vec2 aside = vec2(-forward.y, forward.x);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = (corner.x < 0.0 ? from - forward * r : to + forward * r) + aside * corner.y * r;
  along = brush.zw;
  piece = vec4(from, to);
  radius = vec2(brush.x, mix(brush.x, brush.y, part));
  vec2 square = vec2(place.x, -place.y) * face.x + 0.5;
  gl_Position = vec4((square * face.y + face.z) * 2.0 - 1.0, 0.0, 1.0);
}
)glsl";

/// The relief determines the edge of the ink: it ends before the rim of the groove.
constexpr const char* kFragment = R"glsl(
in vec2 place;
in vec2 along;
flat in vec4 piece;
flat in vec2 radius;
uniform sampler2D heights;
uniform vec3 face;
uniform float soft;
uniform float plateau;
uniform vec2 which;   // sumi or vermilion
out vec4 colour;
void main() {
  vec2 way = piece.zw - piece.xy;
  float squared = dot(way, way);
  float t = squared > 0.0 ? clamp(dot(place - piece.xy, way) / squared, 0.0, 1.0) : 0.0;
  float distance = length(place - piece.xy - way * t);
  float reach = mix(radius.x, radius.y, t);
  float inside = clamp((reach - distance) / soft + 0.5, 0.0, 1.0);
  vec2 square = vec2(place.x, -place.y) * face.x + 0.5;
  float height = texture(heights, square * face.y + face.z).r;
  float groove = 1.0 - smoothstep(0.90, 0.975, height / plateau);
  float wet = inside * groove;
  colour = vec4(which * wet, 0.0, 1.0);
}
)glsl";

}  // namespace

GrooveInk::GrooveInk(ShaderProgram brush) : brush_(std::move(brush)) {
  allocate(texture_, GL_RG8, GL_RG, kTextureSize, kTextureSize);
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
}

base::Result<GrooveInk> GrooveInk::create() {
  auto brush = ShaderProgram::compile("ink", kVertex, kFragment);
  if (!brush) return tl::unexpected(brush.error());
  return GrooveInk(std::move(*brush));
}

void GrooveInk::set_strokes(const StrokeGeometry& strokes, const geometry::TabletShape& shape,
                            DrawStatistics& statistics) {
  shapes_ = strokes.ink;
  plateau_ = strokes.plateau;
  ranges_ = strokes.ink_ranges;
  shape_ = shape;
  drawn_valid_ = false;
  if (shapes_.empty()) return;
  upload(pieces_, GL_ARRAY_BUFFER, std::span<const InkPiece>(shapes_), statistics);
}

void GrooveInk::draw_stroke(std::size_t stroke, double from, double to, bool current) {
  const InkRange& range = ranges_[stroke];
  const double from_m = from * range.length_m;
  const double to_m = to * range.length_m;
  std::size_t first = range.first;
  std::size_t last = range.first + range.count;
  while (first + 1 < last && shapes_[first].along_m.y < from_m) ++first;
  while (last > first + 1 && shapes_[last - 1].along_m.x > to_m) --last;
  // Instances start where the attributes point: OpenGL 3.3 has no base instance.
  glBindBuffer(GL_ARRAY_BUFFER, pieces_.name());
  const std::size_t offset = first * sizeof(InkPiece);
  attribute(0, 4, sizeof(InkPiece), offset + offsetof(InkPiece, from_m), 1);
  attribute(1, 4, sizeof(InkPiece), offset + offsetof(InkPiece, radius_m), 1);
  brush_.set("front", static_cast<float>(to_m));
  brush_.set("which", current ? glm::vec2(0, 1) : glm::vec2(1, 0));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(last - first));
}

GrooveInk::Change GrooveInk::update(std::span<const double> ink, int current_stroke, GLuint heights,
                                    glm::vec2 face_from_square) {
  std::vector<double> wanted(ranges_.size(), 0.0);
  for (std::size_t i = 0; i < wanted.size() && i < ink.size(); ++i)
    wanted[i] = std::isfinite(ink[i]) ? std::clamp(ink[i], 0.0, 1.0) : 0.0;

  Change change;
  const auto started = [](std::span<const double> shares, int stroke) {
    return stroke > 0 && static_cast<std::size_t>(stroke) <= shares.size() &&
           shares[static_cast<std::size_t>(stroke) - 1] > 0;
  };
  change.everywhere = !drawn_valid_ || drawn_.size() != wanted.size();
  if (!change.everywhere && drawn_current_ != current_stroke)
    change.everywhere = started(drawn_, drawn_current_) || started(drawn_, current_stroke);
  for (std::size_t i = 0; i < wanted.size() && !change.everywhere; ++i)
    change.everywhere = wanted[i] < drawn_[i];
  if (change.everywhere) drawn_.assign(wanted.size(), 0.0);

  const bool had_ink = has_ink_;  // including the previous strokes, whose ink is still in the texture
  drawn_current_ = current_stroke;
  drawn_valid_ = true;
  has_ink_ = std::any_of(wanted.begin(), wanted.end(), [](double share) { return share > 0; });
  if (change.everywhere && !has_ink_ && !had_ink) return change;
  if (!change.everywhere && wanted == drawn_) return change;

  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, kTextureSize, kTextureSize);
  glDisable(GL_SCISSOR_TEST);
  if (change.everywhere) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  glBindVertexArray(array_.name());
  brush_.use();
  brush_.set("face", glm::vec3(1 / shape_.width_m, face_from_square.x, face_from_square.y));
  brush_.set("soft", static_cast<float>(shape_.width_m / kTextureSize * 1.5));
  brush_.set("plateau", plateau_);
  brush_.set("heights", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, heights);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] <= drawn_[i]) continue;
    draw_stroke(i, drawn_[i], wanted[i], static_cast<int>(i) + 1 == current_stroke);
    const InkRange& range = ranges_[i];
    for (std::size_t k = range.first; k < range.first + range.count && !change.everywhere; ++k) {
      const InkPiece& piece = shapes_[k];
      if (piece.along_m.y < drawn_[i] * range.length_m || piece.along_m.x > wanted[i] * range.length_m)
        continue;
      change.fresh_m.emplace_back(piece.from_m, piece.radius_m.x);
      change.fresh_m.emplace_back(piece.to_m, piece.radius_m.y);
    }
  }
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  drawn_ = std::move(wanted);
  return change;
}

}  // namespace nazori::view
