// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/sheet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <latch>

#include "inside.h"

namespace nazori::paint {
namespace {

using base::Errc;

constexpr std::array kSizes{128, 256, 512, 1024};
constexpr double kFinestCell_m = 1e-4;
// In cells^2 a step. Above it a cell could give more than it has.
constexpr double kMostConductivity = 0.125;
static_assert(kMostFixed + std::int64_t{2} * kMostMoving <= INT32_MAX);

bool has_pigment(const Pigment& pigment) {
  const auto fine = [](const Bands& bands) {
    return std::all_of(bands.begin(), bands.end(), [](double b) { return b >= 0 && b <= 100; });
  };
  return fine(pigment.absorption) && fine(pigment.scattering) && pigment.mobility >= 0 &&
         pigment.mobility <= 1 && pigment.granulation >= 0 && pigment.granulation <= 1;
}

void fill_grain(Sheet::Inside& sheet) {
  const Grain grain = make_grain(sheet.size, sheet.paper.grain_m, sheet.paper.seed);
  const int last = sheet.size - 1;
  for (std::size_t t = 0; t < sheet.tiles.size(); ++t) {
    Tile& tile = *sheet.tiles[t];
    const int column0 = static_cast<int>(t) % sheet.tiles_a_side * kTile;
    const int row0 = static_cast<int>(t) / sheet.tiles_a_side * kTile;
    // The border of the sheet is repeated beyond it.
    const auto from = [&](int x, int y) {
      const int column = std::clamp(column0 + x, 0, last), row = std::clamp(row0 + y, 0, last);
      return static_cast<std::size_t>(row) * static_cast<std::size_t>(sheet.size) +
             static_cast<std::size_t>(column);
    };
    for (int y = 0; y < kPaperRows; ++y) {
      for (int x = 0; x < kTile; ++x) {
        const std::size_t to = static_cast<std::size_t>(y) * kTile + static_cast<std::size_t>(x);
        tile.height[to] = grain.height[from(x, y - 1)];
        tile.density[to] = grain.density[from(x, y - 1)];
      }
    }
    for (const Side side : {left, right}) {
      for (int y = 0; y < kTile; ++y) {
        const auto at = from(side == left ? -1 : kTile, y), to = static_cast<std::size_t>(y);
        tile.height_beside[side][to] = grain.height[at];
        tile.density_beside[side][to] = grain.density[at];
      }
    }
  }
}

std::array<const Tile*, 4> neighbours_of(const Sheet::Inside& sheet, std::size_t index) {
  const auto side = static_cast<std::size_t>(sheet.tiles_a_side);
  const std::size_t x = index % side, y = index / side;
  return {x > 0 ? sheet.tiles[index - 1].get() : nullptr,
          x + 1 < side ? sheet.tiles[index + 1].get() : nullptr,
          y > 0 ? sheet.tiles[index - side].get() : nullptr,
          y + 1 < side ? sheet.tiles[index + side].get() : nullptr};
}

constexpr std::array<Side, 4> kFacing{right, left, bottom, top};

bool faces_change(const std::array<const Tile*, 4>& neighbours) {
  for (std::size_t i = 0; i < 4; ++i)
    if (neighbours[i] != nullptr && (neighbours[i]->edges_changed >> kFacing[i] & 1U) != 0) return true;
  return false;
}

/// A layer that dried long ago is covered by water that flows over it now.
void cover_tile(const Sheet::Inside& sheet, Tile& tile) {
  for (std::size_t cell = 0; cell < kCells; ++cell) sheet.cover(tile, cell);
}

void run_tile(Sheet::Inside& sheet, const Surrounded& now, const Surrounded* next) {
  Tile& tile = *now.tile;
  const bool was_wet = tile.is_wet;
  tile.has_changed = step_tile(sheet.rules, now, next);
  // The fields are still in the cache.
  if (tile.has_changed) prepare_edges(tile);
  if (!was_wet && tile.is_wet) cover_tile(sheet, tile);
}

}  // namespace

void Sheet::Inside::cover(Tile& tile, std::size_t cell) const {
  std::int64_t amount = tile.ground ? tile.ground->covered[cell] : 0;
  const std::int64_t before = amount;
  for (const Field& fixed : tile.fixed) amount += fixed[cell];
  if (amount == before || amount > INT32_MAX) return;
  if (!tile.ground) {
    tile.ground = std::make_unique<Ground>();
    for (std::size_t band = 0; band < 3; ++band)
      tile.ground->reflectance[band].fill(static_cast<float>(paper_inside[band]));
  }
  for (std::size_t band = 0; band < 3; ++band) {
    double kx = 0, sx = 0;
    for (std::size_t k = 0; k < kSlots; ++k) {
      const double x = to_fraction(tile.fixed[k][cell]);
      kx += palette[k].absorption[band] * x;
      sx += palette[k].scattering[band] * x;
    }
    float& below = tile.ground->reflectance[band][cell];
    below = static_cast<float>(reflectance_over(layer_of(kx, sx), static_cast<double>(below)));
  }
  tile.ground->covered[cell] = static_cast<Amount>(amount);
  for (Field& fixed : tile.fixed) fixed[cell] = 0;
}

void Sheet::Inside::make_rules() {
  const double cell_m = kSide_m / size;
  rules = {};
  const double conductivity = paper.spread_m2_s * kStep_s / (cell_m * cell_m) / kOne;
  rules.conductivity = static_cast<float>(conductivity);
  rules.conductivity_loss = static_cast<float>(conductivity * paper.spread_variation);
  rules.pinning = static_cast<float>(paper.pinning * kOne);
  rules.pinning_height = static_cast<float>(paper.pinning_height * kOne);
  rules.pinning_density = static_cast<float>(paper.pinning_fibre * kOne);
  rules.absorption = to_amount(paper.absorption_s > kStep_s ? kStep_s / paper.absorption_s : 1);
  const double evaporation = paper.drying_s > 0 ? kStep_s / paper.drying_s : 0;
  rules.evaporation = to_amount(evaporation);
  // The rim is a line: its cells lose as much for each length of it, however large they are.
  rules.rim_evaporation = to_amount(evaporation * paper.rim_drying / 4 * (kFinestCell_m / cell_m));
  rules.fixing = paper.fixing_s > 0 ? static_cast<float>(std::min(kStep_s / paper.fixing_s, 0.5)) : 0.0F;
  for (std::size_t k = 0; k < kSlots; ++k) {
    rules.granulation[k] = static_cast<float>(paper.granulation * palette[k].granulation);
    rules.mobility[k] = static_cast<float>(palette[k].mobility);
  }
}

void Sheet::Inside::settle(Tile& tile) {
  tile.slots = 0;
  tile.is_wet = false;
  for (std::size_t cell = 0; cell < kCells; ++cell)
    tile.is_wet = tile.is_wet || tile.surface[cell] != 0 || tile.fibre[cell] != 0;
  for (std::size_t k = 0; k < kSlots; ++k) {
    Amount any = 0;
    for (std::size_t cell = 0; cell < kCells; ++cell) any |= tile.moving[k][cell] | tile.fixed[k][cell];
    if (any != 0) tile.slots |= static_cast<std::uint8_t>(1U << k);
  }
  touch_tile(tile);
}

Sheet::Sheet(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Sheet::Sheet(Sheet&&) noexcept = default;
Sheet& Sheet::operator=(Sheet&&) noexcept = default;
Sheet::~Sheet() = default;

base::Result<Sheet> Sheet::create(int size, const Paper& paper, const std::array<Pigment, kSlots>& palette) {
  if (std::find(kSizes.begin(), kSizes.end(), size) == kSizes.end())
    return base::fail(Errc::bad_argument, "is not the size of a sheet", std::to_string(size),
                      "give 128, 256, 512 or 1024 cells");
  if (auto fine = check(paper); !fine) return tl::unexpected(std::move(fine).error());
  for (const Pigment& pigment : palette)
    if (!has_pigment(pigment))
      return base::fail(Errc::bad_argument, "has a value outside its range", pigment.name,
                        "give K and S of 0 to 100, mobility and granulation of 0 to 1");
  const double cell_m = kSide_m / size;
  const double fastest = kMostConductivity * cell_m * cell_m / kStep_s;
  // The product of a paper that was made for this limit may lie a rounding above it.
  if (paper.spread_m2_s > fastest * (1 + 1e-12))
    return base::fail(Errc::bad_argument, "spread_m2_s is too fast for a sheet of this size", paper.name,
                      "give at most " + std::to_string(fastest * 1e9) + "e-9, or a sheet of fewer cells");
  auto inside = std::make_unique<Inside>();
  inside->size = size;
  inside->tiles_a_side = size / kTile;
  inside->paper = paper;
  inside->palette = palette;
  for (std::size_t band = 0; band < 3; ++band)
    inside->paper_inside[band] = inside_from_seen(paper.colour[band]);
  inside->make_rules();
  const auto tiles =
      static_cast<std::size_t>(inside->tiles_a_side) * static_cast<std::size_t>(inside->tiles_a_side);
  for (std::size_t i = 0; i < tiles; ++i) inside->tiles.push_back(std::make_unique<Tile>());
  fill_grain(*inside);
  return Sheet(std::move(inside));
}

int Sheet::size() const { return inside_->size; }
TotalAmount Sheet::area() const {
  const TotalAmount side = kLargest / inside_->size;
  return side * side;
}
const Paper& Sheet::paper() const { return inside_->paper; }
const std::array<Pigment, kSlots>& Sheet::palette() const { return inside_->palette; }

base::Result<void> Sheet::set_pigment(int slot, const Pigment& pigment) {
  if (slot < 0 || slot >= kSlots)
    return base::fail(Errc::bad_argument, "there is no such slot", std::to_string(slot), "give 0, 1 or 2");
  if (!has_pigment(pigment))
    return base::fail(Errc::bad_argument, "has a value outside its range", pigment.name,
                      "give K and S of 0 to 100, mobility and granulation of 0 to 1");
  const auto k = static_cast<std::size_t>(slot);
  if (inside_->palette[k] == pigment) return {};
  for (const auto& tile : inside_->tiles) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      const bool is_wet = (tile->surface[cell] | tile->fibre[cell]) != 0 && tile->fixed[k][cell] != 0;
      if (tile->moving[k][cell] != 0 || is_wet)
        return base::fail(Errc::bad_argument, "the paint is still wet", inside_->palette[k].name,
                          "let the sheet dry first");
    }
  }
  for (const auto& tile : inside_->tiles) {
    if ((tile->slots >> k & 1U) == 0) continue;
    for (std::size_t cell = 0; cell < kCells; ++cell)
      if (tile->fixed[k][cell] != 0) inside_->cover(*tile, cell);
    inside_->touch_tile(*tile);
  }
  inside_->palette[k] = pigment;
  inside_->make_rules();
  return {};
}

