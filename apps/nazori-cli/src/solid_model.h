// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/exchange/tablets.h"
#include "nazori/practice/solid_model.h"
#include "output_files.h"

namespace nazori::cli {

/// Writes a plate as a solid, .stl or .3mf by the name of the file, and says what was written.
/// @param subject  a character, a word or an expression: the name of the object in a 3MF.
[[nodiscard]] base::Result<exchange::SolidModel> save_model(const practice::SolidPlate& plate,
                                                            const OutputPlace& place,
                                                            const std::string& subject);

/// The model in one line for people.
[[nodiscard]] std::string model_text(const exchange::SolidModel& made);

/// The strokes whose numbers found no room, in one line; empty where all did.
[[nodiscard]] std::string without_number_text(const std::vector<int>& without_number);

}  // namespace nazori::cli
