// SPDX-License-Identifier: Apache-2.0
// One step of one tile. The loops have fixed lengths and no branches, so that the compiler vectorises them.
#include <algorithm>
#include <cstdint>

#include "inside.h"

namespace nazori::paint {
namespace {

constexpr int kRow = kTile + 4;  // one cell of each neighbour, and room to keep rows apart
using Local = std::array<std::array<float, kRow>, kTile + 2>;
/// The flow through the faces of the cells: faces[y][x] lies before cell x of row y.
using Faces = std::array<std::array<std::int32_t, kRow>, kTile + 1>;

constexpr float kPerLevel = 1.0F / 65535.0F;

struct Scratch {
  Local fibre, pinning, conductivity;
  Local concentration, moving;
  Faces across, down;  // water
  std::array<Faces, kSlots> pigment_across, pigment_down;
  std::array<std::array<float, kTile>, kTile> loss;           // share of the water that evaporated
  std::array<std::array<std::int32_t, kTile>, kTile> is_dry;  // -1 where no water is left
};

std::uint8_t bit(Side side) { return static_cast<std::uint8_t>(1U << side); }

void publish(Tile& tile, Side side, std::size_t first, std::size_t stride) {
  Edge edge;
  for (std::size_t i = 0; i < kTile; ++i) {
    const std::size_t cell = first + i * stride;
    edge.fibre[i] = tile.fibre[cell];
    edge.water[i] = tile.fibre[cell] + tile.surface[cell];
  }
  for (std::size_t k = 0; k < kSlots; ++k) {
    if ((tile.slots >> k & 1U) == 0) continue;
    for (std::size_t i = 0; i < kTile; ++i) edge.moving[k][i] = tile.moving[k][first + i * stride];
  }
  if (edge == tile.edges[side]) return;
  tile.edges[side] = edge;
  tile.edges_changed |= bit(side);
}

/// Rows of a tile in which something can change.
struct Rows {
  std::size_t first = kTile, last = 0;  // from first to before last
  void include(std::size_t y) {
    first = std::min(first, y);
    last = std::max(last, y + 1);
  }
};

Rows rows_of(const Tile& tile, std::uint8_t slots, const std::array<const Edge*, 4>& neighbours) {
  Rows rows;
  for (std::size_t y = 0; y < kTile; ++y) {
    Amount any = 0;
    for (std::size_t x = y * kTile; x < (y + 1) * kTile; ++x) any |= tile.surface[x] | tile.fibre[x];
    for (std::size_t k = 0; k < kSlots; ++k) {
      if ((slots >> k & 1U) == 0) continue;
      for (std::size_t x = y * kTile; x < (y + 1) * kTile; ++x) any |= tile.moving[k][x];
    }
    if (neighbours[left] != nullptr) any |= neighbours[left]->fibre[y];
    if (neighbours[right] != nullptr) any |= neighbours[right]->fibre[y];
    if (any == 0) continue;
    // Water also flows into the rows beside it.
    rows.include(y > 0 ? y - 1 : 0);
    rows.include(std::min<std::size_t>(y + 1, kTile - 1));
  }
  const auto is_wet = [](const Edge* edge) {
    Amount any = 0;
    for (std::size_t i = 0; edge != nullptr && i < kTile; ++i) any |= edge->fibre[i];
    return any != 0;
  };
  if (is_wet(neighbours[top])) rows.include(0);
  if (is_wet(neighbours[bottom])) rows.include(kTile - 1);
  return rows;
}

void load_fibre(const Tile& tile, const std::array<const Edge*, 4>& neighbours, Local& fibre) {
  for (std::size_t y = 0; y < kTile; ++y) {
    const Amount* row = tile.fibre.data() + y * kTile;
    for (std::size_t x = 0; x < kTile; ++x) fibre[y + 1][x + 1] = static_cast<float>(row[x]);
  }
  // Nothing flows through the border of the sheet: beyond it is as much water as before it.
  for (std::size_t i = 0; i < kTile; ++i) {
    fibre[i + 1][0] = neighbours[left] ? static_cast<float>(neighbours[left]->fibre[i]) : fibre[i + 1][1];
    fibre[i + 1][kTile + 1] =
        neighbours[right] ? static_cast<float>(neighbours[right]->fibre[i]) : fibre[i + 1][kTile];
    fibre[0][i + 1] = neighbours[top] ? static_cast<float>(neighbours[top]->fibre[i]) : fibre[1][i + 1];
    fibre[kTile + 1][i + 1] =
        neighbours[bottom] ? static_cast<float>(neighbours[bottom]->fibre[i]) : fibre[kTile][i + 1];
  }
}

float concentration_of(float moving, float water) { return water > 0 ? moving / water : 0.0F; }

void load_pigment(const Tile& tile, const std::array<const Edge*, 4>& neighbours, std::size_t slot,
                  Scratch& s) {
  for (std::size_t y = 0; y < kTile; ++y) {
    const Amount* moving = tile.moving[slot].data() + y * kTile;
    const Amount* surface = tile.surface.data() + y * kTile;
    const Amount* fibre = tile.fibre.data() + y * kTile;
    for (std::size_t x = 0; x < kTile; ++x) {
      const auto p = static_cast<float>(moving[x]);
      s.moving[y + 1][x + 1] = p;
      s.concentration[y + 1][x + 1] = concentration_of(p, static_cast<float>(surface[x] + fibre[x]));
    }
  }
  const auto take = [&](Side side, std::size_t i, std::size_t y, std::size_t x) {
    const Edge* edge = neighbours[side];
    const float p = edge ? static_cast<float>(edge->moving[slot][i]) : 0.0F;
    s.moving[y][x] = p;
    s.concentration[y][x] = edge ? concentration_of(p, static_cast<float>(edge->water[i])) : 0.0F;
  };
  for (std::size_t i = 0; i < kTile; ++i) {
    take(left, i, i + 1, 0);
    take(right, i, i + 1, kTile + 1);
    take(top, i, 0, i + 1);
    take(bottom, i, kTile + 1, i + 1);
  }
}

void load_paper(const StepRules& rules, const Tile& tile, const Rows& rows, Scratch& s) {
  for (std::size_t y = rows.first; y < rows.last + 2; ++y) {
    const std::uint16_t* height = tile.height.data() + y * kPadded;
    const std::uint16_t* density = tile.density.data() + y * kPadded;
    for (std::size_t x = 0; x < kPadded; ++x) {
      const float h = static_cast<float>(height[x]) * kPerLevel;
      const float d = static_cast<float>(density[x]) * kPerLevel;
      s.pinning[y][x] = rules.pinning + rules.pinning_height * h + rules.pinning_density * d;
      s.conductivity[y][x] = rules.conductivity - rules.conductivity_loss * d;
    }
  }
}

/// Water that flows from the cell with `a` to the cell with `b`. Both tiles of a border compute the same.
std::int32_t flow(float a, float b, float pinning_a, float pinning_b, float conductivity_a,
                  float conductivity_b) {
  const float q = 0.5F * (conductivity_a + conductivity_b) * ((a - b) * (a + b));
  const bool stops = (static_cast<int>(b <= 0) & static_cast<int>(a <= pinning_b)) |
                     (static_cast<int>(a <= 0) & static_cast<int>(b <= pinning_a));
  return stops ? 0 : static_cast<std::int32_t>(q);
}

void find_flow(const Rows& rows, Scratch& s) {
  for (std::size_t y = rows.first; y < rows.last; ++y) {
    const auto& f = s.fibre[y + 1];
    const auto& n = s.pinning[y + 1];
    const auto& k = s.conductivity[y + 1];
    for (std::size_t x = 0; x <= kTile; ++x)
      s.across[y][x] = flow(f[x], f[x + 1], n[x], n[x + 1], k[x], k[x + 1]);
  }
  for (std::size_t y = rows.first; y <= rows.last; ++y) {
    const auto &f = s.fibre[y], &g = s.fibre[y + 1];
    const auto &n = s.pinning[y], &o = s.pinning[y + 1];
    const auto &k = s.conductivity[y], &l = s.conductivity[y + 1];
    for (std::size_t x = 1; x <= kTile; ++x) s.down[y][x - 1] = flow(f[x], g[x], n[x], o[x], k[x], l[x]);
  }
}

/// Pigment that goes with the water `q` from a to b: that of the cell which the water leaves.
std::int32_t carried(std::int32_t q, float mobility, float concentration_a, float concentration_b,
                     float moving_a, float moving_b) {
  const float concentration = q > 0 ? concentration_a : concentration_b;
  const float taker = q > 0 ? moving_b : moving_a;
  const auto p = static_cast<std::int32_t>(mobility * static_cast<float>(q) * concentration);
  return taker > static_cast<float>(kMostMoving) ? 0 : p;
}

void find_pigment_flow(float mobility, std::size_t slot, const Rows& rows, Scratch& s) {
  for (std::size_t y = rows.first; y < rows.last; ++y) {
    const auto& c = s.concentration[y + 1];
    const auto& p = s.moving[y + 1];
    for (std::size_t x = 0; x <= kTile; ++x)
      s.pigment_across[slot][y][x] = carried(s.across[y][x], mobility, c[x], c[x + 1], p[x], p[x + 1]);
  }
  for (std::size_t y = rows.first; y <= rows.last; ++y) {
    const auto &c = s.concentration[y], &d = s.concentration[y + 1];
    const auto &p = s.moving[y], &q = s.moving[y + 1];
    for (std::size_t x = 0; x < kTile; ++x)
      s.pigment_down[slot][y][x] = carried(s.down[y][x], mobility, c[x + 1], d[x + 1], p[x + 1], q[x + 1]);
  }
}

struct Changes {
  std::uint32_t any = 0;    // bits that differ
  std::uint32_t water = 0;  // bits of the water that is left
  TotalAmount evaporated = 0;
};

void move_water(const StepRules& rules, const Rows& rows, Tile& tile, Scratch& s, Changes& changes) {
  for (std::size_t y = rows.first; y < rows.last; ++y) {
    Amount* surface = tile.surface.data() + y * kTile;
    Amount* fibre = tile.fibre.data() + y * kTile;
    const auto &above = s.fibre[y], &here = s.fibre[y + 1], &below = s.fibre[y + 2];
    std::uint32_t any = 0, water = 0;
    std::int32_t evaporated = 0;
    for (std::size_t x = 0; x < kTile; ++x) {
      const std::int32_t flowed =
          fibre[x] + s.across[y][x] - s.across[y][x + 1] + s.down[y][x] - s.down[y + 1][x];
      const std::int32_t room = std::max(kOne - flowed, 0);
      const std::int32_t seeps = std::min({surface[x], room, rules.absorption});
      const std::int32_t on = surface[x] - seeps;
      const std::int32_t in = flowed + seeps;
      const std::int32_t dry_sides = static_cast<int>(here[x] <= 0) + static_cast<int>(here[x + 2] <= 0) +
                                     static_cast<int>(above[x + 1] <= 0) +
                                     static_cast<int>(below[x + 1] <= 0);
      const std::int32_t most = rules.evaporation + dry_sides * rules.rim_evaporation;
      const std::int32_t from_surface = std::min(on, most);
      const std::int32_t from_fibre = std::min(in, most - from_surface);
      const std::int32_t gone = from_surface + from_fibre;
      const std::int32_t had = on + in;
      s.loss[y][x] = had > 0 ? static_cast<float>(gone) / static_cast<float>(had) : 0.0F;
      s.is_dry[y][x] = had == gone ? -1 : 0;
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
}

void move_pigment(const StepRules& rules, const Rows& rows, Tile& tile, std::size_t slot, const Scratch& s,
                  Changes& changes) {
  const Faces &across = s.pigment_across[slot], &down = s.pigment_down[slot];
  std::uint32_t any = 0;
  for (std::size_t y = rows.first; y < rows.last; ++y) {
    Amount* moving = tile.moving[slot].data() + y * kTile;
    Amount* fixed = tile.fixed[slot].data() + y * kTile;
    const std::uint16_t* height = tile.height.data() + (y + 1) * kPadded + 1;
    for (std::size_t x = 0; x < kTile; ++x) {
      const std::int32_t flowed = moving[x] + across[y][x] - across[y][x + 1] + down[y][x] - down[y + 1][x];
      // Where nothing is fixed by time, granulation has nothing to act on either.
      const float h = static_cast<float>(height[x]) * kPerLevel;
      const float settling = rules.fixing * (1.0F + rules.granulation[slot] * (1.0F - 2.0F * h));
      const float share = std::max(s.loss[y][x], settling);
      const auto part = static_cast<std::int32_t>(static_cast<float>(flowed) * share);
      // A float of more than 24 bits may have been rounded up.
      const std::int32_t wanted = s.is_dry[y][x] != 0 ? flowed : std::min(part, flowed);
      const std::int32_t fixes = std::min(wanted, kMostFixed - fixed[x]);
      any |= static_cast<std::uint32_t>((flowed - fixes) ^ moving[x]) | static_cast<std::uint32_t>(fixes);
      moving[x] = flowed - fixes;
      fixed[x] += fixes;
    }
  }
  changes.any |= any;
}

}  // namespace

void publish_edges(Tile& tile) {
  publish(tile, left, 0, kTile);
  publish(tile, right, kTile - 1, kTile);
  publish(tile, top, 0, 1);
  publish(tile, bottom, std::size_t{kTile} * (kTile - 1), 1);
}

bool step_tile(const StepRules& rules, Tile& tile, const std::array<const Edge*, 4>& neighbours) {
  std::uint8_t slots = tile.slots;
  for (const Edge* edge : neighbours) {
    if (edge == nullptr) continue;
    for (std::size_t k = 0; k < kSlots; ++k) {
      Amount any = 0;
      for (const Amount p : edge->moving[k]) any |= p;
      if (any != 0) slots |= static_cast<std::uint8_t>(1U << k);
    }
  }
  const Rows rows = rows_of(tile, slots, neighbours);
  if (rows.last == 0) {
    tile.is_wet = false;
    return false;
  }
  Scratch s;
  load_fibre(tile, neighbours, s.fibre);
  load_paper(rules, tile, rows, s);
  find_flow(rows, s);
  // The pigment's flow needs the water as it was before the step.
  for (std::size_t k = 0; k < kSlots; ++k) {
    if ((slots >> k & 1U) == 0) continue;
    load_pigment(tile, neighbours, k, s);
    find_pigment_flow(rules.mobility[k], k, rows, s);
  }
  Changes changes;
  move_water(rules, rows, tile, s, changes);
  for (std::size_t k = 0; k < kSlots; ++k)
    if ((slots >> k & 1U) != 0) move_pigment(rules, rows, tile, k, s, changes);
  tile.evaporated += changes.evaporated;
  tile.slots = slots;
  tile.is_wet = changes.water != 0;
  return changes.any != 0;
}

}  // namespace nazori::paint
