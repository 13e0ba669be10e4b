// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "hand_layer.h"
#include "nazori/author/own_character.h"
#include "nazori/tablet/tablet_line.h"

namespace nazori::author {
namespace {

/// The layer at a sample of a map of `size`. Samples lie on the corners of a lattice from edge to edge.
float layer_at(const HandLayer& hand, int size, int column, int row) {
  if (hand.size == size) return hand.heights[sample_index(size, column, row)];
  const double scale = static_cast<double>(hand.size - 1) / (size - 1);
  const double x = column * scale;
  const double y = row * scale;
  const int left = std::min(static_cast<int>(x), hand.size - 2);
  const int top = std::min(static_cast<int>(y), hand.size - 2);
  const auto at = [&hand](int c, int r) {
    return static_cast<double>(hand.heights[sample_index(hand.size, c, r)]);
  };
  const double u = x - left;
  const double v = y - top;
  const double upper = at(left, top) * (1 - u) + at(left + 1, top) * u;
  const double lower = at(left, top + 1) * (1 - u) + at(left + 1, top + 1) * u;
  return static_cast<float>(upper * (1 - v) + lower * v);
}

}  // namespace

HandLayer resampled(const HandLayer& hand, int size) {
  if (hand.is_untouched() || hand.size == size) return hand;
  HandLayer out{size, {}};
  out.heights.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) out.heights.push_back(layer_at(hand, size, column, row));
  return out;
}

std::vector<float> cut_out(const HandLayer& hand, const carving::GridBox& box) {
  std::vector<float> heights;
  for (int row = box.top; row < box.bottom; ++row) {
    const auto begin =
        hand.heights.begin() + static_cast<std::ptrdiff_t>(sample_index(hand.size, box.left, row));
    heights.insert(heights.end(), begin, begin + (box.right - box.left));
  }
  return heights;
}

base::Result<surface::HeightMap> carve(const OwnCharacter& character, int size) {
  auto map = surface::HeightMap::create(size);
  if (!map) return map;
  if (auto done = carve_box(character, carving::whole_map(size), *map); !done)
    return tl::unexpected(std::move(done).error());
  return map;
}

base::Result<void> carve_box(const OwnCharacter& character, const carving::GridBox& box,
                             surface::HeightMap& map) {
  if (auto done = carving::carve_grooves_in(box, grooves_of(character.strokes), map); !done) return done;
  if (character.hand.is_untouched()) return {};
  const std::span<float> samples = map.samples();
  for (int row = box.top; row < box.bottom; ++row) {
    for (int column = box.left; column < box.right; ++column) {
      float& height = samples[sample_index(map.size(), column, row)];
      height = std::clamp(height + layer_at(character.hand, map.size(), column, row), 0.0F, 1.0F);
    }
  }
  return {};
}

base::Result<std::shared_ptr<const tablet::CarvedTablet>> carved_tablet(surface::HeightMap map,
                                                                        const std::vector<OwnStroke>& strokes,
                                                                        const geometry::TabletShape& shape) {
  return tablet::CarvedTablet::from_height_map(std::move(map), tablet::tablet_lines(stroke_lines(strokes)),
                                               shape);
}

base::Result<std::shared_ptr<const tablet::CarvedTablet>> carved_tablet(const OwnCharacter& character,
                                                                        int size,
                                                                        const geometry::TabletShape& shape) {
  auto map = carve(character, size);
  if (!map) return tl::unexpected(std::move(map).error());
  return carved_tablet(*std::move(map), character.strokes, shape);
}

}  // namespace nazori::author
