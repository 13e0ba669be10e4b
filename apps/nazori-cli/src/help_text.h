// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace nazori::cli {

/// Help in lines of at most 80 columns: each option with its value, its purpose, its range and its default.
class HelpText final : public CLI::Formatter {
 public:
  HelpText();
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name,
                                      CLI::AppFormatMode mode) const override;
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool is_positional) const override;
  [[nodiscard]] std::string make_subcommand(const CLI::App* verb) const override;
};

}  // namespace nazori::cli
