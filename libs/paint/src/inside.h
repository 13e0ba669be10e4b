// SPDX-License-Identifier: Apache-2.0
// The fields of a sheet, tile by tile.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/paint/sheet.h"

namespace nazori::paint {

inline constexpr int kTile = 32;
inline constexpr int kCells = kTile * kTile;
/// Rows of the paper's own fields, which repeat one row of the tiles above and below.
inline constexpr int kPaperRows = kTile + 2;

inline constexpr Amount kMostWater = 16 * kOne;
/// Above it a cell takes no more moving pigment. An eighth at most comes through each of its four sides, so
/// that twice this is never exceeded.
inline constexpr Amount kMostMoving = 8 * kOne;
inline constexpr Amount kMostFixed = 10 * kOne;

using Field = std::array<Amount, kCells>;
using PaperField = std::array<std::uint16_t, std::size_t{kPaperRows} * kTile>;
/// The paper of the columns left and right of a tile.
using PaperSides = std::array<std::array<std::uint16_t, kTile>, 2>;

/// What a neighbouring tile needs of one side of a tile, as it was before the step.
struct alignas(64) Edge {
  std::array<Amount, kTile> surface{}, fibre{};
  std::array<std::array<Amount, kTile>, kSlots> moving{};
  std::uint32_t slots = 0;    ///< bit k: moving[k] holds something; else it is not filled and counts as 0
  bool has_standing = false;  ///< surface holds something; else likewise
};

enum Side : std::uint8_t { left, right, top, bottom };

/// The dry layers below the newest one.
struct Ground {
  Field covered{};                                         ///< their pigment
  std::array<std::array<float, kCells>, 3> reflectance{};  ///< what they and the paper reflect, inside
  friend bool operator==(const Ground&, const Ground&) = default;
};

struct Tile {
  alignas(64) Field surface{}, fibre{};
  std::array<Field, kSlots> moving{}, fixed{};
  PaperField height{}, density{};
  PaperSides height_beside{}, density_beside{};
  std::array<std::array<Edge, 4>, 2> edges{};  ///< of this step and of the next one, see shown
  std::unique_ptr<Ground> ground;
  TotalAmount evaporated = 0;
  std::uint64_t version = 0;       ///< another number after every change of a field
  std::uint32_t standing = 0;      ///< bit y: water may stand on row y
  std::uint8_t slots = 0;          ///< bit k: moving[k] or fixed[k] may hold something
  bool is_wet = false;             ///< any water
  bool has_changed = false;        ///< since its edges were published
  bool has_next_edges = false;     ///< as the fields are now
  std::uint8_t shown = 0;          ///< which of the edges are those of this step
  std::uint8_t edges_changed = 0;  ///< bit of each Side: for this step
  std::uint8_t next_changed = 0;   ///< likewise, for the next one
};

/// Numbers of the paper, as the step needs them.
struct StepRules {
  float conductivity = 0, conductivity_loss = 0;
  float pinning = 0, pinning_height = 0, pinning_density = 0;  // in units of water
  Amount absorption = 0, evaporation = 0, rim_evaporation = 0;
  float fixing = 0;
  std::array<float, kSlots> granulation{}, mobility{};
};

struct Sheet::Inside {
  int size = 0;
  int tiles_a_side = 0;
  Paper paper;
  std::array<Pigment, kSlots> palette;
  StepRules rules;
  Bands paper_inside{};  ///< what the paper reflects, inside
  std::vector<std::unique_ptr<Tile>> tiles;
  bool is_frozen = false;
  int awake = 0;
  std::uint64_t versions = 0;
  std::vector<Tile*> active;
  std::unique_ptr<base::Executor> second;

  [[nodiscard]] Tile& tile_at(int column, int row) const {
    return *tiles[static_cast<std::size_t>(row / kTile) * static_cast<std::size_t>(tiles_a_side) +
                  static_cast<std::size_t>(column / kTile)];
  }
  [[nodiscard]] static std::size_t cell_at(int column, int row) {
    return static_cast<std::size_t>(row % kTile) * kTile + static_cast<std::size_t>(column % kTile);
  }
  /// As cell_at(), in a field of the paper.
  [[nodiscard]] static std::size_t paper_at(int column, int row) { return kTile + cell_at(column, row); }
  /// Notes that a field of a tile was changed from outside.
  void touch_tile(Tile& tile) {
    tile.has_changed = true;
    tile.has_next_edges = false;
    tile.standing = ~std::uint32_t{0};
    tile.version = ++versions;
  }
  /// Makes the fixed pigment of a cell part of the ground.
  void cover(Tile& tile, std::size_t cell) const;
  void make_rules();
  /// Sets what follows from the fields of a tile: slots, is_wet, edges. For tiles that were filled from
  /// outside.
  void settle(Tile& tile);
};

[[nodiscard]] inline const Edge& shown_edge(const Tile& tile, Side side) {
  return tile.edges[tile.shown][side];
}
/// Copies the sides of a tile into its edges for the next step and notes which of them changed.
void prepare_edges(Tile& tile);
/// Makes them those of this step.
void publish_edges(Tile& tile);
/// A tile and the edges that face it; nullptr at the border of the sheet.
struct Surrounded {
  Tile* tile;
  std::array<const Edge*, 4> neighbours;
};
/// One step of a tile whose edges are published. @param next  the tile whose turn it is afterwards, which is
/// brought into the cache meanwhile; nullptr for none. @return whether anything changed.
[[nodiscard]] bool step_tile(const StepRules& rules, const Surrounded& now, const Surrounded* next = nullptr);

/// Height and density of every cell of a sheet, each equally distributed over 0..65535, row by row.
struct Grain {
  std::vector<std::uint16_t> height, density;
};
[[nodiscard]] Grain make_grain(int size, double grain_m, std::uint32_t seed);

}  // namespace nazori::paint
