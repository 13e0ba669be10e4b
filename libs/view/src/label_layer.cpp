// SPDX-License-Identifier: Apache-2.0
#include "label_layer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gl_upload.h"
#include "palette.h"

namespace nazori::view {
namespace {

/// Logical pixels at 12 pt.
constexpr double kDigitHeight = 9;
constexpr double kGap = 5;
constexpr double kEdge = 2;
/// Digits lower than this cannot be read.
constexpr int kLeastHeight = 7;
/// A step to the side of a label's point, as a share of the tablet's width.
constexpr double kSideStep_m = 0.001;

constexpr const char* kVertex = R"glsl(
uniform vec2 viewport;
uniform vec4 box;        // left, bottom, width, height in pixels, y up
out vec2 place;          // in texels from the top left corner
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = vec2(corner.x, 1.0 - corner.y) * box.zw;
  gl_Position = vec4((box.xy + corner * box.zw) / viewport * 2.0 - 1.0, 0.0, 1.0);
}
)glsl";

/// Red: the text, green: the text with its edge.
constexpr const char* kFragment = R"glsl(
in vec2 place;
uniform float top;
uniform vec3 ink;
uniform vec3 ground;
uniform sampler2D texts;
out vec4 colour;
void main() {
  vec2 cover = texelFetch(texts, ivec2(place) + ivec2(0, int(top)), 0).rg;
  if (cover.g <= 0.0) discard;
  colour = vec4(mix(ground, ink, cover.r), cover.g);
}
)glsl";

/// Coverage of the text and, interleaved, of what is within `edge` pixels of it.
std::vector<std::uint8_t> with_edge(const LabelPicture& picture, int edge) {
  std::vector<std::uint8_t> both;
  both.reserve(picture.coverage.size() * 2);
  const auto at = [&picture](int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return 0.0;
    return static_cast<double>(picture.coverage[static_cast<std::size_t>(y * picture.width + x)]);
  };
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      double most = 0;
      for (int dy = -edge; dy <= edge; ++dy) {
        for (int dx = -edge; dx <= edge; ++dx) {
          const double inside = std::clamp(edge + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
          most = std::max(most, inside * at(x + dx, y + dy));
        }
      }
      both.push_back(static_cast<std::uint8_t>(at(x, y)));
      both.push_back(static_cast<std::uint8_t>(std::lround(most)));
    }
  }
  return both;
}

bool overlap(const LabelPlace& a, const LabelPlace& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

}  // namespace

base::Result<LabelLayer> LabelLayer::create() {
  auto text = ShaderProgram::compile("label", kVertex, kFragment);
  if (!text) return tl::unexpected(text.error());
  return LabelLayer(std::move(*text));
}

void LabelLayer::set_labels(std::vector<geometry::Label> labels) {
  labels_ = std::move(labels);
  stale_ = true;
}

void LabelLayer::draw_pictures(int height, int edge, DrawStatistics& statistics) {
  if (!stale_ && height == drawn_height_ && edge == drawn_edge_) return;
  stale_ = false;
  drawn_height_ = height;
  drawn_edge_ = edge;
  cuts_.clear();
  std::vector<LabelPicture> pictures;
  int width = 1, rows = 0;
  for (const geometry::Label& label : labels_) {
    pictures.push_back(font_.draw_text(label.text, height, edge));
    cuts_.push_back({rows, pictures.back().width, pictures.back().height});
    width = std::max(width, pictures.back().width);
    rows += pictures.back().height;
  }
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows) * 2, 0);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto both = with_edge(pictures[i], edge);
    const auto line = static_cast<std::ptrdiff_t>(pictures[i].width) * 2;
    for (int y = 0; y < pictures[i].height; ++y)
      std::copy_n(both.begin() + y * line, line,
                  texels.begin() + static_cast<std::ptrdiff_t>(cuts_[i].top + y) * width * 2);
  }
  upload(texture_, {GL_RG8, GL_RG, width, rows, false}, texels, statistics);
}

void LabelLayer::lay_out(const Projection& projection, double gap) {
  places_.clear();
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const geometry::Label& label = labels_[i];
    const glm::dvec2 at = projection.pixel({label.at.x, label.at.y, 0});
    const glm::dvec2 beside =
        projection.pixel({label.at.x + label.right * kSideStep_m, label.at.y + label.up * kSideStep_m, 0});
    const double length = glm::distance(at, beside);
    const glm::dvec2 way = length > 1e-9 ? (beside - at) / length : glm::dvec2(0);
    const glm::dvec2 size(cuts_[i].width, cuts_[i].height);
    // So far that the box around the text keeps the gap whichever way it goes.
    const double reach = gap + std::abs(way.x) * size.x / 2 + std::abs(way.y) * size.y / 2;
    const glm::dvec2 low = glm::floor(at + way * reach - size / 2.0);
    const LabelPlace place{i, low, low + size};
    if (low.x < 0 || low.y < 0 || place.high.x > projection.width || place.high.y > projection.height)
      continue;
    if (std::any_of(places_.begin(), places_.end(),
                    [&place](const LabelPlace& other) { return overlap(place, other); }))
      continue;
    places_.push_back(place);
  }
}

void LabelLayer::draw(const Projection& projection, const PixelBox& box, const Look& look,
                      const StrokeChoice& choice, DrawStatistics& statistics) {
  places_.clear();
  if (labels_.empty()) return;
  const double pixel = choice.scale * choice.text_scale;
  const int height = std::max(kLeastHeight, static_cast<int>(std::lround(kDigitHeight * pixel)));
  draw_pictures(height, std::max(1, static_cast<int>(std::lround(kEdge * choice.scale))), statistics);
  lay_out(projection, kGap * choice.scale);

  glViewport(0, 0, projection.width, projection.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.x, box.y, box.width, box.height);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  const Palette& colours = palette(look.style, look.theme);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glBindVertexArray(empty_array_.name());
  text_.use();
  text_.set("viewport", glm::vec2(projection.width, projection.height));
  text_.set("texts", 0);
  text_.set("ink", colours.number);
  text_.set("ground", colours.disc);
  for (const LabelPlace& place : places_) {
    const Cut& cut = cuts_[place.label];
    text_.set("box", glm::vec4(place.low.x, projection.height - place.high.y, cut.width, cut.height));
    text_.set("top", static_cast<float>(cut.top));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
}

}  // namespace nazori::view
