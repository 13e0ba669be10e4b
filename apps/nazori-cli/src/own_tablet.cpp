// SPDX-License-Identifier: Apache-2.0
#include "own_tablet.h"

#include <utility>
#include <vector>

#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map_file.h"

namespace nazori::cli {
namespace {

constexpr int kStrokeFileGrid = 128;

}  // namespace

base::Result<std::shared_ptr<const tablet::CarvedTablet>> own_tablet(const OwnTablet& files, int carved_size,
                                                                     const carving::Brush& brush) {
  std::optional<surface::HeightMap> map;
  if (!files.height_map.empty()) {
    auto loaded = surface::load_height_map(files.height_map, files.map_size);
    if (!loaded) return tl::unexpected(std::move(loaded.error()));
    map = std::move(*loaded);
  }
  const int grid = map ? map->size() : files.map_size.value_or(kStrokeFileGrid);
  std::vector<kanji::StrokeLine> lines;
  if (!files.strokes.empty()) {
    const auto order = kanji::StrokeOrder::load(files.strokes, grid);
    if (!order) return tl::unexpected(order.error());
    lines = order->to_lines(grid);
  }
  if (map) return tablet::CarvedTablet::from_height_map(std::move(*map), tablet::tablet_lines(lines));
  return tablet::CarvedTablet::from_lines(std::move(lines), carved_size, brush);
}

}  // namespace nazori::cli
