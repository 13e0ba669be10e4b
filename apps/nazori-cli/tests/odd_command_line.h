// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace nazori::cli::test {

/// A description full of characters that are special in shells and roff.
inline const std::string kOddDescription =
    ".It's \"all\" $(touch pwned) `touch pwned` [a] {b} \\n \\fB #c; d & e | -f ~g ^h !i *";

/// A command line with every kind of option, and with descriptions and words that must be quoted.
struct OddCommandLine {
  OddCommandLine() {
    app.set_version_flag("--version", "1");
    CLI::App* carve = app.add_subcommand("carve", kOddDescription);
    carve->add_option("-o,--output", text, kOddDescription)->required()->type_name("FILE");
    carve->add_option("--folder", text, "A folder")->type_name("FOLDER");
    carve->add_option("--shape", text, "A shape")->check(CLI::IsMember({"round", "it's", "$(touch pwned)"}));
    carve->add_option("--level", number, "A level")
        ->transform(CLI::CheckedTransformer(std::map<std::string, int>{{"high", 2}, {"low", 1}}));
    carve->add_option("--fault", texts, "A fault")->type_name("KIND:STROKE");
    carve->add_option("--size", number, "A size")->check(range)->default_str("4")->type_name("N");
    carve->add_option("--window", numbers, "A window")->delimiter(',')->expected(4)->type_name("A,B,C,D");
    carve->add_option("--rename", pair, "Two names")->expected(2)->type_name("NAME");
    carve->add_option("--hidden", text, "Not shown")->group("");
    carve->add_flag("-q,--quiet", flag, "A flag");
    carve->add_option("characters", texts, "Characters")->required();
    CLI::App* study = app.add_subcommand("study", "Study");
    study->require_subcommand(1);
    study->add_subcommand("check", "Check")->add_option("file", text, "The file");
    app.add_subcommand("secret", "Not shown")->group("");
  }
  OddCommandLine(const OddCommandLine&) = delete;
  OddCommandLine& operator=(const OddCommandLine&) = delete;

  std::string text;
  std::vector<std::string> texts;
  std::vector<std::string> pair;
  std::vector<double> numbers;
  int number = 0;
  bool flag = false;
  CLI::Validator range{[](std::string&) { return std::string(); }, "2..8"};
  CLI::App app{"A program", "nazori-cli"};
};

}  // namespace nazori::cli::test
