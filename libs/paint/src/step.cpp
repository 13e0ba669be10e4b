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
constexpr std::size_t kFirst = 16;
template <class Number>
using Row = std::array<Number, kFirst + kTile + kFirst>;

constexpr float kPerLevel = 1.0F / 65535.0F;

/// What a row of cells held before the step. It is filled by load(). Of the cells beside the tile it knows
/// only `rim`; Border knows the rest.
struct alignas(64) CellRow {
  Row<float> fibre;
  Row<float> barrier;       // a neighbour must hold more than this before water flows from it
  Row<float> conductivity;  // half of it, so that the sum of two is their mean
  Row<Amount> rim;          // what each cell beside this one may lose more because this one is dry
  std::array<Row<float>, kSlots> moving, concentration;
  std::uint32_t slots;    // bit k: moving[k] holds something, or may take it from beside the tile
  std::uint32_t crowded;  // bit k: cells of moving[k] may hold more than kMostMoving
};

/// What flows through a row of faces. Whole vectors fit.
struct alignas(64) FaceRow {
  std::array<std::int32_t, kTile + 16> water;
  std::array<std::array<std::int32_t, kTile + 16>, kSlots> pigment;
};

/// The column of faces between the tile and one beside it: face y lies beside row y.
struct Border {
  FaceRow faces;
  std::array<Amount, kTile> rim;  // of the cells beyond, as in CellRow
  std::uint32_t slots;            // bit k: pigment[k] may come from beyond
};

/// The last rows, and the faces beside and between their cells.
struct Window {
  std::array<CellRow, 4> cells;
  std::array<FaceRow, 2> across;  // face x lies before cell x
  std::array<FaceRow, 3> down;    // face x lies above cell x
  std::array<Border, 2> borders;  // left and right
};

/// The rows of a window, the newest first.
struct Order {
  std::array<CellRow*, 4> cells;
  std::array<FaceRow*, 2> across;
  std::array<FaceRow*, 3> down;
};

/// Makes room for a new row in place of the oldest.
template <class Rows>
void go_on(Rows& rows) {
  auto* oldest = rows.back();
  std::copy_backward(rows.begin(), rows.end() - 1, rows.end());
  rows.front() = oldest;
}

/// How the water of a row of cells evaporated.
struct alignas(64) Loss {
  std::array<float, kTile> share;
  std::array<std::int32_t, kTile> is_empty;  // -1 where no water is left
};

struct alignas(64) Changes {
  bool any = false;                        // anything changed
  bool is_wet = false;                     // water is left
  std::array<Amount, kTile> evaporated{};  // of each column, so that nothing is added across a row
};

struct Step {
  const StepRules& rules;
  Tile& tile;
  const std::array<const Edge*, 4>& neighbours;
  const Surrounded* next;
  std::uint32_t slots;
};

bool has(std::uint32_t slots, std::size_t slot) { return (slots >> slot & 1U) != 0; }

/// Calls act(k) for each slot.
template <class Act>
void for_each(std::uint32_t slots, const Act& act) {
  for (; slots != 0; slots &= slots - 1) act(static_cast<std::size_t>(std::countr_zero(slots)));
}

Amount bits_of(const Amount* amounts) {
  Amount any = 0;
  for (std::size_t x = 0; x < kTile; ++x) any |= amounts[x];
  return any;
}

// Read in place of what is known to be 0, so that it need not come into the cache.
alignas(64) constexpr std::array<Amount, kTile> kNothing{};

const Amount* surface_of(const Tile& tile, std::size_t y) {
  return has(tile.standing, y) ? tile.surface.data() + y * kTile : kNothing.data();
}

bool is_row_empty(const Tile& tile, std::size_t y) {
  const Amount *surface = surface_of(tile, y), *fibre = tile.fibre.data() + y * kTile;
  // Most rows with water have some here.
  if ((surface[0] | fibre[0] | surface[kTile / 2] | fibre[kTile / 2]) != 0) return false;
  Amount any = bits_of(surface) | bits_of(fibre);
  for_each(tile.slots, [&](std::size_t k) { any |= bits_of(tile.moving[k].data() + y * kTile); });
  return any == 0;
}

