// SPDX-License-Identifier: Apache-2.0
#include "stroke_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "disc_shader.h"
#include "gl_upload.h"
#include "nazori/geometry/polyline.h"

namespace nazori::view {
namespace {

/// 2005 drew strokes at 257 x scale over a plateau of 255 x scale.
constexpr double kAbovePlateau = 2.0 / 255.0;

/// Logical pixels.
constexpr double kClassicHalfWidth = 1.0;
constexpr double kHalfWidth = 1.5;
constexpr double kOutline = 1.0;
constexpr double kHeadLength = 13;
constexpr double kDiscRadius = 10;
constexpr double kDiscGap = 3;

/// A line of constant width on the screen: a rectangle around each piece, its edge smoothed by distance.
constexpr const char* kLineVertex = R"glsl(
layout(location = 0) in vec4 ends;
layout(location = 1) in float stroke;
uniform mat4 clip_from_tablet;
uniform vec2 viewport;
uniform float half_width;
uniform float height;
uniform float current;
out vec2 place;
flat out vec4 piece;
vec2 pixel(vec2 p) {
  vec4 clip = clip_from_tablet * vec4(p, height, 1.0);
  return (clip.xy / clip.w * 0.5 + 0.5) * viewport;
}
void main() {
  vec2 from = pixel(ends.xy);
  vec2 to = pixel(ends.zw);
  vec2 way = to - from;
  vec2 forward = length(way) > 0.001 ? normalize(way) : vec2(1.0, 0.0);
  vec2 aside = vec2(-forward.y, forward.x);
  float r = half_width + 1.0;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = (corner.x < 0.0 ? from - forward * r : to + forward * r) + aside * corner.y * r;
  piece = vec4(from, to);
  gl_Position = vec4(place / viewport * 2.0 - 1.0, 0.0, 1.0);
  if (current > 0.5 && abs(stroke - current) > 0.5) gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
}
)glsl";

constexpr const char* kLineFragment = R"glsl(
in vec2 place;
flat in vec4 piece;
uniform float half_width;
uniform vec3 colour_of_line;
uniform float opacity;
out vec4 colour;
void main() {
  vec2 way = piece.zw - piece.xy;
  float squared = dot(way, way);
  float t = squared > 0.0 ? clamp(dot(place - piece.xy, way) / squared, 0.0, 1.0) : 0.0;
  float cover = clamp(half_width + 0.5 - length(place - piece.xy - way * t), 0.0, 1.0);
  if (cover <= 0.0) discard;
  colour = vec4(colour_of_line, cover * opacity);
}
)glsl";

/// An arrowhead in the plane of the plateau. Its own frame: along from the tip backwards, across.
constexpr const char* kHeadVertex = R"glsl(
layout(location = 0) in vec4 head;    // tip, direction
layout(location = 1) in float stroke;
uniform mat4 clip_from_tablet;
uniform vec2 sizes;                   // length of the head and width of its outline, in metres
uniform float height;
uniform float current;
out vec2 place;                       // in lengths of the head
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = vec2(corner.x * 2.0 - 0.6, corner.y * 2.0 - 1.0);
  vec2 aside = vec2(-head.w, head.z);
  vec2 at = head.xy - head.zw * place.x * sizes.x + aside * place.y * sizes.x;
  gl_Position = clip_from_tablet * vec4(at, height, 1.0);
  gl_Position.z = 0.0;
  if (current > 0.5 && abs(stroke - current) > 0.5) gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
}
)glsl";

constexpr const char* kHeadFragment = R"glsl(
in vec2 place;
uniform vec2 sizes;
uniform vec3 colour_of_head;
uniform float opacity;
out vec4 colour;
void main() {
  float grow = sizes.y / sizes.x;
  float y = abs(place.y);
  float flank = dot(vec2(place.x, y), vec2(-0.4067, 0.9135));   // the side leans 24 degrees
  float back = place.x - 1.0 + 0.28 * (1.0 - y / 0.445);
  float pixel = length(vec2(length(dFdx(place)), length(dFdy(place)))) * 0.7071;
  float outside = max(flank, back * 0.85) - grow;
  float cover = clamp(0.5 - outside / pixel, 0.0, 1.0);
  if (cover <= 0.0) discard;
  colour = vec4(colour_of_head, cover * opacity);
}
)glsl";

