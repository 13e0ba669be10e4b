// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/surface/height_map.h"

/// The fixed work that haptic renderers are compared on: a made-up kanji of six strokes as an 8-bit height
/// map, and a hand that traces, sweeps and scribbles over it at 1 kHz. All numbers are rounded (heights to 8
/// bits, positions to 2^-24), so that two programs, or two compilers, get the same work; checksums verify it.
///
/// Units of the specification: x, y in [-1, 1], y growing with the row; z = level * 0.05 * 2 / 124. In metres
/// the side is 0.1 m, so one unit is 0.05 m and the grooves are 10.3 mm deep.
namespace nazori::haptics::workload {

struct Point3 {
  double x, y, z;
};

/// The kanji: levels 0..255, row-major, row n = y growing.
struct Kanji {
  int size = 0;
  std::vector<std::uint8_t> levels;
};

[[nodiscard]] Kanji make_kanji(int size);
/// Along each groove there and back at 0.2 units/s, 0.01 deep, wandering sideways, lifted in between.
[[nodiscard]] std::vector<Point3> trace(const Kanji& kanji, std::size_t ticks);
/// Rows 0.031 apart at 1 unit/s, 0.01 deep, along x, then along y, and so on.
[[nodiscard]] std::vector<Point3> sweep(const Kanji& kanji, std::size_t ticks);
/// Wild curves at 3 units/s, 0.005 to 0.045 deep.
[[nodiscard]] std::vector<Point3> scribble(const Kanji& kanji, std::size_t ticks);

/// The six centre lines, at the floor of the grooves.
[[nodiscard]] std::vector<std::vector<Point3>> centre_lines();

/// FNV-1a of the levels, and of the positions in steps of 2^-20.
[[nodiscard]] std::uint64_t checksum(const Kanji& kanji);
[[nodiscard]] std::uint64_t checksum(std::span<const Point3> path);

/// The kanji as a tablet of 0.1 m.
[[nodiscard]] geometry::TabletShape shape();
[[nodiscard]] surface::HeightMap height_map(const Kanji& kanji);
/// Positions in the tablet frame.
[[nodiscard]] std::vector<Vec3> to_metres(std::span<const Point3> path);

}  // namespace nazori::haptics::workload
