// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/calligraphy/advice.h"

namespace nazori::calligraphy {

/// A written stroke beside its model.
struct StrokePair {
  const BrushStroke* written = nullptr;
  const ModelStroke* model = nullptr;
  kanji::StrokeEnding ending = kanji::StrokeEnding::stop;
  int number = 0;            ///< of the model, from 0
  double side_m = 0;         ///< of the square
  bool is_hiragana = false;  ///< its strokes start as they go on
};

/// Points of a stroke at equal distances along the line of the pen.
struct EvenStroke {
  static constexpr int kPoints = 61;
  double length_m = 0;
  std::vector<geometry::PaperPoint> at;
  std::vector<double> half_width_m;
  std::vector<double> time_s;
};
[[nodiscard]] EvenStroke even(const BrushStroke& stroke);
[[nodiscard]] EvenStroke even(const ModelStroke& stroke);

/// Start, ending, width and speed of one stroke.
[[nodiscard]] std::vector<Advice> advice_on(const StrokePair& pair);
/// Direction of a stroke of the model at its start [rad], from x to y.
[[nodiscard]] double start_direction(const EvenStroke& model, double side_m);
/// Whether the written middle line is near the model's, and the widths as well where the hand decided them.
[[nodiscard]] bool is_near(const StrokePair& pair);

}  // namespace nazori::calligraphy
