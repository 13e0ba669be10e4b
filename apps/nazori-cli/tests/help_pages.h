// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace nazori::cli::test {

/// The content of `nazori-cli VERB --help`.
struct HelpPage {
  std::vector<std::string> verb;     ///< {"study", "due"}; empty for the program
  std::vector<std::string> verbs;    ///< in order
  std::vector<std::string> options;  ///< every name with its dashes: "-o", "--output"
  std::vector<std::string> arguments;

  /// "study due"
  [[nodiscard]] std::string path() const;
};

/// The help of the program and of all its commands, read once.
const std::vector<HelpPage>& help_pages();

}  // namespace nazori::cli::test
