// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "nazori/exchange/document.h"
#include "nazori/writing/recogniser.h"

namespace nazori::exchange {

/// The characters that may have been meant, best first (docs/schemas/handwriting.json, candidates).
[[nodiscard]] Value to_json(std::span<const writing::Candidate> candidates);

/// What the answer to a refused request holds besides "line" and "error" (docs/schemas/handwriting.json,
/// refused_candidates).
[[nodiscard]] Value refused_candidates();

}  // namespace nazori::exchange
