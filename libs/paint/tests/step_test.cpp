// SPDX-License-Identifier: Apache-2.0
// One step of the whole sheet, computed a second time cell by cell as docs/brush.md and the papers'
// properties say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "inside.h"
#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

constexpr int kSize = 128;
// Of 2^26: the sheet computes with floats of 24 bits.
constexpr double kRounding = 100;

struct Model {
  struct One {
    double surface = 0, fibre = 0;
    std::array<double, kSlots> moving{}, fixed{};
    double height = 0, density = 0;
  };
  Paper paper;
  std::array<Pigment, kSlots> palette;
  std::vector<One> cells;
  double evaporated = 0;

  explicit Model(const Sheet& sheet) : paper(sheet.paper()), palette(sheet.palette()) {
    for (int row = 0; row < kSize; ++row)
      for (int column = 0; column < kSize; ++column) {
        const Cell cell = sheet.at(column, row);
        One one{static_cast<double>(cell.surface), static_cast<double>(cell.fibre), {}, {}, cell.height, 0};
        for (std::size_t k = 0; k < kSlots; ++k) {
          one.moving[k] = cell.moving[k];
          one.fixed[k] = cell.fixed[k];
        }
        const Tile& tile = sheet.inside().tile_at(column, row);
        one.density = tile.density[Sheet::Inside::paper_at(column, row)] / 65535.0;
        cells.push_back(one);
      }
  }

  [[nodiscard]] static bool is_inside(int column, int row) {
    return column >= 0 && row >= 0 && column < kSize && row < kSize;
  }
  [[nodiscard]] const One& at(int column, int row) const {
    return cells[static_cast<std::size_t>(row * kSize + column)];
  }
  [[nodiscard]] double conductivity(const One& cell) const {
    const double cell_m = Sheet::kSide_m / kSize;
    return paper.spread_m2_s * Sheet::kStep_s / (cell_m * cell_m) *
           (1 - paper.spread_variation * cell.density);
  }
  [[nodiscard]] double pinning(const One& cell) const {
    return kOne * (paper.pinning + paper.pinning_height * cell.height + paper.pinning_fibre * cell.density);
  }
  /// Water from one cell to the other, less than nothing where it comes from there.
  [[nodiscard]] double flow(const One& a, const One& b) const {
    if (b.fibre <= 0 && a.fibre <= pinning(b)) return 0;
    if (a.fibre <= 0 && b.fibre <= pinning(a)) return 0;
    return (conductivity(a) + conductivity(b)) / 2 * (a.fibre * a.fibre - b.fibre * b.fibre) / kOne;
  }
  [[nodiscard]] double carried(const One& a, const One& b, std::size_t k) const {
    const double q = flow(a, b);
    const One& giver = q > 0 ? a : b;
    const One& taker = q > 0 ? b : a;
    if (taker.moving[k] > 8.0 * kOne) return 0;
    const double water = giver.surface + giver.fibre;
    return water > 0 ? palette[k].mobility * q * giver.moving[k] / water : 0;
  }
  /// What a cell holds after the step.
  [[nodiscard]] One next(int column, int row, double& gone) const {
    const One& here = at(column, row);
    One out = here;
    int dry_sides = 0;
    for (const auto& [x, y] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
      // Beyond the border of the sheet is as much as before it.
      const One& other = is_inside(column + x, row + y) ? at(column + x, row + y) : here;
      dry_sides += other.fibre <= 0 ? 1 : 0;
      out.fibre -= flow(here, other);
      for (std::size_t k = 0; k < kSlots; ++k) out.moving[k] -= carried(here, other, k);
    }
    const double absorbed = paper.absorption_s > Sheet::kStep_s ? Sheet::kStep_s / paper.absorption_s : 1;
    const double seeps = std::min({out.surface, std::max(kOne - out.fibre, 0.0), absorbed * kOne});
    out.surface -= seeps;
    out.fibre += seeps;
    const double drying = paper.drying_s > 0 ? kOne * Sheet::kStep_s / paper.drying_s : 0;
    // A rim of cells of 0.1 mm dries as the paper says, that of larger ones slower.
    const double most = drying + dry_sides * drying * paper.rim_drying / 4 * (1e-4 * kSize / Sheet::kSide_m);
    const double had = out.surface + out.fibre;
    gone = std::min(had, most);
    const double from_surface = std::min(out.surface, gone);
    out.surface -= from_surface;
    out.fibre -= gone - from_surface;
    for (std::size_t k = 0; k < kSlots; ++k) {
      const double settles =
          paper.fixing_s > 0 ? std::min(Sheet::kStep_s / paper.fixing_s, 0.5) *
                                   (1 + paper.granulation * palette[k].granulation * (1 - 2 * here.height))
                             : 0;
      const double share = had - gone < 1 ? 1 : std::min(1.0, std::max(gone / had, settles));
      const double fixes = std::min(out.moving[k] * share, 10.0 * kOne - out.fixed[k]);
      out.moving[k] -= fixes;
      out.fixed[k] += fixes;
    }
    return out;
  }
};