/// A number: disc, ring and figures, always facing the learner, at a whole pixel so that figures stay sharp.
constexpr const char* kDiscFragment = R"glsl(
in vec2 place;
uniform vec3 disc;
uniform vec3 label;     // left and top of the cell, its side, in texels
uniform vec3 ground;
uniform vec3 edge;
uniform vec3 ink;
uniform float ring;
uniform sampler2D labels;
out vec4 colour;
void main() {
  float r = length(place);
  vec2 texel = label.xy + vec2(place.x, -place.y) + label.z * 0.5;
  vec2 sheet = vec2(textureSize(labels, 0));
  bool in_cell = max(abs(place.x), abs(place.y)) < label.z * 0.5 - 0.5;
  float figure = in_cell ? texture(labels, texel / sheet).r : 0.0;
  float inner = clamp(disc.z - ring - r + 0.5, 0.0, 1.0);
  vec3 face = mix(edge, mix(ground, ink, figure), inner);
  colour = vec4(face, clamp(disc.z - r + 0.5, 0.0, 1.0));
}
)glsl";

void point_lines(const VertexArray& array, const Buffer& buffer) {
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  attribute(0, 4, sizeof(LinePiece), offsetof(LinePiece, from_m), 1);
  attribute(1, 1, sizeof(LinePiece), offsetof(LinePiece, stroke), 1);
}

/// Where lines are transparent, no pixel may be painted twice by pieces of one line that overlap.
class FadedOnce {
 public:
  explicit FadedOnce(double opacity) : fades_(opacity < 1) {
    if (!fades_) return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
  }
  ~FadedOnce() {
    if (fades_) glDisable(GL_DEPTH_TEST);
  }
  FadedOnce(const FadedOnce&) = delete;
  FadedOnce& operator=(const FadedOnce&) = delete;

  void begin_layer() const {
    if (!fades_) return;
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
  }

 private:
  bool fades_;
};

}  // namespace

StrokeLayer::StrokeLayer(ShaderProgram line, ShaderProgram head, ShaderProgram disc)
    : line_(std::move(line)), head_(std::move(head)), disc_(std::move(disc)) {
  point_lines(lines_array_, lines_);
  point_lines(classic_array_, classic_heads_);
  glBindVertexArray(heads_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, heads_.name());
  attribute(0, 4, sizeof(ArrowHead), offsetof(ArrowHead, tip_m), 1);
  attribute(1, 1, sizeof(ArrowHead), offsetof(ArrowHead, stroke), 1);
  glBindVertexArray(0);
}

base::Result<StrokeLayer> StrokeLayer::create() {
  auto line = ShaderProgram::compile("stroke line", kLineVertex, kLineFragment);
  if (!line) return tl::unexpected(line.error());
  auto head = ShaderProgram::compile("arrowhead", kHeadVertex, kHeadFragment);
  if (!head) return tl::unexpected(head.error());
  auto disc = ShaderProgram::compile("stroke number", kDiscVertex, kDiscFragment);
  if (!disc) return tl::unexpected(disc.error());
  return StrokeLayer(std::move(*line), std::move(*head), std::move(*disc));
}

void StrokeLayer::set_strokes(const StrokeGeometry& strokes, const geometry::TabletShape& shape,
                              DrawStatistics& statistics) {
  shape_ = shape;
  anchors_ = strokes.anchors;
  line_count_ = {strokes.lines.size(), strokes.shown_lines};
  head_count_ = {strokes.heads.size(), strokes.shown_heads};
  classic_count_ = {strokes.classic_heads.size(), strokes.shown_classic_heads};
  if (line_count_.all > 0)
    upload(lines_, GL_ARRAY_BUFFER, std::span<const LinePiece>(strokes.lines), statistics);
  if (head_count_.all > 0) {
    upload(heads_, GL_ARRAY_BUFFER, std::span<const ArrowHead>(strokes.heads), statistics);
    upload(classic_heads_, GL_ARRAY_BUFFER, std::span<const LinePiece>(strokes.classic_heads), statistics);
  }
}

