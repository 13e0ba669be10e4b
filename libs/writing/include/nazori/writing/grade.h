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

/// The side of a stroke of the model on which it starts.
enum class Side : std::uint8_t { top, bottom, left, right };

/// One mistake, or piece of advice, in a writing.
struct Mistake {
  kanji::MistakeKind kind = kanji::MistakeKind::wrong;
  int stroke = 0;             ///< drawn stroke, from 0; missing: stroke of the model
  std::optional<int> second;  ///< order: the drawn stroke that should have come before it, none if it is not
                              ///< drawn yet; joined, split: see `model`
  std::vector<int> model;  ///< strokes of the model it is about; missing: also one that looks alike and may
                           ///< be missing instead (one of two voicing marks)
  Deviation deviation = Deviation::none;                       ///< wrong: what deviates most
  char32_t character = 0;                                      ///< other: what was written
  kanji::StrokeEnding expected = kanji::StrokeEnding::either;  ///< ending: the ending of the model

  Side start = Side::top;  ///< reversed: where the stroke should start

  friend bool operator==(const Mistake&, const Mistake&) = default;
};

/// How one drawn stroke compares with the model. Deviations are measured after the writing has been fitted to
/// the model, so that its position and size do not count.
struct StrokeVerdict {
  bool ok = false;             ///< the right stroke, in the right order and direction
  std::optional<int> matched;  ///< which stroke of the model it is, from 0
  bool reversed = false;
  double offset_x =
      0;  ///< distance of the stroke's centre to the right of the model's, in sides of the character's box
  double offset_y = 0;  ///< the same, down
  double size = 1;      ///< ratio of the drawn length to the model's
  double angle_rad =
      0;             ///< from the model's start-to-end line to the drawn one, clockwise; 0 for closed strokes
  double shape = 0;  ///< root-mean-square distance of both lines, scaled to length 1 and centred
  double deviation = 0;  ///< all of it: 0 is the model, 1 the limit at normal strictness
};

/// The parts of a score; each from 0 to 1.
struct ScoreParts {
  double strokes = 1;    ///< share of strokes that are there, once, and of the right kind
  double order = 1;      ///< share of strokes in the right order
  double direction = 1;  ///< share of strokes drawn in the right direction
  double shape = 1;      ///< similarity of shapes and sizes
  double place = 1;      ///< likeness of places
};

/// Points of the parts of a score; 100 together.
inline constexpr int kPointsForStrokes = 30;
inline constexpr int kPointsForOrder = 15;
inline constexpr int kPointsForDirection = 15;
inline constexpr int kPointsForShape = 25;
inline constexpr int kPointsForPlace = 15;

/// The result of grading a writing.
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
  double probability = 0;   ///< that a teacher would accept it: calibrated on real writing and on spoiled
                            ///< copies of it (docs/writing.md)
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
/// At or below this strictness a wrong order of right strokes is only advice; at or above `kEndingsCount`
/// wrong endings are mistakes.
inline constexpr double kOrderIsAdvice = 0.25;
inline constexpr double kEndingsCount = 0.85;

/// The probability that a stroke of a strange shape, size or place must leave for the writing to be accepted:
/// the strictness is this threshold. Order and endings follow the limits above.
/// @pre strictness 0..1
[[nodiscard]] double needed_probability(double strictness);

/// Maximum number of points and strokes of one writing.
inline constexpr std::size_t kMaxInkPoints = 50'000;
inline constexpr std::size_t kMaxInkStrokes = 100;

/// Errc::bad_argument for ink without strokes, with a stroke without points, with all points equal, with
/// coordinates that are not finite or beyond 1e9, with too many points or strokes, or with a stroke of which
/// only some points have times or pressures.
[[nodiscard]] base::Result<void> check(const WrittenCharacter& ink);

/// Grades a writing of the character of `model`. `lookalikes` are characters with the same number of strokes
/// that differ from it only in proportions: the writing is compared with them before it is accepted.
/// Thread-safe; 0.1 ms for 12 strokes.
/// @return the errors of check(); Errc::bad_argument for a strictness outside 0..1.
[[nodiscard]] base::Result<Grade> grade(const WrittenCharacter& ink, const Model& model,
                                        const GradeOptions& options = {},
                                        std::span<const Model> lookalikes = {});

/// Grades stroke by stroke: the verdict on each stroke is given when it ends and does not change with later
/// strokes. Only `matched`, the stroke of the model that it is, follows from all strokes so far. A stroke
/// that skips another one is reported at once (`order` without `second`, the stroke that should come first is
/// the last of `model`); the late one is then right. A right stroke stays right when another is drawn over
/// it: the newer one is the extra one. Mistakes that only the end shows (missing strokes) come at the end.
[[nodiscard]] base::Result<Grade> grade_live(const WrittenCharacter& ink, const Model& model,
                                             const GradeOptions& options = {},
                                             std::span<const Model> lookalikes = {});

}  // namespace nazori::writing
