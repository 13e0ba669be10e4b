// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "nazori/paint/sheet.h"

namespace nazori::paint::test {

/// Paper without fibres: nothing is pinned, nothing dries, nothing settles.
inline Paper even_paper() {
  Paper paper;
  paper.spread_variation = 0;
  paper.pinning = paper.pinning_height = paper.pinning_fibre = 0;
  paper.absorption_s = 0;
  paper.drying_s = 0;
  paper.fixing_s = 0;
  paper.granulation = 0;
  return paper;
}

/// Sumi, vermilion, ultramarine.
inline std::array<Pigment, kSlots> palette() {
  return {find_pigment("sumi").value(), find_pigment("vermilion").value(),
          find_pigment("french-ultramarine").value()};
}

inline Sheet sheet_of(int size, const Paper& paper = {}) {
  return Sheet::create(size, paper, palette()).value();
}

/// A brush full of ink of the pigment in a slot.
inline InkLoad full_of(int slot = 0, double concentration = 1) {
  Concentrations ink{};
  ink[static_cast<std::size_t>(slot)] = concentration;
  return dipped(1e-6, 1, ink, ink);
}

/// A brush of `width_m` as bristles side by side that goes straight from one point to another in `steps`
/// parts.
struct Stroke {
  geometry::PaperPoint from{-0.03, 0}, to{0.03, 0};
  double width_m = 0.008;
  double speed_m_s = 0.05;
  double length_m = 0.008;
  double pressure = 1;
  double wetness = 1;
  int steps = 30;
};

inline std::vector<geometry::BristleSegment> segments_of(const Stroke& s, int step) {
  constexpr int kBristles = 40;
  std::vector<geometry::BristleSegment> segments;
  const geometry::PaperPoint way = s.to - s.from;
  const double length = geometry::length(way);
  const geometry::PaperPoint side{-way.y / length, way.x / length};
  for (int i = 0; i < kBristles; ++i) {
    const geometry::PaperPoint offset = side * (s.width_m * ((i + 0.5) / kBristles - 0.5));
    const auto at = [&](int n) { return s.from + way * (static_cast<double>(n) / s.steps) + offset; };
    segments.push_back({at(step), at(step + 1), s.pressure, 1.5 * s.width_m / kBristles, s.length_m,
                        s.speed_m_s, s.wetness, 1});
  }
  return segments;
}

/// Writes the stroke; `between` runs after each part.
template <class Between>
void write(Sheet& sheet, InkLoad& load, const Stroke& s, const Between& between) {
  for (int step = 0; step < s.steps; ++step) {
    sheet.touch(segments_of(s, step), load);
    between();
  }
}
inline void write(Sheet& sheet, InkLoad& load, const Stroke& s) {
  write(sheet, load, s, [] {});
}

/// Water of brush, paper and air, and pigment of brush and paper, in units of an InkLoad.
struct Everything {
  TotalAmount water = 0;
  TotalAmount pigment = 0;
  friend bool operator==(const Everything&, const Everything&) = default;
};
inline Everything everything(const Sheet& sheet, const InkLoad& load) {
  const Holding held = sheet.holding();
  Everything sum{load.tip.water + load.root.water + (held.water + sheet.evaporated()) * sheet.area(),
                 held.covered * sheet.area()};
  for (std::size_t k = 0; k < kSlots; ++k)
    sum.pigment += load.tip.pigment[k] + load.root.pigment[k] + held.pigment[k] * sheet.area();
  return sum;
}

/// Whether every cell holds what a cell can hold.
inline bool is_sound(const Sheet& sheet) {
  for (int row = 0; row < sheet.size(); ++row) {
    for (int column = 0; column < sheet.size(); ++column) {
      const Cell cell = sheet.at(column, row);
      if (cell.surface < 0 || cell.fibre < 0 || cell.covered < 0 || cell.surface > 16 * kOne ||
          cell.fibre > kOne + 4096)
        return false;
      for (std::size_t k = 0; k < kSlots; ++k)
        if (cell.moving[k] < 0 || cell.fixed[k] < 0 || cell.moving[k] > 16 * kOne ||
            cell.fixed[k] > 10 * kOne)
          return false;
    }
  }
  return true;
}

/// Numbers that look random and are the same everywhere. @source G. Marsaglia, Xorshift RNGs, 2003.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2685821657736338717ULL + 1) {}
  std::uint64_t next() {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return state_;
  }
  int below(int limit) { return static_cast<int>((next() >> 8U) % static_cast<std::uint64_t>(limit)); }
  double within(double least, double most) {
    return least + (most - least) * static_cast<double>(next() >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace nazori::paint::test