void StrokeLayer::draw_lines(const VertexArray& array, std::size_t count, float half_width, Colour colour,
                             int current) {
  line_.set("half_width", half_width);
  line_.set("colour_of_line", colour);
  line_.set("current", static_cast<float>(current));
  glBindVertexArray(array.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

void StrokeLayer::draw_heads(const Projection& projection, float size, float grow, Colour colour,
                             int current) {
  const double per_metre = projection.pixels_per_metre(glm::dvec3(0, 0, 0));
  head_.use();
  head_.set("clip_from_tablet", glm::mat4(projection.clip_from_tablet));
  head_.set("sizes", glm::vec2(size / per_metre, grow / per_metre));
  head_.set("height", static_cast<float>(kAbovePlateau * shape_.depth_m));
  head_.set("colour_of_head", colour);
  head_.set("current", static_cast<float>(current));
  glBindVertexArray(heads_array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(head_count_.of(current)));
}

void StrokeLayer::draw_ways(const Projection& projection, const Look& look, const StrokeChoice& choice) {
  const Palette& colours = palette(look.style, look.theme);
  const auto opacity = static_cast<float>(choice.lines_opacity);
  head_.use();
  head_.set("opacity", opacity);
  line_.use();
  line_.set("opacity", opacity);
  line_.set("viewport", glm::vec2(projection.width, projection.height));
  line_.set("clip_from_tablet", glm::mat4(projection.clip_from_tablet));
  line_.set("height", static_cast<float>(kAbovePlateau * shape_.depth_m));
  const int current = choice.current;
  const Colour stroke = current > 0 ? colours.current_stroke : colours.stroke;
  const double pixel = choice.scale;
  if (look.style == Style::classic) {
    const auto half = static_cast<float>(kClassicHalfWidth * pixel);
    draw_lines(lines_array_, line_count_.of(current), half, stroke, current);
    if (choice.heads) draw_lines(classic_array_, classic_count_.of(current), half, stroke, current);
    return;
  }
  const double grow = std::sqrt(choice.text_scale) * pixel;
  const auto half = static_cast<float>(kHalfWidth * grow);
  const auto outline = static_cast<float>(kOutline * pixel);
  const auto head = static_cast<float>(kHeadLength * grow);
  const FadedOnce faded(choice.lines_opacity);
  faded.begin_layer();
  draw_lines(lines_array_, line_count_.of(current), half + outline, colours.stroke_edge, current);
  if (choice.heads) draw_heads(projection, head, outline, colours.stroke_edge, current);
  line_.use();
  faded.begin_layer();
  draw_lines(lines_array_, line_count_.of(current), half, stroke, current);
  if (choice.heads) draw_heads(projection, head, 0, stroke, current);
}

void StrokeLayer::draw(const Projection& projection, const PixelBox& box, const Look& look,
                       const StrokeChoice& choice, DrawStatistics& statistics) {
  numbers_.clear();
  if (anchors_.empty() || !choice.lines) return;
  glViewport(0, 0, projection.width, projection.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.x, box.y, box.width, box.height);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);

  if (choice.lines_opacity > 0) draw_ways(projection, look, choice);
  if (choice.numbers) draw_numbers(projection, look, choice, statistics);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
}

void StrokeLayer::draw_numbers(const Projection& projection, const Look& look, const StrokeChoice& choice,
                               DrawStatistics& statistics) {
  const Palette& colours = palette(look.style, look.theme);
  const double radius = std::round(kDiscRadius * choice.text_scale * choice.scale * 2) / 2;
  const double gap = kDiscGap * choice.scale;
  const int cell = std::clamp(static_cast<int>(std::lround(radius * 2)), 8, 512);
  const auto numbers = static_cast<int>(anchors_.size());
  if (sheet_.cell != cell || sheet_numbers_ != numbers) {
    sheet_ = font_.draw(numbers, cell);
    sheet_numbers_ = numbers;
    upload(labels_, {GL_R8, GL_RED, sheet_.columns * cell, sheet_.rows * cell, false}, sheet_.coverage,
           statistics);
  }
  std::vector<NumberWish> wishes;
  std::vector<int> shown;
  const double height = kAbovePlateau * shape_.depth_m;
  for (int i = 0; i < numbers; ++i) {
    if (choice.current > 0 && choice.current != i + 1) continue;
    const NumberAnchor& anchor = anchors_[static_cast<std::size_t>(i)];
    const glm::dvec2 start = projection.pixel({anchor.start.x, anchor.start.y, height});
    if (start.x < 0 || start.y < 0 || start.x > projection.width || start.y > projection.height) continue;
    const double step = shape_.width_m * 0.01;
    const glm::dvec2 beside = projection.pixel(
        {anchor.start.x + anchor.side.x * step, anchor.start.y + anchor.side.y * step, height});
    const double length = glm::distance(start, beside);
    wishes.push_back({start, length > 1e-6 ? (beside - start) / length : glm::dvec2(0)});
    shown.push_back(i + 1);
  }
  const std::vector<glm::dvec2> places = lay_out_numbers(wishes, radius, gap);

  const Colour thread = choice.current > 0 ? colours.current_stroke : colours.stroke;
  const glm::vec2 viewport(projection.width, projection.height);
  glBindVertexArray(empty_array_.name());
  disc_.use();
  disc_.set("viewport", viewport);
  disc_.set("labels", 0);
  disc_.set("ring", static_cast<float>(choice.scale));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, labels_.name());
  // A dot on each start; a row of small dots leads to a number that had to move away.
  disc_.set("label", glm::vec3(0));
  disc_.set("ground", thread);
  disc_.set("edge", colours.stroke_edge);
  disc_.set("ink", thread);
  const auto dot = [&](glm::dvec2 at, double size) {
    disc_.set("disc", glm::vec3(at.x, projection.height - at.y, size * choice.scale));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 way = places[i] - wishes[i].start;
    const double distance = glm::length(way);
    const double spacing = 4.5 * choice.scale;
    const int dots = std::max(0, static_cast<int>(std::ceil((distance - radius) / spacing - 1.5)));
    for (int k = 0; k < dots; ++k) dot(wishes[i].start + way / distance * (spacing * (k + 1.5)), 1.6);
  }
  for (const NumberWish& wish : wishes) dot(wish.start, 3.4);
  prepare_discs(projection, look, choice);
  for (std::size_t i = 0; i < places.size(); ++i) {
    // Texels and pixels coincide when the middle of the cell and that of the disc agree.
    const double offset = cell % 2 == 0 ? 0.0 : 0.5;
    const glm::dvec2 place = glm::floor(places[i]) + offset;
    numbers_.push_back({shown[i], place, radius});
    draw_disc(projection, numbers_.back());
  }
}

