// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nazori/calligraphy/brush_stroke.h"
#include "nazori/calligraphy/ruling.h"
#include "nazori/calligraphy/sheet_ink.h"
#include "nazori/geometry/written_stroke.h"
#include "nazori/kanji/character.h"
#include "nazori/writing/grade.h"

namespace nazori::calligraphy {

/// A character that stands as model in a square of the sheet.
struct SheetModel {
  kanji::Character character;
  RuledSquare square;
  /// Lines and widths in glyph units, one for each stroke of the character, as of a brush font. Empty: the
  /// lines of the character with the width of a brush.
  std::vector<carving::Groove> strokes = {};
};
/// The strokes of a model in its square, which are shown and compared.
[[nodiscard]] std::vector<ModelStroke> strokes_of(const SheetModel& model);

/// What a piece of advice is about. Each is judged apart from the others.
enum class AdviceKind : std::uint8_t {
  start_turned,  ///< the start points elsewhere; amount: radians from the model, counterclockwise
  hidden_tip,    ///< the tip first moves back (an advanced start); amount: by how much [sides]
  no_stop,       ///< thins out, or is lifted while moving; amount: width at the end over that of the body
  no_hook,       ///< has no hook, or a blunt one; amount as for no_stop
  no_sweep,      ///< ends broad; amount as for no_stop
  thin,          ///< amount: width over that of the model
  thick,         ///< likewise
  flat_width,    ///< of the character: no change from thick to thin; amount: thick over thin
  hasty,         ///< a part is much faster than the rest; amount: fastest speed over slowest
  halting,       ///< a part is much slower than the rest; amount as for hasty
  uncovered,     ///< of the character; amount: share of the model that has ink
  outside,       ///< of the character; amount: share of the ink that lies beside the model
  too_far_left,  ///< of the character: its centre of gravity; amount: distance [sides]
  too_far_right,
  too_high,
  too_low,
  too_large,   ///< of the character; amount: its size over that of the model
  too_small,   ///< likewise
  wide_gap,    ///< between `stroke` and `second`; amount: the gap over that of the model
  narrow_gap,  ///< likewise
};

/// A third of a stroke.
enum class StrokePart : std::uint8_t { beginning, middle, end };

/// One piece of advice: a number, no sentence.
struct Advice {
  AdviceKind kind = AdviceKind::thin;
  int stroke = -1;                       ///< of the model, from 0; -1: of the whole character
  int second = -1;                       ///< of a gap
  StrokePart part = StrokePart::middle;  ///< of hasty and halting
  double amount = 0;

  friend bool operator==(const Advice&, const Advice&) = default;
};

/// What a teacher draws over a writing in vermilion.
struct CorrectionMark {
  enum class Kind : std::uint8_t {
    outline,  ///< around the stroke of the model
    arrow,    ///< from `from` to `to`: how a stroke should start, or where something belongs
    circle,   ///< around what is very good
  };
  Kind kind = Kind::outline;
  int stroke = -1;  ///< of the model, from 0; -1: of the whole character
  std::vector<geometry::Polyline<geometry::PaperFrame>> outline = {};  ///< closed lines
  geometry::PaperPoint from = {}, to = {};  ///< of an arrow; `to`: middle of a circle
  double radius_m = 0;                      ///< of a circle
};

/// What can be said about one written character.
struct CharacterAdvice {
  char32_t character = 0;
  int written = 0;  ///< strokes in its square
  /// These strokes in glyph units of the square, with times since the first point, and pressures where the
  /// pen reported them.
  geometry::WrittenStrokes<geometry::GlyphFrame> ink;
  /// Which stroke is which, and mistakes such as a missing stroke. None where the square is empty or the
  /// strokes cannot be compared.
  std::optional<writing::Grade> grade;
  bool is_comparable = false;  ///< at least half of the strokes were found
  std::vector<Advice> advice;  ///< by stroke, then about the whole
  std::vector<int> good;       ///< strokes of the model, from 0, that are very good
  bool is_good = false;        ///< no mistake and no advice
  std::vector<CorrectionMark> marks;
  double covered = 0;  ///< share of the model that has ink
  double outside = 0;  ///< share of the ink that lies beside the model
};

/// How to compare.
struct AdviceOptions {
  /// The model lies beneath: its place counts for the coverage. Beside it only the form does.
  bool traced = true;
};

/// Compares what is written on a sheet with its models. A stroke belongs to the square in which most of it
/// lies. Advice only: no mark, and no more than these thresholds know (docs/brush.md). Widths are judged only
/// where the hand decided them (WidthFrom). Thread-safe.
/// @param strokes  in the order in which they were written. @param ink  that the sheet holds.
/// @return one for each model, in their order.
[[nodiscard]] std::vector<CharacterAdvice> advise(std::span<const BrushStroke> strokes, const SheetInk& ink,
                                                  std::span<const SheetModel> models,
                                                  const AdviceOptions& options = {});

}  // namespace nazori::calligraphy