Cell Sheet::at(int column, int row) const {
  assert(column >= 0 && column < size() && row >= 0 && row < size());
  const Tile& tile = inside_->tile_at(column, row);
  const std::size_t i = Inside::cell_at(column, row);
  Cell cell;
  cell.surface = tile.surface[i];
  cell.fibre = tile.fibre[i];
  for (std::size_t k = 0; k < kSlots; ++k) {
    cell.moving[k] = tile.moving[k][i];
    cell.fixed[k] = tile.fixed[k][i];
  }
  cell.covered = tile.ground ? tile.ground->covered[i] : 0;
  cell.height = tile.height[Sheet::Inside::paper_at(column, row)] / 65535.0;
  return cell;
}

std::pair<Amount, PigmentAmounts> Sheet::drop(int column, int row, Amount water,
                                              const PigmentAmounts& pigment) {
  assert(column >= 0 && column < size() && row >= 0 && row < size());
  Tile& tile = inside_->tile_at(column, row);
  const std::size_t i = Inside::cell_at(column, row);
  if (tile.surface[i] == 0 && tile.fibre[i] == 0) inside_->cover(tile, i);
  std::pair<Amount, PigmentAmounts> taken{};
  taken.first = std::clamp(kMostWater - tile.surface[i] - tile.fibre[i], 0, std::max(water, 0));
  tile.surface[i] += taken.first;
  for (std::size_t k = 0; k < kSlots; ++k) {
    const Amount room = std::max(kMostMoving - tile.moving[k][i], 0);
    taken.second[k] = std::clamp(pigment[k], 0, room);
    tile.moving[k][i] += taken.second[k];
    if (taken.second[k] != 0) tile.slots |= static_cast<std::uint8_t>(1U << k);
  }
  if (taken.first != 0) tile.is_wet = true;
  inside_->touch_tile(tile);
  return taken;
}

