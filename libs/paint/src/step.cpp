// SPDX-License-Identifier: Apache-2.0
// One step of one tile, row by row: what a few rows need fits into the nearest cache. The loops over cells
// have fixed lengths and no branches, so that the compiler vectorises them.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "inside.h"
#include "wide.h"

namespace nazori::paint {
namespace {

// Cell x of a row is at kFirst + x, so that whole vectors begin at the first cell. The cells of the
// neighbours are beside it.
constexpr std::size_t kFirst = 8;
template <class Number>
using Row = std::array<Number, kFirst + kTile + kFirst>;

constexpr float kPerLevel = 1.0F / 65535.0F;

/// What a row of cells held before the step. It is filled by load().
struct alignas(64) CellRow {
  Row<float> fibre, pinning, conductivity;
  std::array<Row<float>, kSlots> moving, concentration;
  std::uint32_t slots;  // bit k: moving[k] holds something
};

/// What flows through a row of faces.
struct alignas(64) FaceRow {
  Row<std::int32_t> water;
  std::array<Row<std::int32_t>, kSlots> pigment;
};

/// The last rows, of which row 0 is the one above the tile, and the faces beside and between their cells.
struct Window {
  std::array<CellRow, 4> cells;
  std::array<FaceRow, 2> across;  // face x lies before cell x
  std::array<FaceRow, 4> down;    // face x lies above cell x
  CellRow& row(std::size_t i) { return cells[i % cells.size()]; }
  FaceRow& beside(std::size_t i) { return across[i % across.size()]; }
  FaceRow& above(std::size_t i) { return down[i % down.size()]; }
};

/// How the water of a row of cells evaporated.
struct alignas(64) Loss {
  std::array<float, kTile> share;
  std::array<std::int32_t, kTile> is_dry;  // -1 where no water is left
};

struct Changes {
  std::uint32_t any = 0;    // bits that differ
  std::uint32_t water = 0;  // bits of the water that is left
  TotalAmount evaporated = 0;
};

struct Step {
  const StepRules& rules;
  Tile& tile;
  const std::array<const Edge*, 4>& neighbours;
  std::uint32_t slots;
};

bool has(std::uint32_t slots, std::size_t slot) { return (slots >> slot & 1U) != 0; }

Amount bits_of(const Amount* amounts) {
  Amount any = 0;
  for (std::size_t x = 0; x < kTile; ++x) any |= amounts[x];
  return any;
}

/// Bit y: something may change in row y.
std::uint32_t rows_of(const Step& s) {
  std::uint32_t rows = 0;
  for (std::size_t y = 0; y < kTile; ++y) {
    const std::size_t first = y * kTile;
    Amount any = bits_of(s.tile.surface.data() + first) | bits_of(s.tile.fibre.data() + first);
    for (std::size_t k = 0; k < kSlots; ++k)
      if (has(s.tile.slots, k)) any |= bits_of(s.tile.moving[k].data() + first);
    for (const Side side : {left, right})
      if (s.neighbours[side] != nullptr) any |= s.neighbours[side]->fibre[y];
    rows |= static_cast<std::uint32_t>(any != 0) << y;
  }
  // Water also flows into the rows beside it.
  rows |= rows << 1U | rows >> 1U;
  const auto is_wet = [&](Side side) {
    return s.neighbours[side] != nullptr && bits_of(s.neighbours[side]->fibre.data()) != 0;
  };
  return rows | (is_wet(top) ? 1U : 0U) | (is_wet(bottom) ? 1U << (kTile - 1U) : 0U);
}

void load_paper(const Step& s, std::size_t row, CellRow& to) {
  const std::uint16_t* height = s.tile.height.data() + row * kPadded;
  const std::uint16_t* density = s.tile.density.data() + row * kPadded;
  const StepRules rules = s.rules;
  for (std::size_t x = 0; x < kPadded; ++x) {
    const float h = static_cast<float>(height[x]) * kPerLevel;
    const float d = static_cast<float>(density[x]) * kPerLevel;
    to.pinning[kFirst - 1 + x] = rules.pinning + rules.pinning_height * h + rules.pinning_density * d;
    to.conductivity[kFirst - 1 + x] = rules.conductivity - rules.conductivity_loss * d;
  }
}

/// Where the cells of a row are kept.
struct Source {
  const Amount *surface, *fibre;
  std::array<const Amount*, kSlots> moving;
};

Source source_of(const Step& s, std::size_t row) {
  const Edge* edge = row == 0 ? s.neighbours[top] : row > kTile ? s.neighbours[bottom] : nullptr;
  Source from{};
  // Nothing flows through the border of the sheet: beyond it is the same as before it.
  const std::size_t first = (std::clamp<std::size_t>(row, 1, kTile) - 1) * kTile;
  from.surface = edge != nullptr ? edge->surface.data() : s.tile.surface.data() + first;
  from.fibre = edge != nullptr ? edge->fibre.data() : s.tile.fibre.data() + first;
  for (std::size_t k = 0; k < kSlots; ++k)
    from.moving[k] = edge != nullptr ? edge->moving[k].data() : s.tile.moving[k].data() + first;
  return from;
}

float concentration_of(float moving, Amount water) {
  return water > 0 ? moving / static_cast<float>(water) : 0.0F;
}

void load_cells(const Step& s, const Source& from, CellRow& to) {
  for (std::size_t x = 0; x < kTile; ++x) to.fibre[kFirst + x] = static_cast<float>(from.fibre[x]);
  to.slots = 0;
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (!has(s.slots, k)) continue;
    for (std::size_t x = 0; x < kTile; ++x) {
      const auto p = static_cast<float>(from.moving[k][x]);
      to.moving[k][kFirst + x] = p;
      to.concentration[k][kFirst + x] = concentration_of(p, from.surface[x] + from.fibre[x]);
    }
    to.slots |= static_cast<std::uint32_t>(bits_of(from.moving[k]) != 0) << k;
  }
}

/// The cell at `at`, which is beside the one at `own` and belongs to another tile.
void load_beside(const Step& s, Side side, std::size_t y, std::size_t own, std::size_t at, CellRow& to) {
  const Edge* edge = s.neighbours[side];
  to.fibre[at] = edge != nullptr ? static_cast<float>(edge->fibre[y]) : to.fibre[own];
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (!has(s.slots, k)) continue;
    const float p = edge != nullptr ? static_cast<float>(edge->moving[k][y]) : to.moving[k][own];
    to.moving[k][at] = p;
    to.concentration[k][at] =
        edge != nullptr ? concentration_of(p, edge->surface[y] + edge->fibre[y]) : to.concentration[k][own];
    to.slots |= static_cast<std::uint32_t>(p > 0) << k;
  }
}

