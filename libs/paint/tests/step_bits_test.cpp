// SPDX-License-Identifier: Apache-2.0
// The fast step of tiles against the plain step of cells, to the last bit.
#include <gtest/gtest.h>

#include "reference_step.h"
#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

constexpr int kSize = 128;

Paper paper_at_random(Random& random) {
  Paper paper = find_paper(paper_names()[static_cast<std::size_t>(random.below(5))]).value();
  const auto some = [&](double least, double most) {
    return random.below(3) == 0 ? 0 : random.within(least, most);
  };
  paper.spread_m2_s = some(0, 4e-6);
  paper.spread_variation = random.within(0, 1);
  paper.pinning = some(0, 0.4);
  paper.pinning_height = some(0, 0.4);
  paper.pinning_fibre = some(0, 0.4);
  paper.absorption_s = some(0, 0.2);
  paper.drying_s = some(0.5, 20);
  paper.rim_drying = random.within(0, 10);
  paper.fixing_s = some(0.01, 3);
  paper.granulation = random.within(0, 1);
  paper.seed = static_cast<std::uint32_t>(random.below(1000));
  return paper;
}

/// Often nothing, a few units, or nearly as much as there may be.
Amount amount_at_random(Random& random, Amount most) {
  switch (random.below(6)) {
    case 0:
    case 1:
      return 0;
    case 2:
      return random.below(8);
    case 3:
      return most - random.below(8);
    default:
      return random.below(most);
  }
}

void fill_cell(Random& random, Tile& tile, std::size_t cell, int slots) {
  tile.surface[cell] = amount_at_random(random, kMostWater - kOne);
  tile.fibre[cell] = amount_at_random(random, kOne);
  for (std::size_t k = 0; k < kSlots; ++k) {
    if ((slots >> k & 1) == 0) continue;
    tile.moving[k][cell] = amount_at_random(random, kMostMoving + kOne);
    tile.fixed[k][cell] = amount_at_random(random, kMostFixed);
  }
}

/// Some tiles stay dry, some get a single cell or scattered ones, some are full.
void fill(Random& random, Sheet::Inside& sheet) {
  const int slots = random.below(8);
  for (const auto& tile : sheet.tiles) {
    const int one_of = std::array{0, 1, 2, 40, 700}[static_cast<std::size_t>(random.below(5))];
    for (std::size_t cell = 0; cell < kCells && one_of > 0; ++cell)
      if (random.below(one_of) == 0) fill_cell(random, *tile, cell, slots);
    sheet.settle(*tile);
  }
}

const Edge* edge_of(const Sheet::Inside& sheet, int column, int row, Side side) {
  if (column < 0 || row < 0 || column >= kSize || row >= kSize) return nullptr;
  return &shown_edge(sheet.tile_at(column, row), side);
}

/// Water and pigment fall on some cells, also where none stood before.
void drop(Random& random, Sheet& sheet) {
  for (int i = random.below(3) * 20; i > 0; --i)
    sheet.drop(random.below(kSize), random.below(kSize), random.below(2 * kOne),
               {random.below(kOne), random.below(2) * random.below(kOne), 0});
}

/// Every tile makes the step, without the layers of a sheet.
void step_tiles(Sheet::Inside& sheet) {
  for (const auto& tile : sheet.tiles) publish_edges(*tile);
  for (int row = 0; row < kSize; row += kTile)
    for (int column = 0; column < kSize; column += kTile) {
      Tile& tile = sheet.tile_at(column, row);
      tile.has_changed = step_tile(
          sheet.rules, {&tile,
                        {edge_of(sheet, column - 1, row, right), edge_of(sheet, column + kTile, row, left),
                         edge_of(sheet, column, row - 1, bottom), edge_of(sheet, column, row + kTile, top)}});
    }
}

void expect_alike(const ReferenceStep& before, const ReferenceStep& after, const Sheet::Inside& sheet) {
  std::array<bool, 16> has_changed{}, is_wet{};
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const auto& held = after.at(column, row);
      ASSERT_EQ(ReferenceStep::held_by(sheet, column, row), held) << column << ", " << row;
      const auto tile = static_cast<std::size_t>(row / kTile * 4 + column / kTile);
      has_changed[tile] = has_changed[tile] || held != before.at(column, row);
      is_wet[tile] = is_wet[tile] || held.surface != 0 || held.fibre != 0;
    }
  for (std::size_t i = 0; i < sheet.tiles.size(); ++i) {
    EXPECT_EQ(sheet.tiles[i]->has_changed, has_changed[i]) << i;
    EXPECT_EQ(sheet.tiles[i]->is_wet, is_wet[i]) << i;
  }
}

TEST(StepBits, AreThoseOfACellByCellStep) {
  for (std::uint64_t seed = 1; seed <= 40 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Sheet sheet = sheet_of(kSize, paper_at_random(random));
    fill(random, sheet.inside());
    ReferenceStep reference(sheet.inside());
    for (int i = 0; i < 8 && !testing::Test::HasFailure(); ++i) {
      if (i == 4) {
        drop(random, sheet);
        reference = ReferenceStep(sheet.inside());
      }
      const ReferenceStep before = reference;
      const TotalAmount air = sheet.evaporated();
      const TotalAmount evaporated = reference.step();
      step_tiles(sheet.inside());
      expect_alike(before, reference, sheet.inside());
      EXPECT_EQ(sheet.evaporated() - air, evaporated);
    }
  }
}

/// The sides of a tile whose neighbours are told of a change, after `field` holds `amount` in a cell.
int sides_after(Sheet::Inside& sheet, Field& field, std::size_t cell, Amount amount) {
  Tile& tile = *sheet.tiles[0];
  field[cell] = amount;
  sheet.settle(tile);
  publish_edges(tile);
  return tile.edges_changed;
}

TEST(Edges, NeighboursAreToldOfEveryChangeOnTheirSideAndOfNoOther) {
  Sheet sheet = sheet_of(kSize);
  Tile& tile = *sheet.inside().tiles[0];
  constexpr std::size_t kLeft = 5 * kTile, kBottom = std::size_t{kTile} * (kTile - 1) + 7,
                        kMiddle = kLeft + 9;
  for (Field* field : {&tile.surface, &tile.fibre, &tile.moving[0], &tile.moving[1], &tile.moving[2]})
    for (const auto& [cell, sides] :
         {std::pair(kLeft, 1 << left), std::pair(kBottom, 1 << bottom), std::pair(kMiddle, 0)})
      for (const Amount amount : {3, 4, 0, 5, 0}) {
        EXPECT_EQ(sides_after(sheet.inside(), *field, cell, amount), sides) << cell << ", " << amount;
        EXPECT_EQ(sides_after(sheet.inside(), *field, cell, amount), 0) << "nothing changed";
      }
}

}  // namespace
}  // namespace nazori::paint