void Sheet::step(const StepOptions& options) {
  Inside& sheet = *inside_;
  if (sheet.is_frozen) return;
  for (const auto& tile : sheet.tiles) {
    tile->edges_changed = 0;
    if (tile->has_changed) publish_edges(*tile);
  }
  std::vector<Surrounded> work;
  for (std::size_t i = 0; i < sheet.tiles.size(); ++i) {
    Tile& tile = *sheet.tiles[i];
    const auto neighbours = neighbours_of(sheet, i);
    if (options.sleep && !tile.has_changed && !faces_change(neighbours)) continue;
    Surrounded one{&tile, {}};
    for (std::size_t side = 0; side < 4; ++side)
      one.neighbours[side] =
          neighbours[side] != nullptr ? &shown_edge(*neighbours[side], kFacing[side]) : nullptr;
    work.push_back(one);
  }
  const auto run = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      run_tile(sheet, work[i], i + 1 < last ? &work[i + 1] : nullptr);
  };
  const std::size_t half = options.threads > 1 ? work.size() / 2 : work.size();
  if (half < work.size()) {
    if (!sheet.second) sheet.second = std::make_unique<base::Executor>("paint");
    std::latch done(1);
    sheet.second->post([&] {
      run(half, work.size());
      done.count_down();
    });
    run(0, half);
    done.wait();
  } else {
    run(0, half);
  }
  sheet.awake = static_cast<int>(work.size());
  for (const Surrounded& one : work)
    if (one.tile->has_changed) one.tile->version = ++sheet.versions;
}

