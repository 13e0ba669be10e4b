// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/sheet_picture.h"

#include <algorithm>
#include <cmath>

#include "colour_tables.h"
#include "inside.h"

namespace nazori::paint {
namespace {

/// What the paper is missing of its light while it is wet, 0..1.
float wetness_of(const Tile& tile, std::size_t cell) {
  return std::min(
      static_cast<float>(tile.surface[cell] + tile.fibre[cell]) * (1.0F / static_cast<float>(kOne)), 1.0F);
}

float amount_of(const Tile& tile, std::size_t slot, std::size_t cell) {
  return static_cast<float>(tile.moving[slot][cell] + tile.fixed[slot][cell]) *
         (1.0F / static_cast<float>(kOne));
}

/// The slot of the only pigment in a tile; kSlots where there are several.
std::size_t only_slot(const Tile& tile) {
  switch (tile.slots) {
    case 0:
    case 1:
      return 0;
    case 2:
      return 1;
    case 4:
      return 2;
    default:
      return kSlots;
  }
}

}  // namespace

struct SheetPicture::Inside {
  const Sheet::Inside* sheet = nullptr;
  Paper paper;
  std::array<Pigment, kSlots> palette;
  ColourTables tables;
  std::vector<std::uint64_t> drawn;  // version of each tile
  std::vector<int> changed;
  surface::ColourPicture picture;

  void begin(const Sheet& of) {
    sheet = &of.inside();
    paper = of.paper();
    palette = of.palette();
    tables = ColourTables(palette, sheet->paper_inside);
    // No tile ever has this version.
    drawn.assign(sheet->tiles.size(), ~std::uint64_t{0});
    const auto side = static_cast<std::size_t>(of.size());
    picture = {of.size(), of.size(), std::vector<std::uint8_t>(3 * side * side)};
  }

  [[nodiscard]] std::uint8_t* row_of(std::size_t tile, std::size_t y) {
    const auto side = static_cast<std::size_t>(sheet->tiles_a_side);
    const std::size_t column = tile % side * kTile, row = tile / side * kTile + y;
    return picture.rgb.data() + 3 * (row * static_cast<std::size_t>(picture.width) + column);
  }

  void draw_simple(std::size_t index, const Tile& tile, std::size_t slot) {
    const auto darkening = static_cast<float>(paper.wet_darkening);
    for (std::size_t y = 0; y < kTile; ++y) {
      std::uint8_t* pixel = row_of(index, y);
      for (std::size_t x = 0; x < kTile; ++x, pixel += 3) {
        const std::size_t cell = y * kTile + x;
        const float light = 1 - darkening * wetness_of(tile, cell);
        const auto seen = tables.on_paper(slot, amount_of(tile, slot, cell));
        for (std::size_t band = 0; band < 3; ++band) pixel[band] = ColourTables::screen(seen[band] * light);
      }
    }
  }

  void draw_layers(std::size_t index, const Tile& tile) {
    const auto darkening = static_cast<float>(paper.wet_darkening);
    for (std::size_t y = 0; y < kTile; ++y) {
      std::uint8_t* pixel = row_of(index, y);
      for (std::size_t x = 0; x < kTile; ++x, pixel += 3) {
        const std::size_t cell = y * kTile + x;
        const float light = 1 - darkening * wetness_of(tile, cell);
        std::array<float, 3> ground;
        for (std::size_t band = 0; band < 3; ++band)
          ground[band] = tile.ground ? tile.ground->reflectance[band][cell]
                                     : static_cast<float>(sheet->paper_inside[band]);
        const auto seen = tables.over_ground(
            {amount_of(tile, 0, cell), amount_of(tile, 1, cell), amount_of(tile, 2, cell)}, ground);
        for (std::size_t band = 0; band < 3; ++band) pixel[band] = ColourTables::screen(seen[band] * light);
      }
    }
  }
};

SheetPicture::SheetPicture() : inside_(std::make_unique<Inside>()) {}
SheetPicture::SheetPicture(SheetPicture&&) noexcept = default;
SheetPicture& SheetPicture::operator=(SheetPicture&&) noexcept = default;
SheetPicture::~SheetPicture() = default;

const std::vector<int>& SheetPicture::update(const Sheet& sheet) {
  Inside& in = *inside_;
  in.changed.clear();
  if (in.sheet != &sheet.inside() || in.paper != sheet.paper() || in.palette != sheet.palette())
    in.begin(sheet);
  const auto& tiles = sheet.inside().tiles;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Tile& tile = *tiles[i];
    if (in.drawn[i] == tile.version) continue;
    const std::size_t slot = only_slot(tile);
    if (slot < kSlots && !tile.ground) {
      in.draw_simple(i, tile, slot);
    } else {
      in.draw_layers(i, tile);
    }
    in.drawn[i] = tile.version;
    in.changed.push_back(static_cast<int>(i));
  }
  return in.changed;
}

const surface::ColourPicture& SheetPicture::picture() const { return inside_->picture; }

ScreenColour colour_of(const Sheet& sheet, int column, int row) {
  const Sheet::Inside& in = sheet.inside();
  const Tile& tile = in.tile_at(column, row);
  const std::size_t cell = Sheet::Inside::cell_at(column, row);
  const double light = 1 - in.paper.wet_darkening * static_cast<double>(wetness_of(tile, cell));
  std::array<std::uint8_t, 3> screen{};
  for (std::size_t band = 0; band < 3; ++band) {
    double kx = 0, sx = 0;
    for (std::size_t k = 0; k < kSlots; ++k) {
      const double x = to_fraction(TotalAmount{tile.moving[k][cell]} + tile.fixed[k][cell]);
      kx += in.palette[k].absorption[band] * x;
      sx += in.palette[k].scattering[band] * x;
    }
    const double ground =
        tile.ground ? static_cast<double>(tile.ground->reflectance[band][cell]) : in.paper_inside[band];
    screen[band] = to_screen(seen_from_inside(reflectance_over(layer_of(kx, sx), ground)) * light);
  }
  return {screen[0], screen[1], screen[2]};
}

}  // namespace nazori::paint
