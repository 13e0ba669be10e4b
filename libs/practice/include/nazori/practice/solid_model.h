// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/functions/drawing.h"
#include "nazori/kanji/character.h"
#include "nazori/model/mesh.h"
#include "nazori/model/raised.h"
#include "nazori/model/tablet_plate.h"
#include "nazori/surface/height_map.h"

namespace nazori::practice {

/// A tablet to be touched: lines in the glyph box, and its relief where it has one of its own.
struct SolidTablet {
  std::vector<kanji::StrokeLine> strokes;
  std::optional<surface::HeightMap> relief;  ///< for grooves; nothing: carved from the strokes
};

/// How a tablet becomes a solid.
struct SolidSettings {
  bool raised = true;                  ///< lines for fingers; else grooves for a stylus
  bool mould = false;                  ///< the negative, to cast tablets
  std::optional<double> thickness_mm;  ///< of the plate; nothing: 3 mm with raised lines, else 6 mm
  model::TabletPlateSettings plate;    ///< its thickness is ignored, and its hole in a mould

  /// The thickness of the plate, chosen or usual.
  [[nodiscard]] double thickness() const { return thickness_mm.value_or(raised ? 3 : 6); }
};

/// A solid, ready to be written.
struct Solid {
  model::Mesh mesh;
  double width_mm = 0;
  double height_mm = 0;
  double thickness_mm = 0;          ///< from the table to the highest point
  double error_mm = 0;              ///< greatest distance from the relief
  std::vector<int> without_number;  ///< strokes (from 1) for whose number there was no room

  /// Whether the mesh is closed, as printers need it.
  [[nodiscard]] bool is_watertight() const { return model::open_edges(mesh) == 0; }
};

/// The strokes of a tablet as fingers read them: sweeps and hooks sink at their end.
[[nodiscard]] std::vector<model::RaisedStroke> raised_strokes(std::span<const kanji::StrokeLine> strokes);

/// A plate that becomes a solid.
struct SolidPlate {
  model::Plate plate;
  double tolerance_mm = 0.02;       ///< how far the mesh may be from it
  std::vector<int> without_number;  ///< strokes (from 1) for whose number there was no room
};

/// The plate of one or more tablets. @param brush  for those that are carved.
/// @return Errc::bad_argument for no tablet, a raised tablet without strokes, and as model::Plate::create().
[[nodiscard]] base::Result<SolidPlate> tablet_plate(std::span<const SolidTablet> tablets,
                                                    const SolidSettings& settings,
                                                    const carving::Brush& brush = {});

/// A plot as fingers read it: its curves, its axes where they are visible, and its ticks. A surface refers to
/// the relief of the picture.
[[nodiscard]] model::RaisedPlot raised_plot_of(const functions::Plot& plot,
                                               const functions::Picture& picture);

/// The plate of a plot: raised curves or a raised surface, axes, and ticks with numbers in braille.
/// @param side_mm  of the square of the plot. @param mould  the negative, to cast it.
/// @return the errors of model::raised_plot().
[[nodiscard]] base::Result<SolidPlate> plot_plate(const functions::Plot& plot,
                                                  const functions::Picture& picture, double side_mm,
                                                  bool mould = false);

/// The closed mesh of a plate. @return the errors of model::mesh_of().
[[nodiscard]] base::Result<Solid> solid_of(const SolidPlate& plate);

/// Writes a solid, completely or not at all: 3MF where the name ends in .3mf, else STL.
/// @param subject  the name of the object in a 3MF. @return the errors of model::to_3mf() and
/// base::write_file().
[[nodiscard]] base::Result<void> save_solid(const Solid& solid, const std::filesystem::path& path,
                                            const std::string& subject);

/// A grey picture, row by row from the top.
struct ReliefPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
};
/// A plate seen from above, in light from the upper left.
/// @param most  samples of its longer side.
[[nodiscard]] ReliefPicture relief_picture(const model::Plate& plate, int most);

}  // namespace nazori::practice
