// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::view {

/// Vertex shader of a square of four vertices, without attributes, around a disc on the screen. Gives
/// `place`, in pixels from the disc's middle, with two pixels more than the radius for the softened edge.
inline constexpr const char* kDiscVertex = R"glsl(
uniform vec2 viewport;
uniform vec3 disc;      // middle in pixels, y up; radius
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = corner * (disc.z + 2.0);
  gl_Position = vec4((disc.xy + place) / viewport * 2.0 - 1.0, 0.0, 1.0);
}
)glsl";

}  // namespace nazori::view