void expect_a_step_as_computed(Sheet& sheet, const char* what) {
  const Model before(sheet);
  const TotalAmount air = sheet.evaporated();
  sheet.step();
  double evaporated = 0;
  int wrong = 0;
  for (int row = 0; row < kSize && wrong < 5; ++row)
    for (int column = 0; column < kSize && wrong < 5; ++column) {
      double gone = 0;
      const Model::One wanted = before.next(column, row, gone);
      evaporated += gone;
      const Cell cell = sheet.at(column, row);
      bool fits = std::abs(cell.surface - wanted.surface) < kRounding &&
                  std::abs(cell.fibre - wanted.fibre) < kRounding;
      const double had = wanted.surface + wanted.fibre + gone;
      // A dry layer that becomes wet is covered.
      for (std::size_t k = 0; k < kSlots && cell.covered == 0; ++k) {
        const double all = cell.moving[k] + static_cast<double>(cell.fixed[k]);
        fits = fits && std::abs(all - wanted.moving[k] - wanted.fixed[k]) < 4 * kRounding;
        // The share of the water that is lost is rounded by a few units; of nearly nothing that is much.
        const double rounding = 4 * kRounding + (had < 1e4 ? all : 8 * all / had);
        fits = fits && std::abs(cell.fixed[k] - wanted.fixed[k]) < rounding;
      }
      if (fits) continue;
      ++wrong;
      ADD_FAILURE() << what << ": " << column << ", " << row << ": surface " << cell.surface << " for "
                    << wanted.surface << ", fibre " << cell.fibre << " for " << wanted.fibre << ", moving "
                    << cell.moving[0] << " for " << wanted.moving[0] << ", fixed " << cell.fixed[0] << " for "
                    << wanted.fixed[0];
    }
  EXPECT_NEAR(static_cast<double>(sheet.evaporated() - air), evaporated, 1e5) << what;
}

/// Water and pigment at random on most tiles; some stay dry, some are wet in a corner alone.
Sheet at_random(const Paper& paper, std::uint64_t seed) {
  Sheet sheet = sheet_of(kSize, paper);
  Random random(seed);
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const int tile = row / kTile * 4 + column / kTile;
      if (tile % 5 == 1) continue;
      if (tile % 5 == 2 && (column % kTile > 3 || row % kTile < 28)) continue;
      if (random.below(3) == 0) continue;
      const auto some = [&] { return random.below(3) == 0 ? to_amount(random.within(0, 2)) : 0; };
      sheet.drop(column, row, to_amount(random.within(0, random.below(4) == 0 ? 3 : 0.8)),
                 {some(), random.below(400) == 0 ? 8 * kOne : some(), some()});
    }
  return sheet;
}

TEST(Step, IsThatOfTheModelOnEveryPaper) {
  for (const std::string_view name : paper_names()) {
    Sheet sheet = at_random(find_paper(name).value(), 7 + name.size());
    for (int i = 0; i < 6; ++i) expect_a_step_as_computed(sheet, std::string(name).c_str());
  }
}

TEST(Step, IsThatOfTheModelOnPaperWhoseEveryPropertyCounts) {
  Paper paper;
  paper.spread_m2_s = 4e-6;
  paper.spread_variation = 0.9;
  paper.pinning = 0.1;
  paper.pinning_height = 0.3;
  paper.pinning_fibre = 0.4;
  paper.absorption_s = 0.1;
  paper.drying_s = 3;
  paper.rim_drying = 9;
  paper.fixing_s = 0.05;
  paper.granulation = 1;
  Sheet sheet = at_random(paper, 3);
  for (int i = 0; i < 12; ++i) expect_a_step_as_computed(sheet, "mixed");
  paper.fixing_s = 0.01;
  paper.absorption_s = 0.01;
  Sheet fast = at_random(paper, 5);
  for (int i = 0; i < 12; ++i) expect_a_step_as_computed(fast, "fast");
}

