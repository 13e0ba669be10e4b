// SPDX-License-Identifier: Apache-2.0
#include "writing_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "disc_shader.h"
#include "gl_upload.h"
#include "palette.h"

namespace nazori::view {
namespace {

constexpr double kSignRadius = 10;  ///< logical pixels, as the discs of numbers
constexpr double kSignGap = 3;
constexpr float kCrossHalfSide_m = 0.046F;  ///< of a tablet 0.1 m wide
constexpr float kCrossHalfWidth_m = 0.0001F;
constexpr float kDash_m = 0.0012F;
constexpr float kCrossOpacity = 0.38F;

/// A disc of changing radius moved along the face of the tablet.
constexpr const char* kInkVertex = R"glsl(
layout(location = 0) in vec4 ends;      // from, to in metres
layout(location = 1) in vec2 radii;     // at both ends, in metres
layout(location = 2) in vec4 tint;
uniform mat4 clip_from_tablet;
uniform float soft;                     // a pixel, in metres
out vec2 place;
flat out vec4 piece;
flat out vec2 radius;
flat out vec4 colour_of_ink;
void main() {
  vec2 way = ends.zw - ends.xy;
  vec2 forward = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
  vec2 aside = vec2(-forward.y, forward.x);
  float r = max(radii.x, radii.y) + soft;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = (corner.x < 0.0 ? ends.xy - forward * r : ends.zw + forward * r) + aside * corner.y * r;
  piece = ends;
  radius = radii;
  colour_of_ink = tint;
  gl_Position = clip_from_tablet * vec4(place, 0.0, 1.0);
}
)glsl";

constexpr const char* kInkFragment = R"glsl(
in vec2 place;
flat in vec4 piece;
flat in vec2 radius;
flat in vec4 colour_of_ink;
uniform float soft;
out vec4 colour;
void main() {
  vec2 way = piece.zw - piece.xy;
  float squared = dot(way, way);
  float t = squared > 0.0 ? clamp(dot(place - piece.xy, way) / squared, 0.0, 1.0) : 0.0;
  float outside = length(place - piece.xy - way * t) - mix(radius.x, radius.y, t);
  colour = vec4(colour_of_ink.rgb, colour_of_ink.a * clamp(0.5 - outside / soft, 0.0, 1.0));
}
)glsl";

/// A disc that faces the learner, with a cross or an exclamation mark.
constexpr const char* kSignFragment = R"glsl(
in vec2 place;
uniform vec3 disc;
uniform float ring;
uniform vec3 ground;
uniform vec3 mark;
uniform bool crossed;  // else an exclamation mark
out vec4 colour;
float to_line(vec2 p, vec2 a, vec2 b) {
  vec2 way = b - a;
  return length(p - a - way * clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0));
}
void main() {
  vec2 p = place / disc.z;
  float d;
  if (crossed) d = min(to_line(p, vec2(-0.36, -0.36), vec2(0.36, 0.36)), to_line(p, vec2(-0.36, 0.36), vec2(0.36, -0.36)));
  else d = min(to_line(p, vec2(0.0, 0.52), vec2(0.0, -0.10)), length(p - vec2(0.0, -0.48)));
  float r = length(place);
  float drawn = clamp((0.13 - d) * disc.z + 0.5, 0.0, 1.0);
  vec3 face = mix(mark, ground, clamp(disc.z - ring - r + 0.5, 0.0, 1.0));
  colour = vec4(mix(face, mark, drawn), clamp(disc.z - r + 0.5, 0.0, 1.0));
}
)glsl";

const Colour& colour_of(const WritingColours& colours, Verdict verdict) {
  switch (verdict) {
    case Verdict::nearly:
      return colours.nearly;
    case Verdict::wrong:
      return colours.wrong;
    case Verdict::shown:
      return colours.shown;
    case Verdict::right:
    case Verdict::none:
      break;
  }
  return colours.unjudged;
}

bool has_sign(const InkedStroke& stroke) {
  return (stroke.verdict == Verdict::nearly || stroke.verdict == Verdict::wrong) && !stroke.points.empty();
}

glm::vec2 place_of(const geometry::WrittenPoint<geometry::TabletFrame>& point) {
  return {point.at.x, point.at.y};
}

}  // namespace

WritingLayer::WritingLayer(ShaderProgram ink, ShaderProgram sign)
    : ink_(std::move(ink)), sign_(std::move(sign)) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  attribute(0, 4, sizeof(Piece), offsetof(Piece, from_m), 1);
  attribute(1, 2, sizeof(Piece), offsetof(Piece, radius_m), 1);
  attribute(2, 4, sizeof(Piece), offsetof(Piece, colour), 1);
  glBindVertexArray(0);
}

base::Result<WritingLayer> WritingLayer::create() {
  auto ink = ShaderProgram::compile("writing", kInkVertex, kInkFragment);
  if (!ink) return tl::unexpected(ink.error());
  auto sign = ShaderProgram::compile("sign", kDiscVertex, kSignFragment);
  if (!sign) return tl::unexpected(sign.error());
  return WritingLayer(std::move(*ink), std::move(*sign));
}