/// Bit y: something may change in row y.
std::uint32_t rows_of(const Step& s) {
  std::uint32_t rows = 0;
  for (std::size_t y = 0; y < kTile; ++y) rows |= static_cast<std::uint32_t>(!is_row_empty(s.tile, y)) << y;
  s.tile.standing &= rows;
  for (const Side side : {left, right}) {
    if (s.neighbours[side] == nullptr) continue;
    for (std::size_t y = 0; y < kTile; ++y)
      rows |= static_cast<std::uint32_t>(s.neighbours[side]->fibre[y] != 0) << y;
  }
  // Water also flows into the rows beside it.
  rows |= rows << 1U | rows >> 1U;
  const auto is_wet = [&](Side side) {
    return s.neighbours[side] != nullptr && bits_of(s.neighbours[side]->fibre.data()) != 0;
  };
  return rows | (is_wet(top) ? 1U : 0U) | (is_wet(bottom) ? 1U << (kTile - 1U) : 0U);
}

/// Where a line of cells and its paper are kept.
struct Source {
  const std::uint16_t *height, *density;
  const Amount *surface, *fibre;
  std::array<const Amount*, kSlots> moving;
};

Source source_of(const Edge& edge, const std::uint16_t* height, const std::uint16_t* density) {
  Source from{
      height, density, edge.has_standing ? edge.surface.data() : kNothing.data(), edge.fibre.data(), {}};
  for (std::size_t k = 0; k < kSlots; ++k)
    from.moving[k] = has(edge.slots, k) ? edge.moving[k].data() : kNothing.data();
  return from;
}

/// @param row  0 is the one above the tile.
Source source_of(const Step& s, std::size_t row) {
  const std::uint16_t* height = s.tile.height.data() + row * kTile;
  const std::uint16_t* density = s.tile.density.data() + row * kTile;
  const Edge* edge = row == 0 ? s.neighbours[top] : row > kTile ? s.neighbours[bottom] : nullptr;
  if (edge != nullptr) return source_of(*edge, height, density);
  // Nothing flows through the border of the sheet: beyond it is the same as before it.
  const std::size_t y = std::clamp<std::size_t>(row, 1, kTile) - 1;
  Source from{height, density, surface_of(s.tile, y), s.tile.fibre.data() + y * kTile, {}};
  for (std::size_t k = 0; k < kSlots; ++k) from.moving[k] = s.tile.moving[k].data() + y * kTile;
  return from;
}

void load_water(const StepRules& step_rules, const Source& from, CellRow& to) {
  const StepRules rules = step_rules;
  const float conductivity = 0.5F * rules.conductivity, conductivity_loss = 0.5F * rules.conductivity_loss;
  const Amount rim = rules.rim_evaporation;
  for (std::size_t x = 0; x < kTile; ++x) {
    const float h = static_cast<float>(from.height[x]) * kPerLevel;
    const float d = static_cast<float>(from.density[x]) * kPerLevel;
    const float pinning = rules.pinning + rules.pinning_height * h + rules.pinning_density * d;
    const auto fibre = static_cast<float>(from.fibre[x]);
    const std::size_t i = kFirst + x;
    to.fibre[i] = fibre;
    to.barrier[i] = fibre <= 0 ? pinning : -1.0F;
    to.conductivity[i] = conductivity - conductivity_loss * d;
    to.rim[i] = -static_cast<Amount>(fibre <= 0) & rim;
  }
}

