// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/candidates.h"

#include <cmath>

#include "nazori/base/utf8.h"

namespace nazori::exchange {

Value to_json(std::span<const writing::Candidate> candidates) {
  Value characters = Value::array();
  Value likeness = Value::array();
  for (const auto& candidate : candidates) {
    characters.push_back(base::encode_utf8(candidate.character));
    likeness.push_back(std::round(candidate.likeness * 1e4) / 1e4);
  }
  return {{"candidates", std::move(characters)}, {"likeness", std::move(likeness)}};
}

Value refused_candidates() { return {{"candidates", Value::array()}}; }

}  // namespace nazori::exchange