void load(const Step& s, std::size_t row, CellRow& to) {
  load_paper(s, row, to);
  load_cells(s, source_of(s, row), to);
  if (row == 0 || row > kTile) return;
  load_beside(s, left, row - 1, kFirst, kFirst - 1, to);
  load_beside(s, right, row - 1, kFirst + kTile - 1, kFirst + kTile, to);
}

/// Water that flows from the cell with `a` to the cell with `b`. Both tiles of a border compute the same.
std::int32_t flow(float a, float b, float pinning_a, float pinning_b, float conductivity_a,
                  float conductivity_b) {
  const float q = 0.5F * (conductivity_a + conductivity_b) * ((a - b) * (a + b));
  const bool stops = (static_cast<int>(b <= 0) & static_cast<int>(a <= pinning_b)) |
                     (static_cast<int>(a <= 0) & static_cast<int>(b <= pinning_a));
  return stops ? 0 : static_cast<std::int32_t>(q);
}

/// Pigment that goes with the water `q` from a to b: that of the cell which the water leaves.
std::int32_t carried(std::int32_t q, float mobility, float concentration_a, float concentration_b,
                     float moving_a, float moving_b) {
  const float concentration = q > 0 ? concentration_a : concentration_b;
  const float taker = q > 0 ? moving_b : moving_a;
  const auto p = static_cast<std::int32_t>(mobility * static_cast<float>(q) * concentration);
  return taker > static_cast<float>(kMostMoving) ? 0 : p;
}