void load_pigment(const Step& s, const Source& from, CellRow& to) {
  to.slots = to.crowded = 0;
  for_each(s.slots, [&](std::size_t k) {
    const Amount* moving = from.moving[k];
    Amount any = 0;
    for (std::size_t x = 0; x < kTile; ++x) {
      const auto p = static_cast<float>(moving[x]);
      // Where there is no water none flows, so that the concentration does not matter.
      const auto water = static_cast<float>(std::max(from.surface[x] + from.fibre[x], 1));
      to.moving[k][kFirst + x] = p;
      to.concentration[k][kFirst + x] = p / water;
      any |= moving[x];
    }
    to.slots |= static_cast<std::uint32_t>(any != 0) << k;
    to.crowded |= static_cast<std::uint32_t>(any >= kMostMoving) << k;
  });
}

void load(const Step& s, const std::array<Border, 2>& borders, std::size_t row, CellRow& to) {
  const Source from = source_of(s, row);
  load_water(s.rules, from, to);
  load_pigment(s, from, to);
  if (row == 0 || row > kTile) return;
  to.rim[kFirst - 1] = borders[left].rim[row - 1];
  to.rim[kFirst + kTile] = borders[right].rim[row - 1];
  to.slots |= borders[left].slots | borders[right].slots;
}

/// Water that flows from the cell with `a` to the cell with `b`. Both tiles of a border compute the same.
std::int32_t flow(float a, float b, float barrier_a, float barrier_b, float conductivity_a,
                  float conductivity_b) {
  const float q = (conductivity_a + conductivity_b) * ((a - b) * (a + b));
  const bool stops = (static_cast<int>(a <= barrier_b) | static_cast<int>(b <= barrier_a)) != 0;
  return stops ? 0 : static_cast<std::int32_t>(q);
}

/// Pigment that goes with the water from the cells of `a` that begin at `from` to those of `b`: that of the
/// cell which the water leaves.
template <bool kIsCrowded>
void carry(float mobility, std::size_t slot, const CellRow& a, std::size_t from, const CellRow& b,
           FaceRow& faces) {
  const auto &concentration_a = a.concentration[slot], &concentration_b = b.concentration[slot];
  const auto &moving_a = a.moving[slot], &moving_b = b.moving[slot];
  for (std::size_t x = 0; x < kTile; ++x) {
    const std::size_t i = from + x, j = kFirst + x;
    const std::int32_t q = faces.water[x];
    // Both are read in any case: reading one of them under a mask takes longer.
    const float ca = concentration_a[i], cb = concentration_b[j];
    const auto p = static_cast<std::int32_t>(mobility * static_cast<float>(q) * (q > 0 ? ca : cb));
    if constexpr (kIsCrowded) {
      const float ma = moving_a[i], mb = moving_b[j];
      faces.pigment[slot][x] = (q > 0 ? mb : ma) > static_cast<float>(kMostMoving) ? 0 : p;
    } else {
      faces.pigment[slot][x] = p;
    }
  }
}

/// What flows from the cells of `a` that begin at `from` to those of `b`.
void find_flow(const Step& s, const CellRow& a, std::size_t from, const CellRow& b, FaceRow& faces) {
  for (std::size_t x = 0; x < kTile; ++x) {
    const std::size_t i = from + x, j = kFirst + x;
    faces.water[x] =
        flow(a.fibre[i], b.fibre[j], a.barrier[i], b.barrier[j], a.conductivity[i], b.conductivity[j]);
  }
  const std::uint32_t slots = a.slots | b.slots, crowded = a.crowded | b.crowded;
  for_each(s.slots & ~slots, [&](std::size_t k) { faces.pigment[k].fill(0); });
  for_each(slots & ~crowded, [&](std::size_t k) { carry<false>(s.rules.mobility[k], k, a, from, b, faces); });
  for_each(slots & crowded, [&](std::size_t k) { carry<true>(s.rules.mobility[k], k, a, from, b, faces); });
}

