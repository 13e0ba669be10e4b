// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nazori/writing/grade.h"

namespace nazori::writing {

/// The languages of explanations.
enum class Language : std::uint8_t { english, japanese };

/// Mistakes and advice in whole sentences for a learner, mistakes before advice, in the order of strokes.
/// Strokes have the model's numbers, from 1; a stroke that the model does not have is numbered by its
/// position in the writing. "Stroke 3 was drawn before stroke 2.", "Stroke 4 starts at the top." Never empty:
/// writing without mistakes is called right, and a listed order is named.
[[nodiscard]] std::vector<std::string> explain(const Grade& grade, Language language);

/// One mistake (or piece of advice) of `grade` as a sentence.
[[nodiscard]] std::string explain(const Mistake& mistake, const Grade& grade, Language language);

/// The parts of the score, one sentence for each in the order of ScoreParts; the points in them add up to the
/// score. "Order: 13 of 15 points, for each at its turn."
[[nodiscard]] std::vector<std::string> explain_score(const Grade& grade, Language language);

}  // namespace nazori::writing
