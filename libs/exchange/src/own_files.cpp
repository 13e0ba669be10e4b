// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/own_files.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map_file.h"

namespace nazori::exchange {
namespace {

base::Result<int> grid_of(const OwnFiles& files, int map_size) {
  if (files.grid) return *files.grid;
  if (map_size > 0) return map_size;
  const auto guess = guess_grid(files.strokes);
  if (!guess) return tl::unexpected(guess.error());
  return guess->side;
}

}  // namespace

base::Result<GridGuess> guess_grid(const std::filesystem::path& strokes) {
  const auto order = kanji::StrokeOrder::load(strokes, kanji::StrokeOrder::kMaxGrid);
  if (!order) return tl::unexpected(order.error());
  int farthest = 0;
  for (const auto& stroke : order->all())
    for (const auto& point : stroke) farthest = std::max({farthest, point.x, point.y});
  GridGuess guess;
  while (guess.side <= farthest) guess.side *= 2;
  guess.certain = guess.side == GridGuess::kClassic && farthest >= GridGuess::kClassic / 2;
  return guess;
}

base::Result<OwnTablet> load_own_tablet(OwnFiles files, int carved_size, const carving::Brush& brush) {
  std::optional<surface::HeightMap> map = std::move(files.onto);
  if (!files.height_map.empty()) {
    auto loaded = surface::load_height_map(files.height_map, files.map_size);
    if (!loaded) return tl::unexpected(std::move(loaded.error()));
    map = std::move(*loaded);
  }
  OwnTablet own;
  own.map_size = map ? map->size() : 0;
  std::vector<tablet::TabletLine> lines;
  if (!files.strokes.empty()) {
    const auto side = grid_of(files, own.map_size);
    if (!side) return tl::unexpected(side.error());
    const auto order = kanji::StrokeOrder::load(files.strokes, *side);
    if (!order) return tl::unexpected(order.error());
    lines = tablet::tablet_lines(order->to_lines(*side));
  }
  auto tablet = map ? tablet::CarvedTablet::from_height_map(std::move(*map), std::move(lines))
                    : tablet::CarvedTablet::from_lines(std::move(lines), carved_size, brush);
  if (!tablet) return tl::unexpected(std::move(tablet.error()));
  own.tablet = *std::move(tablet);
  return own;
}

}  // namespace nazori::exchange