/// What flows between the cells of row `row`, of which the first and the last are beside a border.
void find_flow_across(const Step& s, const std::array<Border, 2>& borders, std::size_t row,
                      const CellRow& cells, FaceRow& faces) {
  find_flow(s, cells, kFirst - 1, cells, faces);
  const auto &before = borders[left].faces, &after = borders[right].faces;
  faces.water[0] = before.water[row - 1];
  faces.water[kTile] = after.water[row - 1];
  for_each(s.slots, [&](std::size_t k) {
    faces.pigment[k][0] = before.pigment[k][row - 1];
    faces.pigment[k][kTile] = after.pigment[k][row - 1];
  });
}

struct PaperColumn {
  std::array<std::uint16_t, kTile> height, density;
};

PaperColumn paper_of_column(const Tile& tile, std::size_t x) {
  PaperColumn column;
  for (std::size_t y = 0; y < kTile; ++y) {
    column.height[y] = tile.height[(y + 1) * kTile + x];
    column.density[y] = tile.density[(y + 1) * kTile + x];
  }
  return column;
}

void find_border(const Step& s, Side side, Border& border) {
  const Edge &own = shown_edge(s.tile, side), *beyond = s.neighbours[side];
  border.slots = 0;
  if (beyond == nullptr || (bits_of(own.fibre.data()) | bits_of(beyond->fibre.data())) == 0) {
    border.faces = {};
    // Beyond the border of the sheet is as much water as before it.
    for (std::size_t y = 0; y < kTile; ++y) border.rim[y] = own.fibre[y] <= 0 ? s.rules.rim_evaporation : 0;
    return;
  }
  const PaperColumn paper = paper_of_column(s.tile, side == left ? 0 : kTile - 1);
  CellRow here, there;
  const Source from_here = source_of(own, paper.height.data(), paper.density.data());
  const Source from_there =
      source_of(*beyond, s.tile.height_beside[side].data(), s.tile.density_beside[side].data());
  load_water(s.rules, from_here, here);
  load_pigment(s, from_here, here);
  load_water(s.rules, from_there, there);
  load_pigment(s, from_there, there);
  if (side == left)
    find_flow(s, there, kFirst, here, border.faces);
  else
    find_flow(s, here, kFirst, there, border.faces);
  for (std::size_t y = 0; y < kTile; ++y) border.rim[y] = there.rim[kFirst + y];
  border.slots = there.slots;
}

/// @tparam kStands  water may stand on the row. @tparam kLooks  whether a change is looked for.
template <bool kStands, bool kLooks>
void move_water(const Step& s, const Order& w, std::size_t y, Loss& loss, Changes& changes) {
  Amount *surface = s.tile.surface.data() + y * kTile, *fibre = s.tile.fibre.data() + y * kTile;
  const auto &under = w.cells[1]->rim, &here = w.cells[2]->rim, &over = w.cells[3]->rim;
  const auto &across = w.across[1]->water, &below = w.down[1]->water, &above = w.down[2]->water;
  const Amount absorption = s.rules.absorption, evaporation = s.rules.evaporation;
  float* share = loss.share.data();
  std::int32_t* is_empty = loss.is_empty.data();
  std::uint32_t any = 0;
  Amount left_on = 0;
  for (std::size_t x = 0; x < kTile; ++x) {
    const std::int32_t flowed = fibre[x] + across[x] - across[x + 1] + above[x] - below[x];
    const std::size_t i = kFirst + x;
    const std::int32_t most = evaporation + here[i - 1] + here[i + 1] + over[i] + under[i];
    std::int32_t on = 0, in = flowed, from_surface = 0;
    if constexpr (kStands) {
      const std::int32_t room = std::max(kOne - flowed, 0);
      const std::int32_t seeps = std::min(std::min(surface[x], room), absorption);
      on = surface[x] - seeps;
      in = flowed + seeps;
      from_surface = std::min(on, most);
    }
    const std::int32_t from_fibre = std::min(in, most - from_surface);
    const std::int32_t gone = from_surface + from_fibre;
    const std::int32_t had = on + in;
    share[x] = static_cast<float>(gone) / static_cast<float>(std::max(had, 1));
    is_empty[x] = had == gone ? -1 : 0;
    changes.evaporated[x] += gone;
    if constexpr (kLooks) any |= static_cast<std::uint32_t>((in - from_fibre) ^ fibre[x]);
    fibre[x] = in - from_fibre;
    if constexpr (kStands) {
      if constexpr (kLooks) any |= static_cast<std::uint32_t>((on - from_surface) ^ surface[x]);
      left_on |= on - from_surface;
      surface[x] = on - from_surface;
    }
  }
  if (kLooks && any != 0) changes.any = true;
  if (kStands && left_on == 0) s.tile.standing &= ~(1U << y);
}

