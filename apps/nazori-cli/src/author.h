// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "nazori/author/character_file.h"
#include "nazori/base/result.h"
#include "verbs.h"

namespace nazori::cli {

/// The commands of `nazori-cli author`, as in verbs.h.
void add_author_check(CLI::App& author, Action& chosen);
void add_author_convert(CLI::App& author, Action& chosen);
void add_author_trace(CLI::App& author, Action& chosen);
void add_author_keep(CLI::App& author, Action& chosen);

/// A file with a character that somebody made, and its text where it is an SVG.
struct AuthorFile {
  author::OwnCharacter character;
  std::string svg;
};

/// @param grid  side of the grid of a .str or a RAW. @return errors name the file.
[[nodiscard]] base::Result<AuthorFile> read_author_file(const std::string& file, std::optional<int> grid);

/// The endings of all files that read_author_file() reads and that are written.
[[nodiscard]] std::vector<std::string> author_extensions();

}  // namespace nazori::cli
