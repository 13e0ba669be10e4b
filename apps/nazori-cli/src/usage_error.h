// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nazori/base/result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the name that CLI11 has
class App;
class ParseError;
}  // namespace CLI

namespace nazori::cli {

/// The innermost parsed command, the program itself if there is none.
[[nodiscard]] const CLI::App& last_verb(const CLI::App& app);

/// "nazori-cli study due": the program with the parsed commands.
[[nodiscard]] std::string name_of_verb(const CLI::App& app);

/// Names of the direct subcommands: "info", "search"; those without a group are hidden and left out.
[[nodiscard]] std::vector<std::string> verbs_below(const CLI::App& app);

/// The parser's error in the words of this program: the option or command, what is wrong, and the one that
/// was probably meant.
[[nodiscard]] base::Error usage_error(const CLI::App& app, const CLI::ParseError& error);

/// The error for a missing subcommand of `app`, and which one was probably meant.
[[nodiscard]] base::Error no_such_verb(const CLI::App& app, const std::string& given);

/// The first option with an empty text as its value, if any: "" never names a file, a folder or a learner,
/// and omitting the option has another meaning.
[[nodiscard]] std::optional<base::Error> empty_value(const CLI::App& app);

}  // namespace nazori::cli
