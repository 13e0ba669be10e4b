// SPDX-License-Identifier: Apache-2.0
// What the paper takes from the bristles of a brush.
#include <algorithm>
#include <cmath>
#include <limits>

#include "inside.h"

namespace nazori::paint {
namespace {

using geometry::BristleSegment;

// A bristle leaves this part of the film where it only just touches, all of it where it is pressed fully.
constexpr double kLightTouch = 0.4;
// In cells: a thinner band could pass between the centres of the cells.
constexpr double kLeastRadius = 0.71;

bool is_usable(const BristleSegment& s) {
  return std::isfinite(s.from.x) && std::isfinite(s.from.y) && std::isfinite(s.to.x) &&
         std::isfinite(s.to.y) && std::isfinite(s.width_m) && s.width_m >= 0 && std::isfinite(s.length_m) &&
         s.length_m >= 0 && std::isfinite(s.speed_m_s) && s.speed_m_s >= 0 && s.wetness > 0 &&
         s.wetness <= 1 && s.pigment >= 0 && s.pigment <= 1 && s.pressure >= 0 && s.pressure <= 1;
}

/// A band with round ends, in cells: columns and rows count from the centre of the first cell.
struct Band {
  double ax, ay, bx, by, radius;
  double nx, ny;  // from the middle line to one side

  /// The columns of the band in a row. @return false where there are none.
  [[nodiscard]] bool columns(double y, double& first, double& last) const {
    first = std::numeric_limits<double>::infinity();
    last = -first;
    const auto add_end = [&](double x, double dy) {
      const double square = radius * radius - dy * dy;
      if (square < 0) return;
      const double half = std::sqrt(square);
      first = std::min(first, x - half);
      last = std::max(last, x + half);
    };
    add_end(ax, y - ay);
    add_end(bx, y - by);
    const auto add_side = [&](double sign) {
      const double y0 = ay + sign * ny, y1 = by + sign * ny;
      if ((y < y0) == (y < y1)) return;
      const double x = ax + sign * nx + (bx - ax) * (y - y0) / (y1 - y0);
      first = std::min(first, x);
      last = std::max(last, x);
    };
    add_side(1);
    add_side(-1);
    return first <= last;
  }
};

/// What one bristle brings, and what is left of it.
struct Offer {
  Amount film;                  // water that the cell is to hold
  PigmentAmounts pigment;       // likewise
  std::uint16_t lowest_height;  // of the cells that it reaches
  TotalAmount water_left;       // in units of the sheet
  std::array<TotalAmount, kSlots> pigment_left;
};

void give(Sheet::Inside& sheet, Tile& tile, std::size_t cell, Offer& offer) {
  const Amount has = tile.surface[cell] + tile.fibre[cell];
  const auto water =
      static_cast<Amount>(std::min<TotalAmount>(std::max(offer.film - has, 0), offer.water_left));
  PigmentAmounts pigment{};
  Amount any = water;
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (offer.pigment[k] == 0) continue;
    const Amount wanted = std::max(offer.pigment[k] - tile.moving[k][cell], 0);
    pigment[k] = static_cast<Amount>(std::min<TotalAmount>(wanted, offer.pigment_left[k]));
    any |= pigment[k];
  }
  if (any == 0) return;
  if (has == 0) {
    if (water == 0) return;  // pigment moves only in water
    sheet.cover(tile, cell);
  }
  tile.surface[cell] += water;
  offer.water_left -= water;
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (pigment[k] == 0) continue;
    tile.moving[k][cell] += pigment[k];
    offer.pigment_left[k] -= pigment[k];
    tile.slots |= static_cast<std::uint8_t>(1U << k);
  }
  tile.is_wet = true;
  sheet.touch_tile(tile);
}