std::vector<WritingLayer::Piece> WritingLayer::dashes_of(WritingCross cross, const glm::vec4& colour) {
  std::vector<Piece> pieces;
  const auto dash = [&](glm::vec2 from, glm::vec2 to) {
    const float length = glm::distance(from, to);
    const int count = std::max(1, static_cast<int>(std::lround(length / kDash_m)) | 1);
    for (int i = 0; i < count; i += 2)
      pieces.push_back({glm::mix(from, to, static_cast<float>(i) / static_cast<float>(count)),
                        glm::mix(from, to, static_cast<float>(i + 1) / static_cast<float>(count)),
                        glm::vec2(kCrossHalfWidth_m), colour});
  };
  if (cross == WritingCross::none) return pieces;
  constexpr float kEnd = kCrossHalfSide_m;
  dash({-kEnd, 0}, {kEnd, 0});
  dash({0, kEnd}, {0, -kEnd});
  if (cross == WritingCross::halves) return pieces;
  const glm::vec2 corners[] = {{-kEnd, kEnd}, {kEnd, kEnd}, {kEnd, -kEnd}, {-kEnd, -kEnd}, {-kEnd, kEnd}};
  for (std::size_t i = 0; i + 1 < std::size(corners); ++i) dash(corners[i], corners[i + 1]);
  return pieces;
}

void WritingLayer::draw(const Projection& projection, const Overlay& overlay, const Look& look, double scale,
                        double text_scale, DrawStatistics& statistics) {
  const auto strokes = overlay.writing;
  signs_.clear();
  if (strokes.empty() && overlay.cross == WritingCross::none) return;
  const WritingColours& colours = writing_colours(look.style, look.theme);
  std::vector<Piece> pieces = dashes_of(overlay.cross, glm::vec4(colours.unjudged, kCrossOpacity));
  for (const auto& stroke : strokes) {
    const glm::vec4 colour(colour_of(colours, stroke.verdict), static_cast<float>(stroke.opacity));
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      if (i == 0 && stroke.points.size() > 1) continue;
      const std::size_t before = i == 0 ? 0 : i - 1;
      const glm::vec2 radius_m(stroke.half_width_at(before), stroke.half_width_at(i));
      pieces.push_back({place_of(stroke.points[before]), place_of(stroke.points[i]), radius_m, colour});
    }
  }
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  glBindVertexArray(array_.name());
  if (pieces != sent_) {
    upload(buffer_, GL_ARRAY_BUFFER, std::span<const Piece>(pieces), statistics);
    sent_ = std::move(pieces);
  }
  ink_.use();
  ink_.set("clip_from_tablet", glm::mat4(projection.clip_from_tablet));
  ink_.set("soft", static_cast<float>(1 / std::max(projection.pixels_per_metre(glm::dvec3(0)), 1.0)));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(sent_.size()));

  place_signs(projection, strokes, kSignRadius * scale * text_scale);
  for (const SignPlace& place : signs_) draw_sign(projection, place, look, scale);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

void WritingLayer::place_signs(const Projection& projection, std::span<const InkedStroke> strokes,
                               double radius) {
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const InkedStroke& stroke = strokes[i];
    if (!has_sign(stroke)) continue;
    const glm::dvec2 start = projection.pixel({stroke.points.front().at.x, stroke.points.front().at.y, 0});
    const glm::dvec2 end = projection.pixel({stroke.points.back().at.x, stroke.points.back().at.y, 0});
    // Before the start, in line with the stroke, so that it does not hide the stroke.
    const glm::dvec2 way = start - end;
    const double length = glm::length(way);
    const glm::dvec2 away = length > 1 ? way / length : glm::dvec2(-0.7, -0.7);
    glm::dvec2 place = start + away * (radius + kSignGap);
    // Signs of strokes that start together are moved apart.
    for (int tries = 0; tries < 8; ++tries) {
      const auto overlapping = std::find_if(signs_.begin(), signs_.end(), [&](const SignPlace& other) {
        return glm::distance(other.pixel, place) < 2 * radius;
      });
      if (overlapping == signs_.end()) break;
      place += glm::dvec2(-away.y, away.x) * (radius * 0.75);
    }
    place =
        glm::clamp(place, glm::dvec2(radius),
                   glm::max(glm::dvec2(projection.width, projection.height) - radius, glm::dvec2(radius)));
    signs_.push_back({static_cast<int>(i), stroke.verdict, place, radius});
  }
}

void WritingLayer::draw_sign(const Projection& projection, const SignPlace& place, const Look& look,
                             double scale) {
  const WritingColours& colours = writing_colours(look.style, look.theme);
  glBindVertexArray(empty_array_.name());
  sign_.use();
  sign_.set("viewport", glm::vec2(projection.width, projection.height));
  sign_.set("disc", glm::vec3(place.pixel.x, projection.height - place.pixel.y, place.radius));
  sign_.set("ring", static_cast<float>(scale));
  sign_.set("ground", colours.ground_of_sign);
  sign_.set("mark", colour_of(colours, place.verdict));
  sign_.set("crossed", place.verdict == Verdict::wrong ? 1 : 0);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace nazori::view
