// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nazori/writing/grade.h"

namespace nazori::writing {

/// Languages explanations are written in.
enum class Language : std::uint8_t { english, japanese };

/// What is wrong and what could be better, in whole sentences a learner understands, mistakes before advice,
/// in the order of strokes. Strokes have the model's numbers, from 1; one that the model does not have has
/// its turn. "Stroke 3 was drawn before stroke 2.", "Stroke 4 starts at the top." Never empty: writing
/// without mistake is called right, and a listed order is named.
[[nodiscard]] std::vector<std::string> explain(const Grade& grade, Language language);

/// One mistake (or piece of advice) of `grade` as a sentence.
[[nodiscard]] std::string explain(const Mistake& mistake, const Grade& grade, Language language);

/// What the score is made of, one sentence for each part in the order of ScoreParts; the points in them add
/// up to the score. "Order: 13 of 15 points, for each at its turn."
[[nodiscard]] std::vector<std::string> explain_score(const Grade& grade, Language language);

}  // namespace nazori::writing
