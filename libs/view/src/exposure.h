// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/view/tablet_view.h"
#include "relief.h"

namespace nazori::view {

/// How much of the key light and of the sky reaches one sample of a relief. Both 0..1.
struct Exposed {
  float key = 1;
  float sky = 1;
};

/// The same for each sample of a square lattice, row 0 at the top.
struct Exposure {
  int size = 0;
  std::vector<Exposed> samples;
};

/// Grooves are shaded with this part of their depth. With all of it their floors would be dark.
inline constexpr float kShadeDepth = 0.55F;

/// Marches to the horizon: once towards the light, and in eight directions for the sky.
/// @param fine  at the resolution of the picture. The light is found for a lattice half as fine.
[[nodiscard]] Exposure make_exposure(const Relief& fine, const geometry::TabletShape& shape, Hand hand);

/// What reaches the samples of one row of a finer lattice that spans the same square.
class ExposureRow {
 public:
  /// @param exposure  must outlive this.  @param fine  samples a side of the finer lattice, at least 2.
  ExposureRow(const Exposure& exposure, int fine);
  /// Chooses the row of the finer lattice.
  void set_row(int row);
  [[nodiscard]] Exposed at(int column) const {
    const Place& place = places_[static_cast<std::size_t>(column)];
    const Exposed* ends = line_.data() + place.sample;
    return {ends[0].key + (ends[1].key - ends[0].key) * place.beyond,
            ends[0].sky + (ends[1].sky - ends[0].sky) * place.beyond};
  }

 private:
  /// Between a sample of the coarse lattice and the next.
  struct Place {
    int sample;
    float beyond;  ///< 0..1
  };
  const Exposure& exposure_;
  std::vector<Place> places_;  ///< of each column or row of the finer lattice
  std::vector<Exposed> line_;  ///< along the chosen row
};

}  // namespace nazori::view
