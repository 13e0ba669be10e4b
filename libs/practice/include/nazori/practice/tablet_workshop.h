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

/// A tablet that threads may share; null where there is none.
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
  int map_size = 0;  ///< samples a side of the map that was loaded; 0: carved from strokes
  bool has_strokes = false;
};

/// Carves tablets, loads and saves them behind the thread that asks. Requests return at once, answers come as
/// signals. Thread: the owner of the inbox.
class TabletWorkshop {
 public:
  /// Samples a side of a tablet that is carved to be seen and felt.
  static constexpr int kSize = 1024;
  /// Side of the 2005 grid, proposed where a stroke file does not say its own.
  static constexpr int kClassicSize = 128;

  /// @param inbox  outlives this.
  explicit TabletWorkshop(base::Inbox& inbox);
  ~TabletWorkshop();
  TabletWorkshop(const TabletWorkshop&) = delete;
  TabletWorkshop& operator=(const TabletWorkshop&) = delete;

  /// Carves a character; of several requests to carve or load only the newest is answered. The last few
  /// tablets stay at hand.
  void carve(const kanji::Character& character);

  /// Loads a height map and strokes, either or both; an empty path means none. Strokes alone are laid over
  /// `onto` where that is a map from a file (of `onto.map_size` samples), else they are carved.
  /// @param grid_size  of the stroke file; 0: that of the map, or as guess_grid() finds.
  void load(const std::filesystem::path& map_path, const std::filesystem::path& strokes_path,
            const OwnTablet& onto, int grid_size = 0);

  /// Writes the tablet at `size` samples a side. @param own_map  the tablet keeps the size of its own map.
  void save(const Tablet& tablet, const std::filesystem::path& path, FileFormat format, int size,
            bool own_map);

  /// The grid of a stroke file, which does not say how large it is.
  struct GridGuess {
    int side = kClassicSize;  ///< smallest power of two from 128 on that holds every point
    bool certain = false;     ///< the points fill more than half of the 2005 grid
  };
  /// @return the errors of StrokeOrder::load.
  [[nodiscard]] static base::Result<GridGuess> guess_grid(const std::filesystem::path& strokes_path);

  base::Signal<char32_t, const Tablet&> carved;
  base::Signal<const OwnTablet&> loaded;
  base::Signal<const std::filesystem::path&> saved;
  /// Nothing was changed. The path is that of the file it is about, empty for carving.
  base::Signal<const std::filesystem::path&, const base::Error&> failed;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
