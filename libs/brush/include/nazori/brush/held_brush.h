// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/brush/aim.h"
#include "nazori/brush/pen.h"
#include "nazori/brush/tuft.h"

namespace nazori::brush {

/// A brush that a pen moves: sets its tip down where the pen comes down, keeps the ink under the pen, and
/// ends a stroke where the pen leaves the paper. Thread-safe: no.
class HeldBrush {
 public:
  /// @cost that of Aim.
  explicit HeldBrush(const TuftForm& form, const Handling& handling = {});

  /// Another way in which the pen becomes a brush. Begins as if the pen had not been seen before.
  void set_handling(const Handling& handling);
  /// Moves the brush with the pen. @param sample  of finite numbers, at a time after the one before.
  /// @param wetness  of the hair, 0..1.
  /// @return what the hair swept on the paper, in order; valid until the next call.
  [[nodiscard]] std::span<const geometry::BristleSegment> move(const PenSample& sample, double wetness);
  /// Straightens the hair, as dipping and wiping do.
  void reset() { tuft_.reset(); }

  [[nodiscard]] const Tuft& tuft() const { return tuft_; }
  /// Where the pen was last, and whether it was down; not down before the first move.
  [[nodiscard]] const PenSample& pen() const { return pen_; }

 private:
  void touch_down(const PenSample& sample);

  Handling handling_;
  Tuft tuft_;
  PenToHolder holder_;
  Aim aim_;
  PenSample pen_;
  std::vector<geometry::BristleSegment> swept_;
};

}  // namespace nazori::brush
