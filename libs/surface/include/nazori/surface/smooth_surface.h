// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {

/// Height and slope at a place.
struct SurfacePoint {
  double height;    ///< [0, 1] as HeightMap
  double d_column;  ///< change of height per sample to the right
  double d_row;     ///< change of height per sample downwards
};

/// A surface without steps in height or slope through (close to) the samples of a height map, made to be
/// asked a million times a second. Immutable. Thread-safe: yes. Real-time-safe: at() and height() yes.
class SmoothSurface {
 public:
  /// @return Errc::bad_argument for an empty map.
  [[nodiscard]] static base::Result<std::shared_ptr<const SmoothSurface>> create(const HeightMap& map);

  [[nodiscard]] int size() const noexcept { return size_; }
  /// Outside the grid the nearest edge goes on level. @param column,row  finite.
  [[nodiscard]] SurfacePoint at(double column, double row) const noexcept;

 private:
  explicit SmoothSurface(const HeightMap& map);
  int size_;
  std::vector<float> samples_;
};

}  // namespace nazori::surface
