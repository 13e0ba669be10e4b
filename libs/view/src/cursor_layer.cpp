// SPDX-License-Identifier: Apache-2.0
#include "cursor_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "gl_upload.h"

namespace nazori::view {
namespace {

constexpr int kSides = 28;
constexpr std::size_t kIndicesPerBand = std::size_t{kSides} * 6;

/// Logical pixels.
constexpr double kBrushLength = 190;
constexpr double kBrushShare = 0.32;  ///< of the picture's smaller side, at most
constexpr double kConeLength = 30;
constexpr double kDeviceRadius = 5;
constexpr double kThreadWidth = 1;

/// One ring of a body of revolution. Lengths are fractions of the body's length.
struct Ring {
  float along;
  float radius;
  glm::vec4 colour;  ///< alpha 0: the colour of the ink
};

constexpr glm::vec4 kInked{0, 0, 0, 0};
constexpr glm::vec4 kHair{0.42F, 0.33F, 0.25F, 1};
constexpr glm::vec4 kPaleHair{0.80F, 0.70F, 0.55F, 1};
constexpr glm::vec4 kCollar{0.17F, 0.14F, 0.12F, 1};
constexpr glm::vec4 kBamboo{0.80F, 0.64F, 0.40F, 1};
constexpr glm::vec4 kNode{0.62F, 0.46F, 0.26F, 1};
constexpr glm::vec4 kGreen{0, 1, 0, 1};

constexpr std::array<Ring, 19> kBrush{{{0.000F, 0.000F, kInked},
                                       {0.015F, 0.008F, kInked},
                                       {0.050F, 0.024F, kInked},
                                       {0.100F, 0.041F, kInked},
                                       {0.150F, 0.050F, kInked},
                                       {0.175F, 0.0515F, kHair},
                                       {0.215F, 0.050F, kPaleHair},
                                       {0.265F, 0.042F, kPaleHair},
                                       {0.268F, 0.046F, kCollar},
                                       {0.335F, 0.043F, kCollar},
                                       {0.338F, 0.036F, kBamboo},
                                       {0.560F, 0.035F, kBamboo},
                                       {0.566F, 0.038F, kNode},
                                       {0.574F, 0.038F, kNode},
                                       {0.580F, 0.035F, kBamboo},
                                       {0.800F, 0.034F, kBamboo},
                                       {0.990F, 0.033F, kBamboo},
                                       {1.000F, 0.028F, kBamboo},
                                       {1.000F, 0.000F, kNode}}};
/// 2005: a cone of 20 pixels across at the proxy.
constexpr std::array<Ring, 3> kCone{{{0.0F, 0.0F, kGreen}, {1.0F, 0.3333F, kGreen}, {1.0F, 0.0F, kGreen}}};

struct BodyVertex {
  glm::vec3 place;  ///< the tip at the origin, z along the axis
  glm::vec3 normal;
  glm::vec4 colour;
};

constexpr const char* kBodyVertex = R"glsl(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tint;
uniform mat4 clip_from_body;
uniform mat4 view_from_body;   // turns only
uniform vec3 eye;              // in the body's frame
uniform vec3 ink;
out vec3 facing;
out vec3 towards_eye;
out vec4 body;                 // colour; place along the axis
void main() {
  facing = mat3(view_from_body) * normal;
  towards_eye = mat3(view_from_body) * (eye - corner);
  body = vec4(mix(ink, tint.rgb, tint.a), corner.z);
  gl_Position = clip_from_body * vec4(corner, 1.0);
}
)glsl";

/// The silhouette fades over one pixel in place of multisampling; the far end fades out, so that the stylus
/// hides little.
constexpr const char* kBodyFragment = R"glsl(
in vec3 facing;
in vec3 towards_eye;
in vec4 body;
uniform vec3 light;
uniform vec3 fade;      // from, to along the axis, opacity
uniform float matt;     // 1: the flat green of 2005
out vec4 colour;
void main() {
  vec3 n = normalize(facing);
  vec3 e = normalize(towards_eye);
  float rim = dot(n, e);
  float soft = clamp(rim / max(fwidth(rim), 0.0001), 0.0, 1.0);
  float diffuse = 0.42 + 0.62 * max(dot(n, light), 0.0);
  float shine = pow(max(dot(n, normalize(light + e)), 0.0), 40.0) * 0.30;
  vec3 lit = body.rgb * mix(diffuse, 0.55 + 0.45 * max(dot(n, light), 0.0), matt) + shine * (1.0 - matt);
  float opacity = fade.z * (1.0 - smoothstep(fade.x, fade.y, body.w));
  colour = vec4(lit, opacity * soft);
}
)glsl";