void Sheet::dry_now() {
  for (const auto& tile : inside_->tiles) {
    if (!tile->is_wet && tile->slots == 0) continue;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      tile->evaporated += tile->surface[cell] + tile->fibre[cell];
      tile->surface[cell] = tile->fibre[cell] = 0;
      for (std::size_t k = 0; k < kSlots; ++k) {
        if (tile->fixed[k][cell] + tile->moving[k][cell] > kMostFixed) inside_->cover(*tile, cell);
        // More than a cell can hold stays on it as it is.
        const Amount fixes = std::min(tile->moving[k][cell], kMostFixed - tile->fixed[k][cell]);
        tile->fixed[k][cell] += fixes;
        tile->moving[k][cell] -= fixes;
      }
    }
    inside_->settle(*tile);
  }
}

void Sheet::set_frozen(bool frozen) { inside_->is_frozen = frozen; }
bool Sheet::is_frozen() const { return inside_->is_frozen; }

bool Sheet::is_wet() const {
  return std::any_of(inside_->tiles.begin(), inside_->tiles.end(),
                     [](const auto& tile) { return tile->is_wet; });
}

TotalAmount Sheet::evaporated() const {
  TotalAmount sum = 0;
  for (const auto& tile : inside_->tiles) sum += tile->evaporated;
  return sum;
}

Holding Sheet::holding() const {
  Holding sum;
  for (const auto& tile : inside_->tiles) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      sum.water += TotalAmount{tile->surface[cell]} + tile->fibre[cell];
      for (std::size_t k = 0; k < kSlots; ++k)
        sum.pigment[k] += TotalAmount{tile->moving[k][cell]} + tile->fixed[k][cell];
      if (tile->ground) sum.covered += tile->ground->covered[cell];
    }
  }
  return sum;
}

int Sheet::tiles_awake() const { return inside_->awake; }

bool Sheet::is_same_as(const Sheet& other) const {
  const Inside &a = *inside_, &b = *other.inside_;
  if (a.size != b.size || a.paper != b.paper || a.palette != b.palette || a.is_frozen != b.is_frozen)
    return false;
  for (std::size_t i = 0; i < a.tiles.size(); ++i) {
    const Tile &s = *a.tiles[i], &t = *b.tiles[i];
    if (s.surface != t.surface || s.fibre != t.fibre || s.moving != t.moving || s.fixed != t.fixed ||
        s.evaporated != t.evaporated || static_cast<bool>(s.ground) != static_cast<bool>(t.ground) ||
        (s.ground && *s.ground != *t.ground))
      return false;
  }
  return true;
}

}  // namespace nazori::paint
