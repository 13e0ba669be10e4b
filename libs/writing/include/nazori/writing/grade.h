// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/mistake_kind.h"
#include "nazori/kanji/stroke.h"
#include "nazori/writing/model.h"
#include "nazori/writing/written_character.h"

namespace nazori::writing {

/// Why a stroke is wrong: what deviates most.
enum class Deviation : std::uint8_t { none, place, shape, direction, length };

/// Where a stroke of the model starts, seen from its end.
enum class Side : std::uint8_t { top, bottom, left, right };

/// One thing to say about the writing.
struct Mistake {
  kanji::MistakeKind kind = kanji::MistakeKind::wrong;
  int stroke = 0;             ///< drawn stroke, from 0; missing: stroke of the model
  std::optional<int> second;  ///< order: the drawn stroke that should have come before it, none while that is
                              ///< still to be drawn; joined, split: see `model`
  std::vector<int> model;     ///< strokes of the model it is about
  Deviation deviation = Deviation::none;                       ///< wrong: what deviates most
  char32_t character = 0;                                      ///< other: what was written
  kanji::StrokeEnding expected = kanji::StrokeEnding::either;  ///< ending: how the model ends

  Side start = Side::top;  ///< reversed: where the stroke should start

  friend bool operator==(const Mistake&, const Mistake&) = default;
};

/// How one drawn stroke compares with the model. Deviations are those left once all of the writing has been
/// laid over the model, so that neither where nor how large it was written counts.
struct StrokeVerdict {
  bool ok = false;             ///< the right stroke, at the right turn, in the right direction
  std::optional<int> matched;  ///< which stroke of the model it is, from 0
  bool reversed = false;
  double offset_x =
      0;  ///< of the stroke's centre to the right of the model's, in sides of the character's box
  double offset_y = 0;  ///< the same, down
  double size = 1;      ///< drawn length by the model's
  double angle_rad =
      0;             ///< from the model's start-to-end line to the drawn one, clockwise; 0 for closed strokes
  double shape = 0;  ///< root mean square distance of both lines brought to length 1 and to one centre
  double deviation = 0;  ///< all of it: 0 is the model, 1 the limit at normal strictness
};

/// The parts of a score; each from 0 to 1.
struct ScoreParts {
  double strokes = 1;    ///< share of strokes that are there, once, and of the right kind
  double order = 1;      ///< share of strokes at their turn
  double direction = 1;  ///< share of strokes drawn in the right direction
  double shape = 1;      ///< likeness of shapes and sizes
  double place = 1;      ///< likeness of places
};

/// Points of the parts of a score; 100 together.
inline constexpr int kPointsForStrokes = 30;
inline constexpr int kPointsForOrder = 15;
inline constexpr int kPointsForDirection = 15;
inline constexpr int kPointsForShape = 25;
inline constexpr int kPointsForPlace = 15;

/// What is said about a piece of writing.
struct Grade {
  bool accepted = false;
  std::vector<StrokeVerdict> strokes;                  ///< one for each drawn stroke
  std::vector<Mistake> mistakes;                       ///< what keeps it from being accepted, by stroke
  std::vector<Mistake> advice;                         ///< what could be better: endings, and strokes of a
                                                       ///< strange length, slant or place (`wrong`)
  std::optional<kanji::AlternativeOrder> alternative;  ///< the listed order that was used, if not the first
  std::string variant;  ///< the form of the model that fitted; empty: the main one
  ScoreParts parts;
  int score = 0;            ///< 0..100: the parts by their points
  std::optional<int> form;  ///< how well an accepted character is formed, 1 (careless) to kBestForm; none
                            ///< for what is refused or unfinished
};

/// The best form: the writing of a careful hand.
inline constexpr int kBestForm = 5;

/// How to judge.
struct GradeOptions {
  double strictness = 0.5;  ///< 0 lenient, 0.5 normal, 1 strict
  bool unfinished = false;  ///< the character is still being written: later strokes are not missing
};

inline constexpr double kLenient = 0.0;
inline constexpr double kNormal = 0.5;
inline constexpr double kStrict = 1.0;
/// At or below it another order with right strokes is advice; at or above `kEndingsCount` endings are
/// mistakes.
inline constexpr double kOrderIsAdvice = 0.25;
inline constexpr double kEndingsCount = 0.85;

/// Most points and strokes one piece of writing may have.
inline constexpr std::size_t kMaxInkPoints = 50'000;
inline constexpr std::size_t kMaxInkStrokes = 100;

/// Errc::bad_argument for ink without strokes, with a stroke without points, with all points equal, with
/// coordinates that are not finite or beyond 1e9, with too much of it, or with a stroke of which only
/// some points have times or pressures.
[[nodiscard]] base::Result<void> check(const WrittenCharacter& ink);

/// Judges what was written when `model` was asked for. `lookalikes` are characters with as many strokes that
/// differ from it only in proportions: they are compared before it is accepted.
/// Thread-safe; 0.1 ms for 12 strokes.
/// @return the errors of check(); Errc::bad_argument for a strictness outside 0..1.
[[nodiscard]] base::Result<Grade> grade(const WrittenCharacter& ink, const Model& model,
                                        const GradeOptions& options = {},
                                        std::span<const Model> lookalikes = {});

/// Judges stroke by stroke: the verdict on each stroke is the one that was given when it ended, and does not
/// change by what follows; only which stroke of the model it is (`matched`) is what all strokes so far show.
/// A stroke that passes over another is told so at once (`order` without `second`, the stroke to come first
/// is the last of `model`); the one that comes late then is right. A stroke told right stays so when another
/// is drawn over it: the newest is the one too many. Mistakes that only the end shows (missing strokes) come
/// at the end.
[[nodiscard]] base::Result<Grade> grade_live(const WrittenCharacter& ink, const Model& model,
                                             const GradeOptions& options = {},
                                             std::span<const Model> lookalikes = {});

}  // namespace nazori::writing