void StrokeLayer::prepare_discs(const Projection& projection, const Look& look, const StrokeChoice& choice) {
  const Palette& colours = palette(look.style, look.theme);
  const bool current = choice.current > 0;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, labels_.name());
  glBindVertexArray(empty_array_.name());
  disc_.use();
  disc_.set("viewport", glm::vec2(projection.width, projection.height));
  disc_.set("labels", 0);
  disc_.set("ring", static_cast<float>(choice.scale));
  disc_.set("ground", current ? colours.current_disc : colours.disc);
  disc_.set("edge", current ? colours.stroke_edge : colours.disc_edge);
  disc_.set("ink", current ? colours.current_number : colours.number);
}

void StrokeLayer::draw_disc(const Projection& projection, const NumberPlace& place) {
  const int index = place.stroke - 1;
  disc_.set("disc", glm::vec3(place.pixel.x, projection.height - place.pixel.y, place.radius));
  disc_.set("label", glm::vec3(index % sheet_.columns * sheet_.cell, index / sheet_.columns * sheet_.cell,
                               sheet_.cell));
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void StrokeLayer::draw_numbers_again(const Projection& projection, const Look& look,
                                     const StrokeChoice& choice, glm::dvec2 from, glm::dvec2 to,
                                     double reach) {
  bool prepared = false;
  for (const NumberPlace& place : numbers_) {
    if (geometry::distance_to_segment(place.pixel, from, to) > reach + place.radius) continue;
    if (!prepared) {
      glEnable(GL_BLEND);
      glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
      prepare_discs(projection, look, choice);
      prepared = true;
    }
    draw_disc(projection, place);
  }
  if (prepared) glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace nazori::view
