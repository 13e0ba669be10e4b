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

/// The formats in which a plot can be written.
enum class PlotFile : std::uint8_t {
  document,  ///< expression and settings, to open again
  raw,       ///< 8-bit height map
  png,       ///< 16-bit height map
  print,     ///< black and white, for swell paper
  sound,     ///< the sweep, WAV
};

/// The extension of a file name without the dot: "png".
[[nodiscard]] std::string_view extension_of(PlotFile kind);
/// Whether the plot can be written in this format: a surface has neither lines to print nor a curve to play.
[[nodiscard]] bool can_be_written(const Plot& plot, PlotFile kind);
/// Writes the file completely or not at all.
/// @param document  for PlotFile::document; for a sound its settings.
/// @return the errors of the functions that save the formats.
[[nodiscard]] base::Result<void> save_plot(PlotFile kind, const std::filesystem::path& path,
                                           const Drawing& drawing, const PlotDocument& document);

/// Writes plots to files and computes their sweeps on separate threads. Files are written in the order of the
/// requests. Thread: the owner of the inbox.
class PlotExport {
 public:
  /// @param inbox  outlives this object.
  explicit PlotExport(base::Inbox& inbox);

  void write(PlotFile kind, std::filesystem::path path, SharedDrawing drawing, PlotDocument document);
  /// Of several requests only the newest is answered.
  void compose(SharedDrawing drawing, const SoundSettings& settings);
  /// Cancels the computation of a sweep.
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
  base::Background files_;  // declared last, so that its thread ends before the members it uses are destroyed
};

}  // namespace nazori::functions
