// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/kanji/character.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::practice {

/// A tablet that threads may share; null for none.
using Tablet = std::shared_ptr<const tablet::CarvedTablet>;

/// How a tablet is written to a file.
enum class FileFormat : std::uint8_t {
  raw,      ///< 8-bit height map without header
  png,      ///< 16-bit greyscale height map
  strokes,  ///< the 2005 stroke order
};

/// A tablet that came from the learner's own files.
struct OwnTablet {
  Tablet tablet;
  std::string name;  ///< file names, for people
  int map_size = 0;  ///< samples per side of the loaded map; 0: carved from strokes
  bool has_strokes = false;
};

/// Carves, loads and saves tablets on a separate thread. Requests return at once, answers come as signals.
/// Thread: the owner of the inbox.
class TabletWorkshop {
 public:
  /// Samples per side of a tablet that is carved for display and touch.
  static constexpr int kSize = 1024;
  /// Side of the 2005 grid, proposed for a stroke file, which does not contain its own.
  static constexpr int kClassicSize = 128;

  /// @param inbox  outlives this. @param own_characters  folder of the characters that people made; empty:
  /// there are none.
  explicit TabletWorkshop(base::Inbox& inbox, std::filesystem::path own_characters = {});
  ~TabletWorkshop();
  TabletWorkshop(const TabletWorkshop&) = delete;
  TabletWorkshop& operator=(const TabletWorkshop&) = delete;

  /// Carves a character; of several requests to carve or load only the newest is answered. The last few
  /// tablets are cached. An own character, and one whose form somebody made, is carved as it was made, with
  /// its own widths and relief.
  void carve(const kanji::Character& character);

  /// Loads a height map and strokes, either or both; an empty path means none. Strokes alone are combined
  /// with `onto` where that is a map from a file (of `onto.map_size` samples), else they are carved.
  /// @param grid_size  of the stroke file; 0: that of the map, or the result of guess_grid().
  void load(const std::filesystem::path& map_path, const std::filesystem::path& strokes_path,
            const OwnTablet& onto, int grid_size = 0);

  /// A tablet that was made elsewhere takes the place of the requests before it; `loaded` follows at once.
  void show(const OwnTablet& own);

  /// Writes the tablet at `size` samples a side. @param own_map  the tablet keeps the size of its own map.
  void save(const Tablet& tablet, const std::filesystem::path& path, FileFormat format, int size,
            bool own_map);

  /// An estimate of the grid of a stroke file, which does not contain its size.
  struct GridGuess {
    int side = kClassicSize;  ///< smallest power of two from 128 on that holds every point
    bool certain = false;     ///< the points fill more than half of the 2005 grid
  };
  /// @return the errors of StrokeOrder::load.
  [[nodiscard]] static base::Result<GridGuess> guess_grid(const std::filesystem::path& strokes_path);

  base::Signal<char32_t, const Tablet&> carved;
  base::Signal<const OwnTablet&> loaded;
  base::Signal<const std::filesystem::path&> saved;
  /// A request failed and nothing was changed. The path is that of the file in question, empty for carving.
  base::Signal<const std::filesystem::path&, const base::Error&> failed;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
