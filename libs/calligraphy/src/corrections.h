// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/calligraphy/advice.h"
#include "whole_advice.h"

namespace nazori::calligraphy {

/// What a teacher draws for this advice.
[[nodiscard]] std::vector<CorrectionMark> marks_for(const WholePairs& pairs, const CharacterAdvice& advice);

}  // namespace nazori::calligraphy
