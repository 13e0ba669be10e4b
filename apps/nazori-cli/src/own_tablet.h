// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::cli {

/// A tablet from the user's files, in place of a character's; at least one of the files is given.
struct OwnTablet {
  std::string height_map;       ///< a RAW or PNG, or empty
  std::string strokes;          ///< a .str on the map's grid, or empty; alone, it is carved
  std::optional<int> map_size;  ///< side of the RAW, or of the grid of the .str (128 where it is not given)
};

/// @param carved_size  side of the map into which strokes alone are carved.
[[nodiscard]] base::Result<std::shared_ptr<const tablet::CarvedTablet>> own_tablet(
    const OwnTablet& files, int carved_size, const carving::Brush& brush);

}  // namespace nazori::cli
