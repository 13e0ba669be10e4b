// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/paint/sheet.h"

namespace nazori::paint {

/// Undo and redo of the strokes on one sheet, with the ink that the brush had. A state is the sheet in every
/// bit: water comes back wet, what had evaporated since is water again, and the brush has its ink back.
/// Thread rules: one thread.
class History {
 public:
  static constexpr std::size_t kStrokes = 100;

  /// @param limit  strokes that can be undone, at least 1; the oldest are forgotten.
  explicit History(std::size_t limit = kStrokes);

  /// Call it before each stroke. What was undone before can no longer be redone.
  void remember(const Sheet& sheet, const InkLoad& load);
  [[nodiscard]] bool can_undo() const { return !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  /// Brings back the state before the last stroke. Call it with the sheet that remember() got.
  /// @return whether there was one.
  bool undo(Sheet& sheet, InkLoad& load);
  bool redo(Sheet& sheet, InkLoad& load);
  /// Memory of all states [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;
  struct State {
    std::vector<Bytes> tiles;
    std::array<Pigment, kSlots> palette;
    InkLoad load;
  };
  /// The bytes of a tile as it was at a version.
  struct Known {
    std::uint64_t version = 0;
    Bytes bytes;
  };
  [[nodiscard]] State state_of(const Sheet& sheet, const InkLoad& load);
  void restore(const State& state, Sheet& sheet, InkLoad& load);

  std::size_t limit_;
  std::vector<State> past_, future_;
  std::vector<Known> known_;  // of each tile, so that only tiles that changed are packed
};

}  // namespace nazori::paint
