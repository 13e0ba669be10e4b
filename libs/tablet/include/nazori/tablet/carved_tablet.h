// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/label.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/surface/height_map.h"
#include "nazori/surface/smooth_surface.h"
#include "nazori/tablet/tablet_line.h"

namespace nazori::tablet {

/// A carved tablet: a relief and the lines in it, ready to be drawn (height map and lines), felt (surface and
/// paths) and saved. Made from a character's strokes, or from a height map with lines: strokes of a file, or
/// the curves of a plot. Immutable after creation. Thread-safe: yes. Made on a worker thread (milliseconds),
/// never on the servo thread.
class CarvedTablet {
 public:
  /// Carves `lines` at `size` samples a side. A line without an ending is carved as one that stops.
  /// @return the errors of carving::carve.
  [[nodiscard]] static base::Result<std::shared_ptr<const CarvedTablet>> from_lines(
      std::vector<TabletLine> lines, int size, const carving::Brush& brush = {},
      const geometry::TabletShape& shape = {});

  /// Makes a tablet from an existing relief and any number of lines, whose depth is read from the relief.
  /// @param friction  zones with as many samples as the map; null: the material's friction everywhere.
  /// @param labels  texts that are drawn on the tablet and not carved.
  /// @return Errc::bad_argument for an empty map, and for zones of another size.
  [[nodiscard]] static base::Result<std::shared_ptr<const CarvedTablet>> from_height_map(
      surface::HeightMap map, std::vector<TabletLine> lines, const geometry::TabletShape& shape = {},
      std::shared_ptr<const haptics::FrictionZones> friction = nullptr,
      std::vector<geometry::Label> labels = {});

  [[nodiscard]] const surface::HeightMap& height_map() const { return map_; }
  [[nodiscard]] const std::vector<TabletLine>& lines() const { return lines_; }
  [[nodiscard]] const geometry::TabletShape& shape() const { return shape_; }
  [[nodiscard]] const std::shared_ptr<const surface::SmoothSurface>& surface() const { return surface_; }
  /// Centre lines in metres, z at the bottom of the groove: hooks and sweeps rise as they are carved.
  [[nodiscard]] const std::vector<haptics::StrokePath>& paths() const { return paths_; }

  [[nodiscard]] const std::vector<geometry::Label>& labels() const { return labels_; }

  /// Null: the material's friction everywhere.
  [[nodiscard]] const std::shared_ptr<const haptics::FrictionZones>& friction() const { return friction_; }

  /// This tablet as it feels to a stylus whose tip is a ball; 0: a point. Takes as long as
  /// surface::surface_for_ball: for a worker thread where the map is large.
  /// @param radius_m  0..surface::kLargestBall_m, else Errc::bad_argument.
  [[nodiscard]] base::Result<std::shared_ptr<const CarvedTablet>> with_tip(double radius_m) const;
  [[nodiscard]] double tip_radius_m() const { return tip_radius_m_; }

  /// The servo's scene with this tablet and its tip.
  [[nodiscard]] std::shared_ptr<const haptics::HapticScene> scene(const haptics::Material& material,
                                                                  const haptics::Snapping& snapping,
                                                                  const haptics::Guiding& guiding = {}) const;

 private:
  CarvedTablet() = default;
  surface::HeightMap map_;
  std::vector<TabletLine> lines_;
  geometry::TabletShape shape_;
  std::shared_ptr<const surface::SmoothSurface> surface_;
  std::shared_ptr<const surface::SmoothSurface> felt_;  ///< null: surface_
  double tip_radius_m_ = 0;
  std::vector<haptics::StrokePath> paths_;
  std::shared_ptr<const haptics::FrictionZones> friction_;
  std::vector<geometry::Label> labels_;
};

}  // namespace nazori::tablet