/// A soft or sharp capsule between two pixels.
constexpr const char* kMarkVertex = R"glsl(
uniform vec2 viewport;
uniform vec4 ends;      // pixels, y up
uniform vec4 size;      // radius, inner radius (a ring), softness, stretch of the far end
out vec2 place;
void main() {
  vec2 way = ends.zw - ends.xy;
  vec2 forward = length(way) > 0.001 ? normalize(way) : vec2(1.0, 0.0);
  vec2 aside = vec2(-forward.y, forward.x);
  float r = max(size.x, size.w) + size.z + 1.0;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = (corner.x < 0.0 ? ends.xy - forward * r : ends.zw + forward * r) + aside * corner.y * r;
  gl_Position = vec4(place / viewport * 2.0 - 1.0, 0.0, 1.0);
}
)glsl";

constexpr const char* kMarkFragment = R"glsl(
in vec2 place;
uniform vec4 ends;
uniform vec4 size;
uniform vec4 tint;
uniform float far_opacity;
out vec4 colour;
void main() {
  vec2 way = ends.zw - ends.xy;
  float squared = dot(way, way);
  float t = squared > 0.0 ? clamp(dot(place - ends.xy, way) / squared, 0.0, 1.0) : 0.0;
  float distance = length(place - ends.xy - way * t);
  float radius = mix(size.x, size.w, t);
  float soft = size.z * (0.35 + 0.65 * t) + 1.0;
  float cover = clamp((radius - distance) / soft + 0.5, 0.0, 1.0);
  cover *= clamp(distance - size.y + 0.5, 0.0, 1.0);
  cover = size.z > 0.0 ? cover * cover * (3.0 - 2.0 * cover) : cover;
  colour = vec4(tint.rgb, tint.a * cover * mix(1.0, far_opacity, t));
}
)glsl";

void append_body(std::span<const Ring> rings, std::vector<BodyVertex>& vertices,
                 std::vector<std::uint32_t>& indices) {
  // Each band has vertices of its own, so that edges between colours and slopes stay sharp where a band is
  // short, and normals are those of the band.
  for (std::size_t band = 0; band + 1 < rings.size(); ++band) {
    const Ring& near = rings[band];
    const Ring& far = rings[band + 1];
    const glm::vec2 slope(far.along - near.along, far.radius - near.radius);
    const glm::vec2 band_normal = glm::normalize(glm::vec2(slope.x, -slope.y));  // outward, along -axis
    const auto normal_at = [&](std::size_t ring) {
      // Soft hair bends smoothly; everything else keeps its edges.
      if (ring == 0 || ring + 1 >= rings.size() || ring > 7) return band_normal;
      const glm::vec2 before(rings[ring].along - rings[ring - 1].along,
                             rings[ring].radius - rings[ring - 1].radius);
      const glm::vec2 after(rings[ring + 1].along - rings[ring].along,
                            rings[ring + 1].radius - rings[ring].radius);
      if (rings.size() < 8 || ring == 7) return band_normal;
      return glm::normalize(glm::normalize(glm::vec2(before.x, -before.y)) +
                            glm::normalize(glm::vec2(after.x, -after.y)));
    };
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (int side = 0; side <= kSides; ++side) {
      const double angle = 2 * std::numbers::pi * side / kSides;
      const glm::vec3 out(std::cos(angle), std::sin(angle), 0);
      for (std::size_t ring = band; ring <= band + 1; ++ring) {
        const glm::vec2 n = normal_at(ring);
        vertices.push_back({out * rings[ring].radius + glm::vec3(0, 0, rings[ring].along),
                            out * n.x + glm::vec3(0, 0, n.y), rings[ring].colour});
      }
    }
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t a = first + side * 2;
      indices.insert(indices.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
    }
  }
}

}  // namespace

