// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "command_table.h"

namespace nazori::cli {

/// The completion script of a shell for the whole command line: commands, options with their descriptions
/// (zsh and fish), the words of fixed choices, files and folders where they are accepted, otherwise nothing.
/// The same table gives the same bytes.
[[nodiscard]] std::string bash_completion(const Command& program);
[[nodiscard]] std::string zsh_completion(const Command& program);
[[nodiscard]] std::string fish_completion(const Command& program);

/// `text` in single quotes as bash and zsh read it: nothing in it is expanded.
[[nodiscard]] std::string shell_quoted(std::string_view text);

/// `text` with every run of spaces and line ends made one space: fit for a line of a script.
[[nodiscard]] std::string in_one_line(std::string_view text);

/// `text` with a backslash before each of `characters` and before each backslash.
[[nodiscard]] std::string with_backslashes(std::string_view text, std::string_view characters);

}  // namespace nazori::cli