void move_water(const Step& s, const Order& w, std::size_t y, Loss& loss, Changes& changes) {
  if (has(s.tile.standing, y)) {
    changes.any ? move_water<true, false>(s, w, y, loss, changes)
                : move_water<true, true>(s, w, y, loss, changes);
  } else {
    changes.any ? move_water<false, false>(s, w, y, loss, changes)
                : move_water<false, true>(s, w, y, loss, changes);
  }
  if (!changes.is_wet)
    changes.is_wet = (bits_of(surface_of(s.tile, y)) | bits_of(s.tile.fibre.data() + y * kTile)) != 0;
}

template <bool kLooks>
void move_pigment(const Step& s, const Order& w, std::size_t y, std::size_t slot, const Loss& loss,
                  Changes& changes) {
  Amount *moving = s.tile.moving[slot].data() + y * kTile, *fixed = s.tile.fixed[slot].data() + y * kTile;
  const std::uint16_t* height = s.tile.height.data() + (y + 1) * kTile;
  const auto &across = w.across[1]->pigment[slot], &below = w.down[1]->pigment[slot],
             &above = w.down[2]->pigment[slot];
  const float fixing = s.rules.fixing, granulation = s.rules.granulation[slot];
  std::uint32_t any = 0;
  for (std::size_t x = 0; x < kTile; ++x) {
    const std::int32_t flowed = moving[x] + across[x] - across[x + 1] + above[x] - below[x];
    // Where nothing is fixed by time, granulation has nothing to act on either.
    const float twice_h = static_cast<float>(height[x]) * (2.0F * kPerLevel);
    const float settling = fixing * (1.0F + granulation * (1.0F - twice_h));
    const float share = std::max(loss.share[x], settling);
    const auto part = static_cast<std::int32_t>(static_cast<float>(flowed) * share);
    // A float of more than 24 bits may have been rounded up.
    const std::int32_t wanted = loss.is_empty[x] != 0 ? flowed : std::min(part, flowed);
    const std::int32_t fixes = std::min(wanted, kMostFixed - fixed[x]);
    if constexpr (kLooks)
      any |= static_cast<std::uint32_t>((flowed - fixes) ^ moving[x]) | static_cast<std::uint32_t>(fixes);
    moving[x] = flowed - fixes;
    fixed[x] += fixes;
  }
  if (kLooks && any != 0) changes.any = true;
}

/// @param y  of cells[2] in the tile.
void move(const Step& s, const Order& w, std::size_t y, Changes& changes) {
  Loss loss;
  move_water(s, w, y, loss, changes);
  for_each(w.cells[1]->slots | w.cells[2]->slots | w.cells[3]->slots, [&](std::size_t k) {
    changes.any ? move_pigment<false>(s, w, y, k, loss, changes)
                : move_pigment<true>(s, w, y, k, loss, changes);
  });
}

template <class Number>
void fetch(const Number* row) {
  constexpr std::size_t kLine = 64;
  for (std::size_t x = 0; x < kTile; x += kLine / sizeof(Number)) __builtin_prefetch(row + x);
}

void fetch_edge(const Edge& edge, std::uint32_t slots) {
  __builtin_prefetch(&edge.slots);
  fetch(edge.fibre.data());
  for_each(slots, [&](std::size_t k) { fetch(edge.moving[k].data()); });
}

