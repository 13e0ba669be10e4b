// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "nazori/base/result.h"
#include "nazori/geometry/bristle_segment.h"
#include "nazori/paint/amount.h"
#include "nazori/paint/colour.h"
#include "nazori/paint/ink_load.h"
#include "nazori/paint/paper.h"

namespace nazori::paint {

/// What one cell of a sheet holds.
struct Cell {
  Amount surface = 0;       ///< water that stands on the paper
  Amount fibre = 0;         ///< water in the fibres
  PigmentAmounts moving{};  ///< pigment in that water
  PigmentAmounts fixed{};   ///< pigment of the newest layer that no longer moves
  Amount covered = 0;       ///< pigment of older layers, of every kind
  double height = 0;        ///< of the paper, 0 hollow .. 1 top; all heights are equally frequent

  friend bool operator==(const Cell&, const Cell&) = default;
};

/// What a whole sheet holds.
struct Holding {
  TotalAmount water = 0;
  std::array<TotalAmount, kSlots> pigment{};  ///< moving and fixed
  TotalAmount covered = 0;                    ///< pigment of older layers
};

/// How steps are computed. The result does not depend on it.
struct StepOptions {
  int threads = 1;    ///< 1 or 2
  bool sleep = true;  ///< leave out tiles in which nothing can change
};

/// A sheet of paper with water and pigment, 102.4 mm wide, in tiles of 32 x 32 cells.
///
/// Frames: PaperFrame in metres, or column and row with row 0 at the top. Water and pigment are whole numbers
/// that only move: what a cell gives another cell takes, what dries is counted by evaporated(). So their sums
/// are constant to the last unit. The same calls give the same bytes, on 1 or 2 threads.
/// Thread rules: one thread at a time. Memory: about 42 KiB a tile, 42 MiB for 1024 x 1024 cells.
class Sheet {
 public:
  static constexpr double kSide_m = 0.1024;
  static constexpr double kStep_s = 1.0 / 60;
  static constexpr int kLargest = 1024;

  /// @param size  cells a side: 128, 256, 512 or 1024.
  /// @return Errc::bad_argument, also for a paper that check() refuses.
  [[nodiscard]] static base::Result<Sheet> create(int size, const Paper& paper,
                                                  const std::array<Pigment, kSlots>& palette);
  Sheet(Sheet&&) noexcept;
  Sheet& operator=(Sheet&&) noexcept;
  ~Sheet();

  [[nodiscard]] int size() const;
  [[nodiscard]] double cell_m() const { return kSide_m / size(); }
  /// How many units of an InkLoad are one unit of this sheet's cells: 1 with 1024 cells, 64 with 128. An
  /// amount in a cell is a depth, so a larger cell holds more.
  [[nodiscard]] TotalAmount area() const;
  [[nodiscard]] const Paper& paper() const;
  [[nodiscard]] const std::array<Pigment, kSlots>& palette() const;
  /// Gives a slot another pigment. What the slot still holds must be dry; it becomes an older layer.
  /// @return Errc::bad_argument where the slot is out of range or still wet.
  [[nodiscard]] base::Result<void> set_pigment(int slot, const Pigment& pigment);

  /// @param column,row  within [0, size).
  [[nodiscard]] Cell at(int column, int row) const;
  /// Drops water and pigment on a cell, as far as it takes them (a cell holds 16 kOne of water, 8 of moving
  /// pigment). Negative amounts count as 0.
  /// @return what it took: water, then pigment.
  std::pair<Amount, PigmentAmounts> drop(int column, int row, Amount water, const PigmentAmounts& pigment);
  /// Takes ink from the brush along the segments: docs/brush.md, "Deposit". Values that are not finite, and
  /// what lies beside the sheet, are passed over.
  void touch(std::span<const geometry::BristleSegment> segments, InkLoad& load);

  /// Lets kStep_s pass: water seeps, spreads and dries, pigment goes with it and settles.
  void step(const StepOptions& options = {});
  /// Dries the sheet at once: all water evaporates, all pigment stays where it is, up to 10 kOne
  /// of a slot in a cell; what is more stays loose.
  void dry_now();
  /// While a sheet is frozen, step() does nothing.
  void set_frozen(bool frozen);
  [[nodiscard]] bool is_frozen() const;
  /// Whether water is left.
  [[nodiscard]] bool is_wet() const;
  /// Water that went into the air since the sheet was made.
  [[nodiscard]] TotalAmount evaporated() const;
  [[nodiscard]] Holding holding() const;
  /// Tiles that the last step computed.
  [[nodiscard]] int tiles_awake() const;
  /// Whether two sheets are alike in every bit that a file keeps.
  [[nodiscard]] bool is_same_as(const Sheet& other) const;

  struct Inside;
  /// For the other sources of this room.
  [[nodiscard]] Inside& inside() { return *inside_; }
  [[nodiscard]] const Inside& inside() const { return *inside_; }

 private:
  explicit Sheet(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::paint