/// What flows from the cells of `a` that begin at `from` to as many of `b` that begin at kFirst.
template <std::size_t kCount>
void find_flow(const Step& s, const CellRow& a, std::size_t from, const CellRow& b, FaceRow& faces) {
  for (std::size_t x = 0; x < kCount; ++x) {
    const std::size_t i = from + x, j = kFirst + x;
    faces.water[x] =
        flow(a.fibre[i], b.fibre[j], a.pinning[i], b.pinning[j], a.conductivity[i], b.conductivity[j]);
  }
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (!has(s.slots, k)) continue;
    if (!has(a.slots | b.slots, k)) {
      faces.pigment[k].fill(0);
      continue;
    }
    const float mobility = s.rules.mobility[k];
    const auto &c = a.concentration[k], &d = b.concentration[k], &p = a.moving[k], &q = b.moving[k];
    for (std::size_t x = 0; x < kCount; ++x) {
      const std::size_t i = from + x, j = kFirst + x;
      faces.pigment[k][x] = carried(faces.water[x], mobility, c[i], d[j], p[i], q[j]);
    }
  }
}

void move_water(const Step& s, Window& w, std::size_t row, Loss& loss, Changes& changes) {
  Amount* surface = s.tile.surface.data() + (row - 1) * kTile;
  Amount* fibre = s.tile.fibre.data() + (row - 1) * kTile;
  const auto &over = w.row(row - 1).fibre, &here = w.row(row).fibre, &under = w.row(row + 1).fibre;
  const auto &across = w.beside(row).water, &above = w.above(row).water, &below = w.above(row + 1).water;
  const StepRules rules = s.rules;
  std::uint32_t any = 0, water = 0;
  std::int32_t evaporated = 0;
  for (std::size_t x = 0; x < kTile; ++x) {
    const std::int32_t flowed = fibre[x] + across[x] - across[x + 1] + above[x] - below[x];
    const std::int32_t room = std::max(kOne - flowed, 0);
    const std::int32_t seeps = std::min(std::min(surface[x], room), rules.absorption);
    const std::int32_t on = surface[x] - seeps;
    const std::int32_t in = flowed + seeps;
    const std::size_t i = kFirst + x;
    const std::int32_t dry_sides = static_cast<int>(here[i - 1] <= 0) + static_cast<int>(here[i + 1] <= 0) +
                                   static_cast<int>(over[i] <= 0) + static_cast<int>(under[i] <= 0);
    const std::int32_t most = rules.evaporation + dry_sides * rules.rim_evaporation;
    const std::int32_t from_surface = std::min(on, most);
    const std::int32_t from_fibre = std::min(in, most - from_surface);
    const std::int32_t gone = from_surface + from_fibre;
    const std::int32_t had = on + in;
    loss.share[x] = had > 0 ? static_cast<float>(gone) / static_cast<float>(had) : 0.0F;
    loss.is_dry[x] = had == gone ? -1 : 0;
    any |= static_cast<std::uint32_t>((on - from_surface) ^ surface[x]) |
           static_cast<std::uint32_t>((in - from_fibre) ^ fibre[x]);
    water |= static_cast<std::uint32_t>(had - gone);
    evaporated += gone;
    surface[x] = on - from_surface;
    fibre[x] = in - from_fibre;
  }
  changes.any |= any;
  changes.water |= water;
  changes.evaporated += evaporated;
}