CursorLayer::CursorLayer(ShaderProgram body, ShaderProgram mark)
    : body_(std::move(body)), mark_(std::move(mark)) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  attribute(0, 3, sizeof(BodyVertex), offsetof(BodyVertex, place));
  attribute(1, 3, sizeof(BodyVertex), offsetof(BodyVertex, normal));
  attribute(2, 4, sizeof(BodyVertex), offsetof(BodyVertex, colour));
  glBindVertexArray(0);
}

base::Result<CursorLayer> CursorLayer::create(DrawStatistics& statistics) {
  auto body = ShaderProgram::compile("stylus", kBodyVertex, kBodyFragment);
  if (!body) return tl::unexpected(body.error());
  auto mark = ShaderProgram::compile("stylus mark", kMarkVertex, kMarkFragment);
  if (!mark) return tl::unexpected(mark.error());
  CursorLayer layer(std::move(*body), std::move(*mark));
  layer.send_bodies(statistics);
  return layer;
}

void CursorLayer::send_bodies(DrawStatistics& statistics) {
  std::vector<BodyVertex> vertices;
  std::vector<std::uint32_t> indices;
  append_body(kBrush, vertices, indices);
  append_body(kCone, vertices, indices);
  brush_ = {0, kBrush.size()};
  cone_ = {kBrush.size() - 1, kCone.size()};
  glBindVertexArray(array_.name());
  upload(vertices_, GL_ARRAY_BUFFER, std::span<const BodyVertex>(vertices), statistics);
  upload(indices_, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(indices), statistics);
  glBindVertexArray(0);
}

void CursorLayer::draw_body(const Projection& projection, const Body& body, glm::dvec3 tip_m, glm::dvec3 axis,
                            double length_m, double opacity) {
  const glm::dvec3 helper = std::abs(axis.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, axis));
  const glm::dmat3 turn(right, glm::cross(axis, right), axis);
  glm::dmat4 tablet_from_body(turn * length_m);
  tablet_from_body[3] = glm::dvec4(tip_m, 1);
  const glm::dvec3 eye = glm::transpose(turn) * (projection.eye_m - tip_m) / length_m;
  body_.set("clip_from_body", glm::mat4(projection.clip_from_tablet * tablet_from_body));
  body_.set("view_from_body", glm::mat4(glm::dmat4(turn)));
  body_.set("eye", glm::vec3(eye));
  const bool fades = body.rings == kBrush.size();
  body_.set("fade", glm::vec3(fades ? 0.55F : 2.0F, fades ? 1.0F : 3.0F, opacity));
  glBindVertexArray(array_.name());
  // Drawn from far to near along the axis, the bands need no depth buffer.
  const auto band = [&](std::size_t k) {
    const std::size_t offset = (body.first_ring + k) * kIndicesPerBand * sizeof(std::uint32_t);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(kIndicesPerBand), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr)
  };
  const std::size_t bands = body.rings - 1;
  if (eye.z > 0.5) {
    for (std::size_t k = 0; k < bands; ++k) band(k);
  } else {
    for (std::size_t k = bands; k-- > 0;) band(k);
  }
}

