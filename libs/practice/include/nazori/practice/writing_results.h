// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/study/handwriting.h"
#include "nazori/study/writing_result.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// A grade as the study history saves it: faults by stroke of the model where that is known,
/// endings whether they count or are advice.
[[nodiscard]] study::WritingResult to_result(const writing::Grade& grade);

/// What the hand wrote, as the study history saves it; no more of it than may be saved.
[[nodiscard]] study::Handwriting to_handwriting(const std::vector<HandStroke>& strokes);

}  // namespace nazori::practice