TEST(Step, ADropOnEachSideOfATileFlowsToTheOtherOne) {
  Paper paper = even_paper();
  paper.spread_m2_s = 3e-6;
  for (const auto& [column, row] :
       {std::pair(31, 40), std::pair(32, 40), std::pair(40, 31), std::pair(40, 32), std::pair(0, 0),
        std::pair(127, 127), std::pair(95, 96)}) {
    Sheet sheet = sheet_of(kSize, paper);
    sheet.drop(column, row, 2 * kOne, {kOne, kOne / 2, kOne / 4});
    for (int i = 0; i < 8; ++i) expect_a_step_as_computed(sheet, "drop");
    EXPECT_EQ(sheet.holding().water, 2 * kOne);
  }
}

TEST(Grain, OfASeedStaysWhatItIsBecauseSavedSheetsDoNotContainIt) {
  // Ranks of heights and densities that another program, in another language, computed from the same noise.
  struct Known {
    int column, row, height, density;
  };
  const auto compare = [](double grain_m, std::uint32_t seed, const std::vector<Known>& known) {
    const Grain grain = make_grain(kSize, grain_m, seed);
    for (const Known& k : known) {
      const auto cell = static_cast<std::size_t>(k.row * kSize + k.column);
      EXPECT_NEAR(grain.height[cell], k.height, 8) << seed << ": " << k.column << ", " << k.row;
      EXPECT_NEAR(grain.density[cell], k.density, 8) << seed << ": " << k.column << ", " << k.row;
    }
  };
  compare(0.00025, 1,
          {{0, 0, 13652, 38948},
           {1, 0, 30896, 37088},
           {127, 0, 19072, 27492},
           {40, 33, 64016, 43732},
           {41, 33, 2124, 1668},
           {64, 64, 50008, 27616},
           {100, 17, 65028, 40568},
           {5, 120, 28112, 44372},
           {127, 127, 112, 27948}});
  compare(0.005, 7,
          {{0, 0, 62052, 56724},
           {1, 0, 54416, 58964},
           {127, 0, 64124, 51476},
           {40, 33, 21764, 12388},
           {41, 33, 14860, 10360},
           {64, 64, 43548, 11220},
           {100, 17, 24168, 43740},
           {5, 120, 48080, 34320},
           {127, 127, 43700, 41052}});
}

TEST(Grain, LiesOnTheSheetAsItWasMade) {
  Paper paper;
  paper.seed = 5;
  const Sheet sheet = sheet_of(kSize, paper);
  const Grain grain = make_grain(kSize, paper.grain_m, paper.seed);
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const Tile& tile = sheet.inside().tile_at(column, row);
      // Each tile repeats one cell of its neighbours, and at the border of the sheet its own.
      const auto from = [&](int x, int y) {
        return static_cast<std::size_t>(std::clamp(row + y, 0, kSize - 1) * kSize +
                                        std::clamp(column + x, 0, kSize - 1));
      };
      for (const int y : {-1, 0, 1}) {
        const std::size_t at = Sheet::Inside::paper_at(column, row) + static_cast<std::size_t>(y * kTile);
        ASSERT_EQ(tile.height[at], grain.height[from(0, y)]) << column << ", " << row + y;
        ASSERT_EQ(tile.density[at], grain.density[from(0, y)]) << column << ", " << row + y;
      }
      for (const Side side : {left, right}) {
        if (column % kTile != (side == left ? 0 : kTile - 1)) continue;
        const std::size_t beyond = from(side == left ? -1 : 1, 0), y = static_cast<std::size_t>(row % kTile);
        ASSERT_EQ(tile.height_beside[side][y], grain.height[beyond]) << column << ", " << row;
        ASSERT_EQ(tile.density_beside[side][y], grain.density[beyond]) << column << ", " << row;
      }
    }
}

TEST(Amounts, AreRoundedToTheNearestUnitOnBothSides) {
  EXPECT_EQ(to_amount(1), kOne);
  EXPECT_EQ(to_amount(-1), -kOne);
  EXPECT_EQ(to_amount(0.4 / kOne), 0);
  EXPECT_EQ(to_amount(0.6 / kOne), 1);
  EXPECT_EQ(to_amount(-0.4 / kOne), 0);
  EXPECT_EQ(to_amount(-0.6 / kOne), -1);
  EXPECT_EQ(to_fraction(kOne / 4), 0.25);
}

}  // namespace
}  // namespace nazori::paint
