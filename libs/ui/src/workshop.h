// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/tablet/carved_tablet.h"
#include "worker.h"

namespace nazori::ui {

using Tablet = std::shared_ptr<const tablet::CarvedTablet>;

/// How a tablet is written to a file.
enum class FileFormat : std::uint8_t {
  raw,      ///< 8-bit height map without header
  png,      ///< 16-bit greyscale height map
  strokes,  ///< the 2005 stroke order
};

/// A tablet that came from files of the learner's own.
struct OwnTablet {
  Tablet tablet;
  QString name;      ///< file names, for people
  int map_size = 0;  ///< samples a side of the map that was loaded; 0: carved from strokes
  bool has_strokes = false;
};

/// Carves tablets, loads and saves them on a thread of its own. Requests return at once; answers come as
/// signals on the thread of this object.
class Workshop final : public QObject {
  Q_OBJECT
 public:
  /// Samples a side of a tablet carved for the window.
  static constexpr int kSize = 1024;
  /// Side of the 2005 grid, proposed where a stroke file does not say its own.
  static constexpr int kClassicSize = 128;

  explicit Workshop(QObject* parent = nullptr);
  ~Workshop() override;

  /// Carves a character; of several requests only the newest is answered. The last few stay at hand.
  void carve(const kanji::Character& character);

  /// Loads a height map and strokes, either or both; an empty path means none. Strokes alone are laid over
  /// `onto` where that is a map from a file (of `onto_size` samples), else carved. @param grid_size  of the
  /// stroke file; 0: that of the map, or as guess_grid says.
  void load(const QString& map_path, const QString& strokes_path, const OwnTablet& onto, int grid_size = 0);

  /// Writes the tablet at `size` samples a side; a tablet from a map of one's own keeps its own size.
  void save(const Tablet& tablet, const QString& path, FileFormat format, int size, bool own_map);

  /// A stroke file does not say how large its grid is.
  struct GridGuess {
    int side = kClassicSize;  ///< smallest power of two from 128 on that holds every point
    bool certain = false;     ///< the points fill more than half of the 2005 grid
  };
  /// @return the errors of StrokeOrder::load.
  [[nodiscard]] static base::Result<GridGuess> guess_grid(const QString& strokes_path);

 signals:
  void carved(char32_t code_point, nazori::ui::Tablet tablet);
  void loaded(nazori::ui::OwnTablet own);
  void saved(QString path);
  /// Nothing was changed. @param path  the file it is about, empty for carving.
  void failed(QString path, nazori::base::Error error);

 private:
  struct Carved {
    char32_t code_point;
    Tablet tablet;
  };
  std::shared_ptr<std::deque<Carved>> recent_;  // touched by the worker only
  std::atomic<std::uint64_t> newest_{0};
  Worker worker_{QStringLiteral("workshop")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
