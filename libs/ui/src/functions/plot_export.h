// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <cstdint>

#include "functions/plotter.h"
#include "nazori/functions/plot_document.h"
#include "nazori/functions/sound.h"

namespace nazori::ui {

/// What a plot can be written as.
enum class PlotFile : std::uint8_t {
  document,  ///< expression and settings, to open again
  raw,       ///< 8-bit height map
  png,       ///< 16-bit height map
  print,     ///< black and white, for swell paper
  sound,     ///< the sweep, WAV
};

/// Writes plots to files and composes their sweeps, on a thread of its own. Thread: interface.
class PlotExport final : public QObject {
  Q_OBJECT
 public:
  explicit PlotExport(QObject* parent = nullptr);

  void write(PlotFile kind, const QString& path, const SharedDrawing& drawing,
             const functions::PlotDocument& document);
  /// Of several requests only the newest is answered.
  void compose(const SharedDrawing& drawing, const functions::SoundSettings& settings);
  /// What is being composed is not wanted any more.
  void forget_sound() { ++newest_; }

  [[nodiscard]] static QString suffix(PlotFile kind);
  /// For the file dialog.
  [[nodiscard]] static QString filter(PlotFile kind);

 signals:
  void written(QString path);
  void failed(QString path, nazori::base::Error error);
  void composed(nazori::functions::Sound sound);

 private:
  std::uint64_t newest_ = 0;
  Worker worker_{QStringLiteral("plot export")};
};

}  // namespace nazori::ui
