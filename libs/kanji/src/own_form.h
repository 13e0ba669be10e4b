// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// Gives a published character the strokes and parts of somebody's form of it. What the dictionary says
/// stays. While the strokes still are those of the published character, one by one, their types, its parts
/// (where nobody changed them) and its other accepted orders stay, too.
/// @param form  with own_form, and the parts that author::kanji_character() makes.
void take_form(Character& published, const Character& form);

}  // namespace nazori::kanji
