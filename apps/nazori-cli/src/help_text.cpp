// SPDX-License-Identifier: Apache-2.0
#include "help_text.h"

#include <sstream>
#include <vector>

#include "command_table.h"
#include "text_layout.h"

namespace nazori::cli {
namespace {

constexpr int kNameWidth = 26;
constexpr int kWidth = 80;

std::string entry(const std::string& name, const std::string& description) {
  std::vector<std::string> words;
  std::istringstream stream(description);
  for (std::string word; stream >> word;) words.push_back(word);
  std::string text = "  " + name;
  if (display_width(text) > kNameWidth - 2) text += "\n";
  text = text.ends_with('\n') ? text + std::string(kNameWidth, ' ') : pad(text, kNameWidth);
  return text + flow(words, " ", kNameWidth, kWidth) + "\n";
}

}  // namespace

HelpText::HelpText() {
  label("Positionals", "Arguments");
  label("OPTIONS", "options");
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpText::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n"))
    text.erase(at, 1);
  return text;
}

std::string HelpText::make_option(const CLI::Option* option, bool is_positional) const {
  const OptionEntry option_info = option_entry(*option);
  const std::string value = is_positional || option_info.value.empty() ? "" : " " + option_info.value;
  return entry(joined_names(option_info) + value, description_with_notes(option_info));
}

std::string HelpText::make_subcommand(const CLI::App* verb) const {
  return entry(verb->get_name(), verb->get_description());
}

}  // namespace nazori::cli