void CursorLayer::mark(const Projection& projection, glm::dvec2 from, glm::dvec2 to, glm::vec4 size,
                       glm::vec4 colour) {
  mark_.set("viewport", glm::vec2(projection.width, projection.height));
  mark_.set("ends", glm::vec4(from.x, projection.height - from.y, to.x, projection.height - to.y));
  mark_.set("size", size);
  mark_.set("tint", colour);
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

CursorLayer::Trace CursorLayer::draw(const Projection& projection, const Cursor& cursor, const Look& look,
                                     bool current, double scale) {
  const Palette& colours = palette(look.style, look.theme);
  const bool classic = look.style == Style::classic;
  const double per_metre = projection.pixels_per_metre(cursor.proxy_m);
  const glm::dvec2 tip = projection.pixel(cursor.proxy_m);
  const glm::dvec2 device = projection.pixel(cursor.device_m);

  // Axes of the view in the tablet frame: right, up and towards the learner.
  const glm::dvec3 towards = glm::normalize(projection.eye_m - cursor.proxy_m);
  const glm::dmat4& clip = projection.clip_from_tablet;
  const glm::dvec3 right = glm::normalize(glm::dvec3(clip[0][0], clip[1][0], clip[2][0]));
  const glm::dvec3 up = glm::normalize(glm::cross(towards, right));
  const double hand = look.hand == Hand::right ? 1 : -1;
  // In a small picture the brush is smaller, too: it must not cover the character.
  const double smaller = std::min(projection.width, projection.height);
  const double brush = std::min(kBrushLength * scale, smaller * kBrushShare);
  const double length_m = (classic ? kConeLength * scale : brush) / per_metre;
  glm::dvec3 axis = cursor.axis;
  if (glm::length(axis) < 1e-9) {
    axis = classic ? glm::dvec3(0, 0, 1) * 0.8 + right * 0.25 * hand + up * 0.2
                   : right * 0.56 * hand + up * 0.66 + towards * 0.42;
  }
  axis = glm::normalize(axis);

  glViewport(0, 0, projection.width, projection.height);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  mark_.use();
  if (!classic) {
    // The shadow lies on the tablet under the tip and runs out along the stylus, away from the light.
    const glm::vec3 light = light_direction(look.hand);
    const glm::dvec3 end = cursor.proxy_m + axis * (length_m * 0.5);
    const double drop = std::max(end.z, 0.0) / light.z;
    const glm::dvec3 foot(end.x - light.x * drop, end.y - light.y * drop, 0);
    const double lift = std::max(0.0, cursor.proxy_m.z) / light.z;
    const glm::dvec3 start(cursor.proxy_m.x - light.x * lift, cursor.proxy_m.y - light.y * lift,
                           std::min(cursor.proxy_m.z, 0.0));
    const auto width = static_cast<float>(brush * 0.045);
    mark_.set("far_opacity", 0.0F);
    mark(projection, projection.pixel(start), projection.pixel(foot),
         {width * 0.35F, 0, width * (cursor.touching ? 1.6F : 2.6F), width * 1.1F},
         {0.05F, 0.035F, 0.02F, cursor.touching ? 0.60F : 0.38F});
  }
  if (glm::distance(tip, device) > 2 * scale) {
    const auto radius = static_cast<float>(kDeviceRadius * scale);
    const auto thread = static_cast<float>(kThreadWidth * scale);
    mark_.set("far_opacity", 1.0F);
    mark(projection, tip, device, {thread * 0.5F, 0, 0, thread * 0.5F}, {colours.device, 0.55F});
    mark(projection, device, device, {radius, radius - thread * 1.5F, 0, radius}, {colours.device, 0.75F});
    mark(projection, device, device, {radius - thread * 1.5F, 0, 0, radius}, {colours.device, 0.22F});
  }

  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  body_.use();
  const Colour ink = current ? colours.current_ink : from_hex(0x1A1715);
  body_.set("ink", ink * 0.9F);
  const glm::dvec3 key = right * -0.45 * hand + up * 0.55 + towards * 0.70;
  body_.set("light", glm::vec3(glm::normalize(key)));
  body_.set("matt", classic ? 1.0F : 0.0F);
  draw_body(projection, classic ? cone_ : brush_, cursor.proxy_m, axis, length_m,
            classic || cursor.touching ? 1.0 : 0.88);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  return {tip, projection.pixel(cursor.proxy_m + axis * length_m), length_m * per_metre * 0.35};
}

}  // namespace nazori::view
