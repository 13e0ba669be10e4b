// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/character.h"

namespace nazori::kanji {

std::vector<StrokeLine> Character::lines() const {
  std::vector<StrokeLine> out;
  out.reserve(strokes.size());
  for (const Stroke& stroke : strokes) out.push_back(stroke.line);
  return out;
}

}  // namespace nazori::kanji