void move_pigment(const Step& s, Window& w, std::size_t row, std::size_t slot, const Loss& loss,
                  Changes& changes) {
  Amount* moving = s.tile.moving[slot].data() + (row - 1) * kTile;
  Amount* fixed = s.tile.fixed[slot].data() + (row - 1) * kTile;
  const std::uint16_t* height = s.tile.height.data() + row * kPadded + 1;
  const auto &across = w.beside(row).pigment[slot], &above = w.above(row).pigment[slot],
             &below = w.above(row + 1).pigment[slot];
  const float fixing = s.rules.fixing, granulation = s.rules.granulation[slot];
  std::uint32_t any = 0;
  for (std::size_t x = 0; x < kTile; ++x) {
    const std::int32_t flowed = moving[x] + across[x] - across[x + 1] + above[x] - below[x];
    // Where nothing is fixed by time, granulation has nothing to act on either.
    const float h = static_cast<float>(height[x]) * kPerLevel;
    const float settling = fixing * (1.0F + granulation * (1.0F - 2.0F * h));
    const float share = std::max(loss.share[x], settling);
    const auto part = static_cast<std::int32_t>(static_cast<float>(flowed) * share);
    // A float of more than 24 bits may have been rounded up.
    const std::int32_t wanted = loss.is_dry[x] != 0 ? flowed : std::min(part, flowed);
    const std::int32_t fixes = std::min(wanted, kMostFixed - fixed[x]);
    any |= static_cast<std::uint32_t>((flowed - fixes) ^ moving[x]) | static_cast<std::uint32_t>(fixes);
    moving[x] = flowed - fixes;
    fixed[x] += fixes;
  }
  changes.any |= any;
}

void move(const Step& s, Window& w, std::size_t row, Changes& changes) {
  Loss loss;
  move_water(s, w, row, loss, changes);
  const std::uint32_t slots = w.row(row - 1).slots | w.row(row).slots | w.row(row + 1).slots;
  for (std::size_t k = 0; k < kSlots; ++k)
    if (has(slots, k)) move_pigment(s, w, row, k, loss, changes);
}

/// The cells of the tile in rows `first` to before `last`.
void step_rows(const Step& s, std::size_t first, std::size_t last, Window& w, Changes& changes) {
  load(s, first - 1, w.row(first - 1));
  // Each turn reads what the turn before it wrote. A read across two fresh writes would have to wait for
  // them.
  for (std::size_t row = first; row < last + 2; ++row) {
    if (row <= last) {
      load(s, row, w.row(row));
      find_flow<kTile>(s, w.row(row - 1), kFirst, w.row(row), w.above(row));
      if (row > first) find_flow<kTile + 1>(s, w.row(row - 1), kFirst - 1, w.row(row - 1), w.beside(row - 1));
    }
    if (row > first + 1) move(s, w, row - 2, changes);
  }
}

/// @return whether there is anything that could change.
NAZORI_WIDE bool step_cells(const Step& s, Changes& changes) {
  std::uint32_t rows = rows_of(s);
  if (rows == 0) return false;
  Window w;
  while (rows != 0) {
    const int first = std::countr_zero(rows);
    const int last = first + std::countr_one(rows >> first);
    step_rows(s, static_cast<std::size_t>(first) + 1, static_cast<std::size_t>(last) + 1, w, changes);
    rows = last < kTile ? rows >> last << last : 0;
  }
  return true;
}

}  // namespace

bool step_tile(const StepRules& rules, Tile& tile, const std::array<const Edge*, 4>& neighbours) {
  std::uint32_t slots = tile.slots;
  for (const Edge* edge : neighbours)
    if (edge != nullptr) slots |= edge->slots;
  Changes changes;
  if (!step_cells({rules, tile, neighbours, slots}, changes)) {
    tile.is_wet = false;
    return false;
  }
  tile.evaporated += changes.evaporated;
  tile.slots = static_cast<std::uint8_t>(slots);
  tile.is_wet = changes.water != 0;
  return changes.any != 0;
}

}  // namespace nazori::paint
