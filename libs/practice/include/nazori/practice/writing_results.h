// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/study/handwriting.h"
#include "nazori/study/writing_result.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// A grade as the study history saves it: mistakes by stroke of the model where that is known, and endings,
/// whether they count as mistakes or as advice.
[[nodiscard]] study::WritingResult to_result(const writing::Grade& grade);

/// The handwriting as the study history saves it, cut to the largest size that can be saved.
[[nodiscard]] study::Handwriting to_handwriting(const std::vector<HandStroke>& strokes);
/// The same of handwriting in glyph units.
[[nodiscard]] study::Handwriting to_saved(const study::Handwriting& strokes);

}  // namespace nazori::practice
