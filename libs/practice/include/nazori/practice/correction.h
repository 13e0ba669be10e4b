// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/practice/stroke_player.h"
#include "nazori/tablet/carved_tablet.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// The strokes of the model, from 0 and in their order, that show how a writing should have been: those of
/// its mistakes, else those of the advice about it. All of them where another character was written.
[[nodiscard]] std::vector<int> strokes_to_show(const writing::Grade& grade, int model_strokes);

/// The right strokes being drawn over a writing, one after another.
class Correction {
 public:
  /// A stroke of the model as far as it is drawn.
  struct Part {
    int stroke = 0;    ///< from 0
    double share = 0;  ///< of its length, 0..1
  };

  /// Begins with nothing drawn. @param strokes  of the model, from 0 and in their order.
  void begin(const tablet::CarvedTablet& model, std::vector<int> strokes);
  /// Nothing is drawn any more.
  void clear() { strokes_.clear(); }
  /// Draws on. @param passed_s  since the last time.
  void advance(double passed_s);
  /// Draws everything at once, for those who want no motion.
  void finish() { time_s_ = player_.duration_s(); }

  [[nodiscard]] bool is_empty() const { return strokes_.empty(); }
  [[nodiscard]] bool is_moving() const { return !is_empty() && time_s_ < player_.duration_s(); }
  /// What is drawn now; strokes that have not begun are left out.
  [[nodiscard]] std::vector<Part> parts() const;

 private:
  StrokePlayer player_;  ///< of these strokes only
  std::vector<int> strokes_;
  double time_s_ = 0;
};

}  // namespace nazori::practice
