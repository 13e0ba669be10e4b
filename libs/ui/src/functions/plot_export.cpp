// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_export.h"

#include <utility>

#include "nazori/functions/print_picture.h"

namespace nazori::ui {
namespace {

base::Result<void> save_print(const functions::Tracing& tracing, const std::filesystem::path& path) {
  const auto picture = functions::print_picture(tracing);
  if (!picture) return tl::unexpected(picture.error());
  return surface::save_png(*picture, path, surface::PngDepth::bits_8);
}

base::Result<void> save_sweep(const Drawing& drawing, const functions::SoundSettings& settings,
                              const std::filesystem::path& path) {
  const auto sound = functions::sweep(drawing.asked.plot, drawing.picture.tracing, drawing.points, settings);
  if (!sound) return tl::unexpected(sound.error());
  return functions::save_wav(*sound, path);
}

base::Result<void> save(PlotFile kind, const std::filesystem::path& path, const SharedDrawing& drawing,
                        const functions::PlotDocument& document) {
  switch (kind) {
    case PlotFile::document:
      return functions::save_document(document, path);
    case PlotFile::raw:
      return surface::save_raw(drawing->picture.plate.heights, path);
    case PlotFile::png:
      return surface::save_png(drawing->picture.plate.heights, path, surface::PngDepth::bits_16);
    case PlotFile::print:
      return save_print(drawing->picture.tracing, path);
    case PlotFile::sound:
      return save_sweep(*drawing, document.sound, path);
  }
  return {};
}

}  // namespace

PlotExport::PlotExport(QObject* parent) : QObject(parent) {}

void PlotExport::write(PlotFile kind, const QString& path, const SharedDrawing& drawing,
                       const functions::PlotDocument& document) {
  worker_.post([this, kind, path, drawing, document] {
    const auto saved = save(kind, path.toStdString(), drawing, document);
    worker_.answer([this, path, saved] {
      if (saved)
        emit written(path);
      else
        emit failed(path, saved.error());
    });
  });
}

void PlotExport::compose(const SharedDrawing& drawing, const functions::SoundSettings& settings) {
  const std::uint64_t ticket = ++newest_;
  worker_.post([this, drawing, settings, ticket] {
    auto sound = functions::sweep(drawing->asked.plot, drawing->picture.tracing, drawing->points, settings);
    worker_.answer([this, ticket, sound = std::move(sound)] {
      if (ticket != newest_) return;
      if (sound)
        emit composed(*sound);
      else
        emit failed({}, sound.error());
    });
  });
}

QString PlotExport::suffix(PlotFile kind) {
  switch (kind) {
    case PlotFile::document:
      return QStringLiteral("json");
    case PlotFile::raw:
      return QStringLiteral("raw");
    case PlotFile::png:
    case PlotFile::print:
      return QStringLiteral("png");
    case PlotFile::sound:
      return QStringLiteral("wav");
  }
  return {};
}

QString PlotExport::filter(PlotFile kind) {
  switch (kind) {
    case PlotFile::document:
      return tr("Plots (*.json)");
    case PlotFile::raw:
      return tr("Height maps (*.raw)");
    case PlotFile::png:
    case PlotFile::print:
      return tr("Pictures (*.png)");
    case PlotFile::sound:
      return tr("Sounds (*.wav)");
  }
  return {};
}

}  // namespace nazori::ui
