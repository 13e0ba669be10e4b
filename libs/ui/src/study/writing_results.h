// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/study/ink.h"
#include "nazori/study/writing_result.h"
#include "nazori/writing/grade.h"

namespace nazori::ui {

/// What the judge said, as the learner's log keeps it: faults by stroke of the model where that is known,
/// endings whether they count or are advice.
[[nodiscard]] study::WritingResult to_result(const writing::Grade& grade);

/// What the hand wrote, as the learner's log keeps it; no more of it than may be kept.
[[nodiscard]] study::Ink to_study_ink(const std::vector<practice::HandStroke>& strokes);

}  // namespace nazori::ui
