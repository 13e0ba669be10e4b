// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "nazori/base/latest.h"
#include "nazori/base/signal.h"
#include "nazori/functions/drawing.h"
#include "nazori/functions/plot_document.h"
#include "nazori/functions/sound.h"

namespace nazori::functions {

/// What a plot can be written as.
enum class PlotFile : std::uint8_t {
  document,  ///< expression and settings, to open again
  raw,       ///< 8-bit height map
  png,       ///< 16-bit height map
  print,     ///< black and white, for swell paper
  sound,     ///< the sweep, WAV
};

/// The end of a file's name without the dot: "png".
[[nodiscard]] std::string_view extension_of(PlotFile kind);
/// Whether there is something to write: a surface has neither lines to print nor a curve to play.
[[nodiscard]] bool can_be_written(const Plot& plot, PlotFile kind);
/// Writes the file whole or not at all.
/// @param document  of PlotFile::document; of a sound its settings.
/// @return the errors of the functions that save one kind each.
[[nodiscard]] base::Result<void> save_plot(PlotFile kind, const std::filesystem::path& path,
                                           const Drawing& drawing, const PlotDocument& document);

/// Writes plots to files and composes their sweeps, behind the thread that asks. Files are written in the
/// order in which they were asked for. Thread: the owner of the inbox.
class PlotExport {
 public:
  /// @param inbox  outlives this object.
  explicit PlotExport(base::Inbox& inbox);

  void write(PlotFile kind, std::filesystem::path path, SharedDrawing drawing, PlotDocument document);
  /// Of several requests only the newest is answered.
  void compose(SharedDrawing drawing, const SoundSettings& settings);
  /// What is being composed is no longer wanted.
  void forget_sound() { sweep_.cancel(); }

  base::Signal<const std::filesystem::path&> written;
  /// The path is empty where a sweep failed.
  base::Signal<const std::filesystem::path&, const base::Error&> failed;
  base::Signal<const Sound&> composed;

 private:
  struct SweepRequest {
    SharedDrawing drawing;
    SoundSettings settings;
  };

  base::Latest<SweepRequest, base::Result<Sound>> sweep_;
  base::Background files_;  // declared last, so that its thread ends before what it uses
};

}  // namespace nazori::functions
