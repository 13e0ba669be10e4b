// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/exchange/document.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/pen_motion.h"

namespace nazori::exchange {

/// What is to be graded (docs/schemas/handwriting.json, grade_request).
struct GradeRequest {
  char32_t character = 0;
  writing::WrittenCharacter ink;
};

/// Reads "char" and the members of read_handwriting().
/// @return its errors; Errc::parse and Errc::bad_argument for a "char" that is not one character.
[[nodiscard]] base::Result<GradeRequest> read_grade_request(const Value& request);

/// A grade in sentences, for the learner.
struct GradeExplanation {
  std::vector<std::string> verdict;
  std::vector<std::string> score;
  std::vector<std::string> motion;  ///< empty where the motion is not known
};

/// What is answered to a GradeRequest.
struct GradeAnswer {
  char32_t character = 0;
  writing::Grade grade;
  std::vector<writing::PenMotion>
      motion;  ///< of each stroke; empty where neither times nor pressures are known
  std::optional<GradeExplanation> explanation;
};

/// docs/schemas/handwriting.json, grade. Strokes are counted from 0; numbers are rounded to four decimals.
[[nodiscard]] Value to_json(const GradeAnswer& answer);

/// Reads such an answer: all that the document holds, with numbers as they were rounded.
/// @return Errc::parse with the member in Error::where.
[[nodiscard]] base::Result<GradeAnswer> read_grade(const Value& answer);

/// What the answer to a refused request holds besides "line" and "error" (docs/schemas/handwriting.json,
/// refused_grade).
[[nodiscard]] Value refused_grade();

}  // namespace nazori::exchange
