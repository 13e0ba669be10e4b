// SPDX-License-Identifier: Apache-2.0
#include "own_tablet.h"

#include <utility>

#include "nazori/exchange/own_files.h"

namespace nazori::cli {

base::Result<std::shared_ptr<const tablet::CarvedTablet>> own_tablet(const OwnTablet& files, int carved_size,
                                                                     const carving::Brush& brush) {
  exchange::OwnFiles own{files.height_map, files.map_size, files.strokes, {}, {}};
  if (files.height_map.empty()) own.grid = files.map_size.value_or(exchange::GridGuess::kClassic);
  auto loaded = exchange::load_own_tablet(std::move(own), carved_size, brush);
  if (!loaded) return tl::unexpected(std::move(loaded.error()));
  return std::move(loaded->tablet);
}

}  // namespace nazori::cli
