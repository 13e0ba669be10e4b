// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/surface/height_map.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::exchange {

/// Files of the learner's own that make a tablet, in place of a character. At least one is given, or `onto`.
struct OwnFiles {
  std::filesystem::path height_map;  ///< a RAW or PNG, or empty
  std::optional<int> map_size;       ///< side of the RAW; else the file says it
  std::filesystem::path strokes;     ///< a .str, or empty; without a map it is carved
  std::optional<int> grid;           ///< side of the grid of the .str; else that of the map, else a guess
  std::optional<surface::HeightMap> onto;  ///< a map that is there already, where no file is given
};

/// The grid of a stroke file, which does not say how large it is.
struct GridGuess {
  static constexpr int kClassic = 128;  ///< the grid of 2005
  int side = kClassic;                  ///< smallest power of two from 128 on that holds every point
  bool certain = false;                 ///< the points fill more than half of the grid of 2005
};

/// @return the errors of kanji::StrokeOrder::load.
[[nodiscard]] base::Result<GridGuess> guess_grid(const std::filesystem::path& strokes);

/// What was made of a learner's own files.
struct OwnTablet {
  std::shared_ptr<const tablet::CarvedTablet> tablet;
  int map_size = 0;  ///< samples a side of the map that was loaded; 0: carved from strokes
};

/// Reads the files and makes a tablet of them. @param carved_size  side of the map that strokes alone are
/// carved into.
/// @return the errors of surface::load_height_map, kanji::StrokeOrder::load and tablet::CarvedTablet; they
/// name the file.
[[nodiscard]] base::Result<OwnTablet> load_own_tablet(OwnFiles files, int carved_size,
                                                      const carving::Brush& brush = {});

}  // namespace nazori::exchange
