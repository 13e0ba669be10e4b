// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/study/handwriting.h"
#include "nazori/study/writing_result.h"
#include "nazori/writing/grade.h"
#include "pen_recorder.h"

namespace nazori::ui {

/// What the judge said, as the learner's log keeps it: mistakes by stroke of the model where that is known,
/// endings whether they count or are advice.
[[nodiscard]] study::WritingResult to_result(const writing::Grade& grade);

/// What the hand wrote, as the learner's log keeps it; no more of it than may be kept.
[[nodiscard]] study::Handwriting to_handwriting(const std::vector<HandStroke>& strokes);

}  // namespace nazori::ui
