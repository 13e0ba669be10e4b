// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_export.h"

#include <utility>

#include "nazori/functions/print_picture.h"

namespace nazori::functions {
namespace {

base::Result<void> save_print(const Tracing& tracing, const std::filesystem::path& path) {
  const auto picture = print_picture(tracing);
  if (!picture) return tl::unexpected(picture.error());
  return surface::save_png(*picture, path, surface::PngDepth::bits_8);
}

base::Result<Sound> sweep_of(const Drawing& drawing, const SoundSettings& settings) {
  return sweep(drawing.request.plot, drawing.picture.tracing, drawing.points, settings);
}

base::Result<void> save_sweep(const Drawing& drawing, const SoundSettings& settings,
                              const std::filesystem::path& path) {
  const auto sound = sweep_of(drawing, settings);
  if (!sound) return tl::unexpected(sound.error());
  return save_wav(*sound, path);
}

}  // namespace

std::string_view extension_of(PlotFile kind) {
  switch (kind) {
    case PlotFile::document:
      return "json";
    case PlotFile::raw:
      return "raw";
    case PlotFile::png:
    case PlotFile::print:
      return "png";
    case PlotFile::sound:
      return "wav";
  }
  return {};
}

bool can_be_written(const Plot& plot, PlotFile kind) {
  return !plot.is_surface() || (kind != PlotFile::print && kind != PlotFile::sound);
}

base::Result<void> save_plot(PlotFile kind, const std::filesystem::path& path, const Drawing& drawing,
                             const PlotDocument& document) {
  switch (kind) {
    case PlotFile::document:
      return save_document(document, path);
    case PlotFile::raw:
      return surface::save_raw(drawing.picture.plate.heights, path);
    case PlotFile::png:
      return surface::save_png(drawing.picture.plate.heights, path, surface::PngDepth::bits_16);
    case PlotFile::print:
      return save_print(drawing.picture.tracing, path);
    case PlotFile::sound:
      return save_sweep(drawing, document.sound, path);
  }
  return {};
}

PlotExport::PlotExport(base::Inbox& inbox)
    : sweep_(
          "plot sweep", inbox,
          [](const SweepRequest& request, const auto&) {
            return sweep_of(*request.drawing, request.settings);
          },
          [this](const base::Result<Sound>& sound) {
            if (sound)
              composed(*sound);
            else
              failed({}, sound.error());
          }),
      files_("plot export", inbox) {}

void PlotExport::write(PlotFile kind, std::filesystem::path path, SharedDrawing drawing,
                       PlotDocument document) {
  files_.post(
      [this, kind, path = std::move(path), drawing = std::move(drawing), document = std::move(document)] {
        auto saved = save_plot(kind, path, *drawing, document);
        files_.answer([this, path, saved = std::move(saved)] {
          if (saved)
            written(path);
          else
            failed(path, saved.error());
        });
      });
}

void PlotExport::compose(SharedDrawing drawing, const SoundSettings& settings) {
  sweep_.request({std::move(drawing), settings});
}

}  // namespace nazori::functions
