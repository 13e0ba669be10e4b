// SPDX-License-Identifier: Apache-2.0
#include "command_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

namespace nazori::cli {
namespace {

/// Descriptions of all checks of an option, in order.
std::vector<std::string> checks_of(const CLI::Option& option) {
  // CLI11 gives the checks only together with the name of the value, "N:2..8192", or one by one from an
  // option that may be changed. A name may contain a colon itself, so the string cannot be split.
  auto& changeable = const_cast<CLI::Option&>(option);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  std::vector<std::string> checks;
  try {
    for (int i = 0;; ++i) {
      std::string check = changeable.get_validator(i)->get_description();
      if (!check.empty()) checks.push_back(std::move(check));
    }
  } catch (const CLI::OptionNotFound&) {
    return checks;  // past the last one
  }
}

/// The words of "{a,b}" (IsMember) or of "value in {a->1,b->2} OR {1,2}" (CheckedTransformer); none for other
/// checks.
std::vector<std::string> words_of_set(std::string_view check) {
  constexpr std::string_view kTransformer = "value in ";
  if (check.starts_with(kTransformer)) check.remove_prefix(kTransformer.size());
  if (!check.starts_with('{') || check.find('}') == std::string_view::npos) return {};
  std::string_view rest = check.substr(1, check.find('}') - 1);
  std::vector<std::string> words;
  while (!rest.empty()) {
    const std::string_view item = rest.substr(0, rest.find(','));
    words.emplace_back(item.substr(0, item.find("->")));
    rest.remove_prefix(std::min(rest.size(), item.size() + 1));
  }
  return words;
}

/// "FILE" out of "FILE:2..8192:{a,b}".
std::string value_name(const CLI::Option& option, const std::vector<std::string>& checks) {
  std::string name = option.get_type_name();
  for (auto check = checks.rbegin(); check != checks.rend(); ++check) {
    if (name.ends_with(":" + *check)) name.erase(name.size() - check->size() - 1);
  }
  return name;
}

Takes kind_of(const OptionEntry& entry) {
  if (!entry.choices.empty()) return Takes::choice;
  if (entry.value == "FILE" || entry.argument == "file") return Takes::file;
  return entry.value == "FOLDER" ? Takes::folder : Takes::text;
}

Command walk(const CLI::App& app, const std::string& path) {
  Command command;
  command.path = path;
  command.name = app.get_name();
  command.description = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_group().empty()) continue;
    OptionEntry entry = option_entry(*option);
    (entry.argument.empty() ? command.options : command.arguments).push_back(std::move(entry));
  }
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_group().empty()) continue;
    command.verbs.push_back(walk(*verb, (path.empty() ? "" : path + " ") + verb->get_name()));
  }
  return command;
}

void collect(const Command& command, std::vector<const Command*>& all) {
  all.push_back(&command);
  for (const Command& verb : command.verbs) collect(verb, all);
}

}  // namespace

OptionEntry option_entry(const CLI::Option& option) {
  OptionEntry entry;
  for (const std::string& letter : option.get_snames()) entry.names.push_back("-" + letter);
  for (const std::string& word : option.get_lnames()) entry.names.push_back("--" + word);
  if (entry.names.empty()) entry.argument = option.get_name(true, false);
  entry.description = option.get_description();
  entry.group = option.get_group();
  entry.required = option.get_required();
  entry.several = option.get_expected_max() >= CLI::detail::expected_max_vector_size;

  std::string range;
  // A flag expects no value, or has a value of no size; which of the two depends on how it was added.
  if (option.get_type_size() != 0 && option.get_expected_max() != 0) {
    const std::vector<std::string> checks = checks_of(option);
    entry.value = value_name(option, checks);
    for (const std::string& check : checks) {
      if (entry.choices.empty()) entry.choices = words_of_set(check);
      if (check.find("..") != std::string::npos) range = check;
    }
    entry.takes = kind_of(entry);
    // With a delimiter all values are in one word: --window=-1,1,-1,1.
    entry.values = option.get_delimiter() != '\0' ? 1 : std::max(1, option.get_items_expected_min());
  }
  const auto add = [&entry](const std::string& text) {
    entry.notes += (entry.notes.empty() ? "" : "; ") + text;
  };
  if (!range.empty()) add(range);
  if (!option.get_default_str().empty()) add("default: " + option.get_default_str());
  if (entry.required && entry.argument.empty()) add("required");
  return entry;
}

std::string joined_names(const OptionEntry& entry) {
  if (!entry.argument.empty()) return entry.argument + (entry.several ? "..." : "");
  std::string joined;
  for (const std::string& name : entry.names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

std::string description_with_notes(const OptionEntry& entry) {
  return entry.notes.empty() ? entry.description : entry.description + " (" + entry.notes + ")";
}

Command command_table(const CLI::App& app) { return walk(app, ""); }

std::vector<const Command*> all_commands(const Command& command) {
  std::vector<const Command*> all;
  collect(command, all);
  return all;
}

}  // namespace nazori::cli
