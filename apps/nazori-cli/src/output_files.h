// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "characters.h"
#include "nazori/base/result.h"

namespace nazori::cli {

/// What an option for output files asks for.
struct OutputRequest {
  std::string option;                   ///< "--output", for messages
  std::string text;                     ///< as given: a file, a name with {} for the character, or a folder
  std::vector<std::string> extensions;  ///< allowed ones, the first being what files in a folder get
};

/// The file for each of the characters, checked before any work is done: the folder is there and may be
/// written to, the kind of file is one that can be made, several characters get several files.
[[nodiscard]] base::Result<std::vector<std::filesystem::path>> output_files(
    const OutputRequest& request, std::span<const CharacterName> characters);

/// The same for one file that belongs to no character.
[[nodiscard]] base::Result<std::filesystem::path> output_file(const OutputRequest& request);

}  // namespace nazori::cli