void sweep(Sheet::Inside& sheet, const Band& band, Offer& offer) {
  const double last_cell = sheet.size - 1;
  const double top_row = std::ceil(std::min(band.ay, band.by) - band.radius);
  const double bottom_row = std::floor(std::max(band.ay, band.by) + band.radius);
  const auto first_row = static_cast<std::size_t>(std::clamp(top_row, 0.0, last_cell + 1));
  const auto end_row = static_cast<std::size_t>(std::clamp(bottom_row, -1.0, last_cell) + 1);
  for (std::size_t row = first_row; row < end_row; ++row) {
    double first = 0, last = 0;
    if (!band.columns(static_cast<double>(row), first, last)) continue;
    const auto begin = static_cast<std::size_t>(std::clamp(std::ceil(first), 0.0, last_cell + 1));
    const auto end = static_cast<std::size_t>(std::clamp(std::floor(last), -1.0, last_cell) + 1);
    const std::size_t tile_row = row / kTile * static_cast<std::size_t>(sheet.tiles_a_side);
    const std::size_t y = row % kTile;
    for (std::size_t column = begin; column < end; ++column) {
      Tile& tile = *sheet.tiles[tile_row + column / kTile];
      const std::size_t x = column % kTile;
      if (tile.height[(y + 1) * kTile + x] < offer.lowest_height) continue;
      give(sheet, tile, y * kTile + x, offer);
    }
  }
}

/// The share of the cells that a bristle wets: docs/brush.md, "Kasure".
double wetted_share(const Paper& paper, const BristleSegment& s, double wetness) {
  const double resistance = s.speed_m_s * paper.kasure_s;
  const double supply = wetness * s.length_m;
  if (resistance <= 0 || supply >= resistance) return 1;
  return std::pow(supply / resistance, 1 / paper.kasure_exponent);
}

}  // namespace

void Sheet::touch(std::span<const BristleSegment> segments, InkLoad& load) {
  Inside& sheet = *inside_;
  const TotalAmount unit = area();
  const double per_m = size() / kSide_m;
  for (const BristleSegment& s : segments) {
    if (!is_usable(s)) continue;
    const double wetness = s.wetness * load.fullness();
    if (wetness <= 0 || load.tip.water < unit) continue;
    Band band{(s.from.x + kSide_m / 2) * per_m - 0.5,
              (kSide_m / 2 - s.from.y) * per_m - 0.5,
              (s.to.x + kSide_m / 2) * per_m - 0.5,
              (kSide_m / 2 - s.to.y) * per_m - 0.5,
              std::max(s.width_m / 2 * per_m, kLeastRadius),
              0,
              0};
    const double dx = band.bx - band.ax, dy = band.by - band.ay;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!std::isfinite(length)) continue;
    if (length > 0) {
      band.nx = -dy / length * band.radius;
      band.ny = dx / length * band.radius;
    }
    const double film = sheet.paper.film * wetness * (kLightTouch + (1 - kLightTouch) * s.pressure);
    const Concentrations ink = load.concentration();
    const double share = wetted_share(sheet.paper, s, wetness);
    if (share <= 0) continue;
    Offer offer{};
    offer.film = to_amount(film);
    offer.lowest_height = static_cast<std::uint16_t>(std::min(std::ceil((1 - share) * 65536), 65535.0));
    offer.water_left = load.tip.water / unit;
    for (std::size_t k = 0; k < kSlots; ++k) {
      offer.pigment[k] = to_amount(std::min(film * ink[k] * s.pigment, to_fraction(kMostMoving)));
      offer.pigment_left[k] = load.tip.pigment[k] / unit;
    }
    const Offer before = offer;
    sweep(sheet, band, offer);
    const TotalAmount water = (before.water_left - offer.water_left) * unit;
    std::array<TotalAmount, kSlots> pigment{};
    TotalAmount any = water;
    for (std::size_t k = 0; k < kSlots; ++k) {
      pigment[k] = (before.pigment_left[k] - offer.pigment_left[k]) * unit;
      any |= pigment[k];
    }
    if (any != 0) load.give(water, pigment);
  }
}

}  // namespace nazori::paint