/// Brings a row of the next tile into the cache, which is likely to have the same pigments, and one of the
/// edges that it needs.
void fetch_next(const Step& s, std::size_t y) {
  if (s.next == nullptr) return;
  const Tile& tile = *s.next->tile;
  fetch(tile.fibre.data() + y * kTile);
  for_each(s.slots, [&](std::size_t k) {
    fetch(tile.moving[k].data() + y * kTile);
    fetch(tile.fixed[k].data() + y * kTile);
  });
  fetch(tile.height.data() + y * kTile);
  fetch(tile.density.data() + y * kTile);
  const std::size_t edge = y % 4, kind = y / 4;
  if (kind == 1 && s.next->neighbours[edge] != nullptr) fetch_edge(*s.next->neighbours[edge], s.slots);
  if (kind == 2) fetch_edge(tile.edges[0][edge], s.slots);
  if (kind == 3) fetch_edge(tile.edges[1][edge], s.slots);
}

/// The cells of the tile in rows `first` to before `last`; row 0 is the one above the tile.
void step_rows(const Step& s, std::size_t first, std::size_t last, Window& w, Changes& changes) {
  Order rows{{&w.cells[0], &w.cells[1], &w.cells[2], &w.cells[3]},
             {&w.across[0], &w.across[1]},
             {&w.down[0], &w.down[1], &w.down[2]}};
  load(s, w.borders, first - 1, *rows.cells[0]);
  // Each turn reads what the turn before it wrote. A read across two fresh writes would have to wait for
  // them.
  for (std::size_t row = first; row < last + 2; ++row) {
    go_on(rows.cells);
    go_on(rows.across);
    go_on(rows.down);
    if (row <= last) {
      load(s, w.borders, row, *rows.cells[0]);
      find_flow(s, *rows.cells[1], kFirst, *rows.cells[0], *rows.down[0]);
      if (row > first) find_flow_across(s, w.borders, row - 1, *rows.cells[1], *rows.across[0]);
    }
    if (row > first + 1) {
      move(s, rows, row - 3, changes);
      fetch_next(s, row - 3);
    }
  }
}

/// Flow from before the first cell is computed with the others and then replaced, so it must be a number.
void clear_before_first(Window& w) {
  for (CellRow& row : w.cells) {
    row.fibre[kFirst - 1] = row.barrier[kFirst - 1] = row.conductivity[kFirst - 1] = 0;
    for (std::size_t k = 0; k < kSlots; ++k) row.moving[k][kFirst - 1] = row.concentration[k][kFirst - 1] = 0;
  }
}

/// @return whether there is anything that could change.
NAZORI_WIDE bool step_cells(const Step& s, Changes& changes) {
  std::uint32_t rows = rows_of(s);
  if (rows == 0) return false;
  Window w;
  clear_before_first(w);
  for (const Side side : {left, right}) find_border(s, side, w.borders[side]);
  while (rows != 0) {
    const int first = std::countr_zero(rows);
    const int last = first + std::countr_one(rows >> first);
    step_rows(s, static_cast<std::size_t>(first) + 1, static_cast<std::size_t>(last) + 1, w, changes);
    rows = last < kTile ? rows >> last << last : 0;
  }
  return true;
}

}  // namespace

bool step_tile(const StepRules& rules, const Surrounded& now, const Surrounded* next) {
  Tile& tile = *now.tile;
  std::uint32_t slots = tile.slots;
  for (const Edge* edge : now.neighbours)
    if (edge != nullptr) slots |= edge->slots;
  Changes changes;
  if (!step_cells({rules, tile, now.neighbours, next, slots}, changes)) {
    tile.is_wet = false;
    return false;
  }
  for (const Amount evaporated : changes.evaporated) tile.evaporated += evaporated;
  tile.slots = static_cast<std::uint8_t>(slots);
  tile.is_wet = changes.is_wet;
  return changes.any;
}

}  // namespace nazori::paint
