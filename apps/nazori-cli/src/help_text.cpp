// SPDX-License-Identifier: Apache-2.0
#include "help_text.h"

#include <sstream>
#include <vector>

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

/// "-o, --output"; the name as it is for an argument without dashes.
std::string names_of(const CLI::Option* option, bool is_positional) {
  if (is_positional) {
    const bool several = option->get_expected_max() >= CLI::detail::expected_max_vector_size;
    return option->get_name(true, false) + (several ? "..." : "");
  }
  std::string names;
  for (const std::string& letter : option->get_snames()) names += (names.empty() ? "-" : ", -") + letter;
  for (const std::string& word : option->get_lnames()) names += (names.empty() ? "--" : ", --") + word;
  return names;
}

}  // namespace

HelpText::HelpText() {
  label("Positionals", "Arguments");
  label("OPTIONS", "options");
  label("SUBCOMMAND", "VERB");
}

std::string HelpText::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n"))
    text.erase(at, 1);
  return text;
}

std::string HelpText::make_option(const CLI::Option* option, bool is_positional) const {
  // CLI11 gives what an option takes and its range in one: "N:2..8192".
  std::string takes = option->get_type_size() != 0 ? option->get_type_name() : "";
  std::string range;
  if (const std::size_t colon = takes.find(':'); colon != std::string::npos) {
    range = takes.substr(colon + 1);
    takes.erase(colon);
  }
  std::string name = names_of(option, is_positional);
  if (!is_positional && !takes.empty()) name += " " + takes;

  std::vector<std::string> notes;
  if (range.find("..") != std::string::npos) notes.push_back(range);
  if (!option->get_default_str().empty()) notes.push_back("default: " + option->get_default_str());
  if (option->get_required() && !is_positional) notes.emplace_back("required");
  std::string description = option->get_description();
  for (std::size_t i = 0; i < notes.size(); ++i) description += (i == 0 ? " (" : "; ") + notes[i];
  if (!notes.empty()) description += ")";
  return entry(name, description);
}

std::string HelpText::make_subcommand(const CLI::App* verb) const {
  return entry(verb->get_name(), verb->get_description());
}

}  // namespace nazori::cli
