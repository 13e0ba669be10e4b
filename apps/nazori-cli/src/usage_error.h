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

/// The innermost verb that has been read, the program itself where there is none.
[[nodiscard]] const CLI::App& last_verb(const CLI::App& app);

/// "nazori-cli study due": the program with the verbs that have been read.
[[nodiscard]] std::string name_of_verb(const CLI::App& app);

/// Names of the verbs directly below: "info", "search"; those without a group are hidden and left out.
[[nodiscard]] std::vector<std::string> verbs_below(const CLI::App& app);

/// What the parser refused, in the words of this program: the option or verb, what is wrong, and the one that
/// was probably meant.
[[nodiscard]] base::Error usage_error(const CLI::App& app, const CLI::ParseError& error);

/// Why there is no verb of that name below `app`, and which one was probably meant.
[[nodiscard]] base::Error no_such_verb(const CLI::App& app, const std::string& given);

/// The first option that was given an empty text for its value, if any: "" never names a file, a folder or a
/// learner, and an option that is left out has another meaning.
[[nodiscard]] std::optional<base::Error> empty_value(const CLI::App& app);

}  // namespace nazori::cli
